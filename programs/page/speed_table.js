// Speed and wrong pixels of each method on the scene that is shown.
'use strict';

const kMeasured = [['z-buffer', 'exact'], ['scan-line', 'exact'], ['scan-line-z', 'exact'], ['ray-cast', 'exact'],
  ['warnock', 'exact'], ['bsp', 'exact'], ['depth-sort', 'exact'], ['map', 'exact'], ['z-buffer', 'roundoff=1e-9'],
  ['bsp', 'roundoff=1e-9'], ['plain-z-buffer=double'], ['plain-z-buffer=float'], ['plain-z-buffer=24'],
  ['plain-z-buffer=16'], ['none']];

/** Pixels in a row. */
const kSide = 512;
const kViews = 12;
/** The first round is for the browser, which compiles anew what is called often. */
const kRounds = 8;
const kWarming = 60, kLeastTimed = 5;
/** Milliseconds that one method may take of all rounds, if it has been timed at all. */
const kEnough = 4000;

function median(values) {
  return [...values].sort((a, b) => a - b)[values.length >> 1];
}

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
    if (!this.#viewer.given) return;
    this.#button.textContent = 'Stop';
    this.#measure(++this.#runs);
  }

  /** All methods in turn, round after round: what else the machine does meets all of them. */
  async #measure(run) {
    const { key, view, given, drawer, size } = this.#viewer;
    const [width, height] = [kSide, Math.round((kSide * size.height) / size.width)];
    const views = this.#viewer.views_after(kViews);
    const rows = kMeasured.map(([method, precision]) => {
      const options = { width, height, method, samples: 1, ...(precision ? { precision } : {}) };
      return { method, precision, options, times: [], spent: 0 };
    });
    for (let round = 0; round < kRounds; ++round) {
      for (const row of rows) {
        if (row.refused || row.spent > kEnough) continue;
        this.#status.textContent = `Round ${round + 1} of ${kRounds}: ${words_of_method(row.method)} …`;
        const begin = performance.now();
        try {
          const { options } = row;
          if (round === 0) row.wrong = (await drawer.ask('wrong', { key, view, options })).wrong;
          const least = round === 0 ? kWarming : kLeastTimed;
          const times = await drawer.ask('time', { key, view, options, views, least });
          if (round === 1) row.times = [];
          row.times.push(times);
        } catch (refused) {
          row.refused = refused.message;
        }
        if (run !== this.#runs) return;
        row.spent += performance.now() - begin;
        this.#show(rows.filter(({ refused, times }) => refused || times.length > 0), given.name, width, height);
      }
    }
    this.#end('Done.');
  }

  #end(said) {
    this.#button.textContent = 'Measure';
    this.#status.textContent = said;
  }

  #show(rows, name, width, height) {
    const time_of = (row, which) => median(row.times.map((times) => times[which]));
    const least = (which) => Math.min(...rows.filter(({ refused }) => !refused).map((row) => time_of(row, which)));
    const fastest = { anew: least('anew'), again: least('again') };
    const time = (row, which) => {
      const milliseconds = time_of(row, which);
      return element('td', {}, milliseconds === undefined ? '–' : ratio(milliseconds, fastest[which]));
    };
    const line = (row) => {
      const precision = row.precision ? `, ${row.precision.replace('=', ' ')}` : '';
      const head = element('th', { scope: 'row' }, words_of_method(row.method) + precision);
      if (row.refused) return element('tr', {}, head, element('td', { colspan: 3, class: 'wrong' }, row.refused));
      const percent = ((100 * row.wrong) / (width * height)).toPrecision(2);
      return element('tr', {}, head, time(row, 'anew'), time(row, 'again'),
        element('td', { class: row.wrong ? 'wrong' : '' }, row.wrong ? `${row.wrong} (${percent} %)` : '0'));
    };
    const columns = ['Method', 'A new view', 'Again', 'Wrong pixels'];
    this.#place.replaceChildren(element('table', {},
      element('caption', {},
        `${name} at ${width} × ${height} pixels, in this browser: median times relative to the fastest, and pixels ` +
        'that show a polygon other than the one that exact arithmetic gives.'),
      element('thead', {}, element('tr', {}, ...columns.map((words) => element('th', { scope: 'col' }, words)))),
      element('tbody', {}, ...rows.map(line))));
  }
}
