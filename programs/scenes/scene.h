#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/view.h"
#include "displayfile/graphics_system.h"
#include "displayfile/set_view.h"
#include "hidden/touching.h"

namespace displayfile {

/// The vertices of a polygon, in order.
using Polygon = std::vector<Point3>;

/// A parallel view in which world coordinates are device coordinates, to the last bit.
View unit_view();

/// What a generator makes: polygons in order of entry, in segments that may have an image
/// transformation, and the view in which they are entered.
struct Scene {
  struct Segment {
    std::size_t first_polygon;
    ImageTransformation image;
  };

  View view = unit_view();
  std::vector<Point3> points;        ///< world coordinates, polygon after polygon
  std::vector<std::uint32_t> sides;  ///< of each polygon
  std::vector<Segment> segments;     ///< none: one, without image transformation
  /// Gaps are what many are about, also such as are less than numbers can tell.
  Touching touching{Touching::Kind::off};

  std::size_t polygons() const { return sides.size(); }
  void add(std::span<const Point3> polygon);
  void add(std::initializer_list<Point3> polygon) {
    add(std::span(polygon.begin(), polygon.size()));
  }
  void add(const std::vector<Polygon>& polygons);
  /// The polygons added from now on are in a segment of their own.
  void open_segment(const ImageTransformation& image) { segments.push_back({polygons(), image}); }
};

/// Enters the scene into a system without segments: sets the view, then segments 1, 2, … with
/// solid fills of different colours, no lines, and no back-face removal. The pick identifiers
/// are the ordinals.
void enter(const Scene& scene, GraphicsSystem& system);

/// Enters the scene into a new system.
GraphicsSystem entered(const Scene& scene);

}  // namespace displayfile
