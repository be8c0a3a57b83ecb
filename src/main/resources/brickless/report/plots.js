// Motors and sensors over time.

const PLOT_HEIGHT = 84;

/** The plots that a robot's signals give, in the order they are offered. */
function plotsOf(robot) {
  const motors = (signal) => robot.motors.map((motor) => ({name: motor.port, colour: `--port-${motor.port}`, values: motor[signal]}));
  const plots = [];
  if (robot.motors.length > 0) {
    plots.push({id: 'speed', title: 'Speed', unit: '°/s', places: 0, series: motors('speed'), on: true, zero: true});
    plots.push({id: 'duty', title: 'Duty', unit: '%', places: 0, series: motors('duty'), on: false, zero: true});
    plots.push({id: 'tacho', title: 'Tacho', unit: '°', places: 0, series: motors('tacho'), on: false});
    plots.push({id: 'current', title: 'Current', unit: 'A', places: 2, series: motors('amperes'), on: false, zero: true});
  }
  for (const sensor of robot.sensors.filter((one) => one.values.length > 0)) {
    const series = sensor.values.map((values, i) => ({name: sensor.values.length > 1 ? String(i) : '', colour: `--series-${i % 4}`, values}));
    const whole = sensor.values.every((values) => values.every((value) => Number.isNaN(value) || Number.isInteger(value)));
    plots.push({id: `s${sensor.port}-${sensor.kind}`, title: `S${sensor.port} ${sensorName(sensor.kind)}`, unit: 'raw', places: whole ? 0 : 1, series, on: true,
      steps: sensor.kind.includes('touch')});
  }
  plots.push({id: 'heading', title: 'Heading', unit: '°', places: 0, series: [{name: '', colour: '--series-0', values: robot.heading}], on: false});
  plots.push({id: 'battery', title: 'Battery', unit: 'V', places: 2, series: [{name: '', colour: '--series-1', values: robot.volts}], on: false});
  return plots;
}

class Plots {
  constructor(host, recording, robot, group) {
    this.recording = recording;
    this.group = group;
    this.chips = html('div', {class: 'chips', role: 'group', 'aria-label': 'Signals shown'});
    this.body = html('div', {class: 'tracks'});
    host.append(html('div', {class: 'panel-head'}, html('h2', {}, 'Motors and sensors'), this.chips), this.body);
    this.plots = plotsOf(robot).map((plot) => this.plot(plot));
    const axis = new TimeAxis(group.window);
    group.add(axis.row, (context, width, height) => axis.draw(context, width, height));
    this.body.append(axis.row.node);
  }

  plot(plot) {
    const readout = html('div', {class: 'track-readout'});
    plot.cells = plot.series.map((series) => {
      const value = html('span', {class: 'value'});
      const swatch = html('span', {class: 'swatch'});
      swatch.style.background = `var(${series.colour})`;
      readout.append(html('div', {class: 'reading'}, plot.series.length > 1 || series.name ? swatch : null, series.name ? html('span', {class: 'name'}, series.name) : null, value));
      return value;
    });
    const label = html('div', {class: 'track-label'}, html('strong', {}, plot.title), html('span', {class: 'unit'}, plot.unit));
    plot.row = new TrackRow(PLOT_HEIGHT, label, readout, `${plot.title} over time`);
    plot.range = this.range(plot);
    this.group.add(plot.row, (context, width, height) => this.draw(plot, context, width, height));
    this.body.append(plot.row.node);
    plot.row.node.hidden = !plot.on;
    this.chips.append(html('button', {type: 'button', class: 'chip', 'aria-pressed': String(plot.on), on: {click: (event) => {
      plot.row.node.hidden = !plot.row.node.hidden;
      event.currentTarget.setAttribute('aria-pressed', String(!plot.row.node.hidden));
      this.group.redraw();
    }}}, plot.title));
    return plot;
  }

  range(plot) {
    let low = plot.zero ? 0 : Infinity;
    let high = plot.zero ? 0 : -Infinity;
    for (const series of plot.series) {
      for (const value of series.values) {
        if (value < low) {
          low = value;
        }
        if (value > high) {
          high = value;
        }
      }
    }
    if (low > high) {
      return {low: 0, high: 1};
    }
    const margin = high > low ? (high - low) * 0.08 : Math.max(1, Math.abs(high) * 0.1);
    return {low: low - margin, high: high + margin, least: low, most: high};
  }

  draw(plot, context, width, height) {
    gridLines(context, this.group.window, width, height);
    const {low, high} = plot.range;
    const yOf = (value) => height - (value - low) / (high - low) * height;
    if (low < 0 && high > 0) {
      context.strokeStyle = themeColour('--line');
      context.beginPath();
      context.moveTo(0, Math.round(yOf(0)) + 0.5);
      context.lineTo(width, Math.round(yOf(0)) + 0.5);
      context.stroke();
    }
    plot.series.forEach((series) => this.curve(plot, series, context, width, yOf));
    this.scale(plot, context, height);
  }

  scale(plot, context, height) {
    if (plot.range.most === undefined) {
      return;
    }
    context.font = '10.5px system-ui, sans-serif';
    context.textAlign = 'left';
    context.textBaseline = 'top';
    this.haloed(context, number(plot.range.most, plot.places), 4, 3);
    context.textBaseline = 'bottom';
    this.haloed(context, number(plot.range.least, plot.places), 4, height - 2);
  }

  /** Text that stays readable where a curve passes behind it. */
  haloed(context, text, x, y) {
    context.strokeStyle = themeColour('--surface');
    context.lineWidth = 4;
    context.strokeText(text, x, y);
    context.fillStyle = themeColour('--muted');
    context.fillText(text, x, y);
  }

  /** Where several samples fall on one pixel, a line from the least to the greatest, so that no peak is lost. */
  curve(plot, series, context, width, yOf) {
    const {times} = this.recording;
    const {from, to, span} = this.group.window;
    const first = Math.max(0, lastNotAfter(times, from));
    const last = Math.min(times.length - 1, lastNotAfter(times, to) + 1);
    const xOf = (i) => (times[i] - from) / span * width;
    context.strokeStyle = themeColour(series.colour);
    context.lineWidth = 1.5;
    context.lineJoin = 'round';
    context.beginPath();
    let drawing = false;
    const stride = Math.max(1, Math.floor((last - first) / (width * 2)));
    for (let i = first; i <= last; i += stride) {
      let least = Infinity;
      let most = -Infinity;
      for (let j = i; j < i + stride && j <= last; j++) {
        least = Math.min(least, Number.isNaN(series.values[j]) ? Infinity : series.values[j]);
        most = Math.max(most, Number.isNaN(series.values[j]) ? -Infinity : series.values[j]);
      }
      if (least > most) {
        drawing = false;
      } else {
        drawing = this.point(plot, context, xOf(i), yOf(least), yOf(most), drawing);
      }
    }
    context.stroke();
  }

  point(plot, context, x, bottom, top, drawing) {
    if (!drawing) {
      context.moveTo(x, bottom);
    } else if (plot.steps) {
      context.lineTo(x, this.lastY);
      context.lineTo(x, bottom);
    } else {
      context.lineTo(x, bottom);
    }
    if (top !== bottom) {
      context.lineTo(x, top);
    }
    this.lastY = top;
    return true;
  }

  show(time) {
    const sample = this.recording.sampleAt(time);
    for (const plot of this.plots) {
      if (!plot.row.node.hidden) {
        plot.series.forEach((series, i) => setText(plot.cells[i], number(series.values[sample], plot.places)));
      }
    }
  }
}
