#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "displayfile/views/turntable.h"
#include "interp/draw/renderer.h"

namespace displayfile {

/// So many views evenly around a turntable.
struct TurntableViews {
  static constexpr int kMost = 10000;

  int number = 0;                             ///< 1 to kMost
  std::optional<Point3> axis = std::nullopt;  ///< none given: the view's up
  bool fit_window = false;                    ///< to all of them
};

/// Throws Error for anything but 1 to TurntableViews::kMost views.
void require_turntable_views(int number);

/// Throws Error if the options' method does not draw views of a retained scene, or if it draws all
/// segments together and the scope is each.
void require_turntable_method(const DrawOptions& options);

/// Which views of a turntable are drawn: of so many, from one up to, but not including, another.
struct ViewsDrawn {
  int all = 0, first = 0, end = 0;
};

/// The name of one of `views` files: with a number of three digits or more before the extension, as
/// OUT-000.png for OUT.png.
std::filesystem::path numbered(const std::filesystem::path& file, int number, int views);

/// Throws the Errors that drawing these views into numbered files would throw before it draws
/// anything, as require_drawable (interp/draw/draw.h) does.
void require_views_drawable(const ViewsDrawn& views, const std::filesystem::path& file,
                            const DrawOptions& options);

/// Draws a retained scene turned about an axis through its middle (displayfile/views/turntable.h),
/// in any of some views evenly around, each by a Renderer: where no method is set all from one BSP
/// tree in world coordinates. A view is the same, bit for bit, whichever others are drawn. Where
/// the application edited the scene, it is taken up anew, with its middle and what the window is
/// fitted to. For one thread, which shares the work among as many as the options say.
class TurntableRenderer {
 public:
  /// What is to be drawn: `scene`, which a system retained, and the display file of that system,
  /// which says which segments are visible and how their images are transformed. Both must live on,
  /// and may be edited and moved. What the options do not say is as `system` has it; it need not
  /// live on. Throws Error as require_turntable_views and require_turntable_method do, for options
  /// out of their range, and if the segments were drawn in several views.
  TurntableRenderer(const GraphicsSystem& system, const RetainedScene& scene,
                    const DisplayFile& display_file, const TurntableViews& views,
                    const DrawOptions& options);
  TurntableRenderer(TurntableRenderer&& other) noexcept;
  TurntableRenderer& operator=(TurntableRenderer&& other) noexcept;
  ~TurntableRenderer();

  int views() const;
  /// With what the system had set.
  const DrawOptions& options() const;

  /// Throws Error as draw (interp/draw/draw.h) does, for a view that there is not, and as the
  /// constructor for a scene that was edited: here as below.
  Picture draw(int view);
  /// For a file the options' format or its extension says how, as for draw.
  void draw(int view, const Destination& to);
  /// Into the file that is numbered so, as are the options' `ids` and `depth`. Returns its name.
  std::filesystem::path draw_numbered(int view, const std::filesystem::path& file);
  /// The memory of a picture that is no longer needed, for the next.
  void give_back(Picture picture);

  /// That views are drawn by.
  const Renderer& renderer() const;

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

}  // namespace displayfile
