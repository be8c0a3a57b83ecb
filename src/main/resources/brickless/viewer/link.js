// The connection to the server: messages come as server-sent events, what a person does goes out as requests, one after the other.

/** The server says something at least once a second; after a longer silence the connection counts as lost. */
const SILENCE_MILLIS = 5000;
const RETRY_MILLIS = 700;

class Link {
  /** `handlers` by message: begin, sample, events, frame, state; and `lost()`, `refused(sentence, action)`. */
  constructor(handlers) {
    this.handlers = handlers;
    this.queue = Promise.resolve();
    this.connected = false;
    setInterval(() => this.watch(), 1000);
    this.connect();
  }

  connect() {
    const source = new EventSource('events');
    this.source = source;
    this.heard = performance.now();
    for (const name of ['begin', 'sample', 'events', 'frame', 'state']) {
      source.addEventListener(name, (message) => source === this.source && this.take(name, message.data));
    }
    source.addEventListener('error', () => source === this.source && this.lose());
  }

  take(name, data) {
    this.heard = performance.now();
    if (name === 'begin') {
      this.connected = true;
    }
    if (this.connected) {
      this.handlers[name](JSON.parse(data));
    }
  }

  watch() {
    if (this.source && performance.now() - this.heard > SILENCE_MILLIS) {
      this.lose();
    }
  }

  /** Gives the connection up and tries again soon. */
  lose() {
    this.source.close();
    this.source = null;
    this.connected = false;
    this.handlers.lost();
    setTimeout(() => this.connect(), RETRY_MILLIS);
  }

  /** Sends what a person does; requests keep their order. Resolves when the server has answered. */
  send(action) {
    const sent = this.queue.then(() => this.post(action));
    this.queue = sent;
    return sent;
  }

  async post(action) {
    try {
      const answer = await fetch('do', {method: 'POST', headers: {'Content-Type': 'application/json'}, body: JSON.stringify(action), keepalive: true});
      if (!answer.ok) {
        const {error} = await answer.json().catch(() => ({error: `The server answered ${answer.status}.`}));
        this.handlers.refused(error, action);
      }
    } catch (problem) {
      if (this.connected) {
        this.handlers.refused(`That did not reach the run: ${problem.message}`, action);
      }
    }
  }
}
