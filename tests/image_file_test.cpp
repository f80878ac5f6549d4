// PNG, PPM and NumPy files: a written file reads back the same, and a bad file is an Error that
// names it, never a crash or a huge allocation. The comparison of pictures and arrays.

#include <gtest/gtest.h>
#include <png.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <utility>

#include "clip/base/error.h"
#include "interp/files/npy_file.h"
#include "interp/files/picture_compare.h"
#include "interp/files/png_file.h"
#include "interp/files/ppm_file.h"
#include "tests/error_of.h"
#include "tests/temporary_folder.h"

namespace displayfile {
namespace {

namespace fs = std::filesystem;

using test::content;
using test::error_of;

class ImageFile : public test::TemporaryFolder {};

bool mentions(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

Picture noise(int width, int height) {
  Picture picture{width, height, {}, {}, {}};
  std::mt19937 random(7);
  for (int i = 0; i < width * height; ++i) {
    picture.pixels.push_back(0xff000000u | (static_cast<std::uint32_t>(random()) & 0xffffffu));
  }
  return picture;
}

/// The pixels as passed to libpng.
std::uint32_t pixel(unsigned r, unsigned g, unsigned b) {
  return 0xff000000u | b << 16 | g << 8 | r;
}

std::string big_endian(std::uint32_t v) {
  return {static_cast<char>(v >> 24), static_cast<char>(v >> 16), static_cast<char>(v >> 8),
          static_cast<char>(v)};
}

std::string png_chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  std::uint32_t crc = 0xffffffffu;
  for (const char c : body) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0u);
  }
  return big_endian(static_cast<std::uint32_t>(data.size())) + body + big_endian(~crc);
}

const std::string kPngSignature("\x89PNG\r\n\x1a\n", 8);

std::string png_header(std::uint32_t width, std::uint32_t height) {
  return kPngSignature + png_chunk("IHDR", big_endian(width) + big_endian(height) +
                                               std::string("\x08\x02\0\0\0", 5));
}

/// A PNG written by libpng itself, in any of its formats.
struct PngSpecification {
  int bit_depth, colour_type, interlace;
};
void write_by_libpng(const fs::path& path, const PngSpecification& as, png_uint_32 width,
                     std::vector<std::string> rows) {
  std::FILE* out = std::fopen(path.c_str(), "wb");
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, out);
  png_set_IHDR(png, info, width, static_cast<png_uint_32>(rows.size()), as.bit_depth,
               as.colour_type, as.interlace, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  const png_color palette[2] = {{10, 20, 30}, {200, 100, 50}};
  if (as.colour_type == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette, 2);
  png_write_info(png, info);
  std::vector<png_bytep> pointers;
  for (std::string& row : rows) pointers.push_back(reinterpret_cast<png_bytep>(row.data()));
  png_write_image(png, pointers.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  std::fclose(out);
}

// ---- PNG -------------------------------------------------------------------------------

TEST_F(ImageFile, PngReadsBackTheSame) {
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 5}, {257, 64}}) {
    const Picture picture = noise(width, height);
    write_png(picture, file("a.png"));
    const Picture back = read_png(file("a.png"));
    EXPECT_EQ(back.width, width);
    EXPECT_EQ(back.height, height);
    EXPECT_EQ(back.pixels, picture.pixels);
  }
}

TEST_F(ImageFile, PngBytesDependOnThePixelsAlone) {
  const Picture picture = noise(40, 30);
  write_png(picture, file("a.png"));
  write_png(picture, file("b.png"));
  const std::string bytes = content(file("a.png"));
  EXPECT_EQ(bytes, content(file("b.png")));
  EXPECT_FALSE(mentions(bytes, "tIME"));
  // 8-bit RGB without alpha.
  EXPECT_EQ(bytes.substr(24, 2), std::string("\x08\x02", 2));
}

