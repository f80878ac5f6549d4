#pragma once

#include <span>

#include "displayfile/graphics_system.h"

namespace displayfile {

// Primitive shapes, made of polygons_abs_3 (displayfile/shapes/README.md): in the coordinates of
// the application, before the modelling transformation. Their polygons are closed, counterclockwise
// from outside, share their vertices to the last bit, and have a pick identifier each, as polygons
// do. What is round stands on facets, 3 to 1000 of them around, and has normals for smooth shading;
// it is inscribed: its vertices are on the true surface. Errors, before any polygon is entered: an
// empty range, a length that is not above 0, facets out of range, and those of polygons_abs_3.

/// From corner to corner.
void box_3(GraphicsSystem& system, const Point3& low, const Point3& high);
/// A right-angled wedge: the box's half below the plane from its upper edge at low.x to its lower
/// edge at high.x.
void wedge_3(GraphicsSystem& system, const Point3& low, const Point3& high);
/// An upright prism over a regular polygon, whose corners are at `radius` from the middle of its
/// base, the first in the direction of x; `height` is along z.
void prism_3(GraphicsSystem& system, const Point3& base, double radius, double height, int sides);
void cylinder_3(GraphicsSystem& system, const Point3& base, double radius, double height,
                int facets);
/// A cone, or with a radius at its top above 0 a truncated one.
void cone_3(GraphicsSystem& system, const Point3& base, double radius, double height, int facets,
            double top_radius = 0.0);
/// So many facets around, half as many (rounded up) from pole to pole; its axis is along z.
void sphere_3(GraphicsSystem& system, const Point3& centre, double radius, int facets);
/// A ring about a line along z through its centre; the tube has half as many facets around it
/// (rounded up, but 3). Error: the tube's radius is not below the ring's.
void torus_3(GraphicsSystem& system, const Point3& centre, double radius, double tube_radius,
             int facets);
/// A profile in the x-y plane, extruded along z (extruded, in displayfile/shapes/swept.h).
void extrude_3(GraphicsSystem& system, double z_min, double z_max, std::span<const Point2> profile);
/// A profile of points (x, z) in the x-z plane, turned about the z axis (turned, in
/// displayfile/shapes/swept.h).
void turn_3(GraphicsSystem& system, int facets, std::span<const Point2> profile);

}  // namespace displayfile
