// The compiled program is in a page as LZMA's, which is three quarters of what gzip makes of it: gzip looks
// back 32 KiB, and browsers unpack nothing that looks farther. As the LZMA specification has it
// (I. Pavlov, LZMA SDK): a range coder gives bits, of probabilities that follow from what was there
// before; bits are bytes, or say how far back what follows stands already, and how long it is.
'use strict';

/** The bits of a stream, each of a probability in an array, as 2048ths, which learns from it. */
class RangeDecoder {
  #bytes;
  #place;
  #range = 0xffffffff;
  #code = 0;

  /** The stream stands from `place` on. */
  constructor(bytes, place) {
    this.#bytes = bytes;
    this.#place = place + 1;
    for (let k = 0; k < 4; ++k) this.#code = (this.#code << 8 | bytes[this.#place++]) >>> 0;
  }

  /** Whether more was asked for than there is. */
  get is_beyond_end() {
    return this.#place > this.#bytes.length;
  }

  #take_byte() {
    this.#range = (this.#range << 8) >>> 0;
    this.#code = (this.#code << 8 | this.#bytes[this.#place++]) >>> 0;
  }

  bit(probabilities, k) {
    const bound = (this.#range >>> 11) * probabilities[k];
    const bit = this.#code < bound ? 0 : 1;
    if (bit === 0) {
      this.#range = bound;
      probabilities[k] += (2048 - probabilities[k]) >> 5;
    } else {
      this.#range -= bound;
      this.#code -= bound;
      probabilities[k] -= probabilities[k] >> 5;
    }
    if (this.#range < 0x1000000) this.#take_byte();
    return bit;
  }

  /** A number of so many bits that are as often 0 as 1. */
  even_bits(count) {
    let number = 0;
    for (let k = 0; k < count; ++k) {
      this.#range >>>= 1;
      const bit = this.#code < this.#range ? 0 : 1;
      if (bit === 1) this.#code -= this.#range;
      if (this.#range < 0x1000000) this.#take_byte();
      number = number * 2 + bit;
    }
    return number;
  }

  /** A number of so many bits, the highest first; the probabilities are a tree from `first` on. */
  tree(probabilities, first, bits) {
    let node = 1;
    while (node < 1 << bits) node = node << 1 | this.bit(probabilities, first + node);
    return node - (1 << bits);
  }

  /** The same, the lowest first. */
  tree_from_lowest(probabilities, first, bits) {
    let node = 1, number = 0;
    for (let k = 0; k < bits; ++k) {
      const bit = this.bit(probabilities, first + node);
      node = node << 1 | bit;
      number |= bit << k;
    }
    return number;
  }
}

/** Probabilities of a half. */
const even_odds = (size) => new Uint16Array(size).fill(1024);

/** The length of what stands already: 2 to 273. */
class LengthDecoder {
  #choices = even_odds(2);
  #low = even_odds(16 * 8);
  #middle = even_odds(16 * 8);
  #high = even_odds(256);

  take(range, position) {
    if (range.bit(this.#choices, 0) === 0) return 2 + range.tree(this.#low, position * 8, 3);
    if (range.bit(this.#choices, 1) === 0) return 10 + range.tree(this.#middle, position * 8, 3);
    return 18 + range.tree(this.#high, 0, 8);
  }
}

/** How far back it stands: 0 for the byte before. */
class DistanceDecoder {
  #slots = even_odds(4 * 64);
  #middle = even_odds(128);
  #lowest = even_odds(16);

  take(range, length) {
    const slot = range.tree(this.#slots, Math.min(length - 2, 3) * 64, 6);
    if (slot < 4) return slot;
    const bits = (slot >> 1) - 1;
    const high = (2 | slot & 1) * 2 ** bits;
    if (slot < 14) return high + range.tree_from_lowest(this.#middle, high - slot, bits);
    return high + range.even_bits(bits - 4) * 16 + range.tree_from_lowest(this.#lowest, 0, 4);
  }
}

/** What the packed bytes are, which have LZMA's own header with their size. Throws an Error if they are
 *  no such bytes. */
function unpacked_lzma(packed) {
  const damaged = () => new Error('the compiled program in this page is damaged');
  if (packed.length < 18 || packed[0] >= 9 * 5 * 5) throw damaged();
  const literal_context = packed[0] % 9;
  const literal_position = Math.floor(packed[0] / 9) % 5, position_bits = Math.floor(packed[0] / 45);
  const header = new DataView(packed.buffer, packed.byteOffset, 13);
  const size = header.getUint32(5, true);
  if (header.getUint32(9, true) !== 0 || size > 2 ** 28) throw damaged();

  const range = new RangeDecoder(packed, 13);
  const literals = even_odds(0x300 << (literal_context + literal_position));
  const lengths = new LengthDecoder(), lengths_again = new LengthDecoder();
  const distances = new DistanceDecoder();
  // What the next is, after what the last few were, of which there are 12 states: a byte (0 to 6) or
  // something that stands already.
  const is_copy = even_odds(12 * 16), is_short_again = even_odds(12 * 16);
  const is_again = even_odds(12), is_not_last = even_odds(12), is_not_second = even_odds(12);
  const is_fourth = even_odds(12);

  const bytes = new Uint8Array(size);
  let state = 0, last = [0, 0, 0, 0], place = 0;

  const take_literal = () => {
    const before = place > 0 ? bytes[place - 1] : 0;
    const context = ((place & (1 << literal_position) - 1) << literal_context) + (before >> 8 - literal_context);
    const first = 0x300 * context;
    let node = 1;
    if (state >= 7) {  // not what would have gone on the copy
      let expected = bytes[place - last[0] - 1];
      while (node < 0x100) {
        const bit_expected = expected >> 7 & 1;
        expected <<= 1;
        const bit = range.bit(literals, first + (1 + bit_expected << 8) + node);
        node = node << 1 | bit;
        if (bit !== bit_expected) break;
      }
    }
    while (node < 0x100) node = node << 1 | range.bit(literals, first + node);
    bytes[place++] = node & 0xff;
    state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
  };

  /** The length of a copy of a distance that was there before. */
  const take_again = (position) => {
    if (range.bit(is_not_last, state) === 0) {
      if (range.bit(is_short_again, state * 16 + position) === 0) {
        state = state < 7 ? 9 : 11;
        return 1;
      }
    } else {
      const k = range.bit(is_not_second, state) === 0 ? 1 : range.bit(is_fourth, state) === 0 ? 2 : 3;
      last = [last[k], ...last.filter((_, other) => other !== k)];
    }
    state = state < 7 ? 8 : 11;
    return lengths_again.take(range, position);
  };

  const take_copy = (position) => {
    const length = lengths.take(range, position);
    last = [distances.take(range, length), last[0], last[1], last[2]];
    state = state < 7 ? 7 : 10;
    return length;
  };

  while (place < size) {
    if (range.is_beyond_end) throw damaged();
    const position = place & (1 << position_bits) - 1;
    if (range.bit(is_copy, state * 16 + position) === 0) {
      take_literal();
      continue;
    }
    const length = range.bit(is_again, state) === 0 ? take_copy(position) : take_again(position);
    if (last[0] >= place || length > size - place) throw damaged();
    for (const end = place + length; place < end; ++place) bytes[place] = bytes[place - last[0] - 1];
  }
  if (range.is_beyond_end) throw damaged();
  return bytes;
}

if (typeof module !== 'undefined') module.exports = { unpacked_lzma };
