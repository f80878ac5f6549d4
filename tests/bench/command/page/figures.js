"use strict";
// Figures that follow from a report's JSON: means, fronts, growth, and the tables that answer one
// question each. The page shows them; report-figures writes them into a README.

const sum = (values) => values.reduce((a, b) => a + b, 0);
const unique = (values) => [...new Set(values)];
const geometricMean = (values) => Math.exp(sum(values.map(Math.log)) / values.length);

/** To four digits, as the JSON has its own numbers. */
const figure = (x) => Number(x.toPrecision(4));

/** As %.3g prints it, with `digits` digits. */
function general(x, digits = 3) {
  if (x === 0) return "0";
  const [mantissa, exponent] = x.toExponential(digits - 1).split("e");
  if (exponent >= -4 && exponent < digits) return String(Number(x.toPrecision(digits)));
  return `${Number(mantissa)}e${exponent.replace(/^([+-])(\d)$/, "$10$2")}`;
}

/** A ratio as it is read: 0.42, 3.2, 17. */
const times = (ratio) => ratio.toFixed(ratio < 1 ? 2 : ratio < 9.95 ? 1 : 0);
/** With a comma after the thousands. */
const grouped = (count) => String(count).replace(/\B(?=(\d{3})+$)/g, ",");
const plural = (count, word) => `${count} ${word}${count === 1 ? "" : "s"}`;
const onThreads = (what, threads) => (threads === 1 ? what : `${what}, ${threads} threads`);
const shortName = (scene) => scene.replace(/^.*\//, "").replace(/(?!^)\.[^.]*$/, "");
const square = (side) => `${side} x ${side}`;

/** The exponent e of the power c n^e that fits best: least squares of the logarithms. */
function fittedExponent(sizes, costs) {
  const x = sizes.map(Math.log), y = costs.map(Math.log), n = x.length;
  const products = (a, b) => sum(a.map((value, i) => value * b[i]));
  return figure((n * products(x, y) - sum(x) * sum(y)) / (n * products(x, x) - sum(x) ** 2));
}

/** What none before is as small as by `error`, of values in order of time. */
function frontBy(error, values) {
  const sorted = [...values].sort((a, b) => a.time - b.time || error(a) - error(b));
  return sorted.filter((one, i) => sorted.slice(0, i).every((before) => error(one) < error(before)));
}

const SKIPPED = "skipped";
const OBJECT_SPACE = ["bsp", "depth-sort", "map"];
const GL2PS = ["gl2ps", "gl2ps, best root", "gl2ps, best root, culled"];
/** The report's version (bench_command.cpp). */
const FORMAT = 3;
/** What is less than this part of another's time is clearly faster: two runs agree on it. */
const CLEARLY = 0.9;
const VIEWS_OF_WALK = 8;

const isHard = (row) => row.kind === "hard case";
const isExact = (column) => column.exact && column.method !== "auto";
/** Methods whose growth is shown: exact ones, and one precision of each other method. */
const OTHERS_IN_SERIES = ["", "float", "double", "24 bits", "single", "bsp, best root", "bsp, best root, culled"];
const isInSeries = (column) => column.exact || OTHERS_IN_SERIES.includes(column.precision);
const medianTime = (cell) => cell.time.median;
/** Wrong pixels without the ties, in which the polygon shown is exactly as near as the right one. */
const wrongOf = (cell) => cell.wrong_pixels - cell.wrong_and_tied;
const nameOf = ({method, precision}) => (precision ? `${method}, ${precision}` : method);
const columnOf = ({method, precision, exact}) => ({method, precision, exact, name: nameOf({method, precision})});
const isOf = (column) => (cell) => cell.method === column.method && cell.precision === column.precision;

/** The columns of cells, once each, in order. */
function columnsOf(cells) {
  const found = new Map();
  for (const cell of cells) {
    const key = JSON.stringify([cell.method, cell.precision, cell.exact]);
    if (!found.has(key)) found.set(key, columnOf(cell));
  }
  return [...found.values()];
}

function byScene(cells = []) {
  const groups = new Map();
  for (const cell of cells) groups.set(cell.scene, [...(groups.get(cell.scene) ?? []), cell]);
  return groups;
}

/** A report with what follows from it. Rows are scenes with their cells. */
class Figures {
  constructor(report) {
    if (report.format !== FORMAT) throw new Error(`a report of format ${report.format}: expected ${FORMAT}; measure again`);
    const {reference, line_reference, environment, beside = [], viewing = [], feature_costs: features} = report;
    // What tests/bench/figures adds: the meshes, and the rows of other programs of tests/bench.
    const {meshes = [], map_rows: mapRows = [], sheet_rows: sheetRows = []} = report;
    Object.assign(this, {reference, line_reference, environment, beside, viewing, features, meshes, mapRows, sheetRows});
    const cells = byScene(report.cells), lines = byScene(report.line_cells);
    this.rows = report.scenes.map((scene) => {
      const idButSize = scene.scene.replace(/ \d+x\d+$/, "");
      const row = {...scene, idButSize, cells: cells.get(scene.scene) ?? [], lineCells: lines.get(idButSize) ?? []};
      lines.delete(idButSize);
      return row;
    });
    this.columns = columnsOf([...this.rows].sort((a, b) => b.cells.length - a.cells.length).flatMap((row) => row.cells));
    this.hardCases = this.rows.filter(isHard);
    this.names = ["generated", "surface", "walk", "input"].flatMap((kind) =>
      unique(this.rows.filter((row) => row.kind === kind).map((row) => row.name)));
    this.mostThreads = Math.max(1, ...this.rows.flatMap((row) => row.cells.map((cell) => cell.threads)));
    /** All but hard cases and the walk: each picture is one by itself. */
    this.still = this.names.map((name) => this.shown(name)).filter((row) => row.kind !== "walk");
  }

  // ---- Scenes --------------------------------------------------------------------------

  named(name) { return this.rows.filter((row) => row.name === name); }
  /** The scene of a name that is shown: that with the most polygons, and of these the largest picture. */
  shown(name) {
    return this.named(name).reduce((a, b) => (b.polygons - a.polygons || b.size - a.size) > 0 ? b : a);
  }
  largest(name) {
    return this.named(name).reduce((a, b) => (b.size - a.size || b.polygons - a.polygons) > 0 ? b : a);
  }
  /** The scenes of a name at one picture size, by polygons, or with one number of polygons, by pixels: those
   * that share what the most of them share. Empty if there are fewer than two. */
  series(name, against) {
    const shared = against === "polygons" ? "size" : "polygons", by = against === "polygons" ? "polygons" : "size";
    const rows = this.named(name).filter((row) => !isHard(row));
    const groups = unique(rows.map((row) => row[shared])).sort((a, b) => a - b)
      .map((value) => rows.filter((row) => row[shared] === value)).filter((group) => group.length >= 2);
    const most = groups.reduce((a, b) => (b.length > a.length ? b : a), []);
    return most.sort((a, b) => a[by] - b[by]);
  }
  /** Points of a column's growth, in the reference's time on the first scene of the name. */
  growth(scenes, column) {
    const against = scenes.length && scenes[0].polygons !== scenes.at(-1).polygons ? "polygons" : "pixels";
    return scenes.filter((row) => this.measured(row, column) && row.reference_growth).map((row) => ({
      size: row[against], time: this.measured(row, column).time.median * row.reference_growth.median}));
  }
  /** On one thread, of all that have two points at least. */
  get fits() {
    return this.names.flatMap((scene) => ["polygons", "pixels"].flatMap((against) => {
      const scenes = this.series(scene, against);
      return this.columns.flatMap((column) => {
        const points = this.growth(scenes, column);
        if (points.length < 2) return [];
        const exponent = fittedExponent(points.map((p) => p.size), points.map((p) => p.time));
        return [{scene, method: column.method, precision: column.precision, against, points: points.length, exponent}];
      });
    }));
  }
  /** The sides of the pictures of hard cases: "32 x 32", or "16 x 16 to 24 x 24". */
  get sizesOfHardCases() {
    const sizes = this.hardCases.map((row) => row.size), least = Math.min(...sizes), most = Math.max(...sizes);
    return least === most ? square(most) : `${square(least)} to ${square(most)}`;
  }

  // ---- Cells ---------------------------------------------------------------------------

  /** Undefined if nothing was measured. */
  measured(row, column, threads = 1) {
    return row.cells.find((cell) => cell.threads === threads && isOf(column)(cell) && !cell.skipped);
  }
  /** Those rows on which every wanted column was measured, on one thread, that was tried on any. */
  withNothingLeftOut(rows, wanted) {
    for (const column of this.columns.filter(wanted)) {
      const isTried = rows.some((row) => row.cells.some((cell) => cell.threads === 1 && isOf(column)(cell)));
      if (isTried) rows = rows.filter((row) => this.measured(row, column));
    }
    return rows;
  }
  /** Geometric means of a cell's value, by size, of the columns that have one on all rows. */
  means(rows, wanted, value) {
    if (!rows.length) return [];
    return this.columns.flatMap((column, place) => {
      if (!wanted(column)) return [];
      const values = rows.map((row) => this.measured(row, column)).map((cell) => cell && value(cell));
      return values.includes(undefined) ? [] : [{column, place, time: figure(geometricMean(values))}];
    }).sort((a, b) => a.time - b.time);
  }
  /** Wrong pixels of a column on one thread, ties, and all pixels, on the rows on which it was measured. */
  wrong(rows, column) {
    const found = rows.filter((row) => this.measured(row, column)), pixels = sum(found.map((row) => row.pixels));
    const [wrong, tied] = [wrongOf, (cell) => cell.wrong_and_tied].map((value) =>
      sum(found.map((row) => value(this.measured(row, column)))));
    const inAHundred = (count) => pixels && 100 * count / pixels;
    return {wrong, tied, pixels, percent: inAHundred(wrong), percentTied: inAHundred(tied)};
  }
  /** All methods and peers but `auto`, which is one of them, over the scenes on which none was left out. */
  get front() {
    const wanted = (column) => column.method !== "auto", rows = this.withNothingLeftOut(this.still, wanted);
    const all = this.means(rows, wanted, medianTime).map(({column, time}) => {
      const timed = figure(this.wrong(rows, column).percent);
      const percent = this.hardCases.length ? figure(this.wrong(this.hardCases, column).percent) : timed;
      return {column, time, percent, timed};
    }).sort((a, b) => a.time - b.time || a.percent - b.percent);
    if (!all.length) return null;
    return {all, scenes: rows.length, leftOut: this.still.length - rows.length,
            front: frontBy((one) => one.percent, all), frontTimed: frontBy((one) => one.timed, all)};
  }
  /** How `auto` compares with the fixed exact methods over all scenes; null if one side was left out. */
  get auto() {
    const own = this.columns.find((column) => column.method === "auto"), fixed = this.columns.filter(isExact);
    const rows = own ? this.rows.filter((row) => this.measured(row, own)) : [];
    const bounds = {scenes: 0, total_over_best_fixed: 0, best_fixed: "", worst_over_best: 0, worst_scene: "", best_there: "",
                    above_twice: 0};
    const totals = new Map(fixed.map((column) => [column.name, 0]));
    let total = 0;
    for (const row of rows) {
      for (const column of fixed) {
        totals.set(column.name, totals.get(column.name) + (this.measured(row, column)?.time.median ?? Infinity));
      }
      const cells = fixed.map((column) => this.measured(row, column)).filter(Boolean);
      if (!cells.length) continue;
      const best = cells.reduce((a, b) => (b.time.median < a.time.median ? b : a));
      const time = this.measured(row, own).time.median, ratio = figure(time / best.time.median);
      ++bounds.scenes;
      bounds.above_twice += time > 2 * best.time.median ? 1 : 0;
      total += time;
      if (ratio <= bounds.worst_over_best) continue;
      Object.assign(bounds, {worst_over_best: ratio, worst_scene: row.scene, best_there: nameOf(best)});
    }
    if (!bounds.scenes) return null;
    const [name, least] = [...totals].sort().reduce((a, b) => (b[1] < a[1] ? b : a));
    return Object.assign(bounds, {best_fixed: name, total_over_best_fixed: figure(total / least)});
  }

  // ---- Beside others -------------------------------------------------------------------

  compared(row, threads, other, what) {
    return this.beside.find((b) => b.scene === row.scene && b.threads === threads && b.other === other && b.what === what);
  }
  count(row, threads, other, what) { return this.compared(row, threads, other, what)?.count; }
  threadsOf(wanted) { return unique(this.beside.filter(wanted).map((b) => b.threads)); }
  /** A comparison as a cell of a table; why it was left out goes to `leftOut`. */
  besides(row, threads, other, what, leftOut) {
    const found = this.compared(row, threads, other, what);
    if (!found) return "";
    if (found.left_out) return leftOut(row.name, `${what} of ${other}`, found.left_out);
    return found.times_faster ? times(found.times_faster.median) : general(found.count, 6);
  }
  get growthOfNewViews() {
    const threads = this.threadsOf((b) => b.what === "moving camera" || b.other === "truth");
    return this.names.flatMap((scene) => threads.flatMap((n) => {
      const rows = this.named(scene).filter((row) => this.count(row, n, "OSMesa", "triangles") !== undefined);
      const triangles = rows.map((row) => this.count(row, n, "OSMesa", "triangles"));
      const costs = rows.map((row) =>
        1 / (this.compared(row, n, "fewest polygons", "moving camera")?.times_faster.median ?? 1));
      if (unique(triangles).length < 2) return [];
      return [{scene, threads: n, points: rows.length, exponent: fittedExponent(triangles, costs)}];
    }));
  }

  /** All comparisons with other programs: one for each program, way and number of threads, with the ratios of its scenes. */
  get comparisons() {
    const found = new Map(), isPeer = (b) => b.other === "OSMesa" || b.other.startsWith("Embree") || GL2PS.includes(b.other);
    const add = (ours, other, threads, scene, ratio) => {
      const key = [ours, other, threads].join(" | ");
      if (!found.has(key)) found.set(key, {ours, other, threads, scenes: []});
      found.get(key).scenes.push({scene, ratio});
    };
    for (const b of this.beside.filter((one) => isPeer(one) && one.times_faster)) {
      // New views are compared at several numbers of polygons: all else at one.
      const {name} = this.rows.find((row) => row.scene === b.scene);
      if (b.what === "moving camera" && this.largest(name).scene !== b.scene) continue;
      const own = b.other === "OSMesa" ? "z-buffer" : "ray-cast";
      const ours = GL2PS.includes(b.other) ? `${b.what}, exact` : `${own}, exact: ${b.what}`;
      add(ours, b.other, b.threads, b.scene, b.times_faster.median);
    }
    for (const row of this.mapRows.filter((one) => one.time)) {
      add("map, exact", `our own ${row.way}`, 1, row.scene, row.time.median);
    }
    for (const row of this.sheetRows.filter((one) => one.times_faster)) {
      add(row.work, row.beside, row.threads, row.work, row.times_faster);
    }
    return [...found.values()];
  }

  // ---- Lines ---------------------------------------------------------------------------

  /** Methods of lines on all scenes but surfaces, or on surfaces, on one thread: the mean time over `timed`, and
   * sums of lengths. `timed`: the most polygons of each name on which no method was left out, or else hard cases. */
  linesOf(surfaces) {
    const rows = this.rows.filter((row) => (row.kind === "surface") === surfaces);
    const found = (row, column) => row.lineCells.find((cell) => cell.threads === 1 && !cell.skipped && isOf(column)(cell));
    const methods = columnsOf(rows.flatMap((row) => row.lineCells));
    const columns = unique(methods.map((column) => column.method)).flatMap((method) =>
      methods.filter((column) => column.method === method));
    const whole = columns.length ? rows.filter((row) => columns.every((column) => found(row, column))) : [];
    const ordinary = whole.filter((row) => !isHard(row));
    const timed = ordinary.length ? ordinary.filter((row) => !ordinary.some((other) =>
      other.name === row.name && other.polygons > row.polygons)) : whole;
    const lengths = (column, some) => {
      const cells = some.map((row) => found(row, column)).filter(Boolean);
      const [length, missing, extra] = ["length", "missing_length", "extra_length"].map((part) =>
        sum(cells.map((cell) => cell[part])));
      return {length, missing, extra, percent: length && 100 * (missing + extra) / length};
    };
    const all = columns.map((column) => {
      const hard = lengths(column, rows.filter(isHard)), scenes = lengths(column, rows.filter((row) => !isHard(row)));
      const time = timed.length ? figure(geometricMean(timed.map((row) => found(row, column).time.median))) : null;
      return {column, time, hard, scenes, percent: hard.length ? hard.percent : scenes.percent};
    });
    const names = unique(rows.filter((row) => row.kind === (surfaces ? "surface" : "generated")).map((row) => row.name));
    const fits = names.flatMap((scene) => columns.filter((column) => column.exact).flatMap((column) => {
      const points = this.named(scene).filter((row) => found(row, column) && row.line_reference_growth);
      if (points.length < 2) return [];
      const costs = points.map((row) => found(row, column).time.median * row.line_reference_growth.median);
      const exponent = fittedExponent(points.map((row) => row.polygons), costs);
      return [{scene, method: column.method, points: points.length, exponent}];
    }));
    return {all, timed, fits};
  }
}
