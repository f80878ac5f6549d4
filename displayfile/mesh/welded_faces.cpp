#include "displayfile/mesh/welded_faces.h"

#include <bit>

#include "clip/secret_hash.h"

namespace displayfile {

namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFu;

/// Numbers positions in the order in which they first come.
class Positions {
 public:
  explicit Positions(std::size_t most) : slots_(std::bit_ceil(2 * most + 1), kNone) {}

  std::uint32_t number(const Point3& p, std::vector<Point3>& numbered) {
    std::size_t slot = first_slot(p);
    while (slots_[slot] != kNone && numbered[slots_[slot]] != p) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    if (slots_[slot] == kNone) {
      slots_[slot] = static_cast<std::uint32_t>(numbered.size());
      numbered.push_back(p);
    }
    return slots_[slot];
  }
  void prefetch(const Point3& p) const { __builtin_prefetch(&slots_[first_slot(p)]); }

 private:
  std::size_t first_slot(const Point3& p) const { return hash_(p) & (slots_.size() - 1); }

  SecretHash hash_;
  std::vector<std::uint32_t> slots_;  // open addressing, at most half full
};

}  // namespace

WeldedFaces weld(const Mesh& mesh) {
  constexpr std::uint32_t kUsed = 0;
  constexpr std::size_t kAhead = 16;  // while this many others are looked up, the cache fills
  std::vector<std::uint32_t> number(mesh.vertices.size(), kNone);
  for (const std::uint32_t corner : mesh.corners) number[corner] = kUsed;

  WeldedFaces welded{{}, {}, mesh.first_corner};
  welded.vertices.reserve(mesh.vertices.size());
  Positions positions(mesh.vertices.size());
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (v + kAhead < number.size()) positions.prefetch(mesh.vertices[v + kAhead]);
    if (number[v] == kUsed) number[v] = positions.number(mesh.vertices[v], welded.vertices);
  }
  welded.corners.reserve(mesh.corners.size());
  for (const std::uint32_t corner : mesh.corners) welded.corners.push_back(number[corner]);
  return welded;
}

WeldedFaces WeldedObjects::operator()(const Mesh::Object& object) {
  WeldedFaces own{{}, {}, all_.first_corner.subspan(object.first_face, object.faces + 1)};
  const std::size_t start = own.first_corner.front() - all_.first_corner.front();
  const std::size_t corners = own.first_corner.back() - own.first_corner.front();
  const auto used = std::span(all_.corners).subspan(start, corners);
  own.corners.reserve(corners);
  for (const std::uint32_t v : used) {
    if (number_[v] == kNone) {
      number_[v] = static_cast<std::uint32_t>(own.vertices.size());
      own.vertices.push_back(all_.vertices[v]);
    }
    own.corners.push_back(number_[v]);
  }
  for (const std::uint32_t v : used) number_[v] = kNone;
  return own;
}

}  // namespace displayfile
