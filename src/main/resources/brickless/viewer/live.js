// Puts the live view together: what the server tells goes to the views, what a person does goes to the server.

const BRICK_KEYS = {ArrowUp: 'UP', ArrowDown: 'DOWN', ArrowLeft: 'LEFT', ArrowRight: 'RIGHT', Enter: 'ENTER', Escape: 'ESCAPE', Backspace: 'ESCAPE'};

function panel(id) {
  return document.getElementById(id);
}

class LiveView {
  constructor() {
    this.notices = new Notices(panel('notices'));
    this.group = new LiveGroup();
    this.chosenPlots = new Map();
    this.loudspeaker = new Loudspeaker(false);
    this.link = new Link({
      begin: (data) => this.begin(data),
      sample: (line) => this.sample(line),
      events: ({events}) => this.happened(events),
      frame: (frame) => this.frame(frame),
      state: (state) => this.state(state),
      lost: () => this.lost(),
      refused: (sentence, action) => this.refused(sentence, action),
    });
    this.holds = new Holds(this.link);
    this.tools = new Tools(panel('tools'), this.link, (what, down) => this.press(what, down));
    this.controls = new Controls(panel('top'), this.link, this.loudspeaker, this.tools, this.group);
    this.keyboard();
    // A button that was clicked leaves the keyboard to the brick.
    document.addEventListener('mousedown', (event) => event.target.closest('button, a') && event.preventDefault());
    let pointed = false;
    document.addEventListener('pointerdown', () => {
      pointed = true;
    }, {capture: true});
    document.addEventListener('keydown', () => {
      pointed = false;
    }, {capture: true});
    document.addEventListener('change', (event) => pointed && event.target.blur());
  }

  /** A run from its beginning until now: at first, after a restart, after a lost connection. */
  begin(data) {
    const chosen = this.robot ? this.robot.name : null;
    this.recording = new LiveRecording({...data.recording, scene: data.scene, header: data.header, summary: null});
    this.robot = this.recording.robot(chosen) || this.recording.robots[0];
    this.pendingFrame = null;
    this.time = 0;
    this.plotted = -1;
    this.holds.forget();
    this.holds.viewer = data.viewer || 0;
    this.notices.hide('lost');
    if (this.hands) {
      this.hands.close();
    }
    for (const id of ['arena', 'lists']) {
      panel(id).replaceChildren();
    }
    this.arena = new LiveArena(panel('arena'), this.recording);
    this.hands = new Hands(this.arena, this.link, this.holds, (name) => this.choose(name));
    this.lists = new LiveLists(panel('lists'), this.recording);
    this.controls.begin(data);
    this.robotPanels();
    document.body.dataset.state = 'ready';
    document.body.dataset.link = 'up';
    document.body.dataset.session = data.session;
    panel('loading').hidden = true;
    this.group.redraw();
  }

  /** Brick, behaviours and plots of the chosen robot. */
  robotPanels() {
    const {recording, robot} = this;
    for (const id of ['brick', 'timeline', 'plots']) {
      panel(id).replaceChildren();
    }
    this.group.rows = [];
    if (recording.robots.length > 1) {
      const choice = html('select', {class: 'speed robot-choice', 'aria-label': 'Robot', on: {change: () => this.choose(recording.robots[choice.selectedIndex].name)}},
        ...recording.robots.map((one) => html('option', {selected: one === robot}, one.name)));
      panel('brick').append(choice);
    }
    this.arena.chosen = robot;
    this.tools.choose(robot, robot === recording.robots[0]);
    this.brick = new LiveBrick(panel('brick'), recording, robot, (what, down) => this.press(what, down));
    this.timelinePanel();
    this.plots = new LivePlots(panel('plots'), recording, robot, this.group, this.chosenPlots);
    this.schedule();
  }

  timelinePanel() {
    const arbitrations = this.recording.arbitrations.filter((one) => one.robot === this.robot);
    this.timeline = arbitrations.length > 0 ? new Timeline(panel('timeline'), arbitrations, this.group) : null;
    if (!this.timeline) {
      panel('timeline').append(html('div', {class: 'panel-head'}, html('h2', {}, 'Behaviours')),
        html('p', {class: 'timeline-empty'}, 'The program has not started an Arbitrator.'));
    }
  }

