#include "programs/sheet/closed_pieces.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

#include "displayfile/mesh/welded_faces.h"

namespace displayfile {

namespace {

/// Counts how often sides are used, in one direction less in the other.
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

  std::unordered_map<std::uint64_t, int> uses_;  // of sides that are not balanced
};

}  // namespace

std::vector<Mesh::Object> closed_pieces(const Mesh& mesh) {
  const WeldedFaces faces = weld(mesh);
  std::vector<Mesh::Object> pieces;
  SideBalance balance;
  std::size_t first = 0;
  for (std::size_t i = 0; i < faces.faces(); ++i) {
    balance.add(faces.face(i));
    if (!balance.is_closed() && i + 1 < faces.faces()) continue;
    pieces.push_back({"", first, i + 1 - first});
    first = i + 1;
  }
  return pieces;
}

}  // namespace displayfile
