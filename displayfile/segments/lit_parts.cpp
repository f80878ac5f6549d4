#include "displayfile/segments/lit_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "clip/geometry/corners.h"
#include "clip/geometry/rectangle.h"
#include "hidden/exact/orientation.h"
#include "hidden/exact/support_plane.h"
#include "hidden/map/map_pieces.h"
#include "hidden/triangles/convex_turning.h"

namespace displayfile {

namespace {

using Item = ViewedScene::Item;
using Lit = SortedPieces::Lit;
using PlanePoints = Primitives::PlanePoints;

/// Points this close to a plane count as on it and hide no light from it: as a fraction of the
/// plane's change over the picture. The same bound applies to shadow rays
/// (interp/raster/shadows.md).
constexpr double kOnPlane = 0x1p-39;

/// The points of a polygon's support plane. False if it is edge-on.
bool find_plane(const Primitives& items, const Primitives::Item& item, PlanePoints& points) {
  const auto [index, edge_on] = support_vertices(items.points_of(item));
  for (std::size_t k = 0; k < 3; ++k) points[k] = items.point(item.first + index[k]);
  return !edge_on;
}

/// The same plane by points that determine it well everywhere. If a polygon is edge-on up to
/// rounding, rounding has picked the points of the support plane: they may be nearly collinear in
/// space, and are then replaced.
bool find_plane_in_space(const Primitives& items, const Primitives::Item& item,
                         PlanePoints& points) {
  constexpr double kNearlyInLine = 0x1p-10;
  if (!find_plane(items, item, points)) return false;
  if (item.sides == 3) return true;
  PlanePoints spread;
  const auto index = spread_vertices(items.points_of(item)).index;
  for (std::size_t k = 0; k < 3; ++k) spread[k] = items.point(item.first + index[k]);
  const auto twice_area = [&](const PlanePoints& of) {
    const Point3& p = items.points[of[0]];
    return glm::length(glm::cross(items.points[of[1]] - p, items.points[of[2]] - p));
  };
  if (twice_area(points) < kNearlyInLine * twice_area(spread)) points = spread;
  return true;
}

/// True if the light grazes a plane, by three of its points as the light sees them: points found
/// there from the light's view would be off by more than 2^-30 of the polygon.
bool is_grazed(const std::array<Point2, 3>& seen) {
  constexpr double kNoisy = 0x1p-22;
  double longest = 0.0, farthest = 1.0;
  for (std::size_t k = 0; k < 3; ++k) {
    longest = std::max(longest, glm::distance(seen[k], seen[(k + 1) % 3]));
    farthest = std::max(farthest, glm::length(seen[k]));
  }
  const Point2 a = seen[1] - seen[0], b = seen[2] - seen[0];
  return !(std::abs(a.x * b.y - a.y * b.x) > kNoisy * longest * farthest);
}

/// Finds polygons that are coplanar up to rounding, which hide no light from each other.
class PlanesOfLight {
 public:
  explicit PlanesOfLight(const Primitives& items) : items_(items) {
    for (Item i = 0; i < items.items.size(); ++i) {
      planes_.push_back({Primitives::kOwnPlane, 0, 0});
      const Primitives::Item& item = items.items[i];
      PlanePoints points;
      if (item.kind != Primitives::Kind::solid) continue;
      if (!find_plane_in_space(items, item, points)) continue;
      // A view from elsewhere would take other vertices of a polygon that is not flat.
      if (item.sides > 3) planes_.back() = points;
      add(i, points);
    }
    join();
    find_those_below();
  }

  const std::vector<PlanePoints>& planes() const { return planes_; }
  bool are_in_one(Item a, Item b) const {
    return planes_[a][0] != Primitives::kOwnPlane && planes_[a] == planes_[b];
  }
  /// True if a polygon entered later lies over it in the same plane up to rounding, so that the
  /// light seems to reach that one alone, and the viewer may see both.
  bool is_below_another(Item item) const { return below_[item] != 0; }

