#include "tests/bench/command/embree_rays.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "clip/base/error.h"

namespace displayfile::bench {

namespace {

/// A device is started once, as an application does.
class Devices {
 public:
  ~Devices() {
    for (const auto& [threads, device] : devices_) rtcReleaseDevice(device);
  }
  RTCDevice of(int threads) {
    RTCDevice& device = devices_[threads];
    if (device == nullptr) device = rtcNewDevice(fmt::format("threads={}", threads).c_str());
    if (device == nullptr) throw Error("Embree gives no device");
    return device;
  }

 private:
  std::map<int, RTCDevice> devices_;
};

RTCDevice device_of(int threads) {
  static Devices devices;
  return devices.of(threads);
}

RTCBuildQuality quality_of(EmbreeRays::Quality quality) {
  return quality == EmbreeRays::Quality::high ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM;
}

template <class Rays, int kWide, auto kIntersect>
struct PacketOf {
  using Type = Rays;
  static constexpr int kColumns = kWide;
  static void intersect(const int* valid, RTCScene scene, RTCIntersectContext* context,
                        Type* rays) {
    kIntersect(valid, scene, context, rays);
  }
};
template <int kRays>
struct Packet;
template <>
struct Packet<4> : PacketOf<RTCRayHit4, 2, rtcIntersect4> {};
template <>
struct Packet<8> : PacketOf<RTCRayHit8, 4, rtcIntersect8> {};
template <>
struct Packet<16> : PacketOf<RTCRayHit16, 4, rtcIntersect16> {};

}  // namespace

struct EmbreeRays::Scene {
  explicit Scene(const Input& of) : input(of) {}
  ~Scene() {
    if (scene != nullptr) rtcReleaseScene(scene);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  template <int kRays>
  void cast(int row_begin, int row_end, Hits& hits) const;

  const Input& input;
  RTCScene scene = nullptr;
};

std::optional<std::string> EmbreeRays::version() { return RTC_VERSION_STRING; }

int EmbreeRays::packet_width() {
  auto* const device = device_of(1);
  const auto is_native = [&](RTCDeviceProperty property) {
    return rtcGetDeviceProperty(device, property) != 0;
  };
  if (is_native(RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)) return 16;
  return is_native(RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) ? 8 : 4;
}

EmbreeRays::Input::Input(const Triangles& triangles, const PictureSize& of_picture)
    : size(of_picture), fills(triangles.fills) {
  double largest = 1.0;
  for (const Point3& v : triangles.corners) largest = std::max(largest, std::abs(v.z));
  depth_scale = std::ldexp(1.0, -std::ilogb(largest));
  origin = static_cast<float>(largest * depth_scale + 1.0);
  corners.reserve(3 * triangles.corners.size() + 1);
  for (const Point3& v : triangles.corners) {
    corners.push_back(static_cast<float>(v.x * size.width));
    corners.push_back(static_cast<float>(v.y * size.height));
    corners.push_back(static_cast<float>(v.z * depth_scale));
  }
  corners.push_back(0.0F);  // Embree reads sixteen bytes of a vertex
}

EmbreeRays::EmbreeRays(const Input& input, int threads, Quality quality)
    : scene_(std::make_unique<Scene>(input)) {
  auto* const device = device_of(threads);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const std::size_t triangles = input.fills.size();
  if (triangles > 0) {
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               input.corners.data(), 0, 3 * sizeof(float), 3 * triangles);
    auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles));
    for (unsigned i = 0; i < 3 * triangles; ++i) indices[i] = i;
  }
  rtcSetGeometryBuildQuality(geometry, quality_of(quality));
  rtcCommitGeometry(geometry);
  scene_->scene = rtcNewScene(device);
  rtcSetSceneBuildQuality(scene_->scene, quality_of(quality));
  rtcAttachGeometry(scene_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_->scene);
}

EmbreeRays::~EmbreeRays() = default;

/// A few columns of some rows a packet, the packets one after the other along a row. The fields
/// that are the same for all packets are filled in once.
template <int kRays>
void EmbreeRays::Scene::cast(int row_begin, int row_end, Hits& hits) const {
  using Kind = Packet<kRays>;
  constexpr int kColumns = Kind::kColumns, kRows = kRays / kColumns;
  const int width = input.size.width;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  alignas(64) int valid[kRays];
  alignas(64) typename Kind::Type rays;
  for (int k = 0; k < kRays; ++k) {
    rays.ray.org_z[k] = input.origin;
    rays.ray.dir_x[k] = rays.ray.dir_y[k] = 0.0F;
    rays.ray.dir_z[k] = -1.0F;
    rays.ray.tnear[k] = 0.0F;
    rays.ray.time[k] = 0.0F;
    rays.ray.mask[k] = ~0U;
    rays.ray.id[k] = 0;
    rays.ray.flags[k] = 0;
    rays.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
  }
  for (int row = row_begin; row < row_end; row += kRows) {
    for (int k = 0; k < kRays; ++k) {
      rays.ray.org_y[k] = static_cast<float>(row + k / kColumns) + 0.5F;
    }
    for (int column = 0; column < width; column += kColumns) {
      for (int k = 0; k < kRays; ++k) {
        const int i = column + k % kColumns, j = row + k / kColumns;
        valid[k] = i < width && j < row_end ? -1 : 0;
        rays.ray.org_x[k] = static_cast<float>(i) + 0.5F;
        rays.ray.tfar[k] = std::numeric_limits<float>::infinity();
        rays.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
      }
      Kind::intersect(valid, scene, &context, &rays);
      for (int k = 0; k < kRays; ++k) {
        if (valid[k] == 0) continue;
        const int i = column + k % kColumns, j = row + k / kColumns;
        const auto at = static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(i);
        const bool hit = rays.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
        hits.fills[at] = hit ? input.fills[rays.hit.primID[k]] : ViewedScene::kBackground;
        // Nothing hit leaves tfar at infinity, and the depth at minus infinity.
        if (hits.depths.empty()) continue;
        hits.depths[at] = (input.origin - rays.ray.tfar[k]) / input.depth_scale;
      }
    }
  }
}

void EmbreeRays::cast(int row_begin, int row_end, Hits& hits) const {
  static const int width = packet_width();
  switch (width) {
    case 16: return scene_->cast<16>(row_begin, row_end, hits);
    case 8: return scene_->cast<8>(row_begin, row_end, hits);
    default: return scene_->cast<4>(row_begin, row_end, hits);
  }
}

}  // namespace displayfile::bench
