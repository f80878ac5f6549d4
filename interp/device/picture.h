#pragma once

/// Pictures: pixels, picks, paper and pens, and the options of vectors.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "clip/point.h"
#include "displayfile/looks/style.h"

namespace displayfile {

// Pixels.

/// The two kinds of pictures: pixels, or vectors.
enum class PictureKind { raster, vector };

/// A raster picture, top row first. ids and depth are empty unless the options want them.
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
inline constexpr int kUsualSamples = 4;  ///< where nothing is set

/// Throws Error unless both sides are 1 to kLargestSide.
void require_picture_size(long long width, long long height);

// Picking.

/// The primitive seen at a place of a picture: the nearest solid polygon, of equally near ones the
/// one entered later, or a line. Renderer (interp/draw/renderer.h) finds it in a display file,
/// WorldViews (interp/draw/world_views.h) in a scene before viewing.
struct Pick {
  enum class Kind {
    polygon,  ///< the fill of one
    edge,     ///< a drawn side of a polygon
    line,
  };
  Kind kind;
  /// The pick identifier of the polygon; of a line the one that the application set, -1 if none.
  std::int32_t id;
  int segment;   ///< the name of the segment that it is in
  double depth;  ///< normalised: 0 on the back plane, 1 on the front plane, larger is nearer
  /// Where it is seen, in world coordinates: the exact point, rounded. From WorldViews alone.
  std::optional<Point3> world;
};

// Paper and pens. All lengths are millimetres.

/// A sheet of paper on which a picture of vectors is drawn, as large as fits between its margins
/// and in the middle.
struct Paper {
  enum class Turned { automatic, portrait, landscape };
  double width = 210.0, height = 297.0;
  double margin = 10.0;
  /// automatic: landscape if the picture is wider than high, portrait if it is not.
  Turned turned = Turned::automatic;
  bool operator==(const Paper&) const = default;
};

/// A4, A3 and so on from A0 to A6, letter, legal, tabloid, in letters of either case, or WxH, which
/// stays as it is; after each of them -portrait or -landscape if it is to lie so. Throws Error for
/// any other word, and for sides that are not 1 to kLargestSheet.
Paper paper_of(std::string_view word);
std::vector<std::string> sheet_names();  ///< a4 and so on, without those of WxH
inline constexpr double kLargestSheet = 10'000.0;

inline constexpr double kPointsOfMillimetre = 72.0 / 25.4;  ///< of PDF

/// The place of a picture on a sheet.
struct PaperFit {
  double width, height;  ///< of the sheet as it lies
  double left, top;      ///< the picture's upper left corner, from that of the sheet
  double pixel;          ///< a pixel's side
};
/// Throws Error if the margins leave nothing, or are negative, or for a sheet that paper_of
/// refuses.
PaperFit fit_on_paper(const Paper& paper, int picture_width, int picture_height);

/// Fills as parallel lines: the darker a fill, the more of them.
struct Hatching {
  double spacing = 1.0;  ///< of lines where the fill is as dark as the pen
  double angle = 45.0;   ///< degrees, counterclockwise from the horizontal
  bool cross = false;    ///< what is darker than the middle tone gets lines at right angles too
  std::optional<Colour> colour{};  ///< of the pen; black by default, white on dark paper
  double width = 0.3;              ///< of the pen's line
  bool operator==(const Hatching&) const = default;
};
inline constexpr double kClosestHatching = 0.05;

/// A picture drawn by pens, or cut by a laser: lines in a layer for each pen, none twice, in an
/// order in which the pen travels little (interp/vector/pens/README.md).
struct Pens {
  std::optional<Hatching> hatching{};  ///< none: fills are not drawn
  bool crumbs = false;                 ///< as VectorOptions::crumbs
  bool operator==(const Pens&) const = default;
};
/// Throws Error for lengths or angles that are out of their range.
void require_pens(const Pens& pens);

// Vectors.

/// How disjoint fills, which tile the picture, are written next to each other in vectors
/// (interp/vector/seams.md).
enum class Seams {
  trapped,  ///< none is seen: the earlier of two neighbours reaches under the later
  butted    ///< side to side, in a smaller file; where it is antialiased, what is behind shows
};

/// How vectors are written.
struct VectorOptions {
  /// Vertices are rounded to multiples of this part of a pixel, kFinestPrecision to
  /// kCoarsestPrecision.
  double precision = 0.01;
  Seams seams = Seams::trapped;
  /// The picture as large as fits, on a sheet of this size; none: in pixels, or points.
  std::optional<Paper> paper = std::nullopt;
  bool crumbs = false;    ///< strokes are drawn that are shorter than they are wide, and join none
  bool pick_ids = false;  ///< each pick identifier is an element of its own, and named; of SVG

  static constexpr double kFinestPrecision = 0.001, kCoarsestPrecision = 1.0;
};

/// Throws Error for a precision out of its range.
void require_vector_options(const VectorOptions& options);

}  // namespace displayfile
