// The run as data: signals by time, events in order. Times are seconds since the start, lengths millimetres, angles degrees clockwise.

/** Unpacks the text that the page carries: base64 of zlib of JSON. */
async function unpack(base64) {
  const binary = atob(base64.trim());
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) {
    bytes[i] = binary.charCodeAt(i);
  }
  if (typeof DecompressionStream === 'undefined' || location.hash.includes('own-inflate')) {
    return JSON.parse(new TextDecoder().decode(inflate(bytes)));
  }
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return JSON.parse(await new Response(stream).text());
}

/** A signal: one number per sample, NaN where there is none. */
function decodeColumn(column, size, factor = 1) {
  const values = new Float64Array(size).fill(NaN);
  const unit = factor / 10 ** column.places;
  let last = 0;
  column.deltas.forEach((delta, i) => {
    if (delta !== null) {
      last += delta;
      values[column.from + i] = last * unit;
    }
  });
  return values;
}

/** Index of the last entry of a rising array that is not after a time; -1 if all are. */
function lastNotAfter(times, time, timeOf = (entry) => entry) {
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (timeOf(times[middle]) <= time) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low - 1;
}

/** Where something is over time. */
class Track {
  constructor(data, times) {
    this.times = times;
    this.x = decodeColumn(data.x, times.length, 1000);
    this.y = decodeColumn(data.y, times.length, 1000);
    this.heading = decodeColumn(data.heading, times.length);
  }

  /** Pose at a time, between samples on the straight way between them; null where there is none. */
  at(time) {
    const i = Math.max(0, lastNotAfter(this.times, time));
    if (Number.isNaN(this.x[i])) {
      return null;
    }
    const next = Math.min(i + 1, this.times.length - 1);
    const span = this.times[next] - this.times[i];
    const part = span > 0 && !Number.isNaN(this.x[next]) ? Math.min(1, Math.max(0, (time - this.times[i]) / span)) : 0;
    if (part === 0) {
      return {x: this.x[i], y: this.y[i], heading: this.heading[i]};
    }
    const turn = ((this.heading[next] - this.heading[i] + 540) % 360 + 360) % 360 - 180;
    return {
      x: this.x[i] + (this.x[next] - this.x[i]) * part,
      y: this.y[i] + (this.y[next] - this.y[i]) * part,
      heading: this.heading[i] + turn * part,
    };
  }
}

/** Events in order of time, also by type; the lists that it gives grow with it. */
class EventLog {
  constructor(events) {
    this.all = events;
    this.types = new Map();
  }

  ofType(type) {
    if (!this.types.has(type)) {
      this.types.set(type, this.all.filter((event) => event.type === type));
    }
    return this.types.get(type);
  }

  add(event) {
    this.all.push(event);
    if (this.types.has(event.type)) {
      this.types.get(event.type).push(event);
    }
  }
}

/** One robot: its track, its signals, and what happened to it. */
class RecordedRobot {
  constructor(data, times, scene, events) {
    const column = (values) => decodeColumn(values, times.length);
    this.name = data.name;
    this.scene = scene;
    this.track = new Track(data, times);
    this.heading = this.track.heading;
    this.volts = column(data.volts);
    this.motors = data.motors.map((motor) => ({
      port: motor.port,
      tacho: column(motor.tacho),
      speed: column(motor.speed),
      duty: column(motor.duty),
      amperes: column(motor.amperes),
    }));
    this.sensors = data.sensors.map((sensor) => ({
      port: sensor.port,
      kind: sensor.kind,
      values: sensor.values.map(column),
      modes: sensorModes(events, sensor.port, sensor.kind),
    }));
    this.log = new EventLog(events);
    this.screen = new ScreenHistory(this.log.ofType('screen'));
  }
}

/** The whole run. */
class Recording {
  constructor(data) {
    this.header = data.header;
    this.summary = data.summary;
    this.scene = data.scene;
    const size = data.times.from + data.times.deltas.length;
    this.times = decodeColumn(data.times, size);
    this.events = data.events.map((event, order) => ({...event, order})).sort((a, b) => a.t - b.t || a.order - b.order);
    this.log = new EventLog(this.events);
    const last = this.events.length > 0 ? this.events[this.events.length - 1].t : 0;
    this.duration = Math.max(size > 0 ? this.times[size - 1] : 0, last, 1e-3);
    this.robots = data.robots.map((robot) => this.makeRobot(robot, data.scene.robots.find((one) => one.name === robot.name),
      this.events.filter((event) => event.robot === robot.name)));
    this.bodies = data.bodies.map((body) => ({id: body.id, track: new Track(body, this.times)}));
    this.arbitrations = this.robots.flatMap((robot) => Arbitration.all(robot, this.duration));
  }

  makeRobot(data, scene, events) {
    return new RecordedRobot(data, this.times, scene, events);
  }

  /** Index of the sample that counts at a time. */
  sampleAt(time) {
    return Math.max(0, lastNotAfter(this.times, time + 1e-9));
  }
}
