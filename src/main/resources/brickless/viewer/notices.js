// Notices over the page: they take no room, so nothing jumps when they come and go.

const TRANSIENT_MILLIS = 6000;

class Notices {
  constructor(host) {
    this.host = host;
    this.shown = new Map();
  }

  /** Shows a notice of a kind in place of the last one of that kind; `actions` are [label, function]. */
  show(kind, tone, text, actions = []) {
    const [first, ...rest] = text.split('\n');
    const words = html('div', {class: 'notice-text'}, html('p', {}, first), rest.length > 0 ? html('pre', {}, rest.join('\n')) : null);
    const buttons = actions.map(([label, action]) => html('button', {type: 'button', class: 'push-button', on: {click: action}}, label));
    const key = `${tone} ${text}`;
    if (this.shown.has(kind) && this.shown.get(kind).key === key) {
      return;
    }
    this.hide(kind);
    const close = iconButton('Close', icon('M5 5l10 10M15 5L5 15'), () => node.remove(), 'flat close');
    const node = html('div', {class: `notice ${tone}`, 'data-notice': kind, role: tone === 'bad' ? 'alert' : 'status'}, words,
      html('div', {class: 'notice-buttons'}, ...buttons, ...(kind === 'lost' ? [] : [close])));
    this.host.append(node);
    this.shown.set(kind, {key, node});
  }

  hide(kind) {
    const notice = this.shown.get(kind);
    if (notice) {
      notice.node.remove();
      this.shown.delete(kind);
    }
  }

  /** A notice that goes by itself. */
  flash(text) {
    clearTimeout(this.timer);
    this.show('flash', 'bad', text);
    this.timer = setTimeout(() => this.hide('flash'), TRANSIENT_MILLIS);
  }
}
