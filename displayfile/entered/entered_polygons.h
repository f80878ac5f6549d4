#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat4x3.hpp>
#include <span>
#include <vector>

#include "clip/point_row.h"
#include "clip/surfaces.h"
#include "clip/view_volume.h"
#include "displayfile/entered/retained_polygons.h"
#include "hidden/exact/entered_polygon.h"

namespace displayfile {

/// The polygons of a segment as the application entered them, before the modelling transformation,
/// in order: one for each polygon instruction, and those of which no instruction was made, since
/// they are outside of the view or back faces. What touches is judged by them
/// (hidden/touching/touching_planes.md), since viewing rounds. Beside them the lines of line
/// instructions, in world coordinates. Where a retained scene holds the same points, they are kept
/// once.
class EnteredPolygons {
 public:
  using Matrix = glm::dmat4x3;  ///< x' = column 0 x + column 1 y + column 2 z + column 3

  EnteredPolygons(const Touching& touching, const ViewVolume& volume)
      : touching_(touching), volume_(volume) {}

  /// How the segment is viewed.
  const ViewVolume& volume() const { return volume_; }
  /// In the picture polygons lie in one plane only if they are viewed alike.
  bool is_viewed_like(const EnteredPolygons& other) const {
    return volume_.matrix() == other.volume_.matrix() &&
           volume_.viewport() == other.volume_.viewport();
  }

  /// Within which distance they touch others.
  const Touching& touching() const { return touching_; }
  /// Nothing touches but what coincides, and the display file says exactly what was entered.
  bool are_as_viewed() const {
    return touching_.kind == Touching::Kind::off && runs_.empty() && volume_.is_identity() &&
           bent_.empty();
  }
  std::size_t size() const { return are_retained_ ? entered_again_ : first_.size(); }
  /// The numbers of those without an instruction, rising.
  std::span<const std::uint32_t> not_seen() const { return not_seen_; }
  std::size_t seen() const { return size() - not_seen_.size(); }
  /// The numbers of those that are not flat (hidden/exact/bent_polygon.h), rising.
  std::span<const std::uint32_t> bent() const { return bent_; }
  /// The points of a polygon, counted from 0.
  PointRow points(std::size_t i) const;
  /// The modelling matrix that was in force; null if the points are in world coordinates. It stays
  /// until a polygon is entered.
  const Matrix* modelling(std::size_t i) const;
  /// The largest |coordinate| that was entered, also of what is outside of the view.
  double largest() const { return largest_; }
  /// No coordinate of what is kept, nor any of the products that it is a sum of, is larger in world
  /// coordinates.
  double largest_in_world() const;
  /// By how many times 2^-53 of that they are off (hidden/exact/entered_polygon.h).
  double roundings_in_world() const { return has_cuts_ ? kRoundingsWhereCut : kRoundingsInWorld; }
  /// The length of the longest column of the modelling matrices, at least 1.
  double longest() const;
  std::size_t lines() const { return line_ends_.size() / 2; }
  /// The two ends of the line of an instruction, in order of entry; as they were before clipping.
  std::span<const Point3> line(std::size_t i) const {
    return std::span(line_ends_).subspan(2 * i, 2);
  }
  std::size_t bytes() const;  ///< of the arrays, as used; without those of a retained scene

  /// Takes note of a coordinate that was entered, whether or not an instruction is made of it.
  void include(const Point3& p);
  /// A polygon with points of its own. Null: they are in world coordinates.
  void enter(const PointRow& points, const Matrix* modelling);
  /// The polygons entered by enter_shared from here on share so many vertices; those that some
  /// polygon uses are kept, once each.
  void begin_shared(std::size_t vertices) { number_of_shared_.assign(vertices, kNotKept); }
  /// A polygon whose points are those of these indices among the shared ones.
  void enter_shared(std::span<const Point3> vertices, std::span<const std::uint32_t> corners,
                    const Matrix* modelling);
  /// No instruction was made of the polygon that was entered last.
  void note_not_seen() { not_seen_.push_back(static_cast<std::uint32_t>(size() - 1)); }
  /// Cutting planes had cut the polygon that was entered last.
  void note_cut() { has_cuts_ = true; }
  /// A line of which an instruction was made.
  void enter_line(const Point3& from, const Point3& to) {
    line_ends_.insert(line_ends_.end(), {from, to});
  }
  /// Makes room for so many polygons that share vertices, and corners of theirs, more.
  void reserve_more(std::size_t polygons, std::size_t corners);
  void free_room();

  /// If the polygons are those of a retained scene, to the bit, they are kept there from here on,
  /// and no longer by themselves.
  void keep_in(const RetainedPolygons& retained);
  /// Those of a retained scene are entered next, in order, each by `enter` or `enter_shared`: they
  /// are kept there from the start, unless there are lines among them.
  void begin_retained(const RetainedPolygons& retained);
  bool are_retained() const { return are_retained_; }
  /// The scene has other arrays in place of those that it had.
  void move_in(const RetainedPolygons& retained) { retained_ = retained; }

 private:
  static constexpr std::uint32_t kNotKept = 0xffffffffu;
  struct Run {
    std::uint32_t first;  ///< polygon
    Matrix matrix;
  };
  std::size_t corners() const { return corners_.empty() ? points_.size() : corners_.size(); }
  bool are_those_of(const RetainedPolygons& retained) const;
  void enter_again(const PointRow& points, const Matrix* modelling);
  void keep_by_themselves();
  void begin_polygon(const Matrix* modelling);
  void begin_modelling(const Matrix* modelling);
  void note_if_bent(const PointRow& points, const Matrix* modelling);
  void begin_run(const Matrix& matrix);

  Touching touching_;
  ViewVolume volume_;
  bool has_cuts_ = false;
  bool are_retained_ = false;
  RetainedPolygons retained_;      // the polygons, in place of the three arrays that follow
  std::size_t entered_again_ = 0;  // of those
  std::vector<Point3> points_;
  std::vector<std::uint32_t> corners_;  // their points; empty: these in a row
  std::vector<std::uint32_t> first_;    // corner of each polygon
  std::vector<Run> runs_;               // polygons before the first are in world coordinates
  double largest_ = 0.0;
  std::vector<std::uint32_t> not_seen_, bent_;
  std::vector<Point3> line_ends_;
  std::vector<std::uint32_t> number_of_shared_;  // as points, or kNotKept
};

}  // namespace displayfile
