#include "interp/visibility/image_space.h"

#include <algorithm>
#include <array>
#include <string>

#include "clip/error.h"
#include "interp/visibility/ray_cast.h"
#include "interp/visibility/scan_line.h"
#include "interp/visibility/scan_line_z.h"
#include "interp/visibility/warnock.h"
#include "interp/visibility/z_buffer.h"

namespace displayfile {

namespace {

template <class Method>
std::unique_ptr<ImageSpaceMethod> make() {
  return std::make_unique<Method>();
}

constexpr std::array kMethods{
    ImageSpaceEntry{HiddenMethod::z_buffer, make<ZBuffer>},
    ImageSpaceEntry{HiddenMethod::warnock, make<Warnock>},
    ImageSpaceEntry{HiddenMethod::scan_line_z, make<ScanLineZ>},
    ImageSpaceEntry{HiddenMethod::scan_line, make<ScanLine>},
    ImageSpaceEntry{HiddenMethod::ray_cast, make<RayCast>},
};

}  // namespace

std::span<const ImageSpaceEntry> image_space_methods() { return kMethods; }

bool is_image_space(HiddenMethod method) {
  return method == HiddenMethod::automatic ||
         std::ranges::find(kMethods, method, &ImageSpaceEntry::method) != kMethods.end();
}

std::unique_ptr<ImageSpaceMethod> make_image_space_method(HiddenMethod method) {
  const auto entry = std::ranges::find(kMethods, method, &ImageSpaceEntry::method);
  if (entry == kMethods.end()) {
    throw Error("hidden-surface method '" + std::string(name_of(method)) +
                "' does not work in image space");
  }
  return entry->make();
}

}  // namespace displayfile
