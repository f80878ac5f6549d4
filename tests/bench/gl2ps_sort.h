#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "tests/bench/device_scene.h"

namespace displayfile::bench {

/// gl2ps's BSP sort (Geuzaine, gl2ps 1.4), in this process. The polygons, triangles only, are
/// given to it as they come out of an OpenGL feedback buffer, in window coordinates of 1024 x
/// 1024 pixels and in single precision; no OpenGL is involved.
struct Gl2psSort {
  /// gl2ps's version; nothing if this build has no gl2ps.
  static std::optional<std::string> version();

  /// Seconds of gl2psEndPage alone in a format that writes no polygons (GL2PS_TEX): it rescales
  /// depth, builds the tree, traverses it and frees it, and writes nothing.
  static double seconds(const DeviceScene& triangles);
  /// Polygons that it writes, in SVG.
  static std::size_t fragments(const DeviceScene& triangles);
};

}  // namespace displayfile::bench
