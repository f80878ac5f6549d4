// Two independent results for the visible polygon at each pixel: our scan conversion and z-buffer,
// and OpenGL's (OSMesa, llvmpipe). They may differ only where OpenGL's own precision leaves the
// answer open: it rounds vertices to 1/256 pixel and depths to 24 bits. Which answers are open is
// worked out here from the polygons themselves, in long double, without a line of either
// rasteriser.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "clip/geometry/unit.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/segments/viewed_scene.h"
#include "interp/device/interpreter.h"
#include "interp/device/raster_request.h"
#include "interp/opengl/osmesa.h"
#include "interp/raster/software.h"
#include "tests/mesa_leaks.h"
#include "tests/slower.h"

namespace displayfile {
namespace {

using Real = long double;

constexpr Real kEdgeDistance = 1.0L / 256;  // pixels

// llvmpipe's depth at a pixel's centre differs from the plane's by no more than the sum of three
// terms, all in units of 2^-24, the unit of its depth format and of single precision:
//   - the mapped range of z, for the rounding of stored depths and of the vertices' depths;
//   - the rise of the plane over the picture's width and height together, for it works with x
//     and y in single precision;
//   - the triangle's own range of z times its longest side over its height, for the plane of
//     a thin triangle comes from differences of products that nearly cancel.
// The factors are measured: OpenGlsDepthErrorIsWithinTheStatedBound asserts that the bound holds at
// every pixel, and that it is reached within a factor of 2.
constexpr Real kUnitsForRange = 3, kUnitsForRise = 4, kUnitsForThinness = 3;
const Real kUnit = std::exp2(Real(-24));

using Pixels = std::array<Real, 2>;

Real cross(const Pixels& a, const Pixels& b, const Pixels& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// A polygon as it is drawn: vertices in pixels, j upward, and its support plane.
struct Drawn {
  std::int32_t id;
  std::vector<Pixels> vertices;
  Real i0, j0, z0, dz_di, dz_dj;
  Real i_min, i_max, j_min, j_max;

  Real depth(Real i, Real j) const { return z0 + dz_di * (i - i0) + dz_dj * (j - j0); }

  /// The largest, among the triangles of the polygon's fan that hold the point, or all but hold it,
  /// of their range of z times longest side over height.
  Real thinness(Real i, Real j) const {
    Real largest = 0;
    for (std::size_t k = 2; k < vertices.size(); ++k) {
      const std::array<Pixels, 3> corner = {vertices[0], vertices[k - 1], vertices[k]};
      const Real area = cross(corner[0], corner[1], corner[2]);
      if (area == 0) continue;
      Real longest = 0, farthest_out = 0;
      for (std::size_t n = 0; n < 3; ++n) {
        const Pixels &a = corner[n], &b = corner[(n + 1) % 3];
        const Real side = std::hypot(b[0] - a[0], b[1] - a[1]);
        longest = std::max(longest, side);
        farthest_out = std::max(farthest_out, -std::copysign(1, area) * cross(a, b, {i, j}) / side);
      }
      if (farthest_out > kEdgeDistance) continue;
      const auto z = [&](std::size_t n) { return depth(corner[n][0], corner[n][1]); };
      const auto [low, high] = std::minmax({z(0), z(1), z(2)});
      largest = std::max(largest, (high - low) * longest * longest / std::abs(area));
    }
    return largest;
  }

  bool covers(Real i, Real j) const {
    bool inside = false;
    for (std::size_t k = 0, last = vertices.size() - 1; k < vertices.size(); last = k++) {
      const auto &a = vertices[last], &b = vertices[k];
      if ((a[1] < j) == (b[1] < j)) continue;
      inside ^= a[0] + (j - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) <= i;
    }
    return inside;
  }

  Real distance_to_edge(Real i, Real j) const {
    Real nearest = std::numeric_limits<Real>::infinity();
    for (std::size_t k = 0, last = vertices.size() - 1; k < vertices.size(); last = k++) {
      const auto &a = vertices[last], &b = vertices[k];
      const Real x = b[0] - a[0], y = b[1] - a[1], square = x * x + y * y;
      const Real along = square == 0 ? 0 : ((i - a[0]) * x + (j - a[1]) * y) / square;
      const Real t = std::clamp<Real>(along, 0, 1);
      nearest = std::min(nearest, std::hypot(a[0] + t * x - i, a[1] + t * y - j));
    }
    return nearest;
  }
};

/// Collects the filled polygons with their support planes, by the definition.
struct Collector final : OutputDevice {
  Real width, height;
  std::vector<Drawn> polygons;
  Real z_min = std::numeric_limits<Real>::infinity(), z_max = -z_min;

  Collector(int w, int h) : width(w), height(h) {}

  static std::array<std::size_t, 3> support(std::span<const Point3> v) {
    if (v.size() == 3) return {0, 1, 2};
    const auto first_of_largest = [&](auto&& value) {
      std::size_t best = 0;
      for (std::size_t i = 1; i < v.size(); ++i) {
        if (value(i) > value(best)) best = i;
      }
      return best;
    };
    const std::size_t q = first_of_largest([&](std::size_t i) {
      const double x = v[i].x - v[0].x, y = v[i].y - v[0].y;
      return x * x + y * y;
    });
    const std::size_t r = first_of_largest([&](std::size_t i) {
      return std::abs((v[q].x - v[0].x) * (v[i].y - v[0].y) -
                      (v[q].y - v[0].y) * (v[i].x - v[0].x));
    });
    return {0, q, r};
  }

  void fill(const DrawnPolygon& polygon) override {
    const auto v = polygon.vertices;
    const auto [p, q, r] = support(v);
    const Real ux = (Real(v[q].x) - v[p].x) * width, uy = (Real(v[q].y) - v[p].y) * height,
               uz = Real(v[q].z) - v[p].z;
    const Real vx = (Real(v[r].x) - v[p].x) * width, vy = (Real(v[r].y) - v[p].y) * height,
               vz = Real(v[r].z) - v[p].z;
    const Real c = ux * vy - uy * vx;
    if (c == 0) return;
    Drawn drawn{polygon.pick,
                {},
                v[p].x * width,
                v[p].y * height,
                v[p].z,
                (uz * vy - uy * vz) / c,
                (ux * vz - uz * vx) / c,
                0,
                0,
                0,
                0};
    for (const Point3& vertex : v) drawn.vertices.push_back({vertex.x * width, vertex.y * height});
    const auto [left, right] =
        std::ranges::minmax(drawn.vertices, {}, [](auto& at) { return at[0]; });
    const auto [low, high] =
        std::ranges::minmax(drawn.vertices, {}, [](auto& at) { return at[1]; });
    drawn.i_min = left[0];
    drawn.i_max = right[0];
    drawn.j_min = low[1];
    drawn.j_max = high[1];
    const bool inside = left[0] >= 0 && right[0] <= width && low[1] >= 0 && high[1] <= height;
    for (const auto& [i, j] : drawn.vertices) {
      const Real x = std::clamp<Real>(i, 0, width), y = std::clamp<Real>(j, 0, height);
      if (!inside && !drawn.covers(x, y)) continue;  // near enough: only the range of z
      z_min = std::min(z_min, drawn.depth(x, y));
      z_max = std::max(z_max, drawn.depth(x, y));
    }
    polygons.push_back(std::move(drawn));
  }
  void edges(const DrawnPolygon&) override {}
  void line(const DrawnLine&) override {}

  Real depth_error(const Drawn& polygon, Real i, Real j) const {
    const Real rise = std::abs(polygon.dz_di) * width + std::abs(polygon.dz_dj) * height;
    return kUnit * (kUnitsForRange * (z_max - z_min) + kUnitsForRise * rise +
                    kUnitsForThinness * polygon.thinness(i, j));
  }
};

struct Count {
  std::size_t covered = 0, near_edge = 0, near_depth = 0, unexplained = 0;
  std::size_t touching = 0;  ///< show a polygon that lies in one plane with another
  std::string first_unexplained;
};

/// The polygons that may be visible at one pixel, given OpenGL's precision.
class OpenPixel {
 public:
  OpenPixel(const Collector& scene, Real i, Real j) : scene_(scene), i_(i), j_(j) {
    for (const Drawn& polygon : scene.polygons) {
      if (i < polygon.i_min - kEdgeDistance || i > polygon.i_max + kEdgeDistance ||
          j < polygon.j_min - kEdgeDistance || j > polygon.j_max + kEdgeDistance) {
        continue;
      }
      if (polygon.distance_to_edge(i, j) <= kEdgeDistance) {
        perhaps_.push_back(&polygon);
      } else if (polygon.covers(i, j)) {
        surely_.push_back(&polygon);
      }
    }
  }

  enum class Answer { no, perhaps, surely };

  /// Returns whether a polygon of that identifier covers the pixel and none that surely does is
  /// nearer by more than the error of both depths; surely, if no edge of it is near. Background, if
  /// no polygon surely covers the pixel.
  Answer shows(std::int32_t id) const {
    if (id < 0) return surely_.empty() ? Answer::perhaps : Answer::no;
    const auto is_seen = [&](const Drawn* polygon) {
      return polygon->id == id && std::ranges::all_of(surely_, [&](const Drawn* other) {
               return polygon->depth(i_, j_) + scene_.depth_error(*polygon, i_, j_) +
                          scene_.depth_error(*other, i_, j_) >=
                      other->depth(i_, j_);
             });
    };
    if (std::ranges::any_of(surely_, is_seen)) return Answer::surely;
    return std::ranges::any_of(perhaps_, is_seen) ? Answer::perhaps : Answer::no;
  }

  std::string text() const {
    std::string text;
    for (const auto& [kind, list] : {std::pair{"surely", &surely_}, {"perhaps", &perhaps_}}) {
      for (const Drawn* p : *list) {
        text += fmt::format("\n  {} {}: depth {:.12g} +- {:.3g}, edge {:.3g} pixels away", kind,
                            p->id, static_cast<double>(p->depth(i_, j_)),
                            static_cast<double>(scene_.depth_error(*p, i_, j_)),
                            static_cast<double>(p->distance_to_edge(i_, j_)));
      }
    }
    return text;
  }

 private:
  const Collector& scene_;
  Real i_, j_;
  std::vector<const Drawn*> surely_, perhaps_;
};

/// Compares our picture of a display file with OpenGL's of one that should look the same.
Count compare(const DisplayFile& file, const DisplayFile& drawn_by_opengl, int width, int height) {
  const RasterRequest request{.width = width,
                              .height = height,
                              .surfaces = {.method = HiddenMethod::z_buffer},
                              .ids = true};
  const Picture ours = draw_with_software(file, request);
  const Picture theirs = draw_with_osmesa(drawn_by_opengl, request);
  Collector scene(width, height);
  interpret(file, scene, Pass::fills);
  const ViewedScene viewed(file);
  std::set<std::int32_t> touching;
  for (ViewedScene::Fill fill = ViewedScene::kBackground + 1; fill < viewed.end(); ++fill) {
    if (viewed.shared_plane(viewed.item_of(fill)) != nullptr) touching.insert(viewed.pick(fill));
  }
  Count count;
  for (int row = 0; row < height; ++row) {
    for (int i = 0; i < width; ++i) {
      const auto k = static_cast<std::size_t>(row * width + i);
      count.covered += ours.ids[k] >= 0;
      count.touching += touching.contains(ours.ids[k]) ? 1 : 0;
      if (ours.ids[k] == theirs.ids[k]) continue;
      using enum OpenPixel::Answer;
      const OpenPixel pixel(scene, i + 0.5L, height - 1 - row + 0.5L);
      const auto our_answer = pixel.shows(ours.ids[k]), their_answer = pixel.shows(theirs.ids[k]);
      if (our_answer == no || their_answer == no) {
        if (count.unexplained++ > 0) continue;
        count.first_unexplained =
            fmt::format("pixel ({}, {}), {}x{}: ours {}, OSMesa's {}{}", i, row, width, height,
                        ours.ids[k], theirs.ids[k], pixel.text());
      } else if (our_answer == surely && their_answer == surely) {
        ++count.near_depth;
      } else {
        ++count.near_edge;
      }
    }
  }
  return count;
}

/// near_depth is the share of the covered pixels that may differ for nearness in depth, besides
/// those where OpenGL's rounding decides between polygons in one plane.
void expect_agreement(const std::string& name, const DisplayFile& file, double near_depth = 0.01) {
  SCOPED_TRACE(name);
  for (const auto& [width, height] : {std::pair{512, 512}, {333, 251}}) {
    const Count count = compare(file, file, width, height);
    fmt::print(
        "{:34} {:3}x{:3}: {:6} covered, {:4} differ near an edge, {:4} near in depth, {} "
        "unexplained\n",
        name, width, height, count.covered, count.near_edge, count.near_depth, count.unexplained);
    EXPECT_EQ(count.unexplained, 0u) << count.first_unexplained;
    EXPECT_LE(count.near_edge, 8 + count.covered / 100);
    EXPECT_LE(
        static_cast<double>(count.near_depth),
        8 + near_depth * static_cast<double>(count.covered) + static_cast<double>(count.touching));
  }
}

// Meshes to draw, each within a ball of radius 1.4 about the origin or nearly so.

using Surface = void (*)(GraphicsSystem&);

template <class Point>
void grid_of_quads(GraphicsSystem& system, int columns, int rows, Point&& point) {
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const std::array<Point3, 4> corners = {point(i, j), point((i + 1) % columns, j),
                                             point((i + 1) % columns, j + 1), point(i, j + 1)};
      if (corners[0] == corners[1]) {
        system.polygon_abs_3({corners[1], corners[2], corners[3]});
      } else if (corners[2] == corners[3]) {
        system.polygon_abs_3({corners[0], corners[1], corners[2]});
      } else {
        system.polygon_abs_3(corners);
      }
    }
  }
}

constexpr double kTurn = 6.283185307179586;

void sphere(GraphicsSystem& system) {
  constexpr int columns = 180, rows = 90;
  grid_of_quads(system, columns, rows, [](int i, int j) {
    const double around = kTurn * i / columns, up = kTurn * (j - rows / 2) / (2 * rows);
    if (j == 0 || j == rows) return Point3(0, j == 0 ? -1 : 1, 0);
    return Point3(std::cos(around) * std::cos(up), std::sin(up), std::sin(around) * std::cos(up));
  });
}

void torus(GraphicsSystem& system) {
  constexpr int columns = 200, rows = 100;
  grid_of_quads(system, columns, rows, [](int i, int j) {
    const double around = kTurn * i / columns, tube = kTurn * (j % rows) / rows;
    const double radius = 0.9 + 0.4 * std::cos(tube);
    return Point3(radius * std::cos(around), 0.4 * std::sin(tube), radius * std::sin(around));
  });
}

void terrain(GraphicsSystem& system) {
  constexpr int n = 150;
  const auto point = [](int i, int j) {
    const double x = 2.0 * i / n - 1, z = 2.0 * j / n - 1;
    return Point3(x, 0.2 * std::sin(9 * x + 2 * z) * std::cos(7 * z) + 0.03 * std::sin(60 * x * z),
                  z);
  };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      system.polygon_abs_3({point(i, j), point(i + 1, j), point(i + 1, j + 1)});
      system.polygon_abs_3({point(i, j), point(i + 1, j + 1), point(i, j + 1)});
    }
  }
}

