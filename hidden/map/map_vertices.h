#pragma once

#include <bit>
#include <cassert>
#include <cstdint>
#include <vector>

#include "hidden/map/visible_map.h"

namespace displayfile {

/// The vertices of a map, each once, found by their rounded coordinates.
class MapVertices {
 public:
  /// Reserves capacity for the expected number.
  MapVertices(const LineTable& scene, VisibleMap& map, std::size_t expected)
      : scene_(scene), map_(map), table_(std::bit_ceil(2 * expected + 2), kFree) {}

  /// Records vertices where an edge was ended because another's end might touch it.
  void note_touched(std::uint32_t vertex) { touched_.push_back(vertex); }
  const std::vector<std::uint32_t>& touched() const { return touched_; }

  std::uint32_t number(const MapPlace& place, const Point2& at) {
    if (2 * map_.points.size() >= table_.size()) grow();
    assert(2 * map_.points.size() < table_.size());  // so that a free place ends each search
    assert(map_.places.size() == map_.points.size());
    std::size_t k = first_place(at);
    while (table_[k] != kFree && !is_vertex(table_[k], place, at)) k = next_place(k);
    if (table_[k] == kFree) {
      table_[k] = static_cast<std::uint32_t>(map_.points.size());
      map_.places.push_back(place);
      map_.points.push_back(at);
    }
    return table_[k];
  }

 private:
  static constexpr std::uint32_t kFree = 0xffffffffu;

  bool is_vertex(std::uint32_t vertex, const MapPlace& place, const Point2& at) const {
    if (map_.points[vertex] != at) return false;
    if (map_.places[vertex] == place) return true;
    return compare_xy(scene_, map_.places[vertex], place) == 0;
  }
  std::size_t first_place(const Point2& at) const {
    std::uint64_t h = std::bit_cast<std::uint64_t>(at.x) * 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 32) ^ std::bit_cast<std::uint64_t>(at.y)) * 0xd6e8feb86659fd93u;
    return (h ^ (h >> 32)) & (table_.size() - 1);
  }
  std::size_t next_place(std::size_t k) const { return (k + 1) & (table_.size() - 1); }
  void grow() {
    table_.assign(2 * table_.size(), kFree);
    for (std::uint32_t v = 0; v < map_.points.size(); ++v) {
      std::size_t k = first_place(map_.points[v]);
      while (table_[k] != kFree) k = next_place(k);
      table_[k] = v;
    }
  }

  const LineTable& scene_;
  VisibleMap& map_;
  std::vector<std::uint32_t> table_, touched_;
};

}  // namespace displayfile
