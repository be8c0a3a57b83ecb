// Inflates zlib data (RFC 1950, RFC 1951) in browsers without DecompressionStream.

const LENGTH_BASE = [3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 15, 17, 19, 23, 27, 31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258];
const LENGTH_EXTRA = [0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0];
const CODE_ORDER = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];
const CODE_LIMIT = 15;

/** A canonical Huffman code: symbols in the order of their codes, and how many codes have each length. */
class HuffmanCode {
  constructor(lengths) {
    this.counts = new Uint16Array(CODE_LIMIT + 1);
    for (const length of lengths) {
      this.counts[length]++;
    }
    this.counts[0] = 0;
    const next = new Uint16Array(CODE_LIMIT + 2);
    for (let length = 1; length <= CODE_LIMIT; length++) {
      next[length + 1] = next[length] + this.counts[length];
    }
    this.symbols = new Uint16Array(lengths.length);
    lengths.forEach((length, symbol) => {
      if (length > 0) {
        this.symbols[next[length]++] = symbol;
      }
    });
  }

  read(bits) {
    let code = 0;
    let first = 0;
    let index = 0;
    for (let length = 1; length <= CODE_LIMIT; length++) {
      code |= bits.take(1);
      const count = this.counts[length];
      if (code - first < count) {
        return this.symbols[index + code - first];
      }
      index += count;
      first = (first + count) << 1;
      code <<= 1;
    }
    throw new Error('the run inside this page is damaged');
  }
}

/** Bits of a byte array, lowest first. */
class Bits {
  constructor(bytes, position) {
    this.bytes = bytes;
    this.position = position;
    this.buffer = 0;
    this.held = 0;
  }

  take(count) {
    while (this.held < count) {
      if (this.position >= this.bytes.length) {
        throw new Error('the run inside this page is cut off');
      }
      this.buffer |= this.bytes[this.position++] << this.held;
      this.held += 8;
    }
    const value = this.buffer & ((1 << count) - 1);
    this.buffer >>>= count;
    this.held -= count;
    return value;
  }

  toByte() {
    this.buffer = 0;
    this.held = 0;
  }
}

/** Bytes that grow. */
class Bytes {
  constructor() {
    this.array = new Uint8Array(1 << 20);
    this.size = 0;
  }

  reserve(count) {
    if (this.size + count > this.array.length) {
      const larger = new Uint8Array(Math.max(this.array.length * 2, this.size + count));
      larger.set(this.array);
      this.array = larger;
    }
  }

  push(byte) {
    this.reserve(1);
    this.array[this.size++] = byte;
  }

  repeat(distance, length) {
    this.reserve(length);
    for (let i = 0; i < length; i++, this.size++) {
      this.array[this.size] = this.array[this.size - distance];
    }
  }
}

function fixedCodes() {
  const lengths = Array.from({length: 288}, (_, i) => (i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8));
  return [new HuffmanCode(lengths), new HuffmanCode(Array(30).fill(5))];
}

function dynamicCodes(bits) {
  const literals = bits.take(5) + 257;
  const distances = bits.take(5) + 1;
  const count = bits.take(4) + 4;
  const codeLengths = Array(19).fill(0);
  for (let i = 0; i < count; i++) {
    codeLengths[CODE_ORDER[i]] = bits.take(3);
  }
  const code = new HuffmanCode(codeLengths);
  const lengths = [];
  while (lengths.length < literals + distances) {
    const symbol = code.read(bits);
    if (symbol < 16) {
      lengths.push(symbol);
    } else {
      const value = symbol === 16 ? lengths[lengths.length - 1] : 0;
      const times = symbol === 16 ? 3 + bits.take(2) : symbol === 17 ? 3 + bits.take(3) : 11 + bits.take(7);
      lengths.push(...Array(times).fill(value));
    }
  }
  return [new HuffmanCode(lengths.slice(0, literals)), new HuffmanCode(lengths.slice(literals, literals + distances))];
}

function compressedBlock(bits, out, [literalCode, distanceCode]) {
  for (let symbol = literalCode.read(bits); symbol !== 256; symbol = literalCode.read(bits)) {
    if (symbol < 256) {
      out.push(symbol);
    } else {
      const length = LENGTH_BASE[symbol - 257] + bits.take(LENGTH_EXTRA[symbol - 257]);
      const distance = distanceCode.read(bits);
      const extra = distance < 2 ? 0 : (distance >> 1) - 1;
      const base = distance < 2 ? distance + 1 : ((2 + (distance & 1)) << extra) + 1;
      out.repeat(base + bits.take(extra), length);
    }
  }
}

function storedBlock(bits, out) {
  bits.toByte();
  const length = bits.take(16);
  bits.take(16);
  for (let i = 0; i < length; i++) {
    out.push(bits.take(8));
  }
}

/** The bytes that were compressed. */
function inflate(bytes) {
  const bits = new Bits(bytes, 2);
  const out = new Bytes();
  for (let last = 0; !last;) {
    last = bits.take(1);
    const kind = bits.take(2);
    if (kind === 0) {
      storedBlock(bits, out);
    } else {
      compressedBlock(bits, out, kind === 1 ? fixedCodes() : dynamicCodes(bits));
    }
  }
  return out.array.subarray(0, out.size);
}
