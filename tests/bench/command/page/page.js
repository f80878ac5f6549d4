"use strict";
// The page of a report: plots, tables, which method to use when, and every figure of the JSON.

const row = (tag, cells) => `<tr>${cells.map((cell) => `<${tag}>${cell ?? ""}`).join("")}\n`;
const table = (head, rows) => `<table>\n${row("th", head)}${rows.join("")}</table>`;
const wide = (text) => `<div class='wide'>${text}</div>\n`;
const plots = (panels) => `<div class='plots'>\n${panels.join("")}</div>\n`;
const section = (title, text, ...parts) => `<h2>${title}</h2>\n<p>${text}</p>\n${parts.join("")}`;
const spreadCells = (s) => (s ? [s.median, s.least, s.greatest] : ["", "", ""]);
const errorTitle = (one, wrong) => `${one.column.name}: time ${general(one.time)}, ${wrong}`;

/** The plot that the page begins with: all methods and peers, speed against error. Null if there is no scene that all
 * of them were measured on. */
function frontPlot(figures) {
  const found = figures.front, hard = figures.hardCases.length;
  if (!found) return null;
  const curves = found.all.map((one) => {
    const title = errorTitle(one, `${general(one.timed)} % wrong` +
      (hard ? ` of the scenes timed, ${general(one.percent)} % of the stress scenes` : ""));
    // One precision of a method is written out: the others have its colour.
    const label = isInSeries(one.column) ? one.column.name : "";
    return {mark: markOf(figures.columns, one.column), points: [{x: one.time, y: one.percent, title, label}]};
  });
  return plot({
    title: "All methods and peers: below and left is better",
    xLabel: `time of a picture / time of the exact z-buffer, ${plural(found.scenes, "scene")}`,
    yLabel: `wrong pixels, without ties, of ${hard ? `${hard} stress scenes, ${figures.sizesOfHardCases}` : "these scenes"}, %`,
    curves, zeros: 84, width: 980, height: 600, front: found.front.map((one) => ({x: one.time, y: one.percent})),
    xRange: [found.all[0].time, 1.6 * found.all.at(-1).time],  // room for the label of the slowest
    notes: [[{colour: "#444", shape: 0, filled: true}, "filled: claims to be exact"],
            [{colour: "#444", shape: 1, filled: false}, "open: other precisions of the colour's method"],
            [null, "dashed: the front"]]});
}

class Page {
  constructor(figures) { Object.assign(this, {figures, columns: figures.columns, names: figures.names}); }

  html() {
    return [this.head(), this.inShort(), this.lines(), this.whichWhen(), this.pareto(), this.gaps(),
            this.growth("polygons"), this.growth("pixels"), this.fragments(), this.heat(), this.threads(), this.overview(),
            this.features(), this.allFigures()].join("");
  }

  legend(columns, name = (column) => column.name, all = this.columns) {
    return `<div class='legend'>${columns.map((column) =>
      `<span>${markerInText(markOf(all, column))}${escaped(name(column))}</span> `).join("")}</div>\n`;
  }
  curve(column, points) { return points.length ? [{mark: markOf(this.columns, column), joined: true, points}] : []; }

  head() {
    const front = frontPlot(this.figures);
    const environment = Object.entries(this.figures.environment).map(([name, value]) =>
      `<tr><td>${escaped(name)}<td class='l'>${escaped(value)}\n`);
    return `<h1>Speed against error</h1>\n${front ? wide(front) : ""}<p>Every time is a ratio to that of the reference, ` +
      `${escaped(this.figures.reference)}, drawing the same scene in the same run, in turn; given are the median and the ` +
      "least and the greatest of the rounds. A wrong pixel is one whose polygon is not the one that exact arithmetic gives. " +
      "Where the polygon shown is exactly as near as that one, so that only the order of entry decides, it is a tie, which " +
      "is counted apart. " +
      "Depth errors are in units of the view volume's depth.</p>\n<details open><summary>Measured with</summary><table>\n" +
      `${environment.join("")}</table></details>\n`;
  }

  /** The blocks of a README. */
  inShort() {
    return summaries(this.figures).filter(({isOfOtherPages}) => !isOfOtherPages).map(({title, text, rows}) => section(escaped(title), escaped(text), rows ? wide(
      `<table>\n${rows.map((cells, r) => `<tr>${cells.map((cell, c) => {
        const tag = r === 0 ? "th" : "td";
        return `<${tag}${isOfNumbers(rows, c) ? "" : " class='l'"}>${escaped(cell)}`;
      }).join("")}\n`).join("")}</table>`) : "")).join("");
  }

