// The arena as drawn, with robots and movable bodies where they were.

const ROBOT_COLOURS = ['var(--robot-1)', 'var(--robot-2)', 'var(--robot-3)', 'var(--robot-4)'];
/** Robots that are named after a colour have it. */
const NAMED_COLOURS = {blue: ROBOT_COLOURS[0], red: ROBOT_COLOURS[1], green: ROBOT_COLOURS[2]};
/** Points of the driven path closer than this are left out, millimetres. */
const PATH_SPACING = 4;

/** The way of one robot: faint where it will go, strong where it has been. */
class DrivenPath {
  constructor(root, track, colour) {
    this.track = track;
    this.points = [];
    this.lengths = [];
    let length = 0;
    track.times.forEach((time, i) => {
      const point = {x: track.x[i], y: track.y[i]};
      const last = this.points[this.points.length - 1];
      const step = last ? Math.hypot(point.x - last.x, point.y - last.y) : 0;
      if (Number.isFinite(point.x) && (!last || step >= PATH_SPACING)) {
        length += step;
        this.points.push({...point, time});
        this.lengths.push(length);
      }
    });
    const d = `M${this.points.map((point) => `${point.x.toFixed(1)},${point.y.toFixed(1)}`).join('L')}`;
    const attributes = {d, fill: 'none', stroke: colour, 'stroke-width': 6, 'stroke-linejoin': 'round', 'stroke-linecap': 'round'};
    this.future = svg('path', {...attributes, opacity: 0.16});
    this.past = svg('path', {...attributes, opacity: 0.85});
    root.append(this.future, this.past);
    this.total = length;
  }

  show(time, pose) {
    const i = lastNotAfter(this.points, time, (point) => point.time);
    const last = this.points[Math.max(0, i)];
    const driven = i < 0 ? 0 : this.lengths[i] + Math.min(PATH_SPACING, Math.hypot(pose.x - last.x, pose.y - last.y));
    this.past.setAttribute('stroke-dasharray', `${driven.toFixed(1)} ${(this.total + 10).toFixed(1)}`);
    this.past.setAttribute('visibility', driven > 0 ? 'visible' : 'hidden');
  }
}

function robotColour(robot, i) {
  return NAMED_COLOURS[robot.name] || ROBOT_COLOURS[i % ROBOT_COLOURS.length];
}

class Arena {
  constructor(host, recording, pathOf = (root, robot, colour) => new DrivenPath(root, robot.track, colour)) {
    this.recording = recording;
    const [x, y, width, height] = recording.scene.bounds;
    this.stage = html('div', {class: 'stage', role: 'img'});
    this.stage.style.setProperty('--ratio', String(width / height));
    this.caption = html('p', {class: 'stage-caption'});
    host.append(html('div', {class: 'stage-frame'}, this.stage), this.caption);
    this.world = new WorldDrawing(this.stage, recording.scene);
    const overlay = new Layer(this.stage, recording.scene.bounds, 'overlay');
    overlay.root.style.pointerEvents = 'none';
    this.zones(overlay.root);
    this.paths = recording.robots.map((robot, i) => pathOf(overlay.root, robot, robotColour(robot, i)));
    this.drawings = recording.robots.map((robot) => new RobotDrawing(this.stage, recording.scene.bounds, robot));
    this.removals = recording.log.ofType('stimulus').filter((event) => event.do.startsWith('remove '))
      .map((event) => ({time: event.t, id: event.do.slice('remove '.length)}));
    this.flashes = new Layer(this.stage, recording.scene.bounds, 'flashes');
    this.flash = svg('circle', {r: Math.max(width, height) / 40, fill: 'none', stroke: '#d92d20', 'stroke-width': 6, visibility: 'hidden'});
    this.flashes.root.append(this.flash);
    this.hits = recording.log.ofType('collision');
  }

  zones(root) {
    const drawing = this.world.layer.root.querySelector('svg');
    if (!drawing) {
      return;
    }
    for (const zone of drawing.querySelectorAll('[data-zone]')) {
      if (!zone.getBBox || zone.localName === 'g') {
        continue;
      }
      const box = zone.getBBox();
      const outline = zone.cloneNode(false);
      [...outline.attributes].filter((attribute) => /^(id|class|style|fill|stroke.*|opacity|data-.*)$/.test(attribute.name))
        .forEach((attribute) => outline.removeAttribute(attribute.name));
      outline.removeAttribute('transform');
      const group = svg('g', {transform: matrixText(matrixWithin(drawing, zone, true)), fill: 'none', stroke: 'var(--zone)', 'stroke-width': 4,
        'stroke-dasharray': '14 10', opacity: 0.8}, outline);
      const label = svg('text', {x: box.x + box.width / 2, y: box.y + box.height - 14, 'text-anchor': 'middle', fill: 'var(--zone)', stroke: 'none', 'font-size': 34, 'font-weight': 600,
        'font-family': 'system-ui, sans-serif'});
      label.textContent = zone.getAttribute('data-zone');
      group.append(label);
      root.append(group);
    }
  }

  show(time) {
    const sample = this.recording.sampleAt(time);
    this.recording.robots.forEach((robot, i) => {
      const pose = robot.track.at(time);
      if (pose) {
        this.drawings[i].show(pose, sample);
        this.paths[i].show(time, pose);
      }
    });
    for (const body of this.recording.bodies) {
      this.world.place(body.id, body.track.at(time));
    }
    for (const removal of this.removals) {
      this.world.hide(removal.id, time >= removal.time);
    }
    this.showHit(time);
    this.describe(time);
  }

  /** A ring around the robot for a moment after a collision. */
  showHit(time) {
    const hit = this.hits[lastNotAfter(this.hits, time + 1e-9, (event) => event.t)];
    const age = hit ? time - hit.t : 1;
    const robot = hit && this.recording.robots.find((one) => one.name === hit.robot);
    const pose = robot && this.poseOf(robot, hit.t);
    const visible = age < 0.6 && pose;
    this.flash.setAttribute('visibility', visible ? 'visible' : 'hidden');
    if (visible) {
      fill(this.flash, {cx: pose.x, cy: pose.y, opacity: 1 - age / 0.6, r: 130 + 90 * age}, []);
    }
  }

  poseOf(robot, time) {
    return robot.track.at(time);
  }

  describe(time) {
    const words = this.recording.robots.map((robot) => {
      const pose = this.poseOf(robot, time);
      const name = this.recording.robots.length > 1 ? `${robot.name}: ` : '';
      return pose ? `${name}${number(pose.x)} mm, ${number(pose.y)} mm, ${number(((pose.heading % 360) + 540) % 360 - 180)}°` : '';
    });
    this.caption.textContent = words.join('  ·  ');
    this.stage.setAttribute('aria-label', `Arena at ${clock(time)}: ${words.join(', ')}`);
  }
}
