// The head of the page: what runs, how it goes, and the controls of the run.

const LIVE_SPEEDS = ['0.1', '0.25', '0.5', '1', '2', '5', '10', '25', 'max'];
const STEP_ICON = 'M4 3.5v13l7.500-6.5zM13 3.500h2.800v13H13z';
const RESTART_ICON = 'M4 4.500v4h4M4.600 8.200A6 6 0 1 1 4.200 12';
const SEED_ICON = 'M4 4h12v12H4zM7.500 7.500v.01M12.500 7.500v.01M10 10v.01M7.500 12.500v.01M12.500 12.500v.01';
const SOUND_ICON = 'M3 8h3l4-4v12l-4-4H3zM13 7.5a3.5 3.5 0 0 1 0 5M15 5a7 7 0 0 1 0 10';
const MUTED_ICON = 'M3 8h3l4-4v12l-4-4H3zM13 8l4.500 4.500M17.500 8L13 12.500';
const HELP_ICON = 'M7.5 7.500a2.5 2.5 0 1 1 3.6 2.300c-.8.4-1.1.900-1.1 1.700v.5M10 15v.01';
const SAVE_ICON = 'M10 3v9M6 8.500l4 4 4-4M4 16h12';
const LIVE_KEYS = [['← ↑ ↓ →', 'keys of the brick, as long as you hold them'], ['Enter', 'ENTER of the brick'], ['Esc ⌫', 'ESCAPE of the brick'], ['Space', 'pause or go on'],
  ['S', 'on by 50 ms (with Shift by 2 ms)'], ['[ ]', 'slower or faster'], ['C', 'clap'], ['M', 'sound on or off'], ['Shift R', 'restart with the same seed'],
  ['Tab', 'to robots and boxes: arrow keys move them, comma and full stop turn them, Delete takes a box away'], ['+ −', 'longer or shorter stretch of time in the plots'], ['?', 'these keys']];

class Controls {
  constructor(host, link, loudspeaker, tools, group) {
    Object.assign(this, {link, loudspeaker, tools, group});
    this.state = {running: false, speed: 1, ended: null, touches: 0};
    this.latest = 0;
    this.title = html('h1', {}, '');
    this.setting = html('p', {class: 'setting'}, '');
    this.status = html('span', {class: 'outcome', role: 'status', 'data-part': 'status'}, '');
    this.playIcon = icon(PLAY_ICON);
    this.play = iconButton('Go on', this.playIcon, () => this.toggle(), 'play');
    this.step = iconButton('On by 50 ms', icon(STEP_ICON), (event) => this.stepOn(event.shiftKey), 'flat step');
    this.restart = iconButton('Restart with the same seed', icon(RESTART_ICON), () => this.again(), 'flat restart');
    this.now = html('span', {class: 'now'}, '0:00.00');
    this.rate = html('span', {class: 'rate', title: 'Simulated seconds per second'}, '');
    this.speed = html('select', {class: 'speed', 'aria-label': 'Speed', on: {change: () => this.setSpeed(this.speed.value)}},
      ...LIVE_SPEEDS.map((speed) => html('option', {value: speed}, speed === 'max' ? 'max' : `${speed} ×`)));
    this.soundIcon = icon(SOUND_ICON);
    this.sound = iconButton('Sound', this.soundIcon, () => this.mute(!loudspeaker.muted), 'flat sound');
    this.touches = html('span', {class: 'save-count'}, '');
    this.save = html('a', {class: 'push-button save', href: 'stimuli', download: 'stimuli.txt', title: 'What was done to the robot so far, as a stimuli file that repeats it'},
      icon(SAVE_ICON), html('span', {class: 'save-word'}, 'Save stimuli'), this.touches);
    this.help = helpDialog(LIVE_KEYS);
    host.append(html('div', {class: 'what'}, this.title, this.setting), this.status,
      html('div', {class: 'controls', role: 'toolbar', 'aria-label': 'Run'},
        html('div', {class: 'buttons'}, this.restart, iconButton('Restart with a new seed', icon(SEED_ICON), () => this.newSeed(), 'flat seed'), this.step, this.play),
        html('div', {class: 'time', 'data-part': 'time'}, this.now, this.rate), this.speed),
      html('div', {class: 'buttons extras'}, this.save, this.sound, iconButton('Keys', icon(HELP_ICON), () => this.help.showModal(), 'flat keys')), this.help);
    this.mute(loudspeaker.muted);
    document.addEventListener('keydown', (event) => this.key(event));
  }