  lines() {
    return [[false, "Hidden lines"], [true, "Lines of surfaces"]].map(([surfaces, title]) => {
      const all = this.figures.linesOf(surfaces).all, columns = all.map((one) => one.column);
      const curves = all.filter((one) => one.time !== null).map((one) => ({mark: markOf(columns, one.column), points: [
        {x: one.time, y: one.percent, title: errorTitle(one, `${general(one.percent)} % wrong`)}]}));
      return curves.length ? wide(plot({title: `${title}: below and left is better`, curves, zeros: 46, width: 980,
        xLabel: `time / time of ${this.figures.line_reference}`, yLabel: "missing and extra length, % of all lines"})) +
        this.legend(columns, undefined, columns) : "";
    }).join("");
  }

  whichWhen() {
    const all = advice(this.figures).map((a) => `<h3>${escaped(a.purpose)}: ${escaped(a.use)}</h3>\n<p>${escaped(a.reason)}.` +
      `</p>\n<ul>\n${a.why.map((why) => `<li>${escaped(why)}</li>\n`).join("")}</ul>\n`);
    return all.length ? `<h2>Which method when</h2>\n${all.join("")}` : "";
  }

  /** One panel a scene. */
  pareto() {
    if (!this.names.length || !this.columns.length) return "";
    const panels = this.names.map((name) => {
      const scene = this.figures.shown(name), cells = scene.cells.filter((cell) => !cell.skipped && cell.threads === 1);
      const points = cells.map((cell) => ({cell, time: cell.time.median}));
      const front = frontBy(({cell}) => wrongOf(cell), points).map(({cell}) => cell);
      const curves = cells.map((cell) => ({mark: markOf(this.columns, columnOf(cell)), points: [{
        x: cell.time.median, y: wrongOf(cell), spread: [cell.time.least, cell.time.greatest],
        title: `${nameOf(cell)}: time ${cell.time.median}, ${wrongOf(cell)} wrong pixels, ${cell.wrong_and_tied} ties`}]}));
      const names = front.map((cell) => `${escaped(nameOf(cell))} (${cell.time.median}, ${wrongOf(cell)})`).join("; ");
      return `<div class='panel'>${plot({title: `${scene.scene}, ${scene.polygons} polygons`, curves, zeros: 46,
        xLabel: "time of a picture / time of the reference", yLabel: "wrong pixels",
        front: front.map((cell) => ({x: cell.time.median, y: wrongOf(cell)}))})}` +
        `<div class='legend'>Front (time, wrong pixels): ${names}</div></div>\n`;
    });
    return section("Error against time", "Below and left is better; the dashed line is the Pareto front, behind which " +
      "nothing is both faster and more accurate. The colour is the method, the shape its precision, filled where it claims " +
      "to be exact; one thread.", this.legend(this.columns), plots(panels));
  }

  /** One panel a method, a curve a precision. */
  gaps() {
    const withGap = this.figures.rows.filter((scene) => scene.gap);
    const severities = unique(withGap.map((scene) => scene.severity)).sort((a, b) => b - a);
    if (severities.length < 2) return "";
    const panels = unique(this.columns.map((column) => column.method)).map((method) => {
      const own = this.columns.filter((column) => column.method === method);
      const curves = own.flatMap((column) => this.curve(column, severities.flatMap((severity) => {
        const sums = this.figures.wrong(withGap.filter((scene) => scene.severity === severity), column);
        return sums.pixels ? [{x: 10 ** -severity, y: sums.percent,
                               title: `${column.name}: ${general(sums.percent, 4)} % at 1e-${severity}`}] : [];
      })));
      const inHardCases = own.filter((column) => this.figures.wrong(this.figures.hardCases, column).pixels);
      return `<div class='panel'>${plot({title: method, xLabel: "gap (1: the view volume's depth)", curves, zeros: 46,
        yLabel: "wrong pixels, % of all", xRange: [10 ** -severities[0], 10 ** -severities.at(-1)], yRange: [0.001, 100]})}` +
        `${this.legend(inHardCases, (column) => column.precision || column.method)}</div>\n`;
    });
    return section("Error against gap", "Wrong pixels of all families whose gap shrinks, together. At gaps that the rounding " +
      "of the vertices swallows the polygons lie in one plane, the later one is rightly seen, and counts fall.", plots(panels));
  }

