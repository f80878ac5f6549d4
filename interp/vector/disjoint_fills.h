#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "clip/point.h"
#include "interp/device/picture.h"
#include "interp/vector/fill_paint.h"
#include "interp/vector/lattice_loops.h"

namespace displayfile {

/// Pieces of one segment and one paint as one path, and of one pick identifier if these are kept
/// apart.
struct FigureRegion {
  int segment;  ///< 0 if the pieces came within one segment
  std::int32_t pick;
  FillPaint paint;
  LatticeLoops loops;
};

/// Sides of regions that are stroked under them, in the paint of the earlier of the two regions.
struct FigureTrap {
  FillPaint paint;
  LatticeChains sides;
};

/// Disjoint fills in the form in which they are written (interp/vector/seams.md).
struct Figure {
  double unit;  ///< of coordinates, in pixels
  /// Disjoint regions, those of a segment consecutive; none has more than kMostVertices. Of two
  /// neighbours the earlier is the one that comes first here.
  std::vector<FigureRegion> regions;
  /// Every side of a region once, including those on the outline; in drawing order, from the last
  /// region to the first. Empty if the figure is butted, or one region.
  std::vector<FigureTrap> traps;
  /// The outline of all regions together, in parts of no more than kMostVertices; most have one.
  std::vector<LatticeLoops> outline;
  /// Triangles over the sides between the parts of an outline, where they would show in a mask.
  std::vector<LatticeLoops> outline_tents;

  /// Many programs, and printers, draw longer paths slowly or not at all.
  static constexpr std::size_t kMostVertices = 32'000;
};

/// Collects fills that do not overlap, and makes a figure of them. Vertices are rounded once, so
/// that neighbours with a side in common have one afterwards.
class DisjointFills {
 public:
  explicit DisjointFills(const VectorOptions& options) : options_(options) {}

  bool empty() const { return pieces_.empty(); }
  /// A loop in pixels, y down, finite and less than a million in magnitude; loops that are empty
  /// after rounding are omitted.
  void add(std::span<const Point2> loop, const FillPaint& paint, int segment, std::int32_t pick);
  /// Moves the collected figure out.
  Figure take_figure();

 private:
  using Key =
      std::tuple<std::size_t, std::int32_t, FillPaint>;  // place of the segment, pick, paint
  struct Piece {
    std::size_t first, end;  // of its vertices
  };
  std::span<const LatticePoint> loop(std::size_t piece) const {
    return std::span(points_).subspan(pieces_[piece].first,
                                      pieces_[piece].end - pieces_[piece].first);
  }
  /// The collected figure, merged, without traps.
  Figure merged();
  std::vector<std::span<const LatticePoint>> loops_of(std::span<const std::size_t> pieces) const;

  VectorOptions options_;
  std::vector<LatticePoint> points_;
  std::vector<Piece> pieces_;
  std::vector<int> segments_;                    // in the order in which they came
  std::unordered_map<int, std::size_t> places_;  // of segments in it
  std::map<Key, std::vector<std::size_t>> pieces_of_;
};

}  // namespace displayfile