  /** Says what runs. */
  begin(data) {
    this.latest = 0;
    const name = data.header.main;
    setText(this.title, name.slice(name.lastIndexOf('.') + 1));
    this.title.title = data.header.main;
    document.title = `${this.title.textContent} · Brickless live`;
    const robots = data.scene.robots.length;
    const setting = [`world ${data.world}`, robots > 1 ? `${robots} robots` : `robot ${data.robot}`, `seed ${data.seed}`];
    if (data.limit !== null) {
      setting.push(`until ${period(data.limit)}`);
    }
    setText(this.setting, setting.join(' · '));
  }

  show(state) {
    this.state = state;
    const {ended, running} = state;
    const failed = ended && (!GOOD_OUTCOMES.includes(ended.outcome) || (ended.outcome === 'exited' && ended.exitStatus !== 0));
    setText(this.status, ended ? this.outcome(ended) : running ? 'running' : 'paused');
    this.status.className = `outcome ${ended ? (failed ? 'bad' : 'good') : running ? 'going' : 'held-up'}`;
    this.status.title = ended ? `SHA-256 of the trace: ${ended.hash}` : '';
    const goes = running && !ended;
    this.playIcon.firstChild.setAttribute('d', goes ? PAUSE_ICON : PLAY_ICON);
    this.play.setAttribute('aria-label', goes ? 'Pause' : 'Go on');
    this.play.title = goes ? 'Pause' : 'Go on';
    this.play.disabled = Boolean(ended);
    this.step.disabled = Boolean(ended);
    this.restart.classList.toggle('wanted', Boolean(ended));
    this.showSpeed(String(state.speed));
    setText(this.rate, goes ? `${number(state.rate, state.rate < 10 ? 2 : 0)} ×` : '');
    setText(this.touches, state.touches > 0 ? String(state.touches) : '');
    this.time(state.t);
  }

  showSpeed(speed) {
    if (![...this.speed.options].some((option) => option.value === speed)) {
      this.speed.append(html('option', {value: speed}, `${speed} ×`));
    }
    this.speed.value = speed;
  }

  outcome(ended) {
    return ended.outcome === 'exited' && ended.exitStatus !== 0 ? `exited with ${ended.exitStatus}` : ended.outcome;
  }

  /** Shows a time; a frame that was on its way when the state was told does not turn the clock back. */
  time(time) {
    this.latest = Math.max(this.latest, time);
    setText(this.now, clock(this.latest));
  }

  toggle() {
    if (!this.state.ended) {
      this.link.send({do: this.state.running ? 'pause' : 'play'});
    }
  }

  stepOn(small) {
    this.link.send(small ? {do: 'step', millis: 2} : {do: 'step'});
  }

  again() {
    this.link.send({do: 'restart'});
  }

  newSeed() {
    this.link.send({do: 'restart', seed: 1 + Math.floor(Math.random() * 999999)});
  }

  setSpeed(text) {
    this.link.send({do: 'speed', value: text === 'max' ? text : Number(text)});
  }

  mute(muted) {
    this.loudspeaker.mute(muted);
    this.soundIcon.firstChild.setAttribute('d', muted ? MUTED_ICON : SOUND_ICON);
    this.sound.setAttribute('aria-label', muted ? 'Sound is off' : 'Sound is on');
    this.sound.title = muted ? 'Sound is off' : 'Sound is on';
    this.sound.setAttribute('aria-pressed', String(!muted));
  }

  changeSpeed(step) {
    const index = LIVE_SPEEDS.indexOf(String(this.state.speed));
    const next = LIVE_SPEEDS[Math.min(LIVE_SPEEDS.length - 1, Math.max(0, (index < 0 ? 3 : index) + step))];
    this.setSpeed(next);
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || event.repeat || inField(event)) {
      return;
    }
    const onButton = event.target.closest('button, a, .touch-sensor') && event.key === ' ';
    const action = onButton ? null : this.action(event);
    if (action) {
      event.preventDefault();
      action();
    }
  }

  action(event) {
    switch (event.key) {
      case ' ': return () => this.toggle();
      case 's': return () => this.stepOn(false);
      case 'S': return () => this.stepOn(true);
      case '[': return () => this.changeSpeed(-1);
      case ']': return () => this.changeSpeed(1);
      case 'c': return () => this.tools.clap();
      case 'm': return () => this.mute(!this.loudspeaker.muted);
      case 'R': return () => this.again();
      case '+': case '=': return () => this.group.window.zoom(0.5);
      case '-': return () => this.group.window.zoom(2);
      case '?': return () => this.help.showModal();
      default: return null;
    }
  }
}

/** Whether a key is meant for something that has keys of its own. */
function inField(event) {
  return Boolean(event.target.closest('input, select, textarea, dialog, [role=tab], [role=listbox]'));
}
