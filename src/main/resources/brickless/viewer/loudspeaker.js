// Sounds of the brick, played. A browser allows sound only after a person has touched the page.

const LOUDEST = 0.16;
/** Sounds are shortened no further than this when the run is faster than life. */
const SHORTEST_SECONDS = 0.03;
const EDGE_SECONDS = 0.006;
/** The brick has one loudspeaker: more than this many sounds that are still to come are not worth hearing. */
const MOST_SOUNDS = 24;

class Loudspeaker {
  constructor(muted) {
    this.muted = muted;
    this.playing = new Set();
    for (const type of ['pointerdown', 'keydown']) {
      document.addEventListener(type, () => this.wake(), {capture: true});
    }
  }

  wake() {
    if (!this.muted && typeof AudioContext !== 'undefined') {
      this.context = this.context || new AudioContext();
      if (this.context.state === 'suspended') {
        this.context.resume();
      }
    }
  }

  mute(muted) {
    this.muted = muted;
    this.hush();
  }

  hush() {
    this.playing.forEach((source) => source.stop());
    this.playing.clear();
  }

  /** Plays sounds of a batch of events that has just come, `rate` times as fast as the brick would. */
  play(events, rate) {
    if (this.muted || !this.context || this.context.state !== 'running' || events.length === 0) {
      return;
    }
    const first = events[0].t;
    for (const event of events) {
      const start = this.context.currentTime + 0.01 + (event.t - first) / rate;
      if (event.name === 'silence') {
        this.hush();
      } else if (this.playing.size < MOST_SOUNDS) {
        this.sound(event, start, Math.max(SHORTEST_SECONDS, event.millis / 1000 / rate));
      }
    }
  }

  sound(event, start, seconds) {
    const gain = this.context.createGain();
    const loud = LOUDEST * Math.min(100, Math.max(0, event.volume)) / 100;
    gain.gain.setValueAtTime(0, start);
    gain.gain.linearRampToValueAtTime(loud, start + EDGE_SECONDS);
    gain.gain.setValueAtTime(loud, start + seconds - EDGE_SECONDS);
    gain.gain.linearRampToValueAtTime(0, start + seconds);
    gain.connect(this.context.destination);
    const source = event.hertz > 0 ? this.tone(event.hertz) : this.rustle();
    source.connect(gain);
    source.start(start);
    source.stop(start + seconds);
    this.playing.add(source);
    source.addEventListener('ended', () => this.playing.delete(source));
  }

  tone(hertz) {
    const source = this.context.createOscillator();
    source.type = 'square';
    source.frequency.value = hertz;
    return source;
  }

  /** Stands for a sound file, whose samples stay with the program: a rustle of the same length. */
  rustle() {
    const {sampleRate} = this.context;
    const buffer = this.context.createBuffer(1, sampleRate, sampleRate);
    const samples = buffer.getChannelData(0);
    let level = 0;
    for (let i = 0; i < samples.length; i++) {
      level += (Math.random() * 2 - 1 - level) * 0.08;
      samples[i] = level * 3;
    }
    const source = this.context.createBufferSource();
    source.buffer = buffer;
    source.loop = true;
    return source;
  }
}
