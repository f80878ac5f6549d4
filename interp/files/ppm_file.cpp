#include "interp/files/ppm_file.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <istream>
#include <ostream>
#include <span>
#include <vector>

#include "displayfile/text/output.h"
#include "interp/device/picture.h"
#include "interp/files/binary_input.h"
#include "interp/files/pixel_bytes.h"

namespace displayfile {

namespace {

bool is_blank(int c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// The next number of the header: skips blanks and comments, and consumes the one character that
/// ends the number.
int read_header_number(BinaryInput& input, const char* what) {
  std::istream& in = input.stream();
  int c = in.get();
  while (is_blank(c) || c == '#') {
    if (c == '#') {
      while (c != '\n' && c != std::istream::traits_type::eof()) c = in.get();
    } else {
      c = in.get();
    }
  }
  int value = 0, digits = 0;
  for (; c >= '0' && c <= '9'; c = in.get()) {
    if (++digits > 9) input.fail(fmt::format("PPM header: {} is too large", what));
    value = 10 * value + (c - '0');
  }
  if (c == std::istream::traits_type::eof()) input.fail("truncated in the PPM header");
  if (digits == 0 || !is_blank(c)) {
    input.fail(fmt::format("PPM header: expected a number for the {}", what));
  }
  return value;
}

class PpmRowFile : public RowFile {
 public:
  PpmRowFile(const Destination& to, int width, int height) : file_(output_to(to)) {
    require_picture_size(width, height);
    row_.resize(3 * static_cast<std::size_t>(width) + 1);
    file_->stream() << fmt::format("P6\n{} {}\n255\n", width, height);
  }
  void write(const Picture& rows) override {
    const std::size_t width = row_.size() / 3;
    for (int y = 0; y < rows.height; ++y) {
      write_channels<3>(std::span(rows.pixels).subspan(static_cast<std::size_t>(y) * width, width),
                        row_.data());
      file_->stream().write(row_.data(), static_cast<std::streamsize>(3 * width));
    }
  }
  void finish() override { file_->finish(); }
  void commit() override { file_->commit(); }

 private:
  std::unique_ptr<Output> file_;
  std::vector<char> row_;  // and a byte more
};

}  // namespace

std::unique_ptr<RowFile> ppm_row_file(const Destination& to, int width, int height) {
  return std::make_unique<PpmRowFile>(to, width, height);
}

void write_ppm(const Picture& picture, const Destination& to) {
  PpmRowFile file(to, picture.width, picture.height);
  file.write(picture);
  file.commit();
}

Picture read_ppm(const std::filesystem::path& path) {
  BinaryInput input(path);
  char magic[2] = {};
  input.stream().read(magic, 2);
  if (!input.stream() || magic[0] != 'P' || magic[1] != '6' || !is_blank(input.stream().peek())) {
    input.fail("not a PPM file: expected P6");
  }
  Picture picture;
  picture.width = read_header_number(input, "width");
  picture.height = read_header_number(input, "height");
  const int largest_value = read_header_number(input, "largest value");
  if (picture.width < 1 || picture.width > kLargestSide || picture.height < 1 ||
      picture.height > kLargestSide) {
    input.fail(fmt::format("picture of {} x {} pixels: expected 1 to {} on a side", picture.width,
                           picture.height, kLargestSide));
  }
  if (largest_value != 255) {
    input.fail(fmt::format("PPM of largest value {}: expected 255", largest_value));
  }
  const auto width = static_cast<std::size_t>(picture.width);
  const auto height = static_cast<std::size_t>(picture.height);
  if (input.bytes_left() < 3 * width * height) {
    input.fail(fmt::format("truncated: {} bytes of pixels, expected {}", input.bytes_left(),
                           3 * width * height));
  }
  picture.pixels.resize(width * height);
  std::vector<char> row(3 * width);
  std::uint32_t* pixel = picture.pixels.data();
  for (std::size_t y = 0; y < height; ++y) {
    input.read(row.data(), row.size());
    for (std::size_t x = 0; x < width; ++x) {
      std::uint32_t rgba = 0;
      std::memcpy(&rgba, &row[3 * x], 3);
      *pixel++ = in_bytes(rgba) | 0xFF000000u;
    }
  }
  return picture;
}

}  // namespace displayfile
