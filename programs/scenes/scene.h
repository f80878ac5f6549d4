#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "clip/surfaces.h"
#include "clip/view.h"
#include "clip/view/transformation.h"
#include "displayfile/graphics_system.h"
#include "displayfile/views/scene_in_one_view.h"

namespace displayfile {

/// The vertices of a polygon, in order.
using Polygon = std::vector<Point3>;

/// A parallel view in which world coordinates are device coordinates, to the last bit.
View unit_view();

/// The result of a generator: polygons in order of entry, in segments that may have an image
/// transformation, and the view in which they are entered.
struct Scene {
  struct Segment {
    std::size_t first_polygon;
    ImageTransformation image;
    std::optional<View> view = {};  ///< from this segment on, with its viewport; none: as before
  };
  /// A modelling transformation, of its polygon and of all after it up to the next placement.
  struct Placement {
    std::size_t first_polygon;
    Point3 move;       ///< acts first
    Point3 degrees;    ///< turns about the x, the y and the z axis, in this order, act next
    Point3 then_move;  ///< acts last
  };

  View view = unit_view();
  std::vector<Point3> points;         ///< polygon after polygon, before its placement
  std::vector<std::uint32_t> sides;   ///< of each polygon
  std::vector<Segment> segments;      ///< none: one, without image transformation
  std::vector<Placement> placements;  ///< none: points are in world coordinates
  /// Gaps are the subject of many scenes, some smaller than the precision of doubles.
  Touching touching{Touching::Kind::off};

  std::size_t polygons() const { return sides.size(); }
  void add(std::span<const Point3> polygon);
  void add(std::initializer_list<Point3> polygon) {
    add(std::span(polygon.begin(), polygon.size()));
  }
  void add(const std::vector<Polygon>& polygons);
  /// The polygons added from now on are in a segment of their own.
  void open_segment(const ImageTransformation& image) { segments.push_back({polygons(), image}); }
  /// The same, in another view, whose viewport counts.
  void open_segment(const View& other) { segments.push_back({polygons(), {}, other}); }
  /// The polygons added from now on are moved, turned and moved again (Placement).
  void place(const Point3& move, const Point3& degrees, const Point3& then_move) {
    placements.push_back({polygons(), move, degrees, then_move});
  }
};

/// Enters the scene into a system without segments: sets the view, then segments 1, 2, … with
/// solid fills of different colours, no lines, and no back-face removal. The pick identifiers
/// are the ordinals.
void enter(const Scene& scene, GraphicsSystem& system);

/// Enters the scene into a new system.
GraphicsSystem entered(const Scene& scene);

}  // namespace displayfile
