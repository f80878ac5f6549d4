#include "displayfile/segments/hidden_lines_left.h"

#include <algorithm>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/segments/scene_lines.h"
#include "displayfile/segments/viewed_scene.h"

namespace displayfile {

bool leaves_hidden_lines(const DisplayFile& display_file, bool orders_count, int threads) {
  const std::vector<const Segment*> visible = display_file.visible_segments();
  const bool in_order = orders_count && (display_file.sorted() != nullptr ||
                                         std::ranges::all_of(visible, [](const Segment* segment) {
                                           return segment->sorted() != nullptr;
                                         }));
  if (in_order || visible.empty()) return false;
  const ViewedScene scene(visible);
  const bool has_fills = scene.end() > 1;
  if (!has_fills || !scene.has_lines()) return false;
  const FoundLines found =
      find_lines(scene, {.method = HiddenMethod::franklin, .threads = threads});
  return !lines_beside_sides(scene, found, HiddenLines::dashed).pieces.empty();
}

void require_hidden_lines_dumped(const DisplayFile& display_file, HiddenMethod method,
                                 const HiddenSurfaceOptions& options) {
  if (options.hidden_lines != HiddenLines::dashed) return;
  if (!leaves_hidden_lines(display_file, true, options.threads)) return;
  throw Error("hidden lines need a method that sorts, which '" + std::string(name_of(method)) +
              "' does not: expected bsp, depth-sort, map, a method that finds lines, or hidden "
              "lines none");
}

std::string words_of_hidden_lines_left(HiddenMethod method) {
  return "hidden lines are not found by hidden-surface method '" + std::string(name_of(method)) +
         "', which draws in order of entry: expected a method that hides, such as map or franklin, "
         "or hidden lines none";
}

}  // namespace displayfile
