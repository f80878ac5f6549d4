// Speed and wrong pixels of each method on the scene that is shown.
'use strict';

const kMeasured = [['z-buffer', 'exact'], ['scan-line', 'exact'], ['scan-line-z', 'exact'], ['ray-cast', 'exact'],
  ['warnock', 'exact'], ['bsp', 'exact'], ['depth-sort', 'exact'], ['map', 'exact'], ['z-buffer', 'roundoff=1e-9'],
  ['bsp', 'roundoff=1e-9'], ['plain-z-buffer=double'], ['plain-z-buffer=float'], ['plain-z-buffer=24'],
  ['plain-z-buffer=16'], ['none']];

/** Pixels in a row. */
const kSide = 512;
const kViews = 12;

const ratio = (time, fastest) => (time / fastest).toPrecision(3).replace(/\.0+$/, '');

class SpeedTable {
  #viewer;
  #place;
  #button;
  #status;
  #runs = 0;

  constructor(place, viewer) {
    this.#viewer = viewer;
    this.#button = element('button', { type: 'button', class: 'first', click: () => this.#start_or_stop() }, 'Measure');
    this.#status = element('span', { role: 'status' });
    this.#place = element('div', { class: 'wide' });
    place.replaceChildren(element('div', { class: 'row' }, this.#button, this.#status), this.#place);
  }

  /** Another scene is shown: figures of the last one say nothing of it. */
  clear() {
    ++this.#runs;
    this.#button.textContent = 'Measure';
    this.#status.textContent = '';
    this.#place.replaceChildren();
  }

  async #start_or_stop() {
    const is_running = this.#button.textContent === 'Stop';
    if (is_running) {
      ++this.#runs;
      this.#end('Stopped.');
      return;
    }
    const run = ++this.#runs;
    this.#button.textContent = 'Stop';
    const { key, view, given, drawer } = this.#viewer;
    const [width, height] = [kSide, Math.round((kSide * this.#viewer.size.height) / this.#viewer.size.width)];
    const views = this.#viewer.views_after(kViews);
    const rows = [];
    for (const [method, precision] of kMeasured) {
      this.#status.textContent = `${rows.length + 1} of ${kMeasured.length}: ${words_of_method(method)} …`;
      const options = { width, height, method, ...(precision ? { precision } : {}) };
      const row = { method, precision };
      try {
        Object.assign(row, await drawer.ask('measure', { key, view, options, views }));
      } catch (refused) {
        row.refused = refused.message;
      }
      if (run !== this.#runs) return;
      rows.push(row);
      this.#show(rows, given.name, width, height);
    }
    this.#end('Done.');
  }

  #end(said) {
    this.#button.textContent = 'Measure';
    this.#status.textContent = said;
  }

  #show(rows, name, width, height) {
    const measured = rows.filter((row) => !row.refused);
    if (measured.length === 0) return;
    const least = (which) => Math.min(...measured.map((row) => row[which] ?? Infinity));
    const fastest = { anew: least('anew'), again: least('again') };
    const time = (row, which) => element('td', {}, row[which] === undefined ? '–' : ratio(row[which], fastest[which]));
    const line = (row) => {
      const head = element('th', { scope: 'row' },
        row.precision ? `${words_of_method(row.method)}, ${row.precision.replace('=', ' ')}` : words_of_method(row.method));
      if (row.refused) return element('tr', {}, head, element('td', { colspan: 3, class: 'wrong' }, row.refused));
      const percent = row.wrong === 0 ? '0' : `${row.wrong} (${((100 * row.wrong) / row.pixels).toPrecision(2)} %)`;
      return element('tr', {}, head, time(row, 'anew'), time(row, 'again'),
        element('td', { class: row.wrong ? 'wrong' : '' }, percent));
    };
    const column = (words) => element('th', { scope: 'col' }, words);
    this.#place.replaceChildren(element('table', {},
      element('caption', {},
        `${name} at ${width} × ${height} pixels, in this browser: medians of times, in those of the fastest; pixels ` +
        'that show another polygon than the one that exact arithmetic finds there.'),
      element('thead', {}, element('tr', {}, column('Method'), column('A new view'), column('Again'), column('Wrong pixels'))),
      element('tbody', {}, ...rows.map(line))));
  }
}
