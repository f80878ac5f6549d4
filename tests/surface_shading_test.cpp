// Smooth shading of surfaces over grids: their points have the normals of a mesh of the same
// triangles, for any crease angle, with holes, and under modelling transformations.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/display_file.h"

namespace displayfile {
namespace {

constexpr int kColumns = 6, kRows = 5;
using Model = void (*)(GraphicsSystem&);

void start(GraphicsSystem& g, double crease, Model model, Shading shading = Shading::gouraud) {
  g.set_light({1.0, 2.0, 3.0}, 0.1);
  g.set_fill_style({FillStyle::Kind::solid, {1.0, 1.0, 1.0}});
  g.set_line_style({LineStyle::Kind::none});
  g.set_window(-4.0, 4.0, -4.0, 4.0);
  g.set_shading(shading);
  g.set_crease_angle(crease);
  model(g);
  g.open_segment(1);
}

SurfaceGrid grid_of(const std::vector<double>& heights) {
  return {-1.0, 1.5, kColumns, -0.5, 2.0, kRows, heights};
}

/// The intensities of the triangles' vertices, in order of entry; the colour of evenly lit ones.
std::vector<double> lit_vertices(GraphicsSystem& g) {
  g.close_segment();
  std::istringstream dumped(dump(g.display_file()));
  std::vector<double> all;
  double even = 0.0;
  std::vector<double> next;
  for (std::string line; std::getline(dumped, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "fill") words >> word >> even;
    if (word == "intensities") {
      for (double value; words >> value;) next.push_back(value);
    }
    if (word != "polygon") continue;
    if (next.empty()) next.assign(3, even);
    all.insert(all.end(), next.begin(), next.end());
    next.clear();
  }
  return all;
}

std::vector<double> of_surface(const std::vector<double>& heights, double crease, Model model) {
  GraphicsSystem g;
  start(g, crease, model);
  g.surface_3(grid_of(heights));
  return lit_vertices(g);
}

/// A mesh of the cells' triangles a b c and a c d.
Mesh mesh_of(const SurfaceGrid& grid) {
  Mesh mesh;
  for (int j = 0; j < kRows; ++j) {
    for (int i = 0; i < kColumns; ++i) {
      const double z = grid.heights[static_cast<std::size_t>(j * kColumns + i)];
      mesh.vertices.emplace_back(grid.x(i), grid.y(j), std::isnan(z) ? 0.0 : z);
    }
  }
  for (int j = 0; j + 1 < kRows; ++j) {
    for (int i = 0; i + 1 < kColumns; ++i) {
      if (!grid.has_cell(i, j)) continue;
      const auto a = static_cast<std::uint32_t>(j * kColumns + i);
      const std::uint32_t b = a + 1, c = a + kColumns + 1, d = a + kColumns;
      for (const std::uint32_t corner : {a, b, c, a, c, d}) mesh.corners.push_back(corner);
    }
  }
  for (std::size_t k = 0; k <= mesh.corners.size(); k += 3) mesh.first_corner.push_back(k);
  mesh.objects.push_back({"", 0, mesh.faces()});
  return mesh;
}

std::vector<double> of_mesh(const std::vector<double>& heights, double crease, Model model) {
  GraphicsSystem g;
  start(g, crease, model);
  Mesh mesh = mesh_of(grid_of(heights));
  complete_normals(mesh, crease);
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    std::array<Point3, 3> points, normals;
    for (std::size_t k = 0; k < 3; ++k) {
      points[k] = mesh.vertices[mesh.face(i)[k]];
      normals[k] = mesh.normal(3 * i + k);
    }
    g.set_vertex_normals(normals);
    g.polygon_abs_3(points);
  }
  return lit_vertices(g);
}

std::vector<double> random_heights(std::uint32_t seed, bool with_holes) {
  std::mt19937 random(seed);
  std::vector<double> heights;
  for (int k = 0; k < kColumns * kRows; ++k) {
    const double z = static_cast<double>(random() % 1000) / 1000.0;
    const bool is_hole = with_holes && random() % 7 == 0;
    heights.push_back(is_hole ? std::numeric_limits<double>::quiet_NaN() : z);
  }
  return heights;
}

void expect_near(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-9) << "vertex " << k;
}

