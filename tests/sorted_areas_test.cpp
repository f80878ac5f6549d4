// The areas of the object-space sorts' pieces sum exactly to those of the polygons as entered.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "hidden/sort/sort_polygons.h"
#include "tests/every_way.h"

namespace displayfile {
namespace {

using namespace test;

/// Exact, and keeps the definition of each vertex that it makes, in the order of their numbers.
class Recorded : public Exact {
 public:
  Recorded(const Definitions& all, std::vector<DefinedPoint>& made) : Exact(all), made_(&made) {}
  Vertex vertex(std::uint32_t point, std::uint32_t own) const {
    return made_->emplace_back(Exact::vertex(point, own));
  }
  Vertex cut(const Vertex& from, const Vertex& to, const SideLine& line, std::uint32_t own,
             std::uint32_t plane) const {
    return made_->emplace_back(Exact::cut(from, to, line, own, plane));
  }

 private:
  std::vector<DefinedPoint>* made_;
};

/// The tree's pieces as they are, not rounded.
class ExactPieces {
 public:
  ExactPieces(const ItemList& list, RootChoice root)
      : items_(list.view()), scene_(items_, Recorded({items_.points, {}}, made_)) {
    const SurfacePlan options{.root = root};
    SortPolygons<Recorded> sorting(scene_, options);
    sorting.sort_all();
    order_.assign(sorting.order().begin(), sorting.order().end());
  }

  std::span<const PolygonTable::Index> order() const { return order_; }
  std::uint32_t item(PolygonTable::Index piece) const { return scene_.table[piece].item; }
  bool is_polygon(PolygonTable::Index piece) const { return scene_.table[piece].plane != kNoPlane; }
  std::vector<QPoint> points(PolygonTable::Index piece) const {
    std::vector<QPoint> loop;
    for (const std::uint32_t v : scene_.table.vertices(piece)) loop.push_back(point(v));
    return loop;
  }
  /// A vertex of the display file is the true one, rounded once.
  bool is_rounded_once(PolygonTable::Index piece) const {
    return std::ranges::all_of(scene_.table.vertices(piece), [&](std::uint32_t v) {
      const QPoint truth = point(v);
      const Point3 found = scene_.vertices.coordinates(v);
      const auto is_nearest = [](double x, const Q& exactly) {
        const Q off = abs(Q(x) - exactly);
        return off <= abs(Q(std::nextafter(x, 1e300)) - exactly) &&
               off <= abs(Q(std::nextafter(x, -1e300)) - exactly);
      };
      return is_nearest(found.x, truth.x) && is_nearest(found.y, truth.y) &&
             is_nearest(found.z, truth.z);
    });
  }

 private:
  QPlane plane(std::uint32_t k) const {
    const Plane& p = scene_.vertices.plane(k);
    return {rational(p.p), rational(p.q), rational(p.r)};
  }
  QPoint lifted(std::uint32_t k, std::uint32_t own) const {
    const QPoint v = rational(items_.points[k]);
    return {v.x, v.y, plane(own).z(v.x, v.y)};
  }
  QPoint point(std::uint32_t v) const {
    if (v < items_.points.size()) return rational(items_.points[v]);
    const DefinedPoint& d = made_[v - items_.points.size()];
    switch (d.kind) {
      case DefinedPoint::Kind::stored: return rational(d.near);
      case DefinedPoint::Kind::lifted: return lifted(d.a, d.own);
      case DefinedPoint::Kind::edge_cut:
        return *meet(rational(items_.points[d.a]), rational(items_.points[d.b]), plane(d.cut));
      case DefinedPoint::Kind::lifted_edge_cut:
        return *meet(lifted(d.a, d.own), lifted(d.b, d.own), plane(d.cut));
      case DefinedPoint::Kind::plane_cut: return *meet(plane(d.own), plane(d.a), plane(d.cut));
    }
    return {};
  }

  Primitives items_;
  std::vector<DefinedPoint> made_;
  SortTables<Recorded> scene_;
  std::vector<PolygonTable::Index> order_;
};

/// Signed areas are additive whatever the polygon; of one that does not cross itself, no piece
/// may turn the other way.
void expect_exact_areas(const ItemList& list, RootChoice root, bool simple) {
  const ExactPieces pieces(list, root);
  std::vector<Q> area(list.items.size());
  std::vector<bool> polygon(list.items.size());
  for (const auto piece : pieces.order()) {
    if (!pieces.is_polygon(piece)) continue;
    const std::uint32_t item = pieces.item(piece);
    const Q part = twice_area(pieces.points(piece));
    if (simple) {
      EXPECT_EQ(sgn(part), sgn(twice_area(list.points_of(item)))) << "item " << item;
    }
    EXPECT_TRUE(pieces.is_rounded_once(piece)) << "item " << item;
    area[item] += part;
    polygon[item] = true;
  }
  for (std::size_t i = 0; i < area.size(); ++i) {
    EXPECT_EQ(polygon[i], plane_by_definition(list.points_of(i)).has_value()) << "item " << i;
    if (!polygon[i]) continue;
    EXPECT_EQ(area[i], twice_area(list.points_of(i))) << "item " << i;
  }
}

TEST(SortedAreas, SumToTheirPolygonsExactly) {
  for (const SortFamily& family : sort_families()) {
    if (family.name == "lines" || family.name == "cycles") continue;
    for (int k = 0; k < 12 / std::min(kSlower, 6); ++k) {
      for (const RootChoice root : {RootChoice::last, RootChoice::sample, RootChoice::free}) {
        Source s(static_cast<std::uint64_t>(1000 + k));
        const ItemList list = family.make(s);
        expect_exact_areas(list, root, false);
        ASSERT_FALSE(HasFailure()) << family.name << ", seed " << 1000 + k << "\n" << list.text();
      }
    }
  }
}

TEST(SortedAreas, NoPieceOfASimplePolygonIsEmptyOrTurnedOver) {
  for (int k = 0; k < 60 / kSlower; ++k) {
    Source s(static_cast<std::uint64_t>(k));
    ItemList list;
    for (int n = s.between(2, 6); n > 0; --n) {
      list.solid(s.below(2) == 0 ? star_shaped(s, any_slope(s), s.between(4, 12))
                                 : convex(s, any_slope(s), s.between(3, 7)));
    }
    for (const RootChoice root : {RootChoice::last, RootChoice::sample, RootChoice::free}) {
      expect_exact_areas(list, root, true);
      ASSERT_FALSE(HasFailure()) << k << "\n" << list.text();
    }
  }
}

}  // namespace
}  // namespace displayfile