void soup(GraphicsSystem& system) {
  std::mt19937 random(7);
  const auto coordinate = [&] { return 2.0 * static_cast<double>(random()) / 4294967295.0 - 1.0; };
  const auto point = [&] {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    return Point3(x, y, z);
  };
  for (int k = 0; k < 2000; ++k) {
    const Point3 a = point(), b = point(), c = point();
    system.polygon_abs_3({a, b, c});
  }
}

void needles(GraphicsSystem& system) {
  std::mt19937 random(8);
  const auto coordinate = [&] { return 2.0 * static_cast<double>(random()) / 4294967295.0 - 1.0; };
  for (int k = 0; k < 5000; ++k) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    const Point3 a(x, y, z), b(-y, z, x);
    const double thin = 0.02 * coordinate();
    system.polygon_abs_3({a, b, b + Point3(thin, -thin, 0.5 * thin)});
  }
}

/// Concave and self-crossing polygons of many sides, tilted through each other.
void stars(GraphicsSystem& system) {
  for (int k = 0; k < 60; ++k) {
    const int rays = 5 + 2 * (k % 4), step = k % 3 == 0 ? 1 : 2;
    const double tilt = kTurn * k / 127;
    const Point3 u(std::cos(tilt), 0.3 * std::sin(3 * tilt), std::sin(tilt)), v(-0.2, 1, 0.1);
    std::vector<Point3> corners;
    for (int i = 0; i < rays; ++i) {
      const double angle = kTurn * i * step / rays;
      const double radius = step == 1 && i % 2 == 1 ? 0.3 : 1.0;
      corners.push_back(u * (radius * std::cos(angle)) + v * (radius * std::sin(angle)));
    }
    system.polygon_abs_3(corners);
  }
}

