// Mouse, fingers and keys on the figure, as turning, zooming and panning.
'use strict';

/** Half a turn over the figure's smaller side. */
const kTurnAcross = Math.PI;
const kTurnOfKey = Math.PI / 36;
const kZoomOfKey = 1.2;
const kPanOfKey = 0.05;
/** Pixels that a press may move and still be a click. */
const kStill = 4;

/** Tells of what is done to `place`: figure.turn(right, down) in radians, figure.pan(from, to) and
 *  figure.zoom(factor, about) in parts of the picture, figure.rest() when that ends, figure.reset();
 *  and what a Picker is told. */
function listen_to_gestures(place, figure, picker) {
  const fingers = new Map();
  let moved = 0, turns = false;

  const in_parts = ({ clientX, clientY }) => {
    const { left, top, width, height } = place.getBoundingClientRect();
    return [(clientX - left) / width, (clientY - top) / height];
  };

  place.addEventListener('pointerdown', (event) => {
    if (event.button > 1) return;
    place.setPointerCapture(event.pointerId);
    if (fingers.size === 0) moved = 0;
    turns = event.button === 0 && !event.shiftKey;
    fingers.set(event.pointerId, { at: in_parts(event), x: event.clientX, y: event.clientY });
  });

  place.addEventListener('pointermove', (event) => {
    const finger = fingers.get(event.pointerId);
    if (!finger) return;
    const before = { ...finger };
    Object.assign(finger, { at: in_parts(event), x: event.clientX, y: event.clientY });
    const [dx, dy] = [finger.x - before.x, finger.y - before.y];
    moved += Math.hypot(dx, dy);
    if (moved < kStill) return;
    if (fingers.size === 2) {
      const [other] = [...fingers.values()].filter((one) => one !== finger);
      pinch(before, finger, other);
    } else if (turns) {
      const { width, height } = place.getBoundingClientRect();
      const angle = kTurnAcross / Math.min(width, height);
      figure.turn(dx * angle, dy * angle);
    } else {
      figure.pan(before.at, finger.at);
    }
  });

  function pinch(before, after, other) {
    const middle = (a) => [(a.at[0] + other.at[0]) / 2, (a.at[1] + other.at[1]) / 2];
    const apart = (a) => Math.max(1, Math.hypot(a.x - other.x, a.y - other.y));
    figure.pan(middle(before), middle(after));
    figure.zoom(apart(after) / apart(before), middle(after));
  }

  const let_go = (event) => {
    if (!fingers.delete(event.pointerId) || fingers.size > 0) return;
    if (event.type === 'pointerup' && moved < kStill) picker.press(in_parts(event));
    else figure.rest();
  };
  place.addEventListener('pointerup', let_go);
  place.addEventListener('pointercancel', let_go);

  let wheel_ends;
  place.addEventListener('wheel', (event) => {
    // A page that is scrolled past the figure goes on scrolling.
    if (!event.ctrlKey && document.activeElement !== place) return;
    event.preventDefault();
    figure.zoom(2 ** (-event.deltaY / (event.deltaMode === 0 ? 240 : 8)), in_parts(event));
    clearTimeout(wheel_ends);
    wheel_ends = setTimeout(() => figure.rest(), 200);
  }, { passive: false });

  const kArrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  place.addEventListener('keydown', (event) => {
    if (event.altKey || event.metaKey || event.ctrlKey) return;
    const arrow = kArrows[event.key];
    if (arrow && picker.has_cross) picker.move(...arrow.map((x) => x * (event.shiftKey ? 0.002 : 0.02)));
    else if (arrow && event.shiftKey) figure.pan([0.5, 0.5], arrow.map((x) => 0.5 + x * kPanOfKey));
    else if (arrow) figure.turn(...arrow.map((x) => x * kTurnOfKey));
    else if (event.key === '+' || event.key === '=') figure.zoom(kZoomOfKey, [0.5, 0.5]);
    else if (event.key === '-') figure.zoom(1 / kZoomOfKey, [0.5, 0.5]);
    else if (event.key === '0') figure.reset();
    else if (event.key.toLowerCase() === 'p') picker.move(0, 0);
    else if (event.key === 'Escape') picker.forget();
    else return;
    event.preventDefault();
  });
  place.addEventListener('keyup', (event) => {
    if (kArrows[event.key] || event.key === '+' || event.key === '-') figure.rest();
  });
}
