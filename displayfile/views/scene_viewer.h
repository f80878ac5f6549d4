#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/mat3x3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "clip/view.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"
#include "displayfile/segments/viewed_scene.h"
#include "displayfile/views/taken_scene.h"
#include "displayfile/views/triangle_sieve.h"
#include "hidden/exact/pixel_centre.h"

namespace displayfile {

/// A retained scene in new views, unsorted, for image-space methods
/// (displayfile/views/scene_viewer.md). Each vertex is transformed once, however many polygons
/// share it; polygons that are outside, turned away or between pixel centres cost a few
/// instructions; and from the third view on no memory is allocated, as long as the clipped parts do
/// not grow and no lines are selected.
class SceneViewer {
 public:
  /// The scene, and the display file of the system that retained it, with the visibility and image
  /// transformations of segments. Both must outlive it. Vertices equal bit for bit are merged here,
  /// if the application shared none.
  SceneViewer(const RetainedScene& scene, const DisplayFile& attributes);
  ~SceneViewer();
  SceneViewer(SceneViewer&&) noexcept;
  SceneViewer& operator=(SceneViewer&&) noexcept;

  struct Wanted {
    View view;
    glm::dmat3 lights_turned = glm::dmat3(1.0);  ///< a rotation
    /// For a picture of this size only: omits fills without drawn sides that cannot cover a pixel
    /// centre, unless shadows, lines or texts are drawn. Sides up to 65535.
    std::optional<PictureSize> centres_of = std::nullopt;
    int threads = 1;  ///< the result does not depend on it
  };
  /// Prepares again for a scene that has changed; view() does it too. Returns true if it had
  /// changed. Throws Error if the scene or the display file is destroyed.
  bool bring_up_to_date();
  const RetainedScene& scene() const { return taken_.scene(); }
  const DisplayFile& attributes() const { return taken_.attributes(); }

  /// The visible segments in their present state, in that view: the scene of display_file(view),
  /// without omitted fills. Valid until the next call. Throws Error as ViewVolume does, and as
  /// bring_up_to_date.
  const ViewedScene& view(const Wanted& wanted);

  /// The primitives of the last view's items, in order; empty without shadows.
  std::span<const std::uint32_t> primitive_of_items() const { return primitive_of_items_; }
  bool shows_shadows() const { return shows_shadows_; }  ///< in a view
  bool is_lit() const { return is_lit_; }                ///< so that colours follow the lights
  /// True if a visible segment's image was transformed in the last view.
  bool has_images() const;

  /// The display file as if the application had drawn in that view: the polygons clipped and
  /// checked for back faces, whole and in order of entry.
  DisplayFile display_file(const View& view,
                           const glm::dmat3& lights_turned = glm::dmat3(1.0)) const;

  std::size_t bytes() const;  ///< of the arrays, as used in the last view

 private:
  class Part;
  /// The attributes relevant to viewing, in few bytes.
  struct Look {
    bool is_nothing;  ///< hollow, with line style none
    bool is_plain;    ///< solid, without drawn sides and shadows
    bool is_lit, removes_back_faces;
  };
  static Look look_of(const Attributes& attributes);
  /// A block of points.
  struct Block {
    std::uint32_t segment, first, end;  ///< of points
    double largest_depth;               ///< of them, in the last view
  };
  struct SegmentNow {
    std::uint32_t first_point, end_point;
    bool visible = false;
    ImageTransformation image = {};
  };
  void take_up_scene();
  void begin_entered();
  void leave_what_was_entered();
  void take_what_was_entered();
  std::function<EnteredPolygon(std::uint32_t)> polygon_of() const;
  std::function<void(const ViewedScene&, std::vector<std::uint32_t>&)> polygons_of_items() const;
  void begin_planes();
  bool is_as_viewed(const ViewVolume& volume);
  void find_entered(const ViewVolume& volume);
  void find_radius(const ViewVolume& volume);
  static void find_primitives(const RetainedScene& scene, const ViewedScene& viewed,
                              std::size_t corners, std::vector<std::uint32_t>& primitives);
  bool take_segments();
  void share_equal_vertices();
  void view_points(const Wanted& wanted, const ViewVolume& volume);
  template <class Take>
  void take_parts(Take&& take);
  void number_own_corners();
  void view_texts(const ViewVolume& volume);

  TakenScene taken_;
  const RetainedScene* scene_ = nullptr;  // in the current view, as the next
  const DisplayFile* attributes_ = nullptr;
  std::uint64_t palette_ = 0;  // of all its viewed scenes
  /// The scene's polygons as entered, and which of them touch, found once for all views.
  struct Entered;
  std::shared_ptr<Entered> entered_;
  std::vector<Point3> welded_;      // points, if the application shared none
  std::span<const Point3> points_;  // in world coordinates
  std::size_t corners_ = 0;         // of the retained scene
  bool all_edges_drawn_ = true;
  bool selects_lines_ = false;
  std::vector<LineKinds> sides_;  // of the corners in the last view, if lines are selected
  std::vector<Look> looks_;       // of attributes, without colours
  bool shows_shadows_ = false;    // then polygons between pixel centres matter
  bool shows_lines_ = false;      // or texts: the same
  bool is_lit_ = false;
  std::vector<SegmentNow> segments_;
  std::vector<Block> blocks_;
  std::vector<std::uint8_t> outcodes_;  // of the points
  std::vector<PicturePlace> places_;    // the same, in a picture of a size
  std::vector<std::unique_ptr<Part>> parts_;
  ViewedScene viewed_;
  std::vector<std::uint32_t> primitive_of_items_;
  std::optional<Wanted> last_;  // of the view that viewed_ is
};

}  // namespace displayfile
