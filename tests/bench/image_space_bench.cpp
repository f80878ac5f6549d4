// The image-space methods side by side, 1024 x 1024:
//   image_space_bench [--large] [--rounds N] [--threads N] [--only METHOD,...] [MESH...]
// Prints ratios and counts; run it on a machine that does nothing else. Each method is timed in
// turn with what it is held against: OSMesa where the build has it, and the plain z-buffer (depth
// as double), drawing the same display file with all that can be kept from picture to picture
// kept; "first picture" keeps nothing. Ray casting is also held against Embree's rays. "deep": how
// many polygons cover a pixel; "wide": how many pixels of a row a polygon covers. All on so many
// threads, OSMesa by LP_NUM_THREADS (0: in the calling thread). The same view and no culling on
// either side; OSMesa's vertices shared, indexed and resident, glFinish, nothing read back.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "displayfile/mesh/mesh.h"
#include "interp/device/raster_request.h"
#include "interp/opengl/osmesa.h"
#include "interp/raster/fill_paints.h"
#include "interp/raster/software.h"
#include "interp/scan/scan_convert.h"
#include "interp/visibility/image_space.h"
#include "interp/visibility/plain_z_buffer.h"
#include "interp/visibility/z_buffer.h"
#include "programs/bench/beside_embree.h"
#include "programs/bench/growth.h"
#include "programs/bench/indexed_triangles.h"
#include "programs/bench/opengl_mesh.h"
#include "programs/bench/side_by_side.h"
#include "programs/scenes/generated_scenes.h"
#include "programs/scenes/random.h"
#include "programs/scenes/shapes.h"
#include "tests/bench/result_table.h"

