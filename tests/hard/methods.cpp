#include "hard/methods.h"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "displayfile/segments/hidden_surface_check.h"
#include "interp/device/raster_request.h"
#include "interp/opengl/osmesa.h"
#include "interp/raster/software.h"
#include "interp/visibility/image_space.h"
#include "interp/visibility/plain_z_buffer.h"

namespace displayfile {

namespace {

RasterRequest request_ids(int size, HiddenMethod method) {
  RasterRequest request;
  request.width = request.height = size;
  request.surfaces.method = method;
  request.ids = true;
  return request;
}

Picture painter(const DisplayFile& display_file, int size) {
  return draw_with_software(display_file, request_ids(size, HiddenMethod::none));
}

auto image_space(HiddenMethod method, std::optional<double> roundoff) {
  return [=](const DisplayFile& display_file, int size) {
    RasterRequest request = request_ids(size, method);
    if (roundoff) request.surfaces.precision = {.exact = false, .roundoff = *roundoff};
    return draw_with_software(display_file, request);
  };
}

/// All segments sorted together, and painted back to front.
auto sorted(HiddenMethod method, const Precision& precision) {
  return [=](const DisplayFile& display_file, int size) {
    SurfacePlan options;
    options.precision = precision;
    DisplayFile file = display_file;
    file.set_sorted(hidden_surface_check(display_file.visible_segments(), options.by(method)));
    RasterRequest request = request_ids(size, HiddenMethod::none);
    request.sorted = precision.exact;
    return draw_with_software(file, request);
  };
}

auto plain(DepthFormat format) {
  return [format](const DisplayFile& display_file, int size) {
    return draw_with_plain_z_buffer(display_file, request_ids(size, HiddenMethod::z_buffer),
                                    format);
  };
}

/// How often OSMesa granted each depth.
using Granted = std::map<int, int>;

Method osmesa(int depth_bits) {
  const auto granted = std::make_shared<Granted>();
  const auto draw = [=](const DisplayFile& display_file, int size) {
    OsmesaBuffers scene(display_file, request_ids(size, HiddenMethod::z_buffer), depth_bits);
    ++(*granted)[scene.depth_bits()];
    return scene.picture();
  };
  const auto note = [=] {
    std::string text = osmesa_description(depth_bits);
    for (const auto& [bits, scenes] : *granted) {
      text += fmt::format("; granted {} bits in {} drawings", bits, scenes);
    }
    return text;
  };
  return {fmt::format("OSMesa, {} depth bits requested", depth_bits),
          fmt::format("osmesa {}", depth_bits), false, draw, note};
}

void add_sorts(const char* name, const char* column, HiddenMethod method,
               std::vector<Method>& all) {
  all.push_back({fmt::format("{}, exact", name), column, true, sorted(method, {})});
  for (const char* eps : {"1e-15", "1e-12", "1e-9", "1e-6", "1e-3"}) {
    all.push_back({fmt::format("{}, roundoff={}", name, eps), fmt::format("{} {}", column, eps),
                   false, sorted(method, {false, std::stod(eps)})});
  }
}

}  // namespace

std::vector<Method> methods() {
  std::vector<Method> all{
      {"z-buffer, exact", "exact", true, image_space(HiddenMethod::z_buffer, std::nullopt)}};
  for (const char* eps : {"0", "1e-12", "1e-9", "1e-6", "1e-3"}) {
    all.push_back({fmt::format("z-buffer, roundoff={}", eps), fmt::format("ro {}", eps), false,
                   image_space(HiddenMethod::z_buffer, std::stod(eps))});
  }
  for (const ImageSpaceEntry& entry : image_space_methods()) {
    if (entry.method == HiddenMethod::z_buffer) continue;
    const std::string name(name_of(entry.method));
    all.push_back({name + ", exact", name, true, image_space(entry.method, std::nullopt)});
    all.push_back(
        {name + ", roundoff=1e-6", name + " 1e-6", false, image_space(entry.method, 1e-6)});
  }
  add_sorts("BSP", "bsp", HiddenMethod::bsp, all);
  add_sorts("depth sort", "depth", HiddenMethod::depth_sort, all);
  all.push_back({"map", "map", true, sorted(HiddenMethod::map, {})});
  const std::vector<Method> others{
      {"painter in program order", "painter", false, painter},
      {"plain z-buffer, depth as double", "double", false, plain(DepthFormat::float_64)},
      {"plain z-buffer, depth as float", "float", false, plain(DepthFormat::float_32)},
      {"plain z-buffer, depth in 32 bits", "int 32", false, plain(DepthFormat::integer_32)},
      {"plain z-buffer, depth in 24 bits", "int 24", false, plain(DepthFormat::integer_24)},
      {"plain z-buffer, depth in 16 bits", "int 16", false, plain(DepthFormat::integer_16)},
  };
  all.insert(all.end(), others.begin(), others.end());
  if (!osmesa_available()) return all;
  for (int bits : {32, 24, 16}) all.push_back(osmesa(bits));
  return all;
}

long long wrong_pixels(const Picture& picture, const Picture& truth) {
  long long wrong = 0;
  for (std::size_t i = 0; i < truth.ids.size(); ++i) wrong += picture.ids[i] != truth.ids[i];
  return wrong;
}

}  // namespace displayfile
