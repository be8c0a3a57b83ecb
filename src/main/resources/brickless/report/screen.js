// The brick's screen over time.

const SCREEN_WIDTH = 178;
const SCREEN_HEIGHT = 128;
const SCREEN_ROW_BYTES = 23;
const SCREEN_KEYFRAME = 64;

/** Puts the rows that changed into a picture. */
function applyRows(picture, event) {
  event.rows.forEach((row, i) => {
    const hex = event.pixels[i];
    for (let byte = 0; byte < SCREEN_ROW_BYTES; byte++) {
      picture[row * SCREEN_ROW_BYTES + byte] = parseInt(hex.substr(byte * 2, 2), 16);
    }
  });
}

/** Rebuilds the picture at any time from the rows that changed; a whole picture is kept now and then so that going back is quick. */
class ScreenHistory {
  constructor(events) {
    this.events = events;
    this.keyframes = [new Uint8Array(SCREEN_ROW_BYTES * SCREEN_HEIGHT)];
    this.picture = this.keyframes[0].slice();
    this.applied = 0;
  }

  /** How many changes had happened at a time: the same number means the same picture. */
  changesAt(time) {
    return lastNotAfter(this.events, time + 1e-9, (event) => event.t) + 1;
  }

  /** Picture after so many changes: 23 bytes a row, lowest bit leftmost. */
  after(changes) {
    if (changes < this.applied) {
      const frame = Math.floor(changes / SCREEN_KEYFRAME);
      this.picture = this.keyframes[frame].slice();
      this.applied = frame * SCREEN_KEYFRAME;
    }
    while (this.applied < changes) {
      applyRows(this.picture, this.events[this.applied++]);
      if (this.applied % SCREEN_KEYFRAME === 0) {
        this.keyframes[this.applied / SCREEN_KEYFRAME] = this.picture.slice();
      }
    }
    return this.picture;
  }
}

/** Paints a picture on a canvas of the screen's size. */
function paintScreen(canvas, picture) {
  const context = canvas.getContext('2d');
  const image = context.createImageData(SCREEN_WIDTH, SCREEN_HEIGHT);
  for (let y = 0; y < SCREEN_HEIGHT; y++) {
    for (let x = 0; x < SCREEN_WIDTH; x++) {
      const dark = (picture[y * SCREEN_ROW_BYTES + (x >> 3)] >> (x & 7)) & 1;
      const at = (y * SCREEN_WIDTH + x) * 4;
      image.data[at] = dark ? 0x1e : 0xb5;
      image.data[at + 1] = dark ? 0x26 : 0xc2;
      image.data[at + 2] = dark ? 0x1c : 0xa6;
      image.data[at + 3] = 255;
    }
  }
  context.putImageData(image, 0, 0);
}
