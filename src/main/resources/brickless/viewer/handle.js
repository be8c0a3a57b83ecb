// What a hand can take in the arena: an outline that follows a robot or a movable thing, with a knob to turn it and a button to take it away.

const KNOB_PIXELS = 9;
const ARROWS = {ArrowLeft: [-10, 0], ArrowRight: [10, 0], ArrowUp: [0, -10], ArrowDown: [0, 10]};
const TURNS = {',': -5, '.': 5};

/** Middle of the area inside rings of points. */
function centroid(rings) {
  let area = 0;
  let x = 0;
  let y = 0;
  for (const ring of rings) {
    ring.forEach(([x0, y0], i) => {
      const [x1, y1] = ring[(i + 1) % ring.length];
      const cross = x0 * y1 - x1 * y0;
      area += cross;
      x += (x0 + x1) * cross;
      y += (y0 + y1) * cross;
    });
  }
  return area === 0 ? {x: rings[0][0][0], y: rings[0][0][1]} : {x: x / (3 * area), y: y / (3 * area)};
}

class Handle {
  constructor(hands, name, outlines, middle, removable) {
    this.hands = hands;
    this.name = name;
    this.middle = middle;
    this.removable = removable;
    this.shown = null;
    const reach = Math.max(...outlines.flat().map(([x, y]) => Math.hypot(x - middle.x, y - middle.y)));
    this.shape = svg('g', {class: 'handle-shape'}, ...outlines.map((ring) => svg('polygon', {points: ring.map((point) => point.join(',')).join(' ')})));
    this.knob = svg('g', {class: 'knob', 'aria-hidden': 'true'}, svg('line', {x1: 0, y1: 0, x2: reach, y2: 0}), svg('circle', {cx: 0, cy: 0}));
    this.bin = svg('g', {class: 'bin', role: 'button', 'aria-label': `Take ${name} away`}, svg('circle'), svg('path', {d: 'M-3.5,-3.500L3.5,3.5M3.5,-3.500L-3.5,3.5'}));
    this.reach = reach;
    this.tools = svg('g', {class: 'handle-tools'}, this.knob, ...(removable ? [this.bin] : []));
    this.node = svg('g', {class: 'handle', role: 'button', 'aria-roledescription': 'movable', tabindex: 0, 'data-name': name,
      'aria-label': `${name}: drag it; arrow keys move it, comma and full stop turn it${removable ? ', Delete takes it away' : ''}`}, this.shape, this.tools);
    this.listen();
  }

  listen() {
    this.node.addEventListener('pointerdown', (event) => this.grab(event, event.shiftKey));
    this.knob.addEventListener('pointerdown', (event) => this.grab(event, true));
    this.bin.addEventListener('pointerdown', (event) => {
      event.stopPropagation();
      this.remove();
    });
    this.node.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.change({...this.pose, heading: this.pose.heading + (event.deltaY > 0 ? 5 : -5)});
    }, {passive: false});
    this.node.addEventListener('keydown', (event) => this.key(event));
    this.node.addEventListener('focus', () => this.hands.choose(this));
  }

  /** Lays knob and bin out for a scale in millimetres per pixel. */
  scale(millimetres) {
    const radius = KNOB_PIXELS * millimetres;
    fill(this.knob.lastChild, {cx: this.reach + 3 * radius, cy: 0, r: radius}, []);
    this.knob.firstChild.setAttribute('x2', this.reach + 2 * radius);
    this.bin.setAttribute('transform', `translate(0 ${-this.reach - 2 * radius}) scale(${radius / 7})`);
    this.bin.firstChild.setAttribute('r', 7);
  }

  /** Follows the thing: where its middle is, and its heading. */
  follow(pose) {
    if (!this.held) {
      this.put(pose);
    }
  }

  put(pose) {
    this.pose = pose;
    const {x, y, heading} = pose;
    const text = `translate(${x.toFixed(1)} ${y.toFixed(1)}) rotate(${heading.toFixed(1)})`;
    if (text !== this.shown) {
      this.shown = text;
      this.shape.setAttribute('transform', `${text} translate(${-this.middle.x} ${-this.middle.y})`);
      this.tools.setAttribute('transform', `translate(${x.toFixed(1)} ${y.toFixed(1)})`);
      this.knob.setAttribute('transform', `rotate(${heading.toFixed(1)})`);
    }
  }

  grab(event, turning) {
    if (event.button !== 0 || !this.pose) {
      return;
    }
    event.stopPropagation();
    event.preventDefault();
    this.hands.choose(this);
    this.sent = null;
    const from = this.hands.point(event);
    const start = this.pose;
    const bearing = (point) => Math.atan2(point.y - start.y, point.x - start.x) * 180 / Math.PI;
    const move = (next) => {
      const point = this.hands.point(next);
      const turn = ((bearing(point) - bearing(from) + 540) % 360 + 360) % 360 - 180;
      this.drag(turning ? {...start, heading: start.heading + turn} : {...start, x: start.x + point.x - from.x, y: start.y + point.y - from.y});
    };
    this.node.setPointerCapture(event.pointerId);
    this.node.addEventListener('pointermove', move);
    this.node.addEventListener('lostpointercapture', () => {
      this.node.removeEventListener('pointermove', move);
      this.drop();
    }, {once: true});
  }

  drag(pose) {
    this.held = true;
    this.moved = true;
    this.node.classList.add('dragged');
    this.put(pose);
    if (this.hands.running) {
      this.hands.move(this);
    }
  }

  /** Lets go; the outline stays where it was put until the run has seen it. */
  drop() {
    this.node.classList.remove('dragged');
    if (this.moved) {
      this.moved = false;
      this.hands.move(this).then(() => {
        this.held = false;
      });
    }
  }

  change(pose) {
    this.sent = null;
    this.drag(pose);
    this.drop();
  }

  remove() {
    if (this.removable) {
      this.hands.next.delete(this.name);
      this.hands.touch(`remove ${this.name}`);
      this.node.blur();
      this.hands.choose(null);
    }
  }

  key(event) {
    const arrow = ARROWS[event.key];
    const turn = TURNS[event.key];
    if (event.ctrlKey || event.metaKey || event.altKey || !this.pose) {
      return;
    }
    if (arrow) {
      this.change({...this.pose, x: this.pose.x + arrow[0], y: this.pose.y + arrow[1]});
    } else if (turn) {
      this.change({...this.pose, heading: this.pose.heading + turn});
    } else if (event.key === 'Delete' || event.key === 'Backspace') {
      this.remove();
    } else if (event.key === 'Escape') {
      this.node.blur();
      this.hands.choose(null);
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  }

  /** The words of the stimuli file. */
  stimulus() {
    const {x, y, heading} = this.pose;
    return `move ${this.name} ${x.toFixed(0)},${y.toFixed(0)} ${heading.toFixed(1)}`;
  }
}
