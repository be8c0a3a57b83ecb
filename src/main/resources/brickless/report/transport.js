// Play, pause, scrub, speed: buttons, slider and keys.

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 8, 16];
const KEY_HELP = [['Space', 'play or pause'], ['← →', 'one second back or on'], ['Shift ← →', 'one sample (50 ms) back or on'], ['Home End', 'beginning or end'],
  ['N P', 'next or previous event'], ['[ ]', 'slower or faster'], ['+ − 0', 'zoom in, out, all'], ['?', 'these keys']];

class Transport {
  constructor(host, player, window, lists, entries) {
    this.player = player;
    this.window = window;
    this.lists = lists;
    this.entries = entries;
    this.playIcon = icon(PLAY_ICON);
    this.play = iconButton('Play', this.playIcon, () => player.toggle(), 'play');
    this.now = html('span', {});
    this.time = html('output', {class: 'time', 'aria-label': 'Time of the replay'}, this.now,
      html('span', {class: 'total'}, ` / ${clock(player.duration, 0)}`));
    this.ticks = html('canvas', {class: 'ticks', 'aria-hidden': 'true'});
    this.slider = html('input', {type: 'range', class: 'scrub', min: 0, max: player.duration, step: 'any', value: 0, 'aria-label': 'Time', on: {
      input: () => player.seek(Number(this.slider.value))}});
    this.speed = html('select', {class: 'speed', 'aria-label': 'Speed', on: {change: () => player.setSpeed(Number(this.speed.value))}},
      ...SPEEDS.map((speed) => html('option', {value: speed, selected: speed === 1}, `${speed} ×`)));
    this.help = helpDialog(KEY_HELP);
    host.append(
      html('div', {class: 'buttons'},
        iconButton('Previous event', icon('M4 4v12M15.5 4.500v11L7 10z'), () => lists.step(-1), 'flat'), this.play,
        iconButton('Next event', icon('M16 4v12M4.5 4.500v11L13 10z'), () => lists.step(1), 'flat'), this.time),
      html('div', {class: 'scrubber'}, this.slider, this.ticks),
      html('div', {class: 'buttons end'}, this.speed,
        iconButton('Zoom out', icon('M9 3a6 6 0 1 0 0 12A6 6 0 0 0 9 3zM13.5 13.5 18 18M6 9h6'), () => window.zoom(2, player.time), 'flat'),
        iconButton('Zoom in', icon('M9 3a6 6 0 1 0 0 12A6 6 0 0 0 9 3zM13.5 13.5 18 18M6 9h6M9 6v6'), () => window.zoom(0.5, player.time), 'flat'),
        iconButton('Keys', icon('M7.5 7.500a2.5 2.5 0 1 1 3.6 2.300c-.8.4-1.1.900-1.1 1.700v.5M10 15v.01'), () => this.help.showModal(), 'flat keys')),
      this.help);
    document.addEventListener('keydown', (event) => this.key(event));
    new ResizeObserver(() => this.drawTicks()).observe(this.ticks.parentNode);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.drawTicks());
    player.onState(() => this.state());
    player.add(this);
  }

  state() {
    this.playIcon.firstChild.setAttribute('d', this.player.playing ? PAUSE_ICON : PLAY_ICON);
    this.play.setAttribute('aria-label', this.player.playing ? 'Pause' : 'Play');
    this.play.title = this.player.playing ? 'Pause' : 'Play';
    this.speed.value = String(this.player.speed);
  }

  show(time) {
    this.slider.value = time;
    this.slider.setAttribute('aria-valuetext', clock(time));
    this.slider.style.setProperty('--part', String(time / this.player.duration));
    setText(this.now, clock(time));
  }

  drawTicks() {
    const width = this.ticks.clientWidth;
    const height = this.ticks.clientHeight;
    const ratio = globalThis.devicePixelRatio || 1;
    this.ticks.width = Math.round(width * ratio);
    this.ticks.height = Math.round(height * ratio);
    const context = this.ticks.getContext('2d');
    context.scale(ratio, ratio);
    for (const [kind, {tick}] of Object.entries(EVENT_KINDS).reverse()) {
      context.fillStyle = themeColour(`--kind-${kind}`);
      for (const entry of tick ? this.entries.filter((one) => one.kind === kind) : []) {
        context.fillRect(8 + entry.t / this.player.duration * (width - 16) - 1, 0, 2, height);
      }
    }
  }

  key(event) {
    const field = event.target.closest('input, select, textarea, dialog, [role=tab]');
    if (event.ctrlKey || event.metaKey || event.altKey || (field && field !== this.slider)) {
      return;
    }
    const onButton = event.target.closest('button, summary') && (event.key === ' ' || event.key === 'Enter');
    const action = onButton ? null : this.action(event);
    if (action) {
      event.preventDefault();
      action();
    }
  }

  action(event) {
    const {player} = this;
    const move = (seconds) => () => {
      player.pause();
      player.seek(player.time + seconds);
    };
    const small = 0.05;
    switch (event.key) {
      case ' ': return () => player.toggle();
      case 'ArrowLeft': return move(event.shiftKey ? -small : -1);
      case 'ArrowRight': return move(event.shiftKey ? small : 1);
      case 'Home': return move(-Infinity);
      case 'End': return move(Infinity);
      case 'n': return () => this.lists.step(1);
      case 'p': return () => this.lists.step(-1);
      case '[': return () => this.changeSpeed(-1);
      case ']': return () => this.changeSpeed(1);
      case '+': case '=': return () => this.window.zoom(0.5, player.time);
      case '-': return () => this.window.zoom(2, player.time);
      case '0': return () => this.window.set(0, player.duration);
      case '?': return () => this.help.showModal();
      default: return null;
    }
  }

  changeSpeed(step) {
    const index = SPEEDS.indexOf(this.player.speed) + step;
    this.player.setSpeed(SPEEDS[Math.min(SPEEDS.length - 1, Math.max(0, index))]);
  }
}
