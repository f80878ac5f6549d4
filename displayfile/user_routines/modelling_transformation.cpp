#include "displayfile/user_routines/system_state.h"

#include <fmt/format.h>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "displayfile/user_routines/ranges.h"

namespace displayfile {

void GraphicsSystem::create_transformation_3() {
  state_->modelling_.create();
  state_->record("create-transformation-3", {});
}

void GraphicsSystem::translate_3(double tx, double ty, double tz) {
  const RoundToNearest nearest;
  require_finite({tx, ty, tz}, "translation");
  state_->modelling_.translate({tx, ty, tz});
  state_->record("translate-3", {tx, ty, tz});
}

void GraphicsSystem::scale_3(double sx, double sy, double sz) {
  const RoundToNearest nearest;
  require_finite({sx, sy, sz}, "scale");
  state_->modelling_.scale({sx, sy, sz});
  state_->record("scale-3", {sx, sy, sz});
}

void GraphicsSystem::rotate_x_3(double angle) {
  const RoundToNearest nearest;
  require_finite({angle}, "angle");
  state_->modelling_.rotate_x(angle);
  state_->record("rotate-x-3", {angle});
}

void GraphicsSystem::rotate_y_3(double angle) {
  const RoundToNearest nearest;
  require_finite({angle}, "angle");
  state_->modelling_.rotate_y(angle);
  state_->record("rotate-y-3", {angle});
}

void GraphicsSystem::rotate_z_3(double angle) {
  const RoundToNearest nearest;
  require_finite({angle}, "angle");
  state_->modelling_.rotate_z(angle);
  state_->record("rotate-z-3", {angle});
}

void GraphicsSystem::save_transformation_3() {
  const RoundToNearest nearest;
  if (state_->modelling_.saved() == kMostSaved) {
    throw Error(
        fmt::format("{} transformations are saved: expected one to be restored first", kMostSaved));
  }
  state_->modelling_.save();
  state_->record("save-transformation-3", {});
}

void GraphicsSystem::restore_transformation_3() {
  const RoundToNearest nearest;
  if (state_->modelling_.saved() == 0) throw Error("no transformation saved");
  state_->modelling_.restore();
  state_->record("restore-transformation-3", {});
}

}  // namespace displayfile
