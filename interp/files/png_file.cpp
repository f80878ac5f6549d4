#include "interp/files/png_file.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csetjmp>
#include <istream>
#include <ostream>
#include <span>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/memory.h"
#include "displayfile/text/output.h"
#include "interp/device/picture.h"
#include "interp/files/binary_input.h"
#include "interp/files/pixel_bytes.h"

namespace displayfile {

namespace {

/// The last message of libpng. A fixed array: the function that fills it jumps and must own
/// nothing.
struct PngMessage {
  std::array<char, 128> text{};
};

// libpng reports an error by a call that must not return; it is left by longjmp to carry_out().
// No object with a destructor may live in a frame between the two, so the callbacks and the
// steps given to carry_out() hold none.
[[noreturn]] void on_error(png_structp png, png_const_charp what) {
  auto& message = static_cast<PngMessage*>(png_get_error_ptr(png))->text;
  std::strncpy(message.data(), what, message.size() - 1);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void read_bytes(png_structp png, png_bytep to, std::size_t count) {
  auto* in = static_cast<std::istream*>(png_get_io_ptr(png));
  in->read(reinterpret_cast<char*>(to), static_cast<std::streamsize>(count));
  if (in->fail()) png_error(png, "truncated");
}

void write_bytes(png_structp png, png_bytep from, std::size_t count) {
  auto* out = static_cast<std::ostream*>(png_get_io_ptr(png));
  out->write(reinterpret_cast<const char*>(from), static_cast<std::streamsize>(count));
  if (out->fail()) png_error(png, "not all could be written");
}

void flush_nothing(png_structp) {}

/// Runs steps that call libpng; false if libpng found an error.
template <class Steps>
bool carry_out(png_structp png, Steps&& steps) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  steps();
  return true;
}

struct PngWriter {
  PngMessage message;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, on_error, on_warning);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);

  PngWriter() = default;
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
};

struct PngReader {
  PngMessage message;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &message, on_error, on_warning);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);

  PngReader() = default;
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
};

/// Sets libpng to deliver R, G, B, A bytes, whatever the file's colour type.
void ask_for_rgba(png_structp png) {
  png_set_expand(png);
  png_set_strip_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
}

/// A zlib stream holds at most 1032 times its own length.
bool can_hold(std::uint64_t file_bytes, std::uint64_t row_bytes, std::uint64_t rows) {
  constexpr std::uint64_t kBestCompression = 1032;
  return row_bytes * rows <= file_bytes * kBestCompression;
}

void lay_over_white(std::span<std::uint8_t> rgba) {
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    const unsigned alpha = rgba[i + 3];
    if (alpha == 255) continue;
    for (std::size_t k = i; k < i + 3; ++k) {
      rgba[k] = static_cast<std::uint8_t>((rgba[k] * alpha + 255 * (255 - alpha) + 127) / 255);
    }
    rgba[i + 3] = 255;
  }
}

/// Sets fully transparent pixels, whose colour has no meaning, to 0.
void clear_transparent(std::span<std::uint32_t> pixels) {
  for (std::uint32_t& pixel : pixels) {
    if (pixel >> 24 == 0) pixel = 0;
  }
}

png_uint_32 pixels_per_metre(double dpi) {
  constexpr double kMetresOfInch = 0.0254;
  return static_cast<png_uint_32>(std::lround(dpi / kMetresOfInch));
}

class PngRowFile : public RowFile {
 public:
  PngRowFile(const Destination& to, int width, int height, Alpha alpha,
             std::optional<double> dpi = {});
  void write(const Picture& rows) override;
  void finish() override;
  void commit() override { file_->commit(); }

 private:
  template <class Steps>
  void write_by(Steps&& steps) {
    if (!carry_out(writer_.png, steps)) {
      throw Error(fmt::format("{}: {}", file_->name(), writer_.message.text.data()));
    }
  }

  std::unique_ptr<Output> file_;
  PngWriter writer_;
  std::size_t channels_;
  std::vector<std::uint8_t> row_;
};

