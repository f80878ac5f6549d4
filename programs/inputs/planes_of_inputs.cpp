#include "programs/inputs/planes_of_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "clip/base/files.h"
#include "displayfile/user_routines/plane_uses.h"
#include "displayfile/user_routines/system_inside.h"
#include "programs/process/warnings.h"

namespace displayfile {

namespace {

/// The inputs that a plane met: those after the one that sets it.
std::string inputs_met(std::span<const std::string> inputs) {
  if (inputs.empty()) return "what is entered after it";
  std::string first = input_name(inputs.front());
  if (inputs.size() == 1) return first;
  if (inputs.size() == 2) return first + " and " + input_name(inputs.back());
  return fmt::format("{} and {} other inputs", first, inputs.size() - 1);
}

}  // namespace

void PlanesOfInputs::entered(std::size_t i, const GraphicsSystem& system) {
  planes_set_.resize(i + 1, SystemInside::plane_uses(system).planes_set());
  for (const PlaneWithoutEffect& plane : SystemInside::plane_uses(system).without_effect()) {
    if (!plane.is_set) ended_within_.try_emplace(plane.order, i);
  }
}

void PlanesOfInputs::warn(std::span<const std::string> inputs, const GraphicsSystem& system) const {
  for (const PlaneWithoutEffect& plane : SystemInside::plane_uses(system).without_effect()) {
    const auto setter = static_cast<std::size_t>(
        std::ranges::lower_bound(planes_set_, plane.order) - planes_set_.begin());
    if (setter == planes_set_.size()) continue;  // not by an input
    const auto end = ended_within_.find(plane.order);
    const std::size_t last = end != ended_within_.end() ? end->second : planes_set_.size() - 1;
    const auto& [a, b, c, d] = plane.plane;
    warnings() << fmt::format("{}: set-cutting-plane {} {} {} {} {} cuts {} of {}\n",
                              input_name(inputs[setter]), plane.n, a, b, c, d,
                              plane.leaves_nothing ? "away all" : "nothing",
                              inputs_met(inputs.subspan(setter + 1, last - setter)));
  }
}

}  // namespace displayfile
