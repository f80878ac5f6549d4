#include "interp/text/text_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>

#include "clip/base/error.h"
#include "interp/text/cairo_text.h"

namespace displayfile {

namespace {

/// A rectangle in pixels from the picture's top left corner.
struct Tile {
  int left, top, right, bottom;
  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

constexpr int kLargestTile = 4096;        // along a side: Cairo's pictures have a limit
constexpr double kMarginOfLetters = 2.0;  // that antialiasing may reach beyond the letters

/// The coverage of each pixel of a tile by letters, 0 to 255.
class LetterCoverage {
 public:
  explicit LetterCoverage(const Tile& tile)
      : tile_(tile),
        surface_(cairo().image_surface_create(CAIRO_FORMAT_A8, tile.width(), tile.height())),
        context_(cairo().create(surface_.get())) {
    cairo().translate(context_.get(), -tile.left, -tile.top);
  }
  cairo_t* context() const { return context_.get(); }
  /// Must be called after all drawing.
  const unsigned char* row(int y) const {
    cairo().surface_flush(surface_.get());
    return cairo().image_surface_get_data(surface_.get()) +
           static_cast<std::ptrdiff_t>(y - tile_.top) *
               cairo().image_surface_get_stride(surface_.get());
  }

 private:
  struct Destroy {
    void operator()(cairo_t* context) const { cairo().destroy(context); }
    void operator()(cairo_surface_t* surface) const { cairo().surface_destroy(surface); }
  };
  Tile tile_;
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> context_;
};

/// The colour composited over the pixel, which may be transparent. Each component is rounded to the
/// nearest.
std::uint32_t blended(std::uint32_t below, std::uint32_t colour, std::uint32_t coverage) {
  const std::uint32_t of_below = (below >> 24) * (255 - coverage), of_colour = 255 * coverage;
  const std::uint32_t both = of_below + of_colour;
  std::uint32_t pixel = (2 * both + 255) / 510 << 24;
  for (int shift = 0; shift < 24; shift += 8) {
    const std::uint32_t a = below >> shift & 0xFF, b = colour >> shift & 0xFF;
    pixel |= (2 * (of_below * a + of_colour * b) + both) / (2 * both) << shift;
  }
  return pixel;
}

class TextPainter {
 public:
  /// The rows in memory, counted from the top.
  TextPainter(const DrawnLetters& letters, const PictureSize& size, int top, int bottom,
              Picture& picture)
      : letters_(letters), size_(size), held_{0, top, size.width, bottom}, picture_(picture) {}

  void paint(const DeviceText& text) const { paint(text, text.line.width * letters_.line_scale); }
  void paint(const DeviceText& text, double width) const {
    if (!letters_.lettering.is_of_strokes()) {
      return paint(on_page(text, measure_.context()).ink(), pixel_of(text.line.colour),
                   [&](cairo_t* context) { on_page(text, context).show(); });
    }
    const auto paths = letter_paths(letters_.lettering, text, anchor(text), size(text));
    Rectangle ink = paths->around();
    ink = {ink.x_min - width, ink.x_max + width, ink.y_min - width, ink.y_max + width};
    paint(ink, pixel_of(text.line.colour),
          [&](cairo_t* context) { stroke(*paths, width, context); });
  }
  void paint(const AnnotationMark& mark, const Background& background) const {
    using enum AnnotationMark::Kind;
    if (mark.kind == text) return paint(mark.text, mark.width);
    if (mark.kind == blank && background.kind == Background::Kind::none) return;
    Rectangle ink = Rectangle::nothing();
    for (const Point2& p : mark.points) ink.include({p.x, size_.height - p.y});
    const double around = 0.5 * mark.width;
    ink = {ink.x_min - around, ink.x_max + around, ink.y_min - around, ink.y_max + around};
    paint(ink, pixel_of(mark.kind == blank ? background.colour : mark.colour),
          [&](cairo_t* context) { draw_mark(mark, context); });
  }

