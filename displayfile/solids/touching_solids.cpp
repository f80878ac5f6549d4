// Combines solids by the arrangement of their triangles. CGAL provides the intersections and the
// triangulation in a plane.

#include "displayfile/solids/exact_surface.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <variant>

#include "clip/point.h"

namespace displayfile {

namespace {

using Triangle = ExactSurface::Triangle;
using Numbers = std::array<ExactKernel::FT, 3>;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// CGAL 5 has variants of Boost, CGAL 6 those of the standard library.
template <class T, class Variant>
const T* held(const Variant& variant) {
  if constexpr (requires { std::get_if<T>(&variant); }) {
    return std::get_if<T>(&variant);
  } else {
    return boost::get<T>(&variant);
  }
}

// ---- Points ------------------------------------------------------------------------------------

/// Points, each position once.
class NumberedPoints {
 public:
  std::uint32_t number_of(const ExactPoint& p) {
    CGAL::exact(p);  // or its bounds may be infinite: it may be a quotient
    const auto [at, is_new] = numbers_.try_emplace(p, static_cast<std::uint32_t>(points_.size()));
    if (is_new) points_.push_back(p);
    return at->second;
  }
  const ExactPoint& operator[](std::uint32_t number) const { return points_[number]; }
  std::size_t size() const { return points_.size(); }

 private:
  std::vector<ExactPoint> points_;
  std::map<ExactPoint, std::uint32_t, ExactKernel::Less_xyz_3> numbers_;
};

/// A segment between two numbered points; for a single point, both are the same.
using Cut = std::pair<std::uint32_t, std::uint32_t>;

// ---- A triangle cut into pieces -----------------------------------------------------------------

/// The plane of a triangle, and two coordinates in which the triangle has an area.
class Plane {
 public:
  Plane(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c)
      : origin_(a), normal_(CGAL::normal(a, b, c)) {
    CGAL::exact(normal_);
    const auto size = [&](int k) { return CGAL::abs(normal_[k]); };
    for (int k : {1, 2}) {
      if (size(left_out_) < size(k)) left_out_ = k;
    }
    if (CGAL::is_zero(normal_[left_out_]))
      throw std::runtime_error("a triangle of no area: expected none");
  }

  ExactKernel::Point_2 within(const ExactPoint& p) const { return {p[u()], p[v()]}; }
  ExactPoint lifted(const ExactKernel::Point_2& p) const {
    const ExactKernel::FT rise =
        normal_[u()] * (p.x() - origin_[u()]) + normal_[v()] * (p.y() - origin_[v()]);
    Numbers at;
    at[static_cast<std::size_t>(u())] = p.x();
    at[static_cast<std::size_t>(v())] = p.y();
    at[static_cast<std::size_t>(left_out_)] = origin_[left_out_] - rise / normal_[left_out_];
    return {at[0], at[1], at[2]};
  }
  /// True if counterclockwise in the plane is clockwise in the two coordinates.
  bool is_turned() const { return CGAL::is_negative(normal_[left_out_]); }

 private:
  int u() const { return (left_out_ + 1) % 3; }
  int v() const { return (left_out_ + 2) % 3; }

  ExactPoint origin_;
  ExactKernel::Vector_3 normal_;
  int left_out_ = 0;
};

/// A triangle cut along segments in it: a constrained Delaunay triangulation.
class CutTriangle {
 public:
  CutTriangle(const Triangle& triangle, NumberedPoints& points)
      : points_(points), plane_(points[triangle[0]], points[triangle[1]], points[triangle[2]]) {
    for (const std::uint32_t corner : triangle) vertex_of(corner);
  }

  void cut(const Cut& along) {
    const auto from = vertex_of(along.first), to = vertex_of(along.second);
    if (from != to) triangulation_.insert_constraint(from, to);
  }
  /// The pieces, with the triangle's orientation.
  std::vector<Triangle> pieces() {
    for (const auto vertex : triangulation_.finite_vertex_handles()) {
      std::uint32_t& number = vertex->info();  // cuts that cross make vertices without one
      if (number == kNone) number = points_.number_of(plane_.lifted(vertex->point()));
    }
    std::vector<Triangle> all;
    for (const auto face : triangulation_.finite_face_handles()) {
      Triangle& piece = all.emplace_back();
      for (int k = 0; k < 3; ++k) piece[static_cast<std::size_t>(k)] = face->vertex(k)->info();
      if (plane_.is_turned()) std::swap(piece[1], piece[2]);
    }
    return all;
  }

