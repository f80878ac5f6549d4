"use strict";
// Tables that answer one question each: sections of the page, and blocks of a README. A summary has
// a name (of the block), a title, a text, and rows, of which the first is the head; or no rows. Sentences of
// other pages (isOfOtherPages) are blocks alone.

/** Collects why figures of a table are missing: a sentence for each, after its text. */
function notesOfLeftOut() {
  let words = "";
  const leftOut = (scene, whose, why) => {
    words += `${words ? "" : " Skipped:"} ${whose}: ${shortName(scene)}, ${why}.`;
    return SKIPPED;
  };
  return [leftOut, () => words];
}

/** The row of a scene, if any of its figures is there. */
function rowOf(row, cells) {
  return cells.some(Boolean) ? [[shortName(row.name), grouped(row.polygons), square(row.size), ...cells]] : [];
}

/** Pieces of the map, of crossing planes if they were measured, and the scenes on which it is slower or has more of them. */
function costOfMap(figures) {
  const rowsOf = (way) => figures.mapRows.filter((row) => row.way === way);
  const maps = rowsOf("map"), pairs = rowsOf("depth-sort, written").flatMap((row) => {
    const map = maps.find((one) => one.scene === row.scene);
    return map ? [{scene: row.scene, polygons: map.polygons, map: map.pieces, written: row.pieces, time: 1 / row.time.median}] : [];
  });
  if (!pairs.length) return "";
  const planes = pairs.find((pair) => pair.scene.startsWith("planes"));
  const first = planes ? `${grouped(planes.polygons)} crossing planes become ${grouped(planes.map)} visible pieces; depth sort cuts ` +
    `them into ${grouped(planes.written)}. ` : "";
  const slow = pairs.filter((pair) => pair.time > 1), more = pairs.filter((pair) => pair.map > pair.written);
  const slower = slow.length ? ` they take ${times(Math.min(...slow.map((pair) => pair.time)))} to ` +
    `${times(Math.max(...slow.map((pair) => pair.time)))} times as long to find as depth sort takes with writing` : "";
  const larger = more.map((pair) => `${shortName(pair.scene)}${pair.scene === "soup" ? " (random triangles)" : ""} has ` +
    `${times(pair.map / pair.written)} times as many`).join(", ");
  if (!slower && !larger) return first.trimEnd();
  return `${first}But ${[slower && `on ${slow.length} of ${plural(pairs.length, "scene")}${slower}`, larger].filter(Boolean).join(", and ")}.`;
}

