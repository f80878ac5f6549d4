#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "displayfile/graphics_system.h"
#include "displayfile/segments/display_file.h"
#include "programs/scenes/scene.h"
#include "tests/bench/command/report.h"

namespace displayfile::bench {

/// A scene to measure, at one number of polygons and one size of picture.
struct BenchScene {
  enum class Kind { generated, surface, walk, hard_case, input };
  Kind kind;
  std::string name;   ///< of the generator; of an input, its path
  std::size_t n = 0;  ///< requested number of polygons of a generator, or of the city of the walk
  double severity = 0.0;            ///< of a hard case
  bool gap = false;                 ///< the severity s is a gap of 10^-s
  int size = 0;                     ///< pixels a side
  std::uint64_t seed = kUsualSeed;  ///< of generated scenes and hard cases

  static constexpr std::uint64_t kUsualSeed = 1;

  /// All of these in words, different for different scenes.
  std::string id() const;
  std::string id_but_size() const;  ///< all but the picture's size
  std::size_t pixels() const;       ///< of all views
  /// Enters it into a new system, of a walk its first view. Throws Error for an input that cannot
  /// be read.
  void enter(GraphicsSystem& system) const;
  /// Hidden surfaces are not sorted, whatever a drawing program sets. Throws Error as enter.
  DisplayFile make() const;
};

/// Which scenes are measured.
struct SceneChoice {
  std::vector<std::string>
      names;  ///< none: "default", all generated scenes, the surface, the walk and all hard cases
  std::vector<std::size_t> polygons;            ///< of generated scenes; none: the usual ones
  std::vector<int> sizes;                       ///< none: the usual ones
  std::uint64_t seed = BenchScene::kUsualSeed;  ///< of all that are generated
  bool full = false;
};

/// True if those are among them that are measured when none is named.
bool has_default(const SceneChoice& choice);

/// The scenes, grouped by name, in each group the smallest first. Throws Error for a name that is
/// neither a scene's nor a file's.
std::vector<BenchScene> chosen_scenes(const SceneChoice& choice);

std::vector<std::string> scene_names();  ///< that chosen_scenes knows

/// A generated scene; besides those of programs/scenes/generated_scenes.h `stack`: parallel sheets,
/// each most of the picture, in random order.
Scene generated(const std::string& name, std::size_t n, std::uint64_t seed);

/// How a scene covers its picture, averages: how many polygons cover a pixel that any covers
/// (`deep`), how many pixels of a row a polygon covers (`wide`), and how many others a polygon's
/// extents overlap, by a sample (`overlapped`).
Json cover(const BenchScene& scene, const DisplayFile& file);

std::string_view name_of(BenchScene::Kind kind);

}  // namespace displayfile::bench
