#pragma once

#include <cstdint>
#include <span>

#include "clip/point.h"
#include "clip/view_volume.h"

namespace displayfile {

/// Views many points as ClipPipeline::view does one by one, in vectors of doubles: the widest that
/// the processor has. `device` gets their device coordinates, 0 for what is outside of a clip
/// plane, and `outcodes` their outcodes; both are as long as `world`. The same to the last bit.
void view_points(const ViewVolume& volume, std::span<const Point3> world, std::span<Point3> device,
                 std::span<std::uint8_t> outcodes);

}  // namespace displayfile
