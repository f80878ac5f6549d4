#pragma once

/// Pictures: pixels, picks, paper and pens, and the options of vectors.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clip/point.h"
#include "displayfile/looks/style.h"

namespace displayfile {

// Pixels.

/// The two kinds of pictures: pixels, or vectors.
enum class PictureKind { raster, vector };

/// A raster picture, top row first. ids and depth are empty unless requested by the options.
struct Picture {
  int width = 0, height = 0;
  /// 0xAABBGGRR, not premultiplied (in_bytes gives R, G, B, A in memory). Opaque, unless there is
  /// no background: then 0 where nothing is drawn, and with averaged samples A is the covered
  /// fraction.
  std::vector<std::uint32_t> pixels;
  std::vector<std::int32_t> ids;  ///< item buffer: pick identifier of the visible fill; -1: none
  std::vector<double> depth;      ///< of the visible fill; minus infinity: none
  /// Number of pixel centres that painting a sorted display file could not decide
  /// (RasterRequest::sorted).
  std::size_t undecided_centres = 0;
};

/// Rows of a picture, counted from its top: [first, end).
struct PictureRows {
  int first, end;
};

/// Converts a pixel to a number whose bytes in memory are R, G, B, A, as in files and OpenGL, and
/// back.
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

/// Maps normalised device coordinates to a picture of this size: in pixels from its upper left
/// corner, y down, as Renderer::pick takes them.
inline Point2 pixel_at(const Point3& device, int width, int height) {
  return {device.x * width, (1.0 - device.y) * height};
}

/// Limits of a picture's size, for all devices.
inline constexpr int kLargestSide = 65535;
inline constexpr int kMostSamples = 16;  ///< of antialiasing, per pixel side
inline constexpr int kUsualSamples = 4;  ///< the default

/// Throws Error unless both sides are 1 to kLargestSide.
void require_picture_size(long long width, long long height);

// Picking.

/// The primitive visible at a point of a picture: the nearest solid polygon, of equally near ones
/// the one entered last, or a line. Renderer (interp/draw/renderer.h) finds it in a display file,
/// WorldViews (interp/draw/world_views.h) in a scene before viewing.
struct Pick {
  enum class Kind {
    polygon,  ///< a polygon's fill
    edge,     ///< a drawn side of a polygon
    line,
  };
  Kind kind;
  /// The pick identifier of the polygon; for a line the one set by the application, -1 if none.
  std::int32_t id;
  int segment;   ///< the name of its segment
  double depth;  ///< normalised: 0 on the back plane, 1 on the front plane, larger is nearer
  /// The visible point in world coordinates: exact, then rounded. From WorldViews alone.
  std::optional<Point3> world;
};

// Paper and pens. All lengths are in millimetres.

/// A sheet of paper, on which a picture is centred between the margins: as large as fits, unless
/// the size of its pixels is set.
struct Paper {
  enum class Turned { automatic, portrait, landscape };
  double width = 210.0, height = 297.0;
  double margin = 10.0;
  /// automatic: landscape if the picture is wider than high, otherwise portrait.
  Turned turned = Turned::automatic;
  std::optional<double> pixel{};  ///< the side of a pixel
  bool operator==(const Paper&) const = default;
};

/// Reads a0 to a6, letter, legal, tabloid, in either case, or WxH, which keeps its orientation;
/// each may be followed by -portrait or -landscape. Throws Error for any other word, and for sides
/// that are not 1 to kLargestSheet.
Paper paper_of(std::string_view word);
std::vector<std::string> sheet_names();  ///< the named sheets, such as a4
inline constexpr double kLargestSheet = 10'000.0;

inline constexpr double kPointsOfMillimetre = 72.0 / 25.4;  ///< of PDF
inline constexpr double kMillimetresOfInch = 25.4;
/// By how many mm, at most, a picture may be larger than the space between the margins.
inline constexpr double kOverMargins = 0.01;
inline constexpr double kHighestDensity = 100'000.0;  ///< pixels per inch; the lowest is 1

/// The place of a picture on a sheet.
struct PaperFit {
  double width, height;  ///< of the sheet, oriented
  double left, top;      ///< the picture's upper left corner, from that of the sheet
  double pixel;          ///< a pixel's side
};
/// Throws Error if the margins are negative or leave no space; for a sheet that paper_of refuses;
/// if the size of pixels is set and is not above 0, or the picture does not fit between the
/// margins.
PaperFit fit_on_paper(const Paper& paper, int picture_width, int picture_height);

/// Hatching: fills drawn as parallel lines, closer for darker fills.
struct Hatching {
  double spacing = 1.0;  ///< between lines where the fill is as dark as the pen
  double angle = 45.0;   ///< degrees, counterclockwise from the horizontal
  bool cross = false;    ///< fills darker than the middle tone get perpendicular lines too
  std::optional<Colour> colour{};  ///< of the pen; default: black, or white on dark paper
  double width = 0.3;              ///< of the pen's line
  bool operator==(const Hatching&) const = default;
};
inline constexpr double kClosestHatching = 0.05;

/// The order of the paths of one pen (interp/vector/pens/pen_order.md).
enum class PenOrder {
  travel,  ///< short pen travel alone
  cut,     ///< what lies inside of a closed contour first, for cutters
};
/// Reads `travel` or `cut`; throws Error for anything else.
PenOrder pen_order(std::string_view text);
/// How the letters of texts are drawn, which are otherwise written in a font of the system.
struct Lettering {
  static constexpr std::string_view kHershey = "hershey";
  /// The name of a font of the system, such as DejaVu Serif; or `hershey`, or `hershey:NAME`, such
  /// as hershey:scripts: the strokes of a Hershey font, in the width of the line style in force, of
  /// Debian's package hershey-fonts-data. Empty: sans-serif.
  std::string font{};
  /// In vectors, letters as filled outlines, the same in every viewer; by pens as lines.
  bool outlines = false;

