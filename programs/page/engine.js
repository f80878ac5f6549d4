// What draws for the page, and answers its requests: in a worker, so that the page stays responsive.
'use strict';

/** The compiled program from its text in the page. */
function unpacked(base64) {
  return unpacked_lzma(Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)));
}

class Engine {
  #library;
  #scenes = new Map();
  #truths = new Map();

  /** Each request is an object with the name of the method that answers it, `what`. Errors are
   *  answers, too: {error: {message, line, column}}. */
  async answer(request) {
    try {
      return await this[request.what](request);
    } catch (error) {
      const { message, line, column } = error;
      return { error: { message, line, column } };
    }
  }

  async start({ wasm }) {
    this.#library = await displayfile.load({ wasm: unpacked(wasm) });
    const { version, routines } = this.#library;
    return { version, routines };
  }

  /** Takes the place of the scene of the same key, which stays if there is an error. Answers with the view
   *  to turn and the point to turn about, or with why it is not turned. */
  enter({ key, given }) {
    const scene = new Scene(this.#library, given);
    this.#scenes.get(key)?.free();
    this.#scenes.set(key, scene);
    this.#truths.clear();
    return scene.view_and_box();
  }

  draw({ key, view, options }) {
    const begin = performance.now();
    const picture = this.#scenes.get(key).picture(view, options);
    return { ...picture, milliseconds: performance.now() - begin };
  }

  svg({ key, view, options }) {
    return { svg: this.#scenes.get(key).svg(view, options) };
  }

  steps({ key, view, options }) {
    return { steps: this.#scenes.get(key).steps(view, options) };
  }

  pick({ key, view, options, at }) {
    return { seen: this.#scenes.get(key).pick(view, options, at) };
  }

  counts({ key }) {
    return this.#scenes.get(key).counts();
  }

  save({ key, view, options, settings }) {
    return this.#scenes.get(key).saved(view, options, settings);
  }

  #truth(key, view, { width, height }) {
    const name = JSON.stringify([key, view, width, height]);
    if (!this.#truths.has(name)) {
      this.#truths.clear();
      this.#truths.set(name, this.#scenes.get(key).truth(view, { width, height }));
    }
    return this.#truths.get(name);
  }

  time({ key, view, options, views, least }) {
    return drawing_times(this.#scenes.get(key), view, options, views, least);
  }

  wrong({ key, view, options }) {
    const picture = this.#scenes.get(key).picture(view, { ...options, ids: true });
    return { ...picture, wrong: wrong_pixels(picture.ids, this.#truth(key, view, options)) };
  }
}

/** Answers requests in their order; the worker calls it. */
function serve_requests(port) {
  const engine = new Engine();
  port.onmessage = async ({ data: { number, request } }) => {
    const answer = await engine.answer(request);
    const handed = [answer.rgba, answer.ids].filter(Boolean).map(({ buffer }) => buffer);
    port.postMessage({ number, answer }, handed);
  };
}
