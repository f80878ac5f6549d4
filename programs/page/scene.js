// A scene that the page shows, in the worker: a drawing program, or one and the mesh after it, in a
// system; and what is drawn of it in any view.
'use strict';

class Scene {
  #library;
  #given;
  #entered;
  #looks_from = 'null';
  #in_other_view;

  /** `given` is {name, program, mesh: {name, bytes}, shading, lines, aspect}; without a mesh the
   *  program is the whole scene. Throws a DisplayFileError, with its line and column. */
  constructor(library, given) {
    this.#library = library;
    this.#given = given;
    this.#entered = this.#enter(this.program);
  }

  free() {
    this.#entered.free();
    this.#forget_other_view();
  }

  /** The program as it is entered, with what the viewer set. */
  get program() {
    return with_settings(this.#given.program, this.#given);
  }

  #enter(program, mesh = this.#given.mesh) {
    const { name, aspect } = this.#given;
    const system = new this.#library.System();
    try {
      system.setAspectRatio(aspect);
      system.retain();
      system.replay(program, name);
      if (mesh) system.importMesh(mesh.name, mesh.bytes);
      return system;
    } catch (error) {
      system.free();
      throw error;
    }
  }

  #forget_other_view() {
    this.#in_other_view?.system.free();
    this.#in_other_view = undefined;
  }

  /** The view is null for the program's own. Axes stand where the view has them: with them, another
   *  view is another program. */
  #system_in(view) {
    if (!view || !calls(this.program, 'axes-3')) {
      // What is kept from one picture to the next is of one view.
      const looks_from = JSON.stringify(view);
      if (looks_from !== this.#looks_from) this.#entered.lookFrom(view);
      this.#looks_from = looks_from;
      return this.#entered;
    }
    const program = in_view(this.program, view);
    if (this.#in_other_view?.program !== program) {
      const system = this.#enter(program);
      this.#forget_other_view();
      this.#in_other_view = { program, system };
    }
    return this.#in_other_view.system;
  }

  /** The view to turn, and the box to turn about; or why it cannot be turned. */
  view_and_box() {
    try {
      const view = this.#entered.view();
      const { least, greatest } = this.#entered.box();
      if (![...least, ...greatest].every(Number.isFinite)) return { whyNot: 'It is empty.' };
      return { view, middle: least.map((x, k) => (x + greatest[k]) / 2) };
    } catch (error) {
      return { whyNot: error.message };
    }
  }

  /** Pixels; where the scene has texts or annotation, which pixels have not here, SVG. */
  picture(view, options) {
    const system = this.#system_in(view);
    if (!this.has_texts) {
      try {
        return system.draw(options);
      } catch (error) {
        if (!/^(texts|annotations) in pixels/.test(error.message)) throw error;
        this.has_texts = true;
      }
    }
    return { width: options.width, height: options.height, svg: this.svg(view, options) };
  }

  svg(view, options) {
    const { samples, ids, ...of_vectors } = options;
    return this.#system_in(view).svg(of_vectors);
  }

  /** What a method tells of its steps, as JSON. */
  steps(view, options) {
    return JSON.stringify(this.#system_in(view).steps(options));
  }

  truth(view, size) {
    return this.#system_in(view).truth(size).ids;
  }

  /** What is seen there, and the outlines of the polygons of that name: x and y in [0,1], y down. */
  pick(view, options, [x, y]) {
    const system = this.#system_in(view);
    const { samples, ids, ...of_pick } = options;
    const seen = system.pick(x, y, { ...of_pick, reach: 2 });
    return seen && { ...seen, outlines: this.#outlines(system, seen) };
  }

  #outlines(system, { segment, pick }) {
    const pieces = system.pieces({ method: 'none' });
    const outlines = [];
    const of_one = (k) => pieces.segments[k] === segment && pieces.picks[k] === pick;
    for (let k = 0; k < pieces.kinds.length && outlines.length < 1000; ++k) {
      if (!of_one(k)) continue;
      const outline = [];
      for (let p = pieces.first[k]; p < pieces.first[k + 1]; ++p) {
        outline.push([pieces.points[3 * p], 1 - pieces.points[3 * p + 1]]);
      }
      outlines.push({ closed: pieces.kinds[k] !== 2, points: outline });
    }
    return outlines;
  }

  counts() {
    const { segments } = this.#entered.pieces({ method: 'none' });
    return { pieces: segments.length, segments: new Set(segments).size };
  }

  /** The drawing program that draws what is shown, and whether it does: drawn anew, by the same bytes. */
  saved(view, options, settings) {
    // A mesh is no text: what is saved of it is what was called.
    const is_text = !this.#given.mesh;
    const shown = is_text ? this.program : this.#system_in(view).program();
    let program = with_hidden_surfaces(shown, settings);
    if (view && is_text) program = in_view(program, view);
    const system = this.#enter(program, null);
    try {
      const { width, height } = options;
      return { program, isTheSame: system.svg({ width, height }) === this.svg(view, options) };
    } finally {
      system.free();
    }
  }
}
