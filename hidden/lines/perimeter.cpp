#include "hidden/lines/perimeter.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <tuple>

#include "clip/error.h"
#include "clip/work_budget.h"
#include "hidden/lines/cells_in_order.h"
#include "hidden/lines/franklin.h"
#include "hidden/lines/grid_surface.h"
#include "hidden/lines/perimeter_array.h"
#include "hidden/lines/perimeter_polyline.h"
#include "hidden/lines/verticals.h"
#include "hidden/lines/visible_pieces.h"

namespace displayfile {

namespace {

/// Both perimeters, exact.
class PerimeterPolylines {
 public:
  PerimeterPolylines(const GridSurface& surface, const Verticals& verticals)
      : verticals_(verticals),
        upper_(PerimeterPolyline::Bound::upper, surface, verticals),
        lower_(PerimeterPolyline::Bound::lower, surface, verticals) {}

  void find_hidden(std::uint32_t a, std::uint32_t b, std::vector<PartOfLine>& parts) {
    parts.clear();
    const auto line = PerimeterPolyline::line_between(verticals_, a, b);
    upper_.find_within(line, line.p != a, below_);
    if (below_.empty()) return;
    lower_.find_within(line, line.p != a, above_);
    intersect(below_, above_, parts);
  }
  void extend(std::uint32_t a, std::uint32_t b) {
    const auto side = PerimeterPolyline::line_between(verticals_, a, b);
    upper_.extend(side);
    lower_.extend(side);
  }

 private:
  const Verticals& verticals_;
  PerimeterPolyline upper_, lower_;
  std::vector<PartOfLine> below_, above_;
};

/// Which of the names the sides of a surface are; the others are left for the general method.
class NamedSides {
 public:
  NamedSides(const GridSurface& surface, const Verticals& verticals,
             std::span<const LineName> names, const Primitives& items)
      : of_side_(surface.sides(), kNone) {
    for (std::uint32_t n = 0; n < names.size(); ++n) {
      const auto [item, corner] = names[n];
      const std::uint32_t side = surface.side(item, corner);
      if (side == GridSurface::kNone || is_along(verticals, items, names[n])) {
        others_.push_back(names[n]);
      } else {
        of_side_[side] = n;
      }
    }
  }
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::uint32_t name(std::uint32_t side) const { return of_side_[side]; }
  std::span<const LineName> others() const { return others_; }

 private:
  static bool is_along(const Verticals& verticals, const Primitives& items, const LineName& name) {
    const PointRow corners = items.points_of(items.items[name.item]);
    const Point3 &from = corners[(name.corner + 2) % 3], &to = corners[name.corner];
    return verticals.are_along(Point2(from), Point2(to));
  }

  std::vector<std::uint32_t> of_side_;
  std::vector<LineName> others_;
};

/// Draws the sides of a surface's cells, nearest first (algorithm of T. J. Wright).
template <class Perimeters>
class PerimeterMethod {
 public:
  PerimeterMethod(const GridSurface& surface, const NamedSides& named,
                  std::span<const LineName> names, Perimeters& perimeters)
      : surface_(surface),
        named_(named),
        names_(names),
        perimeters_(perimeters),
        passed_(surface.sides(), 0),
        first_(names.size(), PartOfLine{0.0, 0.0}) {}

  std::vector<VisiblePiece> pieces(const WorkProgress& progress) {
    CountedWork work(progress, std::size_t{surface_.columns()} * surface_.rows());
    WorkSteps steps;
    CellsInOrder(surface_).for_each_cell([&](std::uint32_t i, std::uint32_t j, bool second_first) {
      const std::uint32_t a = surface_.number(i, j), b = surface_.number(i + 1, j),
                          c = surface_.number(i + 1, j + 1), d = surface_.number(i, j + 1);
      const Side diagonal{a, c, surface_.diagonal(i, j)};
      const std::array first{Side{a, b, surface_.side_along_x(i, j)},
                             Side{b, c, surface_.side_along_y(i + 1, j)}, diagonal};
      const std::array second{Side{d, a, surface_.side_along_y(i, j)},
                              Side{c, d, surface_.side_along_x(i, j + 1)}, diagonal};
      draw_triangle(second_first ? second : first);
      draw_triangle(second_first ? first : second);
      steps.step();
      work.add(1);
    });
    return in_order_of_names();
  }

 private:
  struct Side {
    std::uint32_t from, to, number;
  };

