#include "displayfile/segments/scene_lines.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "displayfile/segments/cuts_at_vertices.h"
#include "displayfile/segments/lit_parts.h"
#include "hidden/map/map_pieces.h"

namespace displayfile {

namespace {

/// The items with only their drawn sides visible.
class DrawnItems {
 public:
  explicit DrawnItems(const ViewedScene& scene, bool exact = true)
      : sides_(scene.drawn_sides()), items_(scene.primitives()) {
    items_.visible = sides_;
    if (exact) return;  // a ROUNDOFF decides which polygons are coplanar
    items_.planes = {};
    items_.plane_rests = {};
    items_.touching = 0.0;
    items_.ends = nullptr;
  }
  DrawnItems(const DrawnItems&) = delete;
  DrawnItems& operator=(const DrawnItems&) = delete;

  const Primitives& operator*() const { return items_; }

 private:
  std::vector<std::uint8_t> sides_;
  Primitives items_;
};

}  // namespace

std::vector<std::uint32_t> looks_of_lines(const ViewedScene& scene) {
  std::map<std::array<double, 9>, std::uint32_t> numbers;
  std::vector<LineKindStyles> of_kinds_met;
  const auto number_of = [&](const LineKindStyles& of_kinds) {
    const auto met = std::ranges::find(of_kinds_met, of_kinds);
    const auto number = met - of_kinds_met.begin();
    if (met == of_kinds_met.end()) of_kinds_met.push_back(of_kinds);
    return static_cast<double>(number);
  };
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
    const auto& [style_kind, colour, width, dash, gap, of_kinds] = styles[style].style;
    const LineStyle::Kind kind = style_kind;
    const std::array<double, 9> look{static_cast<double>(segment),
                                     static_cast<double>(kind),
                                     colour.r,
                                     colour.g,
                                     colour.b,
                                     width,
                                     dash,
                                     gap,
                                     number_of(of_kinds)};
    const auto number = static_cast<std::uint32_t>(numbers.size());
    std::fill(of_items.begin() + item, of_items.begin() + end,
              numbers.try_emplace(look, number).first->second);
    item = end;
  }
  if (numbers.size() < 2) of_items.clear();
  return of_items;
}

LineStyle style_of_stroke(const ViewedScene& scene, ViewedScene::Item item, LineKinds kinds) {
  const LineStyle& line = scene.line_style(item);
  return scene.kind(item) == Primitives::Kind::line ? line : side_line_style(line, kinds);
}

std::vector<LineToDraw> lines_to_draw(const ViewedScene& scene) {
  return lines_to_draw(*DrawnItems(scene), scene.picks());
}

FoundLines find_lines(const ViewedScene& scene, const SurfacePlan& plan) {
  const DrawnItems items(scene, plan.precision.exact);
  return find_lines(*items, scene.picks(), plan);
}

SortedPieces lines_in_order(const ViewedScene& scene, const FoundLines& found,
                            HiddenLines hidden_lines) {
  SortedPieces lines =
      lines_in_order(scene.primitives(), looks_of_lines(scene), found, hidden_lines);
  put_cuts_at_vertices(scene, lines);
  return lines;
}

SortedPieces lines_beside_sides(const ViewedScene& scene, const FoundLines& found,
                                HiddenLines hidden_lines) {
  SortedPieces lines =
      lines_beside_sides(scene.primitives(), looks_of_lines(scene), found, hidden_lines);
  put_cuts_at_vertices(scene, lines);
  return lines;
}

SortedPieces map_in_order(const ViewedScene& scene, const SurfacePlan& plan) {
  const DrawnItems items(scene);
  const MapOptions of_map{.threads = plan.threads};
  SortedPieces fills = plan.shadows && scene.has_shadows()
                           ? lit_pieces_of_map(scene, *items, of_map)
                           : pieces_of_map(*items, visible_map(*items, of_map));
  const FoundLines found = find_lines(scene, plan.by(HiddenMethod::franklin));
  if (found.lines.empty() && found.intersections.empty()) {
    put_cuts_at_vertices(scene, fills);
    return fills;
  }
  // The lines' points come first, at the indices where their pick identifiers are looked up.
  SortedPieces all =
      lines_in_order(scene.primitives(), looks_of_lines(scene), found, plan.hidden_lines);
  const auto before = static_cast<std::uint32_t>(all.points.size());
  all.first_stroke = fills.pieces.size();
  all.lights = std::move(fills.lights);
  all.pieces.insert(all.pieces.begin(), fills.pieces.begin(), fills.pieces.end());
  for (std::size_t k = 0; k < all.first_stroke; ++k) {
    if (all.pieces[k].first != SortedPiece::kWhole) all.pieces[k].first += before;
  }
  if (!all.hidden.empty()) all.hidden.insert(all.hidden.begin(), all.first_stroke, 0);
  all.points.insert(all.points.end(), fills.points.begin(), fills.points.end());
  all.visible.insert(all.visible.end(), fills.visible.begin(), fills.visible.end());
  put_cuts_at_vertices(scene, all);
  return all;
}

void append_lines(const ViewedScene& scene, const SurfacePlan& plan, SortedPieces& sorted) {
  if (plan.hidden_lines == HiddenLines::none && !plan.intersections) return;
  const SortedPieces lines = lines_beside_sides(
      scene, find_lines(scene, plan.by(HiddenMethod::franklin)), plan.hidden_lines);
  sorted.hidden.assign(sorted.pieces.size(), 0);
  for (std::size_t k = 0; k < lines.pieces.size(); ++k) {
    const auto [item, first, sides] = lines.pieces[k];
    sorted.pieces.push_back({item, static_cast<std::uint32_t>(sorted.points.size()), sides});
    sorted.hidden.push_back(lines.is_hidden(k) ? 1 : 0);
    for (std::uint32_t i = first; i < first + sides; ++i) {
      sorted.points.push_back(lines.points[i]);
      sorted.visible.push_back(lines.visible[i]);
    }
  }
}

}  // namespace displayfile
