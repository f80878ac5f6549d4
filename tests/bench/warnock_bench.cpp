// Warnock's area subdivision: areas visited, and its time over the z-buffer's, by both its ends, on
// one thread: again, and with prepare().

#include "interp/visibility/plain_warnock.h"
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
  struct Areas : PlainWarnock::Unobserved {
    double areas = 0.0, listed = 0.0;
    void visit(const PlainWarnock::Visit& visit) {
      areas += 1.0;
      listed += static_cast<double>(visit.list.size());
    }
  } counted;
  PlainWarnock plain;
  prepare(plain);
  plain.draw_rows(
      0, options.size, [](int, int, std::span<const ViewedScene::Fill>) {}, counted);
  print_row({{"table", "areas of the plain form"},
             {"scene", name},
             {"polygons", scene.end() - 1},
             {"areas a pixel", figure(counted.areas / options.size / options.size)},
             {"polygons an area", figure(counted.listed / counted.areas)}});
  Warnock early;
  prepare(early);
  for (const auto& [warnock, name_of_form] :
       {std::pair<ImageSpaceMethod*, const char*>{&plain, "plain"},
        std::pair<ImageSpaceMethod*, const char*>{&early, "early"}}) {
    const Spread again = times_faster(
        options.rounds, [&] { draw(z_buffer); }, [&, form = warnock] { draw(*form); });
    const Spread anew = times_faster(
        options.rounds, [&] { draw_anew(z_buffer); }, [&, form = warnock] { draw_anew(*form); });
    print_row({{"table", "of the z-buffer's time"},
               {"scene", name},
               {"polygons", scene.end() - 1},
               {"form", name_of_form},
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
