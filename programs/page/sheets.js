// Two tilted sheets that lie in front of each other in turn, ever nearer: by an exact method, and by a
// plain z-buffer beside it.
'use strict';

const kSquares = 11;
/** No side of a square passes through a pixel's centre then: what is wrong is a matter of depth alone. */
const kSheetsSide = 320;
const kSheetColours = ['0.95 0.55 0.15', '0.15 0.35 0.75'];

/** A chequerboard of both sheets. The view is such that device coordinates are those of the world:
 *  what is `gap` apart here is so in the display file, too; and nothing counts as touching. */
function sheets_program(gap) {
  const height = (x, y) => 0.2 + 0.43 * x + 0.31 * y;
  const lines = ['set-touching off', 'set-view-depth -1 0', 'set-window 0 1 0 1', 'set-line-style none'];
  kSheetColours.forEach((colour, sheet) => {
    lines.push(`open-segment ${sheet + 1}`, `set-pick-id ${sheet}`, `set-fill-style solid ${colour}`);
    for (let row = 0; row < kSquares; ++row) {
      for (let column = 0; column < kSquares; ++column) {
        const lift = ((row + column) % 2 === sheet ? gap : -gap) / 2;
        const corner = (i, j) => {
          const [x, y] = [i, j].map((k) => 0.05 + (0.9 * k) / kSquares);
          return `${x} ${y} ${height(x, y) + lift}`;
        };
        const [i, j] = [column, row];
        const corners = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
        // Each sheet's squares are divided by the other diagonal.
        const triangles = sheet === 0 ? [[0, 1, 2], [0, 2, 3]] : [[0, 1, 3], [1, 2, 3]];
        for (const triangle of triangles) {
          lines.push(`polygon-abs-3 ${triangle.map((k) => corners[k]).join('  ')}`);
        }
      }
    }
    lines.push('close-segment');
  });
  return `${lines.join('\n')}\n`;
}

class Sheets {
  #drawer;
  #sides;
  #digits = 15;
  #format = 'float';
  #wanted = false;
  #drawing = false;

  constructor(place, drawer) {
    this.#drawer = drawer;
    const side = () => {
      const canvas = element('canvas', { width: kSheetsSide, height: kSheetsSide, role: 'img', class: 'fixed' });
      const caption = element('figcaption', {});
      const picture = element('div', { class: 'picture' }, canvas);
      return { canvas, caption, figure: element('figure', { class: 'figure' }, picture, caption) };
    };
    this.#sides = [side(), side()];
    const output = element('output', { for: 'gap' }, '1e-15');
    const slider = element('input', { type: 'range', id: 'gap', min: 3, max: 15, step: 1, value: 15,
      'aria-valuetext': '1e-15',
      input: () => {
        this.#digits = Number(slider.value);
        output.textContent = `1e-${this.#digits}`;
        slider.setAttribute('aria-valuetext', output.textContent);
        this.draw();
      } });
    const formats = [[undefined, ['double', 'float', '32', '24', '16'].map((format) =>
      [format, Number(format) ? `${format} bits` : format])]];
    const format = labelled_select('Its depths', 'depths', formats, (value) => { this.#format = value; this.draw(); });
    format.querySelector('select').value = this.#format;
    place.replaceChildren(
      element('div', { class: 'sheets' }, ...this.#sides.map(({ figure }) => figure)),
      element('div', { class: 'sheet-controls' },
        element('label', { for: 'gap' }, 'Apart: ', output), slider, format));
  }

  /** One at a time, the newest after the one that is drawn. */
  async draw() {
    this.#wanted = true;
    if (this.#drawing) return;
    this.#drawing = true;
    try {
      while (this.#wanted) {
        this.#wanted = false;
        await this.#draw_both();
      }
    } finally {
      this.#drawing = false;
    }
  }

  async #draw_both() {
    const gap = `1e-${this.#digits}`;
    const key = 'sheets';
    const given = { name: 'sheets.draw', program: sheets_program(Number(gap)), aspect: 1 };
    await this.#drawer.ask('enter', { key, given });
    const size = { width: kSheetsSide, height: kSheetsSide };
    const sides = [['z-buffer', 'The z-buffer, exact'], [`plain-z-buffer=${this.#format}`, 'A plain z-buffer']];
    for (const [k, [method, words]] of sides.entries()) {
      const options = { ...size, method, precision: 'exact', samples: 1 };
      if (k === 1) delete options.precision;
      const { rgba, wrong } = await this.#drawer.ask('wrong', { key, view: null, options });
      const { canvas, caption } = this.#sides[k];
      canvas.getContext('2d').putImageData(new ImageData(rgba, size.width, size.height), 0, 0);
      const percent = ((100 * wrong) / (size.width * size.height)).toPrecision(3);
      const share = wrong === 0 ? 'no wrong pixel' : `${percent} % of the pixels wrong`;
      caption.textContent = `${words}: ${share}`;
      canvas.setAttribute('aria-label', `Two sheets ${gap} apart. ${caption.textContent}`);
    }
  }
}
