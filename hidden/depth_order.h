#pragma once

#include "hidden/defined_point.h"
#include "hidden/pixel_centre.h"
#include "hidden/plane.h"

namespace displayfile {

// Which of two planes is nearer to the viewer along a projector (a line parallel to z): the
// sign of a's z less b's there, so 1 where a is nearer, 0 where they meet. Neither plane may
// be edge-on. The true sign for coordinates up to kCoordinateLimit, whatever the rounding
// mode.

/// At a pixel's centre; the planes in device coordinates.
int depth_order(const Plane& a, const Plane& b, const PixelCentre& centre);

/// At a point of the projection.
int depth_order(const Plane& a, const Plane& b, const Point2& at);

/// At a defined point's x and y.
int depth_order(const Definitions& all, const Plane& a, const Plane& b, const DefinedPoint& at);

}  // namespace displayfile