TEST_F(ImageFile, PngOfEveryKindIsRead) {
  const fs::path path = file("a.png");
  for (const int interlace : {PNG_INTERLACE_NONE, PNG_INTERLACE_ADAM7}) {
    write_by_libpng(path, {8, PNG_COLOR_TYPE_GRAY, interlace}, 2, {{"\x10\xf0", 2}});
    EXPECT_EQ(read_png(path).pixels,
              (std::vector{pixel(0x10, 0x10, 0x10), pixel(0xf0, 0xf0, 0xf0)}));
    write_by_libpng(path, {1, PNG_COLOR_TYPE_GRAY, interlace}, 2, {{"\x40", 1}});
    EXPECT_EQ(read_png(path).pixels, (std::vector{pixel(0, 0, 0), pixel(255, 255, 255)}));
    write_by_libpng(path, {8, PNG_COLOR_TYPE_PALETTE, interlace}, 2, {{"\x01\x00", 2}});
    EXPECT_EQ(read_png(path).pixels, (std::vector{pixel(200, 100, 50), pixel(10, 20, 30)}));
    write_by_libpng(path, {16, PNG_COLOR_TYPE_RGB, interlace}, 1,
                    {{"\x01\x80\x02\x80\x03\x80", 6}});
    EXPECT_EQ(read_png(path).pixels, (std::vector{pixel(1, 2, 3)}));
    // Half-transparent pixels are composited over white.
    write_by_libpng(path, {8, PNG_COLOR_TYPE_RGB_ALPHA, interlace}, 2,
                    {{"\x0a\x14\x1e\xff\x00\x00\xff\x80", 8}});
    EXPECT_EQ(read_png(path).pixels, (std::vector{pixel(10, 20, 30), pixel(127, 127, 255)}));
  }
}

TEST_F(ImageFile, TruncatedPngIsAnErrorWhereverItEnds) {
  write_png(noise(20, 20), file("whole.png"));
  const std::string whole = content(file("whole.png"));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const fs::path path = file("part.png", whole.substr(0, length));
    const std::string message = error_of([&] { read_png(path); });
    ASSERT_TRUE(mentions(message, path.string())) << length << ": " << message;
  }
}

TEST_F(ImageFile, DamagedPngIsAnErrorOrAPicture) {
  write_png(noise(20, 20), file("whole.png"));
  const std::string whole = content(file("whole.png"));
  int errors = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
    const fs::path path = file("damaged.png", damaged);
    errors += error_of([&] { read_png(path); }).empty() ? 0 : 1;
  }
  // Every chunk carries a check sum; only the names of chunks that may be skipped are free.
  EXPECT_GT(errors, static_cast<int>(whole.size()) - 16);
}

TEST_F(ImageFile, WhatIsNotAPngSaysSo) {
  EXPECT_TRUE(mentions(error_of([&] { read_png(file("text.png", "P6 1 1 255")); }), "not a PNG"));
  EXPECT_TRUE(mentions(error_of([&] { read_png(file("empty.png", "")); }), "not a PNG"));
  EXPECT_TRUE(mentions(error_of([&] { read_png(file("none.png")); }), "none.png: no such file"));
  EXPECT_TRUE(mentions(error_of([&] { read_png(file("")); }), "not a regular file"));
}

TEST_F(ImageFile, AbsurdPngSizesAreRefusedBeforeMemoryIsTaken) {
  const auto read = [&](std::uint32_t width, std::uint32_t height) {
    const std::string data = png_chunk("IDAT", "x") + png_chunk("IEND", "");
    return error_of([&] { read_png(file("a.png", png_header(width, height) + data)); });
  };
  EXPECT_TRUE(mentions(read(1'000'000, 1'000'000), "1000000 x 1000000"));
  EXPECT_TRUE(mentions(read(65535, 65535), "cannot hold 65535 x 65535"));
  EXPECT_TRUE(mentions(read(0, 5), "damaged PNG"));
  EXPECT_TRUE(mentions(read(0x7fffffff, 0x7fffffff), "expected at most 65535"));
}

// ---- PPM -------------------------------------------------------------------------------

TEST_F(ImageFile, PpmReadsBackTheSame) {
  const Picture picture = noise(31, 7);
  write_ppm(picture, file("a.ppm"));
  const Picture back = read_ppm(file("a.ppm"));
  EXPECT_EQ(back.width, 31);
  EXPECT_EQ(back.height, 7);
  EXPECT_EQ(back.pixels, picture.pixels);
}

TEST_F(ImageFile, PpmBytes) {
  const Picture picture{2, 1, {pixel(1, 2, 3), pixel(255, 0, 7)}, {}, {}};
  write_ppm(picture, file("a.ppm"));
  EXPECT_EQ(content(file("a.ppm")), std::string("P6\n2 1\n255\n\x01\x02\x03\xff\x00\x07", 17));
}

TEST_F(ImageFile, PpmHeaderMayHoldCommentsAndBlanks) {
  const Picture picture = read_ppm(file("a.ppm", "P6 # by hand\n# size:\n  1\t#w\n2\n255\nabcdef"));
  EXPECT_EQ(picture.pixels, (std::vector{pixel('a', 'b', 'c'), pixel('d', 'e', 'f')}));
}

