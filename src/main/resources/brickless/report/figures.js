// The head of the page: what ran, how it ended, and the figures.

const GOOD_OUTCOMES = ['exited', 'time-limit', 'goal-reached'];

function outcomeOf(recording) {
  const end = recording.events.find((event) => event.type === 'end');
  const outcome = end ? end.outcome : 'unknown';
  const failed = !GOOD_OUTCOMES.includes(outcome) || (outcome === 'exited' && end.exitStatus !== 0);
  const {goal, passed} = recording.summary || {};
  const missed = !failed && goal && !passed ? `, missed ${goal === 'exit' ? 'its exit' : goal.replace(':', ' ')}` : '';
  return {text: `${outcome}${outcome === 'exited' && end.exitStatus !== 0 ? ` with ${end.exitStatus}` : ''}${missed}`, failed: failed || Boolean(missed)};
}

function figure(name, value, unit) {
  return html('div', {class: 'figure'}, html('dt', {}, name), html('dd', {}, value, unit ? html('span', {class: 'unit'}, ` ${unit}`) : null));
}

class Figures {
  constructor(host, recording) {
    const {header, summary} = recording;
    const name = header.main.slice(header.main.lastIndexOf('.') + 1);
    const outcome = outcomeOf(recording);
    const setting = [`world ${header.world}`, `robot ${header.robots.join(', ')}`, `seed ${header.seed}`];
    if (header.scheduleSeed >= 0) {
      setting.push(`schedule seed ${header.scheduleSeed}`);
    }
    if (header.ideal) {
      setting.push('ideal');
    }
    const figures = html('dl', {class: 'figures'}, figure('Simulated', number(recording.duration, 1), 's'));
    if (summary) {
      figures.append(figure('Driven', number(summary.distanceMetres, 2), 'm'), figure('Collisions', String(summary.collisions)));
      if (summary.zones.length > 0) {
        figures.append(figure('Zones', summary.zones.join(', ')));
      }
      figures.append(figure('Trace', html('code', {title: `SHA-256 ${summary.traceHash}`}, summary.traceHash.slice(0, 8))));
    }
    host.append(html('div', {class: 'what'}, html('h1', {title: header.main}, name), html('p', {class: 'setting'}, setting.join(' · '))),
      html('span', {class: outcome.failed ? 'outcome bad' : 'outcome good'}, outcome.text), figures);
    if (summary && summary.error) {
      const [first, ...rest] = summary.error.split('\n');
      host.after(html('details', {class: 'error-panel'}, html('summary', {}, first), rest.length > 0 ? html('pre', {}, rest.join('\n')) : null));
    }
  }
}
