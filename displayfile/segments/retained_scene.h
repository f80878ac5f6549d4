#pragma once

#include <cstdint>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/mat4x3.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "clip/base/growing_array.h"
#include "clip/base/watched.h"
#include "clip/surfaces.h"
#include "clip/view.h"
#include "displayfile/entered/modelling_runs.h"
#include "displayfile/entered/retained_polygons.h"
#include "displayfile/looks/style.h"
#include "displayfile/segments/polygon_stage.h"
#include "hidden/exact/entered_polygon.h"
#include "hidden/exact/eye.h"
#include "hidden/primitives.h"

namespace displayfile {

class DisplayFile;
class SideKinds;

/// An application's scene before viewing: polygons and lines in world coordinates, after the
/// modelling transformation, in segments; for polygons also the points as entered, and the
/// modelling matrices in force. A GraphicsSystem with retain() fills it;
/// displayfile/views/retained_views.h draws it in other views.
class RetainedScene : public Watched<RetainedScene> {
 public:
  using Primitive = RetainedPrimitive;
  /// A surface over a grid entered by one call.
  struct Surface {
    Point3 upward;  ///< its direction of growing z
    std::uint32_t x_points, y_points;
  };
  struct Segment {
    int name;
    View view;                             ///< the application's view of it
    std::uint32_t first, end;              ///< of its primitives
    std::uint32_t first_point, end_point;  ///< of their points, all of them used
    std::uint32_t first_text = 0, end_text = 0;
    /// The number of segments the scene had opened before it, removed ones included.
    std::uint32_t opened = 0;
    /// Which sides are lines; null: all that the line style shows.
    std::shared_ptr<const SideKinds> sides = nullptr;
    bool intersections = false;  ///< also draws lines where polygons intersect
    std::vector<Surface> surfaces = {};
    Touching touching{Touching::Kind::off};
    std::vector<KeptAnnotation> annotations = {};
  };
  /// Texts are not primitives: they hide nothing.
  struct Text {
    Point3 anchor;
    std::uint32_t next;  ///< the primitive entered after it
    std::uint32_t attributes;
    std::string characters;
  };

  /// Changes when the scene changes, for observers.
  struct Edition {
    std::uint64_t edits = 0;
    std::size_t segments = 0, primitives = 0, corners = 0, points = 0, texts = 0;
    std::size_t annotations = 0;
    bool shares_points = false;
    bool operator==(const Edition& o) const = default;
  };
  Edition edition() const {
    return {place()->edits, segments_.size(), primitives_.size(), all_corners(),
            points_.size(), texts_.size(),    annotations_,       has_shared()};
  }

  /// A modelling matrix: x' = column 0 x + column 1 y + column 2 z + column 3.
  using ModellingMatrix = ModellingRuns::Matrix;

  /// Segments in order of creation. Their visibility and image transformation are in the display
  /// file, under the same name.
  const std::vector<Segment>& segments() const { return segments_; }
  std::span<const Point3> points(const Segment& segment) const {
    return std::span<const Point3>(points_).subspan(segment.first_point,
                                                    segment.end_point - segment.first_point);
  }
  std::span<const Text> texts(const Segment& segment) const {
    return std::span(texts_).subspan(segment.first_text, segment.end_text - segment.first_text);
  }
  const Segment& segment_of(std::uint32_t primitive) const;

