// What happened, in words, and what the program printed.

/** Kinds of events: what they are called on the chips, which are shown at first, and which are marked on the scrubber. */
const EVENT_KINDS = {
  problem: {title: 'Problems', on: true, tick: true},
  contact: {title: 'Contacts', on: true, tick: true},
  zone: {title: 'Zones', on: true, tick: true},
  hand: {title: 'Hands', on: true, tick: true},
  behaviour: {title: 'Behaviours', on: true, tick: false},
  brick: {title: 'LEDs and sounds', on: false, tick: false},
  end: {title: 'End', on: true, tick: false},
};

const LED_WORDS = ['LEDs off', 'LEDs green', 'LEDs red', 'LEDs orange', 'LEDs flash green', 'LEDs flash red', 'LEDs flash orange', 'LEDs pulse green',
  'LEDs pulse red', 'LEDs pulse orange'];
const PRESSED_BY = {auto: ', pressed automatically', stimulus: '', person: ', by hand', program: ', by the program'};

const EVENT_WORDS = {
  collision: (e) => ['contact', `Hit ${e.with} at ${number(e.speed * 1000)} mm/s`],
  fell: () => ['problem', 'Went over the edge'],
  zone: (e) => ['zone', `${e.entered ? 'Entered' : 'Left'} ${e.zone}`],
  stimulus: (e) => ['hand', e.do],
  key: (e) => ['hand', `${e.key} ${e.down ? 'down' : 'up'}${PRESSED_BY[e.cause] || ''}`],
  exception: (e) => ['problem', `${e.exception} in thread ${e.thread}`],
  end: (e) => [['exited', 'time-limit', 'goal-reached'].includes(e.outcome) && e.exitStatus <= 0 ? 'end' : 'problem',
    `End: ${e.outcome}${e.outcome === 'exited' ? ` with status ${e.exitStatus}` : ''}`],
  led: (e) => ['brick', LED_WORDS[e.pattern] || `LED pattern ${e.pattern}`],
  sound: (e) => ['brick', e.name === 'silence' ? 'Silence' : e.hertz > 0 ? `Tone ${e.hertz} Hz for ${period(e.millis / 1000)}` : `Sound ${e.name}`],
};

/** An event in words with its kind; null if it is none for people. */
function describedEvent(event, several) {
  const words = EVENT_WORDS[event.type];
  if (!words) {
    return null;
  }
  const [kind, text] = words(event);
  return {t: event.t, kind, text: several && event.robot ? `${event.robot}: ${text}` : text};
}

/** The events of a run in words, in order of time. */
function describedEvents(recording) {
  const several = recording.robots.length > 1;
  const entries = [];
  const add = (t, robot, kind, text) => entries.push({t, kind, text: several && robot ? `${robot}: ${text}` : text});
  for (const event of recording.events) {
    const entry = describedEvent(event, several);
    if (entry) {
      entries.push(entry);
    }
  }
  for (const arbitration of recording.arbitrations) {
    const {name} = arbitration.robot;
    arbitration.active.forEach((span) => add(span.from, name, 'behaviour', `${arbitration.names[span.behaviour]} takes control`));
    for (const giving of arbitration.givings) {
      const who = arbitration.names[giving.behaviour];
      const by = giving.by >= 0 ? ` for ${arbitration.names[giving.by]}` : '';
      add(giving.from, name, 'behaviour', `${who} is told to give way${by}`);
      if (giving.slow) {
        add(giving.from + SLOW_SECONDS, name, 'problem', `${who} ignores suppress(): ${giving.endless ? 'it never gave way' : `it took ${period(giving.to - giving.from)} to give way`}`);
      }
    }
  }
  return entries.map((entry, order) => ({...entry, order})).sort((a, b) => a.t - b.t || a.order - b.order);
}

class Lists {
  constructor(host, recording, player) {
    this.player = player;
    this.all = describedEvents(recording);
    const pick = (entry) => {
      player.pause();
      player.seek(entry.t);
    };
    this.shown = new Set(Object.keys(EVENT_KINDS).filter((kind) => EVENT_KINDS[kind].on));
    this.events = new Listing('Events', (entry) => [html('span', {class: 'row-mark'}), html('span', {class: 'row-text', title: entry.text}, entry.text)], pick,
      'Nothing of this kind happened.');
    const lines = recording.events.filter((event) => event.type === 'print');
    this.console = new Listing('Console', (entry) => [html('span', {class: 'row-text mono'}, entry.text)], pick, 'The program printed nothing.');
    this.console.node.classList.add('console');
    const chips = html('div', {class: 'chips', role: 'group', 'aria-label': 'Kinds of events shown'}, ...this.chips());
    tabs(host, [['Events', html('div', {class: 'tab-body'}, chips, this.events.node), this.all.length],
      ['Console', html('div', {class: 'tab-body'}, this.console.node), lines.length]]);
    this.filter();
    this.console.setEntries(lines.map((event) => ({t: event.t, kind: event.error ? 'error' : '', text: event.text})));
  }

  chips() {
    return Object.entries(EVENT_KINDS).filter(([kind]) => kind !== 'end' && this.all.some((entry) => entry.kind === kind)).map(([kind, {title, on}]) =>
      html('button', {type: 'button', class: `chip ${kind}`, 'aria-pressed': String(on), on: {click: (event) => {
        const show = !this.shown.has(kind);
        this.shown[show ? 'add' : 'delete'](kind);
        event.currentTarget.setAttribute('aria-pressed', String(show));
        this.filter();
        this.show(this.player.time);
      }}}, html('span', {class: 'row-mark'}), title));
  }

  filter() {
    this.entries = this.all.filter((entry) => this.shown.has(entry.kind));
    this.events.setEntries(this.entries);
  }

  /** Moves to the next (1) or previous (−1) event. */
  step(direction) {
    const now = lastNotAfter(this.entries, this.player.time + 1e-9, (entry) => entry.t);
    let index = now + direction;
    while (direction < 0 && index >= 0 && this.entries[index].t >= this.player.time - 1e-9) {
      index--;
    }
    if (this.entries[index]) {
      this.player.pause();
      this.player.seek(this.entries[index].t);
    }
  }

  show(time) {
    this.events.show(time, true);
    this.console.show(time, true);
  }
}