TEST_F(ImageFile, BadPpmIsAnError) {
  const auto read = [&](const std::string& bytes) {
    const fs::path path = file("a.ppm", bytes);
    const std::string message = error_of([&] { read_ppm(path); });
    EXPECT_TRUE(mentions(message, path.string())) << message;
    return message;
  };
  EXPECT_TRUE(mentions(read(""), "expected P6"));
  EXPECT_TRUE(mentions(read("P3\n1 1\n255\n1 2 3"), "expected P6"));
  EXPECT_TRUE(mentions(read("P6\n2 2\n255\nabc"), "truncated: 3 bytes of pixels, expected 12"));
  EXPECT_TRUE(mentions(read("P6\n2"), "truncated"));
  EXPECT_TRUE(mentions(read("P6\n# no end"), "truncated"));
  EXPECT_TRUE(mentions(read("P6\n0 2\n255\n"), "expected 1 to 65535"));
  EXPECT_TRUE(mentions(read("P6\n70000 2\n255\n"), "expected 1 to 65535"));
  EXPECT_TRUE(mentions(read("P6\n99999999999 2\n255\n"), "too large"));
  EXPECT_TRUE(mentions(read("P6\n65535 65535\n255\nabc"), "truncated"));
  EXPECT_TRUE(mentions(read("P6\n-1 2\n255\n"), "width"));
  EXPECT_TRUE(mentions(read("P6\n1 1\n65535\nabcdef"), "expected 255"));
}

// ---- NPY -------------------------------------------------------------------------------

TEST_F(ImageFile, NpyReadsBackTheSame) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<std::int32_t> ids{-1, 0, 1, 2'000'000'000, -2'000'000'000, 7};
  const std::vector<double> depth{-infinity, 0.1, 1e-300, -0.0, 1.0, std::nan("")};
  write_npy(ids, 3, 2, file("ids.npy"));
  write_npy(depth, 2, 3, file("depth.npy"));
  const NpyArray ids_back = read_npy(file("ids.npy"));
  const NpyArray depth_back = read_npy(file("depth.npy"));
  EXPECT_EQ(ids_back.width, 3);
  EXPECT_EQ(ids_back.height, 2);
  EXPECT_EQ(std::get<0>(ids_back.values), ids);
  EXPECT_EQ(depth_back.width, 2);
  const auto& values = std::get<1>(depth_back.values);
  ASSERT_EQ(values.size(), depth.size());
  EXPECT_EQ(std::memcmp(values.data(), depth.data(), 6 * sizeof(double)), 0);
}

TEST_F(ImageFile, NpyBytes) {
  write_npy(std::vector<std::int32_t>{-1, 258, 3, 4, 5, 6}, 3, 2, file("a.npy"));
  const std::string bytes = content(file("a.npy"));
  const std::string dictionary = "{'descr': '<i4', 'fortran_order': False, 'shape': (2, 3), }";
  const std::string header = std::string("\x93NUMPY\x01\x00\x76\x00", 10) + dictionary +
                             std::string(117 - dictionary.size(), ' ') + "\n";
  ASSERT_EQ(header.size(), 128u);
  EXPECT_EQ(bytes.substr(0, 128), header);
  EXPECT_EQ(bytes.substr(128, 8), std::string("\xff\xff\xff\xff\x02\x01\x00\x00", 8));
  EXPECT_EQ(bytes.size(), 128u + 24u);
  write_npy(std::vector<double>{1.0}, 1, 1, file("b.npy"));
  EXPECT_TRUE(mentions(content(file("b.npy")), "'descr': '<f8'"));
  EXPECT_EQ(content(file("b.npy")).substr(128), std::string("\0\0\0\0\0\0\xf0\x3f", 8));
}

std::string npy(const std::string& dictionary, const std::string& data, char version = 1) {
  std::string bytes = std::string("\x93NUMPY", 6) + version + '\0';
  bytes += static_cast<char>(dictionary.size());
  bytes += '\0';
  if (version > 1) bytes += std::string(2, '\0');
  return bytes + dictionary + data;
}

