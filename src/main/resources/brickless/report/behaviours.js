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
    return robot.log.ofType('arbitrator').map((event) => new Arbitration(robot, event, end));
  }

  constructor(robot, created, end) {
    this.robot = robot;
    this.number = created.arbitrator;
    this.names = created.behaviours.map(simpleName);
    this.active = [];
    this.wanted = [];
    this.givings = [];
    this.open = {active: null, wanted: null, giving: null};
    robot.log.all.filter((event) => event.arbitrator === this.number && event.type !== 'arbitrator').forEach((event) => this.add(event));
    this.extend(end);
  }

  /** Takes the next event of this arbitrator. */
  add(event) {
    const span = event.behaviour < 0 ? null : {behaviour: event.behaviour, from: event.t, to: event.t, endless: true};
    if (event.type === 'wants') {
      this.turn('wanted', this.wanted, span, event.t);
    } else if (event.type === 'active') {
      this.turn('active', this.active, span, event.t);
      this.turn('giving', this.givings, null, event.t);
    } else if (event.type === 'suppressed') {
      this.turn('giving', this.givings, span && {...span, by: this.open.wanted ? this.open.wanted.behaviour : -1}, event.t);
    }
  }

  /** Ends the span that was open and begins the next. */
  turn(kind, list, span, time) {
    const last = this.open[kind];
    if (last) {
      Object.assign(last, {to: time, endless: false, slow: kind === 'giving' && time - last.from > SLOW_SECONDS});
    }
    this.open[kind] = span;
    if (span) {
      list.push(span);
    }
  }

  /** Lets what is still going on last until a time. */
  extend(time) {
    for (const [kind, span] of Object.entries(this.open)) {
      if (span) {
        Object.assign(span, {to: Math.max(span.from, time), slow: kind === 'giving' && time - span.from > SLOW_SECONDS});
      }
    }
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
