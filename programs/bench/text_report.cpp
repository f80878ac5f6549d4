#include "programs/bench/text_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "programs/bench/analysis.h"
#include "programs/bench/json_report.h"
#include "programs/bench/line_measure.h"
#include "programs/bench/line_summary.h"
#include "programs/bench/moving_camera_summary.h"
#include "programs/bench/summary_parts.h"

namespace displayfile::bench {

namespace {

using Row = std::vector<std::string>;

/// The first column to the left, the others to the right.
std::string aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Row& row : rows) {
    text += fmt::format("  {:<{}}", row[0], widths[0]);
    for (std::size_t i = 1; i < row.size(); ++i) {
      text += fmt::format("  {:>{}}", row[i], widths[i]);
    }
    text += '\n';
  }
  return text;
}

Row row_of(const Cell& cell, std::size_t polygons) {
  const std::string name =
      cell.key.contender() +
      (cell.key.threads == 1 ? "" : fmt::format(", {} threads", cell.key.threads));
  if (!cell.skipped.empty()) return {name, "skipped", "", "", "", "", "", "", ""};
  const auto per_polygon = static_cast<double>(std::max<std::size_t>(1, polygons));
  return {name,
          number(cell.time.median),
          number(cell.time.least) + " .. " + number(cell.time.greatest),
          cell.again ? number(cell.again->median) : "",
          fmt::format("{}", cell.wrong_pixels),
          number(cell.largest_depth_error),
          cell.fragments ? number(*cell.fragments) : "",
          cell.bytes ? fmt::format("{:.0f}", static_cast<double>(*cell.bytes) / per_polygon) : "",
          fmt::format("{}", cell.exact_calls)};
}

std::string scene_table(const SceneRow& row) {
  std::vector<Row> rows{{"method", "time", "least .. greatest", "again", "wrong pixels",
                         "depth error", "fragments", "bytes", "exact calls"}};
  for (const Cell& cell : row.cells) rows.push_back(row_of(cell, row.polygons));
  return fmt::format("{}: {} polygons\n{}\n", row.scene.id(), row.polygons, aligned(rows));
}

std::string scene_tables(const Report& report) {
  std::string text = fmt::format(
      "Times are ratios to {} on the same scene. Fragments and bytes are for each polygon.\n\n",
      report.reference);
  for (const std::string& name : names_but_hard_cases(report)) {
    text += scene_table(shown_scene(report, name));
  }
  return text;
}

std::string hard_cases_table(const Report& report) {
  std::vector<Row> rows{{"method", "wrong pixels", "in a hundred"}};
  for (const Column& column : columns(report)) {
    const Wrong sum = wrong_pixels(report, "", column);
    if (sum.pixels == 0) continue;
    rows.push_back(
        {column.name(), fmt::format("{}", sum.wrong), fmt::format("{:.3g}", sum.percent())});
  }
  return fmt::format("all hard cases\n{}\n", aligned(rows));
}

Row row_of_lines(const Cell& cell) {
  const std::string name = on_threads(cell.key.contender(), cell.key.threads);
  if (!cell.skipped.empty()) return {name, kSkipped, "", "", "", "", "", ""};
  return {name,
          number(cell.time.median),
          number(cell.time.least) + " .. " + number(cell.time.greatest),
          fmt::format("{}", cell.lines->pieces),
          number(cell.lines->missing),
          number(cell.lines->extra),
          fmt::format("{}", *cell.bytes / std::max<std::int64_t>(
                                              1, static_cast<std::int64_t>(cell.lines->lines))),
          fmt::format("{}", cell.exact_calls)};
}

