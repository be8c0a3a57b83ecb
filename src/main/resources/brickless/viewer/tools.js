// Hands beside the arena: the infrared remote, a clap, the battery.

const CORNERS = {TOP_LEFT: ['Red up', '▲'], TOP_RIGHT: ['Blue up', '▲'], BOTTOM_LEFT: ['Red down', '▼'], BOTTOM_RIGHT: ['Blue down', '▼']};
/** Two corners held together are a button of their own. */
const PAIRS = {'TOP_LEFT TOP_RIGHT': 'BOTH_TOP', 'TOP_LEFT BOTTOM_RIGHT': 'TOP_LEFT+BOTTOM_RIGHT', 'BOTTOM_LEFT TOP_RIGHT': 'BOTTOM_LEFT+TOP_RIGHT',
  'BOTTOM_LEFT BOTTOM_RIGHT': 'BOTH_BOTTOM', 'BOTTOM_LEFT TOP_LEFT': 'BOTH_LEFT', 'BOTTOM_RIGHT TOP_RIGHT': 'BOTH_RIGHT'};
const LEAST_VOLTS = 5;
const MOST_VOLTS = 9;

/** Infrared remote: four keys and the beacon switch, on four channels. */
class Remote {
  constructor(press) {
    this.press = press;
    this.channel = 1;
    this.corners = new Set();
    this.sent = null;
    const channels = [1, 2, 3, 4].map((channel) => html('button', {type: 'button', class: 'chip channel', 'aria-pressed': String(channel === 1), 'aria-label': `Channel ${channel}`,
      on: {click: () => this.choose(channel)}}, String(channel)));
    this.channels = channels;
    this.node = html('div', {class: 'remote', role: 'group', 'aria-label': 'Infrared remote'},
      html('div', {class: 'channels', role: 'group', 'aria-label': 'Channel'}, ...channels),
      html('div', {class: 'remote-pad'}, this.key('BEACON', 'Beacon', '●'), ...Object.entries(CORNERS).map(([corner, [name, sign]]) => this.key(corner, name, sign))));
  }

  key(corner, name, sign) {
    const node = html('button', {type: 'button', class: 'remote-key', 'data-remote': corner, 'aria-label': `${name}: hold`, title: name}, sign);
    holdable(node, () => this.change(corner, true), () => this.change(corner, false));
    return node;
  }

  choose(channel) {
    this.send(null);
    this.channel = channel;
    this.channels.forEach((node, i) => node.setAttribute('aria-pressed', String(i + 1 === channel)));
    this.send(this.button());
  }

  change(corner, down) {
    this.corners[down ? 'add' : 'delete'](corner);
    this.send(this.button());
  }

  button() {
    const held = [...this.corners].sort();
    return held.length === 0 ? null : held.length === 1 ? held[0] : PAIRS[held.slice(0, 2).join(' ')] || held[0];
  }

  send(button) {
    const what = button ? `remote ${this.channel} ${button}` : null;
    if (what !== this.sent) {
      if (this.sent) {
        this.press(this.sent, false);
      }
      if (what) {
        this.press(what, true);
      }
      this.sent = what;
    }
  }
}

class Tools {
  constructor(host, link, press) {
    this.link = link;
    this.remote = new Remote(press);
    this.volts = html('output', {class: 'volts', for: 'battery'}, '–');
    this.battery = html('input', {type: 'range', id: 'battery', class: 'slider', min: LEAST_VOLTS, max: MOST_VOLTS, step: 0.1, value: 7.4, 'aria-label': 'Battery voltage without load',
      on: {input: () => this.label(), change: () => this.setBattery()}});
    host.append(html('div', {class: 'tools'}, html('div', {class: 'tool'}, html('h3', {}, 'Remote'), this.remote.node),
      html('div', {class: 'tool'},
        html('h3', {}, 'Battery'), html('div', {class: 'battery'}, this.battery, this.volts),
        html('h3', {}, 'Noise'),
        html('button', {type: 'button', class: 'push-button clap', on: {click: () => this.clap()}}, 'Clap'))));
  }

  clap() {
    this.link.send({do: 'touch', stimulus: 'clap 80dB'});
  }

  setBattery() {
    this.set = true;
    this.link.send({do: 'touch', stimulus: `battery ${Number(this.battery.value).toFixed(1)}V${this.whose}`});
  }

  /** Whose battery it is. */
  choose(robot, first) {
    this.whose = first ? '' : ` on ${robot.name}`;
    this.set = this.set && this.robot === robot;
    this.robot = robot;
  }

  label() {
    this.battery.style.setProperty('--part', String((this.battery.value - LEAST_VOLTS) / (MOST_VOLTS - LEAST_VOLTS)));
    this.battery.setAttribute('aria-valuetext', `${Number(this.battery.value).toFixed(1)} volts`);
  }

  /** Shows the voltage at the terminals; the slider begins there. */
  show(volts) {
    setText(this.volts, `${number(volts, 2)} V`);
    if (!this.set && Number.isFinite(volts)) {
      this.set = true;
      this.battery.value = volts;
      this.label();
    }
  }
}
