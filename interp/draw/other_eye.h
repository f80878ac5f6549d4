#pragma once

#include <memory>
#include <string>

#include "clip/view.h"
#include "displayfile/graphics_system.h"
#include "displayfile/segments/retained_scene.h"
#include "interp/draw/draw.h"

namespace displayfile {

/// A system as if its application had set another view, for successive views. Image-space methods
/// draw the retained scene (interp/draw/renderer.h); for all else, and where cut faces are hatched,
/// which depends on the view, the application's calls are replayed in that view, once per view.
class OtherEye {
 public:
  /// The system, which must outlive this at its address, its retained scene, and its recorded
  /// program: after further calls on the system, members throw Error. Throws Error as
  /// scene_in_one_view (displayfile/views/scene_in_one_view.h) does.
  OtherEye(const GraphicsSystem& system, const RetainedScene& scene, std::string program);
  OtherEye(OtherEye&& other) noexcept;
  OtherEye& operator=(OtherEye&& other) noexcept;
  ~OtherEye();

  /// The application's view.
  const View& as_drawn() const;

  /// Throws Error, leaving the view unchanged, if the view parameters do not fit together.
  void set_view(const View& view);

  /// The system that the application would have then. Valid until the view is set again.
  const GraphicsSystem& system();
  /// The recorded program in that view (displayfile/text/program_in_view.h).
  std::string program() const;

  /// True if draw() draws a picture with these options in memory, without a replay.
  bool draws(const DrawOptions& options) const;
  /// As draw(system(), options), bit for bit. The picture is valid until the next call.
  const Picture& draw(const DrawOptions& options);

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

}  // namespace displayfile
