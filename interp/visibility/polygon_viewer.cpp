#include "interp/visibility/polygon_viewer.h"

#include <algorithm>

#include "hidden/exact/support_plane.h"

namespace displayfile {

namespace {

using namespace in_world;

bool is_surely_positive(const Ball& a) { return a.middle > a.radius; }

}  // namespace

PolygonViewer::PolygonViewer(const ViewVolume& volume, const ViewRows<Ball>& near,
                             const ViewRows<ExactNumber>& exact, const Point3& size)
    : near_(near),
      exact_(exact),
      perspective_(volume.is_perspective()),
      pipeline_(volume),
      x_(near.window_x, size),
      y_(near.window_y, size),
      z_(near.z, size),
      w_(near.w, size) {
  for (const Linear<Ball>& inside : near.clip) clip_.emplace_back(inside, size);
}

PolygonViewer::Viewed PolygonViewer::view(const Polygon& polygon) {
  if (const auto viewed = view_in_balls(polygon)) return *viewed;
  seen_.clear();
  return view_exactly(polygon);
}

/// Nothing where they do not decide.
std::optional<PolygonViewer::Viewed> PolygonViewer::view_in_balls(const Polygon& polygon) {
  Viewed viewed;
  if (!is_surely_inside(polygon.vertices)) {
    const Clipping clipping = clip_whole(polygon.vertices, near_, points_, cut_);
    if (clipping == Clipping::undecided) return std::nullopt;
    viewed.cut = clipping == Clipping::something;
    if (points_.size() < 3) return viewed;
    seen_.clear();
    for (const WorldPoint<Ball>& p : points_) {
      const Ball w = near_.w.at(p);
      seen_.push_back({near_.window_x.at(p) / w, near_.window_y.at(p) / w,
                       (perspective_ ? p.w : near_.z.at(p)) / w});
    }
  }
  if (!polygon.both_sides) {
    const int turn = this->turn();
    if (turn == kUndecided) return std::nullopt;
    if (turn < 0) return viewed;
  }
  viewed.seen = true;
  if (polygon.flat) return viewed;
  const auto support = support_in_display_file(polygon.vertices, seen_.size());
  if (!support) return std::nullopt;
  viewed.support = *support;
  return viewed;
}

PolygonViewer::Viewed PolygonViewer::view_exactly(const Polygon& polygon) {
  Viewed viewed;
  WorldPoints<ExactNumber> points, cut;
  viewed.cut = clip_whole(polygon.vertices, exact_, points, cut) == Clipping::something;
  if (points.size() < 3) return viewed;
  viewed.seen = polygon.both_sides || turn_in_picture(points, exact_) > 0;
  if (polygon.flat || !viewed.seen) return viewed;
  const auto support = support_in_display_file(polygon.vertices, points.size());
  viewed.support = support ? *support : exact_support(points, exact_);
  return viewed;
}

/// The quick way, for nearly all polygons of a scene that is in the window. Leaves them in seen_.
bool PolygonViewer::is_surely_inside(std::span<const Point3> vertices) {
  seen_.clear();
  for (const Point3& p : vertices) {
    for (const OverBoxes& inside : clip_) {
      if (!is_surely_positive(inside.at(p))) return false;
    }
    const Ball x = x_.at(p), y = y_.at(p), w = w_.at(p);
    for (const Ball& inside : {x, w - x, y, w - y}) {
      if (!is_surely_positive(inside)) return false;
    }
    seen_.push_back({x / w, y / w, (perspective_ ? Ball{1.0, 0.0} : z_.at(p)) / w});
  }
  return true;
}

/// By the sign of the area in the picture.
int PolygonViewer::turn() const {
  Ball area;
  Seen from = seen_[1] - seen_[0];
  for (std::size_t i = 2; i < seen_.size(); ++i) {
    const Seen to = seen_[i] - seen_[0];
    area = area + cross(from.x, from.y, to.x, to.y);
    from = to;
  }
  return sign_of(area);
}

/// The vertices that the definition takes of those in the display file, if it has as many of the
/// polygon as clipping leaves, and these are not edge-on there.
std::optional<Support> PolygonViewer::support_in_display_file(std::span<const Point3> vertices,
                                                              std::size_t left) {
  const auto device = pipeline_.clip_polygon(vertices).vertices;
  if (device.size() != left) return std::nullopt;
  const Support support = support_vertices(device).index;
  const Point3 &p = device[support[0]], q = device[support[1]] - p, r = device[support[2]] - p;
  if (q.x * r.y - q.y * r.x == 0.0) return std::nullopt;
  return support;
}

/// What is linear in the picture is greatest at a vertex.
bool PolygonViewer::is_nowhere_nearer(const Viewed& viewed, double nearness) const {
  if (seen_.empty()) return false;
  if (perspective_ && nearness >= 0.0) return true;
  const double limit = perspective_ ? (1.0 - 4.0 * kUnit) / -nearness : nearness;
  const Seen p = seen_[viewed.support[0]];
  const Seen q = seen_[viewed.support[1]] - p, r = seen_[viewed.support[2]] - p;
  const Ball all = cross(q.x, q.y, r.x, r.y);
  const Ball along_x = cross(q.nearness, q.y, r.nearness, r.y) / all;
  const Ball along_y = cross(q.x, q.nearness, r.x, r.nearness) / all;
  return std::ranges::all_of(seen_, [&](const Seen& vertex) {
    const Seen v = vertex - p;
    const Ball there = p.nearness + along_x * v.x + along_y * v.y;
    return there.middle + 2.0 * there.radius <= limit;
  });
}

}  // namespace displayfile
