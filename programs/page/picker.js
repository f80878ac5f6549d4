// What is seen at a place of the figure: where it is clicked, or where a cross is moved by keys.
'use strict';

class Picker {
  #viewer;
  #cross;

  constructor(viewer) {
    this.#viewer = viewer;
  }

  /** A click at a place, in parts of the picture. */
  press(at) {
    this.#cross = undefined;
    this.#pick(at);
  }

  get has_cross() {
    return this.#cross !== undefined;
  }

  /** Moves the cross, which begins in the middle, by parts of the picture. */
  move(dx, dy) {
    const within = (x) => Math.min(0.999, Math.max(0, x));
    const [x, y] = this.#cross ?? [0.5, 0.5];
    this.#cross = [within(x + dx), within(y + dy)];
    this.#pick(this.#cross);
  }

  /** Takes cross and outline away. */
  forget() {
    this.#cross = undefined;
    this.#viewer.marks.clear();
    this.#viewer.say('');
  }

  async #pick([x, y]) {
    if (!this.#viewer.given) return;
    const { drawer, key, view, options, size, marks } = this.#viewer;
    try {
      const at = [x * size.width, y * size.height];
      const { seen } = await drawer.ask('pick', { key, view, options, at });
      marks.clear();
      if (this.#cross) marks.cross(this.#cross);
      if (seen) marks.outline(seen.outlines);
      this.#viewer.say(seen ? this.#words(seen) : 'Nothing is visible there.');
    } catch (refused) {
      this.#viewer.say(refused.message);
    }
  }

  #words({ kind, pick, segment, depth }) {
    const what = { polygon: 'Polygon', edge: 'Edge of polygon', line: 'Line' }[kind];
    const name = pick < 0 ? 'without identifier' : pick;
    return `${what} ${name} of segment ${segment}, depth ${Number(depth.toPrecision(6))}`;
  }
}
