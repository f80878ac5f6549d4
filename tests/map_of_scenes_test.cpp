// The visible-surface map of whole scenes against the definition, in rationals: generated ones, the
// gallery's, and meshes that DISPLAYFILE_MAP_MESHES names, separated by colons.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "displayfile/mesh/fitted_view.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/viewed_scene.h"
#include "programs/scenes/generated_scenes.h"
#include "tests/gallery.h"
#include "tests/map_truth.h"
#include "tests/slower.h"

namespace displayfile {
namespace {

using namespace test;

/// Checks at most about `most_edges` edges.
void expect_true_map(const DisplayFile& file, std::size_t most_edges, const std::string& name) {
  const ViewedScene scene(file);
  const Primitives items = scene.primitives();
  const VisibleMap map = visible_map(items, {});
  const std::size_t looked_at = std::max(map.edges.size(), scene.items() * std::size_t{2});
  const std::size_t every = 1 + looked_at / (most_edges / kSlower);
  std::vector<Point2> places;
  for (int k = 1; k < 8; ++k) places.emplace_back(0.127 * k, 1.0 - 0.119 * k);
  EXPECT_EQ(wrong_in_map(items, map, places, every), "") << name;
}

TEST(MapOfScenes, GeneratedOnesAgainstTheTruth) {
  struct Generated {
    const char* name;
    std::size_t polygons;
  };
  const Generated scenes[] = {{"city", 120},  {"village", 300}, {"terrain", 400}, {"soup", 60},
                              {"planes", 12}, {"cycles", 80},   {"needles", 60}};
  for (const auto& [name, polygons] : scenes) {
    for (const std::uint32_t seed : {1u, 2u}) {
      GraphicsSystem system;
      enter(generated_scene(name).make(polygons, seed), system);
      expect_true_map(system.display_file(), 1000, name);
    }
  }
}

TEST(MapOfScenes, TheGallerysAgainstTheTruth) {
  for_each_in_gallery([](const std::string& name, const Retained& retained) {
    expect_true_map(retained.system.display_file(), 1000, name);
  });
}

TEST(MapOfScenes, MeshesAgainstTheTruth) {
  const char* const set = std::getenv("DISPLAYFILE_MAP_MESHES");
  std::istringstream names(set == nullptr ? "/usr/share/assimp/models/OBJ/spider.obj" : set);
  for (std::string name; std::getline(names, name, ':');) {
    const Mesh mesh = read_mesh(name);
    GraphicsSystem system;
    fit_view(std::span(&mesh, 1), system);
    enter_mesh(mesh, system, 1);
    expect_true_map(system.display_file(), 1000, name);
  }
}

}  // namespace
}  // namespace displayfile
