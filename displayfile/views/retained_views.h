#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <memory>
#include <vector>

#include "clip/surfaces.h"
#include "clip/view.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"
#include "displayfile/segments/sorted_scene.h"
#include "displayfile/views/taken_scene.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// One tree, many views: a retained scene's hidden surfaces are sorted once, in world coordinates,
/// and ordered for each view by a traversal of the tree (hidden/sort/world_tree.md).
class RetainedViews {
 public:
  /// Prepares for the visible segments of the scene; `attributes` is the display file of the system
  /// that retained them, with their visibility and image transformations. Both may be edited and
  /// moved: the next view sorts again. After one is destroyed, views show the last state prepared.
  /// Throws Error for more than 2^32 - 1 points, and if segments with different image
  /// transformations are to be sorted together, since these act after viewing.
  ///
  /// With scope `segment` each segment has a tree, otherwise there is one for all. The trees use
  /// the plan's precision, root and most_pieces; hidden lines are found and drawn in each view.
  /// Progress is not reported.
  RetainedViews(const RetainedScene& scene, const DisplayFile& attributes,
                const SurfacePlan& plan = {});
  RetainedViews(RetainedViews&&) noexcept;
  RetainedViews& operator=(RetainedViews&&) noexcept;
  ~RetainedViews();

  /// The scene in this view, as if the application had drawn it there: the polygons clipped and
  /// checked for back faces, whole and in order of entry; and sorted, with the lines over them that
  /// close-segment would find: lines of intersection if segments select them, and hidden ones if
  /// the plan has them. `lights_turned` rotates the lights. Throws Error as ViewVolume does, and as
  /// the constructor for an edited scene.
  DisplayFile view(const View& view, const glm::dmat3& lights_turned = glm::dmat3(1.0));

  /// True if the trees are those that this plan would make, within its limit of pieces and that of
  /// the budget in force. These limits then apply to them.
  bool take_up(const SurfacePlan& plan);

  /// Here and below: for the last state prepared.
  std::size_t trees() const { return parts_.size(); }
  /// The counts of the trees, for all views. Comparisons are those of building them.
  const SortCounts& counts() const { return counts_; }
  std::uint64_t walks() const;   ///< of a tree
  std::uint64_t reused() const;  ///< orders reused because the eye crossed no plane

 private:
  class Part;
  void take();
  void bring_up_to_date();
  TakenScene taken_;
  std::vector<std::unique_ptr<Part>> parts_;
  SurfacePlan plan_;
  std::size_t limit_ = 0;  // of pieces, that was in force as the trees were made
  SortCounts counts_;
};

}  // namespace displayfile
