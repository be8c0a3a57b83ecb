// The front of the brick at one moment: screen, LEDs, keys, sound, and what is plugged into its ports.

const LED_COLOURS = ['off', 'green', 'red', 'orange'];
const KEYS = {UP: 'up', DOWN: 'down', LEFT: 'left', RIGHT: 'right', ENTER: 'enter', ESCAPE: 'escape'};
const SENSOR_NAMES = {touch: 'touch', color: 'colour', ultrasonic: 'ultrasonic', gyro: 'gyro', infrared: 'infrared', light: 'light', sound: 'sound'};

/** ev3-ultrasonic → ultrasonic */
function sensorName(kind) {
  return SENSOR_NAMES[kind.replace(/^(ev3|nxt)-/, '')] || kind;
}

/** Whether the LEDs are lit at a time, for a pattern 0 to 9: steady, flashing, or beating like a heart. */
function ledLit(pattern, since) {
  const phase = (since % 1 + 1) % 1;
  if (pattern <= 3) {
    return pattern > 0;
  }
  return pattern <= 6 ? phase % 0.5 < 0.25 : phase < 0.15 || (phase >= 0.2 && phase < 0.35);
}

class Brick {
  constructor(host, recording, robot) {
    this.recording = recording;
    this.robot = robot;
    this.leds = robot.log.ofType('led');
    this.sounds = robot.log.ofType('sound');
    this.keys = robot.log.ofType('key');
    this.canvas = html('canvas', {width: SCREEN_WIDTH, height: SCREEN_HEIGHT, class: 'lcd', role: 'img', 'aria-label': 'Screen of the brick'});
    this.changes = -1;
    this.motorCells = this.ports(['A', 'B', 'C', 'D'], (port) => (robot.motors.some((motor) => motor.port === port) ? 'motor' : ''));
    this.sensorCells = this.ports(['1', '2', '3', '4'], (port) => this.sensorsAt(port).map((sensor) => sensorName(sensor.kind))[0] || '');
    this.keyNodes = Object.entries(KEYS).map(([key, name]) => this.key(key, `key key-${name}`));
    this.pad = html('div', {class: 'pad', 'data-led': 'off', role: this.padRole()}, ...this.keyNodes.filter((node) => node.dataset.key !== 'ESCAPE'));
    this.sound = html('p', {class: 'brick-note', 'data-part': 'sound'});
    this.pressed = html('p', {class: 'brick-note', 'data-part': 'keys'});
    host.append(html('div', {class: 'brick-face'},
      html('div', {class: 'ports'}, ...this.motorCells.map((cell) => cell.node)),
      html('div', {class: 'bezel'}, this.canvas),
      html('div', {class: 'front'},
        html('div', {class: 'front-side'}, this.keyNodes.find((node) => node.dataset.key === 'ESCAPE'), this.pressed),
        this.pad,
        html('div', {class: 'front-side end'}, icon('M3 8h3l4-4v12l-4-4H3zM13 7.5a3.5 3.5 0 0 1 0 5M15 5a7 7 0 0 1 0 10'), this.sound)),
      html('div', {class: 'ports'}, ...this.sensorCells.map((cell) => cell.node))));
  }

  ports(names, what) {
    return names.map((port) => {
      const value = html('span', {class: 'port-value'}, '–');
      const kind = what(port);
      const parts = [html('span', {class: `port-name port-${port}`}, port), html('span', {class: 'port-kind'}, kind || 'empty'), value];
      return {port, value, ...this.cell(port, kind, parts)};
    });
  }

  /** What a port is shown with. */
  cell(port, kind, parts) {
    return {node: html('div', {class: kind ? 'port' : 'port empty'}, ...parts)};
  }

  key(key, className) {
    return html('span', {class: className, 'data-key': key, title: key});
  }

  padRole() {
    return 'img';
  }

  sensorsAt(port) {
    return this.robot.sensors.filter((sensor) => String(sensor.port) === port);
  }

  show(time) {
    const changes = this.robot.screen.changesAt(time);
    if (changes !== this.changes) {
      this.changes = changes;
      paintScreen(this.canvas, this.robot.screen.after(changes));
    }
    const sample = this.recording.sampleAt(time);
    for (const cell of this.motorCells) {
      const motor = this.robot.motors.find((one) => one.port === cell.port);
      setText(cell.value, motor ? `${number(motor.tacho[sample])}°` : '–');
    }
    for (const cell of this.sensorCells) {
      setText(cell.value, this.sensorsAt(cell.port).map((sensor) => sensorText(sensor, sample, time)).find((text) => text) || '–');
    }
    this.showLeds(time);
    this.showKeys(time);
    this.showSound(time);
  }

  showLeds(time) {
    const event = this.leds[lastNotAfter(this.leds, time + 1e-9, (one) => one.t)];
    const pattern = event ? event.pattern : 0;
    const colour = pattern === 0 ? 'off' : LED_COLOURS[(pattern - 1) % 3 + 1];
    const lit = event && ledLit(pattern, time - event.t);
    this.pad.dataset.led = lit ? colour : 'off';
    this.pad.dataset.pattern = pattern;
    this.pad.setAttribute('aria-label', `Keys; LEDs ${colour}${pattern > 6 ? ', pulsing' : pattern > 3 ? ', flashing' : ''}`);
  }

  showKeys(time) {
    const down = new Map();
    for (let i = 0; i < this.keys.length && this.keys[i].t <= time + 1e-9; i++) {
      const event = this.keys[i];
      if (event.down) {
        down.set(event.key, event.cause);
      } else {
        down.delete(event.key);
      }
    }
    this.keyNodes.forEach((node) => node.classList.toggle('down', down.has(node.dataset.key)));
    setText(this.pressed, [...down].map(([key, cause]) => `${key}${cause === 'auto' ? ' (auto)' : ''}`).join(', '));
  }

  showSound(time) {
    const event = this.sounds[lastNotAfter(this.sounds, time + 1e-9, (one) => one.t)];
    const sounding = event && event.name !== 'silence' && time < event.t + Math.max(event.millis, 100) / 1000;
    this.sound.parentNode.classList.toggle('sounding', Boolean(sounding));
    setText(this.sound, !sounding ? '' : event.hertz > 0 ? `${event.hertz} Hz` : event.name);
  }
}

function setText(node, text) {
  if (node.textContent !== text) {
    node.textContent = text;
  }
}
