#pragma once

#include <cstdint>
#include <vector>

#include "clip/view.h"
#include "displayfile/graphics_system.h"
#include "programs/bench/bench_scene.h"
#include "programs/bench/triangles.h"

namespace displayfile::bench {

/// A scene as an application has it before any library knows of it, and views of it: what both
/// sides of a comparison get.
struct ApplicationMesh {
  std::vector<Point3> vertices;               ///< world coordinates
  std::vector<std::uint32_t> corners, sides;  ///< as of GraphicsSystem::polygons_abs_3
  std::vector<FillStyle>
      fills;  ///< of each polygon: its colour in the scene's light, if it has one
  bool back_faces_removed = false;
  std::vector<View> views;  ///< evenly around the scene's middle, the first that of the scene

  static constexpr int kViews = 8;
};

/// Throws CannotDraw, with the reason, for a scene that is not polygons of one colour each in one
/// view: lines, texts, image transformations, back faces some of which are removed.
ApplicationMesh application_mesh(const BenchScene& scene);

/// Enters it as segment 1, in the place of one that is there.
void enter(const ApplicationMesh& mesh, GraphicsSystem& system);

/// In world coordinates; a colour each, as in Picture::pixels.
struct ColouredTriangles {
  std::vector<Point3> corners;
  std::vector<std::uint32_t> colours;
};
ColouredTriangles triangles_of(const ApplicationMesh& mesh);

}  // namespace displayfile::bench
