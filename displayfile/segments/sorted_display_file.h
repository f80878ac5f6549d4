#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "displayfile/graphics_system.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/segment_groups.h"
#include "displayfile/segments/surface_plan.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// A sort's part of the plan.
SortOptions sort_options(const SurfacePlan& plan);

/// Throws Error if lines are to be drawn where they are hidden, and the method is the colour rule
/// over surfaces that are in no order: it finds no lines.
void require_hidden_lines_found(HiddenLines hidden_lines, HiddenMethod method);

/// A display file with its hidden surfaces sorted as the next drawing needs it. Kept from one
/// drawing to the next, it sorts only what has changed since.
class SortedDisplayFile {
 public:
  /// Brings it up to date with the application's display file.
  ///
  /// `by` is the method in force, `automatic` replaced by what it means if that sorts; else
  /// `automatic` is sorted as the map, and `none` is passed where nothing is to be sorted. If so,
  ///  - a method that the application set leaves the segments as close-segment left them, unless
  ///    the scope is all; only a segment that has an image transformation since, or is asked for
  ///    in another precision or with hidden lines otherwise, is sorted again;
  ///  - a method of the options sorts all visible segments together, each group that overlaps by
  ///    itself (displayfile/segments/segment_groups.h), or each on its own if the options or the
  ///    application set that scope; one that `automatic` means sorts all together, whatever the
  ///    scope.
  /// If it does not sort, a method of the options is drawn from the polygons as they were entered
  /// and one that the application set from what close-segment left. Invisible segments stay as
  /// they are.
  const DisplayFile& update(const GraphicsSystem& system, const SurfacePlan& plan, HiddenMethod by);
  /// The same, of a plan that is not at hand.
  const DisplayFile& update(const GraphicsSystem& system, HiddenMethod by,
                            const HiddenSurfaceOptions& options = {}) {
    return update(system, resolve_surfaces(system, options), by);
  }

  /// Brings it up to date with a display file of its own, such as that of a new view: its visible
  /// segments sorted by `method`, a sort or one that finds lines, together unless the options'
  /// scope is each segment, exactly unless they have a precision.
  const DisplayFile& update(const DisplayFile& entered, HiddenMethod method,
                            const HiddenSurfaceOptions& options);

  /// The display file as the last update left it; one that failed leaves it as it was.
  const DisplayFile& display_file() const { return file_; }

  /// The work of the last update with scope all: how many groups of segments that overlap there
  /// are, and how many of them had to be sorted, since one of their segments changed.
  struct Work {
    std::size_t groups = 0, sorted = 0;
  };
  const Work& work() const { return work_; }

 private:
  /// Copies of segments share their instructions.
  struct SortedGroup {
    std::vector<Segment> segments;
    std::shared_ptr<const SortedScene> sorted;
  };
  SortedGroup sorted_group(const SegmentGroup& group, HiddenMethod method,
                           const SortOptions& options);
  template <class Sort>
  const DisplayFile& sort_anew(const DisplayFile& entered, const Sort& sort);
  void sort_as_closed(const SurfacePlan& plan);
  void sort_segments(HiddenMethod method, const SortOptions& options);
  void sort_together(HiddenMethod method, const SortOptions& options);
  void sort_segment(const Segment& segment, HiddenMethod method, const SortOptions& asked);
  void unsort();

  DisplayFile file_;
  DisplayFile last_;                             // of the update before, while file_ is being made
  std::unordered_map<int, SortedGroup> groups_;  // by the name of the first segment
  Work work_;
};

/// The counts of the sorts that are drawn: the sums, and the deepest tree.
SortCounts counts_of_sorts(const DisplayFile& display_file);

/// True if something is drawn in an order that is exactly back to front.
bool has_exact_order(const DisplayFile& display_file);

}  // namespace displayfile
