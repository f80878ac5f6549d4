#pragma once

#include <vector>

#include "interp/visibility/fill_depths.h"
#include "interp/visibility/image_space.h"
#include "interp/visibility/world_rays.h"

namespace displayfile {

/// Ray casting in object space as a method: the fill of the viewed scene visible at each pixel
/// centre is the one hit by the rays in world coordinates (interp/visibility/ray_cast.md). Rays
/// pass through everything removed by viewing.
class WorldRayCast : public ImageSpaceMethod {
 public:
  /// The world must outlive this; null: prepare throws Error.
  explicit WorldRayCast(const ViewedWorld* world) : world_(world) {}

  /// Prepares for a viewed scene of the world's display file. Throws Error with a ROUNDOFF.
  void prepare(const Request& request, int threads) override;
  void draw_rows(int row_begin, int row_end, const SeenRun& seen) const override;

 private:
  using Fill = ViewedScene::Fill;

  const ViewedWorld* world_;
  std::optional<Request> request_;
  std::vector<Fill> fill_of_;             // of the world's primitives
  std::vector<WorldRays::CastRow> rays_;  // of each view
  FillDepths depths_;                     // for distinguishing views
};

}  // namespace displayfile