PngRowFile::PngRowFile(const Destination& to, int width, int height, Alpha alpha,
                       std::optional<double> dpi)
    : file_(output_to(to)), channels_(alpha == Alpha::stored ? 4 : 3) {
  require_picture_size(width, height);
  row_.resize(channels_ * static_cast<std::size_t>(width) + 1);  // as write_channels has it
  if (writer_.info == nullptr) throw Error("not enough memory for a PNG file");
  std::ostream* out = &file_->stream();
  const int colour_type = alpha == Alpha::stored ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB;
  const png_uint_32 density = dpi ? pixels_per_metre(*dpi) : 0;
  write_by([&] {
    png_set_write_fn(writer_.png, out, write_bytes, flush_nothing);
    png_set_IHDR(writer_.png, writer_.info, static_cast<png_uint_32>(width),
                 static_cast<png_uint_32>(height), 8, colour_type, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (density > 0) {
      png_set_pHYs(writer_.png, writer_.info, density, density, PNG_RESOLUTION_METER);
    }
    // Flat faces repeat from row to row. About a fifth of the time of libpng's own choice, for
    // files at most a tenth longer, except of smooth shades.
    png_set_filter(writer_.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
    png_set_compression_level(writer_.png, 2);
    png_write_info(writer_.png, writer_.info);
  });
}

void PngRowFile::write(const Picture& rows) {
  const auto width = static_cast<std::size_t>(rows.width);
  write_by([&] {
    for (int y = 0; y < rows.height; ++y) {
      const auto pixels =
          std::span(rows.pixels).subspan(static_cast<std::size_t>(y) * width, width);
      if (channels_ == 3) {
        write_channels<3>(pixels, row_.data());
      } else {
        write_channels<4>(pixels, row_.data());
      }
      png_write_row(writer_.png, row_.data());
    }
  });
}

void PngRowFile::finish() {
  write_by([&] { png_write_end(writer_.png, nullptr); });
  file_->finish();
}

}  // namespace

const bool kHasPng = true;

std::unique_ptr<RowFile> png_row_file(const Destination& to, int width, int height) {
  return std::make_unique<PngRowFile>(to, width, height, Alpha::none);
}

std::unique_ptr<RowFile> png_alpha_row_file(const Destination& to, int width, int height) {
  return std::make_unique<PngRowFile>(to, width, height, Alpha::stored);
}

std::unique_ptr<RowFile> png_row_file_at(const Destination& to, int width, int height, Alpha alpha,
                                         std::optional<double> dpi) {
  return std::make_unique<PngRowFile>(to, width, height, alpha, dpi);
}

void write_png(const Picture& picture, const Destination& to) {
  const bool opaque = std::ranges::all_of(picture.pixels, [](auto p) { return p >> 24 == 0xFF; });
  PngRowFile file(to, picture.width, picture.height, opaque ? Alpha::none : Alpha::stored);
  file.write(picture);
  file.finish();
  file.commit();
}

Picture read_png(const std::filesystem::path& path, Alpha alpha) {
  BinaryInput input(path);
  const std::uint64_t file_bytes = input.bytes_left();
  std::array<png_byte, 8> signature{};
  input.stream().read(reinterpret_cast<char*>(signature.data()), signature.size());
  if (!input.stream() || png_sig_cmp(signature.data(), 0, signature.size()) != 0) {
    input.fail("not a PNG file");
  }
  PngReader reader;
  if (reader.info == nullptr) throw Error("not enough memory for a PNG file");
  const auto fail = [&] { input.fail(fmt::format("damaged PNG: {}", reader.message.text.data())); };
  png_uint_32 width = 0, height = 0;
  std::size_t row_bytes = 0;
  std::istream* in = &input.stream();
  const bool header_read = carry_out(reader.png, [&] {
    png_set_read_fn(reader.png, in, read_bytes);
    png_set_sig_bytes(reader.png, static_cast<int>(signature.size()));
    png_set_user_limits(reader.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // checked below
    png_read_info(reader.png, reader.info);
    width = png_get_image_width(reader.png, reader.info);
    height = png_get_image_height(reader.png, reader.info);
    row_bytes = png_get_rowbytes(reader.png, reader.info);
  });
  if (!header_read) fail();
  if (width > kLargestSide || height > kLargestSide) {
    input.fail(fmt::format("picture of {} x {} pixels: expected at most {} on a side", width,
                           height, kLargestSide));
  }
  if (!can_hold(file_bytes, row_bytes, height)) {
    input.fail(
        fmt::format("truncated: {} bytes cannot hold {} x {} pixels", file_bytes, width, height));
  }

  Picture picture;
  picture.width = static_cast<int>(width);
  picture.height = static_cast<int>(height);
  picture.pixels = in_large_pages(std::size_t{width} * height, std::uint32_t{0});
  auto* bytes = reinterpret_cast<std::uint8_t*>(picture.pixels.data());
  std::vector<png_bytep> rows(height);
  for (std::size_t y = 0; y < height; ++y) rows[y] = bytes + 4 * y * width;
  const bool pixels_read = carry_out(reader.png, [&] {
    ask_for_rgba(reader.png);
    png_read_update_info(reader.png, reader.info);  // takes memory for a row
    png_read_image(reader.png, rows.data());
    png_read_end(reader.png, nullptr);
  });
  if (!pixels_read) fail();
  if (alpha == Alpha::none) lay_over_white({bytes, 4 * picture.pixels.size()});
  for (std::uint32_t& pixel : picture.pixels) pixel = in_bytes(pixel);
  if (alpha == Alpha::stored) clear_transparent(picture.pixels);
  return picture;
}

}  // namespace displayfile
