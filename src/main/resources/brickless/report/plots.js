// Motors and sensors over time.

const PLOT_HEIGHT = 84;
/** Height of a lane of states; a lane at least so much apart from the next. */
const STATE_HEIGHT = 26;

/** The plots that a robot's signals give, in the order they are offered. */
function plotsOf(robot, times) {
  const motors = (signal) => robot.motors.map((motor) => ({name: motor.port, colour: `var(--port-${motor.port})`, values: motor[signal]}));
  const plots = [];
  if (robot.motors.length > 0) {
    plots.push({id: 'speed', title: 'Speed', unit: '°/s', places: 0, series: motors('speed'), on: true, zero: true});
    plots.push({id: 'duty', title: 'Duty', unit: '%', places: 0, series: motors('duty'), on: false, zero: true});
    plots.push({id: 'tacho', title: 'Tacho', unit: '°', places: 0, series: motors('tacho'), on: false});
    plots.push({id: 'current', title: 'Current', unit: 'A', places: 2, series: motors('amperes'), on: false, zero: true});
  }
  plots.push(...robot.sensors.flatMap((sensor) => sensorPlots(sensor, times)));
  plots.push({id: 'heading', title: 'Heading', unit: '°', places: 0, series: [{name: '', colour: 'var(--series-0)', values: robot.heading}], on: false});
  plots.push({id: 'battery', title: 'Battery', unit: 'V', places: 2, series: [{name: '', colour: 'var(--series-1)', values: robot.volts}], on: false});
  return plots;
}

/** What is plotted in which unit: angle, ° clockwise */
function unitText(plot) {
  const unit = [plot.unit, plot.sense].filter((text) => text).join(' ');
  return [plot.what, unit].filter((text) => text).join(', ');
}

/** What a plot is called on its button: with its quantity where a sensor has several plots. */
function chipText(plot, plots) {
  return plots.filter((other) => other.title === plot.title).length > 1 ? `${plot.title.split(' ')[0]} ${plot.what}` : plot.title;
}

class Plots {
  constructor(host, recording, robot, group) {
    this.recording = recording;
    this.group = group;
    this.chips = html('div', {class: 'chips', role: 'group', 'aria-label': 'Signals shown'});
    this.body = html('div', {class: 'tracks'});
    host.append(html('div', {class: 'panel-head'}, html('h2', {}, 'Motors and sensors'), this.chips), this.body);
    const plots = plotsOf(robot, recording.times);
    this.plots = plots.map((plot) => this.plot(plot, chipText(plot, plots)));
    const axis = new TimeAxis(group.window);
    group.add(axis.row, (context, width, height) => axis.draw(context, width, height));
    this.body.append(axis.row.node);
  }

  plot(plot, chip) {
    const readout = html('div', {class: 'track-readout'});
    plot.cells = plot.series.map((series) => {
      const value = html('span', {class: 'value'});
      const swatch = html('span', {class: 'swatch'});
      swatch.style.background = series.colour;
      readout.append(html('div', {class: 'reading'}, plot.series.length > 1 || series.name ? swatch : null, series.name ? html('span', {class: 'name'}, series.name) : null, value));
      return value;
    });
    const label = html('div', {class: 'track-label'}, html('strong', {}, plot.title),
      html('span', {class: 'unit'}, unitText(plot)));
    plot.row = new TrackRow(plot.words ? STATE_HEIGHT * plot.series.length + 8 : PLOT_HEIGHT, label, readout, `${plot.title} over time`);
    plot.range = this.range(plot);
    this.group.add(plot.row, (context, width, height) => this.draw(plot, context, width, height));
    this.body.append(plot.row.node);
    plot.row.node.hidden = !plot.on;
    this.chips.append(html('button', {type: 'button', class: 'chip', 'aria-pressed': String(plot.on), on: {click: (event) => {
      plot.row.node.hidden = !plot.row.node.hidden;
      event.currentTarget.setAttribute('aria-pressed', String(!plot.row.node.hidden));
      this.group.redraw();
    }}}, chip));
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
    if (plot.words) {
      plot.series.forEach((series, lane) => this.states(plot, series, context, width, 4 + lane * STATE_HEIGHT));
      return;
    }
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
    context.strokeStyle = cssColour(series.colour);
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

  /** A block for each stretch in a state other than 0. */
  states(plot, series, context, width, top) {
    const {times} = this.recording;
    const {from, to, span} = this.group.window;
    const xOf = (i) => Math.min(width, Math.max(0, (times[Math.min(i, times.length - 1)] - from) / span * width));
    const last = Math.min(times.length - 1, lastNotAfter(times, to));
    for (let i = Math.max(0, lastNotAfter(times, from)); i <= last;) {
      const state = series.values[i];
      const begin = i;
      while (i <= last && (series.values[i] === state || (Number.isNaN(state) && Number.isNaN(series.values[i])))) {
        i++;
      }
      if (state > 0) {
        this.block(context, plot.paints[state] || cssColour(series.colour), xOf(begin), top, Math.max(1, xOf(i) - xOf(begin)));
      }
    }
  }

  block(context, paint, x, top, width) {
    context.fillStyle = paint;
    context.fillRect(x, top, width, STATE_HEIGHT - 6);
    if (width > 2) {
      context.strokeStyle = themeColour('--line');
      context.lineWidth = 1;
      context.strokeRect(x + 0.5, top + 0.5, width - 1, STATE_HEIGHT - 7);
    }
  }

  point(plot, context, x, bottom, top, drawing) {
    if (!drawing) {
      context.moveTo(x, bottom);
    } else {
      context.lineTo(x, bottom);
    }
    if (top !== bottom) {
      context.lineTo(x, top);
    }
    return true;
  }

  text(plot, value) {
    return plot.words || plot.lack ? quantityText({...plot, unit: ''}, value) : number(value, plot.places);
  }

  show(time) {
    const sample = this.recording.sampleAt(time);
    for (const plot of this.plots) {
      if (!plot.row.node.hidden) {
        plot.series.forEach((series, i) => setText(plot.cells[i], this.text(plot, series.values[sample])));
      }
    }
  }
}
