#pragma once

#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "hidden/boxes/extents.h"
#include "hidden/lines/line_table.h"
#include "hidden/primitives.h"

namespace displayfile {

/// Roberts's objects (hidden/lines/roberts.md): polygons that share sides, lie beside each other in
/// the projection and have a convex outline together, as the faces that a box turns to the viewer
/// do. Within its outline an object covers every point. All other polygons are objects by
/// themselves, without an outline.
class ConvexObjects {
 public:
  /// Finds those among all polygons that hide. The scene is of the items.
  ConvexObjects(const Primitives& items, const LineTable& scene);

  std::uint32_t size() const { return static_cast<std::uint32_t>(objects_.size()); }
  std::span<const std::uint32_t> polygons(std::uint32_t object) const {
    assert(object < size());
    const Object& o = objects_[object];
    return std::span(polygons_).subspan(o.first, o.polygons);
  }
  /// Points, counterclockwise; none of a polygon that is an object by itself.
  std::span<const std::uint32_t> outline(std::uint32_t object) const {
    assert(object < size());
    const Object& o = objects_[object];
    return std::span(outlines_).subspan(o.first_point, o.points);
  }
  /// Around its polygons', at the depths of their planes.
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
