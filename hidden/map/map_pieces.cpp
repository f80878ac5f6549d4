#include "hidden/map/map_pieces.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "hidden/exact/precision_policies.h"
#include "hidden/exact/support_plane.h"
#include "hidden/map/ways_from_vertex.h"

namespace displayfile {

namespace {

/// An edge as part of the outline of the item visible on its left.
struct Side {
  std::uint32_t from, to;
};

/// The sides of each item's parts.
class SidesOfItems {
 public:
  SidesOfItems(std::size_t items, const VisibleMap& map) : first_(items + 1, 0) {
    const auto count = [&](std::uint32_t item) {
      if (item != VisibleMap::kNothing) ++first_[item + 1];
    };
    for (const VisibleMap::Edge& edge : map.edges) {
      count(edge.left);
      count(edge.right);
    }
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    sides_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const auto& [from, to, left, right] : map.edges) {
      assert(from != to && from < map.points.size() && to < map.points.size());
      if (left != VisibleMap::kNothing) sides_[next[left]++] = {from, to};
      if (right != VisibleMap::kNothing) sides_[next[right]++] = {to, from};
    }
  }

  std::span<Side> of(std::uint32_t item) {
    return std::span(sides_).subspan(first_[item], first_[item + 1] - first_[item]);
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<Side> sides_;
};

/// Follows the sides of items' parts, one item at a time.
class Outlines {
 public:
  Outlines(const Primitives& items, const VisibleMap& map) : map_(map), ways_(items, map) {}

  /// The vertices of a closed line with the part on its left. No two successive vertices are
  /// rounded alike, and at none the line turns back to the previous vertex.
  struct Loop {
    std::vector<std::uint32_t> vertices;
    double area;  ///< twice the area; negative for a hole
  };

  /// The parts of an item: one outline each, joined to its holes.
  const std::vector<Loop>& parts_of(std::span<Side> sides) {
    find_loops(sides);
    parts_.clear();
    std::vector<std::size_t> holes;
    for (std::size_t k = 0; k < loops_.size(); ++k) {
      if (loops_[k].area > 0.0) {
        parts_.push_back(std::move(loops_[k]));
      } else if (loops_[k].area < 0.0) {
        holes.push_back(k);
      }
    }
    for (const std::size_t hole : holes) join(loops_[hole].vertices);
    return parts_;
  }

 private:
  struct Middle {
    double length;  // of the side, squared
    Point2 at;
  };

  const Point2& at(std::uint32_t vertex) const { return map_.points[vertex]; }

  void find_loops(std::span<Side> sides) {
    loops_.clear();
    std::ranges::sort(sides, [](const Side& s, const Side& t) {
      return s.from != t.from ? s.from < t.from : s.to < t.to;
    });
    used_.assign(sides.size(), 0);
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (used_[k] == 0) follow(sides, k);
    }
  }

  /// Follows the line from a side until it closes.
  void follow(std::span<const Side> sides, std::size_t start) {
    std::vector<std::uint32_t> vertices;
    for (std::size_t k = start; k < sides.size() && used_[k] == 0; k = next_of(sides, k)) {
      used_[k] = 1;
      const std::uint32_t vertex = sides[k].to;
      if (vertices.size() > 1 && at(vertices.end()[-2]) == at(vertex)) {
        vertices.pop_back();  // the detour there and back is due to rounding
      } else if (vertices.empty() || at(vertices.back()) != at(vertex)) {
        vertices.push_back(vertex);
      }
    }
    close(vertices);
    if (vertices.size() < 3) return;
    const double area = area_of(vertices);
    loops_.push_back({std::move(vertices), area});
  }

  /// Removes the same cases where the line returns to its start.
  void close(std::vector<std::uint32_t>& vertices) const {
    std::size_t first = 0;
    while (vertices.size() > first + 2) {
      const Point2 &start = at(vertices[first]), &end = at(vertices.back());
      if (start == end || at(vertices.end()[-2]) == start) {
        vertices.pop_back();
      } else if (at(vertices[first + 1]) == end) {
        ++first;
      } else {
        break;
      }
    }
    vertices.erase(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(first));
  }

