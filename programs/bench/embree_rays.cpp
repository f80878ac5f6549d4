#include "programs/bench/embree_rays.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "clip/error.h"

namespace displayfile::bench {

struct EmbreeRays::Scene {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  PictureSize size{1, 1};
  std::vector<ViewedScene::Fill> fills;  // of the triangles
  double depth_scale = 1.0;              // a power of two: Embree has no coordinates beyond 1.8e18
  float origin = 0.0F;                   // z of the rays', before all triangles
  ~Scene() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

std::optional<std::string> EmbreeRays::version() { return RTC_VERSION_STRING; }

EmbreeRays::EmbreeRays(const Triangles& triangles, const PictureSize& size, int threads)
    : scene_(std::make_unique<Scene>()) {
  scene_->size = size;
  scene_->fills = triangles.fills;
  scene_->device = rtcNewDevice(fmt::format("threads={}", threads).c_str());
  if (scene_->device == nullptr) throw Error("Embree gives no device");
  RTCGeometry geometry = rtcNewGeometry(scene_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               triangles.corners.size()));
  auto* indices = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(unsigned), triangles.size()));
  double largest = 1.0;
  for (const Point3& v : triangles.corners) largest = std::max(largest, std::abs(v.z));
  scene_->depth_scale = std::ldexp(1.0, -std::ilogb(largest));
  scene_->origin = static_cast<float>(largest * scene_->depth_scale + 1.0);
  for (const Point3& v : triangles.corners) {
    *vertices++ = static_cast<float>(v.x * size.width);
    *vertices++ = static_cast<float>(v.y * size.height);
    *vertices++ = static_cast<float>(v.z * scene_->depth_scale);
  }
  for (unsigned i = 0; i < 3 * triangles.size(); ++i) indices[i] = i;
  rtcCommitGeometry(geometry);
  scene_->scene = rtcNewScene(scene_->device);
  rtcAttachGeometry(scene_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_->scene);
}

EmbreeRays::~EmbreeRays() = default;

/// Eight rays a packet, four columns of two rows, the packets one after the other along a row.
void EmbreeRays::cast(int row_begin, int row_end, Hits& hits) const {
  const int width = scene_->size.width;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (int row = row_begin; row < row_end; row += 2) {
    for (int column = 0; column < width; column += 4) {
      alignas(32) int valid[8];
      RTCRayHit8 rays;
      for (int k = 0; k < 8; ++k) {
        const int i = column + k % 4, j = row + k / 4;
        valid[k] = i < width && j < row_end ? -1 : 0;
        rays.ray.org_x[k] = static_cast<float>(i) + 0.5F;
        rays.ray.org_y[k] = static_cast<float>(j) + 0.5F;
        rays.ray.org_z[k] = scene_->origin;
        rays.ray.dir_x[k] = rays.ray.dir_y[k] = 0.0F;
        rays.ray.dir_z[k] = -1.0F;
        rays.ray.tnear[k] = 0.0F;
        rays.ray.tfar[k] = std::numeric_limits<float>::infinity();
        rays.ray.time[k] = 0.0F;
        rays.ray.mask[k] = ~0U;
        rays.ray.flags[k] = 0;
        rays.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
        rays.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
      }
      rtcIntersect8(valid, scene_->scene, &context, &rays);
      for (int k = 0; k < 8; ++k) {
        if (valid[k] == 0) continue;
        const int i = column + k % 4, j = row + k / 4;
        const auto at = static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(i);
        const bool hit = rays.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
        hits.fills[at] = hit ? scene_->fills[rays.hit.primID[k]] : ViewedScene::kBackground;
        // Nothing hit leaves tfar at infinity, and the depth at minus infinity.
        if (hits.depths.empty()) continue;
        hits.depths[at] = (scene_->origin - rays.ray.tfar[k]) / scene_->depth_scale;
      }
    }
  }
}

}  // namespace displayfile::bench
