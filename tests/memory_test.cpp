// Running out of memory, each in a process of its own whose memory is limited.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <regex>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/memory.h"
#include "displayfile/files.h"
#include "interp/draw/renderer.h"
#include "interp/truth/truth.h"
#include "tests/error_of.h"

namespace displayfile {
namespace {

using test::error_of;

constexpr std::size_t kMegabyte = 1000000;

/// Limits memory to the bytes in use plus `more`.
void limit_memory(std::size_t more) {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t most = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + more;
  const rlimit limit{most, most};
  setrlimit(RLIMIT_AS, &limit);
}

/// The result of work(), in a process that has `more` bytes of memory more than this one. It has an
/// L in place of the limit, which differs at every start.
std::string within(std::size_t more, const std::function<std::string()>& work) {
  int ends[2];
  if (pipe(ends) != 0) return "no pipe";
  const pid_t child = fork();
  if (child == 0) {
    std::string result;
    try {
      limit_memory(more);
      result = work();
    } catch (const std::exception& other) {
      result = std::string("not an Error: ") + other.what();
    }
    const bool written =
        write(ends[1], result.data(), result.size()) == static_cast<ssize_t>(result.size());
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  std::string result;
  char bytes[512];
  for (ssize_t n = 0; (n = read(ends[0], bytes, sizeof bytes)) > 0;) {
    result.append(bytes, static_cast<std::size_t>(n));
  }
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return "the process ended: " + result;
  return std::regex_replace(result, std::regex("(the limit is |: )[0-9]+( bytes are not enough)?"),
                            "$1L$2");
}

GraphicsSystem triangle() {
  GraphicsSystem g;
  g.open_segment(1);
  g.polygon_abs_3({{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
  g.close_segment();
  return g;
}

TEST(OutOfMemory, OfAPictureIsSaidBeforeAnyWork) {
  const GraphicsSystem g = triangle();
  EXPECT_EQ(within(500 * kMegabyte,
                   [&] { return error_of([&] { draw(g, {.width = 60000, .height = 60000}); }); }),
            "out of memory: a picture of 60000 x 60000 pixels needs at least 14400000000 bytes, "
            "and the limit is L");
  EXPECT_EQ(
      within(500 * kMegabyte,
             [&] {
               Renderer renderer;
               renderer.draw(g, {.width = 100, .height = 100, .samples = 1});
               DrawOptions all{.width = 60000, .height = 60000};
               all.with_ids = all.with_depth = true;
               const std::string error = error_of([&] { renderer.draw(g, all); });
               const Picture& next = renderer.draw(g, {.width = 100, .height = 100, .samples = 1});
               return error +
                      (next.pixels == draw(g, {.width = 100, .height = 100, .samples = 1}).pixels
                           ? ""
                           : ", and another picture");
             }),
      "out of memory: a picture of 60000 x 60000 pixels needs at least 57600000000 bytes, "
      "and the limit is L");
  EXPECT_EQ(within(500 * kMegabyte,
                   [&] { return error_of([&] { truth(g.display_file(), 65535, 65535, false); }); }),
            "out of memory: the truth of 65535 x 65535 pixels needs at least 73012215825 bytes, "
            "and the limit is L");
}

/// In numbers that are large enough for large pages, or not.
TEST(LargePages, HoldAsManyValuesAsAskedFor) {
  for (const std::size_t count : {0u, 5u, 3'000'001u, 9'000'001u}) {
    const std::vector<double> values = in_large_pages(count, 0.5);
    EXPECT_EQ(values.size(), count);
    EXPECT_TRUE(std::ranges::all_of(values, [](double value) { return value == 0.5; }));
  }
}

TEST(OutOfMemory, RowsOfAPictureNeedTheirOwnMemory) {
  const GraphicsSystem g = triangle();
  const auto error_of_rows = [&](int end) {
    return within(500 * kMegabyte, [&] {
      return error_of([&] {
        draw(g, {.width = 60000, .height = 60000, .rows = PictureRows{0, end}});
      });
    });
  };
  EXPECT_EQ(error_of_rows(100), "");
  EXPECT_EQ(error_of_rows(20000),
            "out of memory: a picture of 60000 x 20000 pixels needs at least 4800000000 bytes, and "
            "the limit is L");
}

/// The memory of the previous picture is reused, not allocated a second time.
TEST(OutOfMemory, ARendererNeedsOnePictureOnly) {
  const GraphicsSystem g = triangle();
  EXPECT_EQ(within(150 * kMegabyte,
                   [&] {
                     Renderer renderer;
                     return error_of([&] {
                       for (const int samples : {1, 1, 2})
                         renderer.draw(g, {.width = 5000, .height = 5000, .samples = samples});
                     });
                   }),
            "");
}

TEST(OutOfMemory, OfManyPolygonsLeavesTheStateAsItWas) {
  const std::vector<Point3> vertices{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  std::vector<std::uint32_t> corners(12000000);
  for (std::size_t k = 0; k < corners.size(); ++k) corners[k] = static_cast<std::uint32_t>(k % 3);
  GraphicsSystem g = triangle();
  g.open_segment(2);
  g.polygon_abs_3({{-1, -1, 0.5}, {1, -1, 0}, {0, 1, 0}});
  const std::string before = dump(g.display_file());
  EXPECT_EQ(
      within(200 * kMegabyte,
             [&] {
               const std::string error = error_of([&] { g.polygons_abs_3({vertices, corners}); });
               if (dump(g.display_file()) != before) return std::string("another state");
               g.polygons_abs_3({vertices, std::span(corners).first(6)});
               g.close_segment();
               return error + ", then " + std::to_string(g.counts().polygons);
             }),
      "out of memory: entering 4000000 polygons of 12000000 corners needs at least 336000072 "
      "bytes, and the limit is L, then 4");
}

TEST(OutOfMemory, OfASortLeavesTheSegmentOpen) {
  const std::vector<Point3> vertices{{-1, -1, 0}, {1, -1, 0.1}, {0, 1, 0}};
  std::vector<std::uint32_t> corners(3000000);
  for (std::size_t k = 0; k < corners.size(); ++k) corners[k] = static_cast<std::uint32_t>(k % 3);
  GraphicsSystem g;
  g.set_hidden_surfaces({.removal = true});
  g.set_hidden_surfaces({.method = HiddenMethod::bsp});
  g.open_segment(2);
  g.polygons_abs_3({vertices, corners});
  for (const std::size_t more : {10 * kMegabyte, 120 * kMegabyte}) {
    const std::string found = within(more, [&] {
      const std::string error = error_of([&] { g.close_segment(); });
      if (g.open_segment_name() != 2) return std::string("not open");
      g.set_hidden_surfaces({.removal = false});
      g.close_segment();
      return error;
    });
    EXPECT_TRUE(
        found.starts_with("out of memory: sorting 3000000 points by bsp: L bytes are not enough: "
                          "expected a higher limit of memory"))
        << found;
  }
}

/// A stream that drops text when memory runs out would return the rest: a picture or a dump that is
/// cut short.
TEST(OutOfMemory, NothingThatIsCollectedInMemoryIsCutShort) {
  GraphicsSystem g;
  g.open_segment(1);
  g.move_abs_3(0, 0, 0);
  for (int k = 0; k < 100; ++k) g.text(std::string(65000, '&'));
  g.close_segment();
  DrawOptions on_paper{.width = 100, .height = 100};
  on_paper.vectors.paper = Paper{};
  const auto outcome = [](const std::string& whole, const std::function<std::string()>& made) {
    try {
      return std::string(made() == whole ? "whole" : "cut short");
    } catch (const std::bad_alloc&) {
      return std::string("out of memory");
    } catch (const Error& error) {
      const std::string message = error.what();
      return message.starts_with("out of memory: ") ? "out of memory" : message;
    }
  };
  const std::function<std::string()> makes[] = {
      [&] { return dump(g.display_file()); },
      [&] { return draw_as(g, "svg", {.width = 100, .height = 100}); },
      [&] { return draw_as(g, "svg", on_paper); },
  };
  for (const auto& make : makes) {
    const std::string whole = make();
    int short_of_memory = 0;
    for (const std::size_t more : {5u, 10u, 20u, 40u, 60u, 80u, 100u, 150u}) {
      const std::string found = within(more * kMegabyte, [&] { return outcome(whole, make); });
      short_of_memory += found == "out of memory" ? 1 : 0;
      EXPECT_TRUE(found == "whole" || found == "out of memory")
          << found << " of " << whole.size() << " with " << more;
    }
    EXPECT_GT(short_of_memory, 0);
  }
}

}  // namespace
}  // namespace displayfile
