// What stands beside the figure: choices, the view by buttons, and what is saved.
'use strict';

let controls_made = 0;

/** Choices of a picture; viewer.set(name, value) is told of each. */
function choice_controls(viewer) {
  const prefix = `viewer-${++controls_made}`;
  const select = (words, name, groups) => {
    const made = labelled_select(words, `${prefix}-${name}`, groups, (value) => viewer.set(name, value));
    viewer.shows(name, made);
    return made;
  };
  return element('fieldset', { class: 'choices' },
    element('legend', {}, 'Picture'),
    select('Method', 'method', kMethods),
    select('Precision', 'precision', kPrecisions),
    select('Lines', 'lines', kLines),
    select('Hidden lines', 'hiddenLines', kHiddenLines),
    select('Shading', 'shading', kShadings),
    select('Samples', 'samples', kSamples),
    select('Background', 'background', kBackgrounds));
}

/** Turning and zooming for who does not drag. */
function view_controls(viewer) {
  const button = (said, label, act) =>
    element('button', { type: 'button', 'aria-label': label, title: label, click: act }, said);
  const kStep = Math.PI / 12;
  const turn = (right, down) => () => { viewer.turn(right * kStep, down * kStep); viewer.rest(); };
  const zoom = (factor) => () => { viewer.zoom(factor, [0.5, 0.5]); viewer.rest(); };
  return element('div', { class: 'turning', role: 'group', 'aria-label': 'View' },
    button('←', 'turn to the left', turn(-1, 0)),
    button('→', 'turn to the right', turn(1, 0)),
    button('↑', 'turn up', turn(0, -1)),
    button('↓', 'turn down', turn(0, 1)),
    button('+', 'larger', zoom(1.25)),
    button('−', 'smaller', zoom(0.8)),
    button('Reset', 'Reset: the view of the drawing program', () => viewer.reset()));
}