constexpr std::array<std::pair<const char*, Surface>, 6> kMeshes = {{{"sphere", sphere},
                                                                     {"torus", torus},
                                                                     {"terrain", terrain},
                                                                     {"soup", soup},
                                                                     {"needles", needles},
                                                                     {"stars", stars}}};

struct Direction {
  const char* name;
  Point3 into_scene;
  bool perspective;
};
const std::array kDirections = {
    Direction{"parallel, front", {0, 0, -1}, false},
    Direction{"parallel, corner", {-1, -2, -3}, false},
    Direction{"parallel, grazing", {1, -0.1, -0.2}, false},
    Direction{"perspective, front", {0, 0.01, -1}, true},
    Direction{"perspective, corner", {-3, -2, 1}, true},
    Direction{"perspective, above", {0.1, -1, 0.05}, true},
};

GraphicsSystem drawn(Surface surface, const Direction& direction) {
  GraphicsSystem system;
  system.set_view_plane_normal(direction.into_scene);
  if (direction.perspective) {
    system.set_perspective(unit(direction.into_scene) * -3.0);
  } else {
    system.set_parallel(direction.into_scene);
  }
  system.set_view_depth(-1.6, 1.6);
  system.set_window(-1.25, 1.25, -1.25, 1.25);
  LineStyle none;
  none.kind = LineStyle::Kind::none;
  system.set_line_style(none);
  system.open_segment(1);
  surface(system);
  system.close_segment();
  return system;
}