 private:
  struct Number {
    std::uint32_t value = kNone;
    operator std::uint32_t&() { return value; }
  };
  using Vertices = CGAL::Triangulation_vertex_base_with_info_2<Number, ExactKernel>;
  using Faces = CGAL::Constrained_triangulation_face_base_2<ExactKernel>;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
      ExactKernel, CGAL::Triangulation_data_structure_2<Vertices, Faces>,
      CGAL::Exact_intersections_tag>;

  Triangulation::Vertex_handle vertex_of(std::uint32_t number) {
    const auto vertex = triangulation_.insert(plane_.within(points_[number]));
    vertex->info().value = number;
    return vertex;
  }

  NumberedPoints& points_;
  Plane plane_;
  Triangulation triangulation_;
};

// ---- The arrangement ----------------------------------------------------------------------------

/// A triangle of the arrangement, its corners in the order of their numbers. Its front is the side
/// from which they are counterclockwise.
struct Piece {
  Triangle corners;
  /// For each solid: 1 if it has the piece, its outside in front; -1 if its inside is; or 0.
  std::array<int, 2> turned{0, 0};
  std::array<std::uint32_t, 2> source{kNone, kNone};
};

/// True if the piece's corners, in their order, have the triangle's orientation.
bool runs_alike(const Triangle& sorted, const Triangle& triangle) {
  const auto first = std::ranges::find(triangle, sorted[0]) - triangle.begin();
  return triangle[static_cast<std::size_t>(first + 1) % 3] == sorted[1];
}

/// The triangles of two solids, cut wherever those of one meet those of the other.
class Arrangement {
 public:
  Arrangement(const ExactSurface& a, const ExactSurface& b, CombiningSteps& steps) : steps_(steps) {
    add(a, 0);
    add(b, 1);
    cuts_.resize(triangles_.size());
    find_cuts();
    find_pieces();
    find_patches();
  }

  ExactSurface combined(SolidOperation operation);

 private:
  void add(const ExactSurface& surface, std::size_t solid);
  CGAL::Bbox_3 bounds(std::uint32_t triangle) const;
  void find_cuts();
  void find_cuts(std::uint32_t a, std::uint32_t b);
  void add_cut(std::uint32_t triangle, const Cut& cut);
  void find_pieces();
  void add_piece(std::uint32_t triangle, const Triangle& corners);
  void find_patches();
  std::uint32_t patch_of(std::uint32_t piece);

  bool is_inside(const ExactPoint& p, std::size_t solid);
  /// True if the segment passes through an odd number of the solid's triangles; nothing if it
  /// passes through a corner or a side.
  std::optional<bool> crosses_oddly(const ExactPoint& from, const ExactPoint& to,
                                    std::size_t solid);
  /// Whether the solid is in front of the piece, and whether it is behind it.
  std::array<bool, 2> beside(std::uint32_t piece, std::size_t solid);

  std::span<const Triangle> triangles_of(std::size_t solid) const {
    const std::span<const Triangle> all(triangles_);
    return solid == 0 ? all.first(first_of_b_) : all.subspan(first_of_b_);
  }

