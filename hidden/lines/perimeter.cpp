
#include <algorithm>
#include <iterator>
#include <mutex>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/parallel.h"
#include "clip/base/work_budget.h"
#include "hidden/lines/items_near_lines.h"
#include "hidden/lines/line_methods.h"
#include "hidden/lines/perimeter_array.h"
#include "hidden/lines/perimeter_method.h"

namespace displayfile {

namespace {

/// The array of columns; it covers all columns and receives all lines.
class WholeArray {
 public:
  struct Line {
    std::uint32_t a, b;
  };

  WholeArray(const GridSurface& surface, const Verticals& verticals, double roundoff)
      : array_(surface, verticals, roundoff) {}

  static Line line(std::uint32_t a, std::uint32_t b) { return {a, b}; }
  static Known known(const Line&) { return Known::all; }
  bool find_hidden(const Line& line, std::uint32_t from, std::vector<PartOfLine>& parts) const {
    array_.find_hidden(from, from == line.a ? line.b : line.a, parts);
    return true;
  }
  void extend(const Line& line) { array_.extend(line.a, line.b); }

 private:
  PerimeterArray array_;
};

/// Visible pieces, and the names of lines that are undecided, in order.
struct PartlySeen {
  std::vector<VisiblePiece> pieces;
  std::vector<std::uint32_t> undecided;
  bool gave_up = false;  ///< then there are no pieces
};

/// Runs the method for several parts of the columns, each with its own independent perimeters: a
/// line's hidden parts are those found by any of them. Also runs `beside`, in parallel.
template <class MakePerimeters, class Beside>
PartlySeen pieces_of(const GridSurface& surface, const NamedSides& named,
                     std::span<const LineName> names, std::size_t parts, const MakePerimeters& make,
                     const SurfacePlan& plan, const Beside& beside) {
  using Method = PerimeterMethod<std::invoke_result_t<const MakePerimeters&, std::size_t>>;
  const CellsInOrder order(surface);
  SeenParts seen(names.size());
  std::vector<SeenPart> others, hidden_in_part;
  PartlySeen found;
  std::mutex mutex;
  CountedWork work(plan.progress, std::size_t{surface.columns()} * surface.rows() * parts);
  in_parallel(plan.threads, parts + 1, [&](std::size_t part) {
    if (part == parts) return beside();
    Method method(surface, named, names, make(part), seen);
    method.draw(order, work);
    const std::lock_guard lock(mutex);
    others.insert(others.end(), method.others().begin(), method.others().end());
    hidden_in_part.insert(hidden_in_part.end(), method.hidden_in_part().begin(),
                          method.hidden_in_part().end());
    found.undecided.insert(found.undecided.end(), method.undecided().begin(),
                           method.undecided().end());
    found.gave_up = found.gave_up || method.gave_up();
  });
  if (found.gave_up) return found;
  std::ranges::sort(found.undecided);
  found.undecided.erase(std::unique(found.undecided.begin(), found.undecided.end()),
                        found.undecided.end());
  std::ranges::sort(hidden_in_part, {}, &SeenPart::name);
  std::vector<PartOfLine> hidden;
  for (std::size_t k = 0; k < hidden_in_part.size();) {
    const std::uint32_t name = hidden_in_part[k].name;
    hidden.clear();
    for (; k < hidden_in_part.size() && hidden_in_part[k].name == name; ++k) {
      const PartOfLine& part = hidden_in_part[k].part;
      if (part.from < part.to) hidden.push_back(part);
    }
    if (std::ranges::binary_search(found.undecided, name)) continue;
    unite(hidden);
    seen.add(name, hidden, others);
  }
  found.pieces = seen.pieces(names, std::move(others));
  return found;
}

SeenLines by_franklin(const Primitives& items, std::span<const LineName> names,
                      const SurfacePlan& plan) {
  const ItemsNearLines near(items, names, {}, plan.threads);
  const LineTable scene(near.items(), near.names(), plan.threads);
  return near.by_all_items(visible_lines_by_franklin(near.items(), scene, plan));
}

std::vector<VisiblePiece> pieces_by_franklin(const Primitives& items,
                                             std::span<const LineName> names,
                                             const SurfacePlan& plan) {
  if (names.empty()) return {};
  return by_franklin(items, names, plan).pieces;
}

bool is_before(const VisiblePiece& a, const VisiblePiece& b) {
  return std::tie(a.item, a.corner, a.from) < std::tie(b.item, b.corner, b.from);
}

std::vector<VisiblePiece> in_order(std::vector<VisiblePiece> pieces,
                                   const std::vector<VisiblePiece>& more) {
  if (more.empty()) return pieces;
  std::vector<VisiblePiece> all;
  all.reserve(pieces.size() + more.size());
  std::ranges::merge(pieces, more, std::back_inserter(all), is_before);
  return all;
}

}  // namespace

SeenLines visible_lines_by_perimeter(const Primitives& items, std::span<const LineName> names,
                                     const SurfacePlan& plan,
                                     std::span<const IntersectionLine> intersections,
                                     const GridSurface* known) {
  if (!intersections.empty()) {
    throw Error(
        "hidden-line method 'perimeter' draws one surface, which does not pass through itself: "
        "expected another method for lines of intersection, such as franklin");
  }
  const bool only_lines = std::ranges::all_of(items.items, [](const Primitives::Item& item) {
    return item.kind == Primitives::Kind::line;
  });
  if (only_lines) return by_franklin(items, names, plan);
  std::optional<GridSurface> found;
  if (known == nullptr) found.emplace(items);
  const GridSurface& surface = found ? *found : *known;
  const Verticals verticals(surface);
  constexpr double kMostTouching = 0x1p-16;  // of the picture; more than any format's reach
  const bool has_columns = !verticals.are_points() && verticals.make_columns();
  if (!has_columns || (plan.precision.exact && items.touching > kMostTouching)) {
    return by_franklin(items, names, plan);
  }
  const NamedSides named(surface, verticals, names, items);
  SurfacePlan quietly = plan;  // progress is reported for the surface only
  quietly.progress = {};
  std::vector<VisiblePiece> others;
  const auto find_others = [&] { others = pieces_by_franklin(items, named.others(), quietly); };
  PartlySeen partly;
  if (plan.precision.exact) {
    const SurfaceColumns columns(surface, verticals, items.touching);
    const auto parts = columns.parts(static_cast<std::size_t>(useful_threads(plan.threads)));
    const auto make = [&](std::size_t part) {
      return PerimeterPolylines(surface, verticals, columns, parts[part]);
    };
    partly = pieces_of(surface, named, names, parts.size(), make, plan, find_others);
  } else {
    const auto make = [&](std::size_t) {
      return WholeArray(surface, verticals, plan.precision.roundoff);
    };
    partly = pieces_of(surface, named, names, 1, make, plan, find_others);
  }
  if (partly.gave_up) return by_franklin(items, names, quietly);
  std::vector<LineName> undecided;
  undecided.reserve(partly.undecided.size());
  for (const std::uint32_t name : partly.undecided) undecided.push_back(names[name]);
  SeenLines seen;
  seen.pieces = in_order(in_order(std::move(partly.pieces), others),
                         pieces_by_franklin(items, undecided, quietly));
  return seen;
}

}  // namespace displayfile
