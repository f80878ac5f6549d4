#pragma once

#include "clip/point.h"
#include "hidden/exact/exact_number.h"
#include "hidden/exact/plane.h"

namespace displayfile {

// Meeting points on the line from a to b in the projection: each coordinate is the true one rounded
// once, to the nearest double. Independent of the caller, since the point is the same, for
// coordinates up to kCoordinateLimit: crossing_place(a, b, p, q) = crossing_place(p, q, a, b), and
// the ends of each line may be exchanged.

/// The point where the line through p and q crosses it. The lines must not be parallel.
Point2 crossing_place(const Point2& a, const Point2& b, const Point2& p, const Point2& q);

/// The point where two planes have the same depth above it. Neither plane is edge-on, and their
/// depths differ somewhere along it.
Point2 meeting_place(const Point2& a, const Point2& b, const Plane& one, const Plane& other);

/// The point (x, y) / w, by exact numbers; w is not zero.
struct ExactPlace {
  ExactNumber x, y, w;
};
ExactPlace exact_place(const Point2& p);
ExactPlace exact_crossing_place(const Point2& a, const Point2& b, const Point2& p, const Point2& q);
ExactPlace exact_meeting_place(const Point2& a, const Point2& b, const Plane& one,
                               const Plane& other);

Point2 rounded(const ExactPlace& place);
/// The order by x, then y; 0 if they are the same point. compare_xy(p, q) = -compare_xy(q, p).
int compare_xy(const ExactPlace& p, const ExactPlace& q);
/// 1 if r is left of the line from p to q, -1 if right of it, 0 on it. The sign flips where two of
/// them change places.
int orientation(const ExactPlace& p, const ExactPlace& q, const ExactPlace& r);

}  // namespace displayfile