const summaryMakers = {
  front(figures) {
    const found = figures.front;
    if (!found) return null;
    const hard = figures.hardCases.length > 0;
    const listed = (front) => front.map((one) =>
      `${one.column.name} (time ${general(one.time)}, ${general(one.timed)} % wrong` +
      (hard ? ` of the scenes timed, ${general(one.percent)} % of the stress scenes)` : ")")).join("; ");
    const timed = listed(found.frontTimed), stress = listed(found.front);
    const text = (timed === stress
      ? `On the front, from fastest to most accurate: ${timed}.`
      : "On the front, from fastest to most accurate, by the errors of the scenes timed: " +
        `${timed}. By those of the stress scenes: ${stress}.`) +
      " For every other method one on the front is faster and more accurate. Time is that of a picture from the " +
      `display file, relative to ${figures.reference}, the geometric mean over the ` +
      `${plural(found.scenes, "scene")} from which no method was left out` +
      `${found.leftOut ? ` (${found.leftOut} more do not count)` : ""}; peers are warm, and have the polygons in ` +
      "their own form. Errors are the percentage of pixels whose polygon differs from that of exact arithmetic, " +
      `without ties${hard ? `: of the scenes timed, and of ${aboutHardCases(figures)}.` : ", of these scenes."}`;
    return {title: "Speed against error", text};
  },

  methods: (figures) => methodsTable(figures, "Methods", isInSeries),
  "all-methods": (figures) => methodsTable(figures, "Every measured method and precision", () => true),

  /** The few rows of a README: the defaults, and peers. */
  compared(figures) {
    const found = methodRows(figures, (column) => isInSeries(column) || column.name === "osmesa, 32 bits");
    if (!found) return null;
    const gl2ps = found.rows.filter((row) => row.column.method === "gl2ps" && row.anew !== null && row.pieces !== null);
    const least = (value) => gl2ps.reduce((a, b) => (value(b) < value(a) ? b : a), gl2ps[0]);
    const best = unique([least((row) => row.anew), least((row) => row.pieces)].filter(Boolean));
    const labels = {"z-buffer, exact": "z-buffer, exact: the default for pixels", "osmesa, 24 bits": "OSMesa, 24 bits of depth",
      "osmesa, 32 bits": "OSMesa, 32 bits of depth", "embree, single": "Embree, single precision: its tree and one ray a pixel",
      "map, exact": "map, exact: the default for vectors"};
    for (const row of best) labels[row.column.name] = `${row.column.name}: a sort, which draws no pixels`;
    const hard = figures.hardCases.length > 0;
    const body = Object.entries(labels).flatMap(([name, label]) => {
      const row = found.rows.find((one) => one.column.name === name);
      return row ? [[label, shownMean(row.anew), ...errorCells(row.timed), ...(hard ? errorCells(row.stress) : []),
                     shownMean(row.pieces)]] : [];
    });
    const inputs = found.scenes.filter((row) => row.kind === "input").length;
    const text = `Written by tests/bench/figures. One thread, geometric means over ${plural(found.scenes.length, "scene")}` +
      (inputs ? `, of which ${inputs} are meshes (tests/bench/meshes.sha256 has those that are not in the repository)` : "") +
      `; peers are warm.${figures.environment.date ? ` Measured on ${figures.environment.date}.` : ""} A tie is a pixel where ` +
      "the polygon shown is exactly as near as the right one, so that only the order of entry decides; it does not count as " +
      "wrong.";
    const scenes = "ordinary scenes", stress = `${figures.hardCases.length} stress scenes, ${figures.sizesOfHardCases}`;
    return {title: "Compared", text, rows: [["", "time over that of the exact z-buffer", ...errorHeads(scenes),
      ...(hard ? errorHeads(stress) : []), "pieces a triangle"], ...body]};
  },

  "measured-with"(figures) {
    const rows = Object.entries(figures.environment).map(([name, value]) => [name, value]);
    return {title: "Measured with", text: "Times of different machines or builds cannot be compared. Of different " +
      "runs only the digits that two runs have in common can be compared.", rows: [["item", "value"], ...rows]};
  },

  meshes(figures) {
    return {title: "Meshes", text: "The program makes the generated scenes and the stress scenes, the same on every machine. " +
      "These files are further inputs; no script downloads those that are not in the repository.",
            rows: [["file", "source", "SHA-256"], ...figures.meshes.map((m) => [m.name, m.source, m.sha256])]};
  },

  /** Each way in which another program was timed against ours, slower or faster, in one table. */
  slower(figures) {
    const all = figures.comparisons;
    const body = all.map(({ours, other, threads, scenes}) => {
      const ratios = scenes.map((one) => one.ratio), slow = scenes.filter((one) => one.ratio < 1);
      const plain = (scene) => shortName(scene.replace(/ \d+x\d+$/, "").replace(/ n=\d+$/, ""));
      const names = slow.map((one) => `${plain(one.scene)} ${times(one.ratio)}`);
      return [ours, other, String(threads), `${slow.length} of ${scenes.length}`, ...[Math.min(...ratios),
        geometricMean(ratios), Math.max(...ratios)].map(times), names.slice(0, 6).join(", ") +
        (names.length > 6 ? ` and ${names.length - 6} more` : "")];
    });
    return {title: "Where ours is slower, and where it is not", text: "The other program's time over ours, for every " +
      "comparison of this run: below 1 ours is slower. The section that lists the scenes of a comparison describes it. " +
      "The mean is geometric.", rows: [["ours", "beside", "threads", "slower on", "least", "mean", "greatest",
      "scenes on which it is slower"], ...body]};
  },

  "map-and-sorts"(figures) {
    const scenes = unique(figures.mapRows.map((row) => row.scene));
    const ways = unique(figures.mapRows.map((row) => row.way).filter((way) => way !== "map"));
    const body = scenes.map((scene) => {
      const own = figures.mapRows.filter((row) => row.scene === scene), map = own.find((row) => row.way === "map");
      const others = ways.map((way) => own.find((row) => row.way === way));
      return [scene, grouped(map.polygons), grouped(map.pieces), ...others.flatMap((row) =>
        [grouped(row.pieces), `${times(row.time.median)} (${times(row.time.least)} to ${times(row.time.greatest)})`])];
    });
    return {title: "The map beside our own sorts", text: "The visible-surface map, exact, from a display file to pieces, " +
      "beside depth sort with writing an SVG of all its pieces, and beside the sorts alone: pieces, and the time of each " +
      "over the map's (median, least and greatest of rounds); below 1 the map is slower. All faces of the meshes, front and back.",
            rows: [["scene", "polygons", "pieces of the map", ...ways.flatMap((way) => [`pieces, ${way}`, `map beside ${way}`])],
                   ...body]};
  },

  sheets(figures) {
    const heads = ["work", "asked", "measured", "besides", "beside"];
    return {title: "Surfaces and sheets", text: "The targets were set before anything was measured: the least and, in " +
      "parentheses, the goal. Rows without one had no target.",
            rows: [["work", "target: least (goal)", "measured", "also", "beside", "reached"], ...figures.sheetRows.map((row) =>
              [...heads.map((head) => String(row[head] ?? "")), row.holds === undefined ? "" : row.holds ? "yes" : "no"])]};
  },

  /** The three reasons of a README, each with its number and with what speaks against it. */
  reasons(figures) {
    const rows = methodRows(figures, isInSeries)?.rows ?? [], of = (name) => rows.find((row) => row.column.name === name);
    const exact = of("z-buffer, exact"), osmesa = of("osmesa, 24 bits");
    if (!exact || !osmesa || !figures.hardCases.length) return null;
    const rounded = figures.beside.filter((b) => b.other === "without exact stages" && b.what === "z-buffer" && b.times_faster);
    const saved = rounded.length ? Math.round(100 * (1 - geometricMean(rounded.map((b) => b.times_faster.median)))) : 0;
    const texts = [`**Exact.** Pixels that show the wrong polygon: on ordinary scenes ${general(exact.timed.percent)} %, by OSMesa ` +
      `${general(osmesa.timed.percent)} %; on ${figures.hardCases.length} scenes of ${figures.sizesOfHardCases} pixels, made so that rounding decides, ` +
      `${general(exact.stress.percent)} % and ${general(osmesa.stress.percent)} % ([compared](#compared)). ` +
      "Polygons that touch need no offset: a rug on a floor does not flicker."];
    const cost = costOfMap(figures);
    if (cost) texts.push(`**Small vector files.** ${cost}`);
    texts.push(`**Fast without a GPU.** The exact z-buffer takes ${general(exact.anew / osmesa.anew, 2)} of OSMesa's time on one thread` +
      `${saved > 0 ? `; without its exact stages it would take ${saved} % less time` : ""}.`);
    return {title: "Reasons", isOfOtherPages: true, text: texts.map((text, i) => `${i + 1}. ${text}`).join("\n")};
  },

  "map-cost"(figures) {
    const text = costOfMap(figures);
    return text ? {title: "Pieces of the map", isOfOtherPages: true, text} : null;
  },

  lines(figures) {
    const {timed} = figures.linesOf(false);
    const cases = figures.hardCases.filter((row) => row.lineCells.length).length;
    const names = timed.length && timed.length <= 20 ? ` (${timed.map((row) => shortName(row.name)).join(", ")})` : "";
    return linesTable(figures, false, "Hidden lines: speed against missing and extra length",
      "The methods of lines, with all sides of polygons, against the exact truth of lines. Times relative to " +
      `${figures.line_reference}, on one thread, geometric means over ${plural(timed.length, "scene")} from which no ` +
      `method was left out${names}; growth is the exponent of the time with the polygons, the least and the greatest ` +
      "of the generated scenes. Missing and extra length in millionths of the lines' length, of " +
      `${cases} hard cases and of the scenes.`);
  },
  surfaces(figures) {
    const {timed} = figures.linesOf(true);
    return linesTable(figures, true, "Surfaces over a grid: speed against missing and extra length",
      "The same methods, and those that draw surfaces alone, with all sides of a surface's triangles" +
      `${timed.length ? `, of ${timed.at(-1).polygons}` : ""}, including diagonals, against the exact truth of lines. ` +
      `Times relative to ${figures.line_reference}, on one thread; growth is the exponent of the time with the ` +
      "triangles. Missing and extra length in millionths of the lines' length, of all sizes.");
  },

  "moving-camera"(figures) {
    const threads = figures.threadsOf((b) => b.what === "moving camera" || b.other === "truth");
    const growth = figures.growthOfNewViews, [leftOut, words] = notesOfLeftOut();
    const range = (row, n) => {
      const faster = figures.compared(row, n, "OSMesa", "moving camera")?.times_faster;
      if (!faster) return figures.besides(row, n, "OSMesa", "moving camera", leftOut);
      return `${times(faster.median)} (${times(faster.least)} to ${times(faster.greatest)})`;
    };
    const wrong = (row) => {
      const total = (what) => sum(threads.map((n) => figures.count(row, n, "truth", what) ?? 0));
      return total("views") ? `${grouped(total("wrong pixels"))} in ${total("views")} pictures` : "";
    };
    const exponent = (row, n) => {
      const last = figures.named(row.name).filter((other) => figures.count(other, n, "OSMesa", "triangles")).at(-1);
      const found = growth.find((g) => g.scene === row.name && g.threads === n);
      return found && row === last ? String(found.exponent) : "";
    };
    const body = figures.rows.flatMap((row) => {
      const triangles = figures.count(row, threads[0], "OSMesa", "triangles");
      const bytes = ["retained scene", "view", "drawing"].map((what) =>
        figures.count(row, threads[0], "bytes a triangle", what)?.toFixed(0) ?? "");
      const cells = [...threads.map((n) => range(row, n)), wrong(row), ...bytes,
                     ...(growth.length ? threads.map((n) => exponent(row, n)) : [])];
      const first = [shortName(row.name), triangles === undefined ? "" : grouped(triangles), square(row.size)];
      return cells.some(Boolean) ? [[...first, ...cells]] : [];
    });
    const head = ["scene", "triangles", "picture", ...threads.map((n) => `times as fast, ${plural(n, "thread")}`),
                  "wrong pixels", "bytes: scene", "view", "drawing",
                  ...(growth.length ? threads.map((n) => onThreads("growth", n)) : [])];
    const text = "OSMesa's time for a new view, with 24 bits of depth, a resident, indexed mesh and a new matrix, over " +
      "that of the exact z-buffer for a retained scene, without a sort: the median of rounds, each a turn " +
      "of 8 views around the scene on both sides, the least and the greatest. Both sides get the same triangles, into " +
      "which polygons are cut, with the same shared vertices in the same colours, back faces removed on both or on " +
      "neither, and the same number of threads (one: processor time; several: wall time). Our time is " +
      "from the eye to the picture in memory, OSMesa's from the matrix to the finished drawing, without reading it " +
      "back. Wrong pixels: each of these views, on each number of threads, against the exact truth of its display " +
      "file. Bytes a triangle: of the retained scene with its colours; the additional ones of a view; and those of " +
      "the drawing, without the picture. Growth: the exponent of a new view's time with the " +
      "number of triangles, by least squares over all sizes of the scene.";
    return {title: "A new view of a retained scene", text: text + words(), rows: [head, ...body]};
  },

  osmesa(figures) {
    const threads = figures.threadsOf((b) => b.other === "OSMesa"), [leftOut, words] = notesOfLeftOut();
    const ways = ["start-up", "new vertices", "moving camera", "same picture again"];
    const text = "OSMesa's time, with 24 bits of depth, over that of the exact z-buffer: the same triangles, into " +
      "which polygons are cut, in the same colours, back faces removed on both sides or on neither, the same number of " +
      "threads (one: processor time; several: wall time). OSMesa draws an indexed mesh with shared vertices, flat, in " +
      "an existing context, and waits for the end of the drawing; its picture is not read back, while ours is in " +
      "memory. Start-up: everything new and a picture of one triangle; ours a system and a " +
      "picture, OSMesa's a context, a frame buffer and its vertices. New vertices: ours enters all triangles anew and " +
      "draws them; OSMesa's vertices are uploaded anew and drawn. Moving camera: a turn of 8 views; ours views " +
      "the retained scene and draws it; OSMesa's data is resident, in buffers or in a display list, whichever is " +
      "faster, and each view is another matrix. Same picture again: the display file and the mesh unchanged.";
    const body = figures.names.map((name) => figures.largest(name)).flatMap((row) => {
      // A run of new views alone has a table of its own.
      if (!threads.every((n) => figures.compared(row, n, "OSMesa", "start-up"))) return [];
      return rowOf(row, threads.flatMap((n) => ways.map((what) => figures.besides(row, n, "OSMesa", what, leftOut))));
    });
    const head = ["scene", "polygons", "picture", ...threads.flatMap((n) => ways.map((what) => onThreads(what, n)))];
    return {title: "Beside OSMesa", text: text + words(), rows: [head, ...body]};
  },

  embree(figures) {
    const threads = figures.threadsOf((b) => b.other === "Embree"), [leftOut, words] = notesOfLeftOut();
    const packet = figures.beside.find((b) => b.what === "rays a packet")?.count ?? "";
    const qualities = [["Embree", "moderate"], ["Embree, high quality", "high"]];
    const columns = threads.flatMap((n) => ["rays", "building the tree"].flatMap((what) =>
      qualities.map(([other, quality]) => ({n, what, other, head: onThreads(`${what}, ${quality}`, n)}))));
    const text = "Embree's time, in single precision, over that of our ray caster (ray-cast, exact): the " +
      "same triangles, one ray a pixel through its centre, the same number of threads. Embree casts coherent packets " +
      `of ${packet} rays, as wide as this processor's vectors, with common fields filled in once; its ` +
      "device exists and its triangles are in its own form. Rays: cast at a finished tree, with the hit of each pixel " +
      "stored. Building: making that tree, ours with the edges and planes of the triangles. Moderate and " +
      "high are the qualities of Embree's tree.";
    const body = figures.names.map((name) => figures.largest(name)).flatMap((row) =>
      rowOf(row, columns.map(({n, what, other}) => figures.besides(row, n, other, what, leftOut))));
    return {title: "Rays beside Embree", text: text + words(),
            rows: [["scene", "polygons", "picture", ...columns.map((column) => column.head)], ...body]};
  },

  pieces(figures) {
    const [leftOut, words] = notesOfLeftOut();
    const text = "Pieces that a sort makes of a triangle, 1 if it cut nothing; of the map the visible ones. All get " +
      "the same triangles, gl2ps's in single precision, with and without " +
      "GL2PS_BEST_ROOT. Beside gl2ps: its time over ours, processor time on one thread, as gl2ps " +
      "has but one. The time is that of the sort alone: ours from the triangles to the order and the points of its " +
      "pieces, gl2ps's gl2psEndPage in a format that writes no polygons, without passing the triangles. Culled: with " +
      "GL2PS_OCCLUSION_CULL too, which leaves out hidden pieces and takes longer.";
    const body = figures.names.map((name) => figures.shown(name)).flatMap((row) => {
      const triangles = figures.count(row, 1, "gl2ps", "triangles");
      if (triangles === undefined) return [];
      const cell = (other, what) => figures.besides(row, 1, other, what, leftOut);
      return [[shortName(row.name), grouped(triangles),
               ...[...OBJECT_SPACE, ...GL2PS].map((method) => cell(method, "pieces a triangle")),
               ...OBJECT_SPACE.flatMap((method) => GL2PS.map((peer) => cell(peer, method)))]];
    });
    const beside = OBJECT_SPACE.flatMap((name) => GL2PS.map((peer) => `${name} beside ${peer.replace("gl2ps, ", "")}`));
    return {title: "Pieces of a triangle, beside gl2ps", text: text + words(),
            rows: [["scene", "triangles", ...OBJECT_SPACE, ...GL2PS, ...beside], ...body]};
  },

  exactness(figures) {
    const [leftOut, words] = notesOfLeftOut();
    const all = figures.beside.filter((b) => b.other === "without exact stages");
    for (const b of all.filter((one) => one.left_out)) leftOut(b.scene, b.what, b.left_out);
    const text = "The time of a method that decides exactly, over that of the same code without its exact stages, on one " +
      "thread: the geometric mean over the scenes, the least and the greatest; and the wrong pixels without them " +
      "on these scenes. The time is that of the method's own work on a viewed scene, from preparation to visibility at " +
      "every pixel; of a sort, the sort and the painting of its order. The code without exact stages has a ROUNDOFF of " +
      "0: doubles decide. In the z-buffer single precision decides. Without any ROUNDOFF a sort " +
      "would cut polygons that cross by rounding alone: it has one of 1e-12. The map has no other precision.";
    const body = unique(all.map((b) => b.what)).flatMap((method) => {
      const of = all.filter((b) => b.what === method && !b.left_out);
      if (!of.length) return [];
      const ratios = of.map((b) => 1 / b.times_faster.median);
      return [[method, `${geometricMean(ratios).toFixed(2)} (${Math.min(...ratios).toFixed(2)} to ` +
                       `${Math.max(...ratios).toFixed(2)})`, String(of.length), grouped(sum(of.map((b) => b.count)))]];
    });
    return {title: "What exactness costs", text: text + words(),
            rows: [["method", "exact over rounded", "scenes", "wrong pixels without"], ...body]};
  },

  advice(figures) {
    return {title: "Which method when", text: `From this run alone; times are relative to ${figures.reference}, ` +
      "geometric means over the scenes from which no method was left out. Of methods within a tenth of the fastest the " +
      "first of the tables is named.",
            rows: [["for", "use", "why"], ...advice(figures).map((a) => [a.purpose, a.use, a.reason])]};
  },

  auto(figures) {
    const bounds = figures.auto;
    return bounds && {title: "The method that picks itself", text: "--hidden auto draws pixels by the z-buffer, whatever " +
      `the scene. Over ${plural(bounds.scenes, "scene")} it takes ${bounds.total_over_best_fixed} times what the best fixed method ` +
      `takes in total (${bounds.best_fixed}); at worst it takes ${bounds.worst_over_best} times the best method on a ` +
      `scene (${bounds.worst_scene}, where ${bounds.best_there} is best). --explain prints its choice, for vectors too.`};
  },

  /** A row a method: its count when exact, with each ROUNDOFF, and in what other formats it has. */
  "wrong-pixels"(figures) {
    const sums = figures.columns.map((column) => ({column, ...figures.wrong(figures.hardCases, column)}))
      .filter((one) => one.pixels);
    const pixels = Math.max(0, ...sums.map((one) => one.pixels));
    if (!pixels) return null;
    const families = unique(figures.hardCases.map((row) => row.name)).length;
    const roundoffs = unique(figures.columns.map((c) => c.precision).filter((p) => p.startsWith("roundoff=")));
    const heads = ["exact", ...roundoffs];
    // A peer may have drawn only some of the pixels.
    const count = (one) => grouped(one.wrong) + (one.tied ? ` and ${plural(one.tied, "tie")}` : "") +
      (one.pixels === pixels ? "" : ` of ${grouped(one.pixels)}`);
    const body = unique(sums.map((one) => one.column.method)).map((method) => {
      const own = sums.filter((one) => one.column.method === method);
      const at = (precision) => own.filter((one) => one.column.precision === precision).map(count).join("; ");
      const others = own.filter((one) => !heads.includes(one.column.precision))
        .map((one) => `${one.column.precision && one.column.precision + " "}${count(one)}`);
      return [method, ...heads.map(at), others.join("; ")];
    });
    return {title: "Wrong pixels", text: "Wrong pixels, counted against the exact truth over " +
      `${figures.hardCases.length} hard cases of ${families} families, ${grouped(pixels)} pixels in all; ties, where the ` +
      "polygon shown is exactly as near as the right one, are counted apart:",
            rows: [["method", ...heads, "otherwise"], ...body]};
  },

  viewing(figures) {
    const isProgram = (row) => row.name.endsWith(".draw");
    // A gap of 10^-11 is far above the rounding of viewing, which is some 10^-16 times a few.
    const groups = [
      ["meshes", (row) => row.kind === "input" && !isProgram(row)],
      ["drawing programs", (row) => row.kind === "input" && isProgram(row)],
      ["generated scenes", (row) => row.kind === "generated" || row.kind === "surface"],
      ["hard cases, gap from 1e-1 to 1e-11", (row) => row.gap && row.severity <= 11],
      ["hard cases, gap below that", (row) => row.gap && row.severity > 11],
      ["hard cases of other kinds", (row) => isHard(row) && !row.gap]];
    const body = groups.flatMap(([name, has]) => {
      const rows = figures.viewing.map((v) => ({...v, row: figures.rows.find((row) => row.scene === v.scene)}))
        .filter((v) => has(v.row));
      const total = (part) => grouped(sum(rows.map((v) => v[part])));
      return rows.length ? [[name, grouped(rows.length), total("pixels"), total("different"), total("different_and_tied"),
                             whereViewingDecides(rows)]] : [];
    });
    return {title: "Where exactness begins", text: "Exact means: from the coordinates in the display file. Viewing rounds " +
      "to doubles before that. Counted here are pixels in which the truth of the display file differs from that of the " +
      "world, which is viewed in exact arithmetic (displayfile truth --from world; of hard cases that touch, " +
      "--from entered); scenes in the unit cube are entered through a turned perspective view. Ties among these: both " +
      "polygons are there, within 1e-13 of the view volume's depth, as where polygons coincide in the world. In the " +
      "others an edge or a plane seen edge-on runs through the pixel centre except for rounding, or a slope, a size or " +
      "an image transformation is so large that it makes rounding visible.",
            rows: [["scenes", "number", "pixels", "differ", "of these ties", "where"], ...body]};
  },
};

