#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "displayfile/entered/normal_plane.h"
#include "displayfile/looks/lighting.h"
#include "displayfile/segments/viewed_scene.h"
#include "interp/device/picture.h"

namespace displayfile {

/// The paints of a scene's fills, for a pixel device.
class FillPaints {
 public:
  using Fill = ViewedScene::Fill;

  FillPaints() = default;
  explicit FillPaints(const ViewedScene& scene) { take(scene); }
  /// Replaces the paints by those of a scene.
  void take(const ViewedScene& scene);
  /// As in Picture::pixels; white by default.
  void set_background(std::uint32_t pixel) { pixel_[ViewedScene::kBackground] = pixel; }

  std::uint32_t pixel(Fill fill) const { return pixel_[fill]; }  ///< as in Picture::pixels
  /// The pixels of all fills, by number.
  const std::uint32_t* pixels() const { return pixel_.data(); }
  /// A fill whose colour is multiplied by a varying intensity.
  struct Shade {
    Colour colour;
    IntensityPlane intensity;
  };
  /// The same with Phong shading.
  struct Phong {
    Colour colour;
    NormalPlane normal;
    Light light;
  };
  bool has_shades() const { return !shades_.all.empty() || !phongs_.all.empty(); }
  /// Null if it is flat, or has Phong shading.
  const Shade* shade(Fill fill) const { return shades_.of(fill); }
  /// Null if it is flat, or has Gouraud shading.
  const Phong* phong(Fill fill) const { return phongs_.of(fill); }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// A paint that only some fills have.
  template <class Paint>
  struct OfFills {
    std::vector<std::uint32_t> number;  // of the fills up to the last that has one: in `all`
    std::vector<Paint> all;

    const Paint* of(Fill fill) const {
      return fill >= number.size() || number[fill] == kNone ? nullptr : &all[number[fill]];
    }
    void add(Fill fill, const Paint& paint) {  ///< larger than those added before
      number.resize(fill, kNone);
      number.push_back(static_cast<std::uint32_t>(all.size()));
      all.push_back(paint);
    }
    void clear() {
      number.clear();
      all.clear();
    }
  };
  void take_palette(const ViewedScene& scene);

  std::vector<std::uint32_t> pixel_{0xFFFFFFFF};  // the background's first
  std::uint64_t palette_ = 0;                     // that palette_pixel_ is of
  std::vector<std::uint32_t> palette_pixel_;
  OfFills<Shade> shades_;
  OfFills<Phong> phongs_;
};

}  // namespace displayfile
