#include "displayfile/views/triangle_sieve.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "clip/base/vector_kind.h"

// The code below is compiled once for each kind of vector.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "displayfile/views/triangle_sieve.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace displayfile::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using DoubleTag = hn::CappedTag<double, 8>;
constexpr DoubleTag kDoubles{};
constexpr hn::Rebind<std::int32_t, DoubleTag> kHalfInts{};
using IntTag = hn::CappedTag<std::int32_t, 16>;
using Ints = hn::Vec<IntTag>;
constexpr IntTag kInts{};
constexpr hn::RebindToUnsigned<IntTag> kUnsigned{};
constexpr hn::RebindToFloat<IntTag> kFloats{};
using Floats = hn::Vec<decltype(kFloats)>;
using Mask = hn::Mask<decltype(kFloats)>;

double FindPlaces(std::span<const Point3> device, std::span<const std::uint8_t> outcodes,
                  const PictureSize& size, std::span<PicturePlace> places) {
  const std::size_t lanes = hn::Lanes(kDoubles);
  const double width = size.width * 0x1p15, height = size.height * 0x1p15;
  const auto scale_x = hn::Set(kDoubles, width), scale_y = hn::Set(kDoubles, height);
  const auto half = hn::Set(kDoubles, 0.5);
  auto deepest = hn::Zero(kDoubles);
  std::size_t i = 0;
  for (; i + lanes <= device.size(); i += lanes) {
    hn::Vec<DoubleTag> x, y, z;
    hn::LoadInterleaved3(kDoubles, &device[i].x, x, y, z);
    deepest = hn::Max(deepest, hn::Abs(z));
    alignas(64) std::int32_t whole_x[8], whole_y[8];
    hn::Store(hn::DemoteTo(kHalfInts, hn::Add(hn::Mul(x, scale_x), half)), kHalfInts, whole_x);
    hn::Store(hn::DemoteTo(kHalfInts, hn::Add(hn::Mul(y, scale_y), half)), kHalfInts, whole_y);
    for (std::size_t k = 0; k < lanes; ++k) {
      places[i + k] = {outcodes[i + k] == 0 ? whole_x[k] : PicturePlace::kOutside, whole_y[k]};
    }
  }
  double largest = hn::GetLane(hn::MaxOfLanes(kDoubles, deepest));
  for (; i < device.size(); ++i) {
    largest = std::max(largest, std::abs(device[i].z));
    const auto x = static_cast<std::int32_t>(device[i].x * width + 0.5);
    const auto y = static_cast<std::int32_t>(device[i].y * height + 0.5);
    places[i] = {outcodes[i] == 0 ? x : PicturePlace::kOutside, y};
  }
  return largest;
}

/// As many triangles as a vector has single-precision numbers.
class Sieve {
 public:
  Sieve(const std::uint32_t* corners, const PicturePlace* places) {
    hn::Vec<decltype(kUnsigned)> corner[3];
    hn::LoadInterleaved3(kUnsigned, corners, corner[0], corner[1], corner[2]);
    const std::int32_t* const coordinates = &places->x;
    for (int k = 0; k < 3; ++k) {
      const Ints at = hn::BitCast(kInts, hn::Add(corner[k], corner[k]));
      x_[k] = hn::GatherIndex(kInts, coordinates, at);
      y_[k] = hn::GatherIndex(kInts, coordinates, hn::Add(at, hn::Set(kInts, 1)));
    }
  }

  /// Sets the triangles' bits, the first one's at `i`.
  HWY_INLINE void look(std::size_t i, SievedTriangles& found) {
    const Ints out = hn::Set(kInts, PicturePlace::kOutside);
    const auto outside = hn::Or(hn::Or(hn::Eq(x_[0], out), hn::Eq(x_[1], out)), hn::Eq(x_[2], out));
    Ints extent_x, extent_y, column, columns, row, rows;
    find_centres(x_, column, columns, extent_x);
    find_centres(y_, row, rows, extent_y);
    const Ints zero = hn::Zero(kInts), many = hn::Set(kInts, kFewCentres + 1);
    const auto none = hn::AndNot(outside, hn::Or(hn::Eq(columns, zero), hn::Eq(rows, zero)));

    measure_from(column, row);
    const Floats m =
        hn::Mul(hn::ConvertTo(kFloats, hn::Max(extent_x, extent_y)), hn::Set(kFloats, 0x1p-15f));
    const Floats error =
        hn::Add(hn::Mul(hn::Add(m, hn::Set(kFloats, 1.0f)), hn::Set(kFloats, 0x1p-11f)),
                hn::Mul(hn::Mul(m, m), hn::Set(kFloats, 0x1p-20f)));
    const Floats area = hn::Sub(hn::Mul(hn::Sub(fx_[1], fx_[0]), hn::Sub(fy_[2], fy_[0])),
                                hn::Mul(hn::Sub(fy_[1], fy_[0]), hn::Sub(fx_[2], fx_[0])));
    const Mask certain = hn::And(
        hn::Gt(hn::Abs(area), error),
        hn::And(hn::Le(m, hn::Set(kFloats, 512.0f)), hn::Not(hn::RebindMask(kFloats, outside))));
    const Mask is_none = hn::RebindMask(kFloats, none);
    Mask covers = hn::Not(is_none);
    const auto is_small = hn::And(hn::Lt(columns, many), hn::Lt(rows, many));
    const Mask look_closer = hn::And(hn::And(certain, covers), hn::RebindMask(kFloats, is_small));
    if (!hn::AllFalse(kFloats, look_closer)) {
      const Mask covered = covers_one(area, hn::Neg(error), columns, rows);
      covers = hn::AndNot(hn::AndNot(covered, look_closer), covers);
    }
    found.stays |= bits(hn::And(covers, certain)) << i;
    found.needs_more |= bits(hn::AndNot(certain, covers)) << i;
    found.turned_away |= bits(hn::Lt(area, hn::Zero(kFloats))) << i;
  }

