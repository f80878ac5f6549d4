#include "hidden/map/seen_faces.h"

#include <algorithm>

#include "clip/base/parallel.h"
#include "clip/geometry/corners.h"
#include "hidden/exact/depth_order.h"
#include "hidden/exact/orientation.h"
#include "hidden/lines/visible_pieces.h"

namespace displayfile {

namespace {

/// A triangle is looked up in cells if it is at most this many cells long.
constexpr double kMostCellsToLookUp = 16.0;

/// Determines the visibility of polygons, one at a time, among those near each.
class FaceFinder {
 public:
  FaceFinder(const LineTable& scene, const ContourEdges& ways, const CellGrid& grid)
      : scene_(scene), ways_(ways), grid_(grid), looked_at_(scene.items(), 0) {}

  SeenFaces::Seen look_at(std::uint32_t item) {
    using enum SeenFaces::Seen;
    if (!scene_.hides(item) || grid_.hides(scene_.extent(item)) || is_behind_cells(item)) {
      return nothing;
    }
    if (!is_convex(item)) return some;
    if (grid_.shows(scene_.extent(item))) return whole;
    item_ = item;
    plane_ = scene_.plane(item);
    if (++number_ == 0) {  // all numbers were used
      std::ranges::fill(looked_at_, 0);
      number_ = 1;
    }
    looked_at_[item] = number_;
    return look_around();
  }

 private:
  /// True if all of a triangle is behind the blocking faces of its cells of the finest level.
  bool is_behind_cells(std::uint32_t item) const {
    const CellGrid::Level& level = grid_.levels()[0];
    const int way = ways_.way(item);
    if (level.behind.empty() || scene_.sides(item) != 3 || way == 0) return false;
    const Extent& box = scene_.extent(item);
    const CellLayout& layout = grid_.layout();
    if (layout.length_in_cells(rectangle_of(box)) > kMostCellsToLookUp) return false;
    const CellLayout::Range cells = layout.range(rectangle_of(box), 0);
    for (std::uint32_t j = cells.bottom; j <= cells.top; ++j) {
      for (std::uint32_t i = cells.left; i <= cells.right; ++i) {
        const bool is_blocked = level.behind[std::size_t{j} * level.columns + i] > box.z_max;
        if (!is_blocked && !is_outside(item, way, i, j)) return false;
      }
    }
    return true;
  }
  /// True if a cell is outside of a side of a triangle.
  bool is_outside(std::uint32_t item, int way, std::uint32_t i, std::uint32_t j) const {
    const CellLayout& layout = grid_.layout();
    const Point2 low = layout.origin() + layout.cell() * (Point2(i, j) - CellLayout::kMargin);
    const Point2 high =
        layout.origin() + layout.cell() * (Point2(i + 1, j + 1) + CellLayout::kMargin);
    Point2 p(scene_.corner(item, 2));
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Point2 q(scene_.corner(item, k));
      const Point2 along = static_cast<double>(way) * (q - p);
      // The corner of the cell that is farthest on the inner side.
      const Point2 corner(along.y < 0.0 ? high.x : low.x, along.x > 0.0 ? high.y : low.y);
      if (filtered_orientation(p, q, corner) * way < 0) return true;
      p = q;
    }
    return false;
  }

  bool is_convex(std::uint32_t item) const {
    const std::uint32_t sides = scene_.sides(item);
    const int way = ways_.way(item);
    if (sides == 3 || way == 0) return way != 0;
    const auto at = [&](std::uint32_t k) { return Point2(scene_.corner(item, k)); };
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t next = next_corner(k, sides);
      if (orientation(at(k), at(next), at(next_corner(next, sides))) * way < 0) return false;
    }
    return true;
  }

  /// Determines the visibility from each of the polygons near it.
  SeenFaces::Seen look_around() {
    using enum SeenFaces::Seen;
    const Extent& box = scene_.extent(item_);
    const bool is_in_cover = !scene_.all_even() && grid_.shows_in_cover(box);
    SeenFaces::Seen seen = whole;
    const auto levels = grid_.levels();
    for (std::size_t k = levels.size(); k-- > 0;) {
      const CellGrid::Level& level = levels[k];
      if (level.entries.empty()) continue;
      const CellLayout::Range cells = grid_.layout().range(rectangle_of(box), k);
      for (std::uint32_t j = cells.bottom; j <= cells.top; ++j) {
        for (std::uint32_t i = cells.left; i <= cells.right; ++i) {
          for (const CellGrid::Entry& e : level.in_cell(std::size_t{j} * level.columns + i)) {
            if (e.z_max < box.z_min) break;  // and so are those after it
            if (!e.meets(box) || looked_at_[e.polygon] == number_) continue;
            looked_at_[e.polygon] = number_;
            if (is_clearly_behind(e.polygon) || is_beside(e.polygon) || is_behind(e.polygon)) {
              continue;
            }
            if (is_in_cover) return entire;
            if (!is_behind_by_planes(e.polygon)) return some;
            seen = entire;
          }
        }
      }
    }
    return seen;
  }