/// A table a scene that is no hard case, at its most polygons; and of all together.
std::string line_tables(const Report& report, LineScenes scenes) {
  const auto summary =
      scenes == LineScenes::any ? hidden_lines(report) : hidden_lines_of_surfaces(report);
  if (!summary) return "";
  std::string text = fmt::format(
      "{}: times are ratios to {}. Lengths are in units of the picture, bytes for each line.\n\n",
      scenes == LineScenes::any ? "Hidden lines" : "Lines of surfaces", kLineReference);
  for (const SceneRow* scene : line_methods(report, scenes).timed) {
    if (scene->scene.kind == BenchScene::Kind::hard_case) continue;
    std::vector<Row> rows{{"method", "time", "least .. greatest", "pieces", "missing", "extra",
                           "bytes", "exact calls"}};
    for (const Cell& cell : scene->line_cells) rows.push_back(row_of_lines(cell));
    const auto& of = std::ranges::find_if(scene->line_cells, [](const Cell& cell) {
                       return cell.lines.has_value();
                     })->lines;
    text += fmt::format("lines of {}: {}, of length {}\n{}\n", scene->scene.id_but_size(),
                        of->lines, number(of->length), aligned(rows));
  }
  return text + fmt::format("{}\n{}\n{}\n", summary->title, summary->text, aligned(summary->rows));
}

std::string beside_table(const Report& report) {
  std::vector<Row> rows{{"beside others", "threads", "other", "what", "times as fast", "count"}};
  for (const Beside& b : report.beside) {
    if (is_of_moving_camera(b)) continue;
    rows.push_back({b.scene, fmt::format("{}", b.threads), b.other, b.what,
                    b.times_faster       ? number(b.times_faster->median)
                    : b.left_out.empty() ? ""
                                         : "skipped",
                    b.count ? number(*b.count) : ""});
  }
  return rows.size() == 1 ? "" : aligned(rows) + '\n';
}

std::string auto_line(const AutoBounds& bounds) {
  return fmt::format(
      "auto over {} scenes: {} times the best fixed method in total ({}); at worst {} times the "
      "best on a scene ({}, where {} is); above twice the best on {}\n\n",
      bounds.scenes, number(bounds.total), bounds.best_fixed, number(bounds.worst),
      bounds.worst_scene, bounds.best_there, bounds.above_twice);
}

Row row_of(const FeatureRow& row, const FeatureCosts& costs) {
  const auto own = [&](const std::optional<FeatureRow::Own>& count) {
    return count && row.has_functions ? fmt::format("{}", count->instructions) : std::string();
  };
  const auto times = [](const auto& count) {
    return count ? fmt::format("{:.3f}", ratio(*count)) : std::string();
  };
  const auto more = [](const auto& count) {
    return count ? fmt::format("{:+}", count->on - count->off) : std::string();
  };
  return {row.over.empty() ? row.name : row.name + ", over " + row.over,
          own(row.own_off),
          own(row.own_off).empty() ? "" : fmt::format("{}", row.own_off->allocations),
          fmt::format("{:g}", costs.bytes_a_polygon),
          times(row.instructions),
          own(row.own_on),
          more(row.allocations),
          row.display_file_on ? fmt::format("{:g}", *row.display_file_on) : "",
          times(row.most_bytes)};
}

std::string features_table(const FeatureCosts& costs) {
  std::vector<Row> rows{{"feature", "off: own instructions", "own allocations", "bytes",
                         "on: instructions / off", "own instructions", "allocations more",
                         "bytes more", "memory / off"}};
  for (const FeatureRow& row : costs.rows) rows.push_back(row_of(row, costs));
  const std::string not_counted =
      costs.not_counted.empty()
          ? ""
          : fmt::format("Instructions were not counted: {}.\n", costs.not_counted);
  return fmt::format(
      "what each feature costs off and on: {} polygons, {}x{}, one thread\n"
      "A feature's own functions are those that nothing else needs; bytes are of the display file, "
      "for each polygon.\n{}{}\n",
      costs.polygons, costs.size, costs.size, not_counted, aligned(rows));
}

}  // namespace

std::string text_report(const Report& report) {
  std::string text;
  if (!columns(report).empty()) {
    text += scene_tables(report);
    if (!names(report, BenchScene::Kind::hard_case).empty()) text += hard_cases_table(report);
  }
  text += line_tables(report, LineScenes::any) + line_tables(report, LineScenes::surfaces);
  text += beside_table(report);
  if (const auto summary = moving_camera(report)) {
    text += fmt::format("{}\n{}\n", summary->title, aligned(summary->rows));
  }
  if (const auto bounds = auto_bounds(report)) text += auto_line(*bounds);
  if (report.features) text += features_table(*report.features);
  return text;
}

}  // namespace displayfile::bench
