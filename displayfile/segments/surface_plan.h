#pragma once

#include <cstddef>
#include <optional>

#include "clip/base/work_budget.h"
#include "clip/base/work_progress.h"
#include "clip/surfaces.h"
#include "displayfile/graphics_system.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// What a call asks for in place of what the application set.
struct HiddenSurfaceOptions {
  std::optional<HiddenMethod> method = std::nullopt;
  std::optional<HiddenScope> scope = std::nullopt;
  std::optional<Precision> precision = std::nullopt;
  int threads = 1;                        ///< the result is the same for any number
  std::size_t most_pieces = kMostPieces;  ///< of a sort; Error for more
  /// Told by a method that finds lines of those looked at, anew for each segment, or group of
  /// segments, that is looked at by itself.
  WorkProgress progress = {};
  /// What bringing up to date may use at most, if not null: LimitReached for more.
  WorkBudget* budget = nullptr;
  std::optional<HiddenLines> hidden_lines = std::nullopt;
  /// Lines along which polygons pass through each other are wanted too, where no application says.
  bool intersections = false;
  /// The map is to tell which pieces the light reaches, where shadows are shown
  /// (displayfile/segments/lit_parts.md). Segments are then looked at together, unless the
  /// application or scope says otherwise, since each may darken any other.
  bool shadows = false;
  RootChoice root = RootChoice::free;  ///< of the trees of `bsp`
};

/// How the surfaces of one picture are found: a call's options, and what the application set where
/// they leave it open.
struct SurfacePlan {
  HiddenSurfaceOptions options;
  HiddenMethod method = HiddenMethod::automatic;  ///< as set: may be `automatic`
  Precision precision = {};
  HiddenLines hidden_lines = HiddenLines::none;
  bool intersections = false;
  std::optional<HiddenScope> scope_of_application = std::nullopt;

  bool is_applications() const { return !options.method; }
};

/// Merges both: the method is that of the options, or else what the application set with
/// set_z_buffer, set_hidden_line_removal and set_hidden_method.
SurfacePlan resolve_surfaces(const GraphicsSystem& system, const HiddenSurfaceOptions& options);
/// Where there is no application: exactly, without hidden lines, by `automatic` unless the options
/// say otherwise.
SurfacePlan resolve_surfaces(const HiddenSurfaceOptions& options);

}  // namespace displayfile
