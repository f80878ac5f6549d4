#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "displayfile/graphics_system.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/segment.h"
#include "displayfile/segments/surface_plan.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// Connected components of segments that overlap in the projection: no segment hides anything of
/// another group. By their extents, after the image transformations, lines without their width.
using SegmentGroup = std::vector<const Segment*>;

/// The segments in groups; both keep the input order, groups by their first segment.
std::vector<SegmentGroup> overlapping_groups(std::span<const Segment* const> segments);

/// Throws Error if hidden lines are to be drawn and the method is the colour rule over unsorted
/// surfaces, which finds no lines.
void require_hidden_lines_found(HiddenLines hidden_lines, HiddenMethod method);

/// True if SortedDisplayFile::update, by a method that sorts, sorts all visible segments together.
bool sorts_together(const GraphicsSystem& system, const HiddenSurfaceOptions& options,
                    const SurfacePlan& plan, HiddenMethod by);

/// A display file with its hidden surfaces sorted for the next drawing. Kept between drawings, it
/// sorts only what has changed.
class SortedDisplayFile {
 public:
  /// Updates it from the application's display file; the plan is that of the options and the system
  /// (resolve_surfaces).
  ///
  /// `by` is the method in force, with `automatic` replaced by its choice if that sorts; otherwise
  /// `automatic` is sorted as the map, and `none` is passed where nothing is to be sorted. If it
  /// sorts,
  ///  - a method that the application set leaves the segments as close-segment left them, unless
  ///    the scope is all; only a segment that has an image transformation since, or for which the
  ///    options have another precision or other hidden lines, is sorted again;
  ///  - a method of the options sorts all visible segments together, each group that overlaps by
  ///    itself (displayfile/segments/sorted_display_file.h), or each on its own if the options or
  ///    the application set that scope; one that `automatic` means, and any with line order
  ///    `depth`, sorts all together, whatever the scope.
  /// If it does not sort, a method of the options is drawn from the polygons as entered, and one
  /// set by the application from the segments as closed. Invisible segments stay unchanged.
  const DisplayFile& update(const GraphicsSystem& system, const HiddenSurfaceOptions& options,
                            const SurfacePlan& plan, HiddenMethod by);
  /// The same with the plan that the options and the system give.
  const DisplayFile& update(const GraphicsSystem& system, HiddenMethod by,
                            const HiddenSurfaceOptions& options = {}) {
    return update(system, options, resolve_surfaces(system, options), by);
  }

  /// Updates it from another display file, such as that of a new view: its visible segments are
  /// sorted by the plan's method, a sort or one that finds lines, together unless the plan's scope
  /// is `segment` and its line order is that of entry.
  const DisplayFile& update(const DisplayFile& entered, const SurfacePlan& plan);

  /// The display file after the last successful update.
  const DisplayFile& display_file() const { return file_; }

  /// Work of the last update with scope `all`: the number of groups of overlapping segments, and of
  /// those that had to be sorted because a segment changed.
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
  SortedGroup sorted_group(const SegmentGroup& group, const SurfacePlan& plan);
  template <class Sort>
  const DisplayFile& sort_anew(const DisplayFile& entered, const Sort& sort);
  void sort_as_closed(const HiddenSurfaceOptions& options, const SurfacePlan& plan);
  void sort_segments(const SurfacePlan& plan);
  void sort_together(const SurfacePlan& plan);
  void sort_segment(const Segment& segment, const SurfacePlan& set);
  void unsort();

  DisplayFile file_;
  DisplayFile last_;                             // of the update before, while file_ is being made
  std::unordered_map<int, SortedGroup> groups_;  // by the name of the first segment
  Work work_;
};

/// The counts of the drawn sorts: sums, and the maximum depth of a tree.
SortCounts counts_of_sorts(const DisplayFile& display_file);

/// True if a drawn order is exactly back to front.
bool has_exact_order(const DisplayFile& display_file);

}  // namespace displayfile
