#pragma once

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "clip/base/error.h"
#include "clip/geometry/crease_angle.h"
#include "displayfile/graphics_system.h"
#include "displayfile/user_routines/system_inside.h"
#include "programs/options/number_in.h"
#include "programs/options/option_groups.h"

namespace displayfile {

/// The shading that inputs start with; a program may set another.
struct StartingShading {
  Shading shading = Shading::flat;
  double crease_degrees = kNoCrease;
  bool crease_is_set = false;  ///< by an option

  /// Sets the values that are not defaults.
  void start(GraphicsSystem& system) const {
    if (shading != Shading::flat) system.set_shading(shading);
    const auto set_crease = [&] { system.set_crease_angle(crease_degrees); };
    if (crease_is_set) return set_crease();
    if (crease_degrees != kNoCrease) {
      SystemInside::by_default(system, Setting::crease_angle, set_crease);
    }
  }
};

/// The options --shading and --crease.
struct ShadingWord {
  std::optional<std::string> word;
  std::optional<double> crease;

  void add_to(CLI::App& command) {
    command
        .add_option("--shading", word,
                    "initial shading of the inputs: flat, or gouraud or phong for smooth meshes")
        ->type_name("flat|gouraud|phong")
        ->default_str("flat")
        ->group(kPictureOptions);
    add_crease_to(command, crease);
  }
  static void add_crease_to(CLI::App& command, std::optional<double>& crease) {
    command
        .add_option("--crease", crease,
                    "of smooth meshes without normals: sides at which facets meet at more than "
                    "DEGREES, 0 to 180, stay sharp [180: none]")
        ->type_name("DEGREES")
        ->transform(number_in(0.0, kNoCrease))
        ->group(kPictureOptions);
  }

  /// The shading set, or `unless_set`. Throws Error for an unknown word, or for a crease angle that
  /// can have no effect: with no mesh, or with flat shading and no program that could set another.
  StartingShading starting(bool has_meshes, bool has_programs,
                           const StartingShading& unless_set = {}) const {
    const Shading starts = word ? shading(*word) : unless_set.shading;
    if (crease && !(has_meshes && (starts != Shading::flat || has_programs))) {
      throw Error(fmt::format("--crease {} has no effect: expected {}", *crease,
                              has_meshes ? "--shading gouraud or phong too" : "a mesh"));
    }
    return {starts, crease.value_or(word ? kNoCrease : unless_set.crease_degrees),
            crease.has_value()};
  }
};

}  // namespace displayfile
