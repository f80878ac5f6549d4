#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// The loops around what the even-odd rule fills of a polygon that crosses itself: they do not
/// cross, and have corners where the polygon's sides do (hidden/triangles/triangulation.md).
class UncrossedLoops {
 public:
  /// Where two sides cross. A side has the number of the vertex at which it begins; a share is the
  /// fraction of its length from there.
  struct Crossing {
    std::array<std::uint32_t, 2> side;
    std::array<double, 2> share;
  };

  /// Polygons with more corners or crossings are not uncrossed: the work is quadratic.
  static constexpr std::size_t kMostCorners = 1024, kMostCrossings = 1024;

  /// True if two sides of the polygon cross, each with its ends farther than rounding from the
  /// other. `next`, if not empty, has the sides instead: of each corner the one at which its side
  /// ends, or kInNoLoop.
  static bool crosses(std::span<const Point2> polygon, std::span<const std::uint32_t> next = {});

  /// Finds the loops. False if there are too many corners or crossings, or if rounding leaves no
  /// loops that do not cross.
  bool find(std::span<const Point2> polygon);

  /// The loops' corners; the inside is on the left of the way from one to the next.
  std::span<const Point2> corners() const { return corners_; }
  std::span<const std::uint32_t> next() const { return next_; }  ///< per corner, in its loop
  /// Per corner the polygon's vertex, or the number of vertices and that of a crossing.
  std::span<const std::uint32_t> vertex() const { return vertex_; }
  std::span<const Crossing> crossings() const { return crossings_; }

 private:
  struct Node {
    Point2 place;
    std::uint32_t vertex;  // as in vertex()
  };
  struct OnSide {
    std::uint32_t side;
    double share;
    std::uint32_t node;
  };
  struct Edge {
    std::uint32_t from, to;  // nodes
  };

  std::uint32_t node_at(const Point2& place, std::uint32_t vertex);
  void meet(std::span<const Point2> polygon, std::uint32_t first, std::uint32_t second);
  void part_sides(std::span<const Point2> polygon);
  void keep_odd_edges();
  bool has_inside_on_left(const Edge& edge) const;
  bool link();

  double reach_ = 0.0;
  std::vector<Node> nodes_;
  std::vector<OnSide> on_sides_;
  std::vector<Edge> edges_;
  std::vector<Crossing> crossings_;
  std::vector<Point2> corners_;
  std::vector<std::uint32_t> next_, vertex_;
};

}  // namespace displayfile
