#pragma once

#include <cstddef>
#include <optional>

#include "clip/base/work_budget.h"
#include "clip/surfaces.h"

namespace displayfile {

/// The plan by which one picture's hidden surfaces and lines are found: made once per picture from
/// a call's HiddenSurfaceOptions and the application's settings
/// (displayfile/segments/surface_plan.h), and read by every method.
struct SurfacePlan {
  HiddenMethod method = HiddenMethod::automatic;  ///< `automatic` until one is chosen
  Precision precision = {};
  RootChoice root = RootChoice::free;
  /// Whether methods that find lines also draw hidden parts (hidden/lines/lines_in_order.h).
  HiddenLines hidden_lines = HiddenLines::none;
  /// The order of visible lines that overlap, and with `depth` the gap beside the farther one, in
  /// pixels of a picture of that size.
  LineOrder line_order = LineOrder::entry;
  double line_halo = 0.0;
  int width = 512, height = 512;
  /// Whether they also draw lines along which polygons intersect
  /// (hidden/lines/intersection_lines.h).
  bool intersections = false;
  /// Whether the map finds which of its pieces are lit, for shadows.
  bool shadows = false;
  std::optional<HiddenScope> scope = std::nullopt;  ///< none: the default of the drawing function
  int threads = 1;                                  ///< the result does not depend on it
  std::size_t most_pieces = kMostPieces;            ///< limit of a sort; Error above it
  WorkProgress progress = {};    ///< called by methods that find lines, with lines done
  WorkBudget* budget = nullptr;  ///< limits, if not null

  /// The same with another method.
  SurfacePlan by(HiddenMethod other) const {
    SurfacePlan plan = *this;
    plan.method = other;
    return plan;
  }
  /// The part to keep after the call: without progress and budget.
  SurfacePlan kept() const {
    SurfacePlan plan = *this;
    plan.progress = {};
    plan.budget = nullptr;
    return plan;
  }
  /// True if both find the same surfaces and lines of the same scene, shadows apart.
  bool finds_as(const SurfacePlan& o) const {
    return method == o.method && precision == o.precision && root == o.root &&
           hidden_lines == o.hidden_lines && intersections == o.intersections && orders_lines_as(o);
  }
  /// True if both draw lines that overlap in the same way.
  bool orders_lines_as(const SurfacePlan& o) const {
    if (line_order == LineOrder::entry || o.line_order == LineOrder::entry)
      return line_order == o.line_order;
    return line_halo == o.line_halo && width == o.width && height == o.height;
  }
};

}  // namespace displayfile
