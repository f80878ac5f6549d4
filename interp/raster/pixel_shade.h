#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>

#include "displayfile/entered/normal_plane.h"
#include "hidden/exact/pixel_centre.h"
#include "hidden/exact/support_plane.h"
#include "interp/device/output_device.h"
#include "interp/device/picture.h"
#include "interp/raster/phong_shade.h"
#include "interp/raster/shadows.h"

namespace displayfile {

/// A shaded fill's colour over pixel coordinates: the intensity changes by a constant per column
/// and per row, as depth does (interp/scan/pixel_depth.h). A pixel's intensity is always the same
/// expression of its centre, wherever a run begins: every caller gets the same colour.
class PixelShade {
 public:
  PixelShade(const Colour& colour, const IntensityPlane& plane, const PictureSize& size)
      : colour_(colour),
        plane_(plane),
        x0_(plane.x0 * size.width),
        y0_(plane.y0 * size.height),
        di_dx_(plane.di_dx / size.width),
        di_dy_(plane.di_dy / size.height) {}

  /// Paints the columns first, first + 1, ... of a row, as in Picture::pixels.
  void paint(int row, int first, std::span<std::uint32_t> pixels) const {
    const double of_row = plane_.i0 + di_dy_ * (row + 0.5 - y0_);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const double column = first + static_cast<int>(i) + 0.5 - x0_;
      pixels[i] = pixel_of(colour_ * plane_.within(of_row + di_dx_ * column));
    }
  }
  std::uint32_t at(int row, int column) const {
    std::uint32_t pixel = 0;
    paint(row, column, {&pixel, 1});
    return pixel;
  }

 private:
  Colour colour_;
  IntensityPlane plane_;
  double x0_, y0_, di_dx_, di_dy_;
};

/// The colour of a fill that is lit and of full intensity. Modifications are added here, for fills
/// painted in order (FillColour) and for visible fills (FillPaints).
inline Colour painted_colour(const FillStyle& fill) { return fill.colour; }

/// The paint of a polygon: one colour, or a shade; and another colour in shadow.
class FillColour {
 public:
  /// `shadows` may be null: no shadows.
  FillColour(const DrawnPolygon& polygon, const PictureSize& size, const Shadows* shadows) {
    const Colour colour = painted_colour(polygon.fill);
    if (polygon.intensities.empty()) {
      paint_ = pixel_of(colour);
    } else if (polygon.normals.empty()) {
      paint_.emplace<PixelShade>(colour, IntensityPlane(polygon.vertices, polygon.intensities),
                                 size);
    } else {
      paint_.emplace<PhongShade>(colour, NormalPlane(polygon.vertices, polygon.normals),
                                 *polygon.light, size);
    }
    if (shadows == nullptr || !polygon.fill.shadow) return;
    const std::span<const Point3> v = polygon.vertices;
    const auto [support, edge_on] = support_vertices(v);
    if (edge_on) return;
    const Plane plane(v[support[0]], v[support[1]], v[support[2]]);
    shadow_.emplace(*shadows, Shadows::on(v, plane, size), plane, *polygon.fill.shadow, size);
  }

  /// Paints as PixelShade::paint does; at() is the pixel at one place.
  void paint(int row, int first, std::span<std::uint32_t> pixels) const {
    if (const auto* colour = std::get_if<std::uint32_t>(&paint_)) {
      std::ranges::fill(pixels, *colour);
    } else if (const auto* shade = std::get_if<PixelShade>(&paint_)) {
      shade->paint(row, first, pixels);
    } else {
      std::get_if<PhongShade>(&paint_)->paint(row, first, pixels);
    }
    if (shadow_) shadow_->paint(row, first, pixels);
  }
  std::uint32_t at(int row, int column) const {
    std::uint32_t pixel = 0;
    paint(row, column, {&pixel, 1});
    return pixel;
  }

 private:
  std::variant<std::uint32_t, PixelShade, PhongShade> paint_;  // one colour, or a shade
  std::optional<ShadowedFill> shadow_;
};

}  // namespace displayfile
