// What the program prints and what happens, as it happens.

class LiveLists {
  constructor(host, recording) {
    this.recording = recording;
    this.several = recording.robots.length > 1;
    this.events = new Listing('Events', (entry) => [html('span', {class: 'row-mark'}), html('span', {class: 'row-text', title: entry.text}, entry.text)], () => {},
      'Nothing has happened yet.');
    this.console = new Listing('Console', (entry) => [html('span', {class: 'row-text mono'}, entry.text)], () => {}, 'The program has printed nothing yet.');
    this.console.node.classList.add('console');
    [this.consoleCount, this.eventsCount] = tabs(host, [['Console', html('div', {class: 'tab-body'}, this.console.node), 0],
      ['Events', html('div', {class: 'tab-body'}, this.events.node), 0]]);
    this.console.setEntries([]);
    this.events.setEntries([]);
    this.add(this.console, recording.prints.map((event) => this.line(event)));
    this.add(this.events, describedEvents(recording).filter((entry) => EVENT_KINDS[entry.kind].on));
    this.count();
  }

  line(event) {
    return {t: event.t, kind: event.error ? 'error' : '', text: this.several ? `${event.robot}: ${event.text}` : event.text};
  }

  happened(events) {
    this.add(this.console, events.filter((event) => event.type === 'print').map((event) => this.line(event)));
    const entries = events.map((event) => this.behaviour(event) || describedEvent(event, this.several));
    this.add(this.events, entries.filter((entry) => entry && EVENT_KINDS[entry.kind].on));
    this.count();
  }

  behaviour(event) {
    if (event.type !== 'active' || event.behaviour < 0) {
      return null;
    }
    const {names} = this.recording.arbitrations.find((one) => one.robot.name === event.robot && one.number === event.arbitrator);
    return {t: event.t, kind: 'behaviour', text: `${this.several ? `${event.robot}: ` : ''}${names[event.behaviour]} takes control`};
  }

  add(listing, entries) {
    if (entries.length === 0) {
      return;
    }
    if (listing.entries.length > 2 * MOST_LINES) {
      listing.entries.splice(0, listing.entries.length - MOST_LINES);
    }
    listing.append(entries);
  }

  count() {
    setText(this.consoleCount, String(this.console.entries.length));
    setText(this.eventsCount, String(this.events.entries.length));
  }
}
