// What sensors see, drawn over the arena: beams of distance sensors, the spot below the colour sensor.

class Sensing {
  constructor(root) {
    this.root = root;
    this.shown = new Map();
  }

  /** Shows beams and spots of a frame; lengths in metres. */
  show(robots) {
    const seen = new Set();
    for (const robot of robots) {
      (robot.beams || []).forEach((beam) => seen.add(this.beam(robot.name, beam)));
      (robot.spots || []).forEach((spot) => seen.add(this.spot(robot.name, spot)));
    }
    for (const [key, node] of this.shown) {
      node.setAttribute('visibility', seen.has(key) ? 'visible' : 'hidden');
    }
  }

  node(key, make) {
    if (!this.shown.has(key)) {
      const node = make();
      this.root.append(node);
      this.shown.set(key, node);
    }
    return this.shown.get(key);
  }

  beam(robot, {port, kind, from, rays, metres}) {
    const key = `beam ${robot} ${port}`;
    const colour = kind.includes('infrared') ? 'var(--infrared)' : 'var(--ultrasonic)';
    const group = this.node(key, () => svg('g', {'data-beam': `${robot} ${port}`}, svg('path', {fill: colour, stroke: 'none', class: 'beam-field'}),
      svg('path', {fill: 'none', stroke: colour, class: 'beam-rays'})));
    const point = ([x, y]) => `${(x * 1000).toFixed(1)},${(y * 1000).toFixed(1)}`;
    const start = point(from);
    const ends = rays.map(point);
    group.firstChild.setAttribute('d', `M${start}L${ends.join('L')}Z`);
    group.lastChild.setAttribute('d', ends.map((end) => `M${start}L${end}`).join(''));
    group.classList.toggle('echo', metres !== null);
    group.dataset.metres = metres === null ? '' : metres;
    return key;
  }

  spot(robot, {port, at, radius, rgb}) {
    const key = `spot ${robot} ${port}`;
    const circle = this.node(key, () => svg('circle', {'data-spot': `${robot} ${port}`, class: 'spot'}));
    fill(circle, {cx: (at[0] * 1000).toFixed(1), cy: (at[1] * 1000).toFixed(1), r: Math.max(9, radius * 1000).toFixed(1)}, []);
    circle.style.fill = rgb ? `rgb(${rgb.map((part) => Math.round(part)).join(' ')})` : 'transparent';
    return key;
  }
}
