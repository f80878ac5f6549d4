#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat4x3.hpp>
#include <span>
#include <vector>

#include "clip/geometry/point_row.h"
#include "clip/surfaces.h"
#include "clip/view/view_volume.h"
#include "displayfile/entered/modelling_runs.h"
#include "displayfile/entered/retained_polygons.h"
#include "hidden/exact/entered_polygon.h"

namespace displayfile {

/// The polygons of a segment as the application entered them, before the modelling transformation,
/// in order: one per polygon instruction, and those without an instruction because they are outside
/// of the view or back faces. Touching is decided by them (hidden/touching/touching_planes.md),
/// since viewing rounds. Also the lines of line instructions, in world coordinates. Points that a
/// retained scene holds too are stored once.
class EnteredPolygons {
 public:
  using Matrix = ModellingRuns::Matrix;

  EnteredPolygons(const Touching& touching, const ViewVolume& volume)
      : touching_(touching), volume_(volume) {}

  /// The segment's view.
  const ViewVolume& volume() const { return volume_; }
  /// Polygons can be coplanar in the picture only if they have the same view.
  bool is_viewed_like(const EnteredPolygons& other) const {
    return volume_.matrix() == other.volume_.matrix() &&
           volume_.viewport() == other.volume_.viewport();
  }

  /// The distance within which they touch others.
  const Touching& touching() const { return touching_; }
  /// True if only coincident parts touch and the display file has the entered coordinates exactly.
  bool are_as_viewed() const {
    return touching_.kind == Touching::Kind::off && runs_.empty() && volume_.is_identity() &&
           bent_.empty();
  }
  std::size_t size() const { return are_retained_ ? entered_again_ : first_.size(); }
  /// The indices of those without an instruction, ascending.
  std::span<const std::uint32_t> not_seen() const { return not_seen_; }
  std::size_t seen() const { return size() - not_seen_.size(); }
  /// The indices of those that are not planar (hidden/exact/entered_plane.h), ascending.
  std::span<const std::uint32_t> bent() const { return bent_; }
  /// The points of a polygon, counted from 0.
  PointRow points(std::size_t i) const;
  /// The modelling matrix in force; null if the points are in world coordinates. Valid until a
  /// polygon is entered.
  const Matrix* modelling(std::size_t i) const;
  /// The largest |coordinate| entered, including parts outside of the view.
  double largest() const { return largest_; }
  /// Bound on all world coordinates, and on the products summed for them.
  double largest_in_world() const;
  /// Their rounding error, in units of 2^-53 of that bound (hidden/exact/entered_polygon.h).
  double roundings_in_world() const { return has_cuts_ ? kRoundingsWhereCut : kRoundingsInWorld; }
  /// The length of the longest column of the modelling matrices, at least 1.
  double longest() const;
  std::size_t lines() const { return line_ends_.size() / 2; }
  /// The two ends of an instruction's line, in order of entry, before clipping.
  std::span<const Point3> line(std::size_t i) const {
    return std::span(line_ends_).subspan(2 * i, 2);
  }
  std::size_t bytes() const;  ///< of the used arrays, without those of a retained scene

  /// Records an entered coordinate, whether or not an instruction is made of it.
  void include(const Point3& p);
  /// Enters a polygon with points of its own. modelling null: they are in world coordinates.
  void enter(const PointRow& points, const Matrix* modelling);
  /// Polygons entered by enter_shared from now on share this many vertices; used ones are stored
  /// once.
  void begin_shared(std::size_t vertices) { number_of_shared_.assign(vertices, kNotKept); }
  /// Enters a polygon given by indices of the shared vertices.
  void enter_shared(std::span<const Point3> vertices, std::span<const std::uint32_t> corners,
                    const Matrix* modelling);
  /// The polygon entered last has no instruction.
  void note_not_seen() { not_seen_.push_back(static_cast<std::uint32_t>(size() - 1)); }
  /// The polygon entered last was cut by cutting planes.
  void note_cut() { has_cuts_ = true; }
  /// Enters a line that has an instruction.
  void enter_line(const Point3& from, const Point3& to) {
    line_ends_.insert(line_ends_.end(), {from, to});
  }
  /// Reserves capacity for more polygons that share vertices, and their corners.
  void reserve_more(std::size_t polygons, std::size_t corners);
  void free_room();

  /// If the polygons are bit for bit those of a retained scene, refers to it and frees the copies.
  void keep_in(const RetainedPolygons& retained);
  /// A retained scene's polygons are entered next, in order, each by `enter` or `enter_shared`:
  /// they are referred to from the start, unless there are lines among them.
  void begin_retained(const RetainedPolygons& retained);
  bool are_retained() const { return are_retained_; }
  /// The scene's arrays were replaced.
  void move_in(const RetainedPolygons& retained) { retained_ = retained; }

 private:
  static constexpr std::uint32_t kNotKept = 0xffffffffu;
  std::size_t corners() const { return corners_.empty() ? points_.size() : corners_.size(); }
  bool are_those_of(const RetainedPolygons& retained) const;
  void enter_again(const PointRow& points, const Matrix* modelling);
  void keep_by_themselves();
  void begin_polygon(const Matrix* modelling);
  void begin_modelling(const Matrix* modelling);
  void note_if_bent(const PointRow& points, const Matrix* modelling);

  Touching touching_;
  ViewVolume volume_;
  bool has_cuts_ = false;
  bool are_retained_ = false;
  RetainedPolygons retained_;      // the polygons, instead of the three arrays that follow
  std::size_t entered_again_ = 0;  // of those
  std::vector<Point3> points_;
  std::vector<std::uint32_t> corners_;  // their points; empty: the points in order
  std::vector<std::uint32_t> first_;    // corner of each polygon
  ModellingRuns runs_;                  // of polygons
  double largest_ = 0.0;
  std::vector<std::uint32_t> not_seen_, bent_;
  std::vector<Point3> line_ends_;
  std::vector<std::uint32_t> number_of_shared_;  // as points, or kNotKept
};

}  // namespace displayfile
