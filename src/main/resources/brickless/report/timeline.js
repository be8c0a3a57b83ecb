// Who wanted control, who had it, who was told to give way, and how long that took.

const LANE_HEIGHT = 30;

class Timeline {
  constructor(host, arbitrations, group) {
    this.group = group;
    this.lanes = [];
    const legend = html('div', {class: 'legend'},
      ...[['active', 'in control'], ['wants', 'wants control'], ['giving', 'told to give way'], ['slow', `still going after ${SLOW_SECONDS} s`]]
        .map(([kind, text]) => html('span', {class: 'legend-item'}, html('span', {class: `legend-mark ${kind}`}), text)));
    host.append(html('div', {class: 'panel-head'}, html('h2', {}, 'Behaviours'), legend));
    arbitrations.forEach((arbitration, i) => this.arbitrator(host, arbitration, arbitrations.length > 1 ? i : -1));
    const axis = new TimeAxis(group.window);
    group.add(axis.row, (context, width, height) => axis.draw(context, width, height));
    host.append(html('div', {class: 'tracks'}, axis.row.node));
  }

  arbitrator(host, arbitration, index) {
    const body = html('div', {class: 'tracks lanes'});
    if (index >= 0) {
      host.append(html('h3', {}, `${arbitration.robot.name}, arbitrator ${arbitration.number + 1}`));
    }
    const readout = html('p', {class: 'timeline-now', 'data-part': 'behaviour-now'});
    for (let behaviour = arbitration.names.length - 1; behaviour >= 0; behaviour--) {
      body.append(this.lane(arbitration, behaviour).row.node);
    }
    host.append(body, readout);
    this.lanes.push({arbitration, readout, now: true});
  }

  lane(arbitration, behaviour) {
    const name = arbitration.names[behaviour];
    const colour = `--behaviour-${behaviour % 8}`;
    const swatch = html('span', {class: 'swatch'});
    swatch.style.background = `var(${colour})`;
    const label = html('div', {class: 'track-label one-line', title: name}, swatch, html('strong', {}, name));
    const readout = html('div', {class: 'track-readout'});
    const row = new TrackRow(LANE_HEIGHT, label, readout, name);
    row.node.classList.add('lane');
    row.node.dataset.behaviour = name;
    this.group.add(row, (context, width, height) => this.draw(arbitration, behaviour, colour, context, width, height));
    const lane = {arbitration, behaviour, row, readout};
    this.lanes.push(lane);
    this.total(lane);
    return lane;
  }

  /** Figures of a lane. */
  total({arbitration, behaviour, row, readout}) {
    const totals = arbitration.totals(behaviour);
    readout.classList.toggle('slow', totals.slow);
    readout.replaceChildren(
      html('div', {class: 'reading'}, html('span', {class: 'value'}, totals.times > 0 ? `${totals.times} × · ${period(totals.seconds)}` : 'never')),
      ...(totals.slowest > 0 ? [html('div', {class: 'reading sub'}, `gave way ≤ ${period(totals.slowest)}`)] : []));
    row.canvas.setAttribute('aria-label', `${arbitration.names[behaviour]}: in control ${totals.times} times for ${period(totals.seconds)} altogether`
      + `${totals.slow ? ', ignored suppress' : ''}`);
  }

  draw(arbitration, behaviour, colour, context, width, height) {
    gridLines(context, this.group.window, width, height);
    const bar = (spans, top, thick, paint) => this.spans(spans, behaviour, width, (x, w, span) => {
      context.fillStyle = paint(span);
      context.fillRect(x, top, w, thick);
    });
    const plain = themeColour(colour);
    bar(arbitration.wanted, 3, 4, () => plain);
    bar(arbitration.active, 9, height - 12, () => plain);
    this.spans(arbitration.givings, behaviour, width, (x, w, span) => this.giving(context, x, w, 9, height - 12, span));
  }

  /** The stretch from being told to stop to having stopped; what goes beyond the limit is red. */
  giving(context, x, w, top, thick, span) {
    context.fillStyle = themeColour('--amber');
    context.fillRect(x, top, w, thick);
    if (span.slow) {
      const limit = SLOW_SECONDS / (span.to - span.from) * w;
      context.fillStyle = themeColour('--bad');
      context.fillRect(x + limit, top, Math.max(2, w - limit), thick);
      if (w - limit > 58) {
        context.fillStyle = '#fff';
        context.font = '600 11px system-ui, sans-serif';
        context.textAlign = 'left';
        context.textBaseline = 'middle';
        context.fillText(period(span.to - span.from), x + limit + 6, top + thick / 2 + 0.5);
      }
    }
  }

  spans(spans, behaviour, width, paint) {
    const {from, to, span: length} = this.group.window;
    for (let i = Math.max(0, lastNotAfter(spans, from, (one) => one.from)); i < spans.length && spans[i].from <= to; i++) {
      const span = spans[i];
      if (span.behaviour === behaviour && span.to >= from) {
        const x = (Math.max(from, span.from) - from) / length * width;
        paint(x, Math.max(1, (Math.min(to, span.to) - from) / length * width - x), span);
      }
    }
  }

  show(time) {
    for (const lane of this.lanes) {
      const now = lane.arbitration.at(time);
      if (lane.now) {
        setText(lane.readout, this.sentence(lane.arbitration, now, time));
        lane.readout.classList.toggle('slow', Boolean(now.giving && time - now.giving.from > SLOW_SECONDS));
      } else {
        const active = Boolean(now.active && now.active.behaviour === lane.behaviour);
        lane.row.node.dataset.active = String(active);
        lane.row.node.classList.toggle('on', active);
      }
    }
  }

  sentence(arbitration, {active, wanted, giving}, time) {
    const name = (span) => arbitration.names[span.behaviour];
    const parts = [active ? `${name(active)} has been in control for ${period(time - active.from)}` : 'Nobody is in control'];
    if (giving) {
      parts.push(`told to give way ${period(time - giving.from)} ago, ${giving.endless ? 'and never did' : `does after ${period(giving.to - giving.from)}`}`);
    } else if (wanted && (!active || wanted.behaviour !== active.behaviour)) {
      parts.push(`${name(wanted)} wants control`);
    }
    return `${parts.join('; ')}.`;
  }
}
