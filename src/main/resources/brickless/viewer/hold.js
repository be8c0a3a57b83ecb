// Pressing and holding: with a mouse, a finger or the keyboard, let go of at the latest when the page is left.

/** Even the shortest tap lasts so long in the robot's time, as one by a finger does; simulated seconds. */
const LEAST_HELD = 0.1;

class Holds {
  constructor(link) {
    this.link = link;
    this.held = new Map();
    this.viewer = 0;
    this.time = 0;
    globalThis.addEventListener('blur', () => this.releaseAll());
    globalThis.addEventListener('pagehide', () => this.releaseAll());
    document.addEventListener('visibilitychange', () => document.hidden && this.releaseAll());
  }

  press(robot, what) {
    const key = `${robot} ${what}`;
    const held = this.held.get(key);
    if (held && held.over) {
      this.letGo(key);
    }
    if (!this.held.has(key)) {
      const begun = {robot, what, since: Infinity, known: false, over: false};
      this.held.set(key, begun);
      this.send(robot, what, true).then(() => {
        begun.known = true;
      });
    }
  }

  release(robot, what) {
    const held = this.held.get(`${robot} ${what}`);
    if (held) {
      held.over = true;
    }
  }

  /** Lets go of what nobody holds any more and has been held for long enough. */
  tick(time) {
    this.time = time;
    for (const [key, held] of this.held) {
      if (held.known && held.since === Infinity) {
        held.since = time;
      }
      if (held.over && time - held.since >= LEAST_HELD) {
        this.letGo(key);
      }
    }
  }

  letGo(key) {
    const {robot, what} = this.held.get(key);
    this.held.delete(key);
    this.send(robot, what, false);
  }

  send(robot, what, down) {
    return this.link.send({do: 'hold', robot, what, down, viewer: this.viewer});
  }

  releaseAll() {
    for (const {robot, what} of [...this.held.values()]) {
      this.release(robot, what);
    }
    document.querySelectorAll('.held').forEach((node) => node.dispatchEvent(new Event('letgo')));
  }

  /** Forgets what is held: the run has begun anew. */
  forget() {
    this.held.clear();
    this.time = 0;
    document.querySelectorAll('.held').forEach((node) => node.dispatchEvent(new Event('letgo')));
  }
}

/** Makes an element one that is held: `down` and `up` are called once each, whatever it is held with. */
function holdable(node, down, up) {
  const press = () => {
    if (!node.classList.contains('held')) {
      node.classList.add('held');
      down();
    }
  };
  const release = () => {
    if (node.classList.contains('held')) {
      node.classList.remove('held');
      up();
    }
  };
  const byKey = (event) => (event.key === ' ' || event.key === 'Enter') && !event.ctrlKey && !event.metaKey && !event.altKey;
  node.addEventListener('pointerdown', (event) => {
    if (event.button === 0) {
      event.preventDefault();
      event.stopPropagation();
      node.setPointerCapture(event.pointerId);
      press();
    }
  });
  for (const type of ['pointerup', 'pointercancel', 'lostpointercapture', 'blur', 'letgo']) {
    node.addEventListener(type, release);
  }
  node.addEventListener('contextmenu', (event) => event.preventDefault());
  node.addEventListener('keydown', (event) => {
    if (byKey(event)) {
      event.preventDefault();
      event.stopPropagation();
      press();
    }
  });
  node.addEventListener('keyup', (event) => byKey(event) && release());
}
