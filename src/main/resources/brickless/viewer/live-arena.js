// The arena now: robots and movable things where they are, the way driven so far, what sensors see.

/** Points in one piece of the path; only the last piece changes while the robot drives. */
const PIECE_POINTS = 150;

/** The way of one robot as it gets longer. */
class GrowingPath {
  constructor(root, robot, colour) {
    this.group = svg('g', {fill: 'none', stroke: colour, 'stroke-width': 8, 'stroke-linejoin': 'round', 'stroke-linecap': 'round', opacity: 0.75});
    root.append(this.group);
    this.last = null;
    this.points = [];
    const {track} = robot;
    const lifts = robot.log.ofType('stimulus').filter((event) => event.do.startsWith(`move ${robot.name} `)).map((event) => event.t);
    for (let i = 0; i < track.times.length; i++) {
      if (lifts.length > 0 && lifts[0] <= track.times[i]) {
        lifts.shift();
        this.lift();
      }
      if (Number.isFinite(track.x[i])) {
        this.add({x: track.x[i], y: track.y[i]});
      }
    }
  }

  /** The robot is carried: the next place begins a new line. */
  lift() {
    this.last = null;
  }

  add(point) {
    if (this.last && Math.hypot(point.x - this.last.x, point.y - this.last.y) < PATH_SPACING) {
      return;
    }
    if (!this.last || this.points.length >= PIECE_POINTS) {
      this.points = this.last ? this.points.slice(-1) : [];
      this.piece = svg('path');
      this.group.append(this.piece);
    }
    this.points.push(`${point.x.toFixed(1)},${point.y.toFixed(1)}`);
    this.last = point;
    this.piece.setAttribute('d', `M${this.points.join('L')}`);
  }
}

class LiveArena extends Arena {
  constructor(host, recording) {
    super(host, recording, (root, robot, colour) => new GrowingPath(root, robot, colour));
    this.poses = new Map();
    this.displacements = new Map();
    this.removed = new Set(this.removals.map((removal) => removal.id));
    this.removed.forEach((id) => this.world.hide(id, true));
    this.stage.setAttribute('role', 'group');
    this.stage.setAttribute('aria-label', 'Arena');
    this.sensing = new Sensing(this.plane('sensing'));
    this.labels = recording.robots.length > 1 ? this.nameRobots(this.plane('labels')) : [];
  }

  /** A plane over the drawings that the page's style reaches. */
  plane(className) {
    const plane = svg('svg', {viewBox: this.recording.scene.bounds.join(' '), class: `plane ${className}`});
    this.stage.append(plane);
    return plane;
  }

  /** Shows where everything is; lengths in metres. */
  place(frame) {
    frame.robots.forEach((one) => {
      const i = this.recording.robots.findIndex((robot) => robot.name === one.name);
      const pose = {x: one.x * 1000, y: one.y * 1000, heading: one.heading};
      this.poses.set(one.name, pose);
      this.paths[i].add(pose);
      this.drawings[i].place(pose);
      this.turn(this.drawings[i], one.parts || []);
      if (this.labels[i]) {
        this.labels[i].setAttribute('transform', `translate(${pose.x.toFixed(1)} ${pose.y.toFixed(1)})`);
      }
    });
    this.displacements = new Map(frame.bodies.map((body) => [body.id, {x: body.x * 1000, y: body.y * 1000, heading: body.heading}]));
    for (const {id} of this.recording.scene.bodies) {
      this.world.place(id, this.displacements.get(id) || null);
    }
    this.sensing.show(frame.robots);
    this.showHit(frame.t);
    this.describe(frame.t);
  }

  /** Several robots are told apart by their names in the colours of their paths. */
  nameRobots(plane) {
    const size = this.recording.scene.bounds[2] / 50;
    return this.recording.robots.map((robot, i) => {
      const label = svg('text', {class: 'robot-label', 'font-size': size, y: -size * 3.6, fill: robotColour(robot, i)});
      label.textContent = robot.name;
      plane.append(label);
      return label;
    });
  }

  turn(drawing, parts) {
    for (const turret of drawing.turrets) {
      const part = parts.find((one) => one.id === turret.id);
      if (part) {
        drawing.turn(turret, part.degrees);
      }
    }
    for (const claw of drawing.claws) {
      const part = parts.find((one) => one.id === claw.id);
      if (part) {
        drawing.close(claw, part.degrees);
      }
    }
  }

  /** Takes what a person did to the arena. */
  touched(stimulus) {
    const [what, name] = stimulus.split(' ');
    if (what === 'remove') {
      this.removed.add(name);
      this.world.hide(name, true);
    } else if (what === 'move') {
      const i = this.recording.robots.findIndex((robot) => robot.name === name);
      if (i >= 0) {
        this.paths[i].lift();
      }
    }
  }

  describe() {
    const pose = this.chosen && this.poses.get(this.chosen.name);
    const name = this.recording.robots.length > 1 && this.chosen ? `${this.chosen.name} ` : '';
    setText(this.caption, pose ? `${name}${number(pose.x)}, ${number(pose.y)} mm, ${number(((pose.heading % 360) + 540) % 360 - 180)}°` : '');
  }

  poseOf(robot) {
    return this.poses.get(robot.name);
  }
}
