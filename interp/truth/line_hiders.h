#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "clip/geometry/rectangle.h"
#include "interp/truth/exact_parts.h"
#include "interp/truth/line_items.h"

namespace displayfile {

/// Depths at a line's start and end: from / under and to / under, under > 0; linear between.
struct EndDepths {
  Integer from, to, under;
};

/// A line in integer coordinates.
struct ExactLine {
  Point3 start, end;       ///< in the direction of the first sharer; of an intersection, rounded
  Integer x0, y0, x1, y1;  ///< the projection, times `scale`
  Integer scale = 1;       ///< so that the ends of intersections are whole too
  std::vector<EndDepths> depths;  ///< the distinct depths of its sharers
  std::vector<LineId> sharers;    ///< the first of each depth; none of an intersection
  double farthest;                ///< a lower bound of its depth at all points
};

/// A polygon that may hide part of a line.
struct Hider {
  /// The parameters at which a point that runs along the line, close to its left or close to its
  /// right, crosses the polygon's sides; in any order, an even number each, also beyond the line's
  /// ends.
  std::array<std::vector<Fraction>, 2> crossings;
  EndDepths depth;  ///< of its support plane at the line's ends
  /// For each depth of the line, the sign of the polygon's depth less the line's, at the line's
  /// start and end, where the points as entered determine it: 0 within reach. Empty: none.
  std::vector<std::array<std::optional<int>, 2>> as_entered;
};

/// The part of the line, at the depth of that number, where the polygon is strictly nearer; none if
/// it has no length.
std::optional<ExactPart> nearer_part(const Hider& hider, const ExactLine& line,
                                     std::size_t depth_number);
/// The parts of a line hidden by the polygons, at the depth of that number.
ExactParts hidden_parts(const ExactLine& line, std::size_t depth_number,
                        std::span<const Hider> hiders);
/// The visible parts of a line: visible for one of its sharers.
ExactParts visible_parts(const ExactLine& line, std::span<const Hider> hiders);
/// True if the line is hidden just after the place t on it; 0 <= t < 1.
bool is_hidden_after(const ExactLine& line, std::span<const Hider> hiders, const Fraction& t);

/// The solid polygons of a picture in integer coordinates, and a search for those that may cover a
/// line.
class LineHiders {
 public:
  explicit LineHiders(const LineItems& items, int threads = 1);

  /// The line of these sharers.
  ExactLine line(const LineItems::Sharers& sharers) const;
  /// Every polygon that covers points of the line, or points close to it, and is nearer at one.
  std::vector<Hider> hiders(const ExactLine& line) const;
  /// The parts of the line on which both planes have the same depth that are inside both polygons,
  /// as are the points close to it on either side. Each runs from the end that is lower by x, then
  /// y, to the other; in this order. None for polygons that are not solid or have no plane, or that
  /// share a side.
  std::vector<ExactLine> intersections(std::uint32_t item_a, std::uint32_t item_b) const;

 private:
  struct Point {
    Integer x, y, z;
  };
  /// Depths at (x, y): (origin - slope_x x - slope_y y) / under, under > 0.
  struct DepthPlane {
    Integer slope_x, slope_y, origin, under;
    /// The numerator at (x / scale, y / scale), times scale.
    Integer over(const Integer& x, const Integer& y, const Integer& scale = 1) const {
      return origin * scale - slope_x * x - slope_y * y;
    }
  };
  struct Solid {
    std::uint32_t item;
    Rectangle around;
    double nearest;  // its support plane is no nearer at any point that it covers
  };
  struct Cells {
    std::size_t left, right, bottom, top;
  };

  Point point(const Point3& p) const {
    return {scaled(p.x, places_), scaled(p.y, places_), scaled(p.z, depth_places_)};
  }
  std::optional<std::array<Point3, 3>> plane_points(std::uint32_t item) const;
  std::optional<DepthPlane> plane(std::uint32_t item) const;
  double depth(const Integer& over, const Integer& under) const;
  std::array<double, 2> depth_range(std::uint32_t item) const;
  EndDepths depths(const ExactLine& line, LineId sharer) const;
  EndDepths depths(const ExactLine& line, const DepthPlane& plane) const;
  bool has_own_depth(LineId sharer) const;
  std::vector<std::array<std::optional<int>, 2>> as_entered(const ExactLine& line,
                                                            std::uint32_t item) const;
  std::optional<Hider> hider(const ExactLine& line, std::uint32_t item) const;

  /// The line a x + b y = c in the projection. A place on it is the value of ahead_x x + ahead_y y
  /// there, which grows with x, or with y if the line is steep.
  struct FlatLine {
    Integer a, b, c, ahead_x, ahead_y;
  };
  std::vector<bool> corners_on_plane(std::uint32_t item, std::uint32_t other) const;
  bool touches(std::uint32_t item, std::uint32_t other, const FlatLine& line) const;
  ExactParts inside(std::uint32_t item, std::uint32_t other, const FlatLine& line) const;
  ExactLine between(const FlatLine& line, const ExactPart& part, const DepthPlane& plane) const;

  void enter_solids(int threads);
  void enter_cells();
  std::size_t cell(double coordinate) const;
  Cells cells(const Rectangle& around) const;
  std::size_t entries(std::size_t cells) const;
  std::vector<std::uint32_t> near(const ExactLine& line) const;

  const LineItems& items_;
  int places_ = 0, depth_places_ = 0;  // binary ones, of x and y and of z
  std::vector<Solid> solids_;
  // Squares over the picture, row by row; those at its border include everything beyond.
  std::size_t cells_ = 1;               // per row, and rows
  std::vector<std::size_t> starts_;     // of the cells, in entries_
  std::vector<std::uint32_t> entries_;  // places in solids_
};

}  // namespace displayfile
