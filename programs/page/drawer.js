// The page's end of what draws (engine.js). All scripts that stand in the page before this one run in
// the worker, too: a page from disk cannot load a worker from a file, but from its own text.
'use strict';

const kWorkerScripts = [...document.scripts]
  .filter((script) => script.type === '' && script !== document.currentScript)
  .map(({ text }) => text);

/** What was refused, with its line and column where there are any. */
class Refused extends Error {
  constructor({ message, line, column }) {
    super(message);
    Object.assign(this, { line, column });
  }
}

class Drawer {
  #waiting = new Map();
  #numbers = 0;
  #send;

  constructor() {
    try {
      const text = [...kWorkerScripts, 'serve_requests(self);'].join('\n');
      const worker = new Worker(URL.createObjectURL(new Blob([text], { type: 'text/javascript' })));
      worker.onmessage = ({ data: { number, answer } }) => this.#settle(number, answer);
      worker.onerror = (event) => this.#fail(event.message || 'the worker does not run');
      this.#send = (number, request) => worker.postMessage({ number, request });
    } catch {
      // Where no worker may be started, the page draws itself.
      const engine = new Engine();
      this.#send = async (number, request) => this.#settle(number, await engine.answer(request));
    }
  }

  #settle(number, answer) {
    const { resolve, reject } = this.#waiting.get(number);
    this.#waiting.delete(number);
    if (answer.error) reject(new Refused(answer.error));
    else resolve(answer);
  }

  #fail(message) {
    for (const { reject } of this.#waiting.values()) reject(new Refused({ message }));
    this.#waiting.clear();
  }

  /** The answer of Engine's method `what`; rejects with what was Refused. */
  ask(what, request = {}) {
    const number = this.#numbers++;
    return new Promise((resolve, reject) => {
      this.#waiting.set(number, { resolve, reject });
      this.#send(number, { what, ...request });
    });
  }
}
