#include "interp/visibility/line_picker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "clip/geometry/corners.h"
#include "clip/geometry/rectangle.h"
#include "displayfile/segments/scene_lines.h"
#include "hidden/exact/defined_point.h"
#include "hidden/exact/support_plane.h"

namespace displayfile {

namespace {

/// A visible piece shorter than this fraction of the picture may be a result of rounding
/// (interp/truth/truth.md).
constexpr double kCrumb = 1e-9;
/// Parts of a line shorter than this fraction of it are not examined: doubles hardly distinguish
/// their ends.
constexpr double kShortestPart = 0x1p-50;
/// In pixels: distances closer than this belong to the same point, computed twice.
constexpr double kSameDistance = 1e-6;

}  // namespace

/// A line with its ends by the rule of lines: those of a side lie on the plane of its polygon.
struct LinePicker::Line {
  std::array<Point3, 2> stored;
  Plane own;            ///< if lifted
  bool lifted = false;  ///< off that plane, and projected on to it
  std::array<DefinedPoint, 2> ends;
  Item item = 0;
  Fill fill = ViewedScene::kBackground;

  Definitions definitions() const { return {stored, {&own, 1}}; }
  Point2 from() const { return Point2(stored[0]); }
  Point2 to() const { return Point2(stored[1]); }
  double depth(double t) const { return ends[0].near.z + t * (ends[1].near.z - ends[0].near.z); }
};

/// A fill that is nearer than the line somewhere, or drawn over it.
struct LinePicker::Hider {
  LinePart nearer;  ///< where its plane is, or where it is drawn over the line
  /// The parameters at which a point that moves along the line, close to it on its left or right,
  /// enters or leaves the fill.
  std::array<std::vector<double>, 2> crossings;

