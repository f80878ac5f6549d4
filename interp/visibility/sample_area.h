#pragma once

#include <span>

#include "clip/point.h"
#include "hidden/exact/pixel_centre.h"
#include "interp/scan/pixel_box.h"

namespace displayfile {

/// A sample area of a picture: the centres of the pixels of a rectangle.
using SampleArea = PixelBox;

inline bool is_pixel(const SampleArea& area) { return area.columns() == 1 && area.rows() == 1; }

/// The relation of a polygon to a sample area (the problem book's section 10.6). Areas consist of
/// centres, so a polygon surrounds one if it covers all of its centres, and is disjoint from it if
/// it covers none.
enum class AreaCategory { surrounding, intersecting, contained, disjoint };

/// True if the polygon covers the centre by the definition (interp/truth/truth.md): exact.
bool covers(std::span<const Point3> polygon, const PixelCentre& centre);

/// The category of a polygon with these extents. Surrounding and disjoint are always correct; where
/// rounding leaves open whether a side misses the area, the polygon is intersecting, which decides
/// nothing. For a pixel it is exact: surrounding or disjoint.
AreaCategory category_of(std::span<const Point3> polygon, const SampleArea& extents,
                         const SampleArea& area, const PictureSize& size);

}  // namespace displayfile
