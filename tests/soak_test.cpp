// Segments without end opened, edited and deleted: the memory held does not grow.
// DISPLAYFILE_SOAK_SEGMENTS sets their number: a million take minutes.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>

#include "displayfile/graphics_system.h"
#include "displayfile/segments/retained_scene.h"
#include "displayfile/segments/sorted_display_file.h"
#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "tests/bench/command/counted_memory.h"
#include "tests/from_environment.h"
#include "tests/slower.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

/// An application that keeps a limited number of segments: it opens a new one, edits some of the
/// others and deletes the oldest, and draws from time to time.
class Application {
 public:
  Application() {
    system_.set_window(0.0, 1.0, 0.0, 1.0);
    system_.set_hidden_surfaces({.removal = true});
  }

  void run(int segments) {
    for (int k = 0; k < segments; ++k) step();
  }
  std::uint64_t drawn_pixels() const { return drawn_pixels_; }
  std::uint64_t refused() const { return refused_; }

 private:
  static constexpr std::size_t kMostSegments = 8;
  static constexpr int kDrawEvery = 100;
  static constexpr int kOtherName = 1 << 29;

  void step() {
    static constexpr std::array kMethods = {HiddenMethod::bsp, HiddenMethod::depth_sort};
    system_.set_hidden_surfaces({.method = dice_.of(kMethods)});
    const int name = next_name_++;
    system_.open_segment(name);
    for (int polygons = dice_.from(1, 3); polygons > 0; --polygons) {
      system_.set_pick_id(dice_.from(0, 1000));
      system_.set_fill_style({FillStyle::Kind::solid, {dice_.part(), dice_.part(), dice_.part()}});
      system_.polygon_abs_3({point(), point(), point(), point()});
      if (dice_.one_in(4)) system_.line_abs_3(dice_.part(), dice_.part(), dice_.part());
    }
    if (dice_.one_in(50)) refuse(name);
    system_.close_segment();
    open_.push_back(name);
    edit(open_[static_cast<std::size_t>(dice_.from(0, static_cast<int>(open_.size()) - 1))]);
    if (open_.size() > kMostSegments) {
      system_.delete_segment(open_.front());
      open_.pop_front();
    }
    if (name % 100'000 == 0) {
      system_.delete_all_segments();
      open_.clear();
    }
    if (name % kDrawEvery == 0) draw();
  }

  Point3 point() {
    const double x = dice_.part(), y = dice_.part();
    return {x, y, dice_.part()};
  }

  void edit(int name) {
    switch (dice_.from(0, 4)) {
      case 0: return system_.set_visibility(name, !dice_.one_in(3));
      case 1: return system_.set_image_translation(name, 0.1 * dice_.part(), 0.1 * dice_.part());
      case 2: return system_.set_image_scale(name, 0.5 + dice_.part(), 0.5 + dice_.part());
      case 3: return system_.set_image_rotation(name, dice_.part());
      default: return rename(name);
    }
  }

  void rename(int name) {
    const int other = name ^ kOtherName;  // a name that no other segment has
    system_.rename_segment(name, other);
    std::ranges::replace(open_, name, other);
  }

  /// A call out of order leaves all as it was.
  void refuse(int name) {
    try {
      system_.open_segment(name);
    } catch (const std::exception&) {
      ++refused_;
    }
  }

  void draw() {
    const RasterRequest request{
        .width = 24, .height = 24, .surfaces = {.method = HiddenMethod::z_buffer}, .ids = true};
    const Picture& picture =
        renderer_.draw(sorted_.update(system_, HiddenMethod::z_buffer, {}), request);
    drawn_pixels_ += static_cast<std::uint64_t>(
        std::ranges::count_if(picture.ids, [](std::int32_t id) { return id >= 0; }));
    HiddenSurfaceOptions all;
    all.method = HiddenMethod::depth_sort;
    all.scope = HiddenScope::all;
    sorted_.update(system_, HiddenMethod::depth_sort, all);
  }

  test::Dice dice_{1};
  GraphicsSystem system_;
  SortedDisplayFile sorted_;
  SoftwareRenderer renderer_;
  std::deque<int> open_;
  int next_name_ = 1;
  std::uint64_t drawn_pixels_ = 0, refused_ = 0;
};

TEST(Soak, ManySegmentsInTheMemoryOfAFew) {
  const int segments = test::from_environment("DISPLAYFILE_SOAK_SEGMENTS", 100'000 / test::kSlower);
  const int few = segments / 5;
  Application application;
  const auto of_few = bench::most_bytes_held([&] { application.run(few); });
  const auto of_all = bench::most_bytes_held([&] { application.run(segments - few); });
  EXPECT_GT(of_few, 10'000);
  EXPECT_LE(of_all, 4 * of_few) << "memory grows with the segments that were deleted";
  EXPECT_GT(application.drawn_pixels(), 0u);
  EXPECT_GT(application.refused(), 0u);
}

/// Points are held in the scene and, viewed, in the display file; no other data are as large, nor
/// is there much unused room.
TEST(Memory, OfARetainedSegmentIsLittleMoreThanItsPointsInTheWorldAndInTheView) {
  constexpr int kTriangles = 20'000;  // arrays that double would have room for 32,768
  constexpr std::int64_t kPoints = 2 * 3 * sizeof(Point3), kNumbers = 16 + 4 * 4 + 3;
  const auto held = [] {
    std::int64_t bytes = 0;
    bench::counted_memory([&] {
      RetainedScene scene;
      GraphicsSystem system;
      system.retain(&scene);
      system.open_segment(1);
      for (int i = 0; i < kTriangles; ++i) {
        const double x = 1e-5 * i;
        system.polygon_abs_3({{x, 0.1, 0.2}, {x + 0.1, 0.3, 0.1}, {x, 0.7, 0.6}});
      }
      system.close_segment();
      bytes = bench::bytes_held_now();
    });
    return bytes;
  };
  EXPECT_LE(held(), kTriangles * (kPoints + kNumbers) * 5 / 4);
}

}  // namespace
}  // namespace displayfile