 private:
  struct Lying {
    Item item;
    PlanePoints points;
    double depth, error;  // of the plane at an arbitrary point
    double size;
  };

  Plane plane(const PlanePoints& points) const {
    return {items_.points[points[0]], items_.points[points[1]], items_.points[points[2]]};
  }

  void add(Item item, const PlanePoints& points) {
    const Plane plane = this->plane(points);
    const Point2 at(0.4142135623730951, 0.7320508075688772);
    const double slope = std::abs(plane.normal.z);
    const double depth =
        plane.p.z - (plane.normal.x * (at.x - plane.p.x) + plane.normal.y * (at.y - plane.p.y)) /
                        plane.normal.z;
    const double error = 4.0 * kOnPlane * plane.reach / slope;
    if (std::isfinite(depth) && std::isfinite(error)) {
      lying_.push_back({item, points, depth, error, plane.reach});
    }
  }

  /// Compares each polygon with the planes of similar depth at that point, which are few apart from
  /// its own. The largest polygon of a plane determines its position.
  void join() {
    std::ranges::sort(lying_, [](const Lying& a, const Lying& b) {
      return a.size != b.size ? a.size > b.size : a.item < b.item;
    });
    std::multimap<double, const Lying*> largest;
    std::map<Item, std::vector<Item>> others;  // of the largest
    for (const Lying& now : lying_) {
      const auto end = largest.upper_bound(now.depth + now.error);
      auto other = largest.lower_bound(now.depth - now.error);
      while (other != end && !lies_in(now.item, plane(other->second->points))) ++other;
      if (other == end) {
        largest.emplace(now.depth, &now);
      } else {
        planes_[now.item] = planes_[other->second->item] = other->second->points;
        others[other->second->item].push_back(now.item);
      }
    }
    for (auto& [item, in_plane] : others) {
      in_plane.push_back(item);
      in_one_plane_.push_back(std::move(in_plane));
    }
  }

  /// Sorts the polygons of each plane by x and compares each with those that begin before it ends.
  void find_those_below() {
    below_.assign(planes_.size(), 0);
    std::vector<std::pair<Rectangle, Item>> boxes;
    for (const std::vector<Item>& items : in_one_plane_) {
      boxes.clear();
      for (const Item i : items) {
        const PointRow points = items_.points_of(items_.items[i]);
        boxes.emplace_back(bounding_rectangle({points.data(), points.size()}), i);
      }
      std::ranges::sort(boxes, [](const auto& a, const auto& b) {
        return std::pair(a.first.x_min, a.second) < std::pair(b.first.x_min, b.second);
      });
      for (std::size_t k = 0; k < boxes.size(); ++k) {
        const Rectangle& box = boxes[k].first;
        for (std::size_t n = k + 1; n < boxes.size() && boxes[n].first.x_min < box.x_max; ++n) {
          const Rectangle& other = boxes[n].first;
          if (other.y_min >= box.y_max || box.y_min >= other.y_max) continue;
          const auto [low, high] = std::minmax(boxes[k].second, boxes[n].second);
          if (below_[low] == 0 && lies_over(low, high)) below_[low] = 1;
        }
      }
    }
  }

  /// True if the two overlap, and are not exactly coplanar.
  bool lies_over(Item low, Item high) const {
    if (has_a_side_between(low, high) || has_a_side_between(high, low)) return false;
    PlanePoints points;
    find_plane_in_space(items_, items_.items[low], points);
    const Plane of_low = plane(points);
    return std::ranges::any_of(items_.points_of(items_.items[high]),
                               [&](const Point3& v) { return side_of_plane(v, of_low) != 0; });
  }
  bool has_a_side_between(Item convex, Item other) const {
    const PointRow points = items_.points_of(items_.items[convex]);
    const PointRow others = items_.points_of(items_.items[other]);
    const std::size_t sides = points.size();
    const auto at = [&](std::size_t k) { return Point2(points[k]); };
    const int way = convex_turning(
        sides,
        [&](std::size_t i, std::size_t j, std::size_t k) {
          return orientation(at(i), at(j), at(k));
        },
        [&](std::size_t i, std::size_t j) { return direction_by_x(at(i), at(j)); });
    if (way == 0) return false;
    for (std::size_t k = 0; k < sides; ++k) {
      const Point2 p = at(k), q = at(next_corner(k, sides));
      if (std::ranges::all_of(
              others, [&](const Point3& v) { return orientation(p, q, Point2(v)) * way <= 0; })) {
        return true;
      }
    }
    return false;
  }

