#include "interp/visibility/auto_method.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "interp/scan/flat_extent.h"

namespace displayfile {

namespace {

using Fill = ViewedScene::Fill;

/// The minimax test of every pair, by a sweep from left to right. Boxes that only touch are apart:
/// of two polygons on either side of a line exactly one covers a centre on it.
bool boxes_are_apart(const ViewedScene& scene) {
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
bool nothing_lies_in_front(const ViewedScene& scene) {
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

/// How much of the picture all fills cover together: 1 where they cover it once.
double layers_of(const ViewedScene& scene) {
  double layers = 0.0;
  for (Fill fill = 1; fill < scene.end(); ++fill) layers += covered_part(scene.vertices(fill));
  return layers;
}

/// True if the fill touches or crosses the plane of that before it, or nearly.
bool is_close_to_last(const ViewedScene& scene, Fill fill) {
  constexpr double kClose = 1e-4;
  const Plane plane = scene.plane(fill - 1);
  const double dz_dx = -plane.normal.x / plane.normal.z, dz_dy = -plane.normal.y / plane.normal.z;
  bool before = false, behind = false;
  for (const Point3& v : scene.vertices(fill)) {
    const double nearer = v.z - (plane.p.z + dz_dx * (v.x - plane.p.x) + dz_dy * (v.y - plane.p.y));
    if (std::abs(nearer) < kClose) return true;
    (nearer > 0.0 ? before : behind) = true;
  }
  return before && behind;
}

/// But for so many.
bool each_is_close_to_last(const ViewedScene& scene, Fill exceptions) {
  Fill others = 0;
  for (Fill fill = 2; fill < scene.end() && others <= exceptions; ++fill) {
    others += is_close_to_last(scene, fill) ? 0 : 1;
  }
  return others <= exceptions;
}

/// True if the pixels are so few that in the z-buffer a fill's being close to others costs as much
/// as its pixels: fills that lie one or two deep, or very few all over the picture.
bool is_small_and_close(const ViewedScene& scene, Fill fills) {
  constexpr Fill kFew = 64, kVeryFew = 8;
  constexpr double kSparse = 0.8, kShallow = 2.5, kAllOver = 0.9;
  if (fills < 1 || fills > kFew) return false;
  const double layers = layers_of(scene);
  if (layers < kSparse && fills > kVeryFew) return false;
  if (layers < kShallow) return each_is_close_to_last(scene, 0);
  return fills <= kVeryFew && layers > kAllOver * fills && each_is_close_to_last(scene, fills / 2);
}

MethodChoice choose_for_vectors(const ViewedScene& scene) {
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

bool nothing_hides(const ViewedScene& scene) {
  return scene.end() <= 2 || boxes_are_apart(scene) || nothing_lies_in_front(scene);
}

MethodChoice choose_method(const DisplayFile& display_file, PictureKind kind,
                           const PictureSize& size) {
  const ViewedScene scene(display_file);
  return kind == PictureKind::raster ? choose_method(scene, size) : choose_for_vectors(scene);
}

/// A z-buffer's time follows the pixels that all fills cover; a scan line's the ends of spans, few
/// where polygons are few and wide (interp/visibility/scan_line.md); a subdivision's what is seen
/// in the end: far less where wide polygons lie behind each other many times
/// (interp/visibility/warnock.md).
MethodChoice choose_method(const ViewedScene& scene, const PictureSize& size) {
  constexpr Fill kFewFills = 2000, kVeryFewFills = 32;
  constexpr std::size_t kSides = 8;
  constexpr double kWide = 1.0 / 10.0, kManyPixels = 128.0, kFewPixels = 40.0;
  constexpr double kDeep = 12.0, kDeepIfVeryFew = 16.0, kManyInLayers = 250'000.0;
  const Fill fills = scene.end() - 1;
  const double pixels = static_cast<double>(size.width) * size.height, side = std::sqrt(pixels);
  if (side <= kFewPixels && is_small_and_close(scene, fills)) {
    return {HiddenMethod::warnock,
            "few polygons, close to each other, in few pixels: subdividing areas compares them "
            "once for each area"};
  }
  // Layers are no more than fills: where even so many would not do, they are not added up.
  if (fills <= kFewFills && fills > 0 && (side > kManyPixels || fills * pixels > kManyInLayers)) {
    const double layers = layers_of(scene);
    const bool wide = layers > kWide * fills, very_few = fills <= kVeryFewFills;
    const bool deep = layers > (very_few ? kDeepIfVeryFew : kDeep);
    if (wide && deep && layers * pixels > kManyInLayers) {
      return {HiddenMethod::warnock,
              "wide polygons many deep: subdividing areas looks only at what may be seen"};
    }
    const bool many_pixels = side > kManyPixels && std::sqrt(layers / fills) * side > kManyPixels;
    const bool plain = scene.all_vertices() <= kSides * fills;
    if (wide && many_pixels && plain && very_few) {
      return {HiddenMethod::scan_line,
              "few polygons, and wide: the scan line compares them only where spans begin and end"};
    }
  }
  return {HiddenMethod::z_buffer,
          "one picture in pixels: the z-buffer decides each pixel exactly and sorts nothing"};
}

}  // namespace displayfile
