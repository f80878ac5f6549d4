#include "interp/steps/active_edges.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace displayfile {

ActiveEdges::ActiveEdges(const StepScene& scene) : size_(scene.size()) {
  for (const Polygon polygon : scene.fills()) {
    std::vector<ScanEdge> edges;
    append_edges(scene.vertices(polygon), size_, 0, size_.height, edges);
    for (const ScanEdge& edge : edges) table_.push_back({edge, polygon, 0, 0.0});
  }
  std::ranges::stable_sort(table_, {}, [](const Edge& e) { return e.edge.first_row; });
}

ActiveEdges::Change ActiveEdges::go_to(int row) {
  const std::size_t left =
      std::erase_if(active_, [&](const Edge& e) { return e.edge.last_row < row; });
  const std::size_t first = next_;
  while (next_ < table_.size() && table_[next_].edge.first_row <= row) {
    active_.push_back(table_[next_++]);
  }
  for (Edge& e : active_) {
    e.column = e.edge.column(row, size_);
    e.x = e.edge.x + (row + 0.5 - e.edge.y) * e.edge.dx_dy;
  }
  std::ranges::stable_sort(active_, [](const Edge& a, const Edge& b) {
    return a.column != b.column ? a.column < b.column : a.x < b.x;
  });
  return {next_ - first, left};
}

std::vector<StepRow> ActiveEdges::rows(const StepRecord& record, std::size_t first,
                                       std::size_t end) const {
  constexpr std::size_t kBefore = StepRecord::kMostRows / 4;
  const std::size_t from =
      active_.size() <= StepRecord::kMostRows || first < kBefore ? 0 : first - kBefore;
  std::vector<StepRow> rows;
  std::set<Polygon> in;
  for (std::size_t k = 0; k < active_.size() && rows.size() < StepRecord::kMostRows; ++k) {
    const Edge& e = active_[k];
    const bool enters = in.erase(e.polygon) == 0;
    if (enters) in.insert(e.polygon);
    if (k < from) continue;
    rows.push_back(
        {{record.name(e.polygon), fmt::format("{:.2f}", e.x), fmt::format("{:+.2f}", e.edge.dx_dy),
          std::to_string(e.edge.last_row), enters ? "IN" : "OUT"},
         e.polygon,
         first <= k && k < end ? StepRole::active : StepRole::none});
  }
  return rows;
}

std::vector<StepRun> ActiveEdges::runs(int row) const {
  std::map<Polygon, std::vector<int>> columns;
  for (const Edge& e : active_) columns[e.polygon].push_back(e.column);
  std::vector<StepRun> runs;
  for (const auto& [polygon, of_polygon] : columns) {
    for (std::size_t k = 0; k + 1 < of_polygon.size(); k += 2) {
      if (of_polygon[k] == of_polygon[k + 1]) continue;
      runs.push_back({row, of_polygon[k], of_polygon[k + 1], polygon});
    }
  }
  return runs;
}

std::vector<StepSegment> profile_of(const StepScene& scene, const std::vector<StepRun>& runs) {
  const double width = scene.size().width;
  std::vector<StepSegment> segments;
  segments.reserve(runs.size());
  for (const auto& [row, first, end, polygon] : runs) {
    segments.push_back({first / width, scene.depth(polygon, first, row), end / width,
                        scene.depth(polygon, end - 1, row), polygon});
  }
  return segments;
}

void mark_edges(StepRecord& record, const ActiveEdges& edges) {
  for (const ActiveEdges::Edge& e : edges.edges()) {
    record.mark(StepRole::active, {e.edge.low, e.edge.high}, StepMark::Kind::line);
  }
}

}  // namespace displayfile
