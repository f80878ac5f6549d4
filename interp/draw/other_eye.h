#pragma once

#include <memory>
#include <string>

#include "clip/view.h"
#include "displayfile/graphics_system.h"
#include "displayfile/segments/retained_scene.h"
#include "interp/draw/draw.h"

namespace displayfile {

/// A system as if its application had set another view, for one view after another. Methods that
/// work in image space draw what was retained (interp/draw/renderer.h); for all else, and
/// where cut faces are hatched, which is done anew in each view, the application's calls are
/// replayed in that view, once for each.
class OtherEye {
 public:
  /// The system, which must live on where it is, the scene that it retained, and all that was
  /// recorded of it: when more was called since, whatever draws or tells throws Error. Throws Error
  /// as scene_in_one_view (displayfile/views/scene_in_one_view.h) does.
  OtherEye(const GraphicsSystem& system, const RetainedScene& scene, std::string program);
  OtherEye(OtherEye&& other) noexcept;
  OtherEye& operator=(OtherEye&& other) noexcept;
  ~OtherEye();

  /// The one view in which the application drew.
  const View& as_drawn() const;

  /// Throws Error, and the view is what it was, if the view parameters do not fit together.
  void set_view(const View& view);

  /// The system that the application would have then. It stays until the view is set again.
  const GraphicsSystem& system();
  /// What was recorded, in that view (displayfile/text/program_in_view.h).
  std::string program() const;

  /// True if draw() draws a picture with these options in memory, without a replay.
  bool draws(const DrawOptions& options) const;
  /// As draw(system(), options), to the last bit. The picture stays until the next call.
  const Picture& draw(const DrawOptions& options);

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

}  // namespace displayfile