  /// The font of the system; sans-serif where none is set.
  std::string family() const { return font.empty() ? "sans-serif" : font; }
  bool is_of_strokes() const;
  bool is_of_paths() const { return outlines || is_of_strokes(); }
  bool operator==(const Lettering&) const = default;
};
/// Throws Error for a font that is no name; a Hershey font that is not installed; outlines of one.
void require_lettering(const Lettering& lettering);
/// Reads the words of a lettering, as the options --font and --text: `text` is `text` or
/// `outlines`; nothing: the default. Throws Error for an empty font, for another word, and as
/// require_lettering.
Lettering lettering_of(std::optional<std::string_view> font, std::optional<std::string_view> text);

/// Options for a pen plotter or laser cutter: a layer of lines for each pen, no line twice, in an
/// order with short pen travel (interp/vector/pens/README.md).
struct Pens {
  std::optional<Hatching> hatching{};  ///< none: no fills are drawn
  PenOrder order = PenOrder::travel;   ///< of the paths of one pen
  /// Layers of pens with these colours come first, in this order; others follow in order of first
  /// use. A colour that no pen has is warned of.
  std::vector<Colour> layers{};
  bool crumbs = false;  ///< as VectorOptions::crumbs
  /// Texts are drawn if this is of paths; their letters are areas otherwise. Texts of annotation
  /// are drawn in the usual Hershey font then.
  Lettering lettering{};
  bool operator==(const Pens&) const = default;
};
/// Throws Error for lengths or angles out of range, and for a colour that is twice among the
/// layers.
void require_pens(const Pens& pens);

// Vectors.

/// How adjacent disjoint fills, which tile the picture, are written in vectors
/// (interp/vector/seams.md).
enum class Seams {
  trapped,  ///< no visible seams: the earlier of two neighbours extends under the later
  butted    ///< edge to edge, in a smaller file; antialiased, the background shows through
};

/// Options for vector files.
struct VectorOptions {
  /// Vertices are rounded to multiples of this fraction of a pixel, kFinestPrecision to
  /// kCoarsestPrecision.
  double precision = 0.01;
  Seams seams = Seams::trapped;
  /// The sheet on which the picture is fitted; none: sizes are in pixels, or points.
  std::optional<Paper> paper = std::nullopt;
  bool crumbs = false;    ///< also draws isolated strokes shorter than they are wide
  bool pick_ids = false;  ///< SVG only: one named element per pick identifier
  Lettering lettering{};  ///< as DrawOptions::lettering
  /// SVG only: every id, and every class that has a rule, begins with it, in place of the key that
  /// they end in otherwise (interp/vector/file_key.h). Letters a-z and A-Z, digits, - and _, the
  /// first a letter or _; or empty. Different figures of one page need different prefixes.
  std::string id_prefix{};
  bool is_inline = false;  ///< SVG only: without an XML declaration, to stand in an HTML page
  /// SVG and PDF: a layer for each segment, with its title (set_segment_title) or number as its
  /// name: for Inkscape, and as optional content of the PDF. In PDF, neighbours are then drawn
  /// without a mask, as in EPS (interp/vector/seams.md).
  bool layers = false;

  static constexpr double kFinestPrecision = 0.001, kCoarsestPrecision = 1.0;
};

/// Throws Error for a precision out of range, or a prefix with other characters.
void require_vector_options(const VectorOptions& options);

}  // namespace displayfile
