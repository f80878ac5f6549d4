#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "displayfile/intensity_plane.h"
#include "displayfile/viewed_scene.h"
#include "interp/picture.h"

namespace displayfile {

/// What the fills of a scene are painted with, for a device of pixels.
class FillPaints {
 public:
  using Fill = ViewedScene::Fill;

  FillPaints() = default;
  explicit FillPaints(const ViewedScene& scene) { take(scene); }
  /// Takes those of a scene, in place of those before.
  void take(const ViewedScene& scene);
  /// As in Picture::pixels; white until then.
  void set_background(std::uint32_t pixel) { pixel_[ViewedScene::kBackground] = pixel; }

  std::uint32_t pixel(Fill fill) const { return pixel_[fill]; }  ///< as in Picture::pixels
  /// The same of all fills, by number.
  const std::uint32_t* pixels() const { return pixel_.data(); }
  /// A fill whose colour is not the same everywhere, but multiplied by an intensity.
  struct Shade {
    Colour colour;
    IntensityPlane intensity;
  };
  bool has_shades() const { return !shades_.empty(); }
  /// Null if it is flat.
  const Shade* shade(Fill fill) const {
    return fill >= shade_.size() || shade_[fill] == kNone ? nullptr : &shades_[shade_[fill]];
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  void take_palette(const ViewedScene& scene);

  std::vector<std::uint32_t> pixel_{0xFFFFFFFF};  // the background's first
  std::uint64_t palette_ = 0;                     // that palette_pixel_ is of
  std::vector<std::uint32_t> palette_pixel_;
  std::vector<std::uint32_t> shade_;  // of the fills up to the last that has one: in shades_
  std::vector<Shade> shades_;
};

}  // namespace displayfile
