#include "programs/bench/page_of_lines.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "programs/bench/analysis.h"
#include "programs/bench/json_report.h"
#include "programs/bench/line_measure.h"
#include "programs/bench/line_summary.h"
#include "programs/bench/page_parts.h"
#include "programs/bench/svg_plot.h"

namespace displayfile::bench {

namespace {

std::string line_figures(const Cell& cell) {
  if (!cell.skipped.empty()) return row_skipped(cell, 10);
  const auto& [lines, pieces, length, missing, extra] = *cell.lines;
  return row_begun(cell) + fmt::format("<td>{}<td>{}<td>{}<td>{}<td>{}<td>{}<td>{}<td>{}\n", lines,
                                       pieces, number(length), number(missing), number(extra),
                                       *cell.bytes, cell.exact_calls, spread_cells(cell.time));
}

std::string lines_plot(const LineMethods& methods, const char* title) {
  std::vector<Column> all;
  for (const LineMethod& method : methods.all) all.push_back(method.column);
  Plot plot{title, fmt::format("time / time of {}", kLineReference),
            "missing and extra length, % of all lines", true};
  plot.width = 980.0;
  std::vector<Curve> curves;
  std::string names = "<div class='legend'>";
  for (const LineMethod& method : methods.all) {
    if (!method.time) continue;
    const Mark mark = mark_of(all, method.column);
    curves.push_back({mark,
                      false,
                      {{*method.time, method.percent(), std::nullopt,
                        fmt::format("{}: time {:.3g}, {:.3g} % wrong", method.column.name(),
                                    *method.time, method.percent())}}});
    names += fmt::format("<span>{}{}</span> ", marker_in_text(mark), escaped(method.column.name()));
  }
  if (curves.empty()) return "";
  return "<div class='wide'>" + svg(plot, curves) + "</div>\n" + names + "</div>\n";
}

}  // namespace

std::string lines_plot(const Report& report) {
  return lines_plot(line_methods(report, LineScenes::any),
                    "Hidden lines: below and left is better") +
         lines_plot(line_methods(report, LineScenes::surfaces),
                    "Lines of surfaces: below and left is better");
}

std::string figures_of_lines(const Report& report) {
  std::string text;
  for (const SceneRow& r : report.scenes) {
    if (r.line_cells.empty()) continue;
    text += fmt::format("<details><summary>lines of {}: {} polygons",
                        escaped(r.scene.id_but_size()), r.polygons);
    if (r.line_growth) {
      text += fmt::format(
          "; the reference of lines takes {} ({} to {}) times what it takes on "
          "the first",
          number(r.line_growth->median), number(r.line_growth->least),
          number(r.line_growth->greatest));
    }
    text += "</summary><table>\n" +
            table_row("th", {"method", "precision", "threads", "claims", "lines", "pieces",
                             "length", "missing length", "extra length", "bytes",
                             "exact-stage calls", "time", "least", "greatest"});
    for (const Cell& cell : r.line_cells) text += line_figures(cell);
    text += "</table></details>\n";
  }
  return text;
}

}  // namespace displayfile::bench
