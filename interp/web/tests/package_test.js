// The package as a program under node uses it, beside the command built for this machine.
//   node package_test.js PACKAGE COMMAND PROGRAMS
'use strict';

const assert = require('assert');
const { execFileSync } = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');
const test = require('node:test');

const [folder, command, programs] = process.argv.slice(2).map((name) => path.resolve(name));
const { load, DisplayFileError } = require(path.join(folder, 'displayfile.js'));

const work = fs.mkdtempSync(path.join(os.tmpdir(), 'displayfile-'));
process.on('exit', () => fs.rmSync(work, { recursive: true }));

/** What the command draws of a program, as the bytes of a file. */
function drawn(program, format, method) {
  const file = path.join(work, `drawn.${format}`);
  execFileSync(command, ['draw', program, '-o', file, '--size', '120x120', '--hidden', method],
    { stdio: 'ignore' });
  return fs.readFileSync(file);
}

function without_alpha(rgba) {
  const rgb = Buffer.alloc((rgba.length / 4) * 3);
  for (let k = 0; k < rgba.length / 4; ++k) {
    for (let i = 0; i < 3; ++i) rgb[3 * k + i] = rgba[4 * k + i];
  }
  return rgb;
}

/** A call that must be refused, with what the message must say; the state stays. */
function refused(system, call, said) {
  const before = system.dump();
  assert.throws(call, (error) => error instanceof DisplayFileError && said.test(error.message), String(said));
  assert.strictEqual(system.dump(), before);
}

function square(system, z, pick) {
  system.setPickId(pick);
  system.polygonAbs3(-0.5, -0.5, z, 0.5, -0.5, z, 0.5, 0.5, z, -0.5, 0.5, z);
}

test('pictures, item buffers and SVG are those of the command', async () => {
  const { System } = await load();
  const gallery = fs.readdirSync(programs).filter((name) => name.endsWith('.draw'));
  let compared = 0;
  for (const name of gallery) {
    const program = path.join(programs, name);
    const text = fs.readFileSync(program, 'utf8');
    if (/^ *begin-solid/m.test(text)) continue; // CGAL's
    for (const method of ['z-buffer', 'map', 'franklin']) {
      const system = new System();
      system.replay(text, name);
      const options = { width: 120, height: 120, method };
      assert.strictEqual(system.svg(options), drawn(program, 'svg', method).toString(), name);
      if (!/^ *(text|axes-3|title|leader-3|balloon-3|parts-list|[a-z]+-dimension-3)/m.test(text)) { // Cairo's, in pixels
        const ppm = drawn(program, 'ppm', method);
        assert.ok(without_alpha(system.draw(options).rgba).equals(ppm.subarray(-3 * 120 * 120)), name);
      }
      system.free();
      ++compared;
    }
  }
  assert.ok(compared >= 60, `${compared} compared`);
});

test('user routines are methods, and what is seen is told', async () => {
  const { System, routines, version } = await load();
  assert.match(version, /^\d+\.\d+\.\d+$/);
  const types = fs.readFileSync(path.join(folder, 'displayfile.d.ts'), 'utf8');
  const system = new System();
  for (const { name } of routines) {
    const method = name.replace(/-(.)/g, (_, letter) => letter.toUpperCase());
    assert.strictEqual(typeof system[method], 'function', name);
    assert.ok(types.includes(`  ${method}(`), name);
  }
  system.setFillStyle('solid', 1, 0, 0);
  system.setLineStyle('none');
  system.openSegment(7);
  square(system, 0, 3);
  system.setFillStyle('solid', [0, 0, 1]);
  square(system, 1e-15, 4);
  system.closeSegment();
  const { rgba, ids, depth } = system.draw({ width: 40, height: 40, ids: true, depth: true });
  const middle = 20 * 40 + 20;
  assert.deepStrictEqual([...rgba.slice(4 * middle, 4 * middle + 4)], [0, 0, 255, 255]);
  assert.strictEqual(ids[middle], 4);
  assert.ok(depth[middle] > 0 && depth[0] === -Infinity);
  const seen = system.pick(20, 20, { width: 40, height: 40 });
  assert.deepStrictEqual([seen.kind, seen.pick, seen.segment], ['polygon', 4, 7]);
  assert.strictEqual(system.pick(1, 1, { width: 40, height: 40 }), null);
  const pieces = system.pieces({ method: 'map' });
  assert.deepStrictEqual([...pieces.picks], [4]);
  assert.strictEqual(pieces.points.length, 3 * pieces.first[1]);
});

test('texts have the font that is set', async () => {
  const { System } = await load();
  const system = new System();
  system.openSegment(1);
  system.moveAbs2(0, 0);
  system.text('"I"');
  system.closeSegment();
  assert.match(system.svg(), /font-family:sans-serif;/);
  assert.match(system.svg({ font: 'DejaVu Serif', text: 'text' }), /font-family:'DejaVu Serif',sans-serif;/);
  refused(system, () => system.svg({ font: 'a;b' }), /font 'a;b': expected the name of a font/);
  refused(system, () => system.svg({ font: 'hershey' }), /hershey/);
  refused(system, () => system.svg({ text: 'outlines' }), /Cairo/);
});

test('meshes come as arrays and as files', async () => {
  const { System } = await load();
  const vertices = [0, 0, 0, 0.5, 0, 0, 0, 0.5, 0, 0.5, 0.5, 0];
  const system = new System();
  system.openSegment(1);
  system.mesh({ vertices, corners: Uint32Array.of(0, 1, 2, 1, 3, 2), colours: [1, 0, 0, 0, 1, 0], picks: [5, 6] });
  system.closeSegment();
  const { ids } = system.draw({ width: 64, height: 64, ids: true });
  assert.deepStrictEqual([...new Set(ids)].sort(), [-1, 5, 6]);
  const file = new System();
  file.importMesh('folder/one.obj', Buffer.from('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'));
  assert.match(file.dump(), /polygon 3/);
  refused(file, () => file.importMesh('two.obj', Buffer.from('v 0 0\n')), /^two\.obj:1/);
});

test('what is wrong is an error, and the state stays', async () => {
  const { System } = await load();
  const system = new System();
  system.openSegment(1);
  square(system, 0, 1);
  system.closeSegment();
  refused(system, () => system.polygonAbs3(0, 0, 0), /segment|open/);
  refused(system, () => system.call('no-such-routine'), /no-such-routine/);
  refused(system, () => system.setLight(NaN, 0, 0), /finite/);
  refused(system, () => system.setLight(undefined), /expected/);
  refused(system, () => system.draw({ method: 'nothing' }), /nothing/);
  refused(system, () => system.draw({ wdth: 3 }), /wdth/);
  refused(system, () => system.draw({ width: 0 }), /width 0/);
  refused(system, () => system.drawAs('pdf'), /Cairo/);
  refused(system, () => system.mesh({ vertices: [0, 0], corners: [] }), /vertices|segment/);
  const place = (() => {
    try {
      system.replay('set-light 0 0 1\nset-lihgt 0 0 1\n', 'x.draw');
    } catch (error) {
      return error;
    }
    return null;
  })();
  assert.deepStrictEqual([place.file, place.line], ['x.draw', 2]);
  system.free();
  assert.throws(() => system.dump(), /freed/);
});
