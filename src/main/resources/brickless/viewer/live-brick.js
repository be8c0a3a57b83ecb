// The brick to press: keys, ports with their recent values, touch sensors to hold.

const SPARK_SECONDS = 10;
const SPARK_HEIGHT = 16;

/** The last seconds of one signal, without axes. */
class Sparkline {
  constructor(colour) {
    this.colour = colour;
    this.node = html('canvas', {class: 'spark', 'aria-hidden': 'true'});
  }

  draw(times, values) {
    const ratio = globalThis.devicePixelRatio || 1;
    const width = this.node.clientWidth;
    if (width === 0) {
      return;
    }
    this.node.width = Math.round(width * ratio);
    this.node.height = Math.round(SPARK_HEIGHT * ratio);
    const context = this.node.getContext('2d');
    context.scale(ratio, ratio);
    const end = times.length > 0 ? times[times.length - 1] : 0;
    const first = Math.max(0, lastNotAfter(times, end - SPARK_SECONDS));
    const shown = values.slice(first).filter(Number.isFinite);
    const low = Math.min(...shown);
    const span = Math.max(...shown) - low;
    context.strokeStyle = this.colour;
    context.lineWidth = 1.25;
    context.lineJoin = 'round';
    context.beginPath();
    let drawing = false;
    for (let i = first; i < times.length; i++) {
      const x = width - (end - times[i]) / SPARK_SECONDS * width;
      const y = SPARK_HEIGHT - 1.5 - (span > 0 ? (values[i] - low) / span : 0.5) * (SPARK_HEIGHT - 3);
      if (Number.isFinite(y)) {
        context[drawing ? 'lineTo' : 'moveTo'](x, y);
      }
      drawing = Number.isFinite(y);
    }
    context.stroke();
  }
}

const PORT_COLOURS = {A: '#b45309', B: '#1f5fd6', C: '#c02679', D: '#0d7a6f'};

class LiveBrick extends Brick {
  /** `press` is told which key or touch sensor goes down and up. */
  constructor(host, recording, robot, press) {
    super(host, recording, robot);
    this.press = press;
    this.keyNodes.forEach((node) => holdable(node, () => press(`key ${node.dataset.key}`, true), () => press(`key ${node.dataset.key}`, false)));
    this.touchCells().forEach((cell) => {
      const what = `push S${cell.port}`;
      cell.node.title = `Touch sensor S${cell.port}: hold to press it`;
      cell.node.classList.add('touch');
      holdable(cell.node, () => press(what, true), () => press(what, false));
    });
    this.canvas.setAttribute('aria-label', 'Screen of the brick');
  }

  touchCells() {
    return this.sensorCells.filter((cell) => this.sensorsAt(cell.port).some((sensor) => sensor.kind.endsWith('-touch')));
  }

  padRole() {
    return 'group';
  }

  key(key, className) {
    return html('button', {type: 'button', class: className, 'data-key': key, 'aria-label': `Key ${key}`, title: `${key}: hold to press it`});
  }

  cell(port, kind, parts) {
    const touch = kind === 'touch';
    const spark = new Sparkline(PORT_COLOURS[port] || '#1f5fd6');
    return {spark, node: html(touch ? 'button' : 'div', {class: kind ? 'port' : 'port empty', 'data-port': port, type: touch ? 'button' : null}, ...parts, spark.node)};
  }

  /** Draws the small plots anew. */
  plot() {
    const {times} = this.recording;
    for (const cell of this.motorCells) {
      const motor = this.robot.motors.find((one) => one.port === cell.port);
      if (motor) {
        cell.spark.draw(times, motor.speed);
      }
    }
    for (const cell of this.sensorCells) {
      const sensor = this.sensorsAt(cell.port).find((one) => one.values.length > 0);
      if (sensor) {
        cell.spark.draw(times, sensor.values[0]);
      }
    }
  }
}
