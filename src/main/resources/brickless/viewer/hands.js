// Hands in the arena: robots and movable things are dragged, turned and taken away, touch sensors held.

/** Places of what is dragged are sent no more often than this. */
const MOVE_MILLIS = 100;

class Hands {
  constructor(arena, link, holds, onChoose) {
    this.arena = arena;
    this.link = link;
    this.holds = holds;
    this.onChoose = onChoose;
    this.running = true;
    this.next = new Map();
    this.plane = arena.plane('handles');
    const {scene} = arena.recording;
    this.bodies = scene.bodies.filter((body) => !arena.removed.has(body.id)).map((body) => new Handle(this, body.id, body.outlines, centroid(body.outlines), true));
    this.robots = arena.recording.robots.filter((robot) => robot.scene)
      .map((robot) => new Handle(this, robot.name, robot.scene.outlines, {x: 0, y: 0}, false));
    this.handles = [...this.bodies, ...this.robots];
    this.plane.append(...this.handles.map((handle) => handle.node));
    this.robots.forEach((handle) => this.touchSensors(handle));
    arena.stage.addEventListener('pointerdown', () => this.choose(null));
    this.sizes = new ResizeObserver(() => this.scale());
    this.sizes.observe(arena.stage);
  }

  scale() {
    const width = this.arena.stage.clientWidth;
    this.handles.forEach((handle) => handle.scale(width > 0 ? this.arena.recording.scene.bounds[2] / width : 1));
  }

  /** Where touch sensors are drawn they can be held. */
  touchSensors(handle) {
    const {group} = this.arena.drawings[this.arena.recording.robots.findIndex((robot) => robot.name === handle.name)];
    for (const drawn of group.querySelectorAll('[data-sensor$="-touch"]')) {
      const port = drawn.getAttribute('data-port');
      const copy = drawn.cloneNode(true);
      [copy, ...copy.querySelectorAll('*')].forEach((node) => ['id', 'class', 'style', 'fill', 'stroke', 'transform'].forEach((name) => node.removeAttribute(name)));
      const target = svg('g', {class: 'touch-sensor', transform: matrixText(matrixWithin(group, drawn, true)), 'data-port': port}, svg('title'), copy);
      target.firstChild.textContent = `Touch sensor ${port}: hold to press it`;
      holdable(target, () => this.holds.press(handle.name, `push ${port}`), () => this.holds.release(handle.name, `push ${port}`));
      handle.shape.append(target);
    }
  }

  /** Place in the drawing that an event points at, millimetres. */
  point(event) {
    const box = this.arena.stage.getBoundingClientRect();
    const [x, y, width, height] = this.arena.recording.scene.bounds;
    return {x: x + (event.clientX - box.left) / box.width * width, y: y + (event.clientY - box.top) / box.height * height};
  }

  choose(handle) {
    if (this.chosen !== handle) {
      this.chosen = handle;
      this.handles.forEach((one) => one.node.classList.toggle('chosen', one === handle));
      this.handles.filter((one) => one !== handle).forEach((one) => one.node.blur());
      if (handle && !handle.removable) {
        this.onChoose(handle.name);
      }
    }
  }

  touch(stimulus) {
    return this.link.send({do: 'touch', stimulus});
  }

  /** Sends where a thing was put, at most ten times a second, the newest place only. */
  move(handle) {
    const stimulus = handle.stimulus();
    if (stimulus !== handle.sent) {
      handle.sent = stimulus;
      this.next.set(handle.name, stimulus);
    }
    this.sending = this.sending || this.sendMoves().finally(() => {
      this.sending = null;
    });
    return this.sending;
  }

  async sendMoves() {
    while (this.next.size > 0) {
      const moves = [...this.next.values()];
      this.next.clear();
      await Promise.all([...moves.map((move) => this.touch(move)), new Promise((done) => setTimeout(done, MOVE_MILLIS))]);
    }
  }

  /** Handles follow what they hold. */
  show() {
    for (const handle of this.robots) {
      const pose = this.arena.poses.get(handle.name);
      if (pose) {
        handle.follow(pose);
      }
    }
    for (const handle of this.bodies) {
      const moved = this.arena.displacements.get(handle.name) || {x: 0, y: 0, heading: 0};
      const radians = moved.heading * Math.PI / 180;
      const {x, y} = handle.middle;
      handle.follow({x: moved.x + x * Math.cos(radians) - y * Math.sin(radians), y: moved.y + x * Math.sin(radians) + y * Math.cos(radians), heading: moved.heading});
      handle.node.style.display = this.arena.removed.has(handle.name) ? 'none' : '';
    }
  }

  close() {
    this.sizes.disconnect();
  }
}
