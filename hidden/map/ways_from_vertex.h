#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "hidden/lines/line_table.h"
#include "hidden/map/visible_map.h"

namespace displayfile {

/// The true order of a map's edges around a vertex: rounding the vertices may put an edge on
/// another, or beyond it.
class WaysFromVertex {
 public:
  /// Both must outlive it.
  WaysFromVertex(const Primitives& items, const VisibleMap& map) : items_(items), map_(map) {}

  /// True if, turning clockwise at a vertex from the way back to another, the way to p comes before
  /// that to q. The way back's own direction comes last.
  bool comes_before(std::uint32_t vertex, std::uint32_t back, std::uint32_t p,
                    std::uint32_t q) const;

 private:
  /// 1 if the way from the vertex to q is left of that to p, -1 if right, 0 if they are on one
  /// line.
  int turn(std::uint32_t vertex, std::uint32_t p, std::uint32_t q) const;
  bool is_same_way(std::uint32_t vertex, std::uint32_t p, std::uint32_t q) const;
  const LineTable& scene() const;

  const Primitives& items_;
  const VisibleMap& map_;
  mutable std::optional<LineTable> scene_;  // made if rounded vertices do not decide
};

}  // namespace displayfile