 private:
  /// CentresBetween of the corners along one axis, and their extent.
  HWY_INLINE static void find_centres(const Ints (&at)[3], Ints& first, Ints& count, Ints& extent) {
    const Ints low = hn::Min(hn::Min(at[0], at[1]), at[2]);
    const Ints high = hn::Max(hn::Max(at[0], at[1]), at[2]);
    extent = hn::Sub(high, low);
    constexpr std::int32_t kUp = CentresBetween::kPixel - 2 - CentresBetween::kHalf;
    first = hn::ShiftRight<PicturePlace::kBits>(hn::Add(low, hn::Set(kInts, kUp)));
    const Ints last = hn::ShiftRight<PicturePlace::kBits>(
        hn::Add(high, hn::Set(kInts, 1 - CentresBetween::kHalf)));
    count = hn::Sub(hn::Add(last, hn::Set(kInts, 1)), first);
  }

  /// Measures the corners in pixels from that centre.
  HWY_INLINE void measure_from(Ints column, Ints row) {
    const Ints half = hn::Set(kInts, CentresBetween::kHalf);
    const Ints centre_x = hn::Add(hn::ShiftLeft<PicturePlace::kBits>(column), half);
    const Ints centre_y = hn::Add(hn::ShiftLeft<PicturePlace::kBits>(row), half);
    const Floats pixels = hn::Set(kFloats, 0x1p-15f);
    for (int k = 0; k < 3; ++k) {
      fx_[k] = hn::Mul(hn::ConvertTo(kFloats, hn::Sub(x_[k], centre_x)), pixels);
      fy_[k] = hn::Mul(hn::ConvertTo(kFloats, hn::Sub(y_[k], centre_y)), pixels);
    }
  }

  /// True if one of the few centres is inside of all sides, up to the error -`least`.
  HWY_INLINE Mask covers_one(Floats area, Floats least, Ints columns, Ints rows) const {
    Floats inside[3], per_column[3], per_row[3];
    for (int k = 0, next = 1; k < 3; ++k, next = next == 2 ? 0 : next + 1) {
      const auto toward_inside = [&](Floats value) {
        return hn::Mul(hn::CopySignToAbs(one(), area), value);
      };
      inside[k] = toward_inside(hn::Sub(hn::Mul(fx_[k], fy_[next]), hn::Mul(fy_[k], fx_[next])));
      per_column[k] = toward_inside(hn::Sub(fy_[k], fy_[next]));
      per_row[k] = toward_inside(hn::Sub(fx_[next], fx_[k]));
    }
    Mask covered = hn::Lt(least, least);
    for (std::int32_t j = 0; j < kFewCentres; ++j) {
      Floats at[3] = {inside[0], inside[1], inside[2]};
      for (std::int32_t i = 0; i < kFewCentres; ++i) {
        const auto here =
            hn::And(hn::Gt(columns, hn::Set(kInts, i)), hn::Gt(rows, hn::Set(kInts, j)));
        const Floats deepest = hn::Min(hn::Min(at[0], at[1]), at[2]);
        covered = hn::Or(covered, hn::And(hn::Ge(deepest, least), hn::RebindMask(kFloats, here)));
        for (int k = 0; k < 3; ++k) at[k] = hn::Add(at[k], per_column[k]);
      }
      for (int k = 0; k < 3; ++k) inside[k] = hn::Add(inside[k], per_row[k]);
    }
    return covered;
  }
  HWY_INLINE static Floats one() { return hn::Set(kFloats, 1.0f); }

  HWY_INLINE static std::uint64_t bits(Mask mask) {
    alignas(8) std::uint8_t own[8] = {};
    hn::StoreMaskBits(kFloats, mask, own);
    return own[0] | static_cast<std::uint64_t>(own[1]) << 8;
  }

  Ints x_[3], y_[3];      // as PicturePlace
  Floats fx_[3], fy_[3];  // in pixels
};

SievedTriangles SieveTriangles(const std::uint32_t* corners, std::size_t n,
                               const PicturePlace* places) {
  SievedTriangles found;
  const std::size_t lanes = hn::Lanes(kInts);
  std::size_t i = 0;
  for (; i + lanes <= n; i += lanes) Sieve(corners + 3 * i, places).look(i, found);
  if (i < n) {
    std::uint32_t last[3 * 16];  // in the others all corners are one vertex
    std::fill_n(last, 3 * 16, corners[3 * i]);
    std::copy(corners + 3 * i, corners + 3 * n, last);
    Sieve(last, places).look(i, found);
    const std::uint64_t given =
        n == SievedTriangles::kMost ? ~std::uint64_t{0} : (std::uint64_t{1} << n) - 1;
    found.stays &= given;
    found.needs_more &= given;
  }
  found.turned_away &= found.stays;
  return found;
}

}  // namespace displayfile::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace displayfile {

static_assert(sizeof(PicturePlace) == 2 * sizeof(std::int32_t));

double find_places(std::span<const Point3> device, std::span<const std::uint8_t> outcodes,
                   const PictureSize& size, std::span<PicturePlace> places) {
  assert(outcodes.size() == device.size() && places.size() == device.size());
  return DISPLAYFILE_WIDEST_FORM(FindPlaces)(device, outcodes, size, places);
}

SievedTriangles sieve_triangles(const std::uint32_t* corners, std::size_t n,
                                const PicturePlace* places) {
  assert(n <= SievedTriangles::kMost);
  return DISPLAYFILE_WIDEST_FORM(SieveTriangles)(corners, n, places);
}

}  // namespace displayfile
#endif