  /// True if a side separates both in the projection.
  bool is_beside(std::uint32_t other) const {
    return parts(item_, ways_.way(item_), other) ||
           (ways_.way(other) != 0 && scene_.sides(other) == 3 &&
            parts(other, ways_.way(other), item_));
  }
  /// True if all of the other polygon is on the outer side of a side of a convex one.
  bool parts(std::uint32_t convex, int way, std::uint32_t other) const {
    const std::uint32_t sides = scene_.sides(convex);
    Point2 p(scene_.corner(convex, sides - 1));
    for (std::uint32_t k = 0; k < sides; ++k) {
      const Point2 q(scene_.corner(convex, k));
      if (has_no_corner_inside(p, q, way, other)) return true;
      p = q;
    }
    return false;
  }
  bool has_no_corner_inside(const Point2& p, const Point2& q, int way, std::uint32_t other) const {
    const std::uint32_t sides = scene_.sides(other);
    for (std::uint32_t k = 0; k < sides; ++k) {
      const Point2 c(scene_.corner(other, k));
      if (c == p || c == q) continue;  // polygons share points
      if (orientation(p, q, c) * way > 0) return false;
    }
    return true;
  }

  /// True if is_behind is true without exact arithmetic.
  bool is_clearly_behind(std::uint32_t other) const {
    bool any = false;
    for (std::uint32_t k = 0; k < scene_.sides(other); ++k) {
      const Point3& c = scene_.corner(other, k);
      if (plane_.goes_through(c)) continue;
      const auto [value, bound] = plane_value(c, plane_);
      if (!(value < -bound)) return false;
      any = true;
    }
    return any && (ways_.is_even(other) || is_behind(other));
  }
  /// The same as is_behind for an uneven polygon, whose depths are those of its own plane. By the
  /// filter only.
  bool is_behind_by_planes(std::uint32_t other) const {
    if (ways_.is_even(other)) return false;
    const Plane of_other = scene_.plane(other);
    for (std::uint32_t k = 0; k < scene_.sides(other); ++k) {
      const Point3& c = scene_.corner(other, k);
      if (filtered_depth_order(of_other, plane_, {c.x, c.y, 0.0}) >= 0) return false;
    }
    return true;
  }
  /// True if all of the other polygon is behind the plane, and not all of it in the plane.
  bool is_behind(std::uint32_t other) const {
    bool any = false;
    for (std::uint32_t k = 0; k < scene_.sides(other); ++k) {
      if (scene_.is_off_plane(other, k)) return false;
      const Point3& c = scene_.corner(other, k);
      if (plane_.goes_through(c)) continue;
      const int side = side_of_plane(c, plane_);
      if (side > 0) return false;
      any |= side < 0;
    }
    return any;
  }

  const LineTable& scene_;
  const ContourEdges& ways_;
  const CellGrid& grid_;
  std::uint32_t item_ = 0;
  Plane plane_;
  std::vector<std::uint32_t> looked_at_;
  std::uint32_t number_ = 0;
};

}  // namespace

SeenFaces::SeenFaces(const LineTable& scene) {
  for (std::uint32_t i = 0; i < scene.items(); ++i) {
    seen_.push_back(scene.hides(i) ? Seen::some : Seen::nothing);
  }
}

SeenFaces::SeenFaces(const LineTable& scene, const ContourEdges& ways, const CellGrid& grid,
                     int threads)
    : seen_(scene.items(), Seen::nothing) {
  if (grid.levels().empty()) return;
  constexpr std::size_t kFacesOfAPart = 4096;
  const auto make_finder = [&] { return FaceFinder(scene, ways, grid); };
  Finders finders(make_finder);
  in_parallel(threads, (seen_.size() + kFacesOfAPart - 1) / kFacesOfAPart, [&](std::size_t part) {
    const std::size_t end = std::min(seen_.size(), (part + 1) * kFacesOfAPart);
    finders.use([&](FaceFinder& finder) {
      for (std::size_t i = part * kFacesOfAPart; i < end; ++i) {
        seen_[i] = finder.look_at(static_cast<std::uint32_t>(i));
      }
    });
  });
}

}  // namespace displayfile
