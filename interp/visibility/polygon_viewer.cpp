#include "interp/visibility/polygon_viewer.h"

#include <algorithm>

namespace displayfile {

namespace {

using namespace in_world;

bool is_surely_positive(const Ball& a) { return a.middle > a.radius; }

}  // namespace

PolygonViewer::PolygonViewer(const ViewVolume& volume, const MatrixRows<Ball>& near,
                             const MatrixRows<ExactNumber>& exact, const Point3& size)
    : near_(near),
      exact_(exact),
      perspective_(volume.is_perspective()),
      x_(near.window_x, size),
      y_(near.window_y, size),
      z_(near.z, size),
      w_(near.w, size) {
  for (const Linear<Ball>& inside : near.clip) clip_.emplace_back(inside, size);
}

bool PolygonViewer::is_seen(std::span<const Point3> polygon, bool both_sides) {
  if (const auto in_balls = is_seen_in_balls(polygon, both_sides)) return *in_balls;
  seen_.clear();
  return is_seen_exactly(polygon, both_sides);
}

/// None where the balls do not decide.
std::optional<bool> PolygonViewer::is_seen_in_balls(std::span<const Point3> polygon,
                                                    bool both_sides) {
  if (!is_surely_inside(polygon)) {
    if (clip_whole(polygon, near_, points_, cut_) == Clipping::undecided) return std::nullopt;
    if (points_.size() < 3) return false;
    seen_.clear();
    for (const WorldPoint<Ball>& p : points_) seen_.push_back(seen(p));
  }
  if (both_sides) return true;
  const int turn = this->turn();
  if (turn == kUndecided) return std::nullopt;
  return turn > 0;
}

bool PolygonViewer::is_seen_exactly(std::span<const Point3> polygon, bool both_sides) const {
  WorldPoints<ExactNumber> points, cut;
  clip_whole(polygon, exact_, points, cut);
  return points.size() >= 3 && (both_sides || turn_in_picture(points, exact_) > 0);
}

PolygonViewer::Seen PolygonViewer::seen(const WorldPoint<Ball>& p) const {
  const Ball w = near_.w.at(p);
  return {near_.window_x.at(p) / w, near_.window_y.at(p) / w,
          (perspective_ ? p.w : near_.z.at(p)) / w};
}

/// A fast test, sufficient for nearly all polygons of a scene within the window. Leaves the
/// vertices in seen_.
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

/// The orientation: the sign of the area in the picture.
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

/// A quantity that is linear in the picture is greatest at a vertex.
bool PolygonViewer::is_nowhere_nearer(const std::array<Point3, 3>& plane, double nearness) const {
  if (seen_.empty()) return false;
  if (perspective_ && nearness >= 0.0) return true;
  const double limit = perspective_ ? (1.0 - 4.0 * kUnit) / -nearness : nearness;
  std::array<Seen, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const WorldPoint<Ball> corner = world_point<Ball>(plane[k]);
    if (!is_surely_positive(near_.w.at(corner))) return false;
    corners[k] = seen(corner);
  }
  const Seen p = corners[0], q = corners[1] - p, r = corners[2] - p;
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
