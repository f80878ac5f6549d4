#include "programs/bench/line_summary.h"

#include <fmt/format.h>

#include <algorithm>

#include "programs/bench/growth.h"
#include "programs/bench/json_report.h"
#include "programs/bench/line_measure.h"
#include "programs/bench/summary_parts.h"

namespace displayfile::bench {

namespace {

bool is_hard_case(const SceneRow& row) { return row.scene.kind == BenchScene::Kind::hard_case; }

bool is_among(const SceneRow& row, LineScenes scenes) {
  return (row.scene.kind == BenchScene::Kind::surface) == (scenes == LineScenes::surfaces);
}

Column column_of_lines(const Cell& cell) {
  return {cell.key.method, cell.key.precision, cell.exact};
}

/// Once each, those of a method together; in order of the report.
std::vector<Column> line_columns(const Report& report, LineScenes scenes) {
  std::vector<Column> all;
  for (const SceneRow& row : report.scenes) {
    if (!is_among(row, scenes)) continue;
    for (const Cell& cell : row.line_cells) {
      const Column column = column_of_lines(cell);
      if (std::ranges::find(all, column) != all.end()) continue;
      const auto others =
          std::ranges::find(all.rbegin(), all.rend(), column.method, &Column::method);
      all.insert(others == all.rend() ? all.end() : others.base(), column);
    }
  }
  return all;
}

/// What was measured on one thread; null if nothing was.
const Cell* found(const SceneRow& row, const Column& column) {
  const auto cell = std::ranges::find_if(row.line_cells, [&](const Cell& c) {
    return c.key.threads == 1 && c.skipped.empty() && column_of_lines(c) == column;
  });
  return cell == row.line_cells.end() ? nullptr : &*cell;
}

/// Those rows on which all columns were measured.
std::vector<const SceneRow*> rows_with_all(const Report& report, LineScenes scenes,
                                           const std::vector<Column>& all, bool hard_cases) {
  std::vector<const SceneRow*> rows;
  for (const SceneRow& row : report.scenes) {
    if (!is_among(row, scenes)) continue;
    const bool has_all =
        std::ranges::all_of(all, [&](const Column& column) { return found(row, column); });
    if (has_all && is_hard_case(row) == hard_cases) rows.push_back(&row);
  }
  return rows;
}

std::vector<const SceneRow*> timed_rows(const Report& report, LineScenes scenes,
                                        const std::vector<Column>& all) {
  std::vector<const SceneRow*> rows = rows_with_all(report, scenes, all, false);
  if (rows.empty()) return rows_with_all(report, scenes, all, true);
  std::erase_if(rows, [&](const SceneRow* row) {
    return std::ranges::any_of(rows, [&](const SceneRow* other) {
      return other->scene.name == row->scene.name && other->polygons > row->polygons;
    });
  });
  return rows;
}

}  // namespace

LineMethods line_methods(const Report& report, LineScenes scenes) {
  const std::vector<Column> all = line_columns(report, scenes);
  LineMethods methods;
  if (all.empty()) return methods;
  methods.timed = timed_rows(report, scenes, all);
  for (const Column& column : all) {
    LineMethod method{column, std::nullopt, {}, {}};
    for (const SceneRow& row : report.scenes) {
      const Cell* const cell = is_among(row, scenes) ? found(row, column) : nullptr;
      if (cell == nullptr) continue;
      WrongLength& sum = is_hard_case(row) ? method.hard_cases : method.scenes;
      sum.length += cell->lines->length;
      sum.missing += cell->lines->missing;
      sum.extra += cell->lines->extra;
    }
    std::vector<double> times;
    for (const SceneRow* row : methods.timed) times.push_back(found(*row, column)->time.median);
    if (!times.empty()) method.time = figure(geometric_mean(times));
    methods.all.push_back(std::move(method));
  }
  return methods;
}

std::vector<LineFit> line_fits(const Report& report, LineScenes scenes) {
  std::vector<LineFit> fits;
  const auto kind =
      scenes == LineScenes::surfaces ? BenchScene::Kind::surface : BenchScene::Kind::generated;
  for (const std::string& name : names(report, kind)) {
    for (const Column& column : line_columns(report, scenes)) {
      if (!column.exact) continue;
      std::vector<double> sizes, times;
      for (const SceneRow& row : report.scenes) {
        const Cell* const cell = row.scene.name == name ? found(row, column) : nullptr;
        if (cell == nullptr || !row.line_growth) continue;
        sizes.push_back(static_cast<double>(row.polygons));
        times.push_back(cell->time.median * row.line_growth->median);
      }
      if (sizes.size() < 2) continue;
      fits.push_back({name, column.method, sizes.size(), figure(fitted_exponent(sizes, times))});
    }
  }
  return fits;
}

namespace {

/// "0.9 to 1.3", of several scenes.
std::string growth_of_method(const std::vector<LineFit>& fits, const Column& column) {
  std::optional<double> least, greatest;
  for (const LineFit& fit : fits) {
    if (!column.exact || fit.method != column.method) continue;
    least = std::min(least.value_or(fit.exponent), fit.exponent);
    greatest = std::max(greatest.value_or(fit.exponent), fit.exponent);
  }
  if (!least) return "";
  return *least == *greatest ? fmt::format("{:.2f}", *least)
                             : fmt::format("{:.2f} to {:.2f}", *least, *greatest);
}

std::string names_of(const std::vector<const SceneRow*>& rows) {
  std::string text;
  for (const SceneRow* row : rows) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", short_name(row->scene.name));
  }
  return text;
}

/// What a table of methods says before its rows.
struct LinesTable {
  const char *block, *title;
  std::string text;
  bool has_hard_cases;
};

std::string share_of(double wrong, const WrongLength& of) {
  return of.length == 0.0 ? "" : fmt::format("{:.4g}", 1e6 * wrong / of.length);
}

Summary table_of(const LinesTable& table, const LineMethods& methods,
                 const std::vector<LineFit>& fits) {
  Summary summary{table.block, table.title, table.text, {{"method", "time", "growth"}}};
  std::vector<std::string>& heads = summary.rows.front();
  if (table.has_hard_cases) heads.insert(heads.end(), {"missing, hard cases", "extra, hard cases"});
  heads.insert(heads.end(), {"missing, scenes", "extra, scenes"});
  for (const LineMethod& method : methods.all) {
    const auto& [column, time, hard, scenes] = method;
    std::vector<std::string> row{column.name(), time ? times(*time) : kSkipped,
                                 growth_of_method(fits, column)};
    if (table.has_hard_cases) {
      row.insert(row.end(), {share_of(hard.missing, hard), share_of(hard.extra, hard)});
    }
    row.insert(row.end(), {share_of(scenes.missing, scenes), share_of(scenes.extra, scenes)});
    summary.rows.push_back(std::move(row));
  }
  return summary;
}

}  // namespace

