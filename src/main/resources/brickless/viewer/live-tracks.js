// Plots and behaviours whose right edge is now.

const WINDOW_SECONDS = 30;
/** Plots are drawn no more often than this. */
const REDRAW_MILLIS = 90;

/** The last half minute. */
class LiveWindow extends TimeWindow {
  constructor() {
    super(WINDOW_SECONDS);
  }

  /** Ends at a time, or shows the first half minute. */
  follow(time) {
    this.to = Math.max(this.duration, time);
    this.from = this.to - this.duration;
  }

  zoom(factor) {
    this.duration = Math.min(600, Math.max(5, this.duration * factor));
    this.follow(this.now || 0);
    this.listeners.forEach((listener) => listener());
  }
}

class LiveGroup extends TrackGroup {
  constructor() {
    super(new LiveWindow(), {time: 0, add() {}});
    this.drawn = 0;
  }

  /** There is no going back in a run that goes on. */
  grab() {}

  show(time) {
    this.window.now = time;
    this.player.time = time;
    this.window.follow(time);
    const now = performance.now();
    if (now - this.drawn >= REDRAW_MILLIS) {
      this.drawn = now;
      this.redraw();
    }
  }
}

class LivePlots extends Plots {
  /** `chosen` remembers which signals a person has switched on or off, by id. */
  constructor(host, recording, robot, group, chosen) {
    super(host, recording, robot, group);
    this.robot = robot;
    this.plots.forEach((plot, i) => {
      plot.series.forEach((series) => {
        series.values = Array.isArray(series.values) ? series.values : Array.from(series.values);
      });
      const chip = this.chips.children[i];
      if (chosen.has(plot.id) && chosen.get(plot.id) !== plot.on) {
        chip.click();
      }
      chip.addEventListener('click', () => chosen.set(plot.id, !plot.row.node.hidden));
    });
  }

  /** Takes the newest sample; false if it holds a quantity that has no plot yet. */
  grow() {
    const index = this.recording.times.length - 1;
    const known = this.robot.sensors.map((sensor) => this.growSensor(sensor, index)).every(Boolean);
    for (const plot of this.plots) {
      const {range} = plot;
      const values = plot.series.map((series) => series.values[index]).filter(Number.isFinite);
      if (range.least === undefined || values.some((value) => value < range.least || value > range.most)) {
        plot.range = this.range(plot);
      }
    }
    return known;
  }

  growSensor(sensor, index) {
    const title = sensorTitle(sensor);
    this.plots.filter((plot) => plot.title === title).forEach((plot) => plot.series.forEach((series) => {
      series.values[index] = NaN;
    }));
    const mode = modeAt(sensor, this.recording.times[index]);
    return sensor.values.map((values, i) => ({one: sensorQuantity(sensor.kind, mode, i), value: values[index]}))
      .filter(({value}) => Number.isFinite(value))
      .every(({one, value}) => this.growQuantity(title, one, one.of(value), index));
  }

  growQuantity(title, one, value, index) {
    const plot = this.plots.find((other) => other.title === title && other.what === one.what);
    const series = plot && plot.series.find((other) => other.name === (one.name || ''));
    if (series) {
      series.values[index] = value;
    }
    return Boolean(series);
  }
}
