// Elements of the page, made by the scripts.
'use strict';

/** An element with its attributes, and what is in it: elements and texts. An attribute that is a
 *  function is a listener; one that is false is not there. */
function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') made.addEventListener(name, value);
    else if (value !== false && value !== undefined) made.setAttribute(name, value === true ? '' : value);
  }
  made.append(...children);
  return made;
}

/** A select with its label. The choices are [value, words], in groups where a name stands before
 *  them: [[undefined, [[value, words], ...]], ['Surfaces', [...]]]. */
function labelled_select(words, id, groups, changed) {
  const options = (choices) => choices.map(([value, said]) => element('option', { value }, said));
  const select = element('select', { id, change: () => changed(select.value) });
  for (const [name, choices] of groups) {
    select.append(...(name ? [element('optgroup', { label: name }, ...options(choices))] : options(choices)));
  }
  return element('label', { class: 'choice' }, element('span', {}, words), select);
}

/** Hands the bytes of a file to who looks at the page. */
function save_file(name, bytes, type) {
  const address = URL.createObjectURL(new Blob([bytes], { type }));
  const link = element('a', { href: address, download: name, hidden: true });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 60000);
}