  CombiningSteps& steps_;
  NumberedPoints points_;
  std::vector<Triangle> triangles_;  ///< of a, then of b
  std::vector<std::uint32_t> sources_;
  std::size_t first_of_b_ = 0;
  std::array<CGAL::Bbox_3, 2> bounds_;
  std::vector<std::vector<Cut>> cuts_;  ///< of each triangle
  std::vector<Piece> pieces_;
  std::map<Triangle, std::uint32_t> numbers_;  ///< of pieces, by their corners
  /// A patch is a part of a surface that is connected across sides of two pieces: all of it is
  /// inside the other solid or outside. Each piece leads to another one of its patch, or to itself.
  std::vector<std::uint32_t> patches_;
  std::array<std::map<std::uint32_t, bool>, 2> patch_is_inside_;
  std::mt19937 random_;  ///< with one seed: the same rays each time
};

void Arrangement::add(const ExactSurface& surface, std::size_t solid) {
  std::vector<std::uint32_t> number;
  for (const ExactPoint& p : surface.points) {
    number.push_back(points_.number_of(p));
    bounds_[solid] += p.bbox();
  }
  first_of_b_ = triangles_.size();
  for (const auto& [a, b, c] : surface.triangles) {
    triangles_.push_back({number[a], number[b], number[c]});
  }
  sources_.insert(sources_.end(), surface.sources.begin(), surface.sources.end());
}

CGAL::Bbox_3 Arrangement::bounds(std::uint32_t triangle) const {
  CGAL::Bbox_3 box;
  for (const std::uint32_t corner : triangles_[triangle]) box += points_[corner].bbox();
  return box;
}

void Arrangement::find_cuts() {
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;
  std::array<std::vector<Box>, 2> boxes;
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    boxes[i < first_of_b_ ? 0 : 1].emplace_back(bounds(i), i);
  }
  CGAL::box_intersection_d(boxes[0].begin(), boxes[0].end(), boxes[1].begin(), boxes[1].end(),
                           [&](const Box& a, const Box& b) { find_cuts(a.info(), b.info()); });
}

/// Cuts a triangle of each solid. Their intersection is triangulated in the same way in both:
/// otherwise pieces that cover each other would have different corners.
void Arrangement::find_cuts(std::uint32_t a, std::uint32_t b) {
  steps_.step();
  const auto of = [&](std::uint32_t i) {
    const Triangle& corners = triangles_[i];
    return ExactKernel::Triangle_3(points_[corners[0]], points_[corners[1]], points_[corners[2]]);
  };
  const auto common = CGAL::intersection(of(a), of(b));
  if (!common) return;
  std::vector<std::uint32_t> polygon;
  const auto add = [&](const ExactPoint& p) { polygon.push_back(points_.number_of(p)); };
  if (const auto* point = held<ExactPoint>(*common)) {
    add(*point);
  } else if (const auto* segment = held<ExactKernel::Segment_3>(*common)) {
    add(segment->source());
    add(segment->target());
  } else if (const auto* triangle = held<ExactKernel::Triangle_3>(*common)) {
    for (int k = 0; k < 3; ++k) add(triangle->vertex(k));
  } else if (const auto* points = held<std::vector<ExactPoint>>(*common)) {
    for (const ExactPoint& p : *points) add(p);
  }
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Cut side{polygon[k], polygon[(k + 1) % polygon.size()]};
    for (const std::uint32_t triangle : {a, b}) {
      add_cut(triangle, side);
      if (k > 1) add_cut(triangle, {polygon[0], polygon[k]});
    }
  }
}

void Arrangement::add_cut(std::uint32_t triangle, const Cut& cut) {
  const Triangle& corners = triangles_[triangle];
  const auto is_corner = [&](std::uint32_t p) { return std::ranges::count(corners, p) > 0; };
  if (is_corner(cut.first) && is_corner(cut.second)) return;  // a corner, or a side
  cuts_[triangle].emplace_back(std::minmax(cut.first, cut.second));
}

void Arrangement::find_pieces() {
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    if (cuts_[i].empty()) {
      add_piece(i, triangles_[i]);
      continue;
    }
    std::ranges::sort(cuts_[i]);
    cuts_[i].erase(std::unique(cuts_[i].begin(), cuts_[i].end()), cuts_[i].end());
    CutTriangle cut(triangles_[i], points_);
    for (const Cut& along : cuts_[i]) {
      steps_.step();
      cut.cut(along);
    }
    for (const Triangle& piece : cut.pieces()) add_piece(i, piece);
  }
}

void Arrangement::add_piece(std::uint32_t triangle, const Triangle& corners) {
  Triangle sorted = corners;
  std::ranges::sort(sorted);
  const auto [at, is_new] =
      numbers_.try_emplace(sorted, static_cast<std::uint32_t>(pieces_.size()));
  if (is_new) pieces_.push_back({sorted});
  Piece& piece = pieces_[at->second];
  const std::size_t solid = triangle < first_of_b_ ? 0 : 1;
  piece.turned[solid] += runs_alike(sorted, corners) ? 1 : -1;
  piece.source[solid] = sources_[triangle];
}

std::uint32_t Arrangement::patch_of(std::uint32_t piece) {
  while (patches_[piece] != piece) piece = patches_[piece] = patches_[patches_[piece]];
  return piece;
}

void Arrangement::find_patches() {
  patches_.resize(pieces_.size());
  std::iota(patches_.begin(), patches_.end(), 0u);
  struct Side {
    std::uint32_t low, high, piece;
    auto ends() const { return std::pair(low, high); }
  };
  std::vector<Side> sides;
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    const auto& [a, b, c] = pieces_[i].corners;
    sides.insert(sides.end(), {{a, b, i}, {b, c, i}, {a, c, i}});
  }
  std::ranges::sort(sides, {}, &Side::ends);
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t k = i;
    while (k < sides.size() && sides[k].ends() == sides[i].ends()) ++k;
    if (k == i + 2) patches_[patch_of(sides[i].piece)] = patch_of(sides[i + 1].piece);
    i = k;
  }
}

