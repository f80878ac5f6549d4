// Where corners meet a display file has one number: no two points of its pieces are as close as
// rounding, except vertices that were entered so, and slivers.

#include "displayfile/segments/cuts_at_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "clip/geometry/back_face.h"
#include "displayfile/segments/sorted_display_file.h"
#include "interp/device/output_device.h"
#include "tests/touching_scenes.h"

namespace displayfile {
namespace {

using test::Source;

constexpr double kRounding = 1e-13;

using Places = std::vector<std::array<double, 2>>;

/// The points of pieces that are no slivers as wide as rounding.
Places places_of(const DrawnPieces& pieces) {
  Places places;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const auto points =
        std::span(pieces.points).subspan(pieces.first[k], pieces.first[k + 1] - pieces.first[k]);
    if (points.size() > 2 && std::abs(newell_c(points)) < kRounding) continue;
    for (const Point3& p : points) places.push_back({p.x, p.y});
  }
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// Pairs of places as close as rounding, of which at least one is not a vertex.
std::size_t cracks(const Places& places, const Places& vertices) {
  const auto is_vertex = [&](const auto& p) { return std::ranges::binary_search(vertices, p); };
  std::size_t found = 0;
  for (std::size_t a = 0; a < places.size(); ++a) {
    for (std::size_t b = a + 1; b < places.size(); ++b) {
      if (places[b][0] - places[a][0] > kRounding) break;
      if (std::abs(places[b][1] - places[a][1]) > kRounding) continue;
      if (!is_vertex(places[a]) || !is_vertex(places[b])) ++found;
    }
  }
  return found;
}

struct Drawn {
  DrawnPieces whole, sorted;
};

Drawn drawn(std::uint64_t seed, HiddenMethod method) {
  Source s(seed);
  GraphicsSystem g;
  test::view_from_anywhere(s, g);
  if (seed % 2 == 0) test::turn_and_move(s, g);
  g.set_line_style({});
  g.set_hidden_surfaces({.removal = true});
  g.set_back_face_removal(false);
  g.open_segment(1);
  test::enter_boxes_on_floor(s, g);
  g.close_segment();
  HiddenSurfaceOptions options;
  options.method = method;
  SortedDisplayFile sorted;
  return {drawn_pieces(g.display_file()), drawn_pieces(sorted.update(g, method, options))};
}

class CutsAtVertices : public testing::TestWithParam<HiddenMethod> {};

TEST_P(CutsAtVertices, LeaveNoCracks) {
  std::size_t cuts = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Drawn of = drawn(seed, GetParam());
    const Places vertices = places_of(of.whole), places = places_of(of.sorted);
    EXPECT_EQ(cracks(places, vertices), 0u) << "seed " << seed;
    Places made;
    std::ranges::set_difference(places, vertices, std::back_inserter(made));
    cuts += made.size();
  }
  EXPECT_GT(cuts, 50u);
}

/// Sides have a length, and polygons three of them.
TEST_P(CutsAtVertices, LeaveWholePieces) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const DrawnPieces pieces = drawn(seed, GetParam()).sorted;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const auto points =
          std::span(pieces.points).subspan(pieces.first[k], pieces.first[k + 1] - pieces.first[k]);
      ASSERT_GE(points.size(), pieces.kinds[k] == DrawnPieces::Kind::line ? 2u : 3u);
      for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NE(Point2(points[i]), Point2(points[(i + 1) % points.size()])) << "seed " << seed;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(By, CutsAtVertices,
                         testing::Values(HiddenMethod::bsp, HiddenMethod::depth_sort,
                                         HiddenMethod::map, HiddenMethod::franklin),
                         [](const auto& method) {
                           std::string name(name_of(method.param));
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace displayfile
