// What is marked over the figure: outlines of what was picked, and the place where keys pick.
'use strict';

const kSvg = 'http://www.w3.org/2000/svg';

/** An SVG over the picture, in whose coordinates the picture is the unit square. */
class Marks {
  constructor() {
    this.element = document.createElementNS(kSvg, 'svg');
    this.element.setAttribute('viewBox', '0 0 1 1');
    this.element.setAttribute('preserveAspectRatio', 'none');
    this.element.setAttribute('class', 'marks');
    this.element.setAttribute('aria-hidden', 'true');
  }

  #path(kind, d) {
    // Twice, so that it is seen before light and dark.
    for (const kind_of_line of ['under', 'over']) {
      const path = document.createElementNS(kSvg, 'path');
      path.setAttribute('class', `${kind} ${kind_of_line}`);
      path.setAttribute('d', d);
      this.element.append(path);
    }
  }

  clear() {
    this.element.replaceChildren();
  }

  outline(outlines) {
    this.#path('picked', outlines.map(({ closed, points }) =>
      `M${points.map((point) => point.join(' ')).join('L')}${closed ? 'Z' : ''}`).join(''));
  }

  cross([x, y]) {
    const kArm = 0.02;
    this.#path('cross', `M${x - kArm} ${y}H${x + kArm}M${x} ${y - kArm}V${y + kArm}`);
  }
}
