#include <fmt/format.h>

#include <string>
#include <string_view>

#include "clip/base/error.h"
#include "displayfile/user_routines/system_inside.h"
#include "displayfile/user_routines/system_state.h"

namespace displayfile {

namespace {

void require_precision(const Precision& precision) {
  const double roundoff = precision.roundoff;
  if (precision.exact || (roundoff >= 0.0 && roundoff < 1.0)) return;
  throw Error(fmt::format("ROUNDOFF {}: expected 0 or more and less than 1", roundoff));
}

}  // namespace

/// Throws the Errors of all options; retains a scene if one of them needs it.
void GraphicsSystem::State::require(const HiddenSurfaceOptions& options) {
  if (options.sets_calls()) {
    throw Error(
        "root, threads, most_pieces, progress and budget are of one call, such as of draw: "
        "expected "
        "none of them where the application's hidden surfaces are set");
  }
  if (options.precision) require_precision(*options.precision);
  if (options.lines) require_selection(*options.lines);
  if (options.touching) require_touching(*options.touching);
  if (options.line_halo) require_line_halo(*options.line_halo);
  if (options.method) {
    const HiddenMethod known = hidden_method(name_of(*options.method));  // or refuses
    if (surfaces_of(known) == HiddenMethod::world_ray_cast) retain_for("world-ray-cast");
  }
  if (options.lines && !lines_replaced_ && !options.lines->is_all_alone()) {
    retain_for("set-lines");
  }
}

void GraphicsSystem::set_hidden_surfaces(const HiddenSurfaceOptions& options) {
  State& s = *state_;
  s.require(options);
  if (options.removal) {
    s.surfaces_.removal = *options.removal;
    s.looks_.attributes.back_face_removal = *options.removal;
    s.explicit_.insert(Setting::back_face_removal);
    s.record_setting(Setting::hidden_line_removal, "set-hidden-line-removal", {*options.removal});
  }
  if (options.method) {
    s.surfaces_.method = *options.method;
    s.record_setting(Setting::hidden_method, "set-hidden-method", {name_of(*options.method)});
  }
  if (options.z_buffer) {
    s.surfaces_.z_buffer = *options.z_buffer;
    s.record("set-z-buffer", {*options.z_buffer});
  }
  if (options.scope) {
    s.surfaces_.scope = *options.scope;
    s.record("set-hidden-scope", {name_of(*options.scope)});
  }
  if (options.precision) {
    s.surfaces_.precision = *options.precision;
    s.record("set-precision", {std::string_view(word_of(*options.precision))});
  }
  if (options.hidden_lines) {
    s.surfaces_.hidden_lines = *options.hidden_lines;
    s.record("set-hidden-lines", {name_of(*options.hidden_lines)});
  }
  if (options.line_order) {
    s.surfaces_.line_order = *options.line_order;
    s.record("set-line-order", {name_of(*options.line_order)});
  }
  if (options.line_halo) {
    s.surfaces_.line_halo = *options.line_halo;
    s.record("set-line-halo", {*options.line_halo});
  }
  if (options.lines) {
    if (!s.lines_replaced_) s.surfaces_.lines = *options.lines;
    s.record_setting(Setting::lines, "set-lines", {std::string_view(words_of(*options.lines))});
  }
  if (options.touching) {
    if (!s.touching_replaced_) s.surfaces_.touching = *options.touching;
    s.record_touching(*options.touching);
  }
}

const HiddenSurfaces& GraphicsSystem::hidden_surfaces() const { return state_->surfaces_; }

void GraphicsSystem::State::record_touching(const Touching& touching) {
  record("set-touching", {std::string_view(word_of(touching))});
}

void SystemInside::replace_touching(GraphicsSystem& system, const Touching& touching) {
  require_touching(touching);
  system.state_->surfaces_.touching = touching;
  system.state_->touching_replaced_ = true;
}

void SystemInside::with_automatic_reach(GraphicsSystem& system, double reach,
                                        const std::function<void()>& enter) {
  GraphicsSystem::State& s = *system.state_;
  Touching& touching = s.surfaces_.touching;
  if (touching.kind != Touching::Kind::automatic) return enter();
  touching = {Touching::Kind::length, reach};
  s.record_touching(touching);
  try {
    enter();
  } catch (...) {
    touching = {Touching::Kind::automatic};
    throw;
  }
  touching = {Touching::Kind::automatic};
  s.record_touching(touching);
}

}  // namespace displayfile
