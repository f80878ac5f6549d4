#include "programs/options/pick_option.h"

#include <fmt/format.h>

#include "clip/base/error.h"
#include "interp/draw/renderer.h"
#include "interp/visibility/image_space.h"
#include "programs/options/number_list.h"

namespace displayfile {

PickOption pick_option(std::string_view text) {
  const auto numbers = number_list(text);
  const bool has_reach = numbers && numbers->size() == 3;
  const double reach = has_reach ? numbers->back() : 0.0;
  if (!numbers || (numbers->size() != 2 && !has_reach) ||
      !(reach >= 0.0 && reach <= kLargestSide)) {
    throw Error(fmt::format(
        "--pick {}: expected X,Y or X,Y,REACH in pixels, such as 100,200 or 100,200,3", text));
  }
  return {(*numbers)[0], (*numbers)[1], reach};
}

namespace {

/// As the picture is drawn: in vectors a method of image space is the map.
DrawOptions of_picture(const PicturePlan& plan) {
  DrawOptions drawn = plan.options;
  const HiddenMethod method = plan.method;
  if (plan.kind() != PictureKind::vector || !is_image_space(method)) return drawn;
  drawn.surfaces.method =
      is_colour_rule(method) ? colour_rule_by(HiddenMethod::map) : HiddenMethod::map;
  drawn.surfaces.scope = HiddenScope::all;
  return drawn;
}

}  // namespace

std::string picked(const GraphicsSystem& system, const PickOption& at, const PicturePlan& plan) {
  const DrawOptions& options = plan.options;
  const auto pick = Renderer().pick(system, at.x, at.y, of_picture(plan), at.reach);
  const std::string where = fmt::format("at {},{}: ", at.x, at.y);
  if (!pick) {
    const bool inside = at.x >= 0.0 && at.x < options.width && at.y >= 0.0 && at.y < options.height;
    if (inside) return where + "nothing\n";
    return where +
           fmt::format("outside of the picture, {} x {} pixels\n", options.width, options.height);
  }
  const std::string what = pick->kind == Pick::Kind::polygon ? "polygon"
                           : pick->kind == Pick::Kind::edge  ? "an edge of polygon"
                                                             : "line";
  const std::string id = pick->id >= 0 ? fmt::format(" {}", pick->id) : "";
  return where +
         fmt::format("{}{} of segment {}, depth {}\n", what, id, pick->segment, pick->depth);
}

}  // namespace displayfile
