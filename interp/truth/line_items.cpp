#include "interp/truth/line_items.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "clip/base/error.h"

namespace displayfile {

/// Enters a segment's instructions.
struct LineItems::Walk {
  LineItems& to;
  int segment;
  bool solid = true, outlined = true;
  Point3 pen{};  // the point entered last

  void fill(const FillStyle& style) { solid = style.kind == FillStyle::Kind::solid; }
  void line_style(const LineStyle& style) { outlined = style.kind != LineStyle::Kind::none; }
  void pick(std::int32_t) {}
  void move(const Point3& p) { pen = p; }
  void line(const Point3& p) {
    const Point3 from = std::exchange(pen, p);
    if (!outlined) return;
    add(Kind::line, {{from, p}});
    to.drawn_.insert(to.drawn_.end(), {0, 1});
  }
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t> sides) {
    pen = vertices.back();
    if (!solid && !outlined) return;
    add(solid ? Kind::solid : Kind::hollow, {vertices.begin(), vertices.end()});
    for (const std::int32_t side : sides) {
      to.drawn_.push_back(outlined && side == op::line ? 1 : 0);
    }
  }

  void add(Kind kind, const std::vector<Point3>& points) {
    for (const Point3& p : points) {
      if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
      throw Error(fmt::format("segment {}: a point {} {} {}: expected finite numbers", segment, p.x,
                              p.y, p.z));
    }
    to.items_.push_back({to.points_.size(), static_cast<std::uint32_t>(points.size()), kind});
    to.points_.insert(to.points_.end(), points.begin(), points.end());
  }
};

LineItems::LineItems(const DisplayFile& display_file) {
  for (const Segment& segment : display_file.segments()) {
    if (segment.visible) segment.walk_entered_drawn(Walk{*this, segment.name()});
  }
  take_planes(display_file);
}

/// Takes the shared planes: the items are those of a viewed scene. Touching has a judge of its own.
void LineItems::take_planes(const DisplayFile& display_file) {
  scene_ = std::make_shared<const ViewedScene>(display_file);
  const ViewedScene& scene = *scene_;
  primitives_ = scene.primitives();
  const auto points = primitives_.points;
  if (scene.planes().empty()) return;
  for (std::uint32_t item = 0; item < size(); ++item) {
    const Primitives::PlanePoints* const plane = scene.shared_plane(item);
    plane_of_.push_back(plane == nullptr ? kNoPlane : static_cast<std::uint32_t>(planes_.size()));
    if (plane == nullptr) continue;
    const auto& [p, q, r] = *plane;
    planes_.push_back({points[p], points[q], points[r]});
  }
}

bool LineItems::contains(LineId line) const {
  return line.item < items_.size() && line.corner < items_[line.item].points &&
         (kind(line.item) != Kind::line || line.corner == 1);
}

const Point3& LineItems::from(LineId line) const {
  const std::span<const Point3> all = points(line.item);
  return line.corner == 0 ? all.back() : all[line.corner - 1];
}

std::vector<LineId> LineItems::all_lines() const {
  std::vector<LineId> lines;
  for (LineId line{0, 0}; line.item < size(); ++line.item) {
    for (line.corner = 0; line.corner < items_[line.item].points; ++line.corner) {
      if (contains(line)) lines.push_back(line);
    }
  }
  return lines;
}

std::vector<LineId> LineItems::drawn_lines() const {
  std::vector<LineId> lines = all_lines();
  std::erase_if(lines, [&](LineId l) { return drawn_[items_[l.item].first + l.corner] == 0; });
  return lines;
}

namespace {

auto coordinates(const Point3& p) { return std::tuple(p.x, p.y, p.z); }

}  // namespace

std::vector<LineItems::Sharers> LineItems::shared(std::span<const LineId> lines) const {
  std::vector<LineId> asked(lines.begin(), lines.end());
  std::ranges::sort(asked);
  for (const LineId line : asked) {
    if (contains(line)) continue;
    throw Error(fmt::format("line ({}, {}): expected an item and a corner of the {} items",
                            line.item, line.corner, size()));
  }
  // A line that was entered as such is like no other.
  const auto ends = [&](LineId line) {
    const auto a = coordinates(from(line)), b = coordinates(to(line));
    const std::uint32_t own = kind(line.item) == Kind::line ? line.item + 1 : 0;
    return std::tuple(std::min(a, b), std::max(a, b), own);
  };
  std::vector<LineId> all = all_lines();
  std::ranges::sort(
      all, [&](LineId a, LineId b) { return std::tuple(ends(a), a) < std::tuple(ends(b), b); });
  std::vector<Sharers> found;
  for (auto first = all.begin(); first != all.end();) {
    const auto end =
        std::find_if(first, all.end(), [&](LineId l) { return ends(l) != ends(*first); });
    const bool is_asked =
        std::any_of(first, end, [&](LineId l) { return std::ranges::binary_search(asked, l); });
    if (is_asked) found.emplace_back(first, end);
    first = end;
  }
  std::ranges::sort(found, {}, [](const Sharers& s) { return s.front(); });
  return found;
}

}  // namespace displayfile
