#include "interp/visibility/image_space.h"

#include <algorithm>
#include <array>
#include <string>

#include "clip/base/error.h"
#include "interp/visibility/decided_centres.h"
#include "interp/visibility/plain_scan_line.h"
#include "interp/visibility/plain_warnock.h"
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

/// Wraps a method that is correct for the viewed scene, so that it is correct for the scene as
/// entered.
template <class Method>
std::unique_ptr<ImageSpaceMethod> as_entered() {
  return std::make_unique<MethodAsEntered>(make<Method>());
}

template <DepthFormat kFormat>
std::unique_ptr<ImageSpaceMethod> plain() {
  return make_plain_z_buffer(kFormat);
}

/// Methods that decide exactly, unless a ROUNDOFF is set.
constexpr std::array kExactMethods{
    ImageSpaceEntry{HiddenMethod::z_buffer, make<ZBuffer>},
    ImageSpaceEntry{HiddenMethod::warnock, as_entered<Warnock>},
    ImageSpaceEntry{HiddenMethod::scan_line_z, as_entered<ScanLineZ>},
    ImageSpaceEntry{HiddenMethod::scan_line, as_entered<ScanLine>},
    ImageSpaceEntry{HiddenMethod::ray_cast, as_entered<RayCast>},
};
/// Methods in plain form, for reading and for checking the others; `automatic` never chooses one.
/// All but the z-buffers, which round, decide exactly too.
constexpr std::array kPlainMethods{
    ImageSpaceEntry{HiddenMethod::plain_z_buffer, plain<DepthFormat::float_32>},
    ImageSpaceEntry{HiddenMethod::plain_z_buffer_16, plain<DepthFormat::integer_16>},
    ImageSpaceEntry{HiddenMethod::plain_z_buffer_24, plain<DepthFormat::integer_24>},
    ImageSpaceEntry{HiddenMethod::plain_z_buffer_32, plain<DepthFormat::integer_32>},
    ImageSpaceEntry{HiddenMethod::plain_z_buffer_double, plain<DepthFormat::float_64>},
    ImageSpaceEntry{HiddenMethod::plain_scan_line, as_entered<PlainScanLine>},
    ImageSpaceEntry{HiddenMethod::plain_warnock, as_entered<PlainWarnock>},
};

/// Null if the method is in neither table.
const ImageSpaceEntry* entry_of(HiddenMethod method) {
  for (const std::span<const ImageSpaceEntry> table :
       {std::span<const ImageSpaceEntry>(kExactMethods),
        std::span<const ImageSpaceEntry>(kPlainMethods)}) {
    const auto entry = std::ranges::find(table, method, &ImageSpaceEntry::method);
    if (entry != table.end()) return &*entry;
  }
  return nullptr;
}

}  // namespace

std::span<const ImageSpaceEntry> image_space_methods() { return kExactMethods; }

bool is_image_space(HiddenMethod by) {
  const HiddenMethod method = surfaces_of(by);
  return method == HiddenMethod::automatic || method == HiddenMethod::world_ray_cast ||
         entry_of(method) != nullptr;
}

bool is_plain_z_buffer(HiddenMethod by) {
  const HiddenMethod method = surfaces_of(by);
  return method >= HiddenMethod::plain_z_buffer && method <= HiddenMethod::plain_z_buffer_double;
}

bool decides_exactly(HiddenMethod by) {
  return is_image_space(by) && surfaces_of(by) != HiddenMethod::world_ray_cast &&
         !is_plain_z_buffer(by);
}

std::unique_ptr<ImageSpaceMethod> make_image_space_method(HiddenMethod method,
                                                          const ViewedWorld* world) {
  if (method == HiddenMethod::world_ray_cast) return std::make_unique<WorldRayCast>(world);
  const ImageSpaceEntry* const entry = entry_of(method);
  if (entry == nullptr) {
    throw Error("hidden-surface method '" + std::string(name_of(method)) +
                "' does not work in image space");
  }
  return entry->make();
}

}  // namespace displayfile
