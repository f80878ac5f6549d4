#include "hidden/lines/visible_lines.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "clip/base/work_budget.h"
#include "clip/geometry/corners.h"
#include "hidden/lines/grid_surface.h"
#include "hidden/lines/items_near_lines.h"
#include "hidden/lines/line_methods.h"
#include "hidden/lines/line_table.h"
#include "hidden/lines/side_table.h"

namespace displayfile {

namespace {

/// The lines of a surface's cells, cell by cell.
class LinesOfCells {
 public:
  LinesOfCells(const GridSurface& surface, const Primitives& items,
               std::span<const std::int32_t> picks, std::vector<LineToDraw>& lines)
      : surface_(surface), items_(items), picks_(picks), lines_(lines) {}

  /// Adds the lines in order of corners: those of the triangle at (i + 1, j), then those of the
  /// other.
  void add_cell(std::uint32_t i, std::uint32_t j) {
    const std::uint32_t one = surface_.first_triangle(i, j), other = one + 1;
    const std::uint32_t of_row = 2 * surface_.columns();
    const Point3 &a = surface_.point(surface_.number(i, j)),
                 &b = surface_.point(surface_.number(i + 1, j)),
                 &c = surface_.point(surface_.number(i + 1, j + 1)),
                 &d = surface_.point(surface_.number(i, j + 1));
    constexpr LineName kNobody{GridSurface::kNone, 0};
    const bool last_column = i + 1 == surface_.columns(), last_row = j + 1 == surface_.rows();
    add({one, 0}, {other, 1}, c, a);
    add({one, 1}, j == 0 ? kNobody : LineName{other - of_row, 2}, a, b);
    add({one, 2}, last_column ? kNobody : LineName{other + 2, 0}, b, c);
    add({other, 0}, i == 0 ? kNobody : LineName{one - 2, 2}, d, a);
    add({other, 1}, {one, 0}, a, c);
    add({other, 2}, last_row ? kNobody : LineName{one + of_row, 1}, c, d);
  }

 private:
  /// Adds a side, which the polygon beside it has as `beside`, unless that polygon comes first and
  /// draws it.
  void add(const LineName& name, const LineName& beside, const Point3& from, const Point3& to) {
    const LineKinds own = kinds(name);
    if (own == 0 || Point2(from) == Point2(to)) return;
    LineToDraw line{name, own, name.item};
    if (beside.item != GridSurface::kNone) {
      const LineKinds of_other = kinds(beside);
      if (beside.item < name.item && of_other != 0) return;
      line.kinds = static_cast<LineKinds>(own | of_other);
      const auto [first, second] = std::minmax(name.item, beside.item);
      line.pick_item = !picks_.empty() && picks_[second] < picks_[first] ? second : first;
    }
    lines_.push_back(line);
  }
  LineKinds kinds(const LineName& name) const {
    return items_.visible_at(items_.items[name.item].first + name.corner);
  }

  const GridSurface& surface_;
  const Primitives& items_;
  std::span<const std::int32_t> picks_;
  std::vector<LineToDraw>& lines_;
};

/// Adds the drawn lines of a surface's cells, as in lines_to_draw. The grid determines which cells
/// share sides, and no other sides have the same ends, so that no table of sides is needed.
void add_lines_of(const GridSurface& surface, const Primitives& items,
                  std::span<const std::int32_t> picks, std::vector<LineToDraw>& lines) {
  LinesOfCells cells(surface, items, picks, lines);
  for (std::uint32_t j = 0; j < surface.rows(); ++j) {
    for (std::uint32_t i = 0; i < surface.columns(); ++i) cells.add_cell(i, j);
  }
}

/// The look of a side; kinds 0: not drawn, or drawn as another polygon's.
struct SideLook {
  LineKinds kinds = 0;
  std::uint32_t pick_item = 0;
};

SideLook shared_look(const Primitives& items, std::span<const SideTable::Side> same,
                     std::span<const std::int32_t> picks) {
  SideLook look{.kinds = 0, .pick_item = same[0].name.item};
  for (const auto& [high, name] : same) {
    const LineKinds kinds = items.visible_at(items.items[name.item].first + name.corner);
    look.kinds = static_cast<LineKinds>(look.kinds | kinds);
    if (!picks.empty() && picks[name.item] < picks[look.pick_item]) look.pick_item = name.item;
  }
  return look;
}

/// The looks of the sides of all items, each stored at the first item that draws the side.
class SideLooks {
 public:
  SideLooks(const Primitives& items, std::span<const std::int32_t> picks)
      : items_(items), picks_(picks) {
    first_.reserve(items.items.size());
    std::size_t sides = 0;
    for (const Primitives::Item& item : items.items) {
      first_.push_back(sides);
      sides += item.sides;
    }
    looks_.resize(sides);
    SideTable(items, SideTable::Sides::near_drawn)
        .for_each_set([&](std::span<const SideTable::Side> same) { look_at(same); });
  }