  bool lies_in(Item item, const Plane& plane) const {
    return std::ranges::all_of(items_.points_of(items_.items[item]), [&](const Point3& v) {
      return std::abs(plane_value(v, plane).value) <= kOnPlane * plane.reach;
    });
  }

  const Primitives& items_;
  std::vector<PlanePoints> planes_;
  std::vector<Lying> lying_;
  std::vector<std::vector<Item>> in_one_plane_;
  std::vector<std::uint8_t> below_;
};

/// A scene's polygons, where each polygon of which the light reaches a part is replaced by the same
/// polygon in shadow, with its lit parts before it, in its plane.
class LitItems {
 public:
  LitItems(const ViewedScene& scene, const Primitives& items)
      : scene_(scene), items_(items), points_(items.points.begin(), items.points.end()) {
    reached_.assign(items.items.size(), Reached{});
  }

  /// Finds the parts that this light reaches, of the items that show its shadows.
  void look_from(const HomogeneousPoint& light, const PlanesOfLight& planes,
                 const MapOptions& options) {
    std::vector<Point3> solid;
    for (const Primitives::Item& item : items_.items) {
      if (item.kind != Primitives::Kind::solid) continue;
      for (std::uint32_t k = 0; k < item.sides; ++k) {
        solid.push_back(items_.points[items_.point(item.first + k)]);
      }
    }
    const auto view = LightProjection::of(light, solid);
    if (!view) return;
    std::vector<Point3> seen;
    seen.reserve(items_.points.size());
    for (const Point3& p : items_.points) {
      const Point3 at = (*view)(p);
      seen.push_back(in_range(at) ? at : Point3(0.0));  // of a line, which hides nothing
    }
    Primitives lit = items_;
    lit.points = seen;
    lit.visible = {};
    lit.planes = planes.planes();
    lit.plane_rests = {};  // valid for the picture only
    const VisibleMap map = visible_map(lit, options);
    const SortedPieces pieces = pieces_of_map(lit, map);
    std::size_t k = 0;
    for (Item i = 0; i < items_.items.size(); ++i) {
      const std::size_t first = k;
      while (k < pieces.pieces.size() && pieces.pieces[k].item == i) ++k;
      const FillShadow* const shadow = shadow_of(i);
      if (shadow == nullptr || shadow->light != light) continue;
      const auto parts = std::span(pieces.pieces).subspan(first, k - first);
      reached_[i].lit = parts.empty() ? Lit::in_shadow : Lit::lit;
      if (planes.is_below_another(i) && map.whole[i] == 0) {
        const SortedPieces lit_of_item = not_covered(i, planes, lit, pieces, options);
        reached_[i].lit = lit_of_item.pieces.empty() ? Lit::in_shadow : Lit::lit;
        add_parts(i, lit_of_item.pieces, lit_of_item, seen, *view);
        continue;
      }
      if (parts.empty() || map.whole[i] != 0) continue;
      add_parts(i, parts, pieces, seen, *view);
    }
  }

