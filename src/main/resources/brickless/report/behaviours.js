// Arbitration over time: who wanted control, who had it, who was told to give way and how long that took.

/** An action that went on longer than this after it was told to stop ignored suppress(). */
const SLOW_SECONDS = 1;

/** a.b.Robot$Cruise → Cruise; a.b.Robot$1, which has no name of its own → Robot$1 */
function simpleName(className) {
  return className.replace(/^.*[.$](?=[^\d.$][^.$]*$|[^.$]+\$\d+$)/, '');
}

class Arbitration {
  /** Every arbitrator that a robot's program made. */
  static all(robot, end) {
    return robot.events.filter((event) => event.type === 'arbitrator').map((event) => new Arbitration(robot, event, end));
  }

  constructor(robot, created, end) {
    this.robot = robot;
    this.number = created.arbitrator;
    this.names = created.behaviours.map(simpleName);
    this.active = [];
    this.wanted = [];
    this.givings = [];
    this.read(robot.events.filter((event) => event.arbitrator === this.number && event.type !== 'arbitrator'), end);
  }

  read(events, end) {
    let active = null;
    let wanted = null;
    let giving = null;
    const finish = (span, time, list) => {
      if (span) {
        span.to = time;
        list.push(span);
      }
    };
    for (const event of events) {
      const span = event.behaviour < 0 ? null : {behaviour: event.behaviour, from: event.t, to: end};
      if (event.type === 'wants') {
        finish(wanted, event.t, this.wanted);
        wanted = span;
      } else if (event.type === 'active') {
        finish(active, event.t, this.active);
        finish(giving, event.t, this.givings);
        active = span;
        giving = null;
      } else if (event.type === 'suppressed') {
        finish(giving, event.t, this.givings);
        giving = span && {...span, by: wanted ? wanted.behaviour : -1};
      }
    }
    const open = (span, list) => span && list.push(Object.assign(span, {to: end, endless: true}));
    open(wanted, this.wanted);
    open(active, this.active);
    open(giving, this.givings);
    this.givings.forEach((one) => {
      one.slow = one.to - one.from > SLOW_SECONDS;
    });
  }

  static spanAt(spans, time) {
    const span = spans[lastNotAfter(spans, time + 1e-9, (one) => one.from)];
    return span && (time < span.to || span.endless) ? span : null;
  }

  /** Spans that hold at a time, each null if there is none. */
  at(time) {
    return {
      active: Arbitration.spanAt(this.active, time),
      wanted: Arbitration.spanAt(this.wanted, time),
      giving: Arbitration.spanAt(this.givings, time),
    };
  }

  /** Figures of one behaviour over the whole run. */
  totals(behaviour) {
    const active = this.active.filter((span) => span.behaviour === behaviour);
    const givings = this.givings.filter((span) => span.behaviour === behaviour);
    return {
      times: active.length,
      seconds: active.reduce((sum, span) => sum + span.to - span.from, 0),
      slowest: givings.reduce((most, span) => Math.max(most, span.to - span.from), 0),
      slow: givings.some((span) => span.slow),
    };
  }
}
