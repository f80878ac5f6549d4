'use strict';

const { execFileSync } = require('child_process');

/** Bytes as xz packs them by LZMA, with their size in the header, where xz leaves it open. */
function packed(bytes, properties = 'preset=9e,lc=4,pb=0,nice=273') {
  const lzma = execFileSync('xz', ['--format=lzma', `--lzma1=${properties}`, '--stdout'],
    { input: bytes, maxBuffer: 2 ** 28 });
  lzma.writeBigUInt64LE(BigInt(bytes.length), 5);
  return lzma;
}

module.exports = { packed };
