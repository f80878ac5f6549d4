#pragma once

#include <span>
#include <string_view>

#include "displayfile/mesh/mesh.h"
#include "tests/bench/lines_beside_peers/peer_scene.h"

namespace displayfile::bench {

/// A small mesh of flat faces, and a parallel view of it, in which much touches or coincides. All
/// coordinates are single.
struct DegenerateMesh {
  std::string_view name, what;
  PeerScene (*make)();
};
std::span<const DegenerateMesh> degenerate_meshes();

}  // namespace displayfile::bench
