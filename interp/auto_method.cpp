#include "interp/auto_method.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "interp/flat_extent.h"

namespace displayfile {

namespace {

using Fill = FillScene::Fill;

/// The minimax test of every pair, by a sweep from left to right. Boxes that only touch are apart:
/// of two polygons on either side of a line exactly one covers a centre on it.
bool boxes_are_apart(const FillScene& scene) {
  std::vector<FlatExtent> boxes;
  for (Fill fill = 1; fill < scene.end(); ++fill)
    boxes.push_back(flat_extent(scene.vertices(fill)));
  std::ranges::sort(boxes, {}, &FlatExtent::left);
  std::size_t tests_left = 8 * boxes.size();
  std::vector<FlatExtent> open;  // those that the sweep line crosses
  for (const FlatExtent& box : boxes) {
    std::erase_if(open, [&](const FlatExtent& other) { return other.right <= box.left; });
    if (open.size() > tests_left) return false;
    tests_left -= open.size();
    for (const FlatExtent& other : open) {
      if (other.bottom < box.top && box.bottom < other.top) return false;
    }
    open.push_back(box);
  }
  return true;
}

/// True if no vertex lies before the plane of any fill, as in a single convex object without its
/// back faces: where two fills overlap their planes meet, and of equal depths the later is seen.
bool nothing_lies_in_front(const FillScene& scene) {
  constexpr std::size_t kMostVertices = 256;
  if (scene.all_vertices() > kMostVertices) return false;
  for (Fill fill = 1; fill < scene.end(); ++fill) {
    const Plane plane = scene.plane(fill);
    const int toward_viewer = facing(plane);
    for (Fill other = 1; other < scene.end(); ++other) {
      for (const Point3& v : scene.vertices(other)) {
        const int side = side_of_plane(v, plane) * toward_viewer;
        // A vertex off its own plane counts as moved on to it: no longer where it was tested.
        if (side > 0 || (other == fill && side != 0)) return false;
      }
    }
  }
  return true;
}

/// Of the picture, the part that the fill covers: no more than its box there.
double covered_part(std::span<const Point3> vertices) {
  const FlatExtent box = flat_extent(vertices);
  const auto within = [](double low, double high) {
    return std::max(0.0, std::min(high, 1.0) - std::max(low, 0.0));
  };
  double twice_area = 0.0;
  Point3 from = vertices.back();
  for (const Point3& to : vertices) {
    twice_area += from.x * to.y - to.x * from.y;
    from = to;
  }
  return std::min(std::abs(twice_area) / 2.0,
                  within(box.left, box.right) * within(box.bottom, box.top));
}

/// A z-buffer's time follows the pixels that all fills cover; a scan line's the ends of spans, few
/// where polygons are few and wide (interp/scan_line.md); a subdivision's what is seen in the end:
/// far less where wide polygons lie behind each other many times (interp/warnock.md).
MethodChoice choose_for_pixels(const DisplayFile& display_file, int width) {
  constexpr std::size_t kFewPolygons = 2000;
  constexpr Fill kVeryFewPolygons = 32;
  constexpr double kDeep = 12.0, kWide = 1.0 / 16.0, kManyPixels = 128.0;
  // Of a small picture to look at the scene takes as long as it could save.
  if (width > kManyPixels && display_file.polygons() <= kFewPolygons) {
    const FillScene scene(display_file);
    double layers = 0.0;
    for (Fill fill = 1; fill < scene.end(); ++fill) layers += covered_part(scene.vertices(fill));
    const Fill fills = scene.end() - 1;
    const bool wide = layers > kWide * fills;
    const bool many_pixels = std::sqrt(layers / std::max(1u, fills)) * width > kManyPixels;
    if (wide && many_pixels && fills <= kVeryFewPolygons) {
      return {HiddenMethod::scan_line,
              "few polygons, and wide: the scan line compares them only where spans begin and end"};
    }
    if (wide && layers > kDeep) {
      return {HiddenMethod::warnock,
              "wide polygons many deep: subdividing areas looks only at what may be seen"};
    }
  }
  return {HiddenMethod::z_buffer,
          "one picture in pixels: the z-buffer decides each pixel exactly and sorts nothing"};
}

MethodChoice choose_for_vectors(const DisplayFile& display_file) {
  const FillScene scene(display_file);
  if (scene.has_lines()) {
    return {HiddenMethod::depth_sort,
            "vectors with lines: depth sort cuts least and hides lines behind polygons"};
  }
  if (nothing_hides(scene)) {
    return {HiddenMethod::none, "no polygon can hide another: any order is right"};
  }
  return {HiddenMethod::depth_sort, "vectors: depth sort orders the polygons with the fewest cuts"};
}

}  // namespace

bool nothing_hides(const FillScene& scene) {
  return scene.end() <= 2 || boxes_are_apart(scene) || nothing_lies_in_front(scene);
}

MethodChoice choose_method(const DisplayFile& display_file, PictureKind kind, int width) {
  return kind == PictureKind::raster ? choose_for_pixels(display_file, width)
                                     : choose_for_vectors(display_file);
}

}  // namespace displayfile
