#include "displayfile/mesh/welded_faces.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "hidden/touching/vertices_within_reach.h"

namespace displayfile {

namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFu;

struct Edge {
  std::uint32_t from, to;
  std::uint32_t high() const { return std::max(from, to); }
};

/// Edges used more often in one direction than in the other.
std::vector<SideOfPoints> unpaired_edges(const WeldedFaces& faces) {
  std::vector<std::size_t> end(faces.vertices.size() + 1, 0);
  for_each_edge(faces,
                [&](std::uint32_t from, std::uint32_t to) { ++end[std::min(from, to) + 1]; });
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Edge> edges(end.back());
  for_each_edge(faces, [&](std::uint32_t from, std::uint32_t to) {
    edges[end[std::min(from, to)]++] = {from, to};
  });
  std::vector<SideOfPoints> unpaired;
  std::size_t begin = 0;
  for (std::size_t v = 0; v < faces.vertices.size(); begin = end[v++]) {
    const auto of_vertex = std::span(edges).subspan(begin, end[v] - begin);
    std::ranges::sort(of_vertex, {}, &Edge::high);
    for (std::size_t first = 0, last = 0; first < of_vertex.size(); first = last) {
      std::ptrdiff_t up = 0;
      for (; last < of_vertex.size() && of_vertex[last].high() == of_vertex[first].high(); ++last) {
        up += of_vertex[last].from < of_vertex[last].to ? 1 : -1;
      }
      for (std::size_t k = first; up != 0 && k < last; ++k) {
        unpaired.push_back({of_vertex[k].from, of_vertex[k].to});
      }
    }
  }
  return unpaired;
}

}  // namespace

WeldedFaces weld(const Mesh& mesh, double reach) {
  constexpr std::uint32_t kUsed = 0;
  std::vector<std::uint32_t> number(mesh.vertices.size(), kNone);
  for (const std::uint32_t corner : mesh.corners) number[corner] = kUsed;
  std::vector<Point3> used;
  used.reserve(mesh.vertices.size());
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] != kUsed) continue;
    number[v] = static_cast<std::uint32_t>(used.size());
    used.push_back(mesh.vertices[v]);
  }
  const std::vector<std::uint32_t> first = first_within(used, reach);
  WeldedFaces welded{{}, {}, mesh.first_corner};
  welded.vertices.reserve(used.size());
  std::vector<std::uint32_t> number_of(used.size());
  for (std::size_t k = 0; k < used.size(); ++k) {
    if (first[k] == k) welded.vertices.push_back(used[k]);
    number_of[k] = first[k] == k ? static_cast<std::uint32_t>(welded.vertices.size() - 1)
                                 : number_of[first[k]];
  }
  welded.corners.reserve(mesh.corners.size());
  for (const std::uint32_t corner : mesh.corners) {
    welded.corners.push_back(number_of[number[corner]]);
  }
  return welded;
}

SidesWithVertices::SidesWithVertices(const WeldedFaces& faces, double reach) {
  const std::vector<SideOfPoints> sides = unpaired_edges(faces);
  const PartedSides parted(faces.vertices, sides, reach);
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const auto along = parted.along(k);
    if (along.empty()) continue;
    along_.push_back({sides[k].from, sides[k].to, {along.begin(), along.end()}});
  }
  std::ranges::sort(along_, [](const Along& a, const Along& b) {
    return std::tie(a.from, a.to) < std::tie(b.from, b.to);
  });
}

std::span<const std::uint32_t> SidesWithVertices::along(std::uint32_t from,
                                                        std::uint32_t to) const {
  const auto at = std::ranges::lower_bound(along_, std::tuple(from, to), {},
                                           [](const Along& a) { return std::tuple(a.from, a.to); });
  if (at == along_.end() || at->from != from || at->to != to) return {};
  return at->vertices;
}

FacesWithCorners::FacesWithCorners(const WeldedFaces& faces, const SidesWithVertices& sides)
    : faces_{faces.vertices, {}, {}} {
  first_corner_.push_back(0);
  for (std::size_t i = 0; i < faces.faces(); ++i) {
    std::uint32_t from = faces.face(i).back();
    for (const std::uint32_t to : faces.face(i)) {
      const auto along = sides.along(from, to);
      faces_.corners.insert(faces_.corners.end(), along.begin(), along.end());
      faces_.corners.push_back(to);
      from = to;
    }
    first_corner_.push_back(faces_.corners.size());
  }
  faces_.first_corner = first_corner_;
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