  /// The pieces of the map of this scene, as pieces of the original items.
  SortedPieces pieces(const MapOptions& options) {
    build();
    const Primitives all{points_, corners_, visible_, all_, planes_};
    SortedPieces sorted = pieces_of_map(all, visible_map(all, options));
    for (SortedPiece& piece : sorted.pieces) {
      const Source& source = sources_[piece.item];
      if (source.is_part && piece.first == SortedPiece::kWhole) {
        piece.first = static_cast<std::uint32_t>(sorted.points.size());
        const Primitives::Item& part = all_[piece.item];
        for (std::uint32_t c = 0; c < part.sides; ++c) {
          sorted.points.push_back(points_[corners_[part.first + c]]);
          sorted.visible.push_back(0);
        }
      }
      piece.item = source.item;
      sorted.lights.push_back(source.lit);
    }
    return sorted;
  }

  const FillShadow* shadow_of(Item item) const {
    return items_.items[item].kind == Primitives::Kind::solid ? scene_.shadow_of_item(item)
                                                              : nullptr;
  }

 private:
  struct Reached {
    Lit lit = Lit::unknown;
    std::size_t first_part = 0, parts = 0;  // if a part only
    PlanePoints plane{};
  };
  struct Source {
    Item item;
    Lit lit;
    bool is_part;
  };

  /// The part of an item that the light reaches if others in its plane do not cover it.
  static SortedPieces not_covered(Item i, const PlanesOfLight& planes, const Primitives& items,
                                  const SortedPieces& pieces, const MapOptions& options) {
    std::vector<Point3> points;
    std::vector<Primitives::Item> own;
    const auto add = [&](std::span<const Point3> outline, double depth) {
      own.push_back({static_cast<std::uint32_t>(points.size()),
                     static_cast<std::uint32_t>(outline.size()), Primitives::Kind::solid});
      for (const Point3& p : outline) points.emplace_back(p.x, p.y, depth);
    };
    const auto row = [](const PointRow& r) { return std::span(r.data(), r.size()); };
    const PointRow corners = items.points_of(items.items[i]);
    const Rectangle box = bounding_rectangle(row(corners));
    add(row(corners), 0.0);
    const auto add_before = [&](std::span<const Point3> outline) {
      const Rectangle other = bounding_rectangle(outline);
      const bool apart = other.x_min >= box.x_max || box.x_min >= other.x_max ||
                         other.y_min >= box.y_max || box.y_min >= other.y_max;
      if (!apart) add(outline, 1.0);
    };
    for (const SortedPiece& piece : pieces.pieces) {
      if (piece.item == i || planes.are_in_one(piece.item, i)) continue;
      if (piece.first == SortedPiece::kWhole) {
        add_before(row(items.points_of(items.items[piece.item])));
      } else {
        add_before(std::span(pieces.points).subspan(piece.first, piece.sides));
      }
    }
    const Primitives all{points, {}, {}, own};
    SortedPieces seen = pieces_of_map(all, visible_map(all, options));
    std::erase_if(seen.pieces, [](const SortedPiece& piece) { return piece.item != 0; });
    return seen;
  }

  void add_parts(Item i, std::span<const SortedPiece> parts, const SortedPieces& pieces,
                 const std::vector<Point3>& seen, const LightProjection& view) {
    Reached& reached = reached_[i];
    const Primitives::Item& item = items_.items[i];
    if (!find_plane(items_, item, reached.plane)) return;
    PlanePoints in_space;
    find_plane_in_space(items_, item, in_space);
    const std::array from_light{Point2(seen[in_space[0]]), Point2(seen[in_space[1]]),
                                Point2(seen[in_space[2]])};
    if (is_grazed(from_light)) return;  // lit as a whole
    reached.first_part = part_first_.size();
    for (const SortedPiece& part : parts) {
      const std::size_t begin = part_corners_.size();
      for (std::uint32_t c = 0; c < part.sides; ++c) {
        const std::uint32_t point =
            part.first == SortedPiece::kWhole
                ? items_.point(item.first + c)
                : device_point(item, in_space, Point2(pieces.points[part.first + c]), seen, view);
        part_corners_.push_back(point);
      }
      part_first_.push_back(begin);
      ++reached.parts;
    }
  }

