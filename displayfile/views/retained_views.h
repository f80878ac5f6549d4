#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <memory>
#include <vector>

#include "clip/surface_plan.h"
#include "clip/view.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"
#include "displayfile/segments/sorted_scene.h"
#include "displayfile/views/taken_scene.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// One tree, many views: the hidden surfaces of a retained scene sorted once, in world coordinates,
/// and put in order for each view by a walk of the tree (hidden/sort/world_tree.md).
class RetainedViews {
 public:
  /// Takes the visible segments of the scene; `attributes` is the display file of the system that
  /// retained them and says which are visible, and their image transformations. Both may be edited
  /// and moved: the next view sorts anew. Once one of them is gone, views are of what was taken
  /// last. Throws Error for more than 2^32 - 1 points, and if segments with different image
  /// transformations are to be sorted together: those act after viewing.
  ///
  /// With scope `segment` each segment has a tree, otherwise there is one for all. Of the plan the
  /// trees follow precision, root and most_pieces; hidden lines are found in each view, and drawn
  /// too. Progress is not reported.
  RetainedViews(const RetainedScene& scene, const DisplayFile& attributes,
                const SurfacePlan& plan = {});
  RetainedViews(RetainedViews&&) noexcept;
  RetainedViews& operator=(RetainedViews&&) noexcept;
  ~RetainedViews();

  /// What the scene is in this view, as if the application had drawn it there: the polygons clipped
  /// and checked for back faces, whole and in order of entry; and sorted, with the lines over them
  /// that close-segment would find: where polygons pass through each other, if segments select
  /// that, and hidden ones if the plan has them. Lights are turned by
  /// `lights_turned`, a rotation. Throws Error as ViewVolume does, and as the constructor for a
  /// scene that was edited.
  DisplayFile view(const View& view, const glm::dmat3& lights_turned = glm::dmat3(1.0));

  /// True if the trees are those that this plan would make, within its limit of pieces and that of
  /// the budget in force; then these hold from now on.
  bool take_up(const SurfacePlan& plan);

  /// Here as below of the scene as it was taken last.
  std::size_t trees() const { return parts_.size(); }
  /// The counts of the trees, for all views. Comparisons are those of building them.
  const SortCounts& counts() const { return counts_; }
  std::uint64_t walks() const;   ///< of a tree
  std::uint64_t reused() const;  ///< orders that needed no walk, since the eye crossed no plane

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
