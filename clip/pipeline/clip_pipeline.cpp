#include "clip/pipeline/clip_pipeline.h"

#include <algorithm>
#include <cassert>

#include "clip/geometry/corners.h"
#include "clip/pipeline/clip_stage.h"

namespace displayfile {

namespace {

constexpr std::array kStages{ClipPlane::back,  ClipPlane::front,  ClipPlane::eye, ClipPlane::left,
                             ClipPlane::right, ClipPlane::bottom, ClipPlane::top};

template <class V>
concept HasValue = requires(const V& v) {
  v.value;
};

}  // namespace

/// The point where an edge leaves the volume through `plane`.
///
/// It is computed from the end that is nearer along the edge, so that the other end, however far
/// away, does not cost it precision; and so that W, which is above 0 at both ends after the stages
/// in front of the eye, is above 0 there.
///
/// Rounding may not put the point outside of a plane that has both ends inside: a polygon that runs
/// that plane's stage would then cut the edge again, while its neighbour, which does not run it,
/// would keep the point.
template <class V>
V ClipPipeline::cut(const V& inside, const V& outside, ClipPlane plane) const {
  const double d_in = volume_.inside_distance(plane, inside.position);
  const double d_out = volume_.inside_distance(plane, outside.position);
  assert(d_out < 0.0);
  const double t = d_in / (d_in - d_out);
  V v{};
  const HomogeneousPoint along = outside.position - inside.position;
  if (t <= 0.5) {
    v.position = inside.position + along * t;
  } else {
    v.position = outside.position - along * (d_out / (d_out - d_in));
  }
  if constexpr (HasValue<V>) {
    v.value = inside.value;
    if (outside.value != inside.value) {  // both ends are in front of the eye
      const double t_in_picture = t * outside.position.w / v.position.w;
      v.value += (outside.value - inside.value) * t_in_picture;
    }
  }
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

template <class V>
void ClipPipeline::clip_stage(ClipPlane plane, Stages<V>& stage) const {
  displayfile::clip_stage(
      bit_of(plane), stage.in, stage.out,
      [&](const V& v) { return volume_.inside_distance(plane, v.position) == 0.0; },
      [&](const V& inside, const V& outside) { return cut(inside, outside, plane); });
}

template <class V, class Values>
void ClipPipeline::run_stages(std::span<const Point3> world,
                              std::span<const std::uint8_t> edge_visible,
                              [[maybe_unused]] const Values& values, Stages<V>& stage) {
  const std::size_t n = world.size();
  assert(edge_visible.empty() || edge_visible.size() == n);
  if constexpr (HasValue<V>) assert(values.size() == n);
  stage.in.resize(n);
  Outcode any = 0, all = ~0u;
  for (std::size_t i = 0; i < n; ++i) {
    V& v = stage.in[i];
    v.position = volume_.transform(world[i]);
    v.outcode = volume_.outcode(v.position);
    v.edge_visible = edge_visible.empty() ? std::uint8_t{1} : edge_visible[i];
    if constexpr (HasValue<V>) v.value = values[i];
    any |= v.outcode;
    all &= v.outcode;
  }
  met_ |= any;
  if (all != 0) return stage.in.clear();  // wholly outside of one plane
  if (any == 0) return;
  if constexpr (HasValue<V>) {
    const auto in_front = [](const V& v) { return v.position.w > 0.0; };
    if (!std::ranges::all_of(stage.in, in_front)) {
      const auto mean = mean_of_vertices(values);
      for (V& v : stage.in) v.value = mean;
    }
  }
  for (ClipPlane plane : kStages) {
    if ((any & bit_of(plane)) == 0) continue;  // no vertex is outside of this plane
    clip_stage(plane, stage);
    any = 0;
    for (const V& v : stage.in) any |= v.outcode;
  }
}

template <class V>
ClippedPolygon ClipPipeline::in_device_coordinates(std::span<const V> clipped) {
  if (clipped.size() < 3) return {};
  vertices_.resize(clipped.size());
  visible_.resize(clipped.size());
  for (std::size_t i = 0; i < clipped.size(); ++i) {
    assert(clipped[i].position.w > 0.0);  // also in a parallel view, where W is 1
    vertices_[i] = volume_.to_device(clipped[i].position);
    visible_[i] = clipped[i].edge_visible;
  }
  return {vertices_, visible_};
}

ClippedPolygon ClipPipeline::clip_polygon(std::span<const Point3> world,
                                          std::span<const std::uint8_t> edge_visible,
                                          std::span<const double> intensities) {
  if (intensities.empty()) {
    run_stages(world, edge_visible, NoValues(), stage_);
    return in_device_coordinates<Vertex>(stage_.in);
  }
  ClippedPolygon clipped =
      clip_shaded(world, edge_visible, intensities, intensity_stage_, intensities_);
  if (!clipped.vertices.empty()) clipped.intensities = intensities_;
  return clipped;
}

ClippedPolygon ClipPipeline::clip_with_normals(std::span<const Point3> world,
                                               std::span<const std::uint8_t> edge_visible,
                                               std::span<const Point3> normals) {
  ClippedPolygon clipped = clip_shaded(world, edge_visible, normals, normal_stage_, normals_);
  if (!clipped.vertices.empty()) clipped.normals = normals_;
  return clipped;
}

template <class Value>
ClippedPolygon ClipPipeline::clip_shaded(std::span<const Point3> world,
                                         std::span<const std::uint8_t> edge_visible,
                                         std::span<const Value> values,
                                         Stages<ShadedVertex<Value>>& stage,
                                         std::vector<Value>& of_clipped) {
  run_stages(world, edge_visible, values, stage);
  of_clipped.clear();
  for (const ShadedVertex<Value>& v : stage.in) of_clipped.push_back(v.value);
  return in_device_coordinates<ShadedVertex<Value>>(stage.in);
}

bool ClipPipeline::clip_line(const Point3& a, const Point3& b, Point3& device_a, Point3& device_b) {
  Vertex from{volume_.transform(a), 0, 1}, to{volume_.transform(b), 0, 1};
  from.outcode = volume_.outcode(from.position);
  to.outcode = volume_.outcode(to.position);
  met_ |= from.outcode | to.outcode;
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
