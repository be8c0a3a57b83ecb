// Pressing and holding: with a mouse, a finger or the keyboard, let go of at the latest when the page is left.

class Holds {
  constructor(link) {
    this.link = link;
    this.held = new Map();
    this.viewer = 0;
    globalThis.addEventListener('blur', () => this.releaseAll());
    globalThis.addEventListener('pagehide', () => this.releaseAll());
    document.addEventListener('visibilitychange', () => document.hidden && this.releaseAll());
  }

  press(robot, what) {
    const key = `${robot} ${what}`;
    if (!this.held.has(key)) {
      this.held.set(key, {robot, what});
      this.send(robot, what, true);
    }
  }

  release(robot, what) {
    if (this.held.delete(`${robot} ${what}`)) {
      this.send(robot, what, false);
    }
  }

  send(robot, what, down) {
    this.link.send({do: 'hold', robot, what, down, viewer: this.viewer});
  }

  releaseAll() {
    this.forget().forEach(({robot, what}) => this.send(robot, what, false));
    document.querySelectorAll('.held').forEach((node) => node.dispatchEvent(new Event('letgo')));
  }

  /** Forgets what is held, as when the run has begun anew. */
  forget() {
    const all = [...this.held.values()];
    this.held.clear();
    return all;
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
