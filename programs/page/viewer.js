// The figure: a picture of a scene on a canvas, which is turned, picked at and saved.
'use strict';

const next_frame = () => new Promise((resolve) => requestAnimationFrame(resolve));

/** A picture that takes longer, in milliseconds, is drawn by another method while the figure turns. */
const kSlow = 120;
/** Milliseconds after which it is told that a picture is being drawn. */
const kPatience = 400;
/** Seconds that a picture may take: the worker does nothing else meanwhile. */
const kLongest = 30;
/** Milliseconds between the pictures of a screen that shows 60 a second. */
const kFrame = 1000 / 60;
const kMostPixels = 2048;

function greatest_common_divisor(a, b) {
  return b === 0 ? a : greatest_common_divisor(b, a % b);
}

class Viewer {
  /** What is shown: {name, program, mesh}. */
  given;
  /** The picture that is shown, as Engine.draw gave it. */
  picture;
  #shape;
  #settings = { samples: '' };
  #first_settings;
  #selects = new Map();
  #view;
  #middle;
  #pose = kAsDrawn;
  #turning = false;
  #wanted = false;
  #drawing;
  #slow = false;
  #resize;

  /** Fills `place`, in which the still may stand. Pictures have the shape of width and height. */
  constructor(place, drawer, { key = 'scene', width = 512, height = 512, settings = {} }) {
    this.drawer = drawer;
    this.key = key;
    this.#shape = [width, height];
    Object.assign(this.#settings, settings);
    this.#first_settings = { ...this.#settings };
    this.canvas = element('canvas', { tabindex: 0, role: 'application', 'aria-roledescription': 'figure' });
    this.marks = new Marks();
    this.status = element('p', { class: 'status', role: 'status' });
    this.caption = element('figcaption', {});
    this.command = element('code', { class: 'command' });
    const help = element('p', { class: 'help', id: `${key}-help` },
      'Drag or arrow keys rotate; the wheel after a click, pinching, + and − zoom; Shift with dragging or arrow keys, and ' +
      'two fingers, pan; 0 resets. A click picks, and so does P with the arrow keys, until Escape.');
    this.canvas.setAttribute('aria-describedby', help.id);
    const picture = element('div', { class: 'picture' }, this.canvas, this.marks.element);
    picture.style.setProperty('--shape', width / height);
    this.figure = element('figure', { class: 'figure' }, picture, this.caption, this.status);
    this.controls = element('div', { class: 'controls' }, view_controls(this),
      choice_controls(this), save_controls(this),
      element('p', { class: 'same' }, 'The command draws the same picture from the saved program:', this.command), help);
    place.replaceChildren(this.figure, this.controls);
    this.picker = new Picker(this);
    listen_to_gestures(this.canvas, this, this.picker);
    this.#resize = new ResizeObserver(() => this.#ask_for_picture());
    this.#resize.observe(picture);
  }

  /** Shows a scene, {name, program, mesh}. Rejects with what was Refused, and shows what it did. */
  async show(given, keeps_view = false) {
    const before = this.given;
    this.given = given;
    try {
      await this.#enter();
    } catch (refused) {
      if (this.given === given) this.given = before;
      throw refused;
    }
    if (!keeps_view) this.#pose = kAsDrawn;
    await this.redrawn();
    this.#label();
  }

  /** Shows nothing, where a scene that was chosen cannot be drawn. */
  clear(name) {
    this.given = undefined;
    this.picture = undefined;
    this.#view = undefined;
    this.why_not_turned = 'it is not drawn';
    this.picker.forget();
    this.canvas.getContext('2d').clearRect(0, 0, this.canvas.width, this.canvas.height);
    this.canvas.setAttribute('aria-label', `${name}: not drawn`);
    this.caption.textContent = `${name} · not drawn`;
    this.command.textContent = '';
  }

  async #enter() {
    const [width, height] = this.#shape;
    const { shading } = this.#settings;
    const given = { ...this.given, shading, lines: this.#lines(), aspect: width / height };
    const { view, middle, whyNot } = await this.drawer.ask('enter', { key: this.key, given });
    this.#view = view;
    this.#middle = middle;
    if (!view) this.#pose = kAsDrawn;
    this.why_not_turned = whyNot;
    this.canvas.classList.toggle('fixed', !view);
    this.#slow = false;
    this.picker.forget();
    this.say(whyNot ? `This scene cannot be rotated: ${whyNot}` : '');
    this.#offer_shading();
  }

  /** A method of lines draws the sides of a scene that shows none. */
  #lines() {
    const { lines, method } = this.#settings;
    if (lines || !kLineMethods.has(method) || !this.given) return lines;
    return this.given.mesh || draws_no_lines(this.given.program) ? 'all' : lines;
  }

