#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clip/geometry/bounds.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/fitted_view.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/retained_scene.h"

namespace displayfile {

/// A camera that follows a system's contents: for bindings, whose callers enter arrays of any size
/// anywhere and set the camera before or after. The primitives are retained, and viewed on demand,
/// in a view that is fitted to all of them (fitted_view.h). Following ends when the application
/// itself sets a view parameter, which acts on later segments alone.
///
/// The caller owns both; one FollowedView belongs to one system.
class FollowedView {
 public:
  /// Sets the camera of all segments entered since it began, and of those to come. Errors: a
  /// segment is open; segments that were not retained; the application has set the view or the
  /// window; those of fit_view, if anything is entered. Nothing is changed then.
  void look(GraphicsSystem& system, const Camera& camera);

  /// True if the application has set no view, and nothing is entered that was not followed.
  bool would_begin(const GraphicsSystem& system) const;
  /// Must be called before primitives of arrays are entered: if would_begin, a default camera
  /// begins to follow, with z up.
  void begin_by_default(GraphicsSystem& system);

  /// True if the application has set a camera or a window.
  static bool is_view_set(const GraphicsSystem& system);

  bool follows() const { return camera_.has_value(); }
  /// Must be called when something else changed on which the view depends, such as the aspect
  /// ratio.
  void changed() { viewed_.reset(); }

  /// Must be called before a segment is opened: sets the view for it, as far as it is known, for
  /// primitives that are placed by the view in force, such as axes_3.
  void place(GraphicsSystem& system);
  /// The same within a segment, for the primitives entered so far; called before axes_3.
  void place_in_segment(GraphicsSystem& system);

  /// Fits the view to all that is entered, for pictures with that aspect ratio, and views it; the
  /// open segment is left as it is. None: the system's aspect ratio. No effect if nothing has
  /// changed. Throws Error as fit_view does, and as close_segment.
  void bring_up_to_date(GraphicsSystem& system, std::optional<double> aspect = std::nullopt);

  /// Calls run(), which may call any routine, with everything entered so far viewed. If it sets the
  /// camera or the window, or `sets_view` and something is entered, following ends afterwards: the
  /// primitives entered keep their view.
  void running(GraphicsSystem& system, bool sets_view, const std::function<void()>& run);

  /// Calls enter(), which opens and closes one segment, in a view of its own, whatever the camera:
  /// along z, of x from 0 to `width` and y from 0 to 1, in the middle of a column at the right of
  /// the picture, of at least that part of the picture's width or height, whichever is smaller. If
  /// the camera follows, the followed scene is to the left of the column from then on, in pictures
  /// of any shape. The light in force leaves colours as they are. Errors: no room beside other
  /// columns; a modelling transformation or cutting planes in force.
  void enter_beside(GraphicsSystem& system, double width, const std::function<void()>& enter);
  /// True for a segment entered by it.
  bool is_beside(const RetainedScene::Segment& segment) const;

  const std::optional<Camera>& camera() const { return camera_; }
  /// The fitted view of all followed segments, after bring_up_to_date.
  const std::optional<View>& view() const { return fitted_; }

  /// The program that a recorder wrote since following began, in the fitted view.
  std::string recorded(std::string_view program) const;

 private:
  /// A segment with a view of its own.
  struct Beside {
    std::uint32_t opened;
    int name;      ///< when it was opened
    double width;  ///< of its window, whose height is 1
    View view, in_picture;
  };
  bool is_followed(const RetainedScene::Segment& segment) const;
  std::vector<std::uint32_t> followed(const RetainedScene& scene) const;
  CameraAsSet as_set(const GraphicsSystem& system) const;
  std::optional<View> view_of(const GraphicsSystem& system, const Camera& camera) const;
  View view_before_fit(const GraphicsSystem& system) const;
  void begin(GraphicsSystem& system, const Camera& camera);
  void set_view(GraphicsSystem& system, const View& view);
  void arrange_columns(double aspect);
  void stop();
  void count_bounds(const RetainedScene& scene);

  std::optional<Camera> camera_;
  std::uint32_t first_ = 0;                       // segment that it follows, as opened
  std::optional<View> fitted_;                    // the view of all that is viewed
  std::optional<RetainedScene::Edition> viewed_;  // as it was then
  Bounds bounds_;                                 // of what has been counted
  std::uint32_t counted_ = 0;                     // segments, as opened
  bool has_followed_ = false;
  std::vector<Beside> beside_;
  std::vector<Point3> lights_;  // default ones, each in place of those before
  double columns_right_ = 1.0;  // of the columns in beside_
  double right_ = 1.0;          // of the viewport for what it follows
};

}  // namespace displayfile
