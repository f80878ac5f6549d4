// A view that is turned about a point, zoomed and shifted: view.md.
'use strict';

/** How the figure stands: turned by a quaternion [w, x, y, z] as the world sees it, its window made
 *  smaller by `zoom`, and shifted, in view-plane coordinates. */
const kAsDrawn = Object.freeze({ turn: Object.freeze([1, 0, 0, 0]), zoom: 1, shift: Object.freeze([0, 0]) });

const is_as_drawn = ({ turn, zoom, shift }) =>
  turn[1] === 0 && turn[2] === 0 && turn[3] === 0 && zoom === 1 && shift[0] === 0 && shift[1] === 0;

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (a, s) => a.map((x) => x * s);
const sum = (a, b) => a.map((x, k) => x + b[k]);
const difference = (a, b) => a.map((x, k) => x - b[k]);
const of_length_1 = (a) => scaled(a, 1 / Math.hypot(...a));

function quaternion(axis, angle) {
  return [Math.cos(angle / 2), ...scaled(of_length_1(axis), Math.sin(angle / 2))];
}
/** The rotation that is first b, then a. */
function after(a, b) {
  const [p, q] = [a.slice(1), b.slice(1)];
  return of_length_1([a[0] * b[0] - dot(p, q), ...sum(sum(scaled(q, a[0]), scaled(p, b[0])), cross(p, q))]);
}
function rotated([w, ...axis], vector) {
  const t = scaled(cross(axis, vector), 2);
  return sum(sum(vector, scaled(t, w)), cross(axis, t));
}

/** Nine digits are more than is seen, and fewer than a drawing program should have to show. */
const rounded = (numbers) => numbers.map((x) => Number(x.toPrecision(9)) + 0);

/** The viewer's right, up and back in world coordinates, each of length 1. */
function axes_of(view) {
  const back = of_length_1(scaled(view.planeNormal, -1));
  const right = of_length_1(cross(view.up, back));
  return { right, up: cross(back, right), back };
}

/** The view in which the figure stands so, whose own view is `base`, about the point `middle`. What
 *  turns is the view, the other way: the world and its lights stay. */
function view_of(base, middle, { turn, zoom, shift }) {
  const [w, x, y, z] = turn;
  const back = [w, -x, -y, -z];
  const is_turned = x !== 0 || y !== 0 || z !== 0;
  const vector = (a) => (is_turned ? rounded(rotated(back, a)) : a);
  const point = (a) => (is_turned ? rounded(sum(middle, rotated(back, difference(a, middle)))) : a);
  const [xmin, xmax, ymin, ymax] = base.window;
  const centre = [(xmin + xmax) / 2 + shift[0], (ymin + ymax) / 2 + shift[1]];
  const half = [(xmax - xmin) / 2 / zoom, (ymax - ymin) / 2 / zoom];
  const window = zoom === 1 && shift[0] === 0 && shift[1] === 0
    ? base.window
    : rounded([centre[0] - half[0], centre[0] + half[0], centre[1] - half[1], centre[1] + half[1]]);
  return {
    ...base,
    referencePoint: point(base.referencePoint),
    planeNormal: vector(base.planeNormal),
    up: vector(base.up),
    projection: base.perspective ? point(base.projection) : vector(base.projection),
    window,
  };
}

/** Turned on by angles in radians: what is in front goes to the right, and down. About the axis that
 *  is up in the figure's own view, so that it does not fall over, and about the viewer's right. */
function turned(base, pose, to_right, down) {
  const { right } = axes_of(base);
  const upright = quaternion(rotated(pose.turn, base.up), to_right);
  return { ...pose, turn: after(quaternion(right, down), after(upright, pose.turn)) };
}

/** A place in the picture, from its upper left corner in parts of its width and height, in
 *  view-plane coordinates of the view that the pose shows. */
function in_window(base, pose, [x, y]) {
  const [left, right, bottom, top] = base.viewport;
  const [xmin, xmax, ymin, ymax] = base.window;
  const u = (x - left) / (right - left) - 0.5, v = (1 - y - bottom) / (top - bottom) - 0.5;
  return [
    (xmin + xmax) / 2 + pose.shift[0] + (u * (xmax - xmin)) / pose.zoom,
    (ymin + ymax) / 2 + pose.shift[1] + (v * (ymax - ymin)) / pose.zoom,
  ];
}

/** What is seen at the place `from` goes to `to`, in parts of the picture. */
function panned(base, pose, from, to) {
  const moved = difference(in_window(base, pose, from), in_window(base, pose, to));
  return { ...pose, shift: sum(pose.shift, moved) };
}

/** Larger by a factor, about a place that stays where it is. */
function zoomed(base, pose, factor, about = [0.5, 0.5]) {
  const zoom = Math.min(1e4, Math.max(1e-2, pose.zoom * factor));
  const larger = { ...pose, zoom };
  const moved = difference(in_window(base, pose, about), in_window(base, larger, about));
  return { ...larger, shift: sum(pose.shift, moved) };
}
