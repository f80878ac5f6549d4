#pragma once

#include <vector>

namespace displayfile {

/// One stage of Sutherland and Hodgman's ("Reentrant polygon clipping", CACM 17, 1974): a polygon
/// is cut by one plane, from `in` to `out`, which then change places.
///
/// A vertex V has an `outcode`, whose `bit` means outside, and the flag `edge_visible` of the side
/// that ends there; sides along the plane are not drawn. is_on_plane(v) is called for inside
/// vertices. cut(inside, outside) makes the vertex where an edge crosses the plane, always from its
/// inside end, so that polygons that share the edge are cut at the same point. No remaining vertex
/// has the bit, if no vertex made by cut has it.
template <class V, class OnPlane, class Cut>
void clip_stage(unsigned bit, std::vector<V>& in, std::vector<V>& out, OnPlane&& is_on_plane,
                Cut&& cut) {
  out.clear();
  if (in.empty()) return;
  const V* previous = &in.back();
  for (const V& vertex : in) {
    const bool was_outside = (previous->outcode & bit) != 0;
    const bool is_outside = (vertex.outcode & bit) != 0;
    if (was_outside && !is_outside) {
      if (is_on_plane(vertex)) {
        out.push_back(vertex);  // the edge ends where it enters: nothing remains
        out.back().edge_visible = 0;
      } else {
        // Reached along the plane: a cut vertex is made with no visible side.
        out.push_back(cut(vertex, *previous));
        out.push_back(vertex);
      }
    } else if (!was_outside && is_outside) {
      if (!is_on_plane(*previous)) {
        V exit = cut(*previous, vertex);
        exit.edge_visible = vertex.edge_visible;
        out.push_back(exit);
      }
    } else if (!is_outside) {
      out.push_back(vertex);
    }
    previous = &vertex;
  }
  in.swap(out);
}

}  // namespace displayfile
