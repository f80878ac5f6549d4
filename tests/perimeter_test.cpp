// The perimeter method against the general methods of lines on the same triangles.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "displayfile/graphics_system.h"
#include "displayfile/segments/scene_lines.h"
#include "hidden/lines/grid_surface.h"
#include "hidden/lines/line_ends.h"
#include "hidden/lines/visible_lines.h"
#include "interp/truth/judged_lines.h"
#include "tests/error_of.h"
#include "tests/slower.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

using Height = std::function<double(double, double)>;

/// A surface over [-1, 1] x [-1, 1].
std::vector<double> heights_of(int nx, int ny, const Height& height) {
  std::vector<double> heights;
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      heights.push_back(height(-1.0 + 2.0 * i / (nx - 1), -1.0 + 2.0 * j / (ny - 1)));
    }
  }
  return heights;
}

/// The position of the eye, in degrees around z and above the grid, and its distance from the
/// middle; parallel if that is 0.
struct Camera {
  double azimuth, elevation, distance = 0.0;
};

Point3 toward(const Camera& camera) {
  const SineCosine a = sine_cosine_of_degrees(camera.azimuth),
                   e = sine_cosine_of_degrees(camera.elevation);
  return {e.cosine * a.sine, -e.cosine * a.cosine, e.sine};
}

void look(GraphicsSystem& g, const Camera& camera) {
  const Point3 eye = toward(camera);
  g.set_view_plane_normal(-eye);
  g.set_view_up(std::abs(camera.elevation) == 90.0 ? Point3(0, 1, 0) : Point3(0, 0, 1));
  if (camera.distance > 0.0) {
    g.set_perspective(camera.distance * eye);
    g.set_window(-30, 30, -30, 30);
  } else {
    g.set_parallel(-eye);
    g.set_window(-4, 4, -4, 4);
  }
  g.set_window_fit(WindowFit::stretch);
}

DisplayFile surface_seen(const Camera& camera, int nx, int ny, const std::vector<double>& heights,
                         SurfaceCurves curves = SurfaceCurves::both, bool mirrored = false) {
  GraphicsSystem g;
  look(g, camera);
  if (mirrored) g.scale_3(-1, 1, 1);
  g.set_surface_curves(curves);
  g.open_segment(1);
  g.surface_3({-1, 1, nx, -1, 1, ny, heights});
  g.close_segment();
  return g.display_file();
}

using Pieces = std::map<LineName, std::vector<std::pair<double, double>>>;

Pieces pieces_of(const FoundLines& found) {
  Pieces pieces;
  for (const auto& [item, corner, from, to] : found.seen.pieces) {
    pieces[{item, corner}].emplace_back(from, to);
  }
  return pieces;
}

/// The length in one list of intervals that is not in the other, and the reverse.
double difference(const std::vector<std::pair<double, double>>& one,
                  const std::vector<std::pair<double, double>>& other) {
  std::vector<std::pair<double, int>> ends;
  for (const auto& [from, to] : one) ends.insert(ends.end(), {{from, 1}, {to, -1}});
  for (const auto& [from, to] : other) ends.insert(ends.end(), {{from, 2}, {to, -2}});
  std::ranges::sort(ends);
  double sum = 0.0, last = 0.0;
  int state = 0;
  for (const auto& [at, change] : ends) {
    if (state == 1 || state == 2) sum += at - last;
    last = at;
    state += change;
  }
  return sum;
}

struct Compared {
  double differs = 0.0;  ///< in length of the projection
  std::size_t pieces = 0, equal = 0, lines = 0;
};

Compared compared(const DisplayFile& file, const SurfacePlan& options = {}) {
  const ViewedScene scene(file);
  const FoundLines general = find_lines(scene, {.method = HiddenMethod::franklin});
  const FoundLines found = find_lines(scene, options.by(HiddenMethod::perimeter));
  Pieces expected = pieces_of(general), seen = pieces_of(found);
  Compared result{
      .differs = 0.0, .pieces = found.seen.pieces.size(), .equal = 0, .lines = found.lines.size()};
  for (const LineToDraw& line : general.lines) {
    const LineEnds ends(scene.primitives(), line.name);
    const double length = glm::length(Point2(ends.to) - Point2(ends.from));
    const double differs = length * difference(expected[line.name], seen[line.name]);
    result.differs += differs;
    result.equal += expected[line.name] == seen[line.name] ? 1 : 0;
  }
  return result;
}