 private:
  /// Paints the area covered by draw(context), which is within `ink`.
  template <class Draw>
  void paint(const Rectangle& ink, std::uint32_t colour, const Draw& draw) const {
    const auto bounded = [](double v, int low, int high) {
      return static_cast<int>(std::clamp(v, static_cast<double>(low), static_cast<double>(high)));
    };
    if (!(ink.x_min < ink.x_max && ink.y_min < ink.y_max)) return;  // blanks, or far off
    const int left = bounded(std::floor(ink.x_min - kMarginOfLetters), held_.left, held_.right);
    const int right = bounded(std::ceil(ink.x_max + kMarginOfLetters), held_.left, held_.right);
    const int top = bounded(std::floor(ink.y_min - kMarginOfLetters), held_.top, held_.bottom);
    const int bottom = bounded(std::ceil(ink.y_max + kMarginOfLetters), held_.top, held_.bottom);
    for (int y = top; y < bottom; y += kLargestTile) {
      for (int x = left; x < right; x += kLargestTile) {
        paint(Tile{x, y, std::min(x + kLargestTile, right), std::min(y + kLargestTile, bottom)},
              colour, draw);
      }
    }
  }

  /// Lines are drawn without caps.
  void draw_mark(const AnnotationMark& mark, cairo_t* context) const {
    const bool is_line = mark.kind == AnnotationMark::Kind::line;
    bool is_first = true;
    for (const Point2& p : mark.points) {
      (std::exchange(is_first, false) ? cairo().move_to : cairo().line_to)(context, p.x,
                                                                           size_.height - p.y);
    }
    if (!is_line || mark.closed) cairo().close_path(context);
    if (!is_line) return cairo().fill(context);
    cairo().set_line_cap(context, CAIRO_LINE_CAP_BUTT);
    cairo().set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    cairo().set_line_width(context, mark.width);
    cairo().stroke(context);
  }

  Point2 anchor(const DeviceText& text) const {
    return {text.anchor.x * size_.width, size_.height - text.anchor.y * size_.height};
  }
  double size(const DeviceText& text) const { return text.style.size * size_.height; }
  CairoText on_page(const DeviceText& text, cairo_t* context) const {
    return {context, letters_.lettering.family(), text, anchor(text), size(text)};
  }

  static void stroke(const LetterPaths& paths, double width, cairo_t* context) {
    cairo().set_line_width(context, width);
    cairo().set_line_cap(context, CAIRO_LINE_CAP_ROUND);
    cairo().set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    cairo().new_path(context);
    for (const LetterPaths::Letter& letter : paths.letters) {
      for (const auto& points : letter) {
        cairo().move_to(context, points[0].x, points[0].y);
        for (const Point2& p : points) cairo().line_to(context, p.x, p.y);
      }
    }
    cairo().stroke(context);
  }

  template <class Draw>
  void paint(const Tile& tile, std::uint32_t colour, const Draw& draw) const {
    const LetterCoverage coverage(tile);
    draw(coverage.context());
    for (int y = tile.top; y < tile.bottom; ++y) {
      const unsigned char* const covered = coverage.row(y) - tile.left;
      std::uint32_t* const pixels =
          picture_.pixels.data() +
          static_cast<std::size_t>(y - held_.top) * static_cast<std::size_t>(size_.width);
      for (int x = tile.left; x < tile.right; ++x) {
        if (covered[x] != 0) pixels[x] = blended(pixels[x], colour, covered[x]);
      }
    }
  }

  DrawnLetters letters_;
  PictureSize size_;
  Tile held_;
  Picture& picture_;
  LetterCoverage measure_{Tile{0, 0, 1, 1}};
};

void require_cairo(std::string_view what) {
  try {
    cairo();
  } catch (const Error& e) {
    throw Error(fmt::format(
        "{0} in pixels are drawn by Cairo, which cannot be loaded: {1}; expected it to be "
        "installed, or a drawing without {0}, or an .svg file",
        what, e.what()));
  }
}

}  // namespace

void paint_texts(std::span<const DeviceText> texts, const DrawnLetters& letters,
                 const PictureSize& size, int first_row, int end_row, Picture& rows) {
  if (texts.empty()) return;
  require_cairo("texts");
  const TextPainter painter(letters, size, size.height - end_row, size.height - first_row, rows);
  for (const DeviceText& text : texts) painter.paint(text);
}

void paint_annotation(std::span<const AnnotationMark> marks, const Background& background,
                      const DrawnLetters& letters, const PictureSize& size, int first_row,
                      int end_row, Picture& rows) {
  if (marks.empty()) return;
  require_cairo("annotations");
  const TextPainter painter(letters, size, size.height - end_row, size.height - first_row, rows);
  for (const AnnotationMark& mark : marks) painter.paint(mark, background);
}

}  // namespace displayfile
