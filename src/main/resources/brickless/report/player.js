// Time of the replay. Views register and are told to show a time; a live viewer can drive the same views with the present time.

class Player {
  constructor(duration) {
    this.duration = duration;
    this.time = 0;
    this.speed = 1;
    this.playing = false;
    this.views = [];
    this.stateListeners = [];
  }

  /** Adds something with a method show(time). */
  add(view) {
    this.views.push(view);
  }

  onState(listener) {
    this.stateListeners.push(listener);
  }

  seek(time) {
    this.time = Math.min(this.duration, Math.max(0, time));
    this.show();
  }

  show() {
    for (const view of this.views) {
      view.show(this.time);
    }
  }

  setSpeed(speed) {
    this.speed = speed;
    this.changed();
  }

  toggle() {
    if (this.playing) {
      this.pause();
    } else {
      this.play();
    }
  }

  play() {
    if (this.time >= this.duration) {
      this.time = 0;
    }
    this.playing = true;
    this.last = null;
    requestAnimationFrame((now) => this.frame(now));
    this.changed();
  }

  pause() {
    this.playing = false;
    this.changed();
  }

  changed() {
    this.stateListeners.forEach((listener) => listener());
  }

  frame(now) {
    if (!this.playing) {
      return;
    }
    const passed = this.last === null ? 0 : Math.min(0.25, (now - this.last) / 1000);
    this.last = now;
    this.seek(this.time + passed * this.speed);
    if (this.time >= this.duration) {
      this.pause();
    } else {
      requestAnimationFrame((next) => this.frame(next));
    }
  }
}
