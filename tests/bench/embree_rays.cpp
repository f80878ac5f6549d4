#include "tests/bench/embree_rays.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

#include "clip/error.h"

namespace displayfile::bench {

struct EmbreeRays::Scene {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  int width = 0;
  ~Scene() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

std::optional<std::string> EmbreeRays::version() { return RTC_VERSION_STRING; }

EmbreeRays::EmbreeRays(const FillScene& triangles, int width, int height, int threads)
    : scene_(std::make_unique<Scene>()) {
  scene_->width = width;
  scene_->device = rtcNewDevice(fmt::format("threads={}", threads).c_str());
  if (scene_->device == nullptr) throw Error("Embree gives no device");
  const std::size_t count = triangles.end() - 1;
  RTCGeometry geometry = rtcNewGeometry(scene_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * count));
  auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), count));
  for (FillScene::Fill fill = 1; fill < triangles.end(); ++fill) {
    const auto polygon = triangles.vertices(fill);
    if (polygon.size() != 3) throw Error("a fill is not a triangle");
    for (const Point3& v : polygon) {
      *vertices++ = static_cast<float>(v.x * width);
      *vertices++ = static_cast<float>(v.y * height);
      *vertices++ = static_cast<float>(v.z);
    }
  }
  for (unsigned i = 0; i < 3 * count; ++i) indices[i] = i;
  rtcCommitGeometry(geometry);
  scene_->scene = rtcNewScene(scene_->device);
  rtcAttachGeometry(scene_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_->scene);
}

EmbreeRays::~EmbreeRays() = default;

/// Eight rays a packet, four columns of two rows, the packets one after the other along a row.
void EmbreeRays::cast(int row_begin, int row_end, std::vector<FillScene::Fill>& seen) const {
  const int width = scene_->width;
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
        rays.ray.org_z[k] = 2.0F;
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
        seen[at] = rays.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID ? FillScene::kBackground
                                                                 : rays.hit.primID[k] + 1;
      }
    }
  }
}

}  // namespace displayfile::bench