  /// The point of the polygon at that position as seen from the light: one of its vertices, or
  /// otherwise the corresponding combination of three of them.
  std::uint32_t device_point(const Primitives::Item& item, const PlanePoints& plane,
                             const Point2& at, const std::vector<Point3>& seen,
                             const LightProjection& view) {
    for (std::uint32_t c = 0; c < item.sides; ++c) {
      const std::uint32_t corner = items_.point(item.first + c);
      if (Point2(seen[corner]) == at) return corner;
    }
    const auto cross = [](const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; };
    std::array<Point2, 3> from_it;
    for (std::size_t k = 0; k < 3; ++k) from_it[k] = Point2(seen[plane[k]]) - at;
    Point3 sum(0.0);
    double weights = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3& vertex = items_.points[plane[k]];
      const double weight = cross(from_it[(k + 1) % 3], from_it[(k + 2) % 3]) / view.weight(vertex);
      sum += weight * vertex;
      weights += weight;
    }
    points_.push_back(sum / weights);
    return static_cast<std::uint32_t>(points_.size() - 1);
  }

  void build() {
    for (Item i = 0; i < items_.items.size(); ++i) {
      const Primitives::Item& item = items_.items[i];
      const Reached& reached = reached_[i];
      add(i, reached.parts > 0 ? Lit::in_shadow : reached.lit, item);
      for (std::size_t p = reached.first_part; p < reached.first_part + reached.parts; ++p) {
        const std::size_t end =
            p + 1 < part_first_.size() ? part_first_[p + 1] : part_corners_.size();
        add_part(i, reached.plane,
                 std::span(part_corners_).subspan(part_first_[p], end - part_first_[p]));
      }
    }
  }
  void add(Item i, Lit lit, const Primitives::Item& item) {
    const auto first = static_cast<std::uint32_t>(corners_.size());
    for (std::uint32_t c = item.first; c < item.first + item.sides; ++c) {
      corners_.push_back(items_.point(c));
      visible_.push_back(items_.visible_at(c));
    }
    all_.push_back({first, item.sides, item.kind});
    planes_.push_back(items_.has_own_plane(i) ? PlanePoints{Primitives::kOwnPlane, 0, 0}
                                              : items_.planes[i]);
    sources_.push_back({i, lit, false});
  }
  void add_part(Item i, const PlanePoints& plane, std::span<const std::uint32_t> corners) {
    const auto first = static_cast<std::uint32_t>(corners_.size());
    corners_.insert(corners_.end(), corners.begin(), corners.end());
    visible_.resize(corners_.size(), 0);
    all_.push_back({first, static_cast<std::uint32_t>(corners.size()), Primitives::Kind::solid});
    planes_.push_back(items_.has_own_plane(i) ? plane : items_.planes[i]);
    sources_.push_back({i, Lit::lit, true});
  }

  const ViewedScene& scene_;
  const Primitives& items_;
  std::vector<Reached> reached_;         // of the items
  std::vector<std::size_t> part_first_;  // of all lit parts
  std::vector<std::uint32_t> part_corners_;
  // The items and their parts.
  std::vector<Point3> points_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::uint8_t> visible_;
  std::vector<Primitives::Item> all_;
  std::vector<PlanePoints> planes_;
  std::vector<Source> sources_;
};

}  // namespace

SortedPieces lit_pieces_of_map(const ViewedScene& scene, const Primitives& items,
                               const MapOptions& options) {
  LitItems lit(scene, items);
  const PlanesOfLight planes(items);
  std::vector<HomogeneousPoint> lights;
  for (Item i = 0; i < items.items.size(); ++i) {
    const FillShadow* const shadow = lit.shadow_of(i);
    if (shadow == nullptr || std::ranges::find(lights, shadow->light) != lights.end()) continue;
    lights.push_back(shadow->light);
    lit.look_from(shadow->light, planes, options);
  }
  return lit.pieces(options);
}

}  // namespace displayfile