  /// The next side. If several start at the vertex, it is the first clockwise from the way back,
  /// which keeps to the same part.
  std::size_t next_of(std::span<const Side> sides, std::size_t k) const {
    const auto begin = std::ranges::lower_bound(sides, sides[k].to, {}, &Side::from);
    const auto end = std::ranges::upper_bound(sides, sides[k].to, {}, &Side::from);
    const auto first = static_cast<std::size_t>(begin - sides.begin());
    const auto last = static_cast<std::size_t>(end - sides.begin());
    if (last == first + 1) return first;
    const std::uint32_t vertex = sides[k].to, back = sides[k].from;
    std::size_t best = sides.size();
    for (std::size_t i = first; i < last; ++i) {
      if (used_[i] != 0) continue;
      if (best == sides.size() || ways_.comes_before(vertex, back, sides[i].to, sides[best].to)) {
        best = i;
      }
    }
    return best;
  }

  double area_of(std::span<const std::uint32_t> vertices) const {
    double area = 0.0;
    const Point2& origin = at(vertices[0]);
    for (std::size_t k = 1; k + 1 < vertices.size(); ++k) {
      const Point2 p = at(vertices[k]) - origin, q = at(vertices[k + 1]) - origin;
      area += p.x * q.y - p.y * q.x;
    }
    return area;
  }

  /// Joins a hole to the smallest outline around it.
  void join(const std::vector<std::uint32_t>& hole) {
    Loop* around = nullptr;
    if (parts_.size() > 1) find_middles(hole);
    for (Loop& part : parts_) {
      const bool smaller = around == nullptr || part.area < around->area;
      if (smaller && (parts_.size() == 1 || has_hole_inside(part.vertices))) around = &part;
    }
    if (around == nullptr) return;
    // Joined from its lowest vertex to the closest one of the outline.
    const auto lowest = std::ranges::min_element(hole, [&](std::uint32_t v, std::uint32_t w) {
      return std::pair(at(v).x, at(v).y) < std::pair(at(w).x, at(w).y);
    });
    std::vector<std::uint32_t>& outline = around->vertices;
    const auto distance = [&](std::uint32_t v) {
      const Point2 apart = at(v) - at(*lowest);
      return apart.x * apart.x + apart.y * apart.y;
    };
    const auto closest = std::ranges::min_element(outline, {}, distance);
    joined_.assign(outline.begin(), closest + 1);
    joined_.insert(joined_.end(), lowest, hole.end());
    joined_.insert(joined_.end(), hole.begin(), lowest + 1);
    joined_.insert(joined_.end(), closest, outline.end());
    if (at(*closest) == at(*lowest)) {  // they touch: no connecting side
      joined_.clear();
      joined_.insert(joined_.end(), outline.begin(), closest);
      joined_.insert(joined_.end(), lowest, hole.end());
      joined_.insert(joined_.end(), hole.begin(), lowest);
      joined_.insert(joined_.end(), closest, outline.end());
    }
    std::swap(outline, joined_);
  }

  /// Finds the middles of a hole's three longest sides. A corner may touch the outline, and
  /// rounding may have put it outside.
  void find_middles(const std::vector<std::uint32_t>& hole) {
    assert(hole.size() >= 3);
    middles_.clear();
    std::uint32_t before = hole.back();
    for (const std::uint32_t v : hole) {
      const Point2 &p = at(before), &q = at(v), side = q - p;
      middles_.push_back({side.x * side.x + side.y * side.y, 0.5 * (p + q)});
      before = v;
    }
    std::partial_sort(middles_.begin(), middles_.begin() + 3, middles_.end(),
                      [](const Middle& a, const Middle& b) {
                        return std::tuple(a.length, a.at.x, a.at.y) >
                               std::tuple(b.length, b.at.x, b.at.y);
                      });
  }

