#include "programs/sheet/closed_pieces.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

#include "clip/geometry/secret_hash.h"
#include "displayfile/mesh/welded_faces.h"

namespace displayfile {

namespace {

/// Counts the uses of sides in one direction less those in the other.
class SideBalance {
 public:
  void add(std::span<const std::uint32_t> face) {
    std::uint32_t from = face.back();
    for (const std::uint32_t to : face) {
      if (from != to) add(from, to);
      from = to;
    }
  }
  bool is_closed() const { return uses_.empty(); }

 private:
  void add(std::uint32_t from, std::uint32_t to) {
    const auto [low, high] = std::minmax(from, to);
    const auto side = uses_.try_emplace((std::uint64_t{low} << 32) | high, 0).first;
    side->second += from < to ? 1 : -1;
    if (side->second == 0) uses_.erase(side);
  }

  std::unordered_map<std::uint64_t, int, SecretHash> uses_;  // of sides that are not balanced
};

/// Objects that are closed by themselves, and the unions of consecutive ones that are not.
std::vector<MeshPiece> closed_objects(const Mesh& mesh, const WeldedFaces& faces) {
  std::vector<MeshPiece> all;
  for (const Mesh::Object& object : mesh.objects) {
    SideBalance balance;
    for (std::size_t i = 0; i < object.faces; ++i) balance.add(faces.face(object.first_face + i));
    const bool goes_on = !all.empty() && !all.back().closed && !balance.is_closed();
    if (!goes_on) all.push_back({object.first_face, 0, balance.is_closed()});
    all.back().faces += object.faces;
  }
  return all;
}

}  // namespace

std::vector<MeshPiece> closed_pieces(const Mesh& mesh) {
  const double reach = entered_reach(mesh);
  const WeldedFaces welded = weld(mesh, reach);
  const FacesWithCorners with_corners(welded, SidesWithVertices(welded, reach));
  const WeldedFaces& faces = with_corners.faces();
  std::vector<MeshPiece> pieces;
  for (const MeshPiece& whole : closed_objects(mesh, faces)) {
    SideBalance balance;
    std::size_t first = whole.first_face;
    const std::size_t end = whole.first_face + whole.faces;
    for (std::size_t i = first; i < end; ++i) {
      balance.add(faces.face(i));
      if (!balance.is_closed() && i + 1 < end) continue;
      pieces.push_back({first, i + 1 - first, balance.is_closed()});
      first = i + 1;
    }
  }
  return pieces;
}

}  // namespace displayfile
