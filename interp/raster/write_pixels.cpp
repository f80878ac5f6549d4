#include "interp/raster/write_pixels.h"

#include <cstddef>

#include "clip/base/vector_kind.h"

// The code below is compiled once for each kind of vector.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "interp/raster/write_pixels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace displayfile::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void WritePixels(std::span<const std::uint32_t> number, const std::uint32_t* pixel_of,
                 std::uint32_t* pixels) {
  constexpr hn::CappedTag<std::uint32_t, 16> kPixels;
  constexpr hn::RebindToSigned<decltype(kPixels)> kNumbers;
  const std::size_t lanes = hn::Lanes(kPixels);
  std::size_t i = 0;
  for (; i + lanes <= number.size(); i += lanes) {
    const auto numbers = hn::LoadU(kPixels, number.data() + i);
    const bool same = hn::AllTrue(kPixels, hn::Eq(numbers, hn::Set(kPixels, number[i])));
    hn::StoreU(same ? hn::Set(kPixels, pixel_of[number[i]])
                    : hn::GatherIndex(kPixels, pixel_of, hn::BitCast(kNumbers, numbers)),
               kPixels, pixels + i);
  }
  for (; i < number.size(); ++i) pixels[i] = pixel_of[number[i]];
}

}  // namespace displayfile::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace displayfile {

void write_pixels(std::span<const std::uint32_t> number, const std::uint32_t* pixel_of,
                  std::uint32_t* pixels) {
  DISPLAYFILE_WIDEST_FORM(WritePixels)(number, pixel_of, pixels);
}

}  // namespace displayfile
#endif
