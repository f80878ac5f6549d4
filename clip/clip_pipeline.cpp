#include "clip/clip_pipeline.h"

#include <algorithm>

namespace displayfile {

namespace {

constexpr std::array kStages{ClipPlane::back,  ClipPlane::front,  ClipPlane::eye, ClipPlane::left,
                             ClipPlane::right, ClipPlane::bottom, ClipPlane::top};

}  // namespace

/// The point where an edge leaves the volume through `plane`.
///
/// Rounding may not put the point outside of a plane that both ends are inside of: then a
/// polygon that runs that plane's stage would cut the edge again and its neighbour, which
/// does not, would keep it.
ClipPipeline::Vertex ClipPipeline::cut(const Vertex& inside, const Vertex& outside,
                                       ClipPlane plane) const {
  const double d_in = volume_.inside_distance(plane, inside.position);
  const double d_out = volume_.inside_distance(plane, outside.position);
  const double t = d_in / (d_in - d_out);
  Vertex v{inside.position + (outside.position - inside.position) * t, 0, 0};
  volume_.snap(plane, v.position);
  const Outcode both_inside = ~(inside.outcode | outside.outcode) | bit_of(plane);
  for (ClipPlane p : kStages) {
    if (Outcode out = volume_.outcode(v.position); (out & both_inside & bit_of(p)) != 0) {
      volume_.snap(p, v.position);
    }
  }
  v.outcode = volume_.outcode(v.position) & ~both_inside;
  return v;
}

/// One stage: stage_in_ to stage_out_, which then change places.
void ClipPipeline::clip_stage(ClipPlane plane) {
  const Outcode bit = bit_of(plane);
  stage_out_.clear();
  if (stage_in_.empty()) return;
  const Vertex* previous = &stage_in_.back();
  for (const Vertex& vertex : stage_in_) {
    const bool was_outside = (previous->outcode & bit) != 0;
    const bool is_outside = (vertex.outcode & bit) != 0;
    if (was_outside && !is_outside) {
      Vertex entry = cut(vertex, *previous, plane);  // reached along the plane
      if (volume_.inside_distance(plane, vertex.position) == 0.0) {
        stage_out_.push_back(vertex);  // the edge enters at its end: nothing of it remains
        stage_out_.back().edge_visible = 0;
      } else {
        stage_out_.push_back(entry);
        stage_out_.push_back(vertex);
      }
    } else if (!was_outside && is_outside) {
      if (volume_.inside_distance(plane, previous->position) != 0.0) {
        Vertex exit = cut(*previous, vertex, plane);
        exit.edge_visible = vertex.edge_visible;
        stage_out_.push_back(exit);
      }
    } else if (!is_outside) {
      stage_out_.push_back(vertex);
    }
    previous = &vertex;
  }
  stage_in_.swap(stage_out_);
}

ClippedPolygon ClipPipeline::clip_polygon(std::span<const Point3> world,
                                          std::span<const std::uint8_t> edge_visible) {
  const std::size_t n = world.size();
  vertices_.resize(n);
  visible_.resize(n);
  stage_in_.resize(n);
  Outcode any = 0, all = ~0u;
  for (std::size_t i = 0; i < n; ++i) {
    Vertex& v = stage_in_[i];
    v.position = volume_.transform(world[i]);
    v.outcode = volume_.outcode(v.position);
    v.edge_visible = edge_visible.empty() ? std::uint8_t{1} : edge_visible[i];
    any |= v.outcode;
    all &= v.outcode;
  }
  if (all != 0) return {};  // wholly outside of one plane
  if (any != 0) {
    for (ClipPlane plane : kStages) {
      if ((any & bit_of(plane)) == 0) continue;  // no vertex is outside of this plane
      clip_stage(plane);
      any = 0;
      for (const Vertex& v : stage_in_) any |= v.outcode;
    }
    if (stage_in_.size() < 3) return {};
    vertices_.resize(stage_in_.size());
    visible_.resize(stage_in_.size());
  }
  for (std::size_t i = 0; i < stage_in_.size(); ++i) {
    vertices_[i] = volume_.to_device(stage_in_[i].position);
    visible_[i] = stage_in_[i].edge_visible;
  }
  return {vertices_, visible_};
}

bool ClipPipeline::clip_line(const Point3& a, const Point3& b, Point3& device_a,
                             Point3& device_b) const {
  Vertex from{volume_.transform(a), 0, 1}, to{volume_.transform(b), 0, 1};
  from.outcode = volume_.outcode(from.position);
  to.outcode = volume_.outcode(to.position);
  for (ClipPlane plane : kStages) {
    if ((from.outcode & to.outcode) != 0) return false;
    const Outcode bit = bit_of(plane);
    if ((from.outcode & bit) != 0) {
      from = cut(to, from, plane);
    } else if ((to.outcode & bit) != 0) {
      to = cut(from, to, plane);
    }
  }
  device_a = volume_.to_device(from.position);
  device_b = volume_.to_device(to.position);
  return true;
}

}  // namespace displayfile