class ItemBuffer : public testing::Test {
 protected:
  void SetUp() override {
    if (!osmesa_available()) GTEST_SKIP() << osmesa_description();
  }
};

TEST_F(ItemBuffer, OpenGlsDepthErrorIsWithinTheStatedBound) {
  if (test::kSlower > 1) GTEST_SKIP() << "OpenGL is not ours to look into";
  Real worst = 0;
  for (const auto& [name, surface] : kMeshes) {
    for (const Direction& direction : kDirections) {
      constexpr int size = 400;
      const GraphicsSystem system = drawn(surface, direction);
      const Picture picture =
          draw_with_osmesa(system.display_file(), {.width = size,
                                                   .height = size,
                                                   .surfaces = {.method = HiddenMethod::z_buffer},
                                                   .ids = true,
                                                   .depth = true});
      Collector scene(size, size);
      interpret(system.display_file(), scene, Pass::fills);
      std::map<std::int32_t, const Drawn*> by_id;
      for (const Drawn& polygon : scene.polygons) {
        const auto [place, is_new] = by_id.try_emplace(polygon.id, &polygon);
        if (!is_new) place->second = nullptr;  // in several parts
      }
      Real here = 0;
      for (std::size_t k = 0; k < picture.ids.size(); ++k) {
        if (picture.ids[k] < 0 || by_id.at(picture.ids[k]) == nullptr) continue;
        const Drawn& polygon = *by_id.at(picture.ids[k]);
        const auto i = static_cast<Real>(k % size), row = static_cast<Real>(k / size);
        const Real x = i + 0.5L, y = size - 0.5L - row;
        here = std::max(here, std::abs(polygon.depth(x, y) - picture.depth[k]) /
                                  scene.depth_error(polygon, x, y));
      }
      fmt::print("{:34} depth error {:.2f} of the bound\n",
                 fmt::format("{}, {}", name, direction.name), static_cast<double>(here));
      worst = std::max(worst, here);
    }
  }
  EXPECT_LE(worst, 1.0L);
  EXPECT_GE(worst, 0.5L) << "the bound is not tight";
}

