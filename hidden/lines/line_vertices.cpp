#include "hidden/lines/line_vertices.h"

#include <algorithm>

namespace displayfile {

LineVertices::LineVertices(const LineTable& scene, const Primitives& items, const SideTable& sides,
                           const ContourEdges& contours)
    : sides_(sides), joins_(items.points.size(), 0), first_(items.points.size() + 1, 0) {
  for (const std::uint32_t n : scene.first_lines_of_names()) {
    for (const std::uint32_t point : {scene.lines()[n].a, scene.lines()[n].b}) {
      std::uint8_t& ends = joins_[vertex(point)];
      ends = static_cast<std::uint8_t>(std::min(ends + 1, 2));
    }
  }
  for (std::uint8_t& ends : joins_) ends = ends == 2 ? 1 : 0;
  const auto for_each_corner = [&](const auto& visit) {
    for (std::uint32_t i = 0; i < items.items.size(); ++i) {
      if (contours.way(i) == 0) continue;
      for (std::uint32_t k = 0; k < items.items[i].sides; ++k) {
        const std::uint32_t v = vertex(items.point(items.items[i].first + k));
        if (joins_[v] != 0) visit(v, LineName{i, k});
      }
    }
  };
  for_each_corner([&](std::uint32_t v, const LineName&) { ++first_[v + 1]; });
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  corners_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for_each_corner([&](std::uint32_t v, const LineName& corner) { corners_[next[v]++] = corner; });
}

}  // namespace displayfile