  /// What is nearer than a side was passed before the nearer of its triangles, which moves the
  /// perimeters only after all its sides were drawn.
  void draw_triangle(const std::array<Side, 3>& sides) {
    std::array<bool, 3> may_extend{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (passed_[sides[k].number] != 0) continue;
      passed_[sides[k].number] = 1;
      may_extend[k] = draw(sides[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (may_extend[k]) perimeters_.extend(sides[k].from, sides[k].to);
    }
  }

  /// False if nothing of it is seen, and so nothing is outside of the perimeters.
  bool draw(const Side& side) {
    const std::uint32_t name = named_.name(side.number);
    if (name == NamedSides::kNone) return true;
    // A cell's first triangle runs along its sides to greater x and y, but back along the diagonal;
    // the second the other way.
    const auto [low, high] = std::minmax(side.from, side.to);
    const bool is_diagonal = side.number >= surface_.diagonal(0, 0);
    if (surface_.is_first(names_[name].item) != is_diagonal) {
      perimeters_.find_hidden(low, high, hidden_);
    } else {
      perimeters_.find_hidden(high, low, hidden_);
    }
    double from = 0.0;
    for (const PartOfLine& part : hidden_) {
      if (from < part.from) add_seen(name, {from, part.from});
      from = part.to;
    }
    if (from < 1.0) add_seen(name, {from, 1.0});
    return hidden_.size() != 1 || hidden_[0].from > 0.0 || hidden_[0].to < 1.0;
  }

  void add_seen(std::uint32_t name, const PartOfLine& part) {
    PartOfLine& first = first_[name];
    if (first.from < first.to) {
      others_.push_back({name, part});
    } else {
      first = part;
    }
  }

  std::vector<VisiblePiece> in_order_of_names() {
    std::ranges::stable_sort(others_, {}, &SeenPart::name);
    std::vector<VisiblePiece> pieces;
    pieces.reserve(names_.size() + others_.size());
    auto other = others_.begin();
    for (std::uint32_t n = 0; n < names_.size(); ++n) {
      const auto [item, corner] = names_[n];
      const auto add = [&, item = item, corner = corner](const PartOfLine& part) {
        pieces.push_back({item, corner, part.from, part.to});
      };
      if (first_[n].from < first_[n].to) add(first_[n]);
      for (; other != others_.end() && other->name == n; ++other) add(other->part);
    }
    return pieces;
  }

  const GridSurface& surface_;
  const NamedSides& named_;
  std::span<const LineName> names_;
  Perimeters& perimeters_;
  std::vector<std::uint8_t> passed_;
  std::vector<PartOfLine> hidden_;
  std::vector<PartOfLine> first_;  // what is seen of each name; empty: nothing
  std::vector<SeenPart> others_;   // what more is seen of some
};

SeenLines by_franklin(const Primitives& items, std::span<const LineName> names,
                      const LineOptions& options) {
  const LineScene scene(items, names, options.threads);
  return visible_lines_by_franklin(items, scene, options);
}

bool is_before(const VisiblePiece& a, const VisiblePiece& b) {
  return std::tie(a.item, a.corner, a.from) < std::tie(b.item, b.corner, b.from);
}

template <class Perimeters>
std::vector<VisiblePiece> pieces_of(const GridSurface& surface, const NamedSides& named,
                                    std::span<const LineName> names, Perimeters perimeters,
                                    const WorkProgress& progress) {
  return PerimeterMethod(surface, named, names, perimeters).pieces(progress);
}

}  // namespace

SeenLines visible_lines_by_perimeter(const Primitives& items, std::span<const LineName> names,
                                     const LineOptions& options,
                                     std::span<const IntersectionLine> intersections) {
  if (!intersections.empty()) {
    throw Error(
        "hidden-line method 'perimeter' draws one surface, which does not pass through itself: "
        "expected another method for lines of intersection, such as franklin");
  }
  const bool only_lines = std::ranges::all_of(items.items, [](const Primitives::Item& item) {
    return item.kind == Primitives::Kind::line;
  });
  if (only_lines) return by_franklin(items, names, options);
  const GridSurface surface(items);
  const Verticals verticals(surface);
  if (verticals.are_points() || !verticals.make_columns()) {
    return by_franklin(items, names, options);
  }
  const NamedSides named(surface, verticals, names, items);
  SeenLines seen;
  seen.pieces = options.precision.exact
                    ? pieces_of(surface, named, names, PerimeterPolylines(surface, verticals),
                                options.progress)
                    : pieces_of(surface, named, names,
                                PerimeterArray(surface, verticals, options.precision.roundoff),
                                options.progress);
  if (named.others().empty()) return seen;
  const SeenLines others = by_franklin(items, named.others(), options);
  std::vector<VisiblePiece> all;
  all.reserve(seen.pieces.size() + others.pieces.size());
  std::ranges::merge(seen.pieces, others.pieces, std::back_inserter(all), is_before);
  seen.pieces = std::move(all);
  return seen;
}

}  // namespace displayfile
