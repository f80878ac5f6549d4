#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "clip/surfaces.h"
#include "displayfile/looks/style.h"
#include "displayfile/segments/display_file.h"
#include "programs/scenes/scene.h"

namespace displayfile::bench {

/// The features that a drawing of the feature scene uses; by default none of the optional ones.
struct FeatureUse {
  bool clipped_by_window = false, clipped_by_depth = false, perspective = false;
  bool cutting_planes = false;  ///< two, through the middle
  bool modelling = false, image_transformation = false, bent_polygons = false;
  LineStyle::Kind lines = LineStyle::Kind::none;
  bool colours = false;           ///< another fill style for each polygon
  bool pick_identifiers = false;  ///< set for each polygon
  bool texts = false;             ///< one in each segment
  bool back_face_removal = false, light = false, vertex_normals = false, shadows = false;
  Shading shading = Shading::gouraud;  ///< with vertex_normals
  HiddenSurfaceOptions surfaces;       ///< no method: hidden-line removal off
  bool ids = false, depth = false, svg = false, osmesa = false;
  int samples = 1;
  bool recorded = false, retained = false, selects_lines = false, world_tree = false;
};

/// A feature that can be turned on and off.
struct Feature {
  std::string_view name;
  std::string_view turned_on_by;
  std::string_view over;  ///< the feature that is on when it is off; empty: none is
  void (*turn_on)(FeatureUse&);
  /// The code that only it needs: parts of the names of functions, with their classes, or of
  /// libraries.
  std::vector<std::string_view> functions;
  std::string_view not_counted{};  ///< why its cost is not counted
};

/// One entry a feature; each comes after the one that it builds on.
const std::vector<Feature>& features();

/// The features used when this one is on: it and all that it builds on.
FeatureUse use_of(const Feature& feature);

inline constexpr std::size_t kFeaturePolygons = 1000;
inline constexpr int kFeaturePictureSize = 64;
Scene feature_scene(std::size_t polygons = kFeaturePolygons);

/// From the first routine of a new system to the picture, of which nothing is kept. `look` receives
/// the display file.
using LookAt = std::function<void(const DisplayFile& drawn)>;
void draw_with(const FeatureUse& use, const Scene& scene, const LookAt& look = nullptr);

}  // namespace displayfile::bench
