#include "interp/text/text_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "clip/base/error.h"
#include "interp/text/cairo_text.h"

namespace displayfile {

namespace {

/// Pixels from the picture's top left corner.
struct Tile {
  int left, top, right, bottom;
  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

constexpr int kLargestTile = 4096;        // along a side: Cairo's pictures have a limit
constexpr double kMarginOfLetters = 2.0;  // that antialiasing may reach beyond the letters

/// How much of each pixel of a tile letters cover, 0 to 255.
class LetterCoverage {
 public:
  explicit LetterCoverage(const Tile& tile)
      : tile_(tile),
        surface_(cairo().image_surface_create(CAIRO_FORMAT_A8, tile.width(), tile.height())),
        context_(cairo().create(surface_.get())) {
    cairo().translate(context_.get(), -tile.left, -tile.top);
  }
  cairo_t* context() const { return context_.get(); }
  /// To be called when all is drawn.
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

/// The colour over the pixel, which may be transparent. Each component is rounded to the nearest.
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
  TextPainter(const PictureSize& size, int top, int bottom, Picture& picture)
      : size_(size), held_{0, top, size.width, bottom}, picture_(picture) {}

  void paint(const DeviceText& text) const {
    const Rectangle ink = on_page(text, measure_.context()).ink();
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
        paint(text, {x, y, std::min(x + kLargestTile, right), std::min(y + kLargestTile, bottom)});
      }
    }
  }

 private:
  CairoText on_page(const DeviceText& text, cairo_t* context) const {
    return {context,
            text,
            {text.anchor.x * size_.width, size_.height - text.anchor.y * size_.height},
            text.style.size * size_.height};
  }

  void paint(const DeviceText& text, const Tile& tile) const {
    const LetterCoverage coverage(tile);
    on_page(text, coverage.context()).show();
    const std::uint32_t colour = pixel_of(text.line.colour);
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

  PictureSize size_;
  Tile held_;
  Picture& picture_;
  LetterCoverage measure_{Tile{0, 0, 1, 1}};
};

void require_cairo() {
  try {
    cairo();
  } catch (const Error& e) {
    throw Error(fmt::format(
        "texts in pixels are drawn by Cairo, which cannot be loaded: {}; expected it to be "
        "installed, or a drawing without texts, or an .svg file",
        e.what()));
  }
}

}  // namespace

void paint_texts(std::span<const DeviceText> texts, const PictureSize& size, int first_row,
                 int end_row, Picture& rows) {
  if (texts.empty()) return;
  require_cairo();
  const TextPainter painter(size, size.height - end_row, size.height - first_row, rows);
  for (const DeviceText& text : texts) painter.paint(text);
}

}  // namespace displayfile
