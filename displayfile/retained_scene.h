#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "clip/view.h"
#include "displayfile/lighting.h"
#include "displayfile/style.h"

namespace displayfile {

/// What an application drew, before viewing: polygons and lines in world coordinates, after the
/// modelling transformation, in segments. A GraphicsSystem that was told to retain
/// (GraphicsSystem::retain) fills it; displayfile/retained_views.h draws it in other views.
class RetainedScene {
 public:
  /// How primitives are drawn that were entered in a row.
  struct Attributes {
    FillStyle fill;
    LineStyle line;
    std::optional<Light> light;  ///< the fill is lit in each view
    bool back_face_removal = false;
    bool shadows = false;
    bool operator==(const Attributes&) const = default;
  };
  /// A polygon, or a line of two points.
  struct Primitive {
    std::size_t first;         ///< of its points
    std::uint32_t sides;       ///< 2: a line
    std::uint32_t attributes;  ///< index in the segment's
    std::int32_t pick;
    Point3 normal;  ///< of the whole polygon, where there is light
    bool is_line() const { return sides == 2; }
  };
  struct Segment {
    int name;
    View view;  ///< in which the application drew it
    std::vector<Point3> points;
    std::vector<std::uint8_t> edge_visible;  ///< of the side that ends at the point
    /// Of the points of polygons that are shaded smoothly, zero of others; empty if there are none.
    std::vector<Point3> vertex_normals;
    std::vector<Primitive> primitives;
    std::vector<Attributes> attributes;
  };

  /// Segments in order of creation. What they are drawn with, visibility and image
  /// transformation, is in the display file, under the same name.
  const std::vector<Segment>& segments() const { return segments_; }

  // For the GraphicsSystem, when the call has succeeded.
  void open_segment(int name, const View& view);
  void remove(int name);
  void remove_all() { segments_.clear(); }
  void rename(int from, int to);
  /// Into the segment opened last. edge_visible is empty if all sides are; vertex_normals unless
  /// the polygon is shaded smoothly.
  void enter_polygon(std::span<const Point3> world, std::span<const std::uint8_t> edge_visible,
                     const Attributes& attributes, const Point3& normal,
                     std::span<const Point3> vertex_normals, std::int32_t pick);
  void enter_line(const Point3& from, const Point3& to, const Attributes& attributes);

 private:
  void enter(std::span<const Point3> points, std::span<const std::uint8_t> edge_visible,
             const Attributes& attributes, const Point3& normal, std::int32_t pick);

  std::vector<Segment> segments_;
};

}  // namespace displayfile
