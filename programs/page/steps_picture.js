'use strict';

/** The picture so far in pixels, and over it outlines, names, lines and what the step points at. */
class StepsPicture {
  constructor(story, canvas, overlay) {
    this.story = story;
    this.canvas = canvas;
    this.overlay = overlay;
    canvas.width = story.width;
    canvas.height = story.height;
    this.colours = story.data.polygons.map((polygon) => StepsPicture.rgba(polygon.colour));
    this.background = StepsPicture.rgba(story.data.background);
    this.side = 1000;  // of the unit square in the overlay
    overlay.setAttribute('viewBox', `0 0 ${this.side} ${this.side}`);
    this.outlineGroup = this.outlines();
    // The outlines of many polygons would darken all of the picture.
    this.outlineGroup.setAttribute('opacity', String(Math.min(1, 10 / Math.sqrt(story.data.polygons.length + 1))));
    this.lineGroup = this.group('drawn-lines', []);
    this.stayGroup = this.group('stays', []);
    this.changing = this.group('changing', []);
    overlay.replaceChildren(this.outlineGroup, this.stayGroup, this.lineGroup, this.changing);
  }

  static rgba(hex) {
    const n = parseInt(hex.slice(1), 16);
    return [n >> 16, (n >> 8) & 255, n & 255, 255];
  }

  show(at, {outlines, names}) {
    this.ids = this.story.picture(at);
    this.showPixels();
    this.outlineGroup.style.display = outlines ? '' : 'none';
    this.showUntil(this.lineGroup, at < 0 ? 0 : this.story.linesUntil[at], (k) => this.line(this.story.lines[k]));
    this.showUntil(this.stayGroup, at < 0 ? 0 : this.story.staysUntil[at], (k) => this.mark(this.story.stays[k]));
    this.changing.replaceChildren(this.marks(at), ...(names ? [this.names(at)] : []));
  }

  /** Makes a group hold so many elements, of those that never change. */
  showUntil(group, count, element) {
    while (group.childElementCount > count) group.lastChild.remove();
    for (let k = group.childElementCount; k < count; ++k) group.append(element(k));
  }

  showPixels() {
    const image = new ImageData(this.story.width, this.story.height);
    this.ids.forEach((polygon, k) => {
      image.data.set(polygon < 0 ? this.background : this.colours[polygon], 4 * k);
    });
    this.canvas.getContext('2d').putImageData(image, 0, 0);
  }

  /** In words: how many pixels each polygon is seen in. */
  described() {
    const counts = new Map();
    for (const polygon of this.ids) counts.set(polygon, (counts.get(polygon) || 0) + 1);
    const seen = [...counts].filter(([polygon]) => polygon >= 0).sort((a, b) => a[0] - b[0]);
    const shown = seen.map(([polygon, n]) => `${this.story.nameOf(polygon)} ${n}`);
    return shown.length ? `The picture so far, in pixels: ${shown.join(', ')}`
                        : 'The picture so far: nothing is painted';
  }

  static element(name, attributes, text) {
    const made = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    if (text !== undefined) made.textContent = text;
    return made;
  }

  group(name, children) {
    const group = StepsPicture.element('g', {class: name});
    group.append(...children);
    return group;
  }

  x(unit) { return +(unit * this.side).toFixed(2); }
  y(unit) { return +((1 - unit) * this.side).toFixed(2); }

  path(points, step, closed) {
    let d = '';
    for (let k = 0; k + 1 < points.length; k += step) {
      d += `${k === 0 ? 'M' : 'L'}${this.x(points[k])} ${this.y(points[k + 1])}`;
    }
    return closed ? d + 'Z' : d;
  }

  outlineOf(piece, attributes) {
    const points = this.story.data.pieces[piece].points;
    const closed = this.story.data.polygons[this.story.data.pieces[piece].polygon].kind !== 'line';
    return StepsPicture.element('path', {d: this.path(points, 3, closed), ...attributes});
  }

  outlines() {
    const all = this.story.data.polygons.map((_, piece) => this.outlineOf(piece, {}));
    return this.group('outlines', all);
  }

  line([, hidden, x0, y0, x1, y1]) {
    return StepsPicture.element('path', {
      d: this.path([x0, y0, x1, y1], 2, false),
      class: hidden ? 'line-hidden' : 'line-seen',
    });
  }

  marks(at) {
    const marks = at < 0 ? [] : this.story.steps[at].marks || [];
    return this.group('step-marks', marks.map((mark) => this.mark(mark)));
  }

  mark([kind, role, ...rest]) {
    if (kind === 'piece') return this.outlineOf(rest[0], {class: `mark-piece role-${role}`});
    if (kind === 'line') {
      return StepsPicture.element('path', {d: this.path(rest, 2, false), class: `mark-line role-${role}`});
    }
    if (kind === 'points') {
      let d = '';
      for (let k = 0; k + 1 < rest.length; k += 2) d += `M${this.x(rest[k])} ${this.y(rest[k + 1])}h0`;
      return StepsPicture.element('path', {d, class: `mark-points role-${role}`});
    }
    const [left, right, bottom, top] = rest;
    const {width, height} = this.story;
    return StepsPicture.element('rect', {
      x: this.x(left / width),
      y: this.y(top / height),
      width: this.x((right - left) / width),
      height: this.x((top - bottom) / height),
      class: `mark-box role-${role}`,
    });
  }

  /** The names of the pieces that the step marks, or before the first step of all polygons. */
  names(at) {
    const marked = at < 0 ? [] : (this.story.steps[at].marks || []).filter(([kind]) => kind === 'piece');
    const all = this.story.data.polygons.map((_, piece) => piece);
    const pieces = at < 0 && all.length <= 40 ? all : marked.map((mark) => mark[2]);
    return this.group('names', [...new Set(pieces)].map((piece) => {
      const [x, y] = this.middle(this.story.data.pieces[piece].points);
      return StepsPicture.element('text', {x: this.x(x), y: this.y(y)}, this.story.nameOf(piece));
    }));
  }

  /** A place well inside of the piece: its centroid, or for what has no area the mean. */
  middle(points) {
    let area = 0, cx = 0, cy = 0, mx = 0, my = 0;
    const n = points.length / 3;
    for (let k = 0; k < n; ++k) {
      const [x0, y0] = [points[3 * k], points[3 * k + 1]];
      const next = 3 * ((k + 1) % n);
      const [x1, y1] = [points[next], points[next + 1]];
      const cross = x0 * y1 - x1 * y0;
      area += cross;
      cx += (x0 + x1) * cross;
      cy += (y0 + y1) * cross;
      mx += x0 / n;
      my += y0 / n;
    }
    const inside = Math.abs(area) > 1e-9 ? [cx / (3 * area), cy / (3 * area)] : [mx, my];
    return inside.map((c) => Math.min(Math.max(c, 0.03), 0.97));
  }
}