  /** Shading is of lit scenes whose polygons have normals. */
  #offer_shading() {
    const { program, mesh } = this.given;
    const has_normals = mesh || /^\s*(set-vertex-normals|(cylinder|cone|sphere|torus|turn)-3)\b/m.test(program);
    this.#selects.get('shading').hidden = !(has_normals && calls(program, 'set-light'));
  }

  /** A control's select, which shows what is set. */
  shows(name, label) {
    this.#selects.set(name, label);
    const select = label.querySelector('select');
    const value = this.#settings[name] ?? '';
    if (value && ![...select.options].some((option) => option.value === value)) {
      select.append(element('option', { value }, value));
    }
    select.value = value;
  }

  /** What is set, in words: '' or none is what the program says. */
  get settings() {
    return this.#settings;
  }

  /** Whether another picture is shown than the program's own. */
  get is_changed() {
    const differs = ([name, value]) => name !== 'samples' && (value || '') !== (this.#first_settings[name] || '');
    return this.view !== null || Object.entries(this.#settings).some(differs);
  }

  async set(name, value) {
    const before = { ...this.#settings };
    const lines_before = this.#lines();
    this.#settings[name] = value;
    const is_entered_anew = this.given && (name === 'shading' || this.#lines() !== lines_before);
    try {
      if (is_entered_anew) await this.#enter();
      this.#slow = false;
      await this.redrawn();
    } catch (refused) {
      Object.assign(this.#settings, before);
      if (is_entered_anew) await this.#enter();
      this.#selects.get(name).querySelector('select').value = before[name] ?? '';
      this.say(refused.message);
    }
  }

  /** The picture's size: near to the screen's pixels, and of the very shape that was asked for, which
   *  decides what of a scene is in the picture. */
  get size() {
    const [width, height] = this.#shape;
    const both = greatest_common_divisor(width, height);
    const [columns, rows] = [width / both, height / both];
    const shown = (this.canvas.parentElement.clientWidth || width) * devicePixelRatio;
    const times = Math.max(1, Math.round(Math.min(kMostPixels, shown) / columns));
    return { width: times * columns, height: times * rows };
  }

  /** What is set, as options of the JavaScript API. */
  get options() {
    const { method, precision, hiddenLines, samples, background, scope } = this.#settings;
    const given = Object.entries({ method, precision, hiddenLines, scope }).filter(([, value]) => value);
    const options = { ...this.size, mostSeconds: kLongest, ...Object.fromEntries(given) };
    if (samples) options.samples = Number(samples);
    if (background) options.background = background === 'none' ? 'none' : background.split(' ').map(Number);
    return options;
  }

  /** The view that is shown; null: that of the drawing program. */
  get view() {
    return !this.#view || is_as_drawn(this.#pose) ? null : view_of(this.#view, this.#middle, this.#pose);
  }

  /** Views that follow it, as while turning. */
  views_after(count, degrees = 1) {
    if (!this.#view) return [];
    return Array.from({ length: count }, (_, k) =>
      view_of(this.#view, this.#middle, turned(this.#view, this.#pose, ((k + 1) * degrees * Math.PI) / 180, 0)));
  }

  // ---- Gestures ----

  #move(pose) {
    if (!this.#view) {
      this.say(`This scene cannot be rotated: ${this.why_not_turned}`);
      return;
    }
    this.#pose = pose(this.#view, this.#pose);
    this.#turning = true;
    this.marks.clear();
    this.#ask_for_picture();
  }
  turn(right, down) {
    this.#move((view, pose) => turned(view, pose, right, down));
  }
  pan(from, to) {
    this.#move((view, pose) => panned(view, pose, from, to));
  }
  zoom(factor, about) {
    this.#move((view, pose) => zoomed(view, pose, factor, about));
  }
  reset() {
    this.#move(() => kAsDrawn);
    this.rest();
  }
  /** What was moved has come to rest: it is drawn as it was asked for. */
  rest() {
    if (!this.#turning) return;
    this.#turning = false;
    this.#ask_for_picture();
  }

  // ---- Drawing ----

  #ask_for_picture() {
    if (!this.given) return;
    this.redrawn().catch((refused) => {
      this.say(refused.message);
      if (this.picture) this.#tell(this.picture, false);
    });
  }

  /** Draws what is wanted now, one picture at a time: the newest view after the one that is drawn. */
  redrawn() {
    if (!this.given) return Promise.resolve();
    this.#wanted = true;
    this.#drawing ??= this.#draw_while_wanted().finally(() => { this.#drawing = undefined; });
    return this.#drawing;
  }

  /** When what was asked for is drawn. */
  drawn() {
    return this.#drawing ?? Promise.resolve();
  }

  async #draw_while_wanted() {
    while (this.#wanted) {
      this.#wanted = false;
      const begin = performance.now();
      await this.#draw_once();
      // There is no use in more pictures than the screen shows.
      if (this.#wanted && performance.now() - begin < kFrame) await next_frame();
    }
  }

  async #draw_once() {
    const { options } = this;
    const is_quick = this.#turning && this.#is_replaceable(options);
    if (is_quick) options.method = 'z-buffer';
    if (this.#turning) options.samples = 1;
    const picture = await this.#while_busy(
      this.drawer.ask('draw', { key: this.key, view: this.view, options }));
    // N x N samples take at most N * N times as long as the one that is drawn while it turns.
    const samples = options.samples ?? kUsualSamples;
    if (!is_quick && picture.milliseconds > kSlow * samples ** 2) this.#slow = true;
    await this.#show_picture(picture);
    this.#tell(picture, is_quick);
  }

  /** What takes long is told, and so is its end. */
  async #while_busy(work) {
    const told = setTimeout(() => {
      this.caption.textContent = `${this.given.name} · drawing …`;
      this.canvas.setAttribute('aria-busy', 'true');
    }, kPatience);
    try {
      return await work;
    } finally {
      clearTimeout(told);
      this.canvas.removeAttribute('aria-busy');
    }
  }

  #is_replaceable({ method, precision }) {
    return this.#slow && kExactMethods.has(method) && (!precision || precision === 'exact');
  }

  async #show_picture(picture) {
    const { width, height, rgba, svg } = picture;
    const is_new_size = this.canvas.width !== width || this.canvas.height !== height;
    const context = this.canvas.getContext('2d');
    if (rgba) {
      if (is_new_size) Object.assign(this.canvas, { width, height });
      context.putImageData(new ImageData(rgba, width, height), 0, 0);
    } else {
      const image = new Image();
      image.src = `data:image/svg+xml,${encodeURIComponent(svg)}`;
      await image.decode();
      Object.assign(this.canvas, { width, height });
      context.drawImage(image, 0, 0, width, height);
    }
    this.picture = picture;
  }

  #tell({ width, height, milliseconds, svg }, is_quick) {
    const method = this.#settings.method ? words_of_method(this.#settings.method) : '';
    const words = [this.given.name, `${width} × ${height}`];
    if (method) words.push(is_quick ? `${method}, at rest` : method);
    words.push(svg ? 'drawn as SVG, since it has texts' : `${milliseconds < 10 ? milliseconds.toFixed(1) : Math.round(milliseconds)} ms`);
    this.caption.textContent = words.join(' · ');
    this.canvas.dataset.pictures = Number(this.canvas.dataset.pictures ?? 0) + 1;
    this.command.textContent = command_line(this);
    const drawn = this.#settings.method || own_method(this.given.program ?? '');
    const usual = this.#selects.get('samples').querySelector('option');
    usual.textContent = words_of_usual_samples(drawn);
  }

  async #label() {
    const { pieces, segments } = await this.drawer.ask('counts', { key: this.key });
    this.canvas.setAttribute('aria-label',
      `${this.given.name}: ${pieces} polygons and lines in ${segments} segment${segments === 1 ? '' : 's'}`);
  }

  say(words) {
    this.status.textContent = words;
  }
}
