#pragma once

#include <cstdint>
#include <vector>

#include "interp/scan/scan_edge.h"
#include "interp/visibility/fill_depths.h"
#include "interp/visibility/image_space.h"
#include "interp/visibility/pixel_tree.h"

namespace displayfile {

/// Ray casting in image space: after the transform the eye is infinitely far away, and a ray runs
/// along z through each pixel's centre to the nearest fill that it hits. Rays are cast in packets
/// through a hierarchy of boxes, and hits are decided exactly (interp/visibility/ray_cast.md). With
/// a ROUNDOFF a ray sees the fill entered last of those within ROUNDOFF of the nearest.
class RayCast : public ImageSpaceMethod {
 public:
  void prepare(const Request& request, int threads) override;
  void draw_rows(int row_begin, int row_end, const SeenRun& seen) const override;
  /// The rows of a packet.
  int rows_at_a_time() const override { return 8; }

  /// The fill visible to one ray: through the centre of a pixel, the row counted from the bottom.
  ViewedScene::Fill seen_at(int column, int row) const;

 private:
  /// A fill that may cover a centre.
  struct Target {
    ViewedScene::Fill fill;
    std::uint32_t first_edge, end_edge;  ///< with few sides: the place of its sides in edges_
    std::uint32_t many_sided;            ///< with many: its number among those; otherwise kFewSided
    PixelBox pixels;
  };
  static constexpr std::uint32_t kFewSided = ~std::uint32_t{0};
  class Caster;

  void find_targets(int threads);
  void enter_edges(Target& target);

  std::optional<Request> request_;
  FillDepths depths_;
  std::vector<Target> targets_;
  std::vector<ScanEdge> edges_;
  std::uint32_t many_sided_ = 0;
  PixelTree tree_;
};

}  // namespace displayfile
