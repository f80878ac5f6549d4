// How a method finds what is seen in the scene that is shown: the page that `displayfile steps` writes
// of it, in a frame, and to be saved.
'use strict';

const kStepped = [[undefined, [['bsp', 'BSP tree'], ['depth-sort', 'depth sort'], ['warnock', 'Warnock'],
  ['scan-line', 'scan line'], ['scan-line-z', 'scan-line z-buffer'], ['z-buffer', 'z-buffer'],
  ['ray-cast', 'ray casting'], ['franklin', 'Franklin'], ['roberts', 'Roberts'], ['appel', 'Appel'],
  ['perimeter', 'perimeter, of one surface']]]];
const kSteppedSides = [[undefined, [16, 32, 64, 128].map((side) => [String(side), `${side} in a row`])]];

/** The page of steps with its data, from the template, which is that page without any. */
function page_of_steps(template, title, json) {
  const before = '<script type="application/json" id="data">';
  const escaped = title.replace(/&/g, '&amp;').replace(/</g, '&lt;');
  return template
    .replace(`${before}{}`, () => before + json.replace(/</g, '\\u003c'))
    .replace(/<title>[^<]*/, () => `<title>${escaped}`);
}

class StepByStep {
  #viewer;
  #template;
  #method = 'bsp';
  #side = '64';
  #status;
  #place;
  #address;

  constructor(place, viewer, template) {
    this.#viewer = viewer;
    this.#template = template;
    this.#status = element('p', { class: 'status', role: 'status' });
    this.#place = element('div', {});
    const method = labelled_select('Method', 'stepped', kStepped, (value) => { this.#method = value; });
    const side = labelled_select('Pixels', 'stepped-side', kSteppedSides, (value) => { this.#side = value; });
    side.querySelector('select').value = this.#side;
    const button = (words, act, kind) => element('button', { type: 'button', class: kind, click: act }, words);
    place.replaceChildren(
      element('div', { class: 'row' }, method, side,
        button('Watch', () => this.#watch(), 'first'), button('Save as a page', () => this.#save())),
      this.#status, this.#place);
  }

  /** Another scene is shown. */
  clear() {
    this.#status.textContent = '';
    this.#place.replaceChildren();
    if (this.#address) URL.revokeObjectURL(this.#address);
    this.#address = undefined;
  }

  /** The page; undefined, and it is told why, if there is none. */
  async #page() {
    const { drawer, key, view, given, size } = this.#viewer;
    if (!given) return undefined;
    const width = Number(this.#side), height = Math.max(1, Math.round((width * size.height) / size.width));
    this.#status.textContent = 'Computing the steps …';
    try {
      const { steps } = await drawer.ask('steps', { key, view, options: { method: this.#method, width, height } });
      this.#status.textContent = '';
      return page_of_steps(this.#template, given.name, steps);
    } catch (refused) {
      this.#status.textContent = refused.message;
      return undefined;
    }
  }

  async #watch() {
    this.clear();
    const page = await this.#page();
    if (!page) return;
    this.#address = URL.createObjectURL(new Blob([page], { type: 'text/html' }));
    const title = `${this.#viewer.given.name}, step by step`;
    const frame = element('iframe', { class: 'steps', src: this.#address, title });
    this.#place.replaceChildren(frame);
    frame.addEventListener('load', () => frame.contentWindow.focus());
  }

  async #save() {
    const page = await this.#page();
    if (page) save_file(`${this.#viewer.given.name.replace(/\.[a-z]+$/i, '')}-${this.#method}.html`, page, 'text/html');
  }
}