  /// The primitives of all segments, in order of entry.
  std::uint32_t size() const { return static_cast<std::uint32_t>(primitives_.size()); }
  const Primitive& operator[](std::uint32_t i) const { return primitives_[i]; }
  PointRow points(std::uint32_t i) const {
    if (corners_.empty()) return of(points_, i);
    return {points_, corners(i)};
  }
  /// The indices of its points. Requires shared points.
  std::span<const std::uint32_t> corners(std::uint32_t i) const { return of(corners_, i); }
  /// The length of the longest column of the modelling matrices, at least 1.
  double longest_column() const { return modellings_.longest_column(); }
  /// The distance within which vertices of the segment's polygons are merged, in world coordinates.
  double reach_in_world(const Segment& segment) const;
  /// Bound on all world coordinates, and on the products summed for them.
  double largest_in_world() const;
  /// Their rounding error, in units of 2^-53 of that bound (hidden/exact/entered_polygon.h).
  double roundings_in_world() const { return has_cuts_ ? kRoundingsWhereCut : kRoundingsInWorld; }
  /// True if no modelling transformation was in force.
  bool is_entered_in_world() const { return modellings_.empty(); }
  /// A polygon's points as entered, before the modelling transformation; if cutting planes cut it,
  /// including the cut points. Results of solid operations count as entered in world coordinates,
  /// and so do the ends of lines.
  PointRow entered_points(std::uint32_t i) const {
    if (entered_.empty()) return points(i);
    if (corners_.empty()) return of(entered_, i);
    return {entered_, corners(i)};
  }
  /// The modelling matrix in force when they were entered.
  const ModellingMatrix& modelling_matrix(std::uint32_t i) const;
  /// A segment's primitives as entered, in the scene's own arrays.
  RetainedPolygons entered_polygons(const Segment& segment) const;
  /// The first corner of a segment's primitives.
  std::uint32_t first_corner(const Segment& segment) const {
    return segment.first < size() ? primitives_[segment.first].first
                                  : static_cast<std::uint32_t>(all_corners());
  }
  /// The primitive with that first corner.
  std::uint32_t primitive_of_corner(std::uint32_t first) const;
  /// True if the side that ends at this corner of the primitive, counted from 0, was not made by
  /// cutting a polygon into triangles.
  bool edge_visible(std::uint32_t i, std::uint32_t corner) const {
    return edge_visible_[primitives_[i].first + corner] != 0;
  }
  /// True if some polygons were entered with shared vertices.
  bool has_shared() const { return !corners_.empty(); }
  Attributes attributes(std::uint32_t i) const;
  /// The same, without the colour of the fill: polygons of many colours share all else.
  const Attributes& shared_attributes(std::uint32_t i) const {
    return attributes_[attributes_of_look(primitives_[i].look)];
  }
  const Colour& fill_colour(std::uint32_t i) const { return colours_[primitives_[i].look]; }
  std::span<const Colour> fill_colours() const { return colours_; }  ///< by look
  std::span<const Attributes> all_attributes() const { return attributes_; }
  /// An index into all_attributes.
  std::uint32_t attributes_of_look(std::uint32_t look) const { return attributes_of_look_[look]; }
  const Attributes& attributes(const Text& text) const { return attributes_[text.attributes]; }
  /// A primitive that is a polygon, for a view stage.
  WorldPolygon polygon(std::uint32_t i) const;
  Point3 normal(std::uint32_t i) const;   ///< of a lit polygon, out of its light face, or 0
  bool is_smooth(std::uint32_t i) const;  ///< its vertices have normals
  bool draws(std::uint32_t i) const;      ///< false for hollow polygons with line style none
  /// The largest distance of a vertex from the plane that a tree uses for the polygon: one of more
  /// than three sides counts as planar within a tolerance (clip/geometry/planarity.h).
  double off_plane(std::uint32_t i) const;
  double off_plane(std::uint32_t i, const Plane& plane) const;  ///< from that plane

  /// The primitives that draw something, as items of a sort in world coordinates; points and edges
  /// are the scene's own. Fills primitive_of with the items' primitives.
  std::vector<Primitives::Item> items(std::vector<std::uint32_t>& primitive_of) const;
  Primitives primitives(std::span<const Primitives::Item> items) const {
    return {points_, corners_, edge_visible_, items};
  }

  /// True if a segment has lines where polygons intersect.
  bool has_intersections() const;
  /// True if a segment selects sides other than those that the line style shows.
  bool selects_lines() const;
  /// True if back faces of a polygon of the segment are removed.
  bool removes_back_faces(const Segment& segment) const;
  /// The kinds in a view of the side that ends at each corner, 0 where it is not drawn, whatever
  /// the line style; 1 for all sides of segments without a selection.
  void sides_in_view(const Eye& eye, std::vector<LineKinds>& of_corners) const;
  /// The same over all views: 0 for sides that no view draws.
  std::vector<LineKinds> sides_in_any_view() const;

  /// A scene of the segments for which the function returns true.
  RetainedScene selected(const std::function<bool(const Segment&)>& is_selected) const;
  /// A scene of the segments that are visible in the display file of the system that retained them.
  RetainedScene visible_in(const DisplayFile& display_file) const;

  /// Enters one of the scene's segments into a segment of a display file, completely and in order
  /// of entry, through the stage of a view; lights are rotated by `lights_turned`. The drawn sides
  /// are those that the segment selects for the view's eye. Calls is_item(primitive) for each
  /// entered primitive that draws something: these are the items, in order, of the viewed scene
  /// (displayfile/segments/viewed_scene.h).
  void enter_viewed(const Segment& part, const Eye& eye, PolygonStage& stage,
                    const glm::dmat3& lights_turned, displayfile::Segment& segment,
                    const std::function<void(std::uint32_t)>& is_item) const;

