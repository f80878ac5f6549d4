#include "hidden/touching/planes_in_row.h"

#include <bit>
#include <limits>

#include "clip/base/vector_kind.h"

// The code below is compiled once for each kind of vector.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hidden/touching/planes_in_row.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace displayfile::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Writes the indices that PlanesInRow::near returns. Has no branches that depend on the planes:
/// most runs are short, and processing an empty run costs less than detecting it. Near planes are
/// therefore marked as bits of a word, which are processed together.
std::size_t FindNear(const PlanesInRow::Plane* planes, float near,
                     const std::array<float, 3>& point, std::span<const PlanesInRow::Run> runs,
                     std::uint32_t* found) {
  const hn::CappedTag<float, 8> floats;
  const auto x = hn::Set(floats, point[0]), y = hn::Set(floats, point[1]),
             z = hn::Set(floats, point[2]), most = hn::Set(floats, near);
  const auto lanes = static_cast<std::uint32_t>(hn::Lanes(floats));
  constexpr std::uint32_t kBytes = 8;
  std::uint32_t first[kBytes];  // per byte of the word
  std::uint32_t bytes = 0;
  std::uint64_t word = 0;
  std::size_t n = 0;
  const auto write = [&] {
    for (; word != 0; word &= word - 1) {
      const auto bit = static_cast<std::uint32_t>(std::countr_zero(word));
      found[n++] = first[bit / 8] + bit % 8;
    }
    bytes = 0;
  };
  for (const auto& [begin, end] : runs) {
    std::uint32_t k = begin;
    do {
      hn::Vec<decltype(floats)> nx, ny, nz, distance;
      hn::LoadInterleaved4(floats, planes[k].normal.data(), nx, ny, nz, distance);
      const auto along = hn::MulAdd(nz, z, hn::MulAdd(ny, y, hn::Mul(nx, x)));
      std::uint8_t bits[8] = {};
      hn::StoreMaskBits(floats, hn::Le(hn::Abs(hn::Sub(along, distance)), most), bits);
      word |= std::uint64_t{bits[0]} << (8 * bytes);
      first[bytes++] = k;
      if (bytes == kBytes) write();
      k += lanes;
    } while (k < end);
  }
  write();
  return n;
}

}  // namespace displayfile::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace displayfile {

static_assert(sizeof(PlanesInRow::Plane) == 4 * sizeof(float));

PlanesInRow::PlanesInRow(std::size_t planes, float near)
    : planes_(planes + kAtOnce, Plane{{0.0F, 0.0F, 0.0F}, std::numeric_limits<float>::quiet_NaN()}),
      numbers_(planes),
      near_(near),
      find_(widest_form()) {}

PlanesInRow::Form* PlanesInRow::widest_form() { return DISPLAYFILE_WIDEST_FORM(FindNear); }

std::span<const std::uint32_t> PlanesInRow::near(const std::array<float, 3>& point,
                                                 std::span<const Run> runs) {
  std::size_t most = 0;
  for (const Run& run : runs) most += run.end - run.begin + 2 * kAtOnce;
  if (most > found_.size()) found_.resize(2 * most);
  return {found_.data(), find_(planes_.data(), near_, point, runs, found_.data())};
}

}  // namespace displayfile
#endif
