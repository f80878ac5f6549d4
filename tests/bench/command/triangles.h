#pragma once

#include <vector>

#include "displayfile/segments/display_file.h"
#include "displayfile/segments/viewed_scene.h"

namespace displayfile::bench {

/// A scene's fills cut into triangles, for peers that require them.
struct Triangles {
  std::vector<Point3> corners;           ///< three a triangle, device coordinates
  std::vector<ViewedScene::Fill> fills;  ///< of which fill each triangle is a part

  std::size_t size() const { return fills.size(); }
};

/// Cut by hidden/triangles/triangulation.h: a fill that crosses itself has no tiling, and its
/// triangles cover other pixels.
Triangles in_triangles(const ViewedScene& scene);

/// A display file of the triangles, solid and without lines, for methods that are to get the same
/// as such a peer.
DisplayFile display_file_of(const Triangles& triangles);

}  // namespace displayfile::bench