constexpr double kCreases[] = {180.0, 150.0, 120.0, 90.0, 45.0, 20.0, 5.0, 0.0};

TEST(SurfaceShading, HasTheNormalsOfAMeshOfTheSameTriangles) {
  for (const double crease : kCreases) {
    for (std::uint32_t seed = 1; seed <= 8; ++seed) {
      SCOPED_TRACE(testing::Message() << "crease " << crease << ", seed " << seed);
      const auto heights = random_heights(seed, false);
      const auto model = [](GraphicsSystem&) {};
      expect_near(of_surface(heights, crease, model), of_mesh(heights, crease, model));
    }
  }
}

TEST(SurfaceShading, CountsNoCellThatHolesLeaveOut) {
  for (const double crease : kCreases) {
    for (std::uint32_t seed = 1; seed <= 8; ++seed) {
      SCOPED_TRACE(testing::Message() << "crease " << crease << ", seed " << seed);
      const auto heights = random_heights(seed, true);
      const auto model = [](GraphicsSystem&) {};
      expect_near(of_surface(heights, crease, model), of_mesh(heights, crease, model));
    }
  }
}

TEST(SurfaceShading, FollowsTheModellingTransformation) {
  const auto turn = [](GraphicsSystem& g) {
    g.rotate_x_3(30.0);
    g.rotate_y_3(-20.0);
    g.scale_3(1.0, 0.5, 2.0);
  };
  for (const double crease : kCreases) {
    const auto heights = random_heights(3, true);
    expect_near(of_surface(heights, crease, turn), of_mesh(heights, crease, turn));
  }
}

/// The light of a mirrored surface is that of the surface, mirrored. Triangles are entered in
/// another order, with their vertices in another.
TEST(SurfaceShading, IsMirroredWithTheSurface) {
  const auto heights = random_heights(5, true);
  for (const double crease : kCreases) {
    const auto sum_of = [&](bool mirrored) {
      GraphicsSystem g;
      start(g, crease, [](GraphicsSystem&) {});
      g.set_light({mirrored ? -1.0 : 1.0, 2.0, 3.0}, 0.1);
      if (mirrored) g.scale_3(-1.0, 1.0, 1.0);
      g.surface_3(grid_of(heights));
      double sum = 0.0;
      for (const double value : lit_vertices(g)) sum += value * value;
      return sum;
    };
    EXPECT_NEAR(sum_of(true), sum_of(false), 1e-9);
  }
}

TEST(SurfaceShading, IsTheSameInARetainedScene) {
  const auto heights = random_heights(7, true);
  GraphicsSystem plain, retained;
  retained.retain();
  for (GraphicsSystem* g : {&plain, &retained}) {
    start(
        *g, 40.0, [](GraphicsSystem&) {}, Shading::phong);
    g->surface_3(grid_of(heights));
    g->close_segment();
  }
  EXPECT_EQ(dump(plain.display_file()), dump(retained.display_file()));
}

TEST(SurfaceShading, IsFlatUnlessItIsSet) {
  const auto heights = random_heights(2, false);
  const auto dumped = [&](bool with_light, Shading shading) {
    GraphicsSystem g;
    if (with_light) g.set_light({1.0, 2.0, 3.0}, 0.1);
    g.set_shading(shading);
    g.open_segment(1);
    g.surface_3(grid_of(heights));
    g.close_segment();
    return dump(g.display_file());
  };
  EXPECT_EQ(dumped(true, Shading::flat).find("intensities"), std::string::npos);
  EXPECT_EQ(dumped(false, Shading::gouraud), dumped(false, Shading::flat));
  EXPECT_NE(dumped(true, Shading::gouraud).find("intensities"), std::string::npos);
}

}  // namespace
}  // namespace displayfile
