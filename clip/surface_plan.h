#pragma once

#include <cstddef>
#include <optional>

#include "clip/base/work_budget.h"
#include "clip/surfaces.h"

namespace displayfile {

/// How the hidden surfaces and lines of one picture are found: made once for a picture, of a call's
/// HiddenSurfaceOptions and what the application set (displayfile/segments/surface_plan.h), and
/// read by all that finds surfaces or lines.
struct SurfacePlan {
  HiddenMethod method = HiddenMethod::automatic;  ///< `automatic` until one is picked
  Precision precision = {};
  RootChoice root = RootChoice::free;
  /// The methods that find lines draw them too where they are hidden
  /// (hidden/lines/lines_in_order.h).
  HiddenLines hidden_lines = HiddenLines::none;
  /// They draw those too along which polygons pass through each other
  /// (hidden/lines/intersection_lines.h).
  bool intersections = false;
  /// The map finds which of its pieces the light reaches, where shadows are shown.
  bool shadows = false;
  std::optional<HiddenScope> scope = std::nullopt;  ///< none: as usual where it is drawn
  int threads = 1;                                  ///< the result is the same for any number
  std::size_t most_pieces = kMostPieces;            ///< of a sort; Error for more
  WorkProgress progress = {};    ///< called by methods that find lines: of lines done
  WorkBudget* budget = nullptr;  ///< LimitReached for more, if not null

  /// The same by another method.
  SurfacePlan by(HiddenMethod other) const {
    SurfacePlan plan = *this;
    plan.method = other;
    return plan;
  }
  /// What is kept after the call: without its progress and its budget.
  SurfacePlan kept() const {
    SurfacePlan plan = *this;
    plan.progress = {};
    plan.budget = nullptr;
    return plan;
  }
  /// True if both find the same surfaces and lines of the same scene, shadows apart.
  bool finds_as(const SurfacePlan& o) const {
    return method == o.method && precision == o.precision && root == o.root &&
           hidden_lines == o.hidden_lines && intersections == o.intersections;
  }
};

}  // namespace displayfile
