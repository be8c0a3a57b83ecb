// A long list of which only the rows in view exist. Arrow keys choose rows, as in any list box.

const ROW_HEIGHT = 30;

class Listing {
  /** `render(entry)` gives the children of a row, `pick(entry)` is told which row a person chose. */
  constructor(name, render, pick, empty) {
    this.render = render;
    this.pick = pick;
    this.empty = empty;
    this.entries = [];
    this.current = -1;
    this.spacer = html('div', {class: 'listing-spacer'});
    this.id = `list-${name.toLowerCase()}`;
    this.node = html('div', {class: 'listing', role: 'listbox', tabindex: 0, 'aria-label': name, id: this.id,
      on: {scroll: () => this.scrolled(), keydown: (event) => this.key(event)}}, this.spacer);
    new ResizeObserver(() => {
      this.showEnd();
      this.draw();
    }).observe(this.node);
  }

  setEntries(entries) {
    this.entries = entries;
    this.current = -1;
    this.spacer.style.height = `${Math.max(1, entries.length) * ROW_HEIGHT}px`;
    this.node.scrollTop = 0;
    this.draw(true);
  }

  /** Takes further entries and, unless somebody has scrolled away from it, goes on showing the last. */
  append(entries) {
    this.follows = this.follows !== false;
    this.entries.push(...entries);
    this.current = this.entries.length - 1;
    this.spacer.style.height = `${Math.max(1, this.entries.length) * ROW_HEIGHT}px`;
    this.showEnd();
    this.draw(true);
  }

  /** The last row comes into view if it is followed. */
  showEnd() {
    if (this.follows) {
      this.node.scrollTop = this.spacer.offsetHeight;
    }
  }

  scrolled() {
    if (this.follows !== undefined && this.node.clientHeight > 0) {
      this.follows = this.node.scrollTop + this.node.clientHeight >= this.spacer.offsetHeight - ROW_HEIGHT / 2;
    }
    this.draw();
  }

  /** Marks the entry that counts at a time and, if asked, brings it into view. */
  show(time, follow) {
    const index = lastNotAfter(this.entries, time + 1e-9, (entry) => entry.t);
    if (index !== this.current) {
      this.current = index;
      if (follow) {
        this.reveal(index);
      }
      this.draw(true);
    }
  }

  reveal(index) {
    const top = Math.max(0, index) * ROW_HEIGHT;
    const height = this.node.clientHeight;
    if (top < this.node.scrollTop || top + ROW_HEIGHT > this.node.scrollTop + height) {
      this.node.scrollTop = Math.max(0, top - height / 2);
    }
  }

  draw(changed = false) {
    const first = Math.max(0, Math.floor(this.node.scrollTop / ROW_HEIGHT) - 2);
    const last = Math.min(this.entries.length - 1, Math.ceil((this.node.scrollTop + this.node.clientHeight) / ROW_HEIGHT) + 2);
    if (!changed && first === this.first && last === this.last) {
      return;
    }
    this.first = first;
    this.last = last;
    const rows = [];
    for (let i = first; i <= last; i++) {
      rows.push(this.row(i));
    }
    this.spacer.replaceChildren(...(this.entries.length > 0 ? rows : [html('p', {class: 'listing-empty'}, this.empty)]));
    if (this.current >= first && this.current <= last) {
      this.node.setAttribute('aria-activedescendant', `${this.id}-${this.current}`);
    } else {
      this.node.removeAttribute('aria-activedescendant');
    }
  }

  row(i) {
    const entry = this.entries[i];
    const row = html('div', {class: `row ${entry.kind}${i > this.current ? ' future' : ''}`, role: 'option', id: `${this.id}-${i}`,
      'aria-selected': String(i === this.current), 'aria-posinset': i + 1, 'aria-setsize': this.entries.length, 'data-time': entry.t,
      on: {click: () => this.pick(entry)}}, html('span', {class: 'row-time'}, clock(entry.t)), ...this.render(entry));
    row.style.top = `${i * ROW_HEIGHT}px`;
    return row;
  }

  key(event) {
    const page = Math.max(1, Math.floor(this.node.clientHeight / ROW_HEIGHT) - 1);
    const step = {ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -Infinity, End: Infinity}[event.key];
    if (step === undefined || this.entries.length === 0 || event.ctrlKey || event.metaKey || event.altKey) {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
    const index = Math.min(this.entries.length - 1, Math.max(0, this.current + step));
    this.pick(this.entries[index]);
    if (index !== this.current) {
      this.current = index;
      this.draw(true);
    }
    this.reveal(index);
  }
}