namespace displayfile::bench {
namespace {

constexpr int kSide = 1024;
constexpr std::uint64_t kSeed = 1;

struct Options {
  std::vector<std::string> meshes, only;
  bool large = false;
  int rounds = 5, threads = 1;
};

RasterRequest request(HiddenMethod method, int threads) {
  RasterRequest r;
  r.threads = threads;
  r.width = r.height = kSide;
  r.method = method;
  return r;
}

/// Draws a display file again and again.
using Draw = std::function<void()>;

struct Drawer {
  std::string name;
  std::function<Draw(const DisplayFile&)> made_ready;
};

Drawer plain_z_buffer() {
  return {"plain z-buffer", [](const DisplayFile& file) {
            return [&file] {
              draw_with_plain_z_buffer(file, request(HiddenMethod::z_buffer, 1),
                                       DepthFormat::float_64);
            };
          }};
}

Drawer image_space(HiddenMethod method, int threads) {
  return {std::string(name_of(method)), [=](const DisplayFile& file) {
            return [=, &file, renderer = std::make_shared<SoftwareRenderer>()] {
              renderer->draw(file, request(method, threads));
            };
          }};
}

/// Nothing is kept from one picture to the next.
Drawer first_picture(int threads) {
  return {"z-buffer, first picture", [=](const DisplayFile& file) {
            return [=, &file] {
              SoftwareRenderer().draw(file, request(HiddenMethod::z_buffer, threads));
            };
          }};
}

/// Vertices that triangles share, resident.
Drawer osmesa() {
  return {"OSMesa", [](const DisplayFile& file) {
            struct Kept {
              explicit Kept(const DisplayFile& of)
                  : triangles(indexed_triangles(ViewedScene(of))),
                    mesh(triangles, {PictureSize{kSide, kSide}}) {
                mesh.set_matrix(glm::dmat4(1.0));
                mesh.make_resident();
              }
              IndexedTriangles triangles;
              OpenGlMesh mesh;
            };
            return [kept = std::make_shared<Kept>(file)] { kept->mesh.draw(); };
          }};
}

std::vector<Drawer> drawers(const Options& options) {
  std::vector<Drawer> all{plain_z_buffer(), first_picture(options.threads)};
  for (const ImageSpaceEntry& entry : image_space_methods()) {
    const std::string name(name_of(entry.method));
    if (options.only.empty() || std::ranges::count(options.only, name) > 0) {
      all.push_back(image_space(entry.method, options.threads));
    }
  }
  return all;
}

/// Averages over the pixels that polygons cover: how many polygons cover one, and how many pixels a
/// polygon covers in a row.
struct Cover {
  double deep, wide;
};
Cover cover(const DisplayFile& file) {
  const ViewedScene scene(file);
  std::vector<bool> covered(std::size_t{kSide} * kSide);
  double pixels = 0.0, runs = 0.0;
  ScanConverter converter;
  for (ViewedScene::Fill fill = 1; fill < scene.end(); ++fill) {
    converter.scan_convert(scene.vertices(fill), {{kSide, kSide}, 0, kSide},
                           [&](int row, int first, int end) {
                             pixels += end - first;
                             runs += 1.0;
                             for (int i = first; i < end; ++i) {
                               covered[static_cast<std::size_t>(row * kSide + i)] = true;
                             }
                           });
  }
  const auto seen = static_cast<double>(std::ranges::count(covered, true));
  return {pixels / std::max(1.0, seen), pixels / std::max(1.0, runs)};
}

std::string text_of(const Spread& faster) {
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", faster.median, faster.least, faster.greatest);
}

struct NamedSystem {
  std::string name;
  GraphicsSystem system;
};

/// One row a scene, one column a method: how many times as fast it is as the other.
void print_times_faster(const std::vector<Drawer>& all, const Drawer& other,
                        const std::vector<std::function<NamedSystem()>>& scenes, int rounds) {
  std::vector<std::string> heads{"scene", "polygons", "deep", "wide"};
  for (const Drawer& drawer : all) {
    if (drawer.name != other.name) heads.push_back(drawer.name);
  }
  std::vector<std::vector<std::string>> rows;
  for (const auto& make : scenes) {
    const NamedSystem scene = make();
    const DisplayFile& file = scene.system.display_file();
    const Cover covers = cover(file);
    std::vector<std::string> row{scene.name, fmt::format("{}", file.polygons()),
                                 fmt::format("{:.1f}", covers.deep),
                                 fmt::format("{:.1f}", covers.wide)};
    const Draw beside = other.made_ready(file);
    for (const Drawer& drawer : all) {
      if (drawer.name == other.name) continue;
      row.push_back(text_of(times_faster(rounds, drawer.made_ready(file), beside)));
    }
    rows.push_back(std::move(row));
  }
  fmt::print("Times as fast as {}, 1024 x 1024 (least to greatest of {} rounds)\n\n{}\n",
             other.name, rounds, text_table(heads, rows));
}

/// Parallel sheets, each most of the picture, in random order: k of them cover a pixel.
Scene stack(std::size_t k) {
  Random random(kSeed);
  std::vector<Polygon> sheets;
  for (std::size_t i = 0; i < k; ++i) {
    const double z = (static_cast<double>(i) + 0.5) / static_cast<double>(k);
    sheets.push_back(random_regular(random, 4, {0.4, 0.6}, {0.5, 0.7}, {0.8 * z, 0.1, 0.05}));
  }
  random.shuffle(sheets);
  Scene scene;
  scene.add(sheets);
  return scene;
}

std::vector<std::function<NamedSystem()>> scenes(const Options& options) {
  std::vector<std::function<NamedSystem()>> all;
  for (const char* name : {"city", "soup", "terrain"}) {
    for (const std::size_t n : {10'000u, 100'000u, 1'000'000u}) {
      if (n > 100'000 && !options.large) continue;
      all.push_back([=] {
        return NamedSystem{name, entered(generated_scene(name).make(n, kSeed))};
      });
    }
  }
  for (const std::string& path : options.meshes) {
    all.push_back([=] {
      NamedSystem mesh{path.substr(path.rfind('/') + 1), GraphicsSystem()};
      import_mesh(path, mesh.system);
      return mesh;
    });
  }
  return all;
}

std::vector<std::function<NamedSystem()>> deep_scenes() {
  std::vector<std::function<NamedSystem()>> all;
  for (const std::size_t k : {1u, 4u, 16u, 64u, 256u}) {
    all.push_back([=] { return NamedSystem{"stack", entered(stack(k))}; });
  }
  for (const std::size_t k : {4u, 16u, 64u, 256u}) {
    all.push_back([=] {
      return NamedSystem{"planes", entered(generated_scene("planes").make(k, kSeed))};
    });
  }
  return all;
}

/// What deciding exactly costs the fast z-buffer, of which pixels without colours are timed; and
/// how ray casting stands beside Embree.
void print_exact_and_rays(const std::vector<std::function<NamedSystem()>>& scenes,
                          const Options& options) {
  std::vector<std::string> heads{"scene", "polygons", "exact z-buffer: time over rounded"};
  if (EmbreeRays::version()) heads.insert(heads.end(), {"rays: times as fast as Embree", "hit"});
  std::vector<std::vector<std::string>> rows;
  for (const auto& make : scenes) {
    const NamedSystem named = make();
    const ViewedScene scene(named.system.display_file());
    ZBuffer exact, rounded(ZBuffer::Decided::in_single_precision);
    for (ZBuffer* method : {&exact, &rounded}) {
      method->prepare({scene, {kSide, kSide}, std::nullopt}, 1);
    }
    const FillPaints paints(scene);
    std::vector<std::uint32_t> pixels(std::size_t{kSide} * kSide);
    const auto draw = [&](const ZBuffer& method) {
      return [&] {
        method.draw_rows(0, kSide, [&](int row, int first, std::span<const ViewedScene::Fill> run) {
          std::uint32_t* const to = pixels.data() + row * kSide + first;
          for (std::size_t i = 0; i < run.size(); ++i) to[i] = paints.pixel(run[i]);
        });
      };
    };
    std::vector<std::string> row{named.name, fmt::format("{}", scene.end() - 1),
                                 text_of(times_faster(options.rounds, draw(rounded), draw(exact)))};
    if (EmbreeRays::version()) {
      const DisplayFile cut = display_file_of(in_triangles(scene));
      const BesideEmbree beside =
          cast_beside_embree(ViewedScene(cut), kSide, options.threads, EmbreeRays::Quality::high,
                             {.rounds = options.rounds});
      row.push_back(text_of(beside.rays));
      row.push_back(fmt::format("{:.0f} %", 100.0 * beside.hit));
    }
    rows.push_back(std::move(row));
  }
  fmt::print("{}\n", text_table(heads, rows));
}

/// The exponent e of the time, as of n^e.
void print_growth(const std::vector<Drawer>& all, const Options& options) {
  std::vector<std::string> heads{"scene"};
  for (const Drawer& drawer : all) heads.push_back(drawer.name);
  std::vector<std::vector<std::string>> rows;
  const int high = options.large ? 6 : 5;
  for (const char* name : {"city", "soup", "terrain"}) {
    std::vector<double> sizes;
    std::vector<std::vector<double>> costs(all.size());
    for (const std::size_t n : sizes_of_growth(3, high)) {
      const GraphicsSystem system = entered(generated_scene(name).make(n, kSeed));
      sizes.push_back(static_cast<double>(system.display_file().polygons()));
      for (std::size_t k = 0; k < all.size(); ++k) {
        const Draw draw = all[k].made_ready(system.display_file());
        draw();
        std::vector<double> times;
        for (int i = 0; i < options.rounds; ++i) times.push_back(seconds(draw));
        costs[k].push_back(spread(times).median);
      }
    }
    std::vector<std::string> row{name};
    for (const auto& cost : costs)
      row.push_back(fmt::format("{:.2f}", fitted_exponent(sizes, cost)));
    rows.push_back(std::move(row));
  }
  fmt::print(
      "Growth of the time with the polygons' number from 10^3 to 10^{}: the exponent\n\n{}\n", high,
      text_table(heads, rows));
}

void run(const Options& options) {
  std::vector<Drawer> all = drawers(options);
  if (osmesa_available()) {
    fmt::print("{}\n\n", osmesa_description());
    print_times_faster(all, osmesa(), scenes(options), options.rounds);
  }
  print_times_faster(all, plain_z_buffer(), scenes(options), options.rounds);
  print_times_faster(all, plain_z_buffer(), deep_scenes(), options.rounds);
  if (osmesa_available()) all.push_back(osmesa());
  print_exact_and_rays(scenes(options), options);
  print_growth(all, options);
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  displayfile::bench::Options options;
  CLI::App app("The image-space methods side by side");
  app.add_option("mesh", options.meshes, "meshes, in any format that the command reads")
      ->check(CLI::ExistingFile);
  app.add_option("--only", options.only, "of the listed methods only these")->delimiter(',');
  app.add_flag("--large", options.large, "also 10^6 polygons");
  app.add_option("--rounds", options.rounds, "of each comparison")->check(CLI::Range(1, 1000));
  app.add_option("--threads", options.threads, "of both sides")->check(CLI::Range(1, 64));
  CLI11_PARSE(app, argc, argv);
  setenv("LP_NUM_THREADS", std::to_string(options.threads > 1 ? options.threads : 0).c_str(), 1);
  displayfile::bench::run(options);
}
