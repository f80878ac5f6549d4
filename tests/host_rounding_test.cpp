#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <ios>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/mesh/fitted_view.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/views/retained_views.h"
#include "interp/device/output_device.h"
#include "interp/draw/draw.h"
#include "interp/draw/turntable_renderer.h"
#include "tests/from_eyes.h"
#include "tests/random_application.h"
#include "tests/slower.h"

// A host may have set another rounding mode for its own numbers: it changes nothing here, and it is
// the host's again after each call.

namespace displayfile {
namespace {

using test::FromEyes;

constexpr std::array kOtherModes{FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

/// While it lives, the host rounds so.
class HostRounds {
 public:
  explicit HostRounds(int mode) : mode_(mode) { std::fesetround(mode); }
  ~HostRounds() {
    EXPECT_EQ(std::fegetround(), mode_) << "the mode is not the host's any more";
    std::fesetround(FE_TONEAREST);
  }
  HostRounds(const HostRounds&) = delete;
  HostRounds& operator=(const HostRounds&) = delete;

 private:
  const int mode_;
};

std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::filesystem::path> gallery() {
  std::vector<std::filesystem::path> programs;
  for (const auto& entry :
       std::filesystem::directory_iterator(DISPLAYFILE_SOURCE_DIR "/programs")) {
    if (entry.path().extension() == ".draw") programs.push_back(entry.path());
  }
  std::ranges::sort(programs);
  return programs;
}

/// The result of a call, or the message of its error.
template <class Call>
std::string result_of(const Call& call) {
  try {
    return call();
  } catch (const Error& e) {
    return std::string("error: ") + e.what();
  }
}

DrawOptions options_with(HiddenMethod method, int samples = 1) {
  DrawOptions options{.samples = 1};
  options.width = options.height = 96;
  options.surfaces.method = method;
  options.samples = samples;
  options.surfaces.threads = 3;
  return options;
}

/// The results of a program: its display file, and pictures of it in pixels, vectors and lines.
std::vector<std::string> all_of(const std::string& program) {
  GraphicsSystem system;
  replay(program, "program", system);
  std::vector<std::string> all{dump(system.display_file())};
  const auto draws = [&](std::string_view format, const DrawOptions& options) {
    all.push_back(result_of([&] { return draw_as(system, format, options); }));
  };
  draws("ppm", options_with(HiddenMethod::automatic));
  draws("ppm", options_with(HiddenMethod::scan_line, 3));
  draws("svg", options_with(HiddenMethod::map));
  draws("svg", options_with(HiddenMethod::bsp));
  draws("svg", options_with(HiddenMethod::franklin));
  return all;
}

TEST(HostRounding, ChangesNothingOfTheGallery) {
  const std::vector<std::filesystem::path> programs = gallery();
  ASSERT_GT(programs.size(), 20u);
  std::size_t bytes = 0;
  for (std::size_t number = 0; number < programs.size(); number += test::kSlower) {
    const std::filesystem::path& file = programs[number];
    SCOPED_TRACE(file.filename());
    const std::string program = contents(file);
    const std::vector<std::string> expected = all_of(program);
    for (const std::string& each : expected) bytes += each.size();
    for (const int mode : kOtherModes) {
      SCOPED_TRACE(mode);
      std::vector<std::string> made;
      {
        const HostRounds host(mode);
        made = all_of(program);
      }
      ASSERT_EQ(made.size(), expected.size());
      for (std::size_t k = 0; k < made.size(); ++k) {
        EXPECT_TRUE(made[k] == expected[k]) << "output " << k;
      }
    }
  }
  EXPECT_GT(bytes, 1000000u / test::kSlower);
}

/// The first line of two texts that differs.
std::string difference(const std::string& a, const std::string& b) {
  std::istringstream first(a), second(b);
  std::string line, other;
  while (std::getline(first, line) && std::getline(second, other)) {
    if (line != other) return line + "\n" + other;
  }
  return "one is longer";
}

/// Whatever routine is called, and whether it is refused.
TEST(HostRounding, ChangesNoRoutine) {
  constexpr int kApplications = 60 / test::kSlower, kCalls = 250;
  int refused = 0;
  for (int seed = 0; seed < kApplications; ++seed) {
    const auto run = [&](int mode) {
      std::ostringstream recording;
      Recorder recorder(recording);
      GraphicsSystem system;
      system.set_recorder(&recorder);
      test::RandomApplication application(std::mt19937_64(static_cast<std::uint64_t>(seed)),
                                          system);
      for (int i = 0; i < kCalls; ++i) {
        // The application's own numbers are unchanged.
        const HostRounds host(mode);
        application.call();
      }
      if (system.open_segment_name()) {
        const HostRounds host(mode);
        system.close_segment();
      }
      refused += application.refused();
      return recording.str() + dump(system.display_file());
    };
    const std::string expected = run(FE_TONEAREST);
    for (const int mode : kOtherModes) {
      const std::string made = run(mode);
      ASSERT_TRUE(made == expected) << "seed " << seed << ", mode " << mode << "\n"
                                    << difference(made, expected);
    }
  }
  EXPECT_GT(refused, 100 / test::kSlower);
}

/// Retained scenes: other eyes, turntables, trees in world coordinates.
TEST(HostRounding, ChangesNoOtherView) {
  const std::string program = contents(DISPLAYFILE_SOURCE_DIR "/programs/lit-mesh.draw");
  GraphicsSystem as_drawn;
  replay(program, "program", as_drawn);
  View view = as_drawn.view();
  view.set_plane_normal(view.plane_normal + Point3(0.1, 0.2, 0.3));
  const auto run = [&] {
    std::vector<std::string> all;
    RetainedScene scene;
    GraphicsSystem system;
    system.retain(&scene);
    replay(program, "program", system);
    const auto keep = [&](const Picture& picture) {
      all.emplace_back(reinterpret_cast<const char*>(picture.pixels.data()),
                       picture.pixels.size() * sizeof picture.pixels[0]);
    };
    for (const HiddenMethod method :
         {HiddenMethod::z_buffer, HiddenMethod::bsp, HiddenMethod::world_ray_cast}) {
      TurntableRenderer renderer(system, scene, system.display_file(), {.number = 5},
                                 options_with(method));
      keep(renderer.draw(2));
    }
    FromEyes renderer(scene, system.display_file());
    keep(renderer.draw(view, options_with(HiddenMethod::z_buffer)));
    all.push_back(dump(renderer.display_file(view)));
    RetainedViews trees(scene, system.display_file(), {});
    all.push_back(dump(trees.view(view)));
    return all;
  };
  const std::vector<std::string> expected = run();
  for (const int mode : kOtherModes) {
    SCOPED_TRACE(mode);
    std::vector<std::string> made;
    {
      const HostRounds host(mode);
      made = run();
    }
    EXPECT_TRUE(made == expected);
  }
}

}  // namespace
}  // namespace displayfile
