#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "displayfile/segments/viewed_scene.h"
#include "hidden/exact/depth_comparison.h"
#include "hidden/exact/entered_outline.h"
#include "hidden/exact/pixel_centre.h"
#include "interp/visibility/fill_depths.h"

namespace displayfile {

/// The projections of a scene's items into the picture, each created on first use.
class ProjectionsAsEntered {
 public:
  EnteredProjection& of(const ViewedScene::EnteredItem& item, std::uint32_t look) {
    return views_.try_emplace(look, *item.volume, *item.image).first->second;
  }
  void forget() { views_.clear(); }

 private:
  std::unordered_map<std::uint32_t, EnteredProjection> views_;  // by look
};

/// Compares the depths of two fills by their planes as entered, where viewing's rounding may decide
/// (interp/visibility/fills_as_entered.md). For one thread.
class DepthsAsEntered {
 public:
  using Fill = ViewedScene::Fill;

  explicit DepthsAsEntered(const ViewedScene& scene) : scene_(&scene) {}
  /// Replaces the scene.
  void take(const ViewedScene& scene) {
    scene_ = &scene;
    views_.forget();
    depths_.clear();
    planes_.clear();
  }

  /// True if the depths of two fills that share no plane are so close at a centre that viewing may
  /// decide which is nearer.
  bool are_close(Fill one, Fill other, const PixelCentre& centre);
  /// The comparison of their planes as entered; none if one is not known.
  std::optional<DepthComparison> comparison(Fill one, Fill other);

 private:
  /// A fill's depth, and its change over the picture.
  struct Depth {
    FillDepth rounded;
    double slopes = 0.0;
  };
  Depth& depth_of(Fill fill, const PictureSize& size);
  const PlaneInPicture* plane_of(Fill fill);

  const ViewedScene* scene_;
  ProjectionsAsEntered views_;
  PictureSize size_{0, 0};  // of the depths
  std::unordered_map<Fill, Depth> depths_;
  std::unordered_map<Fill, std::optional<PlaneInPicture>> planes_;
};

}  // namespace displayfile