double wave(double x, double y) { return 0.5 * std::sin(5.0 * x) * std::cos(4.0 * y + x); }

/// A segment with 15 x 12 points of it.
void enter_wave(GraphicsSystem& g) {
  const std::vector<double> heights = heights_of(15, 12, wave);
  g.open_segment(1);
  g.surface_3({-1, 1, 15, -1, 1, 12, heights});
  g.close_segment();
}

constexpr double kRounding = 1e-9;

TEST(Perimeter, FromAllSidesIsWhatTheGeneralMethodsSee) {
  const std::vector<double> heights = heights_of(13, 17, wave);
  for (const double distance : {0.0, 3.0, 5.0}) {
    for (int azimuth = 0; azimuth < 360; azimuth += 17) {
      for (const double elevation : {-70.0, -20.0, 0.0, 7.0, 30.0, 65.0, 89.0}) {
        SCOPED_TRACE(testing::Message() << azimuth << " " << elevation << " " << distance);
        const Camera camera{static_cast<double>(azimuth), elevation, distance};
        const Compared result = compared(surface_seen(camera, 13, 17, heights));
        EXPECT_LE(result.differs, kRounding);
        EXPECT_GT(result.pieces, 13u * 17u / 8u);
      }
    }
  }
}

TEST(Perimeter, MostPiecesAreTheSameBitForBit) {
  const std::vector<double> heights = heights_of(40, 40, wave);
  const Compared result = compared(surface_seen({33.0, 25.0, 4.0}, 40, 40, heights));
  EXPECT_LE(result.differs, kRounding);
  EXPECT_EQ(result.equal, result.lines);
}

TEST(Perimeter, AlongTheGridAndFromAbove) {
  const std::vector<double> heights = heights_of(11, 9, wave);
  for (const double distance : {0.0, 4.0}) {
    for (const double azimuth : {0.0, 90.0, 180.0, 270.0}) {
      for (const double elevation : {-90.0, -30.0, 0.0, 15.0, 60.0, 90.0}) {
        SCOPED_TRACE(testing::Message() << azimuth << " " << elevation << " " << distance);
        const Compared result =
            compared(surface_seen({azimuth, elevation, distance}, 11, 9, heights));
        EXPECT_LE(result.differs, kRounding);
      }
    }
  }
}

/// Flattened, and seen from its edge: one line in the picture, whose columns have no width.
TEST(Perimeter, OfNoWidth) {
  const std::vector<double> heights = heights_of(6, 5, wave);
  for (const Camera& camera : {Camera{0.0, 0.0}, Camera{0.0, 30.0}, Camera{0.0, 10.0, 4.0}}) {
    GraphicsSystem g;
    look(g, camera);
    g.scale_3(0, 1, 1);
    g.open_segment(1);
    g.surface_3({-1, 1, 6, -1, 1, 5, heights});
    g.close_segment();
    EXPECT_LE(compared(g.display_file()).differs, kRounding);
  }
}

/// Heights of few values, so that cells are flat and heights equal; plains and steps.
std::vector<double> stepped(test::Dice& dice, int nx, int ny) {
  const int values = dice.from(1, 4);
  const bool in_rows = dice.one_in(3), in_columns = dice.one_in(3);
  std::vector<double> of_row(static_cast<std::size_t>(std::max(nx, ny)));
  for (double& z : of_row) z = dice.from(0, values) / 4.0;
  std::vector<double> heights;
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      heights.push_back(in_rows      ? of_row[static_cast<std::size_t>(j)]
                        : in_columns ? of_row[static_cast<std::size_t>(i)]
                                     : dice.from(0, values) / 4.0);
    }
  }
  return heights;
}

TEST(Perimeter, OfRandomGridsAndViews) {
  constexpr std::uint32_t kGrids = 1000 / test::kSlower;
  for (std::uint32_t seed = 0; seed < kGrids; ++seed) {
    SCOPED_TRACE(seed);
    test::Dice dice(seed);
    const int nx = dice.from(2, 12), ny = dice.from(2, 12);
    std::vector<double> heights(static_cast<std::size_t>(nx * ny));
    for (double& z : heights) z = dice.from(-1000, 1000) / 1000.0;
    if (dice.one_in(2)) heights = stepped(dice, nx, ny);
    Camera camera{dice.from(0, 3599) / 10.0, dice.from(-890, 890) / 10.0,
                  dice.one_in(2) ? 0.0 : dice.from(25, 80) / 10.0};
    if (dice.one_in(3)) camera.azimuth = 45.0 * dice.from(0, 7);
    if (dice.one_in(4)) camera.elevation = 0.0;
    const auto curves = static_cast<SurfaceCurves>(dice.from(0, 2));
    const Compared result = compared(surface_seen(camera, nx, ny, heights, curves));
    EXPECT_LE(result.differs, kRounding);
  }
}

