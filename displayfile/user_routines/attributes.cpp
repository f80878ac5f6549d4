#include "displayfile/user_routines/system_state.h"

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "clip/geometry/crease_angle.h"
#include "clip/geometry/unit.h"
#include "displayfile/user_routines/ranges.h"
#include "displayfile/user_routines/system_inside.h"

namespace displayfile {

namespace {

void require_line_length(double length) {
  if (length > 0.0 && length <= 1e6) return;
  throw Error(
      fmt::format("line width or dash {}: expected more than 0 pixels and at most 1e6", length));
}

void require_line_kind_style(const LineKindStyle& style) {
  if (style.kind == LineStyle::Kind::none) {
    throw Error("style of a kind of lines: expected solid or dashed, not none");
  }
  if (style.dash.has_value() != style.gap.has_value() ||
      (style.dash && style.kind != LineStyle::Kind::dashed)) {
    throw Error("style of a kind of lines: expected dash and gap together, with dashed");
  }
  for (const auto& length : {style.width, style.dash, style.gap}) {
    if (length) require_line_length(*length);
  }
  if (style.colour) require_colour(*style.colour);
}

/// The arguments of set-line-kind-style after the kind.
std::string words_of(const LineKindStyle& style) {
  std::string words = style.width ? fmt::format("{}", *style.width) : "same";
  if (style.kind) words += *style.kind == LineStyle::Kind::solid ? " solid" : " dashed";
  if (style.dash) words += fmt::format(" {} {}", *style.dash, *style.gap);
  if (const auto& c = style.colour) words += fmt::format(" {} {} {}", c->r, c->g, c->b);
  return words;
}

}  // namespace

void GraphicsSystem::set_fill_style(const FillStyle& style) {
  state_->attributes_changed();
  if (style.kind == FillStyle::Kind::hollow) {
    state_->looks_.attributes.fill = {
        FillStyle::Kind::hollow};  // a colour has no meaning here: one representation
    return state_->record_setting(Setting::fill_style, "set-fill-style", {"hollow"});
  }
  require_colour(style.colour);
  state_->looks_.attributes.fill = {FillStyle::Kind::solid, style.colour};
  state_->record_setting(Setting::fill_style, "set-fill-style",
                         {"solid", style.colour.r, style.colour.g, style.colour.b});
}

void GraphicsSystem::set_line_style(const LineStyle& style) {
  const LineStyle checked = state_->require_line_style(style);
  state_->attributes_changed();
  LineStyle& line = state_->looks_.attributes.line;
  line = {checked.kind, checked.colour, checked.width, checked.dash, checked.gap, line.of_kinds};
  state_->replace_width(line);
  state_->explicit_.insert(Setting::line_style);
  state_->record_line_style("set-line-style", checked);
}

/// Gives each style one representation: members without a meaning in its kind have their defaults.
LineStyle GraphicsSystem::State::require_line_style(const LineStyle& style) {
  if (style.kind == LineStyle::Kind::none) return {LineStyle::Kind::none};
  require_colour(style.colour);
  for (const double length : {style.width, style.dash, style.gap}) require_line_length(length);
  if (style.kind != LineStyle::Kind::dashed) return {style.kind, style.colour, style.width};
  return {style.kind, style.colour, style.width, style.dash, style.gap};
}

void GraphicsSystem::State::record_line_style(std::string_view routine, const LineStyle& style) {
  const Colour& c = style.colour;
  switch (style.kind) {
    case LineStyle::Kind::none: return record(routine, {"none"});
    case LineStyle::Kind::solid: return record(routine, {"solid", c.r, c.g, c.b, style.width});
    case LineStyle::Kind::dashed:
      return record(routine, {"dashed", c.r, c.g, c.b, style.width, style.dash, style.gap});
  }
}

void GraphicsSystem::set_line_kind_style(StyledLines lines, const LineKindStyle& style) {
  require_line_kind_style(style);
  if (!state_->has_replaced_style(lines)) state_->change_line_kind_style(lines, style);
  state_->record("set-line-kind-style", {name_of(lines), std::string_view(words_of(style))});
}

void GraphicsSystem::State::change_line_kind_style(StyledLines lines, const LineKindStyle& style) {
  attributes_changed();
  LineKindStyles& of_kinds = looks_.attributes.line.of_kinds;
  of_kinds = of_kinds.with(lines, style);
}

void GraphicsSystem::State::replace_width(LineStyle& line) const {
  if (line.kind != LineStyle::Kind::none) line.width = width_replaced_.value_or(line.width);
}

void SystemInside::replace_line_width(GraphicsSystem& system, double pixels) {
  require_line_length(pixels);
  GraphicsSystem::State& s = *system.state_;
  s.attributes_changed();
  s.width_replaced_ = pixels;
  s.replace_width(s.looks_.attributes.line);
  if (auto& lower = s.looks_.surfaces.lower_line) s.replace_width(*lower);
}

void SystemInside::replace_line_kind_style(GraphicsSystem& system, StyledLines lines,
                                           const LineKindStyle& style) {
  require_line_kind_style(style);
  system.state_->change_line_kind_style(lines, style);
  system.state_->styles_replaced_ |= 1u << static_cast<unsigned>(lines);
}

void GraphicsSystem::set_text_style(const TextStyle& style) {
  if (!(style.size > 0.0 && style.size <= 1.0)) {
    throw Error(fmt::format(
        "text size {}: expected more than 0 and at most 1, the picture's height", style.size));
  }
  state_->looks_.attributes.text = style;
  if (style.always) {
    state_->record("set-text-style", {style.size, name_of(style.alignment), "always"});
  } else {
    state_->record("set-text-style", {style.size, name_of(style.alignment)});
  }
}

void GraphicsSystem::set_light(const Point3& toward, double ambient) {
  const RoundToNearest nearest;
  require_finite({toward.x, toward.y, toward.z}, "light direction");
  if (toward == Point3(0.0)) throw Error("light direction is zero: expected a direction");
  if (!(ambient >= 0.0 && ambient <= 1.0)) {
    throw Error(fmt::format("ambient light {}: expected 0 to 1", ambient));
  }
  state_->attributes_changed();
  state_->looks_.attributes.light = {unit(toward), ambient};
  state_->record_setting(Setting::light, "set-light", {toward.x, toward.y, toward.z, ambient});
}

void GraphicsSystem::set_shading(Shading shading) {
  state_->looks_.attributes.shading = shading;
  state_->record("set-shading", {name_of(shading)});
}

void GraphicsSystem::set_crease_angle(double degrees) {
  require_crease_angle(degrees);
  state_->looks_.crease_degrees = degrees;
  state_->record_setting(Setting::crease_angle, "set-crease-angle", {degrees});
}

void GraphicsSystem::set_shadows(bool on) {
  state_->looks_.attributes.shadows = on;
  state_->record("set-shadows", {on});
}

void GraphicsSystem::set_vertex_normals(PointList<Point3> normals) {
  if (normals.size() == 1 || normals.size() == 2) {
    throw Error(
        fmt::format("normals of {} vertices: expected at least 3, or none", normals.size()));
  }
  for (const Point3& n : normals) require_finite({n.x, n.y, n.z}, "vertex normal");
  state_->vertex_normals_.assign(normals.begin(), normals.end());
  if (state_->recorder_ != nullptr) state_->recorder_->write("set-vertex-normals", normals, 3);
}

void GraphicsSystem::set_back_face_removal(bool on) {
  state_->looks_.attributes.back_face_removal = on;
  state_->record_setting(Setting::back_face_removal, "set-back-face-removal", {on});
}

void GraphicsSystem::set_background(const Background& background) {
  if (background.kind == Background::Kind::none) {
    state_->looks_.background = {Background::Kind::none};
    return state_->record("set-background", {"none"});
  }
  require_colour(background.colour);
  state_->looks_.background = background;
  const Colour& c = background.colour;
  state_->record("set-background", {c.r, c.g, c.b});
}

void GraphicsSystem::set_pick_id(int id) {
  if (id < -1) throw Error(fmt::format("pick identifier {}: expected 0 or more, or -1", id));
  state_->pick_ = id;
  state_->record("set-pick-id", {id});
}

}  // namespace displayfile