  growth(against) {
    const shown = this.columns.filter(isInSeries);
    const panels = this.names.flatMap((name) => {
      const scenes = this.figures.series(name, against);
      if (!scenes.length) return [];
      const curves = shown.flatMap((column) => this.curve(column, this.figures.growth(scenes, column).map(({size, time}) =>
        ({x: size, y: time, title: `${column.name}: ${general(time, 4)}`}))));
      const fixed = against === "polygons" ? `${square(scenes[0].size)} pixels` : `${scenes[0].polygons} polygons`;
      return [plot({title: `${name}, ${fixed}`, xLabel: against, yLabel: "time / reference on the smallest scene", curves})];
    });
    if (!panels.length) return "";
    const fits = this.figures.fits.filter((fit) => fit.against === against);
    const names = this.names.filter((name) => fits.some((fit) => fit.scene === name));
    const exponents = this.columns.filter((column) => fits.some(isOf(column))).map((column) => row("td", [
      escaped(column.name), ...names.map((name) => {
        const fit = fits.filter(isOf(column)).find((one) => one.scene === name);
        return fit && `${fit.exponent} <small>(${fit.points} points)</small>`;
      })]));
    return section(`Time against ${against}`, "Both axes are logarithmic, so that a power is a line; one unit is the " +
      "reference's time on the first scene of the name. In the table the fitted exponents e of time = c " +
      `${against}<sup>e</sup>.`, this.legend(shown), plots(panels),
      wide(table([`exponent of ${against}`, ...names.map((name) => escaped(shortName(name)))], exponents)));
  }

  fragments() {
    const columns = this.columns.filter((column) => column.method !== "gl2ps"), drawn = [];  // which counts triangles
    const panels = this.names.flatMap((name) => {
      const scenes = this.figures.series(name, "polygons");
      const curves = columns.flatMap((column) => {
        const points = scenes.flatMap((scene) => {
          const pieces = this.figures.measured(scene, column)?.fragments_per_polygon;
          return pieces === undefined ? [] : [{x: scene.polygons, y: pieces, title: `${column.name}: ${pieces}`}];
        });
        if (points.length) drawn.push(column);
        return this.curve(column, points);
      });
      return curves.length ? [plot({title: name, xLabel: "polygons", yLabel: "fragments a polygon", curves})] : [];
    });
    return panels.length ? section("Fragments", "Pieces that the sorts make of a polygon, and those of which the map says " +
      "that they are seen. gl2ps gets triangles: the pieces of those are in a table above.", this.legend(unique(drawn)),
      plots(panels)) : "";
  }

  heat() {
    const {hardCases} = this.figures, families = [...unique(hardCases.map((scene) => scene.name)), "all"];
    const columns = this.columns.filter((column) => this.figures.wrong(hardCases, column).pixels);
    if (!hardCases.length) return "";
    const cells = families.flatMap((family) => columns.map((column) => {
      const of = family === "all" ? hardCases : hardCases.filter((scene) => scene.name === family);
      const {wrong, tied, pixels, percent} = this.figures.wrong(of, column);
      return {percent: pixels ? percent : null,
              title: `${family}, ${column.name}: ${wrong} wrong of ${pixels} pixels, and ${tied} ties`};
    }));
    return section("Wrong pixels of the hard cases", "In a hundred, over all severities of a family; green: none.",
                   wide(heatMap(families, columns.map((column) => column.name), cells)));
  }

  /** A table of the shown scenes: a row a contender, a column a scene. */
  matrix(head, columns, value) {
    const scenes = this.names.map((name) => this.figures.shown(name));
    return wide(table([head, ...this.names.map((name) => escaped(shortName(name)))], columns.map((column) =>
      row("td", [escaped(column.name), ...scenes.map((scene) => {
        const cell = this.figures.measured(scene, column);
        return cell && value(scene, cell, column);
      })]))));
  }
  threads() {
    const most = this.figures.mostThreads;
    return most === 1 ? "" : section("Threads", `Time on 1 thread over time on ${most}.`, this.matrix("method",
      this.columns.filter((column) => column.exact), (scene, one, column) => {
        const all = this.figures.measured(scene, column, most);
        return all && (one.time.median / all.time.median).toFixed(2);
      }));
  }
  overview() {
    return !this.names.length || !this.columns.length ? "" : section("Memory and exact arithmetic", "Most bytes that the " +
      "program's own arrays and the picture held at a time, for each polygon (OSMesa, Embree and gl2ps take theirs " +
      "elsewhere); and how often one picture needed a predicate's exact stage.",
      this.matrix("bytes a polygon", this.columns, (scene, cell) =>
        cell.bytes === undefined ? "" : (cell.bytes / Math.max(1, scene.polygons)).toFixed(0)),
      this.matrix("exact-stage calls", this.columns, (scene, cell) => cell.exact_stage_calls));
  }

