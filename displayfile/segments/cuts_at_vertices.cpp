#include "displayfile/segments/cuts_at_vertices.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "clip/geometry/corners.h"
#include "clip/geometry/secret_hash.h"

namespace displayfile {

namespace {

/// True if the depths are equal up to rounding.
bool is_as_deep(const Point3& a, const Point3& b) {
  constexpr double kRounding = 0x1p-40;
  return std::abs(a.z - b.z) <= kRounding * (1.0 + std::abs(b.z));
}

/// The cuts of pieces by their positions in the picture, and the positions to which they are moved.
class CutsInPicture {
 public:
  explicit CutsInPicture(double radius)
      : radius_(radius), per_cell_(1.0 / (kRadiiOfCell * radius)) {}

  struct Cut {
    Point3 at, to;
    std::uint32_t point;  ///< among those of the pieces
    bool is_placed = false;
  };
  std::vector<Cut> all;

  void make_ready() {
    first_.assign(std::bit_ceil(4 * all.size() + 1), kNone);
    for (std::uint32_t k = 0; k < all.size(); ++k) {
      const Point3& at = all[k].at;
      for (const double x : {at.x - radius_, at.x + radius_}) {
        for (const double y : {at.y - radius_, at.y + radius_}) has_some_[square(x, y)] = 1;
      }
      const Cell low = cell(at.x - radius_, at.y - radius_),
                 high = cell(at.x + radius_, at.y + radius_);
      for (std::int64_t x = low.x; x <= high.x; ++x) {
        for (std::int64_t y = low.y; y <= high.y; ++y) {
          std::uint32_t& first = first_[place_of({x, y})];
          in_cells_.push_back({k, first});
          first = static_cast<std::uint32_t>(in_cells_.size() - 1);
        }
      }
    }
  }
  /// Moves each cut within the radius in x and y to the vertex, unless it is placed already: the
  /// first vertex counts, but one of the cut's depth takes precedence.
  void take_vertex(const Point3& vertex) {
    if (has_some_[square(vertex.x, vertex.y)] == 0) return;
    for_each_near(vertex, [&](Cut& cut) {
      if (cut.is_placed && (is_as_deep(cut.to, cut.at) || !is_as_deep(vertex, cut.at))) return;
      cut.to = vertex;
      cut.is_placed = true;
    });
  }
  /// Moves cuts without a near vertex to the first of those near each other.
  void join() {
    for (Cut& cut : all) {
      if (cut.is_placed) continue;
      for_each_near(cut.at, [&](Cut& other) {
        if (&other <= &cut || other.is_placed) return;
        other.to = cut.at;
        other.is_placed = true;
      });
    }
    for (Cut& cut : all) {
      if (!is_as_deep(cut.to, cut.at)) cut.to.z = cut.at.z;
    }
  }

 private:
  static constexpr double kRadiiOfCell = 8.0;
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  struct Cell {
    std::int64_t x, y;
  };
  struct InCell {
    std::uint32_t cut, next;
  };

  /// A grid of kSquares squares over the picture; positions outside of it count to the first or
  /// last row or column.
  static constexpr std::size_t kSquares = 256;
  static std::size_t square(double x, double y) {
    const auto of = [](double v) {
      return v >= 0.0 && v < 1.0 ? static_cast<std::size_t>(v * kSquares) : std::size_t{0};
    };
    return of(x) * kSquares + of(y);
  }
  /// Rounds towards zero: cells there are twice as wide.
  Cell cell(double x, double y) const {
    constexpr double kMost = 0x1p62;
    return {static_cast<std::int64_t>(std::clamp(x * per_cell_, -kMost, kMost)),
            static_cast<std::int64_t>(std::clamp(y * per_cell_, -kMost, kMost))};
  }
  std::size_t place_of(const Cell& cell) const {
    return hash_(static_cast<std::uint64_t>(cell.x) * 0x9E3779B97F4A7C15u +
                 static_cast<std::uint64_t>(cell.y)) &
           (first_.size() - 1);
  }
  template <class Visit>
  void for_each_near(const Point3& p, const Visit& visit) {
    for (std::uint32_t k = first_[place_of(cell(p.x, p.y))]; k != kNone; k = in_cells_[k].next) {
      Cut& cut = all[in_cells_[k].cut];
      const double x = std::abs(cut.at.x - p.x), y = std::abs(cut.at.y - p.y);
      if (x <= radius_ && y <= radius_) visit(cut);
    }
  }