/** Those that the report has figures for. */
function summaries(figures) {
  return Object.entries(summaryMakers).map(([name, make]) => ({name, ...make(figures)}))
    .filter((summary) => summary.title && summary.rows?.length !== 1);
}

/** True if a column is of numbers, which stand to the right. */
const isOfNumbers = (rows, column) =>
  rows.slice(1).every((row) => row[column] === "" || row[column] === SKIPPED || /^\d/.test(row[column]));

const aboutHardCases = (figures) => `${figures.hardCases.length} stress scenes of ${figures.sizesOfHardCases} pixels ` +
  "each (the hard cases, in which rounding decides)";

/** The geometric mean of the pieces that a sort, ours or another's, or the map makes of a triangle; null without one. */
function piecesATriangle(figures, rows, column) {
  const isOurs = OBJECT_SPACE.includes(column.method);
  if (isOurs ? !column.exact : column.method !== "gl2ps") return null;
  const other = isOurs ? column.method : column.name.replace("gl2ps, bsp", "gl2ps");
  const each = rows.map((row) => figures.count(row, 1, other, "pieces a triangle"));
  return each.includes(undefined) ? null : geometricMean(each);
}

const shownMean = (value) => (value === null ? "" : general(value));
const errorHeads = (scenes) => [`wrong, %: ${scenes}`, "and ties, %"];
const errorCells = (error) => (error.pixels ? [general(error.percent), general(error.percentTied)] : ["", ""]);

