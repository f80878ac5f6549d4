// The text of a drawing program with some of its lines replaced: what the viewer sets, and the view.
// The program that is saved is made here, and so is the one that is drawn.
'use strict';

const kViewRoutines = new Set(['set-view-reference-point', 'set-view-plane-normal', 'set-view-distance',
  'set-view-up', 'set-parallel', 'set-perspective', 'set-view-depth', 'set-front-plane-clipping',
  'set-back-plane-clipping', 'set-window', 'set-viewport']);

/** The routine that a line calls; undefined if it calls none. */
function routine_of(line) {
  const found = /^\s*([a-z][a-z0-9-]*)/.exec(line);
  return found ? found[1] : undefined;
}

/** Whether any line calls it. */
function calls(text, routine) {
  return new RegExp(`^[ \\t]*${routine}(?![a-z0-9-])`, 'm').test(text);
}

/** The hidden-surface method that a program's pictures have by its last calls; '' if it sets none. */
function own_method(text) {
  const last = (routine) =>
    [...text.matchAll(new RegExp(`^[ \\t]*${routine}[ \\t]+([a-z0-9=-]+)`, 'gm'))].at(-1)?.[1];
  if (last('set-z-buffer') === 'on') return 'z-buffer';
  return last('set-hidden-line-removal') === 'on' ? last('set-hidden-method') ?? '' : '';
}

/** The program without the lines that call these, and with others before its first segment. */
function replaced(text, is_left_out, lines) {
  const kept = text.split('\n').filter((line) => !is_left_out.has(routine_of(line)));
  const first = kept.findIndex((line) => routine_of(line) === 'open-segment');
  kept.splice(first < 0 ? kept.length : first, 0, ...lines);
  return kept.join('\n');
}

/** What the viewer may set and the program says, too, in lines that take the place of the program's:
 *  shading ("flat", "gouraud", "phong"), and the kinds of lines ("none", or words of set-lines). */
function with_settings(text, { shading, lines }) {
  let result = text;
  // They stand first: what is modelled before the first segment may be lit, too.
  if (shading) result = `set-shading ${shading}\n${replaced(result, new Set(['set-shading']), [])}`;
  if (lines === 'none') {
    result = `set-line-style none\n${replaced(result, new Set(['set-line-style', 'set-lines']), [])}`;
  } else if (lines) {
    const drawn = result.replace(/^([ \t]*set-line-style[ \t]+)none\b/gm, '$1solid 0 0 0');
    result = `set-lines ${lines}\n${replaced(drawn, new Set(['set-lines']), [])}`;
  }
  return result;
}

/** Whether all lines that the program draws are invisible: what it says after its last segment, such as
 *  the usual styles again, draws nothing. */
function draws_no_lines(text) {
  const drawing = text.slice(0, text.lastIndexOf('\nclose-segment'));
  const styles = [...drawing.matchAll(/^[ \t]*set-line-style[ \t]+([a-z]+)/gm)];
  const first_segment = drawing.search(/^[ \t]*open-segment/m);
  return styles.length > 0 && styles[0].index < first_segment && styles.every(([, kind]) => kind === 'none');
}

const on_or_off = (is_on) => (is_on ? 'on' : 'off');

/** The routines that set a view. */
function lines_of_view(view) {
  const numbers = (values) => values.map((x) => (Object.is(x, -0) ? '0' : String(x))).join(' ');
  return [
    `set-view-reference-point ${numbers(view.referencePoint)}`,
    `set-view-plane-normal ${numbers(view.planeNormal)}`,
    `set-view-distance ${numbers([view.distance])}`,
    `set-view-up ${numbers(view.up)}`,
    `${view.perspective ? 'set-perspective' : 'set-parallel'} ${numbers(view.projection)}`,
    `set-view-depth ${numbers([view.front, view.back])}`,
    `set-front-plane-clipping ${on_or_off(view.frontClipping)}`,
    `set-back-plane-clipping ${on_or_off(view.backClipping)}`,
    `set-window ${numbers(view.window)}`,
    `set-viewport ${numbers(view.viewport)}`,
  ];
}

/** The program in another view. A window that a program does not set is widened, one that it sets is
 *  not, unless it says so: the one that is set here is as the program's was. */
function in_view(text, view) {
  const lines = lines_of_view(view);
  const sets_window = calls(text, 'set-window') || calls(text, 'set-viewport');
  if (!sets_window && !calls(text, 'set-window-fit')) lines.push('set-window-fit widen');
  return replaced(text, kViewRoutines, lines);
}

/** The program with what was chosen of hidden surfaces for a picture: a method that is chosen so orders
 *  all segments together, unless the program says otherwise. */
function with_hidden_surfaces(text, { method, precision, scope, hiddenLines, background }) {
  const left_out = new Set(), lines = [];
  let at_end = '';
  if (method) {
    for (const routine of ['set-hidden-method', 'set-z-buffer']) left_out.add(routine);
    lines.push(`set-hidden-method ${method}`);
    if (!scope && !calls(text, 'set-hidden-scope')) lines.push('set-hidden-scope all');
    // After the last segment, where it removes no back faces from what was entered.
    at_end = 'set-hidden-line-removal on\n';
  }
  const set = (routine, words) => {
    if (!words) return;
    left_out.add(routine);
    lines.push(`${routine} ${words}`);
  };
  set('set-precision', precision);
  set('set-hidden-scope', scope);
  set('set-hidden-lines', hiddenLines);
  set('set-background', background);
  const result = replaced(text, left_out, lines);
  return at_end === '' ? result : `${result.replace(/\n*$/, '\n')}${at_end}`;
}
