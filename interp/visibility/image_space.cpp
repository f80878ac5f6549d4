#include "interp/visibility/image_space.h"

#include <algorithm>
#include <array>
#include <string>

#include "clip/error.h"
#include "interp/visibility/plain_z_buffer.h"
#include "interp/visibility/ray_cast.h"
#include "interp/visibility/scan_line.h"
#include "interp/visibility/scan_line_z.h"
#include "interp/visibility/warnock.h"
#include "interp/visibility/world_ray_cast.h"
#include "interp/visibility/z_buffer.h"

namespace displayfile {

namespace {

template <class Method>
std::unique_ptr<ImageSpaceMethod> make() {
  return std::make_unique<Method>();
}

template <DepthFormat kFormat>
std::unique_ptr<ImageSpaceMethod> plain() {
  return make_plain_z_buffer(kFormat);
}

constexpr std::array kMethods{
    ImageSpaceEntry{HiddenMethod::z_buffer, make<ZBuffer>},
    ImageSpaceEntry{HiddenMethod::warnock, make<Warnock>},
    ImageSpaceEntry{HiddenMethod::scan_line_z, make<ScanLineZ>},
    ImageSpaceEntry{HiddenMethod::scan_line, make<ScanLine>},
    ImageSpaceEntry{HiddenMethod::ray_cast, make<RayCast>},
    ImageSpaceEntry{HiddenMethod::plain_z_buffer, plain<DepthFormat::float_32>},
    ImageSpaceEntry{HiddenMethod::plain_z_buffer_16, plain<DepthFormat::integer_16>},
    ImageSpaceEntry{HiddenMethod::plain_z_buffer_24, plain<DepthFormat::integer_24>},
    ImageSpaceEntry{HiddenMethod::plain_z_buffer_32, plain<DepthFormat::integer_32>},
    ImageSpaceEntry{HiddenMethod::plain_z_buffer_double, plain<DepthFormat::float_64>},
};
constexpr std::size_t kExact = 5;  // the first, which decide exactly unless a ROUNDOFF is asked for

}  // namespace

std::span<const ImageSpaceEntry> image_space_methods() { return std::span(kMethods).first(kExact); }

bool is_image_space(HiddenMethod method) {
  return method == HiddenMethod::automatic || method == HiddenMethod::world_ray_cast ||
         std::ranges::find(kMethods, method, &ImageSpaceEntry::method) != kMethods.end();
}

std::unique_ptr<ImageSpaceMethod> make_image_space_method(HiddenMethod method,
                                                          const ViewedWorld* world) {
  if (method == HiddenMethod::world_ray_cast) return std::make_unique<WorldRayCast>(world);
  const auto entry = std::ranges::find(kMethods, method, &ImageSpaceEntry::method);
  if (entry == kMethods.end()) {
    throw Error("hidden-surface method '" + std::string(name_of(method)) +
                "' does not work in image space");
  }
  return entry->make();
}

}  // namespace displayfile