  SecretHash hash_;
  std::vector<std::uint8_t> has_some_ = std::vector<std::uint8_t>(kSquares * kSquares, 0);
  double radius_, per_cell_;
  std::vector<std::uint32_t> first_;  // in in_cells_, of each place
  std::vector<InCell> in_cells_;
};

/// Moves the cuts of pieces, one piece after the other.
class MovedPieces {
 public:
  MovedPieces(const CutsInPicture& cuts, SortedPieces& pieces) : cuts_(cuts), pieces_(pieces) {}

  /// Must be called for all cut pieces, in order. False if nothing is left of a line.
  bool move(SortedPiece& piece) {
    if (next_ == cuts_.all.size() || cuts_.all[next_].point - piece.first >= piece.sides) {
      return true;  // it has none
    }
    moved_.clear();
    bool some = false;
    for (std::uint32_t point = piece.first; point < piece.first + piece.sides; ++point) {
      moved_.push_back(pieces_.points[point]);
      if (next_ == cuts_.all.size() || cuts_.all[next_].point != point) continue;
      moved_.back() = cuts_.all[next_++].to;
      some = some || moved_.back() != pieces_.points[point];
    }
    return !some || replace(piece);
  }

 private:
  /// Writes the moved points, without sides that have lost their length; false if a line has. A
  /// polygon with no more than two sides left stays unchanged: it may cover a pixel's centre.
  bool replace(SortedPiece& piece) {
    kept_.clear();
    for (std::uint32_t k = 0; k < piece.sides; ++k) {
      const Point3& before = moved_[previous_corner(k, piece.sides)];
      if (Point2(before) != Point2(moved_[k])) kept_.push_back(k);
    }
    if (piece.sides == 2 && kept_.empty()) return false;
    if (piece.sides > 2 && kept_.size() < 3) return true;
    for (std::uint32_t n = 0; n < kept_.size(); ++n) {
      const std::uint32_t from = piece.first + kept_[n], to = piece.first + n;
      pieces_.points[to] = moved_[kept_[n]];
      pieces_.visible[to] = pieces_.visible[from];
      if (!pieces_.corners.empty()) pieces_.corners[to] = pieces_.corners[from];
    }
    piece.sides = static_cast<std::uint32_t>(kept_.size());
    return true;
  }

  const CutsInPicture& cuts_;
  SortedPieces& pieces_;
  std::size_t next_ = 0;
  std::vector<Point3> moved_;
  std::vector<std::uint32_t> kept_;
};

/// Finds the cuts that are not vertices of their own item, bit for bit, and not where the line
/// before ended at one.
void find_cuts(const ViewedScene& scene, const SortedPieces& pieces, CutsInPicture& cuts) {
  const Point3* last = nullptr;  // that is a vertex
  for (const SortedPiece& piece : pieces.pieces) {
    if (piece.first == SortedPiece::kWhole) continue;
    const PointRow own = scene.points(piece.item);
    for (std::uint32_t k = piece.first; k < piece.first + piece.sides; ++k) {
      const Point3& p = pieces.points[k];
      if (last != nullptr && p == *last) continue;
      if (std::ranges::find(own, p) == own.end()) {
        cuts.all.push_back({p, p, k});
      } else {
        last = &p;
      }
    }
  }
}

}  // namespace

double cuts_may_move(const ViewedScene& scene) { return 2.0 * scene.boundary_error(); }

void put_cuts_at_vertices(const ViewedScene& scene, SortedPieces& pieces) {
  const double radius = cuts_may_move(scene);
  if (!(radius > 0.0) || pieces.points.empty()) return;
  CutsInPicture cuts(radius);
  find_cuts(scene, pieces, cuts);
  if (cuts.all.empty()) return;
  cuts.make_ready();
  for (ViewedScene::Item item = 0; item < scene.items(); ++item) {
    for (const Point3& vertex : scene.points(item)) cuts.take_vertex(vertex);
  }
  cuts.join();
  MovedPieces moved(cuts, pieces);
  std::size_t kept = 0, fills = 0;
  for (std::size_t k = 0; k < pieces.pieces.size(); ++k) {
    SortedPiece& piece = pieces.pieces[k];
    if (piece.first != SortedPiece::kWhole && !moved.move(piece)) continue;
    pieces.pieces[kept] = piece;
    if (!pieces.hidden.empty()) pieces.hidden[kept] = pieces.hidden[k];
    if (k < pieces.lights.size()) pieces.lights[kept] = pieces.lights[k];
    if (k < pieces.first_stroke) ++fills;
    ++kept;
  }
  if (kept == pieces.pieces.size()) return;
  pieces.pieces.resize(kept);
  if (!pieces.hidden.empty()) pieces.hidden.resize(kept);
  pieces.lights.resize(std::min(pieces.lights.size(), fills));
  if (pieces.first_stroke != SortedPieces::kNoStrokes) pieces.first_stroke = fills;
}

}  // namespace displayfile
