#include "clip/view/view_volume.h"

#include <cassert>
#include <cstddef>

#include "clip/base/vector_kind.h"
#include "clip/pipeline/clip_pipeline.h"

// The code below is compiled once for each kind of vector.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "clip/pipeline/view_points.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace displayfile::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using DoubleTag = hn::CappedTag<double, 8>;
using Doubles = hn::Vec<DoubleTag>;
using DoubleMask = hn::Mask<DoubleTag>;
constexpr DoubleTag kDoubles{};
constexpr hn::RebindToUnsigned<DoubleTag> kBits{};
using Bits = hn::Vec<decltype(kBits)>;

/// The numbers of a view volume, each in all lanes; results are those of ViewVolume's functions.
class VolumeInVectors {
 public:
  explicit VolumeInVectors(const ViewVolume& volume)
      : volume_(volume), nearest_w_(hn::Set(kDoubles, volume.nearest_w())) {
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) {
        matrix_[column][row] = hn::Set(kDoubles, volume.matrix()[column][row]);
      }
    }
  }

  /// Transforms as many points as a vector has doubles.
  HWY_INLINE void view(const double* world, double* device, std::uint8_t* outcodes) const {
    Doubles x, y, z;
    hn::LoadInterleaved3(kDoubles, world, x, y, z);
    const auto transformed = [&](int row) {
      return hn::Add(hn::Add(hn::Mul(matrix_[0][row], x), hn::Mul(matrix_[1][row], y)),
                     hn::Add(hn::Mul(matrix_[2][row], z), matrix_[3][row]));
    };
    const Doubles in_x = transformed(0), in_y = transformed(1), in_z = transformed(2),
                  in_w = transformed(3), zero = hn::Zero(kDoubles);
    Bits code = hn::Zero(kBits);
    const auto require = [&](DoubleMask inside, ClipPlane plane) {
      const Outcode bit = bit_of(plane) & volume_.active();
      const Bits outside = hn::BitCast(kBits, hn::VecFromMask(kDoubles, hn::Not(inside)));
      code = hn::Or(code, hn::And(outside, hn::Set(kBits, std::uint64_t{bit})));
    };
    require(hn::Ge(in_z, zero), ClipPlane::back);
    require(hn::Le(in_z, in_w), ClipPlane::front);
    require(hn::Ge(in_w, nearest_w_), ClipPlane::eye);
    require(hn::Ge(in_x, zero), ClipPlane::left);
    require(hn::Le(in_x, in_w), ClipPlane::right);
    require(hn::Ge(in_y, zero), ClipPlane::bottom);
    require(hn::Le(in_y, in_w), ClipPlane::top);
    alignas(64) std::uint64_t codes[8];
    hn::Store(code, kBits, codes);
    for (std::size_t i = 0; i < hn::Lanes(kDoubles); ++i) {
      outcodes[i] = static_cast<std::uint8_t>(codes[i]);
    }

    const DoubleMask inside = hn::RebindMask(kDoubles, hn::Eq(code, hn::Zero(kBits)));
    const bool perspective = volume_.is_perspective();
    const auto in_cube = [&](Doubles coordinate) {
      return hn::IfThenElseZero(inside, perspective ? hn::Div(coordinate, in_w) : coordinate);
    };
    const auto in_viewport = [&](double low, double high, Doubles t) {
      if (low == 0.0 && high == 1.0) return t;
      const Doubles from_low = hn::Mul(hn::Sub(hn::Set(kDoubles, 1.0), t), hn::Set(kDoubles, low));
      return hn::IfThenElseZero(inside, hn::Add(from_low, hn::Mul(t, hn::Set(kDoubles, high))));
    };
    const Rectangle& viewport = volume_.viewport();
    hn::StoreInterleaved3(in_viewport(viewport.x_min, viewport.x_max, in_cube(in_x)),
                          in_viewport(viewport.y_min, viewport.y_max, in_cube(in_y)), in_cube(in_z),
                          kDoubles, device);
  }

 private:
  const ViewVolume& volume_;
  Doubles matrix_[4][4], nearest_w_;
};

void ViewPoints(const ViewVolume& volume, std::span<const Point3> world, std::span<Point3> device,
                std::span<std::uint8_t> outcodes) {
  const VolumeInVectors in_vectors(volume);
  const ClipPipeline pipeline(volume);
  const std::size_t lanes = hn::Lanes(kDoubles);
  std::size_t i = 0;
  for (; i + lanes <= world.size(); i += lanes) {
    in_vectors.view(&world[i].x, &device[i].x, &outcodes[i]);
  }
  for (; i < world.size(); ++i) {
    const PipelineVertex viewed = pipeline.view(world[i]);
    device[i] = viewed.device;
    outcodes[i] = static_cast<std::uint8_t>(viewed.outcode);
  }
}

}  // namespace displayfile::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace displayfile {

static_assert(sizeof(Point3) == 3 * sizeof(double));
static_assert(kClipPlanes <= 8);

void view_points(const ViewVolume& volume, std::span<const Point3> world, std::span<Point3> device,
                 std::span<std::uint8_t> outcodes) {
  assert(device.size() == world.size() && outcodes.size() == world.size());
  DISPLAYFILE_WIDEST_FORM(ViewPoints)(volume, world, device, outcodes);
}

}  // namespace displayfile
#endif
