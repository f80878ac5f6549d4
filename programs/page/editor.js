// An editor for drawing programs: a text area with line numbers, the place of an error, and what the
// routine on the caret's line takes.
'use strict';

/** After so many milliseconds without a key the program is drawn. */
const kPause = 250;

class Editor {
  #text;
  #numbers;
  #behind;
  #error;
  #hint;
  #routines = new Map();
  #pause;
  #shown_error;

  /** Fills `place`; changed(text) is called after each change that was typed. */
  constructor(place, changed) {
    this.#numbers = element('div', { class: 'numbers', 'aria-hidden': 'true' });
    this.#behind = element('pre', { class: 'behind', 'aria-hidden': 'true' });
    this.#text = element('textarea', {
      id: 'program', spellcheck: 'false', autocapitalize: 'off', autocomplete: 'off', wrap: 'off',
      'aria-describedby': 'program-error program-hint',
      input: () => this.#typed(changed),
      scroll: () => this.#scrolled(),
      keydown: (event) => this.#tab(event),
    });
    this.#error = element('p', { class: 'error', id: 'program-error', role: 'alert' });
    this.#hint = element('p', { class: 'hint', id: 'program-hint' });
    document.addEventListener('selectionchange', () => this.#show_hint());
    place.replaceChildren(
      element('label', { for: 'program', class: 'visually-hidden' }, 'Drawing program'),
      element('div', { class: 'editor' }, this.#numbers,
        element('div', { class: 'text' }, this.#behind, this.#text)),
      this.#error, this.#hint);
    new ResizeObserver(() => this.#scrolled()).observe(this.#text);
  }

  /** The user routines, {name, arguments}, for the hint: without how many arguments there are. */
  set routines(routines) {
    const without_numbers = (words) => words.replace(/(^|, or )(\d|a multiple)[^:,]*: /g, '$1');
    this.#routines = new Map(routines.map((routine) => [routine.name, without_numbers(routine.arguments)]));
  }

  get text() {
    return this.#text.value;
  }
  set text(text) {
    clearTimeout(this.#pause);
    this.#text.value = text;
    this.#text.scrollTo(0, 0);
    this.show_error(undefined);
  }

  #typed(changed) {
    this.#number();
    clearTimeout(this.#pause);
    this.#pause = setTimeout(() => changed(this.text), kPause);
  }

  /** Tab leaves the editor, as it leaves all else; Enter keeps the line's indentation. */
  #tab(event) {
    if (event.key !== 'Enter' || event.ctrlKey || event.metaKey) return;
    const { value, selectionStart } = this.#text;
    const line = value.slice(value.lastIndexOf('\n', selectionStart - 1) + 1, selectionStart);
    const [indentation] = /^[ \t]*/.exec(line);
    if (indentation === '') return;
    event.preventDefault();
    document.execCommand('insertText', false, `\n${indentation}`);
  }

  /** What was refused, {message, line, column}; undefined: nothing. */
  show_error(refused) {
    this.#shown_error = refused;
    this.#error.textContent = refused ? refused.message : '';
    this.#text.setAttribute('aria-invalid', refused ? 'true' : 'false');
    this.#number();
    this.#mark_place();
    if (refused?.line) this.#scroll_to(refused.line);
  }

  #number() {
    const count = this.text.split('\n').length;
    const wrong = this.#shown_error?.line;
    const numbers = Array.from({ length: count }, (_, k) => String(k + 1));
    const before = numbers.slice(0, wrong ? wrong - 1 : count).join('\n');
    const parts = wrong && wrong <= count
      ? [before && `${before}\n`, element('b', {}, String(wrong)), `\n${numbers.slice(wrong).join('\n')}`]
      : [before];
    this.#numbers.replaceChildren(element('div', { style: 'white-space: pre' }, ...parts));
    this.#scrolled();
  }

  /** The line that is wrong, and the word in it: the text once more, behind the text. */
  #mark_place() {
    const { line, column } = this.#shown_error ?? {};
    if (!line) {
      this.#behind.replaceChildren();
      return;
    }
    const lines = this.text.split('\n');
    const wrong = lines[line - 1] ?? '';
    // Columns are counted in characters of Unicode, from 1.
    const before = column ? [...wrong].slice(0, column - 1).join('') : wrong;
    const [word] = /^\S*/.exec(wrong.slice(before.length));
    const marked = element('span', { class: 'line' }, before,
      element('span', { class: 'place' }, word || (column ? ' ' : '')), wrong.slice(before.length + word.length));
    this.#behind.replaceChildren('\n'.repeat(line - 1), marked, '\n'.repeat(Math.max(1, lines.length - line)));
    this.#scrolled();
  }

  #scroll_to(line) {
    const height = parseFloat(getComputedStyle(this.#text).lineHeight);
    const top = (line - 1) * height;
    const { scrollTop, clientHeight } = this.#text;
    if (top < scrollTop || top > scrollTop + clientHeight - 2 * height) {
      this.#text.scrollTop = Math.max(0, top - clientHeight / 3);
    }
  }

  #scrolled() {
    this.#numbers.scrollTop = this.#text.scrollTop;
    this.#behind.scrollTop = this.#text.scrollTop;
    this.#behind.scrollLeft = this.#text.scrollLeft;
  }

  #show_hint() {
    if (document.activeElement !== this.#text) return;
    const { value, selectionStart } = this.#text;
    const begin = value.lastIndexOf('\n', selectionStart - 1) + 1;
    const routine = routine_of(value.slice(begin).split('\n', 1)[0]);
    const takes = this.#routines.get(routine);
    this.#hint.textContent = takes === undefined ? '' : `${routine} ${takes}`.trim();
  }
}
