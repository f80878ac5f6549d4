#include "displayfile/hidden_surface_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "clip/memory.h"
#include "hidden/lines/lines_in_order.h"

namespace displayfile {

namespace {

/// Items of different segments or line styles are not drawn by one stroke: a number for each
/// segment and style. Empty if there is one.
std::vector<std::uint32_t> strokes_of(const ViewedScene& scene) {
  std::map<std::array<double, 8>, std::uint32_t> numbers;
  std::vector<std::uint32_t> of_items(scene.items());
  const auto styles = scene.line_styles();
  const auto segments = scene.segments();
  std::size_t style = 0, segment = 0;
  for (ViewedScene::Item item = 0; item < scene.items();) {
    while (style + 1 < styles.size() && styles[style + 1].first <= item) ++style;
    while (segment + 1 < segments.size() && segments[segment + 1].first <= item) ++segment;
    ViewedScene::Item end = scene.items();
    if (style + 1 < styles.size()) end = std::min(end, styles[style + 1].first);
    if (segment + 1 < segments.size()) end = std::min(end, segments[segment + 1].first);
    const auto& [style_kind, colour, width, dash, gap] = styles[style].style;
    const LineStyle::Kind kind = style_kind;
    const std::array<double, 8> look{static_cast<double>(segment),
                                     static_cast<double>(kind),
                                     colour.r,
                                     colour.g,
                                     colour.b,
                                     width,
                                     dash,
                                     gap};
    const auto number = static_cast<std::uint32_t>(numbers.size());
    std::fill(of_items.begin() + item, of_items.begin() + end,
              numbers.try_emplace(look, number).first->second);
    item = end;
  }
  if (numbers.size() < 2) of_items.clear();
  return of_items;
}

/// Lines that no polygon of the order has: those that fills hide, and where polygons pass through
/// each other.
void append_lines(const ViewedScene& scene, const SortOptions& options, SortedPieces& sorted) {
  const SortedPieces lines = lines_in_order(scene, HiddenMethod::franklin, options);
  sorted.hidden.assign(sorted.pieces.size(), 0);
  for (std::size_t k = 0; k < lines.pieces.size(); ++k) {
    const auto [item, first, sides] = lines.pieces[k];
    const bool is_hidden = lines.is_hidden(k);
    if (!is_hidden && !lines.is_intersection(lines.pieces[k])) continue;
    sorted.pieces.push_back({item, static_cast<std::uint32_t>(sorted.points.size()), sides});
    sorted.hidden.push_back(is_hidden ? 1 : 0);
    for (std::uint32_t i = first; i < first + sides; ++i) {
      sorted.points.push_back(lines.points[i]);
      sorted.visible.push_back(lines.visible[i]);
    }
  }
}

SortedPieces pieces_of(const ViewedScene& scene, HiddenMethod method, const SortOptions& options) {
  if (finds_lines(method)) return lines_in_order(scene, method, options);
  SortedPieces sorted = sort_hidden_surfaces(scene.primitives(), method, options);
  if (options.hidden_lines == HiddenLines::dashed || options.intersections) {
    append_lines(scene, options, sorted);
  }
  return sorted;
}

std::shared_ptr<const SortedScene> sorted_scene(ViewedScene viewed,
                                                const ImageTransformation& image,
                                                HiddenMethod method, const SortOptions& options) {
  SortedPieces pieces = pieces_of(viewed, method, options);
  const auto hidden = static_cast<std::size_t>(std::ranges::count(pieces.hidden, 1));
  const SortCounts counts{pieces.pieces.size() - hidden, pieces.cuts, pieces.comparisons,
                          pieces.depth};
  auto ordered = std::make_shared<OrderedScene>(
      OrderedScene{std::make_shared<ViewedScene>(std::move(viewed)), std::move(pieces)});
  return std::make_shared<SortedScene>(SortedScene{{std::move(ordered)},
                                                   image,
                                                   method,
                                                   options.precision,
                                                   counts,
                                                   options.hidden_lines,
                                                   options.intersections});
}

/// What `sort` returns, which has every point in its tables at least.
template <class Sort>
std::shared_ptr<const SortedScene> with_memory_of_sort(std::size_t points, HiddenMethod method,
                                                       Sort&& sort) {
  return with_memory(
      points * sizeof(Point3),
      [&] { return fmt::format("sorting {} points by {}", points, name_of(method)); }, sort);
}

}  // namespace

SortedPieces lines_in_order(const ViewedScene& scene, HiddenMethod method,
                            const SortOptions& options) {
  Primitives items = scene.primitives();
  const std::vector<std::uint8_t> drawn = scene.drawn_sides();
  items.visible = drawn;
  return lines_in_order(items, {scene.picks(), strokes_of(scene)}, method, options);
}

SortedPieces lines_in_order(const ViewedScene& scene, const SeenLines& seen) {
  Primitives items = scene.primitives();
  const std::vector<std::uint8_t> drawn = scene.drawn_sides();
  items.visible = drawn;
  return lines_in_order(items, {scene.picks(), strokes_of(scene)}, seen);
}

bool is_object_space(HiddenMethod by) {
  const HiddenMethod method = surfaces_of(by);
  return method == HiddenMethod::bsp || method == HiddenMethod::depth_sort || finds_lines(method);
}

std::shared_ptr<const SortedScene> hidden_surface_check(
    const std::shared_ptr<const Instructions>& entered, const ImageTransformation& image,
    HiddenMethod by, const SortOptions& options) {
  const HiddenMethod method = surfaces_of(by);
  return with_memory_of_sort(entered->points(), method, [&] {
    return sorted_scene(ViewedScene(entered, image), image, method, options);
  });
}

std::shared_ptr<const SortedScene> hidden_surface_check(std::span<const Segment* const> segments,
                                                        HiddenMethod by,
                                                        const SortOptions& options) {
  const HiddenMethod method = surfaces_of(by);
  std::size_t points = 0;
  for (const Segment* segment : segments) points += segment->entered()->points();
  return with_memory_of_sort(
      points, method, [&] { return sorted_scene(ViewedScene(segments), {}, method, options); });
}

}  // namespace displayfile
