#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "clip/error.h"
#include "clip/point.h"
#include "displayfile/looks/background.h"
#include "displayfile/looks/style.h"
#include "hidden/hidden_lines.h"
#include "hidden/hidden_method.h"

namespace displayfile {

struct ViewedWorld;

/// What becomes of a display file: pixels, or vectors.
enum class PictureKind { raster, vector };

/// A raster picture, top row first. ids and depth are empty unless they were asked for.
struct Picture {
  int width = 0, height = 0;
  /// 0xAABBGGRR, colours not multiplied by A (in_bytes gives R, G, B, A in memory). Opaque, unless
  /// there is no background: then 0 where nothing is drawn, and A the part that is covered where
  /// samples were averaged.
  std::vector<std::uint32_t> pixels;
  std::vector<std::int32_t> ids;  ///< item buffer: pick identifier of the fill seen, -1 for none
  std::vector<double> depth;      ///< of the fill seen; minus infinity for none
  /// Pixel centres that a sorted display file's painting left to be decided
  /// (RasterRequest::sorted).
  std::size_t undecided_centres = 0;
};

/// Rows of a picture from its top, from one up to, but not including, another.
struct PictureRows {
  int first, end;
};

/// What to draw of a display file, and how large.
struct RasterRequest {
  int width = 512, height = 512;
  /// Only these rows of it, as a picture of so many; none given: all.
  std::optional<PictureRows> rows = std::nullopt;
  /// An image-space method (interp/visibility/image_space.h), or `automatic` for the one that is
  /// the cheapest (interp/visibility/auto_method.h): the nearest fill is seen, wherever it stands
  /// in the order; any other: what is drawn last.
  HiddenMethod method = HiddenMethod::none;
  /// True if fills that are drawn in order are in exact back-to-front order: what is nearest is
  /// then to be seen also where cuts were rounded and where polygons touch.
  bool sorted = false;
  Background background = {};
  bool ids = false, depth = false;
  /// Over fills whose surfaces are found in image space, beside the lines that are seen
  /// (hidden/lines/README.md); an order of polygons has those that it was made with.
  HiddenLines hidden_lines = HiddenLines::none;
  bool intersections = false;
  bool crumbs = false;  ///< as DrawOptions::crumbs
  bool texts = true;    ///< drawn over the pixels: not where these are not kept
  int threads = 1;
  double line_scale = 1.0;  ///< of the widths and dashes of lines
  /// Depths closer than this count as equal (the textbook's ROUNDOFF); none: exact.
  std::optional<double> roundoff = std::nullopt;
  /// Whose display file it is, for world_ray_cast. A renderer that is used again needs it alive.
  const ViewedWorld* world = nullptr;
};

/// The pixel as a number whose bytes in this machine's memory are R, G, B, A, as files and OpenGL
/// have them; and from such a number the pixel.
inline std::uint32_t in_bytes(std::uint32_t pixel) {
  return std::endian::native == std::endian::little ? pixel : __builtin_bswap32(pixel);
}

/// A colour as a pixel: each component rounded to the nearest of 0 to 255.
inline std::uint32_t pixel_of(const Colour& colour) {
  const auto byte = [](double c) { return static_cast<std::uint32_t>(c * 255.0 + 0.5); };
  return 0xFF000000u | byte(colour.b) << 16 | byte(colour.g) << 8 | byte(colour.r);
}

/// The background as a pixel; 0 if there is none.
inline std::uint32_t pixel_of(const Background& background) {
  return background.kind == Background::Kind::none ? 0 : pixel_of(background.colour);
}

/// Where a point in normalised device coordinates is in a picture of this size: in pixels from its
/// upper left corner, y down, as Renderer::pick takes it.
inline Point2 pixel_at(const Point3& device, int width, int height) {
  return {device.x * width, (1.0 - device.y) * height};
}

/// The limits of a picture's size that the devices state and keep.
inline constexpr int kLargestSide = 65535;
inline constexpr int kMostSamples = 16;  ///< of antialiasing, along a pixel's side

/// Throws Error unless both sides are 1 to kLargestSide.
inline void require_picture_size(long long width, long long height) {
  if (width >= 1 && height >= 1 && width <= kLargestSide && height <= kLargestSide) return;
  const std::string most = std::to_string(kLargestSide);
  throw Error("picture size " + std::to_string(width) + "x" + std::to_string(height) +
              ": expected 1x1 to " + most + "x" + most + " pixels");
}

}  // namespace displayfile
