// The scan-line z-buffer, besides its pictures (software_truth_test.cpp): any rows alone, its
// memory, and how often it needs exact arithmetic. Pictures that are written as their rows come.

#include "interp/visibility/scan_line_z.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <numbers>
#include <ostream>

#include "hidden/exact/predicate_counts.h"
#include "interp/draw/draw.h"
#include "interp/files/npy_file.h"
#include "interp/files/png_file.h"
#include "interp/files/ppm_file.h"
#include "interp/raster/software.h"
#include "interp/visibility/z_buffer.h"
#include "tests/bench/command/counted_memory.h"
#include "tests/slower.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

namespace fs = std::filesystem;
using Fill = ViewedScene::Fill;

// ---- Rows ------------------------------------------------------------------------------

/// The fills seen in rows row_begin <= row < row_end, row by row.
std::vector<Fill> seen_in(const ImageSpaceMethod& method, const PictureSize& size, int row_begin,
                          int row_end) {
  const auto width = static_cast<std::size_t>(size.width);
  std::vector<Fill> fills(width * static_cast<std::size_t>(row_end - row_begin), ~Fill{0});
  method.draw_rows(row_begin, row_end, [&](int row, int first, std::span<const Fill> seen) {
    std::ranges::copy(seen, fills.begin() + (row - row_begin) * size.width + first);
  });
  return fills;
}

TEST(ScanLineZ, AnyRowsAloneAreThoseOfThePicture) {
  constexpr PictureSize kSize{33, 29};
  for (const test::SceneFamily& family : test::scene_families()) {
    for (std::uint32_t seed = 0; seed < 20 / test::kSlower; ++seed) {
      const ViewedScene scene(test::scene(family, seed, 40));
      ScanLineZ method;
      method.prepare({scene, kSize, {}}, 1);
      const std::vector<Fill> whole = seen_in(method, kSize, 0, kSize.height);
      for (const auto& [begin, end] : {std::pair{0, 1}, {1, 17}, {13, 14}, {14, 29}, {28, 29}}) {
        const std::vector<Fill> rows(whole.begin() + begin * kSize.width,
                                     whole.begin() + end * kSize.width);
        ASSERT_EQ(seen_in(method, kSize, begin, end), rows)
            << fmt::format("{}, seed {}, rows {} to {}", family.name, seed, begin, end);
      }
    }
  }
}

/// Nothing is exact then, but the same doubles are compared in the same order: also by the
/// z-buffer, which uses them only where single precision does not decide.
TEST(ScanLineZ, WithRoundoffTheFillsSeenAreTheZBuffers) {
  constexpr PictureSize kSize{47, 41};
  for (const double roundoff : {0.0, 1e-9, 1e-2}) {
    for (const test::SceneFamily& family : test::scene_families()) {
      const ViewedScene scene(test::scene(family, 5, 60));
      ScanLineZ scan_line;
      ZBuffer z_buffer;
      scan_line.prepare({scene, kSize, roundoff}, 1);
      z_buffer.prepare({scene, kSize, roundoff}, 1);
      ASSERT_EQ(seen_in(scan_line, kSize, 0, kSize.height),
                seen_in(z_buffer, kSize, 0, kSize.height))
          << family.name << ", roundoff " << roundoff;
    }
  }
}

// ---- Costs -----------------------------------------------------------------------------

/// A picture full of triangles of any size.
DisplayFile many_triangles(int polygons) {
  test::Dice dice(3);
  DisplayFile file;
  Segment& segment = file.create(1);
  segment.set_style(LineStyle{LineStyle::Kind::none});
  for (int k = 0; k < polygons; ++k) {
    segment.set_pick(k);
    const double size = std::pow(2.0, -dice.from(0, 6));
    const double x = dice.part(), y = dice.part(), z = dice.part();
    test::enter(segment, {{x, y, z}, {x + size, y, z}, {x, y + size, z + dice.part()}});
  }
  return file;
}

