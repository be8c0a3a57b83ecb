// Drawings (worlds and robots) as layers of the arena. Each lives in a shadow tree, so that its ids and styles stay its own.

const REFERENCE = /^\s*(#|data:image\/(png|jpeg)[;,])/i;

/** Removes what can run or load: scripts, foreign content, event handlers, references to anywhere else. */
function disarm(root) {
  root.querySelectorAll('script, foreignObject, iframe, object, embed, a').forEach((node) => node.remove());
  for (const node of [root, ...root.querySelectorAll('*')]) {
    for (const attribute of [...node.attributes]) {
      const name = attribute.localName.toLowerCase();
      if (name.startsWith('on') || (name === 'href' && !REFERENCE.test(attribute.value))) {
        node.removeAttributeNode(attribute);
      }
    }
  }
}

/** Line of every start tag, in document order; what has no id is named by its tag and line. */
function tagLines(text) {
  const lines = [];
  const skipped = /<!--[^]*?-->|<!\[CDATA\[[^]*?\]\]>|<\?[^]*?\?>|<(?![/!?])|\n/g;
  let line = 1;
  for (const match of text.matchAll(skipped)) {
    if (match[0] === '<') {
      lines.push(line);
    } else {
      line += match[0].split('\n').length - 1;
    }
  }
  return lines;
}

/** Elements of a drawing by the names that the trace gives them. */
function namedElements(root, text) {
  const lines = tagLines(text);
  const named = new Map();
  [root, ...root.querySelectorAll('*')].forEach((node, i) => {
    const base = node.id || `${node.localName}-line-${lines[i]}`;
    let name = base;
    for (let copy = 2; named.has(name); copy++) {
      name = `${base}-${copy}`;
    }
    named.set(name, node);
  });
  return named;
}

/** Transform from an element's own frame to the drawing's; the element's own transform counts only if asked. */
function matrixWithin(drawing, node, own) {
  let matrix = new DOMMatrix();
  for (let one = own ? node : node.parentNode; one && one !== drawing; one = one.parentNode) {
    const transform = one.transform && one.transform.baseVal.consolidate();
    if (transform) {
      const m = transform.matrix;
      matrix = new DOMMatrix([m.a, m.b, m.c, m.d, m.e, m.f]).multiply(matrix);
    }
  }
  return matrix;
}

function matrixText(m) {
  return `matrix(${[m.a, m.b, m.c, m.d, m.e, m.f].join(' ')})`;
}

/** Reads a drawing; null if it is none. */
function parseDrawing(text) {
  const root = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
  return root && root.localName === 'svg' && root.namespaceURI === SVG && !root.querySelector('parsererror') ? document.importNode(root, true) : null;
}

/** A layer of the arena with its own ids and styles, as large as the arena, in millimetres. */
class Layer {
  constructor(stage, bounds, className) {
    this.host = html('div', {class: `layer ${className}`, 'aria-hidden': 'true'});
    stage.append(this.host);
    this.root = svg('svg', {viewBox: bounds.join(' '), width: '100%', height: '100%', preserveAspectRatio: 'xMidYMid meet'});
    this.root.style.cssText = 'display:block;position:absolute;inset:0;overflow:visible';
    this.host.attachShadow({mode: 'open'}).append(this.root);
  }
}

/** The world's drawing, whose movable bodies can be put elsewhere. */
class WorldDrawing {
  constructor(stage, scene) {
    this.layer = new Layer(stage, scene.bounds, 'world');
    this.bodies = new Map();
    const drawing = parseDrawing(scene.svg);
    if (drawing) {
      this.insert(drawing, scene);
    }
    for (const body of scene.bodies.filter((one) => !this.bodies.has(one.id))) {
      this.outline(body);
    }
  }

  insert(drawing, scene) {
    const named = namedElements(drawing, scene.svg);
    disarm(drawing);
    const [x, y, width, height] = scene.bounds;
    fill(drawing, {x, y, width, height, viewBox: scene.bounds.join(' '), preserveAspectRatio: 'none'}, []);
    drawing.removeAttribute('style');
    drawing.style.overflow = 'hidden';
    this.layer.root.append(drawing);
    drawing.querySelectorAll('[data-robot]').forEach((start) => start.setAttribute('display', 'none'));
    for (const body of scene.bodies) {
      const node = named.get(body.id);
      if (node && node.isConnected && node.getBBox) {
        this.bodies.set(body.id, this.movable(drawing, node));
      }
    }
  }

  /** Displacements are of the page; the element may stand inside groups that have transforms of their own. */
  movable(drawing, node) {
    const group = matrixWithin(drawing, node, false);
    return {node, group, inverse: group.inverse(), own: node.getAttribute('transform') || '', shown: ''};
  }

  outline(body) {
    const shape = svg('g', {class: 'body-outline', fill: '#a1887f', 'fill-opacity': 0.8, stroke: '#5d4037', 'stroke-width': 3, display: 'none'},
      ...body.outlines.map((ring) => svg('polygon', {points: ring.map((point) => point.join(',')).join(' ')})));
    this.layer.root.append(shape);
    this.bodies.set(body.id, {node: shape, group: new DOMMatrix(), inverse: new DOMMatrix(), own: '', shown: '', ghost: true});
  }

  /** Puts a body where it is; null = at its drawn place. */
  place(id, pose) {
    const body = this.bodies.get(id);
    if (!body) {
      return;
    }
    const text = pose ? `${pose.x} ${pose.y} ${pose.heading}` : '';
    if (text === body.shown) {
      return;
    }
    body.shown = text;
    body.node.setAttribute('data-displacement', text);
    if (body.ghost) {
      body.node.setAttribute('display', pose ? 'inline' : 'none');
    }
    if (pose) {
      const moved = new DOMMatrix().translate(pose.x, pose.y).rotate(pose.heading);
      const m = body.inverse.multiply(moved).multiply(body.group);
      body.node.setAttribute('transform', `${matrixText(m)} ${body.own}`);
    } else if (body.own) {
      body.node.setAttribute('transform', body.own);
    } else {
      body.node.removeAttribute('transform');
    }
  }

  hide(id, hidden) {
    const body = this.bodies.get(id);
    if (body) {
      body.node.style.visibility = hidden ? 'hidden' : '';
    }
  }
}

/** Parts of a claw's drawing that lie on one side of its middle, with the jaw that moves them. */
function jawParts(container, claw, node) {
  const parts = node.children.length > 0 ? [...node.children] : [node];
  return parts.filter((part) => part.getBBox).flatMap((part) => {
    const box = part.getBBox();
    const toRobot = matrixWithin(container, part, true);
    const offsets = [0, 1, 2, 3].map((i) => new DOMPoint(box.x + (i & 1) * box.width, box.y + (i >> 1) * box.height)
      .matrixTransform(toRobot).y - claw.pivot[1]);
    const side = offsets.every((y) => y <= 0.01) ? -1 : offsets.every((y) => y >= -0.01) ? 1 : 0;
    const jaw = claw.jaws.find((one) => one.side === side);
    const group = matrixWithin(container, part, false);
    return jaw && box.width > 0 ? [{jaw, node: part, group, inverse: group.inverse(), own: part.getAttribute('transform') || ''}] : [];
  });
}

/** A robot's drawing at a pose, turrets and jaws moved by their motors; its collision outline if the drawing cannot be shown. */
class RobotDrawing {
  constructor(stage, bounds, robot) {
    this.layer = new Layer(stage, bounds, 'robot');
    this.robot = robot;
    this.group = svg('g', {'data-robot-name': robot.name});
    this.layer.root.append(this.group);
    const drawing = robot.scene ? parseDrawing(robot.scene.svg) : null;
    this.turrets = [];
    this.claws = [];
    if (drawing) {
      const named = namedElements(drawing, robot.scene.svg);
      disarm(drawing);
      const container = svg('g', {}, ...drawing.childNodes);
      this.group.append(container);
      this.turrets = robot.scene.turrets.filter((turret) => named.has(turret.id)).map((turret) => {
        const node = named.get(turret.id);
        return {...turret, node, own: node.getAttribute('transform') || '', motor: robot.motors.find((motor) => motor.port === turret.port)};
      });
      this.claws = robot.scene.claws.filter((claw) => named.has(claw.id)).map((claw) => ({...claw,
        parts: jawParts(container, claw, named.get(claw.id)), motor: robot.motors.find((motor) => motor.port === claw.port)}));
    } else if (robot.scene) {
      this.group.append(svg('g', {fill: '#cfd6dd', stroke: '#3c434b', 'stroke-width': 3},
        ...robot.scene.outlines.map((ring) => svg('polygon', {points: ring.map((point) => point.join(',')).join(' ')}))));
    }
  }

  show(pose, sample) {
    this.place(pose);
    for (const turret of this.turrets) {
      const tacho = turret.motor ? turret.motor.tacho[sample] : NaN;
      this.turn(turret, Number.isFinite(tacho) ? tacho * turret.ratio : 0);
    }
    for (const claw of this.claws) {
      this.close(claw, claw.motor ? claw.motor.tacho[sample] : NaN);
    }
  }

  place(pose) {
    this.group.setAttribute('transform', `translate(${pose.x.toFixed(2)} ${pose.y.toFixed(2)}) rotate(${pose.heading.toFixed(3)})`);
  }

  turn(turret, degrees) {
    turret.node.setAttribute('transform', `rotate(${degrees} ${turret.pivot.join(' ')}) ${turret.own}`);
  }

  /** Shows a claw as far closed as its motor has turned. */
  close(claw, degrees) {
    const closed = Number.isFinite(degrees) ? Math.max(0, Math.min(1, (degrees - claw.open) / (claw.closed - claw.open))) : 0;
    for (const part of claw.parts) {
      const [x, y] = part.jaw.hinge;
      const swung = new DOMMatrix().translate(x, y).rotate(closed * part.jaw.degrees).translate(-x, -y);
      part.node.setAttribute('transform', `${matrixText(part.inverse.multiply(swung).multiply(part.group))} ${part.own}`);
    }
  }
}
