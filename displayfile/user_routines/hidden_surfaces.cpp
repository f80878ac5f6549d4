#include "displayfile/graphics_system.h"

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "clip/error.h"

namespace displayfile {

void GraphicsSystem::set_hidden_line_removal(bool on) {
  hidden_ = on;
  attributes_.back_face_removal = on;
  said_.insert(Setting::back_face_removal);
  record_said(Setting::hidden_line_removal, "set-hidden-line-removal", {on});
}

void GraphicsSystem::set_back_face_removal(bool on) {
  attributes_.back_face_removal = on;
  record_said(Setting::back_face_removal, "set-back-face-removal", {on});
}

void GraphicsSystem::set_hidden_method(HiddenMethod method) {
  const HiddenMethod known = displayfile::hidden_method(name_of(method));  // or refuses
  if (surfaces_of(known) == HiddenMethod::world_ray_cast) retain_for("world-ray-cast");
  method_ = known;
  said_.insert(Setting::hidden_method);
  record("set-hidden-method", {name_of(method)});
}

void GraphicsSystem::set_hidden_scope(HiddenScope scope) {
  scope_ = scope;
  record("set-hidden-scope", {name_of(scope)});
}

void GraphicsSystem::set_precision(const Precision& precision) {
  const double roundoff = precision.roundoff;
  if (!precision.exact && !(roundoff >= 0.0 && roundoff < 1.0)) {
    throw Error(fmt::format("ROUNDOFF {}: expected 0 or more and less than 1", roundoff));
  }
  sort_options_.precision = precision;
  if (recorder_ == nullptr) return;
  const std::string text = precision.exact ? "exact" : fmt::format("roundoff={}", roundoff);
  record("set-precision", {std::string_view(text)});
}

void GraphicsSystem::set_hidden_lines(HiddenLines lines) {
  sort_options_.hidden_lines = lines;
  record("set-hidden-lines", {name_of(lines)});
}

void GraphicsSystem::set_touching(const Touching& touching) {
  require_touching(touching);
  if (!touching_replaced_) touching_ = touching;
  record_touching(touching);
}

void GraphicsSystem::record_touching(const Touching& touching) {
  if (recorder_ == nullptr) return;
  const std::string word = word_of(touching);
  record("set-touching", {std::string_view(word)});
}

void GraphicsSystem::put_touching_in_force(const Touching& touching) {
  touching_ = touching;
  record_touching(touching);
}

void GraphicsSystem::replace_touching(const Touching& touching) {
  require_touching(touching);
  touching_ = touching;
  touching_replaced_ = true;
}

void GraphicsSystem::set_z_buffer(bool on) {
  z_buffer_ = on;
  record("set-z-buffer", {on});
}

}  // namespace displayfile
