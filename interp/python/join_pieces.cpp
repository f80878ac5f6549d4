#include "interp/python/join_pieces.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace displayfile::python {

namespace {

/// Two pieces that overlap only within a strip of this width, in a picture from 0 to 1, may be
/// drawn in either order: the difference is invisible.
constexpr double kTolerance = 1e-9;
/// Polygons of more pieces stay in pieces.
constexpr std::size_t kMostPieces = 512;
/// A piece with more neighbours than this keeps its place: large overlapping polygons would need a
/// comparison of all pairs.
constexpr std::size_t kMostLooks = 4096;
/// The largest mean number of cells per piece: cells are enlarged until it holds.
constexpr std::size_t kMostCells = 16;

using Corners = std::span<const Point3>;

/// True if, across one of the sides of `a`, the two overlap by no more than `reach`. Then their
/// intersection lies in a strip of that width along the side, for any polygons: they may be
/// concave, and the side may be short and its direction a result of rounding. A repeated corner, as
/// from a cut, is a side of length 0: it has no direction, and separates nothing.
bool a_side_separates(Corners a, Corners b, double reach) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point3& p = a[i];
    const Point3& q = a[(i + 1) % a.size()];
    const double length = std::hypot(q.x - p.x, q.y - p.y);
    if (length == 0.0) continue;
    const double nx = (p.y - q.y) / length, ny = (q.x - p.x) / length;
    const auto along = [&](const Point3& r) { return (r.x - p.x) * nx + (r.y - p.y) * ny; };
    const auto [a_low, a_high] = std::ranges::minmax(a, {}, along);
    const auto [b_low, b_high] = std::ranges::minmax(b, {}, along);
    if (along(a_high) <= along(b_low) + reach || along(b_high) <= along(a_low) + reach) {
      return true;
    }
  }
  return false;
}

/// False only if the two have at most a strip of width kTolerance in common; if one is a line, only
/// if there is a gap of that width between them, since lines are drawn with a width. Pieces that
/// are not convex may count as overlapping where only their hulls do.
bool overlap(Corners a, Corners b) {
  const bool is_line = a.size() == 2 || b.size() == 2;
  const double reach = is_line ? -kTolerance : kTolerance;
  return !a_side_separates(a, b, reach) && !a_side_separates(b, a, reach);
}

/// The pieces that lie in each cell of a grid over the picture, in their order.
class Cells {
 public:
  explicit Cells(const DrawnPieces& pieces)
      : side_(static_cast<std::size_t>(
            std::clamp(std::sqrt(static_cast<double>(pieces.size())), 1.0, 1024.0))) {
    while (side_ > 1 && cells_of_all(pieces) > kMostCells * pieces.size()) side_ /= 2;
    cells_.resize(side_ * side_);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      visit(corners_of(pieces, k), [&](std::vector<std::uint32_t>& cell) {
        cell.push_back(static_cast<std::uint32_t>(k));
        return false;
      });
    }
  }

  static Corners corners_of(const DrawnPieces& pieces, std::size_t k) {
    return Corners(pieces.points).subspan(pieces.first[k], pieces.first[k + 1] - pieces.first[k]);
  }

  /// True if a piece after `from` and before `to` overlaps piece `from`, except those of the same
  /// polygon that are drawn at `to` too; or if too many would have to be examined.
  bool covered(const DrawnPieces& pieces, std::span<const std::uint32_t> places, std::uint32_t from,
               std::uint32_t to) {
    const Corners corners = corners_of(pieces, from);
    std::size_t looks = 0;
    return visit(corners, [&](const std::vector<std::uint32_t>& cell) {
      for (auto k = std::ranges::upper_bound(cell, from); k != cell.end() && *k < to; ++k) {
        if (++looks > kMostLooks) return true;
        const bool moves_too = pieces.picks[*k] == pieces.picks[from] && places[*k] == to;
        if (!moves_too && overlap(corners, corners_of(pieces, *k))) return true;
      }
      return false;
    });
  }

 private:
  std::size_t cell_of(double value) const {
    const auto cells = static_cast<double>(side_);
    return static_cast<std::size_t>(std::clamp(value * cells, 0.0, cells - 1.0));
  }

  /// A range of columns and rows, both ends included.
  struct Block {
    std::size_t left, right, bottom, top;
  };
  Block block_of(Corners corners) const {
    const auto [x_low, x_high] = std::ranges::minmax(corners, {}, &Point3::x);
    const auto [y_low, y_high] = std::ranges::minmax(corners, {}, &Point3::y);
    return {cell_of(x_low.x), cell_of(x_high.x), cell_of(y_low.y), cell_of(y_high.y)};
  }

  std::size_t cells_of_all(const DrawnPieces& pieces) const {
    std::size_t all = 0;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const Block block = block_of(corners_of(pieces, k));
      all += (block.right - block.left + 1) * (block.top - block.bottom + 1);
    }
    return all;
  }

  /// Calls `enter` for the cells of a block until it returns true, which is then returned.
  template <class Enter>
  bool visit(Corners corners, Enter&& enter) {
    const Block block = block_of(corners);
    for (std::size_t y = block.bottom; y <= block.top; ++y) {
      for (std::size_t x = block.left; x <= block.right; ++x) {
        if (enter(cells_[y * side_ + x])) return true;
      }
    }
    return false;
  }

  std::size_t side_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

