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

std::string word_of(const Precision& precision) {
  return precision.exact ? "exact" : fmt::format("roundoff={}", precision.roundoff);
}

}  // namespace

/// Throws the Errors of all settings; retains a scene where one of them needs it.
void GraphicsSystem::State::require(const HiddenSurfaceSettings& settings) {
  if (settings.precision) require_precision(*settings.precision);
  if (settings.lines) require_selection(*settings.lines);
  if (settings.touching) require_touching(*settings.touching);
  if (settings.line_halo) require_line_halo(*settings.line_halo);
  if (settings.method) {
    const HiddenMethod known = hidden_method(name_of(*settings.method));  // or refuses
    if (surfaces_of(known) == HiddenMethod::world_ray_cast) retain_for("world-ray-cast");
  }
  if (settings.lines && !lines_replaced_ && !settings.lines->is_all_alone()) {
    retain_for("set-lines");
  }
}

void GraphicsSystem::set_hidden_surfaces(const HiddenSurfaceSettings& settings) {
  State& s = *state_;
  s.require(settings);
  if (settings.removal) {
    s.surfaces_.removal = *settings.removal;
    s.attributes_.back_face_removal = *settings.removal;
    s.explicit_.insert(Setting::back_face_removal);
    s.record_setting(Setting::hidden_line_removal, "set-hidden-line-removal", {*settings.removal});
  }
  if (settings.method) {
    s.surfaces_.method = *settings.method;
    s.record_setting(Setting::hidden_method, "set-hidden-method", {name_of(*settings.method)});
  }
  if (settings.z_buffer) {
    s.surfaces_.z_buffer = *settings.z_buffer;
    s.record("set-z-buffer", {*settings.z_buffer});
  }
  if (settings.scope) {
    s.surfaces_.scope = *settings.scope;
    s.record("set-hidden-scope", {name_of(*settings.scope)});
  }
  if (settings.precision) {
    s.surfaces_.precision = *settings.precision;
    s.record("set-precision", {std::string_view(word_of(*settings.precision))});
  }
  if (settings.hidden_lines) {
    s.surfaces_.hidden_lines = *settings.hidden_lines;
    s.record("set-hidden-lines", {name_of(*settings.hidden_lines)});
  }
  if (settings.line_order) {
    s.surfaces_.line_order = *settings.line_order;
    s.record("set-line-order", {name_of(*settings.line_order)});
  }
  if (settings.line_halo) {
    s.surfaces_.line_halo = *settings.line_halo;
    s.record("set-line-halo", {*settings.line_halo});
  }
  if (settings.lines) {
    if (!s.lines_replaced_) s.surfaces_.lines = *settings.lines;
    s.record_setting(Setting::lines, "set-lines", {std::string_view(words_of(*settings.lines))});
  }
  if (settings.touching) {
    if (!s.touching_replaced_) s.surfaces_.touching = *settings.touching;
    s.record_touching(*settings.touching);
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
