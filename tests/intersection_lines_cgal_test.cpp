// Where triangles pass through each other (hidden/lines/intersection_lines.h) against CGAL's exact
// constructions.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "hidden/exact/support_plane.h"
#include "hidden/lines/intersection_lines.h"
#include "tests/slower.h"
#include "tests/sort_scenes.h"

namespace displayfile {
namespace {

using namespace test;
using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactNumberOfCgal = ExactKernel::FT;
using Corners = std::array<Point3, 3>;

ExactKernel::Point_3 exactly(const Point3& p) { return {p.x, p.y, p.z}; }
ExactKernel::Triangle_3 exactly(const Corners& t) {
  return {exactly(t[0]), exactly(t[1]), exactly(t[2])};
}

/// True if no double is closer.
bool is_nearest(double value, const ExactNumberOfCgal& exact) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto off = [&](double d) -> ExactNumberOfCgal {
    return CGAL::abs(exact - ExactNumberOfCgal(d));
  };
  const ExactNumberOfCgal found = off(value);
  return found <= off(std::nextafter(value, kInfinity)) &&
         found <= off(std::nextafter(value, -kInfinity));
}
bool is_nearest(const Point3& value, const ExactKernel::Point_3& exact) {
  return is_nearest(value.x, exact.x()) && is_nearest(value.y, exact.y()) &&
         is_nearest(value.z, exact.z());
}

/// The segment that the triangles have in common, if that is a segment.
std::optional<ExactKernel::Segment_3> common_segment(const Corners& a, const Corners& b) {
  const auto common = CGAL::intersection(exactly(a), exactly(b));
  if (!common) return std::nullopt;
  const auto* segment = boost::get<ExactKernel::Segment_3>(&*common);
  return segment == nullptr ? std::nullopt : std::optional(*segment);
}

bool lies_on_a_side(const ExactKernel::Segment_3& segment, const Corners& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    const ExactKernel::Segment_3 side(exactly(t[k]), exactly(t[(k + 1) % 3]));
    if (side.has_on(segment.source()) && side.has_on(segment.target())) return true;
  }
  return false;
}

/// True if it is so short that its rounded ends may be one point.
bool is_crumb(const ExactKernel::Segment_3& segment) {
  return segment.squared_length() < ExactNumberOfCgal(1e-31);
}

/// At random, on a grid of few places, around one line, or with a corner in common.
std::array<Corners, 2> two_triangles(Source& s) {
  std::array<Corners, 2> pair;
  const int kind = s.below(4), n = s.between(2, 5);
  for (Corners& t : pair) {
    for (Point3& p : t) {
      p = kind == 0 ? in_cube(s) : on_grid(s, n, n);
      if (kind == 2) p.z = 0.5 + (p.x - 0.5) * s.between(-3, 3) / 4.0;
    }
  }
  if (kind == 3) pair[1][0] = pair[0][static_cast<std::size_t>(s.below(3))];
  return pair;
}

TEST(IntersectionLinesAndCgal, TrianglesHaveTheSameSegment) {
  Source s(7);
  int crossing = 0, touching = 0;
  for (int k = 0; k < 20000 / kSlower; ++k) {
    const auto [a, b] = two_triangles(s);
    if (support_vertices(a).edge_on || support_vertices(b).edge_on) continue;  // by definition
    ItemList list;
    list.solid({a.begin(), a.end()});
    list.solid({b.begin(), b.end()});
    const std::vector<IntersectionLine> found = intersection_lines(list.view());
    const auto common = common_segment(a, b);
    if (found.empty()) {
      touching += common ? 1 : 0;
      ASSERT_TRUE(!common || is_crumb(*common) || lies_on_a_side(*common, a) ||
                  lies_on_a_side(*common, b))
          << list.text();
      continue;
    }
    ++crossing;
    ASSERT_EQ(found.size(), 1u) << list.text();
    ASSERT_TRUE(common.has_value()) << list.text();
    ASSERT_FALSE(lies_on_a_side(*common, a) || lies_on_a_side(*common, b)) << list.text();
    const bool turned = common->target() < common->source();
    ASSERT_TRUE(is_nearest(found[0].start, turned ? common->target() : common->source()) &&
                is_nearest(found[0].end, turned ? common->source() : common->target()))
        << list.text();
  }
  EXPECT_GT(crossing, 1000 / kSlower);
  EXPECT_GT(touching, 100 / kSlower);
}

}  // namespace
}  // namespace displayfile
