#include <array>
#include <string>

#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "interp/draw/draw.h"
#include "interp/truth/truth.h"
#include "tests/bench/worst_scenes.h"

namespace displayfile::bench {

namespace {

constexpr int kSize = 256;  // pixels a side

// Object space: the pieces or lines that are left, counted in the dump.

/// A method that sorts when the segment is closed.
template <class Enter>
Cost sorted(HiddenMethod method, const Enter& enter, LineKinds lines = {}) {
  GraphicsSystem g;
  begin(g);
  g.set_hidden_surfaces({.removal = true});
  g.set_back_face_removal(false);
  g.set_hidden_surfaces({.method = method});
  if (lines != LineKinds{}) g.set_hidden_surfaces({.lines = LineSelection{.kinds = lines}});
  g.open_segment(1);
  enter(g);
  Cost cost = cost_of([&] {
    g.close_segment();
    return 0;
  });
  const std::string text = dump(g.display_file());
  const std::string_view counted = finds_lines(method) ? "\nline " : "\npolygon ";
  for (std::size_t at = text.find(counted); at != std::string::npos;
       at = text.find(counted, at + 1)) {
    cost.output += 1.0;
  }
  return cost;
}

void enter_all(GraphicsSystem& g, const std::vector<Polygon>& polygons, bool with_lines) {
  if (with_lines) g.set_line_style({});
  for (const Polygon& p : polygons) g.polygon_abs_3(p);
}

template <HiddenMethod method, auto scene>
Cost object_space(std::size_t n) {
  return sorted(method, [&](GraphicsSystem& g) { enter_all(g, scene(n), finds_lines(method)); });
}

std::vector<Polygon> one_star(std::size_t n) { return {crossing_star(n, 0.5)}; }
std::vector<Polygon> one_comb(std::size_t n) { return {comb(n, 0.5)}; }

/// Lines along which polygons pass through each other.
Cost intersections(std::size_t n) {
  return sorted(
      HiddenMethod::franklin, [&](GraphicsSystem& g) { enter_all(g, planes(n), true); },
      kinds_of(LineKind::intersection));
}

/// A surface of about n points at random heights.
Cost rough_surface(std::size_t n) {
  const auto side = static_cast<int>(std::sqrt(real(n)));
  std::mt19937_64 random(1);
  std::vector<double> heights;
  for (int k = 0; k < side * side; ++k) heights.push_back(real(random() % 1000) / 4000);
  return sorted(HiddenMethod::perimeter, [&](GraphicsSystem& g) {
    g.set_line_style({});
    g.rotate_x_3(-60);
    g.translate_3(0.5, 0.5, 0.5);
    g.surface_3({-0.4, 0.4, side, -0.3, 0.3, side, heights});
  });
}

// Image space, in pictures of 256 x 256: what is made is always as large.

template <HiddenMethod method, auto scene>
Cost image_space(std::size_t n) {
  const GraphicsSystem g = entered_polygons(scene(n));
  DrawOptions options;
  options.width = options.height = kSize;
  options.hidden = method;
  return cost_of([&] { return draw(g, options).pixels.size(); });
}

template <auto scene>
Cost shadows(std::size_t n) {
  GraphicsSystem g;
  begin(g);
  g.set_light({0.3, 0.4, 1.0});
  g.set_shadows(true);
  g.open_segment(1);
  enter_all(g, scene(n), false);
  g.close_segment();
  DrawOptions options;
  options.width = options.height = kSize;
  options.hidden = HiddenMethod::z_buffer;
  return cost_of([&] { return draw(g, options).pixels.size(); });
}

template <auto scene>
Cost true_picture(std::size_t n) {
  const GraphicsSystem g = entered_polygons(scene(n));
  return cost_of([&] { return truth(g.display_file(), 64, 64, false).ids.size(); });
}

constexpr const char* kPlanesOut = "n^3: what planes cut each other into";
constexpr const char* kRows = "n crossings in each row of pixels";
constexpr const char* kSheets = "n fills at each pixel";

constexpr auto kCases = std::to_array<WorstCase>({
    {"bsp", "n crossing planes", 8, "pieces", kPlanesOut, object_space<HiddenMethod::bsp, planes>},
    {"bsp", "n planes that all but meet in a point", 4, "pieces", kPlanesOut,
     object_space<HiddenMethod::bsp, bundle>},
    {"bsp", "n bars that cross", 32, "pieces", "n^2 / 4 pieces at most",
     object_space<HiddenMethod::bsp, grid>},
    {"bsp", "n slivers", 32, "pieces", "n^3 at most", object_space<HiddenMethod::bsp, needles>},
    {"depth-sort", "n crossing planes", 8, "pieces", kPlanesOut,
     object_space<HiddenMethod::depth_sort, planes>},
    {"depth-sort", "n planes that all but meet in a point", 4, "pieces", kPlanesOut,
     object_space<HiddenMethod::depth_sort, bundle>},
    {"depth-sort", "n sheets", 64, "pieces", "n^2 pairs that overlap",
     object_space<HiddenMethod::depth_sort, stack>},
    {"depth-sort", "n slivers", 32, "pieces", "n^3 at most",
     object_space<HiddenMethod::depth_sort, needles>},
    {"map", "n bars that cross", 32, "pieces", "n^2 / 4 pieces are seen",
     object_space<HiddenMethod::map, grid>},
    {"map", "n crossing planes", 16, "pieces", "n^2 lines in which they meet",
     object_space<HiddenMethod::map, planes>},
    {"map", "n sheets", 64, "pieces", "n^2 pairs that overlap",
     object_space<HiddenMethod::map, stack>},
    {"map", "a star whose n sides cross each other", 33, "pieces", "n^2 / 2 crossings",
     object_space<HiddenMethod::map, one_star>},
    {"map", "a comb of n corners", 256, "pieces", "n sides against each other",
     object_space<HiddenMethod::map, one_comb>},
    {"roberts", "n bars that cross", 32, "lines", "n^2 pieces of lines are seen",
     object_space<HiddenMethod::roberts, grid>},
    {"roberts", "n sheets", 64, "lines", "n sides against n polygons",
     object_space<HiddenMethod::roberts, stack>},
    {"roberts", "a comb of n corners", 256, "lines", "n sides against one polygon of n",
     object_space<HiddenMethod::roberts, one_comb>},
    {"appel", "n bars that cross", 32, "lines", "n^2 pieces of lines are seen",
     object_space<HiddenMethod::appel, grid>},
    {"appel", "n sheets", 64, "lines", "n sides against n polygons",
     object_space<HiddenMethod::appel, stack>},
    {"appel", "a comb of n corners", 256, "lines", "n sides against one polygon of n",
     object_space<HiddenMethod::appel, one_comb>},
    {"franklin", "n bars that cross", 32, "lines", "n^2 pieces of lines are seen",
     object_space<HiddenMethod::franklin, grid>},
    {"franklin", "n sheets", 64, "lines", "each side against the n before it: all are seen",
     object_space<HiddenMethod::franklin, stack>},
    {"franklin", "a star whose n sides cross each other", 33, "lines", "n^2 / 2 crossings",
     object_space<HiddenMethod::franklin, one_star>},
    {"franklin", "n slivers", 32, "lines", "n^2 crossings",
     object_space<HiddenMethod::franklin, needles>},
    {"franklin", "a comb of n corners", 256, "lines", "n sides in each cell that the teeth cross",
     object_space<HiddenMethod::franklin, one_comb>},
    {"intersection lines", "n crossing planes", 8, "lines", "n^2 lines, each before n planes",
     intersections},
    {"perimeter", "a rough surface of n points", 1024, "lines",
     "n^1.5: each row crosses the perimeter", rough_surface},
    {"none", "n sheets", 64, "pixels", kSheets, image_space<HiddenMethod::none, stack>},
    {"none", "a comb of n corners", 1024, "pixels", kRows,
     image_space<HiddenMethod::none, one_comb>},
    {"z-buffer", "n sheets, the nearest last", 64, "pixels", kSheets,
     image_space<HiddenMethod::z_buffer, stack>},
    {"z-buffer", "a comb of n corners", 1024, "pixels", kRows,
     image_space<HiddenMethod::z_buffer, one_comb>},
    {"z-buffer", "n crossing planes", 16, "pixels", kSheets,
     image_space<HiddenMethod::z_buffer, planes>},
    {"z-buffer", "a star whose n sides cross each other", 256, "pixels", kRows,
     image_space<HiddenMethod::z_buffer, one_star>},
    {"scan-line", "n sheets", 64, "pixels", kSheets, image_space<HiddenMethod::scan_line, stack>},
    {"scan-line", "a comb of n corners", 1024, "pixels", kRows,
     image_space<HiddenMethod::scan_line, one_comb>},
    {"scan-line", "n crossing planes", 16, "pixels", "n^2 crossings in each row",
     image_space<HiddenMethod::scan_line, planes>},
    {"scan-line", "n slivers", 64, "pixels", "n^2 crossings in each row",
     image_space<HiddenMethod::scan_line, needles>},
    {"scan-line", "a star whose n sides cross each other", 256, "pixels", kRows,
     image_space<HiddenMethod::scan_line, one_star>},
    {"scan-line-z", "n sheets", 64, "pixels", kSheets,
     image_space<HiddenMethod::scan_line_z, stack>},
    {"scan-line-z", "a star whose n sides cross each other", 256, "pixels", kRows,
     image_space<HiddenMethod::scan_line_z, one_star>},
    {"ray-cast", "n sheets", 64, "pixels", kSheets, image_space<HiddenMethod::ray_cast, stack>},
    {"ray-cast", "a comb of n corners", 1024, "pixels", kRows,
     image_space<HiddenMethod::ray_cast, one_comb>},
    {"ray-cast", "n slivers", 64, "pixels", kSheets, image_space<HiddenMethod::ray_cast, needles>},
    {"ray-cast", "a star whose n sides cross each other", 64, "pixels", "n sides at each pixel",
     image_space<HiddenMethod::ray_cast, one_star>},
    {"warnock", "n sheets", 64, "pixels", kSheets, image_space<HiddenMethod::warnock, stack>},
    {"warnock", "a comb of n corners", 1024, "pixels", kRows,
     image_space<HiddenMethod::warnock, one_comb>},
    {"warnock", "n crossing planes", 16, "pixels", kSheets,
     image_space<HiddenMethod::warnock, planes>},
    {"warnock", "a star whose n sides cross each other", 64, "pixels", "n sides in each area",
     image_space<HiddenMethod::warnock, one_star>},
    {"shadows", "n sheets", 64, "pixels", "n casters at each pixel", shadows<stack>},
    {"shadows", "n bars that cross", 64, "pixels", "n casters at each pixel", shadows<grid>},
    {"truth", "n sheets", 16, "pixels", kSheets, true_picture<stack>},
    {"truth", "a star whose n sides cross each other", 64, "pixels", kRows, true_picture<one_star>},
});

}  // namespace

std::span<const WorstCase> worst_of_pictures() { return kCases; }

}  // namespace displayfile::bench