TEST_F(ImageFile, NpyOfOtherTypesAndVersionsIsRead) {
  const auto read = [&](const std::string& bytes) { return read_npy(file("a.npy", bytes)).values; };
  const std::string shape = "'fortran_order': False, 'shape': (1, 2)";
  EXPECT_EQ(std::get<0>(read(npy("{'descr': '|u1', " + shape + "}\n", "\x07\xff"))),
            (std::vector<std::int32_t>{7, 255}));
  EXPECT_EQ(
      std::get<0>(read(npy("{'descr': '<i8', " + shape + ", }\n",
                           std::string("\xff\xff\xff\xff\xff\xff\xff\xff\x02\0\0\0\0\0\0\0", 16)))),
      (std::vector<std::int32_t>{-1, 2}));
  EXPECT_EQ(std::get<1>(read(npy("{" + shape + ",\"descr\":\"<f4\"}",
                                 std::string("\0\0\x80\x3f\0\0\x80\xff", 8), 2))),
            (std::vector<double>{1.0, -std::numeric_limits<double>::infinity()}));
}

TEST_F(ImageFile, NpyInFortranOrderIsTheSameArray) {
  const NpyArray array =
      read_npy(file("a.npy", npy("{'descr': '|u1', 'fortran_order': True, 'shape': (2, 3)}",
                                 std::string("\1\4\2\5\3\6", 6))));
  EXPECT_EQ(array.width, 3);
  EXPECT_EQ(array.height, 2);
  EXPECT_EQ(std::get<0>(array.values), (std::vector<std::int32_t>{1, 2, 3, 4, 5, 6}));
}