/// They are drawn only if they are named, as lines of either triangle, along which they run in
/// opposite directions.
TEST(Perimeter, DiagonalsThatAreAskedFor) {
  constexpr int kPoints = 12;
  const auto heights = heights_of(kPoints, kPoints, [](double x, double y) {
    return 0.6 * std::sin(4.0 * x) * std::cos(3.0 * y);
  });
  for (const std::uint32_t kind : {0u, 1u, 2u, 3u}) {
    const std::uint32_t triangle = kind % 2, mirrored = kind / 2;
    const ViewedScene scene(
        surface_seen({35, 25, 5}, kPoints, kPoints, heights, SurfaceCurves::both, mirrored != 0));
    std::vector<LineName> names;
    for (std::uint32_t cell = 0; cell < (kPoints - 1) * (kPoints - 1); ++cell) {
      names.push_back({2 * cell + triangle, triangle});
    }
    Pieces of_both[2];
    for (const HiddenMethod method : {HiddenMethod::franklin, HiddenMethod::perimeter}) {
      const SeenLines seen = visible_lines(scene.primitives(), names, {.method = method});
      Pieces& pieces = of_both[method == HiddenMethod::perimeter];
      for (const auto& [item, corner, from, to] : seen.pieces) {
        pieces[{item, corner}].emplace_back(from, to);
      }
    }
    double differs = 0.0;
    for (const LineName& name : names) differs += difference(of_both[0][name], of_both[1][name]);
    EXPECT_LT(differs, 1e-9) << kind;
    EXPECT_FALSE(of_both[0].empty());
  }
}

TEST(Perimeter, AgainstTheTruth) {
  constexpr std::uint32_t kGrids = 40 / test::kSlower;
  for (std::uint32_t seed = 0; seed < kGrids; ++seed) {
    SCOPED_TRACE(seed);
    test::Dice dice(seed + 5000);
    const int nx = dice.from(2, 7), ny = dice.from(2, 7);
    const Camera camera{dice.from(0, 359) * 1.0, dice.from(-80, 80) * 1.0,
                        dice.one_in(2) ? 0.0 : dice.from(3, 8) * 1.0};
    const DisplayFile file = surface_seen(camera, nx, ny, stepped(dice, nx, ny));
    const JudgedLines judged = judged_lines(file, {.method = HiddenMethod::perimeter});
    EXPECT_LE(judged.errors.missing + judged.errors.extra, kRounding);
  }
}

/// Cells that are seen edge-on, diagonals in line with the eye: sides lie on others in the picture,
/// of which some are not drawn, and planes decide which lines they hide.
TEST(Perimeter, SidesThatLieOnOthers) {
  constexpr std::uint32_t kGrids = 400 / test::kSlower;
  std::size_t pieces = 0;
  for (std::uint32_t seed = 0; seed < kGrids; ++seed) {
    SCOPED_TRACE(seed);
    test::Dice dice(seed + 7000);
    const int nx = dice.from(2, 7), ny = dice.from(2, 7);
    const Camera camera{45.0 * dice.from(0, 7), 0.0, dice.one_in(2) ? 0.0 : dice.from(3, 8) * 1.0};
    const DisplayFile file = surface_seen(camera, nx, ny, stepped(dice, nx, ny));
    const JudgedLines judged = judged_lines(file, {.method = HiddenMethod::perimeter});
    EXPECT_LE(judged.errors.missing + judged.errors.extra, kRounding);
    pieces += judged.pieces;
  }
  EXPECT_GT(pieces, 10 * kGrids);
}

