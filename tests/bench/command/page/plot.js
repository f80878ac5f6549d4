"use strict";
// Plots in SVG: curves and marks on logarithmic axes, and a map of percentages.

const escaped = (text) => String(text).replace(/[&<>"']/g, (c) =>
  ({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;"})[c]);
const px = (x) => x.toFixed(1);

// Distinct also for most who do not see all colours.
const COLOURS = {
  none: "#7f7f7f", "z-buffer": "#1f5fbf", "plain-z-buffer": "#e08a00", bsp: "#1f8f3f", "depth-sort": "#c92a2a",
  "scan-line": "#7b3fb5", "scan-line-z": "#8c5a2b", warnock: "#d6489a", "ray-cast": "#0f9aa8", osmesa: "#111111",
  auto: "#8fce00", embree: "#b8a000", gl2ps: "#ff6f61", roberts: "#1f5fbf", appel: "#e08a00", franklin: "#c92a2a",
  map: "#3a4a9f"};
const SHAPES = ["m-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0z", "m-3.5 -3.5h7v7h-7z", "m0 -5l5 5l-5 5l-5 -5z", "m0 -5l4.5 8h-9z",
                "m0 5l4.5 -8h-9z", "m-4 -4l8 8m0 -8l-8 8", "m-5 0h10m-5 -5v10", "m-2 -5h4v10h-4z"];

/** A column's mark in plots of all columns: the colour is the method's, the shape the precision's; exact ones are
 * filled. */
function markOf(all, column) {
  const own = all.filter((other) => other.method === column.method);
  return {colour: COLOURS[column.method] ?? "#556b2f", shape: own.findIndex((other) => other.name === column.name),
          filled: column.exact || !column.precision};
}
const marker = ({colour, shape, filled}, x, y) => `<path d='M${px(x)} ${px(y)}${SHAPES[shape % SHAPES.length]}' ` +
  `fill='${filled ? colour : "#fff"}' stroke='${colour}' stroke-width='1.4'/>`;
const markerInText = (mark) => `<svg width='14' height='14' class='mark'>${marker(mark, 7, 7)}</svg>`;

const LEFT = 66, RIGHT = 16, TOP = 30, BOTTOM = 48;  // pixels beside the axes
const LETTER = 6.3, LINE = 13;                       // of a label, about

/** Values from `low` to `high` at pixels from `from` to `to`, and ticks. */
function logAxis(values, from, to) {
  const positive = values.filter((v) => v > 0 && Number.isFinite(v));
  let low = Math.log10(Math.min(...positive)), high = Math.log10(Math.max(...positive));
  if (!positive.length) [low, high] = [0, 1];
  const margin = Math.max(0.06 * (high - low), 0.08), ticks = [];
  low -= margin;
  high += margin;
  if (high - low < 0.9) {
    const [least, most] = [10 ** low, 10 ** high];
    let step = 10 ** Math.floor(Math.log10(most - least));
    if ((most - least) / step > 5) step *= 2;
    if ((most - least) / step < 2.5) step /= 4;
    for (let k = Math.ceil(least / step); k * step <= most; ++k) ticks.push(k * step);
  } else {
    const step = Math.max(1, Math.ceil((high - low) / 8));
    for (let e = Math.floor(low); e <= Math.ceil(high); ++e) {
      for (const factor of high - low > 2.2 ? [1] : [1, 2, 5]) {
        const at = e + Math.log10(factor);
        if (e % step === 0 && at >= low && at <= high) ticks.push(factor * 10 ** e);
      }
    }
  }
  return {ticks, place: (value) => from + (Math.log10(value) - low) / (high - low) * (to - from)};
}
function tickLabel(value) {
  const exponent = Math.round(Math.log10(value)), isPower = Math.abs(value / 10 ** exponent - 1) < 1e-6;
  if (!isPower || (value >= 0.00999 && value < 99999)) return general(value, 6);
  return `10<tspan dy='-5' font-size='8'>${exponent}</tspan>`;
}

/** Where labels stand: beside their points, where nothing else is; a line leads to one that is farther. */
function labels(points, width) {
  const meets = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
  const taken = points.map(({x, y}) => ({left: x - 4, right: x + 4, top: y - 4, bottom: y + 4}));
  return points.filter((p) => p.label).map(({x, y, isZero, label, colour}) => {
    const at = (dx, dy) => {
      const left = dx < 0 ? x + dx - LETTER * label.length : x + dx;
      return {left, right: left + LETTER * label.length, top: y + dy - 6, bottom: y + dy + 6};
    };
    const places = [at(8, 0)];
    for (let dy = 0; dy <= 60 && !isZero; dy += 6) places.push(at(8, -dy), at(-8, -dy), at(8, dy), at(-8, dy));
    const place = places.find((p) => p.right < width - RIGHT && p.left > LEFT && !taken.some((t) => meets(t, p))) ?? places[0];
    taken.push(place);
    const middle = (place.top + place.bottom) / 2, near = place.left > x ? place.left : place.right;
    return (Math.abs(middle - y) > 8
      ? `<path d='M${px(x)} ${px(y)}L${px(near)} ${px(middle)}' stroke='${colour}' stroke-width='0.6'/>` : "") +
      `<text x='${px(place.left)}' y='${px(middle + 4)}' fill='${colour}'>${escaped(label)}</text>\n`;
  }).join("");
}

/** A plot: title, xLabel, yLabel, curves of {mark, joined, points: {x, y, spread, title, label}}. Options: `zeros`, the
 * height of a band below for what is not positive; `front`, points of a staircase; xRange, yRange; width, height;
 * `notes` of [mark or null, words]. Labelled points stand one below the other in the band of zeros; others beside each
 * other by their shapes. */
function plot({title, xLabel, yLabel, curves, zeros = 0, front = [], xRange, yRange, width = 470, height = 330, notes = []}) {
  const all = curves.flatMap((curve) => curve.points), bottom = height - BOTTOM, right = width - RIGHT;
  const x = logAxis(xRange ?? all.flatMap((p) => [p.x, ...(p.spread ?? [])]), LEFT, right);
  const y = logAxis(yRange ?? all.map((p) => p.y), bottom - zeros, TOP);
  const placeY = (value) => (value > 0 ? y.place(value) : bottom - zeros / 2 + 1);
  const rowsOfZeros = Array(Math.max(1, Math.floor((zeros - 9) / LINE))).fill(-Infinity), rowOfZero = new Map();
  for (const p of all.filter((q) => !(q.y > 0) && q.label).sort((a, b) => a.x - b.x)) {
    let row = rowsOfZeros.findIndex((end) => end < x.place(p.x) - 8);
    if (row < 0) row = rowsOfZeros.indexOf(Math.min(...rowsOfZeros));
    rowsOfZeros[row] = x.place(p.x) + 10 + LETTER * p.label.length;
    rowOfZero.set(p, bottom - zeros + 6 + LINE * (row + 0.5));
  }
  const middle = (LEFT + right) / 2;
  let text = `<rect x='${LEFT}' y='${TOP}' width='${right - LEFT}' height='${bottom - TOP}' fill='#fff' stroke='#888'/>\n` +
    `<text x='${middle}' y='18' text-anchor='middle' font-weight='bold'>${escaped(title)}</text>\n` +
    `<text x='${middle}' y='${height - 10}' text-anchor='middle'>${escaped(xLabel)}</text>\n` +
    `<text transform='translate(14 ${(TOP + bottom) / 2}) rotate(-90)' text-anchor='middle'>${escaped(yLabel)}</text>\n`;
  for (const tick of x.ticks) {
    const at = px(x.place(tick));
    text += `<path d='M${at} ${TOP}V${bottom}' stroke='#e4e4e4'/>` +
      `<text x='${at}' y='${bottom + 16}' text-anchor='middle'>${tickLabel(tick)}</text>\n`;
  }
  for (const tick of y.ticks) {
    const at = y.place(tick);
    text += `<path d='M${LEFT} ${px(at)}H${right}' stroke='#e4e4e4'/>` +
      `<text x='${LEFT - 6}' y='${px(at + 4)}' text-anchor='end'>${tickLabel(tick)}</text>\n`;
  }
  if (zeros) {
    text += `<rect x='${LEFT}' y='${bottom - zeros + 3}' width='${right - LEFT}' height='${zeros - 3}' fill='#eef6ee' ` +
      `stroke='#888'/><text x='${LEFT - 6}' y='${bottom - zeros / 2 + 5}' text-anchor='end'>0</text>\n`;
  }
  if (front.length) {
    const steps = front.map((p) => `H${px(x.place(p.x))}V${px(placeY(p.y))}`).join("");
    text += `<path d='M${px(x.place(front[0].x))} ${TOP}${steps}H${right}' fill='none' stroke='#aaa' stroke-width='2' ` +
      "stroke-dasharray='5 3'/>\n";
  }
  const labelled = [];
  for (const {mark, joined, points} of curves) {
    // In the band of zeros, precisions beside each other: a method's times are often the same.
    const aside = joined ? 0 : 8 * (mark.shape % 5 - 2);
    const placed = points.map((p) => ({x: x.place(p.x), y: rowOfZero.get(p) ?? placeY(p.y) + (p.y > 0 ? 0 : aside), p}));
    if (joined) {
      text += `<path d='M${placed.map((at) => `${px(at.x)} ${px(at.y)}`).join("L")}' fill='none' stroke='${mark.colour}' ` +
        "stroke-width='1.3'/>\n";
    }
    for (const {x: atX, y: atY, p} of placed) {
      if (p.spread) {
        const [least, greatest] = p.spread.map((value) => px(x.place(value)));
        text += `<path d='M${least} ${px(atY)}H${greatest}' stroke='${mark.colour}' stroke-width='0.8'/>`;
      }
      text += `<g><title>${escaped(p.title)}</title>${marker(mark, atX, atY)}</g>\n`;
      labelled.push({x: atX, y: rowOfZero.get(p) ?? placeY(p.y), isZero: !(p.y > 0), label: p.label, colour: mark.colour});
    }
  }
  text += labels(labelled, width);
  if (notes.length) {
    const room = LETTER * Math.max(...notes.map(([, words]) => words.length)) + 28, left = right - room - 6;
    text += `<rect x='${px(left)}' y='${TOP + 6}' width='${px(room)}' height='${LINE * notes.length + 8}' fill='#fff' ` +
      "stroke='#ccc'/>\n";
    notes.forEach(([mark, words], k) => {
      const at = TOP + 6 + LINE * (k + 1);
      text += (mark ? marker(mark, left + 11, at - 3) : "") +
        `<text x='${px(left + 22)}' y='${px(at + 1)}'>${escaped(words)}</text>\n`;
    });
  }
  return svg(width, height, text);
}
const svg = (width, height, inside) =>
  `<svg class='plot' width='${width}' height='${height}' viewBox='0 0 ${width} ${height}' role='img'>\n${inside}</svg>\n`;
/** A plot as a file of its own. */
const svgFile = (text) => text.replace("class='plot'", "xmlns='http://www.w3.org/2000/svg' font-family='sans-serif' " +
  "font-size='11'").replace(/width='(\d+)' height='(\d+)'[^>]*>\n/, "$&<rect width='$1' height='$2' fill='#fff'/>\n");

/** Percentages in rows and columns: zero light green, and from light to dark red by logarithm. `cells` are
 * {percent, title}, row after row; a percent of null: nothing was measured. */
function heatMap(rows, columns, cells) {
  const cellWidth = 23, cellHeight = 14, names = 178, heads = 172;
  const colour = (percent) => {
    if (percent === null) return "#ddd";
    if (percent === 0) return "#e3f4e3";
    const t = Math.min(1, Math.max(0, (Math.log10(percent) + 2) / 4));
    const mix = (a, b) => Math.round(a + t * (b - a)).toString(16).padStart(2, "0");
    return `#${mix(255, 165)}${mix(243, 15)}${mix(205, 21)}`;
  };
  const label = (percent) => (!percent ? "" : percent < 0.095 ? "&lt;.1" : percent.toFixed(percent < 9.95 ? 1 : 0));
  let text = columns.map((column, c) => `<text transform='translate(${px(names + (c + 0.5) * cellWidth + 4)} ${heads - 5}) ` +
    `rotate(-90)'>${escaped(column)}</text>\n`).join("");
  rows.forEach((row, r) => {
    const y = heads + r * cellHeight;
    text += `<text x='${names - 5}' y='${y + 11}' text-anchor='end'>${escaped(row)}</text>\n`;
    columns.forEach((_, c) => {
      const {percent, title} = cells[r * columns.length + c], x = names + c * cellWidth;
      text += `<g><title>${escaped(title)}</title><rect x='${x}' y='${y}' width='${cellWidth}' height='${cellHeight}' ` +
        `fill='${colour(percent)}' stroke='#fff'/><text x='${x + cellWidth / 2}' y='${y + 10.5}' text-anchor='middle' ` +
        `font-size='9' fill='${percent > 8 ? "#fff" : "#222"}'>${label(percent)}</text></g>\n`;
    });
  });
  return svg(names + columns.length * cellWidth + 10, heads + rows.length * cellHeight + 6, text);
}
