#include "displayfile/cuts_at_vertices.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "clip/corners.h"
#include "clip/secret_hash.h"

namespace displayfile {

namespace {

/// The vertices of a scene, and then cuts, by their places in the picture.
class VerticesInPicture {
 public:
  VerticesInPicture(const ViewedScene& scene, double radius)
      : radius_(radius), cell_(8.0 * radius) {
    std::size_t vertices = 0;
    for (ViewedScene::Item item = 0; item < scene.items(); ++item) {
      vertices += scene.points(item).size();
    }
    first_.assign(std::bit_ceil(2 * vertices + 1), kNone);
    vertices_.reserve(vertices);
    for (ViewedScene::Item item = 0; item < scene.items(); ++item) {
      for (const Point3& p : scene.points(item)) add(p);
    }
  }

  void add(const Point3& p) {
    const std::size_t place = place_of(cell(p.x), cell(p.y));
    std::uint32_t last = kNone;
    for (std::uint32_t k = first_[place]; k != kNone; k = vertices_[k].next) {
      if (vertices_[k].at == p) return;
      last = k;
    }
    (last == kNone ? first_[place] : vertices_[last].next) =
        static_cast<std::uint32_t>(vertices_.size());
    vertices_.push_back({p, kNone});
  }

  /// Of those that are as close as the radius in x and y the first entered, one of nearly the same
  /// depth before all others; null if there is none.
  const Point3* at(const Point3& cut) const {
    const Point3* best = nullptr;
    const double x = cell(cut.x - radius_), y = cell(cut.y - radius_);
    const double last_x = cell(cut.x + radius_), last_y = cell(cut.y + radius_);
    look_in(x, y, cut, best);
    if (last_x != x) look_in(last_x, y, cut, best);
    if (last_y != y) look_in(x, last_y, cut, best);
    if (last_x != x && last_y != y) look_in(last_x, last_y, cut, best);
    return best;
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  struct Vertex {
    Point3 at;
    std::uint32_t next;  ///< in the list of its place, of rising entry
  };

  double cell(double coordinate) const { return std::floor(coordinate / cell_); }
  std::size_t place_of(double x, double y) const {
    return hash_(Point3(x, y, 0.0)) & (first_.size() - 1);
  }
  void look_in(double x, double y, const Point3& cut, const Point3*& best) const {
    for (std::uint32_t k = first_[place_of(x, y)]; k != kNone; k = vertices_[k].next) {
      const Point3& v = vertices_[k].at;
      if (std::abs(v.x - cut.x) > radius_ || std::abs(v.y - cut.y) > radius_) continue;
      if (best == nullptr || comes_before(v, *best, cut)) best = &v;
    }
  }
  static bool comes_before(const Point3& v, const Point3& best, const Point3& cut);

  SecretHash hash_;
  double radius_, cell_;
  std::vector<std::uint32_t> first_;  // of the vertices at each place
  std::vector<Vertex> vertices_;
};

bool is_as_deep(const Point3& v, const Point3& cut) {
  constexpr double kRounding = 0x1p-40;
  return std::abs(v.z - cut.z) <= kRounding * (1.0 + std::abs(cut.z));
}

bool VerticesInPicture::comes_before(const Point3& v, const Point3& best, const Point3& cut) {
  const bool is_deep = is_as_deep(v, cut), best_is = is_as_deep(best, cut);
  return is_deep != best_is ? is_deep : &v < &best;
}

/// Puts the cuts of pieces at vertices, one piece after the other.
class CutsAtVertices {
 public:
  CutsAtVertices(const ViewedScene& scene, double radius, SortedPieces& pieces)
      : scene_(scene), radius_(radius), pieces_(pieces) {}

  /// False if the piece is a line of which nothing is left.
  bool move(SortedPiece& piece) {
    const PointRow own = scene_.points(piece.item);
    moved_.clear();
    bool some = false;
    for (const Point3& p : points_of(piece)) {
      moved_.push_back(std::ranges::find(own, p) == own.end() ? place_of(p) : p);
      some = some || moved_.back() != p;
    }
    return !some || replace(piece);
  }

 private:
  std::span<Point3> points_of(const SortedPiece& piece) const {
    return std::span(pieces_.points).subspan(piece.first, piece.sides);
  }
  Point3 place_of(const Point3& cut) {
    if (!vertices_) vertices_.emplace(scene_, radius_);
    const Point3* const vertex = vertices_->at(cut);
    if (vertex == nullptr) {  // others may be there too
      vertices_->add(cut);
      return cut;
    }
    return {vertex->x, vertex->y, is_as_deep(*vertex, cut) ? vertex->z : cut.z};
  }
  /// By what was moved, without sides that have lost their length; false if a line has. A sliver of
  /// a polygon that has no more than two sides left stays as it is: it may cover a pixel's centre.
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

  const ViewedScene& scene_;
  double radius_;
  SortedPieces& pieces_;
  std::optional<VerticesInPicture> vertices_;
  std::vector<Point3> moved_;
  std::vector<std::uint32_t> kept_;
};

}  // namespace

double cuts_may_move(const ViewedScene& scene) { return 2.0 * scene.boundary_error(); }

void put_cuts_at_vertices(const ViewedScene& scene, SortedPieces& pieces) {
  const double radius = cuts_may_move(scene);
  if (!(radius > 0.0) || pieces.points.empty()) return;
  CutsAtVertices cuts(scene, radius, pieces);
  std::size_t kept = 0;
  std::size_t fills = 0;  // of those kept
  for (std::size_t k = 0; k < pieces.pieces.size(); ++k) {
    SortedPiece& piece = pieces.pieces[k];
    if (piece.first != SortedPiece::kWhole && !cuts.move(piece)) continue;
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