/// Two steps, from a corner: three sides lie on the diagonal of a nearer cell.
TEST(Perimeter, SidesBehindADiagonal) {
  GraphicsSystem g;
  const double diagonal = std::sqrt(0.5);
  g.set_view_plane_normal({-diagonal, diagonal, 0});
  g.set_view_up({0, 0, 1});
  g.set_parallel({-diagonal, diagonal, 0});
  g.set_window(-4, 4, -4, 4);
  g.open_segment(1);
  const std::vector<double> heights{0.25, 0.5,  0.75, 0.5, 0.5, 0.5, 0.75, 0.25,
                                    0,    0.25, 0,    0,   0,   0,   0.75, 0};
  g.surface_3({-1, 1, 4, -1, 1, 4, heights});
  g.close_segment();
  const JudgedLines judged = judged_lines(g.display_file(), {.method = HiddenMethod::perimeter});
  EXPECT_LE(judged.errors.missing + judged.errors.extra, kRounding);
}

/// A length within which parts touch may be as large as the steps: lines within it of a plane lie
/// in it.
TEST(Perimeter, WithATouchingLength) {
  for (std::uint32_t seed = 0; seed < 60 / test::kSlower; ++seed) {
    SCOPED_TRACE(seed);
    test::Dice dice(seed + 8000);
    const int nx = dice.from(2, 6), ny = dice.from(2, 6);
    GraphicsSystem g;
    g.set_hidden_surfaces(
        {.touching = Touching{Touching::Kind::length, seed % 2 == 0 ? 0.05 : 1e-6}});
    look(g, {45.0 * dice.from(0, 7), 0.0});
    g.open_segment(1);
    const std::vector<double> heights = stepped(dice, nx, ny);
    g.surface_3({-1, 1, nx, -1, 1, ny, heights});
    g.close_segment();
    EXPECT_LE(compared(g.display_file()).differs, kRounding);
  }
}

TEST(Perimeter, ThroughModellingAndImageTransformations) {
  GraphicsSystem g;
  look(g, {20.0, 30.0, 6.0});
  g.scale_3(0.7, 1.2, -0.8);
  g.rotate_x_3(25);
  g.rotate_z_3(40);
  enter_wave(g);
  g.set_image_rotation(1, 30);
  g.set_image_scale(1, 0.8, 0.5);
  EXPECT_LE(compared(g.display_file()).differs, kRounding);
}

/// Cells share sides as the grid defines: no table of them is made.
TEST(Perimeter, ItsLinesAreThoseOfATableOfSides) {
  constexpr std::uint32_t kGrids = 100 / test::kSlower;
  for (std::uint32_t seed = 0; seed < kGrids; ++seed) {
    SCOPED_TRACE(seed);
    test::Dice dice(seed + 9000);
    const int nx = dice.from(2, 9), ny = dice.from(2, 9);
    const Camera camera{dice.from(0, 3599) / 10.0, dice.from(-600, 600) / 10.0};
    const auto curves = static_cast<SurfaceCurves>(dice.from(0, 2));
    const bool mirrored = dice.one_in(3);
    const ViewedScene scene(surface_seen(camera, nx, ny, stepped(dice, nx, ny), curves, mirrored));
    Primitives items = scene.primitives();
    // Some sides are drawn by one triangle alone.
    std::vector<std::uint8_t> drawn = scene.drawn_sides();
    for (std::uint8_t& side : drawn) side = dice.one_in(4) ? std::uint8_t{0} : side;
    items.visible = drawn;
    std::vector<std::int32_t> picks(items.items.size());
    for (std::int32_t& pick : picks) pick = dice.from(1, 5);
    const GridSurface surface(items);
    for (const std::span<const std::int32_t> of_items :
         {std::span<const std::int32_t>(), std::span<const std::int32_t>(picks)}) {
      const auto expected = lines_to_draw(items, of_items, nullptr);
      const auto lines = lines_to_draw(items, of_items, &surface);
      ASSERT_EQ(lines.size(), expected.size());
      for (std::size_t k = 0; k < lines.size(); ++k) {
        EXPECT_EQ(lines[k].name, expected[k].name);
        EXPECT_EQ(lines[k].kinds, expected[k].kinds);
        EXPECT_EQ(lines[k].pick_item, expected[k].pick_item);
      }
    }
  }
}

TEST(Perimeter, InAPartOfThePicture) {
  for (const Camera& camera : {Camera{20.0, 30.0, 4.0}, Camera{70.0, -40.0}}) {
    GraphicsSystem g;
    look(g, camera);
    g.set_viewport(0.3, 0.9, 0.1, 0.6);
    enter_wave(g);
    EXPECT_LE(compared(g.display_file()).differs, kRounding);
  }
}

