#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "displayfile/views/turntable.h"
#include "interp/draw/renderer.h"

namespace displayfile {

/// Views at equal angles around a turntable.
struct TurntableViews {
  static constexpr int kMost = 10000;

  int number = 0;                             ///< 1 to kMost
  int first = 0, end = number;                ///< those in [first, end) are drawn into files
  std::optional<Point3> axis = std::nullopt;  ///< none: the view's up
  bool fit_window = false;                    ///< to all of them
};

/// Throws Error for anything but 1 to TurntableViews::kMost views.
void require_turntable_views(int number);

/// Throws Error if the options' method does not draw views of a retained scene, or if it draws all
/// segments together and the scope is `segment`.
void require_turntable_method(const DrawOptions& options);

/// The options of a picture completed by a system's settings, for views of its retained scene.
/// Throws Error for options out of range.
DrawOptions options_of_views(const GraphicsSystem& system, const DrawOptions& options);

/// The name of one of `views` files: with a number of at least three digits before the extension,
/// as OUT-000.png for OUT.png.
std::filesystem::path numbered(const std::filesystem::path& file, int number, int views);

/// Throws the Errors that drawing these views into numbered files would throw before drawing, as
/// require_drawable (interp/draw/draw.h) does.
void require_views_drawable(const TurntableViews& views, const std::filesystem::path& file,
                            const DrawOptions& options);

/// Draws a retained scene rotated about an axis through its middle (displayfile/views/turntable.h),
/// in views at equal angles, each by a Renderer: by default all from one BSP tree in world
/// coordinates. A view is the same, bit for bit, whichever others are drawn. If the application
/// edits the scene, it is prepared again, with its middle and fitted window. Not thread-safe: for
/// use by one thread, which works with as many threads as the options set.
class TurntableRenderer {
 public:
  /// `scene` was retained by a system, whose display file has the visibility and image
  /// transformations of segments. Both must outlive this, and may be edited and moved. Options not
  /// set are those of `system`, which need not outlive it. Throws Error as require_turntable_views
  /// and require_turntable_method do, for options out of range, and if the segments were drawn in
  /// several views.
  TurntableRenderer(const GraphicsSystem& system, const RetainedScene& scene,
                    const DisplayFile& display_file, const TurntableViews& views,
                    const DrawOptions& options);
  TurntableRenderer(TurntableRenderer&& other) noexcept;
  TurntableRenderer& operator=(TurntableRenderer&& other) noexcept;
  ~TurntableRenderer();

  int views() const;
  /// Completed by the system's settings.
  const DrawOptions& options() const;

  /// Throws Error as draw (interp/draw/draw.h) does, for a view out of range, and as the
  /// constructor for an edited scene, here and below.
  Picture draw(int view);
  /// Draws into a file, whose format is that of the options or its extension, as in draw.
  void draw(int view, const Destination& to);
  /// Draws into the numbered file, with the options' `ids` and `depth` numbered likewise. Returns
  /// its name.
  std::filesystem::path draw_numbered(int view, const std::filesystem::path& file);
  /// Returns the memory of an unused picture, for the next one.
  void give_back(Picture picture);

  /// The renderer of the views.
  const Renderer& renderer() const;

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

}  // namespace displayfile
