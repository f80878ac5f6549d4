#include "hidden/lines/contour_edges.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "clip/base/parallel.h"
#include "clip/geometry/corners.h"
#include "hidden/boxes/build_box_tree.h"
#include "hidden/lines/simple_polygon.h"

namespace displayfile {

template <>
void DepthTree::build(std::size_t items, const std::function<DepthBox(Item)>& box_of, int threads) {
  build_by<Halves<DepthBox>>(items, box_of, threads);
}

namespace {

/// The maximum distance in depth of corners from the polygon's plane; 0 if none is off it.
double depth_off_plane(const LineTable& scene, std::uint32_t item) {
  double off = 0.0;
  for (std::uint32_t k = 0; k < scene.sides(item); ++k) {
    if (!scene.is_off_plane(item, k)) continue;
    const Plane plane = scene.plane(item);
    const auto [value, bound] = plane_value(scene.corner(item, k), plane);
    const double least = std::abs(plane.normal.z) - plane.bound.z;
    if (!(least > 0.0)) return std::numeric_limits<double>::infinity();
    off = std::max(off, (std::abs(value) + bound) / least * (1.0 + 0x1p-40));
  }
  return off;
}

/// A polygon with corners farther off its plane than this does not continue a cover.
double most_off_plane(const LineTable& scene) {
  constexpr double kOfScene = 0x1p-10;
  Extent all = Extent::nothing();
  for (const Extent& box : scene.extents()) {
    if (box.x_min <= box.x_max) all.include(box);
  }
  return kOfScene * std::max(0.0, double{all.z_max} - double{all.z_min});
}

}  // namespace

ContourEdges::ContourEdges(const LineTable& scene, const Primitives& items, const SideTable& sides,
                           int threads)
    : way_(scene.items(), 0), has_contour_(scene.items(), 0) {
  constexpr std::size_t kPart = 2048;
  std::vector<double> off_plane;
  if (!scene.all_even()) {
    uneven_.resize(scene.items(), 0);
    off_plane.resize(scene.items(), 0.0);
  }
  const double most_off = scene.all_even() ? 0.0 : most_off_plane(scene);
  in_parallel(threads, (way_.size() + kPart - 1) / kPart, [&](std::size_t part) {
    const std::size_t end = std::min(way_.size(), (part + 1) * kPart);
    for (auto i = static_cast<std::uint32_t>(part * kPart); i < end; ++i) {
      if (!scene.hides(i)) continue;
      way_[i] = static_cast<std::int8_t>(simple_turning(scene.sides(i), [&](std::size_t k) {
        return Point2(scene.corner(i, static_cast<std::uint32_t>(k)));
      }));
      if (!uneven_.empty()) {
        off_plane[i] = depth_off_plane(scene, i);
        if (off_plane[i] > 0.0) uneven_[i] = off_plane[i] <= most_off ? kOfDepth : kOfCover;
        has_contour_[i] = uneven_[i];
      }
      if (way_[i] == 0) has_contour_[i] = kOfCover;
    }
  });
  for (std::size_t i = 0; i < off_plane.size(); ++i) {
    if (uneven_[i] == kOfDepth) step_ = std::max(step_, 2.0 * off_plane[i]);
  }
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
      if (p != q) {  // it runs toward the higher point
        more += way(name.item);
      } else {
        p = sides.vertex(items.point(item.first + name.corner));
        more -= way(name.item);
      }
    }
    const auto is_any_uneven = [&](Of of) {
      return std::ranges::any_of(
          same, [&](const SideTable::Side& side) { return is_uneven(side.name.item, of); });
    };
    if (more != 0 || is_any_uneven(Of::depth)) {
      const bool ends_cover = more != 0 || is_any_uneven(Of::cover);
      for (const auto& [high, name] : same) {
        std::uint8_t& contour = has_contour_[name.item];
        contour = std::max(contour, ends_cover ? kOfCover : kOfDepth);
        contour_sides_.push_back(name);
        if (ends_cover && !uneven_.empty()) cover_sides_.push_back(name);
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
  std::ranges::sort(cover_sides_);
  tree_.build(boxes, threads);
  edges_.reserve(edges.size());
  for (const DepthTree::Item i : tree_.order()) edges_.push_back(edges[i]);
  assert(edges_.size() == edges.size());
}

}  // namespace displayfile
