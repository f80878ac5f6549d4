#include "interp/steps/active_edges.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <string>

namespace displayfile {

std::vector<StepRow> rows_of(const StepItems& scene, const StepRecord& record,
                             ActiveEdgesOfRow edges, std::size_t first, std::size_t end) {
  constexpr std::size_t kBefore = StepRecord::kMostRows / 4;
  const std::size_t from =
      edges.size() <= StepRecord::kMostRows || first < kBefore ? 0 : first - kBefore;
  std::vector<StepRow> rows;
  std::set<ViewedScene::Fill> in;
  for (std::size_t k = 0; k < edges.size() && rows.size() < StepRecord::kMostRows; ++k) {
    const auto& [edge, fill, column, x] = edges[k];
    const bool enters = in.erase(fill) == 0;
    if (enters) in.insert(fill);
    if (k < from) continue;
    const StepItems::Polygon polygon = scene.viewed().item_of(fill);
    rows.push_back(
        {{record.name(polygon), fmt::format("{:.2f}", x), fmt::format("{:+.2f}", edge.dx_dy),
          std::to_string(edge.last_row), enters ? "IN" : "OUT"},
         polygon,
         first <= k && k < end ? StepRole::active : StepRole::none});
  }
  return rows;
}

std::vector<StepRun> runs_of(const StepItems& scene, ActiveEdgesOfRow edges, int row) {
  std::map<ViewedScene::Fill, std::vector<int>> columns;
  for (const ActiveEdgeList::Edge& e : edges) columns[e.fill].push_back(e.column);
  std::vector<StepRun> runs;
  for (const auto& [fill, of_fill] : columns) {
    for (std::size_t k = 0; k + 1 < of_fill.size(); k += 2) {
      if (of_fill[k] == of_fill[k + 1]) continue;
      runs.push_back({row, of_fill[k], of_fill[k + 1], scene.viewed().item_of(fill)});
    }
  }
  return runs;
}

std::vector<StepSegment> profile_of(const StepItems& scene, const std::vector<StepRun>& runs) {
  const double width = scene.size().width;
  std::vector<StepSegment> segments;
  segments.reserve(runs.size());
  for (const auto& [row, first, end, polygon] : runs) {
    segments.push_back({first / width, scene.depth(polygon, first, row), end / width,
                        scene.depth(polygon, end - 1, row), polygon});
  }
  return segments;
}

void mark_edges(StepRecord& record, ActiveEdgesOfRow edges) {
  for (const ActiveEdgeList::Edge& e : edges) {
    record.mark(StepRole::active, {e.edge.low, e.edge.high}, StepMark::Kind::line);
  }
}

}  // namespace displayfile