  choose(name) {
    if (this.robot.name !== name) {
      this.holds.releaseAll();
      this.robot = this.recording.robot(name);
      this.robotPanels();
    }
  }

  press(what, down) {
    this.holds[down ? 'press' : 'release'](this.robot.name, what);
  }

  sample(line) {
    if (this.recording.sample(line) || !this.plots.grow()) {
      this.robotPanels();
    }
    this.schedule();
  }

  happened(events) {
    const added = events.map((event) => this.recording.happened(event)).includes(true);
    this.lists.happened(events);
    events.filter((event) => event.type === 'stimulus').forEach((event) => this.arena.touched(event.do));
    const {speed, rate} = this.controls.state;
    this.loudspeaker.play(events.filter((event) => event.type === 'sound' && event.robot === this.robot.name), speed === 'max' ? Math.max(1, rate) : speed);
    if (added) {
      this.robotPanels();
    }
    this.schedule();
  }

  frame(frame) {
    this.pendingFrame = frame;
    this.holds.tick(frame.t);
    this.schedule();
  }

  state(state) {
    this.controls.show(state);
    this.hands.running = state.running && !state.ended;
    document.body.dataset.run = state.ended ? 'ended' : state.running ? 'running' : 'paused';
    const restart = [['Restart', () => this.controls.again()]];
    const notice = (kind, tone, text, actions) => (text ? this.notices.show(kind, tone, text, actions) : this.notices.hide(kind));
    const names = state.changed.map((path) => path.slice(path.lastIndexOf('/') + 1)).join(', ');
    notice('changed', 'info', names && `${names} changed on disk.`, restart);
    notice('message', 'bad', state.message, restart);
    notice('error', 'bad', state.ended && state.ended.error, restart);
    this.schedule();
  }

  /** A failed restart tells why in the state, to all viewers. */
  refused(sentence, action) {
    if (action.do !== 'restart') {
      this.notices.flash(sentence);
    }
  }

  lost() {
    document.body.dataset.link = 'lost';
    this.holds.forget();
    this.loudspeaker.hush();
    if (!this.recording) {
      setText(panel('loading'), 'The run does not answer; trying again …');
    } else {
      this.notices.show('lost', 'bad', 'The connection to the run is lost; trying again …');
    }
  }

  /** Draws once per refresh of the screen at most, and only if there is something new. */
  schedule() {
    if (!this.scheduled) {
      this.scheduled = true;
      requestAnimationFrame(() => {
        this.scheduled = false;
        this.draw();
      });
    }
  }

  draw() {
    const frame = this.pendingFrame;
    if (frame) {
      this.pendingFrame = null;
      this.time = frame.t;
      this.arena.place(frame);
      this.hands.show();
      this.controls.time(frame.t);
    }
    const time = Math.max(this.time || 0, this.recording.duration);
    this.brick.show(time);
    const {times} = this.recording;
    if (times.length !== this.plotted) {
      this.plotted = times.length;
      this.brick.plot();
      this.plots.show(time);
      this.tools.show(this.robot.volts[times.length - 1]);
      if (this.timeline) {
        this.timeline.lanes.filter((lane) => !lane.now).forEach((lane) => this.timeline.total(lane));
      }
    }
    if (this.timeline) {
      this.timeline.show(time);
    }
    this.group.show(time);
  }

  /** Keys of the keyboard that are keys of the brick, unless something else has the focus and wants them. */
  keyboard() {
    const keyOf = (event) => (event.ctrlKey || event.metaKey || event.altKey || inField(event) ? null : BRICK_KEYS[event.key]);
    const held = new Map();
    document.addEventListener('keydown', (event) => {
      const key = event.key === 'Enter' && event.target.closest('button, a') ? null : keyOf(event);
      if (key && this.recording) {
        event.preventDefault();
        if (!event.repeat) {
          held.set(event.code, key);
          this.press(`key ${key}`, true);
        }
      }
    });
    document.addEventListener('keyup', (event) => {
      if (held.has(event.code)) {
        this.press(`key ${held.get(event.code)}`, false);
        held.delete(event.code);
      }
    });
  }
}

new LiveView();