/** Means and errors of the wanted columns over the scenes from which none of them was left out; null if there is none. */
function methodRows(figures, wanted) {
  const scenes = figures.withNothingLeftOut(figures.still, wanted);
  if (!scenes.length) return null;
  const mean = (column, value) => figures.means(scenes, (other) => other === column, value)[0]?.time ?? null;
  const rows = figures.columns.filter(wanted).map((column) => {
    const bytes = scenes.map((row) => [row, figures.measured(row, column)]).filter(([, cell]) => cell?.bytes !== undefined)
      .map(([row, cell]) => Math.max(1, cell.bytes) / Math.max(1, row.polygons));
    return {column, anew: mean(column, medianTime), again: mean(column, (cell) => cell.time_again?.median),
            timed: figures.wrong(scenes, column), stress: figures.wrong(figures.hardCases, column),
            bytes: bytes.length ? geometricMean(bytes).toFixed(0) : "", pieces: piecesATriangle(figures, scenes, column)};
  }).filter((row) => row.anew !== null);
  return {scenes, rows};
}

function methodsTable(figures, title, wanted) {
  const found = methodRows(figures, wanted);
  if (!found) return null;
  const hard = figures.hardCases.length > 0, advised = advice(figures), {scenes} = found;
  const {date} = figures.environment;
  const text = `${date ? `Measured on ${date}. ` : ""}Times of a picture relative to ${figures.reference}, geometric ` +
    `means over the ${plural(scenes.length, "scene")} from which no method was left out ` +
    `(${scenes.map((row) => shortName(row.name)).join(", ")}): anew, from the display file; and ` +
    "the same picture again. Peers are warm, and have the polygons in their own form. gl2ps sorts, and draws " +
    "no pixels; culled, it leaves out hidden pieces. Wrong pixels are percentages of all: of the scenes timed" +
    `${hard ? `, and of ${aboutHardCases(figures)}` : ""}. A tie is a pixel where the polygon shown is exactly as near as ` +
    "the right one, so that only the order of entry decides; it does not count as wrong. Pieces are per triangle, of the " +
    "same triangles; the map's are the visible ones.";
  const head = ["method", "anew", "again", ...errorHeads("scenes timed"),
                ...(hard ? errorHeads(`stress scenes, ${figures.sizesOfHardCases}`) : []),
                "bytes a polygon", "pieces", "recommended for"];
  const body = found.rows.map((row) => [row.column.name, shownMean(row.anew), shownMean(row.again), ...errorCells(row.timed),
    ...(hard ? errorCells(row.stress) : []), row.bytes, shownMean(row.pieces),
    advised.filter((a) => a.use === row.column.name).map((a) => a.purpose.replace(/:.*/, "")).join("; ")]);
  return {title, text, rows: [head, ...body]};
}

