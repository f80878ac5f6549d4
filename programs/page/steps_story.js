'use strict';

/**
 * What an algorithm told (interp/steps/README.md), and what holds after any step. Going back costs
 * what going on does: of the picture there are keyframes, and of all else it is known when it
 * changed.
 */
class StepsStory {
  constructor(data) {
    this.data = data;
    this.steps = data.steps;
    this.width = data.width;
    this.height = data.height;
    this.linesUntil = this.countUntil('lines');
    this.lines = this.steps.flatMap((step) => step.lines || []);
    this.staysUntil = this.countUntil('stays');
    this.stays = this.steps.flatMap((step) => step.stays || []);
    this.findPanelChanges();
    this.setKeyframes();
  }

  get count() { return this.steps.length; }

  /** For each step how many entries of that member it and those before it have. */
  countUntil(member) {
    let count = 0;
    return this.steps.map((step) => (count += (step[member] || []).length));
  }

  /** For each panel its changes, and for each node of a tree what became of it, with the steps. */
  findPanelChanges() {
    this.panelChanges = this.data.panels.map(() => []);
    this.nodes = this.data.panels.map(() => new Map());
    this.steps.forEach((step, at) => {
      for (const change of step.panels || []) {
        if (!change.nodes) {
          this.panelChanges[change.panel].push({at, change});
          continue;
        }
        for (const [id, parent, branch, text, piece, role] of change.nodes) {
          const known = this.nodes[change.panel].get(id);
          if (!known) {
            this.nodes[change.panel].set(id, {id, parent, branch, looks: [{at, text, piece, role}]});
          } else {
            known.looks.push({at, text, piece, role});
          }
        }
      }
    });
  }

  /** The last entry of a list in order that is no later than the step. */
  static lastUntil(entries, at) {
    let low = 0;
    let high = entries.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (entries[middle].at <= at) low = middle + 1;
      else high = middle;
    }
    return low === 0 ? undefined : entries[low - 1];
  }

  /** What a panel shows after the step; undefined before it has shown anything. */
  panel(number, at) {
    return (StepsStory.lastUntil(this.panelChanges[number], at) || {}).change;
  }

  /** The rows of that as piece, role and cells. */
  rows(change) {
    return ((change || {}).rows || []).map((row) => {
      const [piece, role, ...cells] = typeof row === 'number' ? [row, 'none'] : row;
      return [piece, role, ...(cells.length ? cells : [this.nameOf(piece)])];
    });
  }

  setKeyframes() {
    const kMostBytes = 64 << 20;
    const bytes = 4 * this.width * this.height;
    this.between = Math.max(32, Math.ceil((this.count * bytes) / kMostBytes));
    this.keyframes = [];
    const picture = this.emptyPicture();
    this.steps.forEach((step, at) => {
      if (at % this.between === 0) this.keyframes.push(picture.slice());
      this.paint(picture, step);
    });
  }

  emptyPicture() { return new Int32Array(this.width * this.height).fill(-1); }

  paint(picture, step) {
    for (const [row, first, end, polygon] of step.gained || []) {
      const start = (this.height - 1 - row) * this.width;
      picture.fill(polygon, start + first, start + end);
    }
  }

  /** Which polygon each pixel shows after the step, top row first; -1 where none. */
  picture(at) {
    if (at < 0 || this.count === 0) return this.emptyPicture();
    const keyframe = Math.floor(at / this.between);
    const picture = this.keyframes[keyframe].slice();
    for (let k = keyframe * this.between; k <= at; ++k) this.paint(picture, this.steps[k]);
    return picture;
  }

  /** The next step after this that runs the line, from the first on if there is none; or -1. */
  nextOnLine(line, after) {
    const from = this.steps.findIndex((step, at) => at > after && step.line === line);
    return from >= 0 ? from : this.steps.findIndex((step) => step.line === line);
  }

  nameOf(piece) { return this.data.pieces[piece].name; }
  colourOf(piece) { return this.data.polygons[this.data.pieces[piece].polygon].colour; }
}