  const SideLook& operator[](const LineName& name) const {
    return looks_[first_[name.item] + name.corner];
  }

 private:
  void look_at(std::span<const SideTable::Side> same) {
    const auto drawn = std::ranges::find_if(
        same, [&](const SideTable::Side& side) { return is_visible(side.name); });
    if (drawn == same.end()) return;
    looks_[first_[drawn->name.item] + drawn->name.corner] = shared_look(items_, same, picks_);
  }
  bool is_visible(const LineName& name) const {
    return items_.is_visible(items_.items[name.item].first + name.corner);
  }

  const Primitives& items_;
  std::span<const std::int32_t> picks_;
  std::vector<std::size_t> first_;  // per item, its first side among all items' sides
  std::vector<SideLook> looks_;
};

/// The names of a line method and of an alternative, for messages.
WorkDone work_of(HiddenMethod method) {
  constexpr const char* kFranklin = "hidden-line method franklin";
  switch (method) {
    case HiddenMethod::roberts: return {"visible lines by roberts", kFranklin};
    case HiddenMethod::appel: return {"visible lines by appel", kFranklin};
    case HiddenMethod::plain_appel: return {"visible lines by plain-appel", kFranklin};
    case HiddenMethod::perimeter: return {"visible lines by perimeter", kFranklin};
    default:
      return {"visible lines by franklin", "for pixels hidden-surface method colour-rule=z-buffer"};
  }
}

}  // namespace

std::vector<LineToDraw> lines_to_draw(const Primitives& items, std::span<const std::int32_t> picks,
                                      const GridSurface* surface) {
  std::vector<LineToDraw> lines;
  lines.reserve(items.items.size());
  const auto ends = [&](const LineName& name) {
    const auto& [first, sides, kind] = items.items[name.item];
    return std::array{
        Point2(items.points[items.point(first + previous_corner(name.corner, sides))]),
        Point2(items.points[items.point(first + name.corner)])};
  };
  const auto add = [&](const LineName& name, const SideLook& look) {
    if (look.kinds == 0) return;
    const auto [from, to] = ends(name);
    if (from != to) lines.push_back({name, look.kinds, look.pick_item});
  };
  std::optional<SideLooks> looks;
  if (surface == nullptr) looks.emplace(items, picks);
  for (std::uint32_t i = 0; i < items.items.size(); ++i) {
    if (items.items[i].kind == Primitives::Kind::line) {
      add({i, 1}, {kDrawn, i});
    } else if (looks) {
      for (std::uint32_t corner = 0; corner < items.items[i].sides; ++corner) {
        add({i, corner}, (*looks)[{i, corner}]);
      }
    } else {  // the only polygons are the surface's
      add_lines_of(*surface, items, picks, lines);
      i += 2 * surface->columns() * surface->rows() - 1;
    }
  }
  return lines;
}

std::vector<LineToDraw> lines_to_draw(const Primitives& items,
                                      std::span<const std::int32_t> picks) {
  const std::optional<GridSurface> surface = GridSurface::of(items);
  return lines_to_draw(items, picks, surface ? &*surface : nullptr);
}

std::vector<LineName> drawn_lines(const Primitives& items) {
  std::vector<LineName> names;
  for (const LineToDraw& line : lines_to_draw(items, {})) names.push_back(line.name);
  return names;
}

SeenLines visible_lines(const Primitives& items, std::span<const LineName> lines,
                        const SurfacePlan& plan, std::span<const IntersectionLine> intersections,
                        const GridSurface* surface) {
  const HiddenMethod method = plan.method;
  if (!finds_lines(method)) {
    throw Error("the hidden-line method " + std::string(name_of(method)) +
                " does not find visible lines: expected roberts, appel, franklin, perimeter or "
                "plain-appel");
  }
  const NamedWork named(work_of(method));
  std::vector<LineName> names(lines.begin(), lines.end());
  if (!std::ranges::is_sorted(names)) std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  if (method == HiddenMethod::perimeter) {
    return visible_lines_by_perimeter(items, names, plan, intersections, surface);
  }
  const ItemsNearLines near(items, names, intersections, plan.threads);
  const LineTable scene(near.items(), near.names(), plan.threads, near.intersections());
  const auto by_method = [&] {
    if (method == HiddenMethod::roberts) {
      return visible_lines_by_roberts(near.items(), scene, plan);
    }
    if (method == HiddenMethod::appel) return visible_lines_by_appel(near.items(), scene, plan);
    if (method == HiddenMethod::plain_appel) {
      return visible_lines_by_plain_appel(near.items(), scene, plan);
    }
    return visible_lines_by_franklin(near.items(), scene, plan);
  };
  return near.by_all_items(by_method());
}

}  // namespace displayfile