/** The names of scenes that differ, the ones with the most pixels first, and how many more. */
function whereViewingDecides(rows) {
  const different = new Map();
  for (const v of rows.filter((one) => one.different)) {
    const name = shortName(v.row.name);
    different.set(name, (different.get(name) ?? 0) + v.different);
  }
  const names = [...different].sort((a, b) => b[1] - a[1]).map(([name, pixels]) => `${name} (${pixels})`);
  return names.slice(0, 4).join(", ") + (names.length > 4 ? ` and ${names.length - 4} more` : "");
}

function linesTable(figures, surfaces, title, text) {
  const {all, fits} = figures.linesOf(surfaces);
  if (!all.length) return null;
  const share = (wrong, of) => (of.length ? general(1e6 * wrong / of.length, 4) : "");
  const growth = (column) => {
    const exponents = fits.filter((fit) => column.exact && fit.method === column.method).map((fit) => fit.exponent);
    return unique([Math.min(...exponents), Math.max(...exponents)].filter(isFinite)).map((e) => e.toFixed(2)).join(" to ");
  };
  const groups = surfaces ? ["scenes"] : ["hard", "scenes"], words = {hard: "hard cases", scenes: "scenes"};
  const head = ["method", "time", "growth", ...groups.flatMap((g) => [`missing, ${words[g]}`, `extra, ${words[g]}`])];
  const body = all.map((one) => [one.column.name, one.time === null ? SKIPPED : times(one.time), growth(one.column),
    ...groups.flatMap((g) => [share(one[g].missing, one[g]), share(one[g].extra, one[g])])]);
  return {title, text, rows: [head, ...body]};
}

