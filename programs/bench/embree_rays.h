#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hidden/exact/pixel_centre.h"
#include "programs/bench/triangles.h"

namespace displayfile::bench {

/// Embree's primary rays (Wald et al., Embree 3) in this process: parallel rays along z through
/// the pixel centres, in coherent packets of eight. Its triangles are in single precision, and
/// lie in pixels.
class EmbreeRays {
 public:
  /// Embree's version; nothing if this build has no Embree.
  static std::optional<std::string> version();

  /// Commits a scene, on so many threads.
  EmbreeRays(const Triangles& triangles, const PictureSize& size, int threads);
  ~EmbreeRays();
  EmbreeRays(const EmbreeRays&) = delete;
  EmbreeRays& operator=(const EmbreeRays&) = delete;

  /// What the rays meet, the bottom row first.
  struct Hits {
    std::vector<ViewedScene::Fill> fills;  ///< ViewedScene::kBackground where there is none
    std::vector<double> depths;            ///< minus infinity where there is none; empty: not asked
    Hits(const PictureSize& size, bool with_depths)
        : fills(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)),
          depths(with_depths ? fills.size() : 0) {}
  };
  /// Enters the hits of these rows. By several threads at a time.
  void cast(int row_begin, int row_end, Hits& hits) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace displayfile::bench