  features() {
    const costs = this.figures.features;
    if (!costs) return "";
    const own = (feature, state) => (feature.has_functions ? [state.own_instructions, state.own_allocations] : ["none", ""]);
    const ratio = ({on, off}, what) => on[what] === undefined ? "" : (on[what] / off[what]).toFixed(3);
    const rows = costs.features.map((feature) => {
      const {on, off} = feature, over = feature.over ? `, over ${escaped(feature.over)}` : "";
      const name = `${escaped(feature.feature)}<br><small>${escaped(feature.turned_on_by)}${over}</small>`;
      const begun = [name, ...own(feature, off), costs.off.display_file_bytes_a_polygon];
      if (on.not_counted) return row("td", begun).replace("\n", `<td class='l' colspan='7'>not counted: ${escaped(on.not_counted)}\n`);
      const more = on.allocations - off.allocations;
      return row("td", [...begun, on.instructions, ratio(feature, "instructions"), ...own(feature, on),
                        `${more < 0 ? "" : "+"}${more}`, on.display_file_bytes_a_polygon, ratio(feature, "most_bytes")]);
    });
    const counted = costs.off.instructions === undefined
      ? `<p><b>Instructions were not counted: ${escaped(costs.instructions_not_counted)}.</b></p>\n`
      : `<p>With everything off the drawing is ${costs.off.instructions} instructions and ${costs.off.allocations} ` +
        "allocations. Instructions are callgrind's, on the processor that it imitates, which need not have this one's vector " +
        "instructions.</p>\n";
    return section("Pay for what is used", `${costs.polygons} polygons drawn at ${costs.size}x${costs.size} on one thread, from ` +
      "the first routine to the picture, without each feature and with it; one that is over another is measured with that one " +
      "on in both. A feature's own functions are those that nothing else needs. Asking whether it is on is a branch in " +
      "functions that all drawings run through; a feature that has no functions of its own is only such a branch. Bytes are of " +
      "the display file, for each polygon; off, beyond its vertices and sides. Memory is the most that was held at a time.",
      counted, wide(table(["feature, what turns it on", "own instructions, off", "own allocations, off", "bytes, off",
        "instructions, on", "/ off", "own instructions, on", "own allocations, on", "allocations more", "bytes more",
        "memory / off"], rows)));
  }

  details(summary, head, rows) {
    return rows.length ? `<details><summary>${escaped(summary)}</summary>${table(head, rows)}</details>\n` : "";
  }
  /** The row of a cell, or why nothing was measured. */
  cellRow(cell, columns, values) {
    const begun = `<tr><td>${escaped(cell.method)}<td class='l'>${escaped(cell.precision)}<td>${cell.threads}<td>` +
      `${cell.exact ? "exact" : ""}`;
    if (cell.skipped) return `${begun}<td class='l' colspan='${columns}'>skipped: ${escaped(cell.skipped)}\n`;
    return `${begun}${values.map((value) => `<td>${value ?? ""}`).join("")}\n`;
  }
  allFigures() {
    const grown = (reference, growth) => !growth ? "" : `; the ${reference} takes ${growth.median} (${growth.least} to ` +
      `${growth.greatest}) times what it takes on the first`;
    const time = ["time", "least", "greatest"], begun = ["method", "precision", "threads", "claims"];
    const beside = this.figures.beside.map((b) => `<tr><td>${escaped(b.scene)}<td>${b.threads}<td class='l'>${escaped(b.other)}` +
      `<td class='l'>${escaped(b.what)}${b.left_out ? `<td class='l' colspan='4'>skipped: ${escaped(b.left_out)}`
        : [...spreadCells(b.times_faster), b.count ?? ""].map((value) => `<td>${value}`).join("")}\n`);
    const lines = this.figures.rows.map((scene) => this.details(
      `lines of ${scene.idButSize}: ${scene.polygons} polygons${grown("reference of lines", scene.line_reference_growth)}`,
      [...begun, "lines", "pieces", "length", "missing length", "extra length", "bytes", "exact-stage calls", ...time],
      scene.lineCells.map((cell) => this.cellRow(cell, 10, [cell.lines, cell.pieces, cell.length, cell.missing_length,
        cell.extra_length, cell.bytes, cell.exact_stage_calls, ...spreadCells(cell.time)]))));
    const pixels = this.figures.rows.map((scene) => this.details(
      `${scene.scene}: ${scene.polygons} polygons, ${scene.pixels} pixels, deep ${scene.deep}, wide ${scene.wide}, ` +
      `each overlaps ${scene.overlapped}` +
      `${isHard(scene) ? `, severity ${scene.severity}` : ""}${grown("reference", scene.reference_growth)}`,
      [...begun, "wrong pixels and ties", "ties", "largest depth error", "mean", "fragments a polygon", "bytes",
       "exact-stage calls", ...time, "again", "least", "greatest"],
      scene.cells.map((cell) => this.cellRow(cell, 13, [cell.wrong_pixels, cell.wrong_and_tied, cell.largest_depth_error,
        cell.mean_depth_error, cell.fragments_per_polygon, cell.bytes, cell.exact_stage_calls, ...spreadCells(cell.time),
        ...spreadCells(cell.time_again)]))));
    return section("All figures", "The same as in the JSON.", this.details("Beside others, and without exact stages",
      ["scene", "threads", "other", "what", "times as fast", "least", "greatest", "count"], beside), ...lines, ...pixels);
  }
}
