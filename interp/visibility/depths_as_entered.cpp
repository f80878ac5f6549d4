#include "interp/visibility/depths_as_entered.h"

#include <cmath>

namespace displayfile {

DepthsAsEntered::Depth& DepthsAsEntered::depth_of(Fill fill, const PictureSize& size) {
  if (size != size_) {
    depths_.clear();
    size_ = size;
  }
  const auto [at, is_new] = depths_.try_emplace(fill);
  Depth& depth = at->second;
  if (is_new) {
    depth.rounded = FillDepth(*scene_, fill, size, std::nullopt);
    const PixelDepth& d = depth.rounded.depth;
    depth.slopes = std::abs(d.dz_dx) * size.width + std::abs(d.dz_dy) * size.height;
  }
  return depth;
}

/// Null if unknown. Where the shared plane is edge-on, the fill has its own.
const PlaneInPicture* DepthsAsEntered::plane_of(Fill fill) {
  const auto [at, is_new] = planes_.try_emplace(fill);
  std::optional<PlaneInPicture>& plane = at->second;
  if (is_new) {
    const ViewedScene::Item number = scene_->item_of(fill);
    const auto find = [&](const ViewedScene::EnteredItem& item) {
      if (plane || !item.is_known()) return;
      plane = views_.of(item, scene_->look_of(number)).plane(item.polygon);
      if (plane && plane->is_edge_on()) plane.reset();
    };
    find(scene_->plane_as_entered(number));
    find(scene_->as_entered(number));
  }
  return plane ? &*plane : nullptr;
}

bool DepthsAsEntered::are_close(Fill one, Fill other, const PixelCentre& centre) {
  constexpr double kOfSlopes = 8.0;
  const Depth &a = depth_of(one, centre.size), &b = depth_of(other, centre.size);
  const auto at = [&](const Depth& d) {
    return d.rounded.depth.at(d.rounded.depth.row(centre.row), centre.column);
  };
  const double viewing = kOfSlopes * scene_->plane_radius() * (2.0 + a.slopes + b.slopes);
  return rounded_order(at(a) - at(b), a.rounded.error + b.rounded.error + viewing) == 0;
}

std::optional<DepthComparison> DepthsAsEntered::comparison(Fill one, Fill other) {
  const PlaneInPicture *const p = plane_of(one), *const q = plane_of(other);
  if (p == nullptr || q == nullptr) return std::nullopt;
  return DepthComparison(*p, *q);
}

}  // namespace displayfile
