#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace displayfile {

/// Faces that lie side by side without common edges, as IGES files have them, joined along the
/// edges that coincide within `tolerance`. Returns for each face of the shape, in the order of
/// TopExp_Explorer, the one in its place, if any is left. Closed shells get their outside outward.
std::vector<TopoDS_Face> sewn_faces(const TopoDS_Shape& shape, double tolerance);

/// True if an edge of the shape belongs to one face alone.
bool has_free_edges(const TopoDS_Shape& shape);

}  // namespace displayfile
