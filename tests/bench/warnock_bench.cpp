// Warnock's area subdivision: areas visited, and its time against the z-buffer's, side by side on
// one thread at 1024 x 1024. Prints ratios and counts; run it on a machine that does nothing else.
//   warnock_bench [ROUNDS [SCENE POLYGONS]...]

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "interp/visibility/warnock.h"
#include "interp/visibility/z_buffer.h"
#include "programs/bench/side_by_side.h"
#include "programs/scenes/generated_scenes.h"

namespace displayfile::bench {
namespace {

constexpr PictureSize kSize{1024, 1024};

void draw(const ImageSpaceMethod& method) {
  method.draw_rows(0, kSize.height, [](int, int, std::span<const ViewedScene::Fill>) {});
}

/// Takes up the scene and draws it.
void draw_anew(ImageSpaceMethod& method, const ViewedScene& scene) {
  method.prepare({scene, kSize, {}}, 1);
  draw(method);
}

struct Areas {
  std::size_t visited = 0, listed = 0;
};
Areas areas_of(const Warnock& warnock) {
  Areas areas;
  warnock.draw_rows(
      0, kSize.height, [](int, int, std::span<const ViewedScene::Fill>) {},
      Warnock::Observer{.visit = [&](const Warnock::Visit& visit) {
        ++areas.visited;
        areas.listed += visit.list.size();
      }});
  return areas;
}

/// Warnock's time over the other's, drawing again and with prepare().
std::string ratios(ImageSpaceMethod& other, ImageSpaceMethod& warnock, const ViewedScene& scene,
                   int rounds) {
  draw_anew(other, scene);
  draw_anew(warnock, scene);
  const Spread again = times_faster(
      rounds, [&] { draw(other); }, [&] { draw(warnock); });
  const Spread anew = times_faster(
      rounds, [&] { draw_anew(other, scene); }, [&] { draw_anew(warnock, scene); });
  return fmt::format("{:>6.2f} ({:.2f} to {:.2f}), with prepare() {:>6.2f} ({:.2f} to {:.2f})",
                     again.median, again.least, again.greatest, anew.median, anew.least,
                     anew.greatest);
}

void measure(const std::string& name, std::size_t polygons, int rounds) {
  const GraphicsSystem system = entered(generated_scene(name).make(polygons, 1));
  const ViewedScene scene(system.display_file());
  ZBuffer z_buffer;
  fmt::print("{}, {} polygons\n", name, scene.end() - 1);
  for (const auto& [finish, form] :
       {std::pair{Warnock::Finish::at_pixels, "at pixels"}, {Warnock::Finish::early, "early"}}) {
    Warnock warnock(finish);
    warnock.prepare({scene, kSize, {}}, 1);
    const Areas areas = areas_of(warnock);
    const auto visited = static_cast<double>(areas.visited);
    fmt::print(
        "  {:<9}: {:>8.5f} areas a pixel, {:>7.2f} polygons an area\n"
        "             of the z-buffer's time {}\n",
        form, visited / (1024.0 * 1024.0), static_cast<double>(areas.listed) / visited,
        ratios(z_buffer, warnock, scene, rounds));
  }
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 7;
  std::vector<std::pair<std::string, std::size_t>> scenes;
  for (int i = 2; i + 1 < argc; i += 2) {
    scenes.emplace_back(argv[i], static_cast<std::size_t>(std::atoll(argv[i + 1])));
  }
  if (scenes.empty()) {
    scenes = {{"planes", 30},      {"planes", 300},      {"soup", 1'000},
              {"soup", 10'000},    {"city", 10'000},     {"village", 10'000},
              {"terrain", 10'000}, {"terrain", 200'000}, {"needles", 10'000}};
  }
  for (const auto& [name, polygons] : scenes) {
    displayfile::bench::measure(name, polygons, rounds);
  }
}
