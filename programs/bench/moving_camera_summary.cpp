#include "programs/bench/moving_camera_summary.h"

#include <fmt/format.h>

#include <algorithm>

#include "programs/bench/analysis.h"
#include "programs/bench/beside.h"
#include "programs/bench/growth.h"
#include "programs/bench/json_report.h"
#include "programs/bench/summary_parts.h"

namespace displayfile::bench {

using namespace beside;

namespace {

std::optional<double> count(const Report& report, const SceneRow& row, int threads,
                            std::string_view other, std::string_view what) {
  const Beside* const found = find_beside(report, row.scene.id(), threads, other, what);
  return found == nullptr ? std::nullopt : found->count;
}

/// "5.1 (4.8 to 5.3)": the median, the least and the greatest.
std::string times_and_range(const Report& report, const SceneRow& row, int threads,
                            LeftOut& left_out) {
  const Beside* const found = find_beside(report, row.scene.id(), threads, kOsmesa, kNewViews);
  if (found == nullptr || !found->times_faster) {
    return shown(report, row, threads, kOsmesa, kNewViews, left_out);
  }
  const Spread& faster = *found->times_faster;
  return fmt::format("{} ({} to {})", times(faster.median), times(faster.least),
                     times(faster.greatest));
}

/// "0 in 16 pictures", each number of threads in each view.
std::string wrong_pixels_in_all(const Report& report, const SceneRow& row,
                                const std::vector<int>& threads) {
  double wrong = 0.0, pictures = 0.0;
  for (const int n : threads) {
    wrong += count(report, row, n, kTruth, kWrongPixels).value_or(0.0);
    pictures += count(report, row, n, kTruth, kViews).value_or(0.0);
  }
  if (pictures == 0.0) return "";
  return fmt::format("{} in {:g} pictures", grouped(static_cast<std::int64_t>(wrong)), pictures);
}

/// The exponent, beside the largest number of triangles of a scene; empty beside any other.
std::string exponent(const std::vector<GrowthOfNewViews>& growth, const Report& report,
                     const SceneRow& row, int threads) {
  const bool is_last = std::none_of(&row + 1, report.scenes.data() + report.scenes.size(),
                                    [&](const SceneRow& other) {
                                      return other.scene.name == row.scene.name &&
                                             count(report, other, threads, kOsmesa, kTriangles);
                                    });
  for (const GrowthOfNewViews& g : growth) {
    if (is_last && g.scene == row.scene.name && g.threads == threads) return number(g.exponent);
  }
  return "";
}

/// The numbers of threads that the views were drawn on.
std::vector<int> threads_of_new_views(const Report& report) {
  std::vector<int> all;
  for (const Beside& b : report.beside) {
    const bool is_theirs = b.what == kNewViews || b.other == kTruth;
    if (is_theirs && std::ranges::find(all, b.threads) == all.end()) all.push_back(b.threads);
  }
  return all;
}

Summary empty_table(const std::vector<int>& threads, bool with_growth) {
  Summary summary{
      "moving-camera",
      "A new view of a retained scene",
      "How many times as fast a new view of a retained scene is, by the exact z-buffer and "
      "without a sort, as in OSMesa, with 24 bits of depth, a resident, indexed mesh and a new "
      "matrix: the median of rounds, each a turn of 8 views around the scene on both sides, the "
      "least and the greatest. Both sides get the same triangles, into which polygons are cut, "
      "with the same shared vertices in the same colours, back faces removed on both or on "
      "neither, and as many threads (one: the processor's time; several: the time on the wall). "
      "Timed on our side is all from the eye to the picture in memory, in OSMesa from the "
      "matrix until all is drawn, without reading it back. Wrong pixels: each of these views, "
      "on each number of threads, against the exact truth of its display file. Bytes a "
      "triangle: what is held of the scene as it is retained, its colours in it; what a view of "
      "it holds besides; and what the drawing holds, but for the picture. Growth: the exponent "
      "of a new view's time with the number of triangles, by least squares over all sizes of "
      "the scene.",
      {{"scene", "triangles", "picture"}}};
  auto& head = summary.rows.front();
  for (const int n : threads) {
    head.push_back(fmt::format("times as fast, {} thread{}", n, n == 1 ? "" : "s"));
  }
  head.insert(head.end(), {"wrong pixels", "bytes: scene", "view", "drawing"});
  for (const int n : threads) {
    if (with_growth) head.push_back(on_threads("growth", n));
  }
  return summary;
}

}  // namespace

std::vector<GrowthOfNewViews> growth_of_new_views(const Report& report) {
  std::vector<GrowthOfNewViews> all;
  for (const std::string& name : names_but_hard_cases(report)) {
    for (const int threads : threads_of_new_views(report)) {
      std::vector<double> triangles, costs;
      for (const SceneRow& row : report.scenes) {
        const auto size = count(report, row, threads, kOsmesa, kTriangles);
        if (row.scene.name != name || !size) continue;
        const Beside* const beside_first =
            find_beside(report, row.scene.id(), threads, kFewestPolygons, kNewViews);
        triangles.push_back(*size);
        costs.push_back(beside_first == nullptr ? 1.0 : 1.0 / beside_first->times_faster->median);
      }
      if (triangles.empty() || std::ranges::min(triangles) == std::ranges::max(triangles)) continue;
      all.push_back({name, threads, triangles.size(), figure(fitted_exponent(triangles, costs))});
    }
  }
  return all;
}

std::optional<Summary> moving_camera(const Report& report) {
  const std::vector<int> threads = threads_of_new_views(report);
  const std::vector<GrowthOfNewViews> growth = growth_of_new_views(report);
  Summary summary = empty_table(threads, !growth.empty());
  LeftOut left_out;
  for (const SceneRow& row : report.scenes) {
    const auto triangles =
        threads.empty() ? std::nullopt : count(report, row, threads.front(), kOsmesa, kTriangles);
    std::vector<std::string> cells{short_name(row.scene.name),
                                   triangles ? grouped(static_cast<std::int64_t>(*triangles)) : "",
                                   fmt::format("{0} x {0}", row.scene.size)};
    for (const int n : threads) cells.push_back(times_and_range(report, row, n, left_out));
    cells.push_back(wrong_pixels_in_all(report, row, threads));
    for (const char* what : {kRetainedScene, kView, kDrawing}) {
      const auto bytes =
          triangles ? count(report, row, threads.front(), kMemory, what) : std::nullopt;
      cells.push_back(bytes ? fmt::format("{:.0f}", *bytes) : "");
    }
    for (const int n : threads) {
      if (!growth.empty()) cells.push_back(exponent(growth, report, row, n));
    }
    const bool is_there = std::any_of(cells.begin() + 3, cells.end(),
                                      [](const std::string& cell) { return !cell.empty(); });
    if (is_there) summary.rows.push_back(std::move(cells));
  }
  if (summary.rows.size() == 1) return std::nullopt;
  summary.text += left_out.words();
  return summary;
}

bool is_of_moving_camera(const Beside& beside) {
  const bool is_osmesas =
      beside.what == kNewViews || beside.what == kTriangles || beside.what == kOtherPixels;
  return beside.other == kTruth || beside.other == kMemory || beside.other == kFewestPolygons ||
         (beside.other == kOsmesa && is_osmesas);
}

}  // namespace displayfile::bench
