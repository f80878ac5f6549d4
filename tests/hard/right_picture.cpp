#include "hard/right_picture.h"

#include <optional>

#include "displayfile/graphics_system.h"
#include "displayfile/segments/retained_scene.h"
#include "interp/truth/entered_truth.h"
#include "interp/truth/truth.h"

namespace displayfile {

Picture right_picture(const Scene& scene, JudgedFrom from, int size) {
  if (from == JudgedFrom::display_file) {
    return truth_as_entered(entered(scene).display_file(), size, size, false);
  }
  RetainedScene retained;
  GraphicsSystem system;
  system.retain(&retained);
  enter(scene, system);
  return entered_truth(retained, system.display_file(), size, size, false, std::nullopt).picture;
}

}  // namespace displayfile