// ---- Inside and outside -------------------------------------------------------------------------

std::optional<bool> Arrangement::crosses_oddly(const ExactPoint& from, const ExactPoint& to,
                                               std::size_t solid) {
  bool is_odd = false;
  for (const Triangle& triangle : triangles_of(solid)) {
    steps_.step();
    const std::array<const ExactPoint*, 3> p{&points_[triangle[0]], &points_[triangle[1]],
                                             &points_[triangle[2]]};
    int least = 1, most = -1;
    for (std::size_t k = 0; k < 3 && (least >= 0 || most <= 0); ++k) {
      const int side = CGAL::orientation(from, to, *p[k], *p[(k + 1) % 3]);
      least = std::min(least, side);
      most = std::max(most, side);
    }
    if (least < 0 && most > 0) continue;  // the line passes beside it
    const int before = CGAL::orientation(*p[0], *p[1], *p[2], from);
    const int behind = CGAL::orientation(*p[0], *p[1], *p[2], to);
    if (before * behind > 0) continue;
    if (least != most || before * behind == 0) return std::nullopt;
    is_odd = !is_odd;
  }
  return is_odd;
}

bool Arrangement::is_inside(const ExactPoint& p, std::size_t solid) {
  if (triangles_of(solid).empty()) return false;
  const CGAL::Bbox_3 box = bounds_[solid] + p.bbox();
  const Point3 low(box.xmin(), box.ymin(), box.zmin()), high(box.xmax(), box.ymax(), box.zmax());
  for (int attempt = 0; attempt < 100; ++attempt) {
    // Beyond the box in x: outside.
    const auto any = [&] { return static_cast<double>(random_() % 4096) / 1024.0 - 1.5; };
    const double y = any(), z = any();
    const Point3 to(high.x + (high.x - low.x) + (high.y - low.y) + (high.z - low.z),
                    low.y + y * (high.y - low.y), low.z + z * (high.z - low.z));
    if (const auto odd = crosses_oddly(p, ExactPoint(to.x, to.y, to.z), solid)) return *odd;
  }
  throw std::runtime_error("expected other parts");
}

std::array<bool, 2> Arrangement::beside(std::uint32_t piece, std::size_t solid) {
  const int turned = pieces_[piece].turned[solid];
  const bool is_outside_in_front = turned > 0;
  if (turned != 0) return {!is_outside_in_front, is_outside_in_front};
  const auto [known, is_new] = patch_is_inside_[solid].try_emplace(patch_of(piece));
  if (is_new) {
    const auto& [a, b, c] = pieces_[piece].corners;
    known->second = is_inside(CGAL::centroid(points_[a], points_[b], points_[c]), solid);
  }
  return {known->second, known->second};
}

bool holds(SolidOperation operation, bool in_a, bool in_b) {
  switch (operation) {
    case SolidOperation::unite: return in_a || in_b;
    case SolidOperation::intersect: return in_a && in_b;
    case SolidOperation::difference: break;
  }
  return in_a && !in_b;
}

ExactSurface Arrangement::combined(SolidOperation operation) {
  ExactSurface result;
  std::vector<std::uint32_t> number(points_.size(), kNone);
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    const auto beside_a = beside(i, 0), beside_b = beside(i, 1);
    const bool in_front = holds(operation, beside_a[0], beside_b[0]);
    const bool behind = holds(operation, beside_a[1], beside_b[1]);
    if (in_front == behind) continue;
    Triangle triangle = pieces_[i].corners;
    if (in_front) std::swap(triangle[1], triangle[2]);
    for (std::uint32_t& corner : triangle) {
      std::uint32_t& renumbered = number[corner];
      if (renumbered == kNone) {
        renumbered = static_cast<std::uint32_t>(result.points.size());
        result.points.push_back(points_[corner]);
      }
      corner = renumbered;
    }
    result.triangles.push_back(triangle);
    const auto& [of_a, of_b] = pieces_[i].source;
    result.sources.push_back(of_a != kNone ? of_a : of_b);
  }
  return result;
}

}  // namespace

ExactSurface combined_by_arrangement(SolidOperation operation, const ExactSurface& a,
                                     const ExactSurface& b, CombiningSteps& steps) {
  return Arrangement(a, b, steps).combined(operation);
}

}  // namespace displayfile