bool overlap_each_other(const DrawnPieces& pieces, std::span<const std::uint32_t> own) {
  for (std::size_t i = 0; i < own.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (overlap(Cells::corners_of(pieces, own[i]), Cells::corners_of(pieces, own[j]))) {
        return true;
      }
    }
  }
  return false;
}

/// The place of each piece in the order: its own, or that of a later piece of its polygon that
/// stays where it is.
///
/// Drawn by their places, and those of one place as the sort has them, any two pieces that overlap
/// are in the sort's order. For let piece a come before piece b there, and overlap it.
///  - places[a] < b: a is drawn first, as no piece moves back and places[b] >= b.
///  - places[a] == b: a piece that others move to stays, so places[b] == b too; of one place a
///  comes
///    first.
///  - places[a] > b: b is between a and places[a] and overlaps a. a moves in spite of that only if
///  b
///    is of the same polygon and has the same place; and there a comes first.
std::vector<std::uint32_t> places_of(const DrawnPieces& pieces,
                                     const std::vector<std::vector<std::uint32_t>>& own) {
  std::vector<std::uint32_t> places(pieces.size());
  std::iota(places.begin(), places.end(), 0u);
  Cells cells(pieces);
  for (const std::vector<std::uint32_t>& of_one : own) {
    for (std::size_t i = of_one.size(); i-- > 1;) {
      const std::uint32_t k = of_one[i - 1], to = places[of_one[i]];
      if (!cells.covered(pieces, places, k, to)) places[k] = to;
    }
  }
  return places;
}

}  // namespace

void join_pieces(std::span<const std::uint32_t> sides, std::span<const Point3> points,
                 DrawnPieces& pieces) {
  const std::size_t count = pieces.size();
  std::vector<std::vector<std::uint32_t>> own(sides.size());
  for (std::size_t k = 0; k < count; ++k) {
    const auto item = static_cast<std::size_t>(pieces.picks[k]);
    if (item < sides.size()) own[item].push_back(static_cast<std::uint32_t>(k));
  }
  const std::vector<std::uint32_t> places = places_of(pieces, own);

  std::vector<Corners> whole(count);  // the polygon, for the last of its pieces
  std::vector<bool> left_out(count);
  std::size_t begin = 0;
  for (std::size_t item = 0; item < sides.size(); begin += sides[item++]) {
    if (own[item].size() < 2 || own[item].size() > kMostPieces) continue;
    // All in one place and not over each other, they are drawn as the polygon itself. Sides that
    // cuts made are in two pieces, in opposite directions: together the pieces wind around each
    // point as often as the polygon does.
    const std::uint32_t last = own[item].back();
    const auto stays = [&](std::uint32_t k) { return places[k] != last; };
    if (std::ranges::any_of(own[item], stays) || overlap_each_other(pieces, own[item])) continue;
    for (const std::uint32_t k : own[item]) left_out[k] = k != last;
    whole[last] = points.subspan(begin, sides[item]);
  }

  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t k) { return places[k]; });
  DrawnPieces joined;
  for (const std::uint32_t k : order) {
    if (left_out[k]) continue;
    const Corners corners = whole[k].empty() ? Cells::corners_of(pieces, k) : whole[k];
    joined.points.insert(joined.points.end(), corners.begin(), corners.end());
    if (whole[k].empty()) {
      const auto sides_of = std::span(pieces.sides).subspan(pieces.first[k], corners.size());
      joined.sides.insert(joined.sides.end(), sides_of.begin(), sides_of.end());
      const auto cuts_of = std::span(pieces.cuts).subspan(pieces.first[k], corners.size());
      joined.cuts.insert(joined.cuts.end(), cuts_of.begin(), cuts_of.end());
    } else {
      joined.sides.resize(joined.points.size(), 1);
      joined.cuts.resize(joined.points.size(), 0);
    }
    joined.end_piece(pieces.looks(k));
  }
  pieces = std::move(joined);
}

}  // namespace displayfile::python
