#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hidden/exact/pixel_centre.h"
#include "tests/bench/command/triangles.h"

namespace displayfile::bench {

/// Embree's primary rays (Wald et al., Embree 3) in this process: parallel rays along z through
/// the pixel centres, in coherent packets that are as wide as the processor's vectors. Its
/// triangles are in single precision, and lie in pixels.
class EmbreeRays {
 public:
  /// The quality of the tree: "moderate" and "high" are Embree's own (RTC_BUILD_QUALITY_MEDIUM,
  /// RTC_BUILD_QUALITY_HIGH). A better one takes longer to build, and less time for each ray.
  enum class Quality { moderate, high };

  /// Embree's version; nothing if this build has no Embree.
  static std::optional<std::string> version();
  /// The number of rays of a packet that the processor casts at a time: 4, 8 or 16.
  static int packet_width();

  /// Embree's input, in its own form.
  struct Input {
    Input(const Triangles& triangles, const PictureSize& of_picture);
    PictureSize size;
    std::vector<float> corners;            ///< x, y and z of three a triangle
    std::vector<ViewedScene::Fill> fills;  ///< of the triangles
    double depth_scale = 1.0;  ///< a power of two: Embree has no coordinates beyond 1.8e18
    float origin = 0.0F;       ///< z of the rays', before all triangles
  };

  /// Commits a scene of an input, which must outlive this, on `threads` threads, by a device made
  /// before, which is shared by scenes of as many threads.
  EmbreeRays(const Input& input, int threads, Quality quality = Quality::moderate);
  ~EmbreeRays();
  EmbreeRays(const EmbreeRays&) = delete;
  EmbreeRays& operator=(const EmbreeRays&) = delete;

  /// The hits of the rays, the bottom row first.
  struct Hits {
    std::vector<ViewedScene::Fill> fills;  ///< ViewedScene::kBackground where there is none
    std::vector<double> depths;  ///< minus infinity where there is none; empty: not requested
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
