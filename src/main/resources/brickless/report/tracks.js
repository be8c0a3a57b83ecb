// What the plots and the behaviour timeline have in common: one stretch of time, one scale, one cursor.

/** The stretch of time that is shown. */
class TimeWindow {
  constructor(duration) {
    this.duration = duration;
    this.from = 0;
    this.to = duration;
    this.listeners = [];
  }

  get span() {
    return this.to - this.from;
  }

  onChange(listener) {
    this.listeners.push(listener);
  }

  set(from, span) {
    const length = Math.min(this.duration, Math.max(0.5, span));
    const start = Math.min(Math.max(0, from), this.duration - length);
    if (start !== this.from || length !== this.span) {
      this.from = start;
      this.to = start + length;
      this.listeners.forEach((listener) => listener());
    }
  }

  /** Makes the stretch shorter (factor below 1) or longer around a time, which keeps its place. */
  zoom(factor, around) {
    const place = (around - this.from) / this.span;
    const span = Math.min(this.duration, Math.max(0.5, this.span * factor));
    this.set(around - Math.min(1, Math.max(0, place)) * span, span);
  }

  /** Turns the page when a time has left it. */
  follow(time) {
    if (time < this.from || time > this.to) {
      this.set(time < this.from ? time - this.span * 0.9 : time - this.span * 0.1, this.span);
    }
  }
}

/** Round steps for an axis of a length into about so many parts. */
function niceStep(length, parts) {
  const rough = length / parts;
  const power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map((step) => step * power).find((step) => step >= rough);
}

/** One row: a label, a canvas over the shown stretch of time, and the values at the cursor. */
class TrackRow {
  constructor(height, label, readout, description) {
    this.height = height;
    this.canvas = html('canvas', {class: 'track-canvas', role: 'img', 'aria-label': description});
    this.cursor = html('div', {class: 'cursor'});
    this.area = html('div', {class: 'track-area'}, this.canvas, this.cursor);
    this.area.style.height = `${height}px`;
    this.node = html('div', {class: 'track'}, label, this.area, readout);
  }

  /** The canvas cleared for drawing, its unit one CSS pixel, or null while the row is not shown. */
  begin() {
    const width = this.area.clientWidth;
    if (width === 0) {
      return null;
    }
    const ratio = window.devicePixelRatio || 1;
    this.width = width;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(this.height * ratio);
    const context = this.canvas.getContext('2d');
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    return context;
  }

  place(window, time) {
    const part = (time - window.from) / window.span;
    this.cursor.style.transform = `translateX(${(part * this.area.clientWidth).toFixed(1)}px)`;
    this.cursor.hidden = part < 0 || part > 1;
  }
}

/** Rows that share a window: redraws them when it changes, moves the cursors, and lets the pointer set the time. */
class TrackGroup {
  constructor(window, player) {
    this.window = window;
    this.player = player;
    this.rows = [];
    this.pending = false;
    window.onChange(() => this.redraw());
    new ResizeObserver(() => this.redraw()).observe(document.body);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.redraw());
    player.add(this);
  }

  add(row, draw) {
    row.draw = draw;
    this.rows.push(row);
    row.area.addEventListener('pointerdown', (event) => this.grab(row, event));
    row.area.addEventListener('wheel', (event) => this.wheel(row, event), {passive: false});
  }

  remove(row) {
    this.rows = this.rows.filter((one) => one !== row);
  }

  timeAt(row, event) {
    const box = row.area.getBoundingClientRect();
    return this.window.from + (event.clientX - box.left) / box.width * this.window.span;
  }

  grab(row, event) {
    if (event.button !== 0) {
      return;
    }
    const move = (next) => this.player.seek(Math.min(this.window.to, Math.max(this.window.from, this.timeAt(row, next))));
    row.area.setPointerCapture(event.pointerId);
    row.area.addEventListener('pointermove', move);
    row.area.addEventListener('lostpointercapture', () => row.area.removeEventListener('pointermove', move), {once: true});
    move(event);
  }

  wheel(row, event) {
    if (event.ctrlKey || event.metaKey) {
      event.preventDefault();
      this.window.zoom(event.deltaY > 0 ? 1.25 : 0.8, this.timeAt(row, event));
    }
  }

  redraw() {
    if (!this.pending) {
      this.pending = true;
      requestAnimationFrame(() => {
        this.pending = false;
        this.drawNow();
      });
    }
  }

  drawNow() {
    for (const row of this.rows) {
      const context = row.begin();
      if (context) {
        row.draw(context, row.width, row.height);
      }
      row.place(this.window, this.player.time);
    }
  }

  show(time) {
    this.window.follow(time);
    this.rows.forEach((row) => row.place(this.window, time));
  }
}

/** The axis of time with round marks. */
class TimeAxis {
  constructor(window) {
    this.window = window;
    this.row = new TrackRow(22, html('div', {class: 'track-label'}), html('div', {class: 'track-readout'}), 'Time');
  }

  draw(context, width, height) {
    const step = niceStep(this.window.span, Math.max(2, width / 90));
    context.fillStyle = themeColour('--muted');
    context.strokeStyle = themeColour('--line');
    context.font = '11px system-ui, sans-serif';
    context.textBaseline = 'middle';
    for (let i = Math.ceil(this.window.from / step); i * step <= this.window.to + 1e-9; i++) {
      const x = Math.round((i * step - this.window.from) / this.window.span * width) + 0.5;
      context.beginPath();
      context.moveTo(x, 0);
      context.lineTo(x, 5);
      context.stroke();
      context.textAlign = x < 14 ? 'left' : x > width - 14 ? 'right' : 'center';
      context.fillText(clock(i * step, step < 0.1 ? 2 : step < 1 ? 1 : 0), x, height / 2 + 3);
    }
  }
}

/** Vertical lines at the marks of the axis of time. */
function gridLines(context, window, width, height) {
  const step = niceStep(window.span, Math.max(2, width / 90));
  context.strokeStyle = themeColour('--grid');
  context.lineWidth = 1;
  context.beginPath();
  for (let i = Math.ceil(window.from / step); i * step <= window.to + 1e-9; i++) {
    const x = Math.round((i * step - window.from) / window.span * width) + 0.5;
    context.moveTo(x, 0);
    context.lineTo(x, height);
  }
  context.stroke();
}
