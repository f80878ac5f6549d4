#include "hidden/lines/contour_edges.h"

#include <algorithm>
#include <cassert>

#include "clip/base/parallel.h"
#include "clip/corners.h"
#include "hidden/lines/simple_polygon.h"

namespace displayfile {

namespace {

bool has_corner_off_plane(const LineTable& scene, std::uint32_t item) {
  for (std::uint32_t k = 0; k < scene.sides(item); ++k) {
    if (scene.is_off_plane(item, k)) return true;
  }
  return false;
}

}  // namespace

ContourEdges::ContourEdges(const LineTable& scene, const Primitives& items, const SideTable& sides,
                           int threads)
    : way_(scene.items(), 0), has_contour_(scene.items(), 0) {
  constexpr std::size_t kPart = 2048;
  if (!scene.all_even()) uneven_.resize(scene.items(), 0);
  in_parallel(threads, (way_.size() + kPart - 1) / kPart, [&](std::size_t part) {
    const std::size_t end = std::min(way_.size(), (part + 1) * kPart);
    for (auto i = static_cast<std::uint32_t>(part * kPart); i < end; ++i) {
      if (!scene.hides(i)) continue;
      way_[i] = static_cast<std::int8_t>(simple_turning(scene.sides(i), [&](std::size_t k) {
        return Point2(scene.corner(i, static_cast<std::uint32_t>(k)));
      }));
      if (!uneven_.empty()) uneven_[i] = has_corner_off_plane(scene, i) ? 1 : 0;
      has_contour_[i] = way_[i] == 0 || !is_even(i) ? 1 : 0;
    }
  });
  std::vector<Edge> edges;
  std::vector<DepthBox> boxes;
  sides.for_each_set([&](std::span<const SideTable::Side> same) {
    std::int32_t more = 0;
    std::uint32_t p = 0, q = 0;
    for (const auto& [high, name] : same) {
      const Primitives::Item& item = items.items[name.item];
      const std::uint32_t before = previous_corner(name.corner, item.sides);
      p = sides.vertex(items.point(item.first + before));
      q = high;
      if (p != q) {  // it runs to the higher one
        more += way(name.item);
      } else {
        p = sides.vertex(items.point(item.first + name.corner));
        more -= way(name.item);
      }
    }
    const bool all_even = std::ranges::all_of(
        same, [&](const SideTable::Side& side) { return is_even(side.name.item); });
    if (more != 0 || !all_even) {
      for (const auto& [high, name] : same) {
        has_contour_[name.item] = 1;
        contour_sides_.push_back(name);
      }
    }
    if (more == 0) return;
    edges.push_back({items.points[p], items.points[q], more});
    DepthBox box = DepthBox::nothing();
    box.extent.include(edges.back().p);
    box.extent.include(edges.back().q);
    boxes.push_back(box);
  });
  std::ranges::sort(contour_sides_);
  tree_.build(boxes, threads);
  edges_.reserve(edges.size());
  for (const DepthTree::Item i : tree_.order()) edges_.push_back(edges[i]);
  assert(edges_.size() == edges.size());
}

}  // namespace displayfile
