// A recording that grows while one watches. Lists only ever get longer, so views may keep them.

const MOTOR_SIGNALS = ['tacho', 'speed', 'duty', 'amperes'];
/** Printed lines kept; the oldest go first. */
const MOST_LINES = 5000;

/** The newest picture of a screen; earlier ones are not kept. */
class LiveScreen {
  constructor(events) {
    this.picture = new Uint8Array(SCREEN_ROW_BYTES * SCREEN_HEIGHT);
    this.changes = 0;
    events.forEach((event) => this.add(event));
  }

  add(event) {
    applyRows(this.picture, event);
    this.changes++;
  }

  changesAt() {
    return this.changes;
  }

  after() {
    return this.picture;
  }
}

class LiveRobot extends RecordedRobot {
  constructor(data, times, scene, events) {
    super(data, times, scene, events.filter((event) => event.type !== 'screen'));
    this.modes = events.filter((event) => event.type === 'mode');
    this.screen = new LiveScreen(events.filter((event) => event.type === 'screen'));
    this.heading = Array.from(this.heading);
    this.volts = Array.from(this.volts);
    for (const motor of this.motors) {
      for (const signal of MOTOR_SIGNALS) {
        motor[signal] = Array.from(motor[signal]);
      }
    }
    this.sensors.forEach((sensor) => {
      sensor.values = sensor.values.map((column) => Array.from(column));
    });
  }

  /** Takes the sample with an index; true if it has a signal that there was not before. */
  grow(index, sample) {
    this.heading[index] = sample.heading;
    this.volts[index] = sample.volts;
    const motors = sample.motors.map((motor) => this.growMotor(index, motor));
    const sensors = sample.sensors.map((sensor) => this.growSensor(index, sensor));
    return motors.concat(sensors).includes(true);
  }

  growMotor(index, sample) {
    let known = this.motors.find((one) => one.port === sample.port);
    const added = !known;
    if (added) {
      known = {port: sample.port};
      MOTOR_SIGNALS.forEach((signal) => {
        known[signal] = nothing(index);
      });
      insert(this.motors, known);
    }
    for (const signal of MOTOR_SIGNALS) {
      known[signal][index] = finite(sample[signal]);
    }
    return added;
  }

  /** A sensor went into a mode; true if it had not been in that one before. */
  changeMode(event) {
    this.modes.push(event);
    const known = this.sensors.find((one) => one.port === event.port && one.kind === event.kind);
    if (!known) {
      return false;
    }
    const before = known.modes.some((one) => one.mode === event.mode);
    known.modes.push(event);
    return !before;
  }

  growSensor(index, sample) {
    let known = this.sensors.find((one) => one.port === sample.port && one.kind === sample.kind);
    if (!known) {
      known = {port: sample.port, kind: sample.kind, values: [], modes: sensorModes(this.modes, sample.port, sample.kind)};
      insert(this.sensors, known);
    }
    const before = known.values.length;
    while (known.values.length < sample.values.length) {
      known.values.push(nothing(index));
    }
    known.values.forEach((column, i) => {
      column[index] = finite(sample.values[i]);
    });
    return known.values.length > before;
  }
}

function nothing(size) {
  return new Array(size).fill(NaN);
}

function insert(devices, device) {
  devices.push(device);
  devices.sort((a, b) => String(a.port).localeCompare(String(b.port)));
}

function finite(value) {
  return typeof value === 'number' ? value : NaN;
}

class LiveRecording extends Recording {
  constructor(data) {
    super(data);
    this.times = Array.from(this.times);
    this.prints = this.events.filter((event) => event.type === 'print');
    this.log = new EventLog(this.events.filter((event) => !['print', 'screen'].includes(event.type)));
    this.events = this.log.all;
  }

  makeRobot(data, scene, events) {
    return new LiveRobot(data, this.times, scene, events);
  }

  robot(name) {
    return this.robots.find((one) => one.name === name);
  }

  /** Takes a sample; true if there are signals now that there were not before. */
  sample(line) {
    const index = this.times.length;
    if (index > 0 && line.t <= this.times[index - 1]) {
      return false;
    }
    this.times.push(line.t);
    this.duration = line.t;
    this.arbitrations.forEach((one) => one.extend(line.t));
    return line.robots.map((sample) => this.robot(sample.name).grow(index, sample)).some(Boolean);
  }

  /** Takes the next event; true if there is something to plot or to list that there was not before. */
  happened(event) {
    const robot = this.robot(event.robot);
    if (event.type === 'screen') {
      robot.screen.add(event);
      return false;
    }
    if (event.type === 'print') {
      this.prints.push(event);
      if (this.prints.length >= 2 * MOST_LINES) {
        this.prints.splice(0, MOST_LINES);
      }
      return false;
    }
    this.log.add(event);
    if (!robot) {
      return false;
    }
    robot.log.add(event);
    if (event.type === 'mode') {
      return robot.changeMode(event);
    }
    if (event.type === 'arbitrator') {
      this.arbitrations.push(new Arbitration(robot, event, event.t));
      return true;
    }
    this.arbitrations.filter((one) => one.robot === robot && one.number === event.arbitrator).forEach((one) => one.add(event));
    return false;
  }
}
