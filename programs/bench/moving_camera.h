#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "programs/bench/bench_scene.h"
#include "programs/bench/timing.h"

namespace displayfile::bench {

/// A retained scene with a moving camera: ApplicationMesh::kViews new views around it, by NewViews,
/// one after another.
struct MovingCamera {
  std::size_t triangles = 0;
  int views = 0;  ///< all that are drawn; each was held against the truth of its display file
  std::int64_t wrong_pixels = 0;  ///< in all of them
  // Bytes a triangle.
  double scene_bytes = 0.0;    ///< the scene as it is retained
  double view_bytes = 0.0;     ///< what viewing it keeps, after a turn of all views
  double drawing_bytes = 0.0;  ///< what drawing it keeps besides, the picture not in it
  /// How many times as fast all views are as those of the first scene, which is smaller.
  std::optional<Spread> beside_first;
  /// And as OSMesa is, of whose pictures so many pixels in a hundred are others in one view at
  /// most; nothing if there is no OSMesa.
  std::optional<Spread> beside_osmesa;
  double other_pixels = 0.0;
};

/// The scene's picture has scene.size pixels a side. The first scene is of the same name, with so
/// many polygons asked for; 0: there is none. Throws CannotDraw as application_mesh does.
MovingCamera move_camera(const BenchScene& scene, std::size_t first_polygons, int threads,
                         const Effort& effort);

}  // namespace displayfile::bench
