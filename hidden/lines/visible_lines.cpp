#include "hidden/lines/visible_lines.h"

#include <algorithm>
#include <string>

#include "clip/error.h"
#include "hidden/lines/appel.h"
#include "hidden/lines/franklin.h"
#include "hidden/lines/line_scene.h"
#include "hidden/lines/roberts.h"
#include "hidden/lines/side_table.h"

namespace displayfile {

std::vector<LineName> drawn_lines(const Primitives& items) {
  std::vector<std::size_t> first;  // side of each item, among those of all
  first.reserve(items.items.size());
  std::size_t sides = 0;
  for (const Primitives::Item& item : items.items) {
    first.push_back(sides);
    sides += item.sides;
  }
  std::vector<std::uint8_t> is_drawn(sides, 0);
  SideTable(items).for_each_set([&](std::span<const SideTable::Side> same) {
    const auto drawn = std::ranges::find_if(same, [&](const SideTable::Side& side) {
      return items.is_visible(items.items[side.name.item].first + side.name.corner);
    });
    if (drawn != same.end()) is_drawn[first[drawn->name.item] + drawn->name.corner] = 1;
  });
  std::vector<LineName> lines;
  lines.reserve(static_cast<std::size_t>(std::ranges::count(is_drawn, 1)));
  for (std::uint32_t i = 0; i < items.items.size(); ++i) {
    const Primitives::Item& item = items.items[i];
    const bool is_line = item.kind == Primitives::Kind::line;
    for (std::uint32_t corner = is_line ? 1 : 0; corner < item.sides; ++corner) {
      const Point3& to = items.points[items.point(item.first + corner)];
      const std::uint32_t before = corner == 0 ? item.sides - 1 : corner - 1;
      const Point3& from = items.points[items.point(item.first + before)];
      if ((is_line || is_drawn[first[i] + corner] != 0) && Point2(from) != Point2(to)) {
        lines.push_back({i, corner});
      }
    }
  }
  return lines;
}

SeenLines visible_lines(const Primitives& items, std::span<const LineName> lines,
                        HiddenMethod method, const LineOptions& options,
                        std::span<const IntersectionLine> intersections) {
  if (!finds_lines(method)) {
    throw Error("the hidden-line method " + std::string(name_of(method)) +
                " does not find visible lines: expected roberts, appel or franklin");
  }
  std::vector<LineName> names(lines.begin(), lines.end());
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  const LineScene scene(items, names, options.threads, intersections);
  if (method == HiddenMethod::roberts) return visible_lines_by_roberts(items, scene, options);
  if (method == HiddenMethod::appel) return visible_lines_by_appel(items, scene, options);
  return visible_lines_by_franklin(items, scene, options);
}

}  // namespace displayfile
