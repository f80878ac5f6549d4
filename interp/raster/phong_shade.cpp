#include "interp/raster/phong_shade.h"

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "clip/base/vector_kind.h"
#include "interp/device/picture.h"
#include "interp/raster/phong_row.h"

// The code below is compiled once for each kind of vector.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "interp/raster/phong_shade.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace displayfile::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The operations of PhongShade::at, in the same order, on several pixels at a time.
void PaintPhong(const PhongRow& row, int first, std::span<std::uint32_t> pixels) {
  constexpr hn::CappedTag<double, 4> kPixels;  // more seldom fit into a run
  constexpr hn::Rebind<std::int32_t, decltype(kPixels)> kWhole;
  constexpr hn::RebindToUnsigned<decltype(kWhole)> kStored;
  const auto set = [&](double value) { return hn::Set(kPixels, value); };
  const auto square = [](auto v) { return hn::Mul(v, v); };
  const std::size_t lanes = hn::Lanes(kPixels);
  for (std::size_t i = 0; i < pixels.size(); i += lanes) {
    const double centre = first + static_cast<int>(i) + 0.5;
    const auto column = hn::Sub(hn::Iota(kPixels, centre), set(row.x0));
    const auto component = [&](int c) {
      const auto n = hn::Add(set(row.normal[c]), hn::Mul(set(row.step[c]), column));
      const auto low = set(row.low[c]);
      return hn::IfThenElse(hn::Gt(n, low), hn::Min(n, set(row.high[c])), low);
    };
    const auto x = component(0), y = component(1), z = component(2);
    const auto along_light =
        hn::Add(hn::Add(hn::Mul(x, set(row.toward.x)), hn::Mul(y, set(row.toward.y))),
                hn::Mul(z, set(row.toward.z)));
    const auto length = hn::Sqrt(hn::Add(hn::Add(square(x), square(y)), square(z)));
    const auto cosine = hn::Div(along_light, length);
    const auto lit = hn::IfThenElseZero(hn::Gt(cosine, hn::Zero(kPixels)), cosine);
    const auto intensity =
        hn::Min(set(1.0), hn::Add(set(row.ambient), hn::Mul(set(1.0 - row.ambient), lit)));
    const auto byte = [&](double colour) {
      const auto part = hn::Mul(set(colour), intensity);
      return hn::DemoteTo(kWhole, hn::Add(hn::Mul(part, set(255.0)), set(0.5)));
    };
    const auto rgb = hn::Or(byte(row.colour.r), hn::Or(hn::ShiftLeft<8>(byte(row.colour.g)),
                                                       hn::ShiftLeft<16>(byte(row.colour.b))));
    const auto opaque = hn::Or(hn::BitCast(kStored, rgb), hn::Set(kStored, 0xFF000000u));
    if (i + lanes <= pixels.size()) {
      hn::StoreU(opaque, kStored, pixels.data() + i);
    } else {
      HWY_ALIGN std::uint32_t last[hn::MaxLanes(kStored)];
      hn::Store(opaque, kStored, last);
      for (std::size_t k = i; k < pixels.size(); ++k) pixels[k] = last[k - i];
    }
  }
}

}  // namespace displayfile::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace displayfile {

/// Paints a few pixels one by one: filling vectors with common values would cost more.
void PhongShade::paint(int row, int first, std::span<std::uint32_t> pixels) const {
  constexpr std::size_t kFew = 2;
  if (pixels.size() <= kFew) {
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      pixels[i] = at(row, first + static_cast<int>(i));
    }
    return;
  }
  static const auto paint_row = DISPLAYFILE_WIDEST_FORM(PaintPhong);
  paint_row({normal_of_row(row), dn_dx_, low_, high_, light_.toward, colour_, x0_, light_.ambient},
            first, pixels);
}

std::uint32_t PhongShade::at(int row, int column) const {
  const Point3 linear = normal_of_row(row) + dn_dx_ * (column + 0.5 - x0_);
  const Point3 normal = NormalPlane::within(linear, low_, high_);
  const double cosine = glm::dot(normal, light_.toward) / std::sqrt(glm::dot(normal, normal));
  return pixel_of(colour_ * intensity_at(light_, cosine));
}

}  // namespace displayfile
#endif