// ---- Which method for what ---------------------------------------------------------------

/** Which method to use for a purpose, and why: only of purposes that the report has figures for. */
function advice(figures) {
  return [plotInAPaper, gameLevel, hugeImage, thinSheets, anyOther].map((of) => of(figures)).filter(Boolean);
}

/** The first in the tables of those that none is clearly faster than. */
function bestOf(byTime) {
  const good = byTime.filter((mean) => mean.time <= byTime[0].time / CLEARLY);
  return good.reduce((a, b) => (b.place < a.place ? b : a)).column;
}
const listed = (means) => means.map(({column, time}) =>
  `${column.exact ? column.method : `${column.method} with ${column.precision}`} ${time}`).join(", ");
const firstOf = (means) => listed(means.slice(0, 3));
const over = (rows, of) => plural(rows.length, "scene") + (of === rows.length ? "" :
  ` (${of - rows.length} more, from which an exact method was left out, do not count)`);

/** Only what is in polygons can be written as vectors. */
function plotInAPaper(figures) {
  const givesPolygons = (column) => column.exact && OBJECT_SPACE.includes(column.method);
  const rows = figures.withNothingLeftOut(figures.still, givesPolygons);
  const fragments = figures.means(rows, isExact, (cell) => cell.fragments_per_polygon);
  if (!fragments.length) return null;
  const best = fragments[0].column, of = over(rows, figures.still.length);
  const wrong = (column, some) => figures.wrong(some, column).wrong;
  const rounded = figures.columns.filter((column) => column.method === best.method && !column.exact).map((column) =>
    `With ${column.precision} the same method has ${wrong(column, rows)} wrong pixels on these scenes and ` +
    `${wrong(column, figures.hardCases)} on the hard cases; exact has ${wrong(best, rows)} and ` +
    `${wrong(best, figures.hardCases)}.`);
  return {purpose: "A plot in a paper: vectors, drawn once", use: best.name,
          reason: "pixels cannot be scaled, so only the methods in object space draw vectors; pieces of a polygon, over " +
                  `${of}: ${listed(fragments)}`,
          why: ["Vectors need polygons, in an order as from a sort or without overlap as from the map; an image-space " +
                "method gives pixels.",
                `Fragments a polygon (geometric mean over ${of}): ${listed(fragments)}. Fewer pieces are a smaller file; ` +
                "the map's are those alone that are seen.",
                "Time of a picture, in reference times: " + `${listed(figures.means(rows, givesPolygons, medianTime))}.`,
                ...rounded]};
}

