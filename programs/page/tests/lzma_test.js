// lzma.js unpacks what xz packs, with any properties, and tells damaged bytes; and the packed viewer is
// as small as the project asks.
//   node lzma_test.js PACKAGE
'use strict';

const assert = require('assert');
const fs = require('fs');
const path = require('path');
const { packed } = require('../../../interp/web/packed.js');
const { unpacked_lzma } = require('../lzma.js');

const kMostOfViewer = 680_000;  // bytes: what a page of one scene adds to its size

/** Numbers from 0 to 1 that look like chance, the same each time. */
let seed = 1;
function chance() {
  seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
  return seed / 2 ** 32;
}

/** Bytes of few kinds, of which stretches come again, near and far. */
function sample(size) {
  const bytes = Buffer.alloc(size);
  const kinds = 1 + Math.floor(chance() * 256);
  for (let k = 0; k < size;) {
    const length = Math.min(size - k, 1 + Math.floor(chance() ** 4 * 400));
    const from = Math.floor(chance() * k);
    for (const end = k + length, shift = k - from; k < end; ++k) {
      bytes[k] = shift > 0 && kinds % 3 !== 0 ? bytes[k - shift] : Math.floor(chance() * kinds);
    }
  }
  return bytes;
}

const kProperties = ['preset=9e,pb=0,nice=273', 'preset=6', 'preset=0,lc=1,lp=3,pb=4', 'preset=3,lc=0,lp=0,pb=0'];
const is_of_message = /the compiled program in this page is damaged/;

let unpacked = 0, told = 0;
for (const size of [0, 1, 2, 17, 300, 5000, 100_000]) {
  for (const properties of kProperties) {
    const bytes = sample(size);
    const lzma = packed(bytes, properties);
    assert.ok(Buffer.from(unpacked_lzma(lzma)).equals(bytes), `${size} bytes, ${properties}`);
    ++unpacked;
    if (size < 300) continue;
    assert.throws(() => unpacked_lzma(lzma.subarray(0, lzma.length >> 1)), is_of_message);
    // Other bytes are other contents, or no contents: never anything else.
    for (let k = 0; k < 200; ++k) {
      const damaged = Buffer.from(lzma);
      damaged[13 + Math.floor(chance() * (damaged.length - 13))] ^= 1 + Math.floor(chance() * 255);
      try {
        assert.strictEqual(unpacked_lzma(damaged).length, size);
      } catch (error) {
        assert.match(error.message, is_of_message);
        ++told;
      }
    }
  }
}
assert.throws(() => unpacked_lzma(Buffer.alloc(5)), is_of_message);
assert.throws(() => unpacked_lzma(Buffer.alloc(40, 255)), is_of_message);
console.log(`${unpacked} samples unpacked, ${told} of those that were damaged told`);

const folder = process.argv[2];
for (const name of ['displayfile-module', 'displayfile-viewer']) {
  const program = fs.readFileSync(path.join(folder, `${name}.wasm`));
  const lzma = Buffer.from(fs.readFileSync(path.join(folder, `${name}.wasm.lzma.base64`), 'utf8'), 'base64');
  assert.ok(Buffer.from(unpacked_lzma(lzma)).equals(program), name);
  console.log(`${name}: ${program.length} bytes, packed ${lzma.length}`);
  if (name === 'displayfile-viewer') assert.ok(lzma.length <= kMostOfViewer, `more than ${kMostOfViewer}`);
}
