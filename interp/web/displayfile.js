// Display File in JavaScript: the C API (interp/c) compiled to WebAssembly, for pages and for node.
// displayfile.d.ts documents each function. A page has it as `displayfile` after
// <script src="displayfile.js">, node by require("displayfile").
(function (root) {
  'use strict';

  /** What the system could not carry out. The state is then what it was before the call. */
  class DisplayFileError extends Error {
    constructor(message) {
      super(message);
      this.name = 'DisplayFileError';
      const place = /^([^:\n]*):(\d+):(?:(\d+):)? /.exec(message);
      this.file = place ? place[1] : undefined;
      this.line = place ? Number(place[2]) : undefined;
      this.column = place && place[3] ? Number(place[3]) : undefined;
    }
  }

  /** Memory of the compiled program that lasts as long as one call. */
  class Lent {
    constructor(module) {
      this.module = module;
      this.places = [];
    }
    bytes(size) {
      const place = this.module._malloc(Math.max(1, size));
      if (place === 0) throw new DisplayFileError(`out of memory: ${size} bytes`);
      this.places.push(place);
      return place;
    }
    text(words) {
      if (words === undefined || words === null) return 0;
      const { module } = this;
      const size = module.lengthBytesUTF8(String(words)) + 1;
      const place = this.bytes(size);
      module.stringToUTF8(String(words), place, size);
      return place;
    }
    array(values, Kind) {
      const array = values instanceof Kind ? values : Kind.from(values);
      const place = this.bytes(array.byteLength);
      this.module.HEAPU8.set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength), place);
      return place;
    }
    end() {
      for (const place of this.places) this.module._free(place);
    }
  }

  function make(module) {
    const layout = JSON.parse(module.UTF8ToString(module._df_layout()));
    const text = (place) => module.UTF8ToString(place);
    const size_at = (place) => new Uint32Array(module.HEAPU8.buffer, place, 1)[0];

    /** A structure of the C API in memory that is lent. */
    function structure(lent, name, members = {}) {
      const { size, members: places } = layout[name];
      const place = lent.bytes(size);
      module.HEAPU8.fill(0, place, place + size);
      const view = () => new DataView(module.HEAPU8.buffer, place, size);
      view().setUint32(0, size, true);
      for (const [member, value] of Object.entries(members)) {
        if (value === undefined || value === null) continue;
        const [kind, at] = places[member];
        if (kind === 'i32') view().setInt32(at, value, true);
        else if (kind === 'u32' || kind === 'pointer') view().setUint32(at, value, true);
        else if (kind === 'u64') view().setBigUint64(at, BigInt(value), true);
        else if (kind === 'f64') view().setFloat64(at, value, true);
        else value.forEach((v, k) => view().setFloat64(at + 8 * k, v, true));
      }
      return place;
    }
    function member(place, name, which) {
      const { size, members } = layout[name];
      const [kind, at] = members[which];
      const view = new DataView(module.HEAPU8.buffer, place, size);
      if (kind.startsWith('numbers')) {
        return Array.from({ length: Number(kind.slice(7)) }, (_, k) => view.getFloat64(at + 8 * k, true));
      }
      if (kind === 'i32') return view.getInt32(at, true);
      return kind === 'f64' ? view.getFloat64(at, true) : view.getUint32(at, true);
    }

    const whole = (what, value, least, most) => {
      if (value === undefined) return undefined;
      if (!Number.isInteger(value) || value < least || value > most) {
        throw new DisplayFileError(`${what} ${value}: expected a whole number from ${least} to ${most}`);
      }
      return value;
    };
    const kOptions = new Set(['width', 'height', 'method', 'scope', 'precision', 'hiddenLines',
      'lineOrder', 'lineHalo', 'font', 'text', 'background', 'samples', 'mostPieces', 'mostSeconds',
      'ids', 'depth', 'reach']);

    function options_in(lent, options = {}) {
      for (const name of Object.keys(options)) {
        if (!kOptions.has(name)) {
          throw new DisplayFileError(`option ${name}: expected ${[...kOptions].join(', ')}`);
        }
      }
      const { background } = options;
      return structure(lent, 'df_options', {
        width: whole('width', options.width, 1, 65535),
        height: whole('height', options.height, 1, 65535),
        method: lent.text(options.method),
        scope: lent.text(options.scope),
        precision: lent.text(options.precision),
        hidden_lines: lent.text(options.hiddenLines),
        background: background === undefined ? 0 : background === 'none' ? 2 : 1,
        background_colour: Array.isArray(background) ? background : undefined,
        samples: whole('samples', options.samples, 1, 16),
        most_pieces: whole('mostPieces', options.mostPieces, 1, Number.MAX_SAFE_INTEGER),
        most_seconds: options.mostSeconds,
        line_order: lent.text(options.lineOrder),
        line_halo: options.lineHalo,
        font: lent.text(options.font),
        text: lent.text(options.text),
      });
    }

    const routines = [];
    for (let k = 0; k < module._df_routines(); ++k) {
      routines.push({
        name: text(module._df_routine_name(k)),
        arguments: text(module._df_routine_arguments(k)),
      });
    }

    /** Arguments as drawing programs write them: numbers exactly, true and false as on and off. */
    function words(value) {
      if (typeof value === 'number') {
        if (!Number.isFinite(value)) throw new DisplayFileError(`${value}: expected a finite number`);
        return Object.is(value, -0) ? '-0' : String(value);
      }
      if (typeof value === 'boolean') return value ? 'on' : 'off';
      if (typeof value === 'string') return value;
      if (value !== null && typeof value === 'object' && typeof value[Symbol.iterator] === 'function') {
        return Array.from(value, words).join(' ');
      }
      throw new DisplayFileError(`${String(value)}: expected numbers, words, true or false, or arrays of them`);
    }

    class System {
      #system = module._df_create();

      constructor() {
        if (this.#system === 0) throw new DisplayFileError('out of memory: no system');
      }

      /** Lets go of its memory. Nothing may be asked of it after that. */
      free() {
        module._df_destroy(this.#system);
        this.#system = 0;
      }

      /** Calls a function of the C API with memory that is lent to it. */
      #do(work) {
        if (this.#system === 0) throw new DisplayFileError('the system was freed');
        const lent = new Lent(module);
        try {
          const [result, found] = work(this.#system, lent);
          if (result !== 0) throw new DisplayFileError(text(module._df_error(this.#system)));
          return found && found();
        } finally {
          lent.end();
        }
      }

      call(routine, ...values) {
        return this.#do((system, lent) =>
          [module._df_call(system, lent.text(routine), lent.text(words(values)))]);
      }

      replay(program, name = '-') {
        return this.#do((system, lent) => {
          const bytes = typeof program === 'string' ? new TextEncoder().encode(program) : program;
          const place = lent.array(bytes, Uint8Array);
          return [module._df_replay(system, place, bytes.length, lent.text(name))];
        });
      }

      importMesh(name, bytes) {
        // Readers see the name's extension, and messages the name.
        const plain = name.replace(/^.*[/\\]/, '') || 'mesh';
        module.FS.writeFile(plain, bytes);
        try {
          return this.#do((system, lent) => [module._df_import_mesh(system, lent.text(plain))]);
        } finally {
          module.FS.unlink(plain);
        }
      }

      setAspectRatio(aspect) {
        return this.#do((system) => [module._df_set_aspect_ratio(system, aspect)]);
      }

      mesh({ vertices, corners, sides, colours, picks, normals }) {
        return this.#do((system, lent) => {
          const array = (values, Kind) => (values ? lent.array(values, Kind) : 0);
          const count = (what, values, each) => {
            if (!values) return 0;
            if (values.length % each !== 0) {
              throw new DisplayFileError(`${what}: expected ${each} numbers each, got ${values.length}`);
            }
            return values.length / each;
          };
          return [module._df_polygons(system, structure(lent, 'df_mesh', {
            vertices: array(vertices, Float64Array), vertex_count: count('vertices', vertices, 3),
            corners: array(corners, Uint32Array), corner_count: count('corners', corners, 1),
            sides: array(sides, Uint32Array), polygon_count: count('sides', sides, 1),
            colours: array(colours, Float64Array), colour_count: count('colours', colours, 3),
            picks: array(picks, Int32Array), pick_count: count('picks', picks, 1),
            normals: array(normals, Float64Array), normal_count: count('normals', normals, 3),
          }))];
        });
      }

      draw(options = {}) {
        const { width = 512, height = 512 } = options;
        return this.#do((system, lent) => {
          const given = options_in(lent, options);
          const pixels = width * height;
          const rgba = lent.bytes(4 * pixels);
          const ids = options.ids ? lent.bytes(4 * pixels) : 0;
          const depth = options.depth ? lent.bytes(8 * pixels) : 0;
          return [module._df_draw(system, given, pixels, rgba, ids, depth), () => {
            const { buffer } = module.HEAPU8;
            return {
              width,
              height,
              rgba: new Uint8ClampedArray(buffer, rgba, 4 * pixels).slice(),
              ids: ids ? new Int32Array(buffer, ids, pixels).slice() : undefined,
              depth: depth ? new Float64Array(buffer, depth, pixels).slice() : undefined,
            };
          }];
        });
      }

      drawAs(format, options = {}) {
        return this.#do((system, lent) => {
          const bytes = lent.bytes(8);
          const given = options_in(lent, options);
          return [module._df_draw_as(system, given, lent.text(format), bytes, bytes + 4), () => {
            const first = size_at(bytes);
            return module.HEAPU8.slice(first, first + size_at(bytes + 4));
          }];
        });
      }

      svg(options = {}) {
        return new TextDecoder().decode(this.drawAs('svg', options));
      }

      /** What a function hands out as bytes and their number. */
      #text(call) {
        return this.#do((system, lent) => {
          const bytes = lent.bytes(8);
          return [call(system, bytes, lent), () => {
            const first = size_at(bytes);
            return new TextDecoder().decode(module.HEAPU8.slice(first, first + size_at(bytes + 4)));
          }];
        });
      }

      dump() {
        return this.#text((system, bytes) => module._df_dump(system, bytes, bytes + 4));
      }

      pieces(options = {}) {
        return this.#do((system, lent) => {
          const found = structure(lent, 'df_pieces');
          return [module._df_drawn_pieces(system, options_in(lent, options), found), () => {
            const count = member(found, 'df_pieces', 'pieces');
            const array = (which, Kind, length) => {
              const place = member(found, 'df_pieces', which);
              return length === 0 ? new Kind(0) : new Kind(module.HEAPU8.buffer, place, length).slice();
            };
            const first = array('first', Uint32Array, count + 1);
            const points = first[count] ?? 0;
            return {
              kinds: array('kinds', Uint8Array, count),
              first,
              points: array('points', Float64Array, 3 * points),
              sides: array('sides', Uint8Array, points),
              fills: array('fills', Float64Array, 3 * count),
              lineColours: array('line_colours', Float64Array, 3 * count),
              lineWidths: array('line_widths', Float64Array, count),
              lineKinds: array('line_kinds', Uint8Array, count),
              picks: array('picks', Int32Array, count),
              segments: array('segments', Int32Array, count),
              cuts: array('cuts', Uint8Array, points),
            };
          }];
        });
      }

      truth(options = {}) {
        const { width = 512, height = 512 } = options;
        return this.#do((system, lent) => {
          const pixels = width * height;
          const ids = lent.bytes(4 * pixels);
          return [module._df_truth(system, options_in(lent, options), pixels, ids, 0), () =>
            ({ width, height, ids: new Int32Array(module.HEAPU8.buffer, ids, pixels).slice() })];
        });
      }

      steps({ mostSteps, ...options }) {
        return JSON.parse(this.#text((system, bytes, lent) => module._df_steps(system,
          options_in(lent, options),
          whole('mostSteps', mostSteps, 1, 2 ** 32 - 1) ?? 0, bytes, bytes + 4)));
      }

      retain() {
        return this.#do((system) => [module._df_retain(system)]);
      }

      view() {
        return this.#do((system, lent) => {
          const view = structure(lent, 'df_view');
          return [module._df_drawn_view(system, view), () => {
            const of = (which) => member(view, 'df_view', which);
            const [front, back] = of('depth');
            return {
              referencePoint: of('reference_point'),
              planeNormal: of('plane_normal'),
              up: of('up'),
              distance: of('distance'),
              perspective: of('is_perspective') !== 0,
              projection: of('projection'),
              front,
              back,
              frontClipping: of('clips_front') !== 0,
              backClipping: of('clips_back') !== 0,
              window: of('window'),
              viewport: of('viewport'),
            };
          }];
        });
      }

      box() {
        return this.#do((system, lent) => {
          const box = lent.bytes(48);
          return [module._df_box(system, box), () => {
            const all = Array.from(new Float64Array(module.HEAPU8.buffer, box, 6));
            return { least: all.slice(0, 3), greatest: all.slice(3) };
          }];
        });
      }

      lookFrom(view) {
        return this.#do((system, lent) => [module._df_look_from(system, view === null ? 0 :
          structure(lent, 'df_view', {
            reference_point: view.referencePoint,
            plane_normal: view.planeNormal,
            up: view.up,
            distance: view.distance,
            is_perspective: view.perspective ? 1 : 0,
            projection: view.projection,
            depth: [view.front, view.back],
            clips_front: view.frontClipping ? 1 : 0,
            clips_back: view.backClipping ? 1 : 0,
            window: view.window,
            viewport: view.viewport,
          }))]);
      }

      program() {
        return this.#text((system, bytes) => module._df_program(system, bytes, bytes + 4));
      }

      pick(x, y, options = {}) {
        return this.#do((system, lent) => {
          const seen = structure(lent, 'df_seen');
          const given = options_in(lent, options);
          return [module._df_pick(system, given, x, y, options.reach ?? 0, seen), () => {
            const of = (which) => member(seen, 'df_seen', which);
            if (!of('is_seen')) return null;
            return {
              kind: ['polygon', 'edge', 'line'][of('kind')],
              pick: of('pick'),
              segment: of('segment'),
              depth: of('depth'),
            };
          }];
        });
      }
    }

    for (const { name } of routines) {
      const method = name.replace(/-(.)/g, (_, letter) => letter.toUpperCase());
      System.prototype[method] = function (...values) {
        return this.call(name, ...values);
      };
    }

    return { version: text(module._df_version()), routines, System, DisplayFileError };
  }

  /** `wasm`: the compiled program's bytes, for pages that contain them. */
  async function load({ wasm } = {}) {
    if (typeof require !== 'function') return make(await root.createDisplayfile({ wasmBinary: wasm }));
    const path = require('path').join(__dirname, 'displayfile-module.wasm');
    const create = require('./displayfile-module.js');
    return make(await create({ wasmBinary: wasm || require('fs').readFileSync(path) }));
  }

  const exported = { load, DisplayFileError };
  if (typeof module === 'object' && module.exports) module.exports = exported;
  else root.displayfile = exported;
})(typeof globalThis === 'object' ? globalThis : this);