/** Every view is a new one: nothing of a picture can be kept but what does not depend on the view. */
function gameLevel(figures) {
  const walk = figures.rows.find((row) => row.kind === "walk");
  if (!walk) return null;
  const wanted = (column) => isExact(column) || column.precision === "retained tree";
  const rows = figures.withNothingLeftOut([figures.shown(walk.name)], wanted), [row] = rows;
  const all = figures.means(rows, wanted, (cell) => cell.time_again.median);
  if (!all.length) return null;
  const best = bestOf(all), tree = figures.measured(row, {method: "bsp", precision: "retained tree"});
  const wrong = (column) => figures.wrong(rows, column).wrong;
  const list = all.map(({column, time}) => `${column.name} ${time} (${wrong(column)} wrong pixels)`).join(", ");
  return {purpose: "A game level walked through", use: best.name,
          reason: `each view is a new one; ${wrong(best)} wrong pixels in ${VIEWS_OF_WALK} views of ${row.polygons} ` +
                  `polygons; time: ${firstOf(all)}`,
          why: [`Time of ${row.scene} of ${row.polygons} polygons, each view clipped and drawn anew, in reference times: ` +
                `${list}.`,
                ...(tree ? ["The retained tree is built once, in world coordinates, and then only walked: with its building " +
                            `these views take ${tree.time.median}. It sees world coordinates, so it may differ where the ` +
                            "view's own rounding decides."] : [])]};
}