TEST(Perimeter, IsTheSameOnAnyNumberOfThreads) {
  constexpr std::uint32_t kGrids = 100 / test::kSlower;
  for (std::uint32_t seed = 0; seed < kGrids; ++seed) {
    SCOPED_TRACE(seed);
    test::Dice dice(seed + 7000);
    const int nx = dice.from(2, 30), ny = dice.from(2, 30);
    std::vector<double> heights = stepped(dice, nx, ny);
    if (dice.one_in(2)) heights = heights_of(nx, ny, wave);
    const Camera camera{dice.from(0, 3599) / 10.0, dice.from(-600, 600) / 10.0,
                        dice.one_in(2) ? 0.0 : dice.from(25, 80) / 10.0};
    const ViewedScene scene(surface_seen(camera, nx, ny, heights));
    const FoundLines alone = find_lines(scene, {.method = HiddenMethod::perimeter});
    for (const int threads : {2, 3, 16}) {
      SurfacePlan options;
      options.threads = threads;
      const FoundLines found = find_lines(scene, options.by(HiddenMethod::perimeter));
      EXPECT_EQ(found.seen.pieces, alone.seen.pieces) << threads;
    }
  }
}

TEST(Perimeter, OtherLinesAreHiddenByTheSurface) {
  const std::vector<double> heights = heights_of(15, 12, wave);
  GraphicsSystem g;
  look(g, {20.0, 30.0});
  g.open_segment(1);
  g.move_abs_3(-1, 1.5, -1);
  g.line_abs_3(1, 1.2, 1);
  g.surface_3({-1, 1, 15, -1, 1, 12, heights});
  g.line_abs_3(0, 0, -2);
  g.close_segment();
  EXPECT_LE(compared(g.display_file()).differs, kRounding);
}

TEST(Perimeter, WithRoundoffItIsTheProblemBooksArray) {
  const std::vector<double> heights = heights_of(40, 40, wave);
  const DisplayFile file = surface_seen({33.0, 25.0, 4.0}, 40, 40, heights);
  SurfacePlan options;
  options.precision = {.exact = false, .roundoff = 1e-9};
  const Compared result = compared(file, options);
  EXPECT_GT(result.differs, kRounding);
  EXPECT_LT(result.differs, 1.0);  // of some 30 that are seen
}

std::string error_of(const std::function<void(GraphicsSystem&)>& enter) {
  GraphicsSystem g;
  look(g, {20.0, 30.0});
  g.set_hidden_surfaces({.method = HiddenMethod::perimeter});
  g.open_segment(1);
  enter(g);
  return test::error_of(
      [&] { find_lines(ViewedScene(g.display_file()), {.method = HiddenMethod::perimeter}); });
}

TEST(Perimeter, WhatIsNotOneWholeSurfaceIsRefused) {
  const std::vector<double> heights = heights_of(5, 5, wave);
  const SurfaceGrid grid{-1, 1, 5, -1, 1, 5, heights};
  const std::string draws = "'perimeter' draws one surface, whole and of solid cells; ";
  const auto expect = [&](const std::string& what,
                          const std::function<void(GraphicsSystem&)>& enter) {
    const std::string error = error_of(enter);
    EXPECT_NE(error.find(draws + what), std::string::npos) << error;
    EXPECT_NE(error.find("expected another method, such as franklin"), std::string::npos) << error;
  };
  expect("there is none", [](auto& g) { g.polygon_abs_3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}); });
  expect("there are 2", [&](auto& g) {
    g.surface_3(grid);
    g.surface_3(grid);
  });
  expect("there are polygons beside it", [&](auto& g) {
    g.surface_3(grid);
    g.polygon_abs_3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  });
  expect("its cell 3 3 is missing", [&](auto& g) {
    std::vector<double> with_hole = heights;
    with_hole[18] = std::numeric_limits<double>::quiet_NaN();
    g.surface_3({-1, 1, 5, -1, 1, 5, with_hole});
  });
  expect("its cell 1 1 is missing, clipped, hollow", [&](auto& g) {
    g.set_fill_style({FillStyle::Kind::hollow});
    g.surface_3(grid);
  });
  expect("its cell", [&](auto& g) { g.surface_3({-9, 1, 5, -1, 1, 5, heights}); });
  EXPECT_EQ(error_of([&](auto& g) { g.surface_3(grid); }), "");
  EXPECT_EQ(error_of([&](auto& g) { g.line_abs_3(1, 1, 1); }), "");
}

}  // namespace
}  // namespace displayfile
