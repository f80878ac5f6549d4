#pragma once

#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "hidden/boxes/extents.h"
#include "hidden/lines/line_table.h"
#include "hidden/primitives.h"

namespace displayfile {

/// Roberts's objects (hidden/lines/roberts.md): polygons that share sides, do not overlap in the
/// projection and have a convex outline together, such as the visible faces of a box. An object
/// covers every point within its outline. All other polygons are objects by themselves, without an
/// outline.
class ConvexObjects {
 public:
  /// Finds the objects among all polygons that hide. `scene` must be the table of `items`.
  ConvexObjects(const Primitives& items, const LineTable& scene);

  std::uint32_t size() const { return static_cast<std::uint32_t>(objects_.size()); }
  std::span<const std::uint32_t> polygons(std::uint32_t object) const {
    assert(object < size());
    const Object& o = objects_[object];
    return std::span(polygons_).subspan(o.first, o.polygons);
  }
  /// Points, counterclockwise; empty for a single polygon.
  std::span<const std::uint32_t> outline(std::uint32_t object) const {
    assert(object < size());
    const Object& o = objects_[object];
    return std::span(outlines_).subspan(o.first_point, o.points);
  }
  /// Extents around the objects' polygons, with the depths of their planes.
  std::span<const Extent> extents() const { return extents_; }

 private:
  struct Object {
    std::uint32_t first, polygons;      ///< in polygons_
    std::uint32_t first_point, points;  ///< in outlines_
  };
  void add(std::span<const std::uint32_t> polygons, std::span<const std::uint32_t> outline,
           const LineTable& scene);

  std::vector<Object> objects_;
  std::vector<Extent> extents_;
  std::vector<std::uint32_t> polygons_, outlines_;
};

}  // namespace displayfile