std::optional<Summary> hidden_lines(const Report& report) {
  const LineMethods methods = line_methods(report, LineScenes::any);
  if (methods.all.empty()) return std::nullopt;
  const auto cases = std::ranges::count_if(report.scenes, [](const SceneRow& row) {
    return is_hard_case(row) && !row.line_cells.empty();
  });
  const bool few = methods.timed.size() <= 20;
  return table_of(
      {"lines", "Hidden lines: speed against missing and extra length",
       fmt::format(
           "What methods of lines find of all sides of polygons, against the exact truth of lines. "
           "Times in those of {}, on one thread, geometric means over {} scene{} from which none "
           "was left out{}; growth is the exponent of the time with the polygons, the least and "
           "the greatest of the generated scenes. Missing and extra length in a million of the "
           "lines' length, of {} hard cases and of the scenes.",
           kLineReference, methods.timed.size(), methods.timed.size() == 1 ? "" : "s",
           few && !methods.timed.empty() ? fmt::format(" ({})", names_of(methods.timed)) : "",
           cases),
       true},
      methods, line_fits(report, LineScenes::any));
}

std::optional<Summary> hidden_lines_of_surfaces(const Report& report) {
  const LineMethods methods = line_methods(report, LineScenes::surfaces);
  if (methods.all.empty()) return std::nullopt;
  std::string triangles;
  for (const SceneRow* row : methods.timed) triangles = fmt::format(", of {}", row->polygons);
  return table_of(
      {"surfaces", "Surfaces over a grid: speed against missing and extra length",
       fmt::format(
           "What the same methods, and those that draw surfaces alone, find of all sides of a "
           "surface's triangles{}, diagonals among them, against the exact truth of lines. Times "
           "in those of {}, on one thread; growth is the exponent of the time with the triangles. "
           "Missing and extra length in a million of the lines' length, of all sizes.",
           triangles, kLineReference),
       false},
      methods, line_fits(report, LineScenes::surfaces));
}

}  // namespace displayfile::bench
