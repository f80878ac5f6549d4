// Warnock's area subdivision: areas visited, and its time over the z-buffer's, by both its ends, on
// one thread: again, and with prepare().

#include "interp/visibility/warnock.h"
#include "interp/visibility/z_buffer.h"
#include "programs/scenes/generated_scenes.h"
#include "tests/bench/benchmark.h"

namespace displayfile::bench {

const char* const kAbout = "Warnock's area subdivision: areas, and time over the z-buffer's";

namespace {

void measure(const std::string& name, std::size_t polygons, const Options& options) {
  const GraphicsSystem system = entered(generated_scene(name).make(polygons, 1));
  const ViewedScene scene(system.display_file());
  const auto draw = [&](const ImageSpaceMethod& method) {
    method.draw_rows(0, options.size, [](int, int, std::span<const ViewedScene::Fill>) {});
  };
  const auto prepare = [&](ImageSpaceMethod& method) {
    method.prepare({scene, {options.size, options.size}, {}}, 1);
  };
  const auto draw_anew = [&](ImageSpaceMethod& method) {
    prepare(method);
    draw(method);
  };
  ZBuffer z_buffer;
  prepare(z_buffer);
  for (const auto& [finish, form] :
       {std::pair{Warnock::Finish::at_pixels, "at pixels"}, {Warnock::Finish::early, "early"}}) {
    Warnock warnock(finish);
    prepare(warnock);
    double areas = 0.0, listed = 0.0;
    warnock.draw_rows(
        0, options.size, [](int, int, std::span<const ViewedScene::Fill>) {},
        Warnock::Observer{.visit = [&](const Warnock::Visit& visit) {
          areas += 1.0;
          listed += static_cast<double>(visit.list.size());
        }});
    const Spread again = times_faster(
        options.rounds, [&] { draw(z_buffer); }, [&] { draw(warnock); });
    const Spread anew = times_faster(
        options.rounds, [&] { draw_anew(z_buffer); }, [&] { draw_anew(warnock); });
    print_row({{"table", "of the z-buffer's time"},
               {"scene", name},
               {"polygons", scene.end() - 1},
               {"ends", form},
               {"areas a pixel", figure(areas / options.size / options.size)},
               {"polygons an area", figure(listed / areas)},
               {"again", figures(again)},
               {"with prepare()", figures(anew)}});
  }
}

}  // namespace

void run(const Options& options) {
  for (const std::string& name : options.scenes) measure(name, options.polygons, options);
  if (!options.scenes.empty()) return;
  for (const auto& [name, polygons] : {std::pair{"planes", 30},
                                       {"planes", 300},
                                       {"soup", 1'000},
                                       {"soup", 10'000},
                                       {"city", 10'000},
                                       {"village", 10'000},
                                       {"terrain", 10'000},
                                       {"terrain", 200'000},
                                       {"needles", 10'000}}) {
    measure(name, static_cast<std::size_t>(polygons), options);
  }
}

}  // namespace displayfile::bench