std::int64_t memory_of(ImageSpaceMethod& method, const ViewedScene& scene,
                       const PictureSize& size) {
  return bench::most_bytes_held([&] {
    method.prepare({scene, size, {}}, 1);
    method.draw_rows(0, size.height, [](int, int, std::span<const Fill>) {});
  });
}

TEST(ScanLineZ, MemoryDoesNotGrowWithThePicturesHeight) {
  const ViewedScene scene(many_triangles(2000));
  ScanLineZ low, high;
  const std::int64_t least = memory_of(low, scene, {40, 500});
  const std::int64_t most = memory_of(high, scene, {40, 60'000});
  EXPECT_LT(most, least + least / 4);
}

TEST(ScanLineZ, MemoryIsAFewBytesAPolygonAndARow) {
  const ViewedScene scene(many_triangles(100));
  ScanLineZ scan_line;
  const PictureSize size{2000, 2000};
  constexpr std::int64_t kOfWholeZBuffer = 8 * 2000 * 2000;  // a depth and a fill for each pixel
  EXPECT_LT(100 * memory_of(scan_line, scene, size), kOfWholeZBuffer);
}

std::uint64_t exact_decisions(const ViewedScene& scene, const PictureSize& size) {
  ScanLineZ method;
  method.prepare({scene, size, {}}, 1);
  reset_predicate_counts();
  method.draw_rows(0, size.height, [](int, int, std::span<const Fill>) {});
  std::uint64_t sum = 0;
  for (const StageCounts& counts : predicate_counts()) sum += counts.exact;
  return sum;
}

/// Rectangles that cover the picture, each this much above the last; all on one tilted plane if 0.
ViewedScene sheets(int n, double apart) {
  DisplayFile file;
  Segment& segment = file.create(1);
  for (int k = 0; k < n; ++k) {
    const double x = -0.25 - 0.01 * k, z = 0.5 + k * apart;
    const double third = 1.0 / 3.0;
    const auto on = [&](double px, double py) { return Point3{px, py, z + px * 0.25 + py * 0.5}; };
    if (apart == 0.0) {
      test::enter(segment, {on(-0.25, -0.5 - 0.25 * k), on(1.5, -0.5), on(0.5, 2.0 + 0.5 * k)});
    } else {
      test::enter(segment,
                  {{x, -0.3, z}, {1.3, -0.3, z}, {1.3, 1.3, z + third}, {x, 1.3, z + third}});
    }
  }
  return ViewedScene(file);
}

/// Sheets that rounded depths do not distinguish take exact arithmetic for a row at most, not for a
/// pixel; those of one plane for the picture.
TEST(ScanLineZ, ExactDecisionsDoNotGrowWithThePicturesWidth) {
  constexpr int kSheets = 20;
  const std::uint64_t narrow = exact_decisions(sheets(kSheets, 0x1p-53), {50, 40});
  EXPECT_EQ(exact_decisions(sheets(kSheets, 0x1p-53), {5000, 40}), narrow);
  EXPECT_LE(exact_decisions(sheets(kSheets, 0.0), {1000, 1000}), 3u * kSheets * (kSheets - 1) / 2);
}

// ---- Pictures written as their rows come -----------------------------------------------

/// A folder of its own for each test, gone afterwards.
class RowsWritten : public testing::Test {
 protected:
  RowsWritten() {
    folder_ = fs::path(testing::TempDir()) / fmt::format("rows_written_{}", ::getpid());
    fs::create_directories(folder_);
  }
  ~RowsWritten() override { fs::remove_all(folder_); }
  fs::path file(const std::string& name) const { return folder_ / name; }
  bool empty_folder() const { return fs::is_empty(folder_); }

 private:
  fs::path folder_;
};

/// Fills that cross one another, and lines that cross the whole picture: thin, wide, dashed, flat,
/// steep, and far beyond its borders.
GraphicsSystem crossing_fills_and_lines() {
  GraphicsSystem g;
  g.set_window(0, 1, 0, 1);
  g.set_view_depth(-2, 2);
  test::Dice dice(11);
  g.open_segment(1);
  for (int k = 0; k < 40; ++k) {
    const LineStyle::Kind kind = k % 3 == 0   ? LineStyle::Kind::none
                                 : k % 3 == 1 ? LineStyle::Kind::solid
                                              : LineStyle::Kind::dashed;
    LineStyle style{kind, {0.0, dice.part(), dice.part()}};
    style.width = dice.of(std::array{1.0, 2.5, 9.0});
    g.set_line_style(style);
    g.set_fill_style({FillStyle::Kind::solid, {dice.part(), dice.part(), 1.0}});
    const auto point = [&] { return Point3{dice.part(), dice.part(), dice.part()}; };
    g.polygon_abs_3({point(), point(), point()});
    const Point3 from = point(), to = point();
    g.move_abs_3(from.x, from.y, from.z);
    g.line_abs_3(to.x, 0.001 * k + from.y, to.z);
    g.line_abs_3(to.x, to.y, from.z);
  }
  g.close_segment();
  g.set_image_scale(1, 2.0, 3.0);
  g.set_image_translation(1, -0.5, -0.75);
  return g;
}

struct Case {
  HiddenMethod method;
  int width, height, threads;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << name_of(c.method) << ' ' << c.width << 'x' << c.height << ", " << c.threads << " threads";
}

class RowsWrittenOf : public RowsWritten, public testing::WithParamInterface<Case> {};

// Sizes of more pixels than are held at a time.
INSTANTIATE_TEST_SUITE_P(Pictures, RowsWrittenOf,
                         testing::Values(Case{HiddenMethod::scan_line_z, 1237, 2111, 1},
                                         Case{HiddenMethod::scan_line_z, 65535, 37, 2},
                                         Case{HiddenMethod::z_buffer, 33333, 131, 1},
                                         Case{HiddenMethod::none, 20011, 157, 2},
                                         Case{HiddenMethod::depth_sort, 9001, 151, 1}));

TEST_P(RowsWrittenOf, AreThePictureInMemory) {
  const GraphicsSystem g = crossing_fills_and_lines();
  DrawOptions options{.samples = 1};
  options.surfaces.method = GetParam().method;
  options.width = GetParam().width;
  options.height = GetParam().height;
  options.surfaces.threads = GetParam().threads;
  options.ids = file("ids.npy");
  options.depth = file("depth.npy");
  draw(g, file("a.png"), options);
  const Picture picture = draw(g, options);
  EXPECT_EQ(read_png(file("a.png")).pixels, picture.pixels);
  EXPECT_EQ(std::get<0>(read_npy(options.ids).values), picture.ids);
  EXPECT_EQ(std::get<1>(read_npy(options.depth).values), picture.depth);
  options.ids.clear();
  options.depth.clear();
  draw(g, file("a.ppm"), options);
  EXPECT_EQ(read_ppm(file("a.ppm")).pixels, picture.pixels);
}

TEST_F(RowsWritten, MemoryDoesNotGrowWithThePicturesHeight) {
  GraphicsSystem g = crossing_fills_and_lines();
  const auto memory = [&](int height) {
    return bench::most_bytes_held([&] {
      draw(g, file("a.png"),
           {.width = 600,
            .height = height,
            .surfaces = {.method = HiddenMethod::scan_line_z},
            .samples = 1});
    });
  };
  const std::int64_t of_one_strip = memory(1700);
  EXPECT_LT(memory(20'000), of_one_strip + of_one_strip / 10);
}

TEST_F(RowsWritten, NoFileIsLeftOfARowFileThatWasNotCommitted) {
  const Picture row{3, 1, {1, 2, 3}, {4, 5, 6}, {7.0, 8.0, 9.0}};
  for (auto* row_file : {png_row_file, ppm_row_file, ids_row_file, depth_row_file}) {
    row_file(file("a"), 3, 2)->write(row);
    EXPECT_TRUE(empty_folder());
  }
}

}  // namespace
}  // namespace displayfile