TEST_F(ItemBuffer, OfMeshesAgreesWithOpenGl) {
  if (test::kSlower > 1) GTEST_SKIP() << "OpenGL is not ours to look into";
  for (const auto& [name, surface] : kMeshes) {
    for (const Direction& direction : kDirections) {
      expect_agreement(fmt::format("{}, {}", name, direction.name),
                       drawn(surface, direction).display_file());
    }
  }
}

TEST_F(ItemBuffer, ASmallDisplacementWouldBeNoticed) {
  const GraphicsSystem system = drawn(sphere, kDirections[1]);
  DisplayFile aside = system.display_file(), nearer = system.display_file();
  aside.segment(1).image.translation = {0.03 / 512, 0.0};  // 0.03 of a pixel
  EXPECT_GT(compare(system.display_file(), aside, 512, 512).unexplained, 10u);

  // Two planes that cross, one of them then moved nearer by 4e-6 of the range of z.
  const auto crossing = [](double z) {
    DisplayFile file;
    Segment& segment = file.create(1);
    const std::vector<std::uint8_t> all(4, 1);
    segment.set_style(FillStyle{});
    segment.set_pick(1);
    segment.enter_polygon({{{0, 0, 0}, {1, 0, 1}, {1, 1, 1}, {0, 1, 0}}}, all);
    segment.set_pick(2);
    segment.enter_polygon(
        {{{0, 0, 0.1 + z}, {1, 0, 0.999 + z}, {1, 1, 0.9 + z}, {0, 1, 0.001 + z}}}, all);
    return file;
  };
  EXPECT_EQ(compare(crossing(0), crossing(0), 512, 512).unexplained, 0u);
  EXPECT_GT(compare(crossing(0), crossing(4e-6), 512, 512).unexplained, 0u);
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder,
                                            const std::string& extension) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == extension) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

