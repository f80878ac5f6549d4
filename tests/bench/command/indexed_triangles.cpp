#include "tests/bench/command/indexed_triangles.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <utility>

#include "interp/raster/fill_paints.h"
#include "tests/bench/command/triangles.h"

namespace displayfile::bench {

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

struct Place {
  std::array<std::uint32_t, 3> bits;
  bool operator==(const Place&) const = default;
};

struct HashOfPlace {
  std::size_t operator()(const Place& place) const {
    std::uint64_t hash = 0;
    for (const std::uint32_t bits : place.bits) hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};

class Indexer {
 public:
  void add(std::span<const Point3> corners, std::uint32_t colour) {
    std::array<std::uint32_t, 3> shared{};  // the first vertex in each corner's place
    for (std::size_t k = 0; k < 3; ++k) shared[k] = first_at(corners[k]);
    const Last last = last_of(shared, colour);
    for (std::size_t k = 1; k <= 3; ++k) {
      const std::size_t corner = (last.corner + k) % 3;
      made.indices.push_back(corner == last.corner ? last.vertex : shared[corner]);
    }
  }

  IndexedTriangles made;

 private:
  /// The corner that stands last, and the vertex in its place that has the colour.
  struct Last {
    std::size_t corner;
    std::uint32_t vertex;
  };

  std::uint32_t first_at(const Point3& p) {
    // Zero has one place, whatever its sign.
    const std::array<float, 3> at{static_cast<float>(p.x) + 0.0F, static_cast<float>(p.y) + 0.0F,
                                  static_cast<float>(p.z) + 0.0F};
    const Place place{{std::bit_cast<std::uint32_t>(at[0]), std::bit_cast<std::uint32_t>(at[1]),
                       std::bit_cast<std::uint32_t>(at[2])}};
    const auto [found, is_new] = first_.try_emplace(place, 0);
    if (is_new) found->second = enter({at[0], at[1], at[2], 0});
    return found->second;
  }

  Last last_of(const std::array<std::uint32_t, 3>& shared, std::uint32_t colour) {
    Last free{0, kNone};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::uint32_t v = shared[k]; v != kNone; v = next_[v]) {
        if (is_coloured_[v] && made.vertices[v].colour == colour) return {k, v};
        if (!is_coloured_[v] && free.vertex == kNone) free = {k, v};
      }
    }
    if (free.vertex == kNone) {
      free = {2, enter(made.vertices[shared[2]])};
      next_[free.vertex] = next_[shared[2]];
      next_[shared[2]] = free.vertex;
    }
    made.vertices[free.vertex].colour = colour;
    is_coloured_[free.vertex] = true;
    return free;
  }

  std::uint32_t enter(const IndexedTriangles::Vertex& vertex) {
    made.vertices.push_back(vertex);
    next_.push_back(kNone);
    is_coloured_.push_back(false);
    return static_cast<std::uint32_t>(made.vertices.size() - 1);
  }

  std::unordered_map<Place, std::uint32_t, HashOfPlace> first_;
  std::vector<std::uint32_t> next_;  // in the same place
  std::vector<bool> is_coloured_;
};

std::vector<Point3> in_clip_coordinates(std::vector<Point3> corners) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Point3& p : corners) {
    low = std::min(low, p.z);
    high = std::max(high, p.z);
  }
  const double range = high > low ? high - low : 1.0;
  for (Point3& p : corners) {
    p = {2.0 * p.x - 1.0, 1.0 - 2.0 * p.y, 2.0 * (p.z - low) / range - 1.0};
  }
  return corners;
}

}  // namespace

IndexedTriangles indexed_triangles(std::span<const Point3> corners,
                                   std::span<const std::uint32_t> colours) {
  Indexer indexer;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    indexer.add(corners.subspan(3 * i, 3), colours[i]);
  }
  return std::move(indexer.made);
}

IndexedTriangles indexed_triangles(const ViewedScene& scene) {
  const Triangles triangles = in_triangles(scene);
  const FillPaints paints(scene);
  std::vector<std::uint32_t> colours;
  colours.reserve(triangles.size());
  for (const ViewedScene::Fill fill : triangles.fills) colours.push_back(paints.pixel(fill));
  return indexed_triangles(in_clip_coordinates(triangles.corners), colours);
}

}  // namespace displayfile::bench