  /// True if at least two of the three middles are inside. If a side runs along the outline within
  /// rounding, its middle is only one of the three, or the area that the other two enclose is due
  /// to rounding.
  bool has_hole_inside(const std::vector<std::uint32_t>& outline) const {
    assert(middles_.size() >= 3);
    const bool first = is_inside(outline, middles_[0].at);
    return first == is_inside(outline, middles_[1].at) ? first : is_inside(outline, middles_[2].at);
  }

  bool is_inside(const std::vector<std::uint32_t>& outline, const Point2& c) const {
    bool inside = false;
    std::uint32_t before = outline.back();
    for (const std::uint32_t w : outline) {
      const Point2 &p = at(before), &q = at(w);
      if ((p.y > c.y) != (q.y > c.y) && (orientation(p, q, c) > 0) == (q.y > p.y)) {
        inside = !inside;
      }
      before = w;
    }
    return inside;
  }

  const VisibleMap& map_;
  WaysFromVertex ways_;
  std::vector<std::uint8_t> used_;
  std::vector<Loop> loops_, parts_;
  std::vector<std::uint32_t> joined_;
  std::vector<Middle> middles_;
};

/// Makes the pieces of items' parts.
class PieceMaker {
 public:
  PieceMaker(const Primitives& items, const VisibleMap& map, SortedPieces& sorted)
      : items_(items), map_(map), sorted_(sorted) {}

  void add_whole(std::uint32_t item) {
    sorted_.pieces.push_back({item, SortedPiece::kWhole, items_.items[item].sides});
  }

  void add(std::uint32_t item, std::span<const std::uint32_t> vertices) {
    assert(vertices.size() >= 3);
    if (item != item_) begin_item(item);
    sorted_.pieces.push_back({item, static_cast<std::uint32_t>(sorted_.points.size()),
                              static_cast<std::uint32_t>(vertices.size())});
    for (const std::uint32_t vertex : vertices) {
      sorted_.points.push_back(point(map_.points[vertex]));
      sorted_.visible.push_back(0);
    }
  }

 private:
  void begin_item(std::uint32_t item) {
    item_ = item;
    const PointRow points = items_.points_of(items_.items[item]);
    points_.assign(points.begin(), points.end());
    if (items_.has_own_plane(item)) {
      const auto& [p, q, r] = support_vertices(points_).index;
      plane_ = Plane(points_[p], points_[q], points_[r]);
    } else {
      const auto& [p, q, r] = items_.planes[item];
      plane_ = Plane(items_.points[p], items_.points[q], items_.points[r]);
    }
  }

  Point3 point(const Point2& at) const {
    for (const Point3& corner : points_) {
      if (corner.x == at.x && corner.y == at.y) return corner;
    }
    return {at.x, at.y, Roundoff::depth(plane_, {at.x, at.y, 0.0})};
  }

  const Primitives& items_;
  const VisibleMap& map_;
  SortedPieces& sorted_;
  std::uint32_t item_ = VisibleMap::kNothing;
  std::vector<Point3> points_;  // of the current item
  Plane plane_;
};

bool draws_no_side(const Primitives& items, const Primitives::Item& item) {
  for (std::uint32_t k = 0; k < item.sides; ++k) {
    if (items.is_visible(item.first + k)) return false;
  }
  return true;
}

}  // namespace

SortedPieces pieces_of_map(const Primitives& items, const VisibleMap& map) {
  assert(map.whole.size() == items.items.size());
  SortedPieces sorted;
  SidesOfItems sides(items.items.size(), map);
  Outlines outlines(items, map);
  PieceMaker maker(items, map, sorted);
  for (std::uint32_t i = 0; i < items.items.size(); ++i) {
    const std::span<Side> of_item = sides.of(i);
    if (of_item.empty()) continue;
    const Primitives::Item& item = items.items[i];
    if (map.whole[i] != 0 && of_item.size() == item.sides && draws_no_side(items, item)) {
      maker.add_whole(i);
      continue;
    }
    for (const auto& part : outlines.parts_of(of_item)) maker.add(i, part.vertices);
  }
  return sorted;
}

}  // namespace displayfile