TEST_F(ImageFile, BadNpyIsAnError) {
  const auto read = [&](const std::string& bytes) {
    const fs::path path = file("a.npy", bytes);
    const std::string message = error_of([&] { read_npy(path); });
    EXPECT_TRUE(mentions(message, path.string())) << message;
    return message;
  };
  const auto with = [&](const std::string& type, const std::string& order, const std::string& shape,
                        const std::string& data) {
    return read(npy(
        "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + "}", data));
  };
  EXPECT_TRUE(mentions(read(""), "not a .npy file"));
  EXPECT_TRUE(mentions(read("PK\x03\x04 a zipped .npz"), "not a .npy file"));
  EXPECT_TRUE(mentions(read(npy("{}", "", 9)), "version 9: expected 1 to 3"));
  EXPECT_TRUE(mentions(read(npy("{}", "", '\xC8')), "version 200: expected 1 to 3"));
  EXPECT_TRUE(mentions(read(std::string("\x93NUMPY\x01\x00\xff\xff{", 11)), "truncated"));
  EXPECT_TRUE(mentions(read(std::string("\x93NUMPY\x02\x00\xff\xff\xff\xff{", 13)), "header of"));
  for (const char* dictionary : {"{}", "", "{'descr': '<i4'}", "{'descr': '<i4', 'shape': (1, 1)}",
                                 "{'descr': 4, 'fortran_order': False, 'shape': (1, 1)}",
                                 "{'descr': '<i4', 'fortran_order': False, 'shape': (1, 1)",
                                 "{'descr': '<i4', 'fortran_order': False, 'shape': (1, 1),",
                                 "{'descr': '<i4', 'fortran_order': False, 'shape': (1, 1} ",
                                 "{'descr': '<i4', 'fortran_order': False, 'shape': (1, -1)}",
                                 "{'descr': '<i4', 'fortran_order': no, 'shape': (1, 1)}",
                                 "{'descr': '<i4', 'fortran_order': False, 'shape': (1, 1)} x"}) {
    EXPECT_TRUE(mentions(read(npy(dictionary, "1234")), "expected a dictionary")) << dictionary;
  }
  EXPECT_TRUE(mentions(with("<i4", "False", "(1,)", "1234"), "1 dimensions"));
  EXPECT_TRUE(mentions(with("<i4", "False", "()", "1234"), "0 dimensions"));
  EXPECT_TRUE(mentions(with("<i4", "False", "(1, 1, 1)", "1234"), "3 dimensions"));
  EXPECT_TRUE(mentions(with("<i4", "False", "(0, 1)", ""), "expected 1 to 65535"));
  EXPECT_TRUE(mentions(with("<i4", "False", "(1000000, 1000000)", "1234"), "expected 1 to 65535"));
  EXPECT_TRUE(mentions(with("<i4", "False", "(65535, 65535)", "1234"), "truncated"));
  EXPECT_TRUE(mentions(with("<i4", "False", "(1, 2)", "1234567"), "7 bytes of values, expected 8"));
  EXPECT_TRUE(mentions(with("<i4", "False", "(1, 2)", "123456789"), "too long"));
  EXPECT_TRUE(mentions(with(">i4", "False", "(1, 1)", "1234"), "'>i4': expected int32"));
  EXPECT_TRUE(mentions(with("<c16", "False", "(1, 1)", "1234"), "expected int32"));
  EXPECT_TRUE(mentions(with("<i8", "False", "(1, 1)", std::string("\0\0\0\0\1\0\0\0", 8)),
                       "value 4294967296"));
}

// ---- Failing writes --------------------------------------------------------------------

TEST_F(ImageFile, NothingIsLeftWhenWritingFails) {
  Picture picture = noise(4, 4);
  const std::vector<std::int32_t> ids(16);
  const fs::path nowhere = file("no-such-folder") / "a";
  EXPECT_TRUE(mentions(error_of([&] { write_png(picture, nowhere); }), nowhere.string()));
  EXPECT_TRUE(mentions(error_of([&] { write_ppm(picture, nowhere); }), nowhere.string()));
  EXPECT_TRUE(mentions(error_of([&] { write_npy(ids, 4, 4, nowhere); }), nowhere.string()));
  EXPECT_TRUE(mentions(error_of([&] { write_npy(ids, 4, 5, file("a")); }), "16 values"));
  picture.width = 0;
  EXPECT_FALSE(error_of([&] { write_png(picture, file("a")); }).empty());
  EXPECT_FALSE(error_of([&] { write_ppm(picture, file("a")); }).empty());
  EXPECT_FALSE(error_of([&] { write_npy(ids, 0, 0, file("a")); }).empty());
  EXPECT_TRUE(empty_folder());
}

TEST_F(ImageFile, FullDiskIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const Picture picture = noise(200, 200);
  EXPECT_TRUE(mentions(error_of([&] { write_png(picture, "/dev/full"); }), "/dev/full"));
  EXPECT_TRUE(mentions(error_of([&] { write_ppm(picture, "/dev/full"); }), "/dev/full"));
}

// ---- Comparing -------------------------------------------------------------------------

TEST(PictureCompare, CountsWrongPixelsAndTheLargestChannelDifference) {
  const Picture a{2, 2, {pixel(0, 0, 0), pixel(9, 9, 9), pixel(1, 2, 3), pixel(5, 5, 5)}, {}, {}};
  Picture b = a;
  EXPECT_FALSE(compare(a, b).differs());
  b.pixels[1] = pixel(9, 10, 9);
  b.pixels[2] = pixel(1, 2, 203);
  const PictureDifference d = compare(a, b);
  EXPECT_TRUE(d.differs());
  EXPECT_EQ(d.pixels, 4);
  EXPECT_EQ(d.wrong_pixels, 2);
  EXPECT_EQ(d.largest, 200.0);
}

TEST(PictureCompare, AnotherSizeDiffers) {
  const PictureDifference d = compare(noise(2, 3), noise(3, 2));
  EXPECT_FALSE(d.same_size);
  EXPECT_TRUE(d.differs());
  EXPECT_TRUE(
      compare(NpyArray{2, 1, std::vector<double>(2)}, NpyArray{1, 2, std::vector<double>(2)})
          .differs());
}

TEST(PictureCompare, ItemBuffersTellBackgroundFromPolygons) {
  const NpyArray a{4, 1, std::vector<std::int32_t>{-1, 3, 4, 5}};
  const NpyArray b{4, 1, std::vector<std::int32_t>{2, 3, 9, -1}};
  const PictureDifference d = compare(a, b);
  EXPECT_EQ(d.wrong_pixels, 3);
  EXPECT_EQ(d.background_and_polygon, 2);
  EXPECT_EQ(d.polygon_and_polygon, 1);
  EXPECT_EQ(d.largest, 6.0);
}

TEST(PictureCompare, EqualInfinitiesAndNotANumbersAreEqual) {
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  const NpyArray a{3, 1, std::vector<double>{-infinity, nan, 0.25}};
  EXPECT_FALSE(compare(a, a).differs());
  const NpyArray b{3, 1, std::vector<double>{-infinity, nan, 0.5}};
  EXPECT_EQ(compare(a, b).wrong_pixels, 1);
  EXPECT_EQ(compare(a, b).largest, 0.25);
  const NpyArray c{3, 1, std::vector<double>{0.0, 1.0, 0.25}};
  EXPECT_EQ(compare(a, c).wrong_pixels, 2);
  EXPECT_EQ(compare(a, c).largest, infinity);
  const NpyArray ints{3, 1, std::vector<std::int32_t>{0, 1, 2}};
  EXPECT_EQ(compare(ints, c).wrong_pixels, 1);
  EXPECT_EQ(compare(ints, c).largest, 1.75);
}

}  // namespace
}  // namespace displayfile