TEST_F(ItemBuffer, OfEveryDrawingProgramAgreesWithOpenGl) {
  const auto programs =
      files_in(std::filesystem::path(DISPLAYFILE_SOURCE_DIR) / "programs", ".draw");
  EXPECT_FALSE(programs.empty());
  for (const auto& path : programs) {
    GraphicsSystem system;
    replay_file(path.string(), system);
    SortedDisplayFile drawn;  // of a line drawing the fills that hide
    const bool is_lines = finds_lines(system.hidden_surfaces().method);
    expect_agreement(
        path.filename().string(),
        is_lines ? drawn.update(system, HiddenMethod::z_buffer, {.method = HiddenMethod::z_buffer})
                 : system.display_file());
  }
}

/// The models in the folder that DISPLAYFILE_MODELS names, or else some of the Debian package
/// assimp-testmodels.
TEST_F(ItemBuffer, OfModelsAgreesWithOpenGl) {
  const char* named = std::getenv("DISPLAYFILE_MODELS");
  const std::filesystem::path folder = named != nullptr ? named : "/usr/share/assimp/models/OBJ";
  const auto models = files_in(folder, ".obj");
  if (models.empty()) GTEST_SKIP() << "no models in " << folder;
  std::size_t drawn = 0;
  for (const auto& path : models) {
    if (std::filesystem::file_size(path) > 20'000'000) continue;
    GraphicsSystem system;
    try {
      import_mesh(path.string(), system);
    } catch (const Error&) {
      continue;  // some are wrong on purpose
    }
    const std::string name = path.filename().string();
    const bool every_face_twice = name == "regr_3429812.obj";
    expect_agreement(name, system.display_file(), every_face_twice ? 1.0 : 0.01);
    ++drawn;
  }
  EXPECT_GT(drawn, models.size() / 2) << "hardly a model could be read";
}

}  // namespace
}  // namespace displayfile