function hugeImage(figures) {
  const large = figures.names.map((name) => figures.series(name, "pixels").at(-1)).filter(Boolean);
  const rows = figures.withNothingLeftOut(large, isExact), all = figures.means(rows, isExact, medianTime);
  if (!all.length) return null;
  const best = bestOf(all), pixels = Math.max(...rows.map((row) => row.pixels)), of = over(rows, large.length);
  const fits = figures.fits.filter((fit) => fit.against === "pixels" && fit.precision === "exact");
  const grow = unique(fits.map((fit) => fit.method)).sort().map((method) => {
    const exponents = fits.filter((fit) => fit.method === method).map((fit) => fit.exponent).sort((a, b) => a - b);
    return `${method} ${figure(exponents[exponents.length >> 1])}`;
  }).join(", ");
  return {purpose: "A huge image", use: best.name, reason: `time at ${pixels} pixels, over ${of}: ${firstOf(all)}`,
          why: [`At ${pixels} pixels, the most of this run, the exact methods take, in reference times (geometric mean ` +
                `over ${of}): ${listed(all)}. Wrong pixels of ${best.name} there: ${figures.wrong(rows, best).wrong}.`,
                `How they grow with the number of pixels (exponent, median over the scenes): ${grow}.`]};
}

function thinSheets(figures) {
  const rows = figures.withNothingLeftOut(
    figures.rows.filter((row) => row.gap && row.severity >= 9 && row.severity <= 13), isExact);
  const all = figures.means(rows, isExact, medianTime);
  if (!all.length) return null;
  const best = bestOf(all), pixels = sum(rows.map((row) => row.pixels));
  const percent = (column) => general(100 * figures.wrong(rows, column).wrong / pixels);
  const there = figures.columns.filter((column) => figures.measured(rows[0], column));
  const named = (column) => `${column.method} ${percent(column)}`;
  const others = unique(there.filter((c) => !c.exact).map((c) => c.method)).map((method) => {
    const own = there.filter((column) => column.method === method && !column.exact);
    return own.every((column) => !column.precision) ? named(own[0])
      : `${method} with ${own.map((column) => `${column.precision} ${percent(column)}`).join(", ")}`;
  });
  return {purpose: "A stack of thin sheets: depths 1e-9 apart and less", use: best.name,
          reason: `the exact methods have ${figures.wrong(rows, best).wrong} wrong pixels there; time: ${firstOf(all)}`,
          why: [`Wrong pixels in a hundred over ${plural(rows.length, "scene")} whose gap is 1e-9 to 1e-13, of the exact methods: ` +
                `${there.filter((column) => column.exact).map(named).join("; ")}.`, `Of the others: ${others.join("; ")}.`,
                `Time of the exact methods there, in reference times (geometric mean): ${listed(all)}. These are small ` +
                `pictures, of ${rows[0].pixels} pixels.`]};
}

function anyOther(figures) {
  const rows = figures.withNothingLeftOut(figures.still, isExact), all = figures.means(rows, isExact, medianTime);
  if (!all.length) return null;
  const usual = bestOf(all), of = over(rows, figures.still.length);
  const exceptions = rows.flatMap((row) => {
    const least = CLEARLY * figures.measured(row, usual).time.median;
    const better = row.cells.filter((cell) => !cell.skipped && cell.threads === 1 && isExact(cell) && medianTime(cell) < least)
      .sort((a, b) => medianTime(a) - medianTime(b))[0];
    return better && better.method !== usual.method ? [`But on ${row.scene}: ${better.method}, at ${medianTime(better)}.`] : [];
  });
  return {purpose: "Any other picture of pixels", use: usual.name,
          reason: `least time of a picture over ${of}: ${firstOf(all)}`,
          why: [`The least time of a picture over ${of} (geometric mean, in reference times): ${listed(all)}.`, ...exceptions]};
}
