#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interp/fill_scene.h"

namespace displayfile::bench {

/// Embree's primary rays (Wald et al., Embree 3) in this process: parallel rays along z through
/// the pixel centres, in coherent packets of eight. Its triangles are in single precision, and
/// lie in pixels.
class EmbreeRays {
 public:
  /// Embree's version; nothing if this build has no Embree.
  static std::optional<std::string> version();

  /// Commits a scene whose fills are all triangles, on so many threads.
  EmbreeRays(const FillScene& triangles, int width, int height, int threads);
  ~EmbreeRays();
  EmbreeRays(const EmbreeRays&) = delete;
  EmbreeRays& operator=(const EmbreeRays&) = delete;

  /// Enters what the rays of these rows see, as draw_rows() tells it. By several threads at a
  /// time.
  void cast(int row_begin, int row_end, std::vector<FillScene::Fill>& seen) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace displayfile::bench
