#pragma once

#include <cstdint>
#include <span>

#include "displayfile/entered/normal_plane.h"
#include "displayfile/looks/lighting.h"
#include "hidden/exact/pixel_centre.h"

namespace displayfile {

/// The colour over pixel coordinates of a fill with Phong shading (displayfile/looks/phong.md):
/// each pixel is lit by the normal at its centre, always by the same expression of the centre,
/// wherever a run begins: every caller gets the same colour.
class PhongShade {
 public:
  PhongShade(const Colour& colour, const NormalPlane& plane, const Light& light,
             const PictureSize& size)
      : colour_(colour),
        light_(light),
        low_(plane.low),
        high_(plane.high),
        x0_(plane.x0 * size.width),
        y0_(plane.y0 * size.height),
        n0_(plane.n0),
        dn_dx_(plane.dn_dx * (1.0 / size.width)),
        dn_dy_(plane.dn_dy * (1.0 / size.height)) {}

  /// Paints the columns first, first + 1, ... of a row, as in Picture::pixels, in the widest
  /// vectors that the processor has.
  void paint(int row, int first, std::span<std::uint32_t> pixels) const;
  /// The colour of one pixel, without vectors: the plain form of paint.
  std::uint32_t at(int row, int column) const;

 private:
  Point3 normal_of_row(int row) const { return n0_ + dn_dy_ * (row + 0.5 - y0_); }

  Colour colour_;
  Light light_;
  Point3 low_, high_;
  double x0_, y0_;
  Point3 n0_, dn_dx_, dn_dy_;
};

}  // namespace displayfile
