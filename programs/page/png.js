// A PNG file of pixels as they are: a canvas's own would multiply transparent ones, and lose some.
// ISO/IEC 15948: a signature, and chunks with their lengths and checks.
'use strict';

const kCrcTable = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let bit = 0; bit < 8; ++bit) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n;
});

function crc_32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = kCrcTable[(crc ^ byte) & 0xff] ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

function png_chunk(kind, content) {
  const chunk = new Uint8Array(12 + content.length);
  const view = new DataView(chunk.buffer);
  view.setUint32(0, content.length);
  chunk.set(new TextEncoder().encode(kind), 4);
  chunk.set(content, 8);
  view.setUint32(8 + content.length, crc_32(chunk.subarray(4, 8 + content.length)));
  return chunk;
}

/** Rows as their differences from the row above, which of a drawing are mostly 0. */
function filtered_rows({ width, height, rgba }) {
  const kUp = 2, stride = 4 * width;
  const rows = new Uint8Array((stride + 1) * height);
  for (let y = 0; y < height; ++y) {
    rows[y * (stride + 1)] = kUp;
    for (let x = 0; x < stride; ++x) {
      const above = y === 0 ? 0 : rgba[(y - 1) * stride + x];
      rows[y * (stride + 1) + 1 + x] = rgba[y * stride + x] - above;
    }
  }
  return rows;
}

/** The bytes of a file, with 8 bits of red, green, blue and opacity. */
async function png_file(picture) {
  const header = new Uint8Array(13);
  const view = new DataView(header.buffer);
  view.setUint32(0, picture.width);
  view.setUint32(4, picture.height);
  header.set([8, 6], 8);
  const packed = new Blob([filtered_rows(picture)]).stream().pipeThrough(new CompressionStream('deflate'));
  const content = new Uint8Array(await new Response(packed).arrayBuffer());
  const signature = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a);
  return new Blob([signature, png_chunk('IHDR', header), png_chunk('IDAT', content),
    png_chunk('IEND', new Uint8Array(0))]);
}