  // Called by GraphicsSystem after a successful call.
  void open_segment(int name, const View& view, const Touching& touching = {Touching::Kind::off});
  /// Completes the segment opened last with this selection of lines.
  void close_segment(const LineSelection& lines);
  /// Continues the segment closed last.
  void reopen_segment();
  void remove(int name);
  void remove_all();
  void rename(int from, int to);
  /// Sets the view of the segment that was opened as the scene's number `opened`.
  void set_view(std::uint32_t opened, const View& view);
  /// Replaces `light` by another one wherever it lights primitives.
  void replace_light(const Light& light, const Light& other);
  /// Enters into the segment opened last. Throws Error, before entering, for more than 2^32 - 2
  /// points in total.
  void enter_polygon(const WorldPolygon& polygon, const Attributes& attributes);
  void enter_line(const Point3& from, const Point3& to, const Attributes& attributes,
                  std::int32_t pick);
  /// Polygons entered by enter_shared from now on share this many vertices; used ones are stored
  /// once. Reserves capacity for polygons and corners.
  void begin_shared(std::size_t vertices, std::size_t polygons = 0, std::size_t corners = 0);
  /// Shared vertices: in world coordinates, and as entered, before the modelling transformation of
  /// that matrix. Null: as entered.
  struct SharedVertices {
    std::span<const Point3> world;
    std::span<const Point3> entered = {};
    const ModellingMatrix* modelling = nullptr;
  };
  /// Enters a polygon given by indices of the shared vertices.
  void enter_shared(std::span<const std::uint32_t> corners, const WorldPolygon& polygon,
                    const Attributes& attributes);
  /// The same for triangles, three corners each, all sides visible: the first has this pick
  /// identifier, each next one `step` more.
  void enter_shared_triangles(const SharedVertices& vertices,
                              std::span<const std::uint32_t> corners, const Attributes& attributes,
                              std::int32_t pick, std::int32_t step);
  void enter_text(const Point3& anchor, std::string_view characters, const Attributes& attributes);
  void enter_annotation(KeptAnnotation annotation);
  /// Marks a surface whose cells are entered next.
  void mark_surface(const Surface& surface) { segments_.back().surfaces.push_back(surface); }

 private:
  template <class Row>
  std::span<const typename Row::value_type> of(const Row& of_corners, std::uint32_t i) const {
    return std::span(of_corners.data(), of_corners.size())
        .subspan(primitives_[i].first, primitives_[i].sides);
  }
  std::size_t all_corners() const { return edge_visible_.size(); }
  void require_room(std::size_t corners) const;
  void begin_primitive(std::size_t sides, const Attributes& attributes, std::int32_t pick);
  void enter_shared_corner(std::uint32_t corner, const Point3& world, const Point3& entered);
  void enter_corners(std::span<const Point3> points, std::span<const Point3> entered);
  void enter_point(const Point3& world, const Point3& entered);
  void begin_modelling(const ModellingMatrix* matrix);
  void finish_primitive(const WorldPolygon& polygon);
  void name_points();
  void free_room(const Segment& segment);
  std::uint32_t look_of(const Attributes& attributes);
  /// Calls on_primitive(std::uint32_t) and on_text(const Text&) for all that a segment holds.
  template <class OnPrimitive, class OnText>
  void in_order_of_entry(const Segment& segment, OnPrimitive&& on_primitive,
                         OnText&& on_text) const;
  bool enter_viewed(std::uint32_t i, const Attributes& attributes, std::span<const LineKinds> sides,
                    PolygonStage& stage, displayfile::Segment& segment) const;
  void append(const RetainedScene& other, const Segment& segment);
  void append_points(const RetainedScene& other, const Segment& segment);

  std::vector<Segment> segments_;
  GrowingArray<Primitive> primitives_;
  std::vector<Text> texts_;
  std::size_t annotations_ = 0;                    // entered so far
  std::vector<Attributes> attributes_;             // without fill colours
  std::vector<std::uint32_t> attributes_of_look_;  // in attributes_
  std::vector<Colour> colours_;                    // of looks
  GrowingArray<Point3> points_;
  GrowingArray<Point3> entered_;            // the same as entered; empty: equal
  ModellingRuns modellings_;                // of points
  GrowingArray<std::uint32_t> corners_;     // their points; empty: the points in order
  std::vector<std::uint8_t> edge_visible_;  // of the side that ends at the corner
  std::vector<Point3> normals_;  // where they are not Newell's, of primitives up to the last such
  std::vector<Point3> vertex_normals_;  // of corners up to those of the last polygon that has some
  std::vector<std::uint32_t> number_of_shared_;  // as points, or kNotKept
  bool has_cuts_ = false;                        // a polygon was cut by cutting planes
  std::uint32_t opened_ = 0;                     // segments, removed ones too
};

}  // namespace displayfile