  bool covers(int side, double t) const {
    const auto& all = crossings[static_cast<std::size_t>(side)];
    return std::ranges::count_if(all, [&](double c) { return c > t; }) % 2 == 1;
  }
};

LinePicker::LinePicker(const ViewedScene& scene, const PictureSize& size, int threads,
                       DrawnLayers layers)
    : scene_(scene), size_(size), layers_(std::move(layers)) {
  enter_lines(threads);
  if (!entries_.empty()) enter_fills(threads);
}

/// All pixels reached by a rectangle with these corners (device coordinates) and a margin in
/// pixels; positions beyond the picture are clamped to just outside of its border.
PixelBox LinePicker::box_of(const Point2& low, const Point2& high, double margin) const {
  const auto pixel = [&](double device, int pixels, double reach) {
    return static_cast<std::int32_t>(
        std::floor(std::clamp(device * pixels + reach, -2.0, pixels + 2.0)));
  };
  const double beyond = margin + 1.0;
  return {pixel(low.x, size_.width, -beyond), pixel(high.x, size_.width, beyond) + 1,
          pixel(low.y, size_.height, -beyond), pixel(high.y, size_.height, beyond) + 1};
}

/// In pixels.
double LinePicker::half_width(const Entry& entry) const {
  const LineKinds kinds = scene_.side_kinds(entry.item, entry.to);
  return style_of_stroke(scene_, entry.item, kinds).width / 2.0;
}

void LinePicker::enter_lines(int threads) {
  Fill next = 1;
  for (Item item = 0; item < scene_.items(); ++item) {
    const bool is_fill = next < scene_.end() && scene_.item_of(next) == item;
    const Fill fill = is_fill ? next++ : ViewedScene::kBackground;
    if (scene_.line_style(item).kind == LineStyle::Kind::none) continue;
    const auto points = static_cast<std::uint32_t>(scene_.points(item).size());
    const bool line = scene_.kind(item) == Primitives::Kind::line;
    for (std::uint32_t to = line ? 1 : 0; to < points; ++to) {
      if (line || scene_.edge_visible(item, to)) entries_.push_back({item, to, fill});
    }
  }
  lines_.build(
      entries_.size(),
      [&](PixelTree::Item i) {
        const Entry& entry = entries_[i];
        const auto points = scene_.points(entry.item);
        const Point2 to(points[entry.to]);
        const Point2 from(points[previous_corner<std::size_t>(entry.to, points.size())]);
        const double margin = half_width(entry);
        return DeepPixelBox{box_of(glm::min(from, to), glm::max(from, to), margin), 0.0F};
      },
      threads);
}

void LinePicker::enter_fills(int threads) {
  fills_.build(
      scene_.end() - 1,
      [&](PixelTree::Item i) {
        const Rectangle around = bounding_rectangle(scene_.vertices(i + 1));
        return DeepPixelBox{box_of({around.x_min, around.y_min}, {around.x_max, around.y_max}, 0.0),
                            0.0F};
      },
      threads);
}

LinePicker::Line LinePicker::line_of(const Entry& entry) const {
  const auto points = scene_.points(entry.item);
  const Point3& from = points[previous_corner<std::size_t>(entry.to, points.size())];
  Line line;
  line.stored = {from, points[entry.to]};
  line.ends = {stored_point(line.stored[0]), stored_point(line.stored[1])};
  line.item = entry.item;
  line.fill = entry.fill;
  if (points.size() <= 3) return line;
  const auto [support, edge_on] = support_vertices(points);
  if (edge_on) return line;
  const auto* const of_bent = scene_.plane_of_bent(entry.item);
  line.own = of_bent != nullptr ? scene_.plane_through(*of_bent)
                                : Plane(points[support[0]], points[support[1]], points[support[2]]);
  const auto is_off = [&](const Point3& p) { return side_of_plane(p, line.own) != 0; };
  line.lifted = is_off(line.stored[0]) || is_off(line.stored[1]);
  if (!line.lifted || facing(line.own) == 0) return line;
  for (std::uint32_t k = 0; k < 2; ++k) line.ends[k] = lifted_point(line.definitions(), k, 0);
  return line;
}

/// The part of the line that is in the picture and within `reach` of the point.
std::optional<LinePart> LinePicker::stretch_within(const Line& line, const Point2& at,
                                                   double reach) const {
  const Point2 from = pixel(line.stored[0]), to = pixel(line.stored[1]), along = to - from;
  const double length = glm::length(along);
  if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
  const Point2 direction = along / length, to_point = at - from;
  const double nearest = glm::dot(to_point, direction);
  const double aside = std::abs(direction.x * to_point.y - direction.y * to_point.x);
  if (aside > reach) return std::nullopt;
  const double half = std::sqrt(reach * reach - aside * aside);
  return part_in_rectangle(
      from, to, {0.0, static_cast<double>(size_.width), 0.0, static_cast<double>(size_.height)},
      {std::max(0.0, (nearest - half) / length), std::min(1.0, (nearest + half) / length)});
}

/// The whole line if the fill is drawn over it, otherwise the part where the fill's plane is
/// nearer.
std::optional<LinePart> LinePicker::part_before(const Line& line, Fill fill) const {
  switch (layers_.hides(scene_.item_of(fill), line.item)) {
    case DrawnLayers::Hides::nowhere: return std::nullopt;
    case DrawnLayers::Hides::where_it_covers: return LinePart{0.0, 1.0};
    case DrawnLayers::Hides::where_nearer: break;
  }
  const Plane plane = scene_.plane(fill);
  const int toward_viewer = facing(plane);
  const auto before = [&](const DefinedPoint& end) {
    return side_of_plane(line.definitions(), end, plane) * toward_viewer;
  };
  const int from = before(line.ends[0]), to = before(line.ends[1]);
  if (from >= 0 && to >= 0) return std::nullopt;
  LinePart nearer{0.0, 1.0};
  if (from > 0 || to > 0) {
    const double a = std::abs(plane_value(line.ends[0].near, plane).value);
    const double b = std::abs(plane_value(line.ends[1].near, plane).value);
    const double meets = a + b > 0.0 ? a / (a + b) : 0.5;
    (from > 0 ? nearer.from : nearer.to) = meets;
  }
  return nearer;
}

/// None if the fill hides no part of the line.
std::optional<LinePicker::Hider> LinePicker::hider(const Line& line, Fill fill) const {
  const auto before = part_before(line, fill);
  if (!before) return std::nullopt;
  Hider hider{*before, {}};

  const Point2 start = line.from(), along = line.to() - start;
  const double square = glm::dot(along, along);
  const auto vertices = scene_.vertices(fill);
  struct Vertex {
    double t;         // along the line
    double distance;  // from it, times its length
    int side;
  };
  const auto place = [&](const Point3& v) {
    const Point2 p(v);
    return Vertex{glm::dot(p - start, along) / square,
                  std::abs(orientation_value(start, line.to(), p).determinant),
                  orientation(start, line.to(), p)};
  };
  Vertex p = place(vertices.back());
  for (const Point3& vertex : vertices) {
    const Vertex q = place(vertex);
    const std::array<bool, 2> crosses{(p.side > 0) != (q.side > 0), (p.side < 0) != (q.side < 0)};
    if (crosses[0] || crosses[1]) {
      const double all = p.distance + q.distance;
      const double t = p.side == 0   ? p.t
                       : q.side == 0 ? q.t
                       : all > 0.0   ? p.t + (q.t - p.t) * (p.distance / all)
                                     : (p.t + q.t) / 2.0;
      for (std::size_t side = 0; side < 2; ++side) {
        if (crosses[side]) hider.crossings[side].push_back(t);
      }
    }
    p = q;
  }
  return hider;
}

std::vector<LinePicker::Hider> LinePicker::hiders_of(const Line& line,
                                                     const LinePart& stretch) const {
  const Point2 along = line.to() - line.from();
  const Point2 a = line.from() + stretch.from * along, b = line.from() + stretch.to * along;
  const PixelBox reached = box_of(glm::min(a, b), glm::max(a, b), 0.0);
  std::vector<Hider> all;
  fills_.any([&](const PixelBoxes& boxes) { return boxes.meets(reached); },
             [&](PixelTree::Position position) {
               const Fill fill = fills_.order()[position] + 1;
               if (fill == line.fill) return false;
               if (auto found = hider(line, fill)) all.push_back(std::move(*found));
               return false;
             });
  return all;
}

/// The parts of the stretch that no fill hides, on at least one side. For a stretch that is a
/// point, the visibility of the line close to it.
std::vector<LinePart> LinePicker::seen_parts(const Line& line, const LinePart& part) const {
  const double crumb =
      std::max(kCrumb / std::max(glm::distance(line.from(), line.to()), kCrumb), kShortestPart);
  const bool is_point = part.to - part.from <= crumb;
  const LinePart stretch =
      is_point ? LinePart{std::max(0.0, part.from - crumb), std::min(1.0, part.to + crumb)} : part;
  const std::vector<Hider> hiders = hiders_of(line, stretch);
  std::vector<double> changes{stretch.from, stretch.to};
  const auto add = [&](double t) {
    if (t > stretch.from && t < stretch.to) changes.push_back(t);
  };
  for (const Hider& hider : hiders) {
    add(hider.nearer.from);
    add(hider.nearer.to);
    for (const auto& of_side : hider.crossings) std::ranges::for_each(of_side, add);
  }
  std::ranges::sort(changes);
  const auto hidden = [&](double t) {
    std::array<bool, 2> on_side{};
    for (const Hider& hider : hiders) {
      if (!(t > hider.nearer.from && t < hider.nearer.to)) continue;
      for (int side = 0; side < 2; ++side) {
        bool& covered = on_side[static_cast<std::size_t>(side)];
        covered = covered || hider.covers(side, t);
      }
    }
    return on_side[0] && on_side[1];
  };
  std::vector<LinePart> parts;
  for (std::size_t i = 0; i + 1 < changes.size(); ++i) {
    const double from = changes[i], to = changes[i + 1];
    if (from == to || hidden(from + (to - from) / 2.0)) continue;
    if (!parts.empty() && parts.back().to == from) {
      parts.back().to = to;
    } else {
      parts.push_back({from, to});
    }
  }
  if (!is_point) {
    std::erase_if(parts, [&](const LinePart& seen) { return seen.to - seen.from < crumb; });
  }
  return parts;
}

std::optional<LinePicker::Found> LinePicker::nearest(const Point2& at, double reach,
                                                     Fill seen_there) const {
  struct Candidate {
    Found found;
    std::uint32_t entry;
    bool of_seen;
  };
  std::vector<Candidate> all;
  const Point2 device(at.x / size_.width, at.y / size_.height);
  const PixelBox reached = box_of(device, device, reach);
  const auto look = [&](PixelTree::Position position) {
    const std::uint32_t number = lines_.order()[position];
    const Entry& entry = entries_[number];
    const Line line = line_of(entry);
    const double far = std::max(reach, half_width(entry));
    const auto stretch = stretch_within(line, at, far);
    if (!stretch) return false;
    const Point2 from = pixel(line.stored[0]), along = pixel(line.stored[1]) - from;
    const double nearest = glm::dot(at - from, along) / glm::dot(along, along);
    for (const LinePart& part : seen_parts(line, *stretch)) {
      const double t = std::clamp(nearest, part.from, part.to);
      const bool is_edge = scene_.kind(entry.item) != Primitives::Kind::line;
      const bool of_seen = entry.fill != ViewedScene::kBackground && entry.fill == seen_there;
      all.push_back({{entry.item, is_edge, glm::distance(at, from + t * along), line.depth(t)},
                     number,
                     of_seen});
    }
    return false;
  };
  lines_.any([&](const PixelBoxes& boxes) { return boxes.meets(reached); }, look);
  if (all.empty()) return std::nullopt;
  const auto distance = [](const Candidate& c) { return c.found.distance; };
  const double least = distance(*std::ranges::min_element(all, {}, distance));
  const Candidate* best = nullptr;
  const auto better = [this](const Candidate& a, const Candidate& b) {
    if (layers_.is_over(a.found.item, b.found.item)) return true;
    if (layers_.is_over(b.found.item, a.found.item)) return false;
    if (a.of_seen != b.of_seen) return a.of_seen;
    if (a.found.depth != b.found.depth) return a.found.depth > b.found.depth;
    return a.entry > b.entry;
  };
  for (const Candidate& candidate : all) {
    if (candidate.found.distance > least + kSameDistance) continue;
    if (best == nullptr || better(candidate, *best)) best = &candidate;
  }
  return best->found;
}

}  // namespace displayfile
