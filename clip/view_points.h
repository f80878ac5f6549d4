#pragma once

#include <cstdint>
#include <span>

#include "clip/point.h"
#include "clip/view_volume.h"

namespace displayfile {

/// Transforms many points as ClipPipeline::view does one, bit for bit, with the processor's widest
/// vectors of doubles. `device` gets device coordinates, 0 for points outside of a clip plane,
/// `outcodes` their outcodes; both have the length of `world`.
void view_points(const ViewVolume& volume, std::span<const Point3> world, std::span<Point3> device,
                 std::span<std::uint8_t> outcodes);

}  // namespace displayfile
