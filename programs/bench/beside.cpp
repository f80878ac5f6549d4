#include "programs/bench/beside.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <utility>

#include "hidden/map/map_pieces.h"
#include "hidden/sort/hidden_surface_sort.h"
#include "interp/draw/renderer.h"
#include "interp/opengl/osmesa.h"
#include "interp/visibility/image_space.h"
#include "interp/visibility/z_buffer.h"
#include "programs/bench/application_mesh.h"
#include "programs/bench/beside_embree.h"
#include "programs/bench/contenders.h"
#include "programs/bench/embree_rays.h"
#include "programs/bench/find_seen.h"
#include "programs/bench/gl2ps_sort.h"
#include "programs/bench/indexed_triangles.h"
#include "programs/bench/moving_camera.h"
#include "programs/bench/opengl_mesh.h"
#include "programs/bench/process.h"
#include "programs/scenes/scene.h"

namespace displayfile::bench {

using namespace beside;

namespace {

using Fill = ViewedScene::Fill;

PictureSize size_of(const BenchScene& scene) { return {scene.size, scene.size}; }

/// Collects what is found of one task.
class Comparison {
 public:
  explicit Comparison(const BesideTask& task) : task_(task) {}

  const BesideTask& task() const { return task_; }
  void add_ratio(const std::string& other, const std::string& what, const Spread& times_faster) {
    add(other, what).times_faster = figures(times_faster);
  }
  /// In turn; how many times as fast ours is.
  void time(const std::string& other, const std::string& what, const auto& ours,
            const auto& others) {
    add_ratio(other, what, warm_ratio(task_.effort, task_.threads, others, ours));
  }
  void count(const std::string& other, const std::string& what, double value) {
    add(other, what).count = value == std::floor(value) ? value : figure(value);
  }
  void leave_out(const std::string& other, const std::string& what, const std::string& why) {
    add(other, what).left_out = why;
  }
  Beside& add(const std::string& other, const std::string& what) {
    found.push_back({task_.scene.id(), task_.threads, other, what});
    return found.back();
  }

  std::vector<Beside> found;

 private:
  const BesideTask& task_;
};

// ---- OSMesa ----------------------------------------------------------------------------

DrawOptions by_z_buffer(const BesideTask& task) {
  DrawOptions options;
  options.width = options.height = task.scene.size;
  options.threads = task.threads;
  options.hidden = HiddenMethod::z_buffer;
  return options;
}

void compare_start_up(Comparison& comparison) {
  const BesideTask& task = comparison.task();
  const std::vector<Point3> triangle{{0.25, 0.25, 0.0}, {0.75, 0.25, 0.0}, {0.5, 0.75, 0.0}};
  const auto indexed = indexed_triangles(triangle, std::vector<std::uint32_t>{0xFF0000FF});
  comparison.time(
      kOsmesa, kStartUp,
      [&] {
        GraphicsSystem system;
        system.set_line_style({LineStyle::Kind::none});
        system.open_segment(1);
        system.polygon_abs_3(triangle);
        system.close_segment();
        draw(system, by_z_buffer(task));
      },
      [&] {
        OpenGlMesh mesh(indexed, {size_of(task.scene)});
        mesh.set_matrix(glm::dmat4(1.0));
        mesh.draw_with_new_vertices();
      });
}

void compare_with_osmesa(Comparison& comparison) {
  compare_start_up(comparison);
  const BesideTask& task = comparison.task();
  ApplicationMesh mesh;
  try {
    mesh = application_mesh(task.scene);
  } catch (const CannotDraw& reason) {
    for (const char* what : {kNewVertices, kAgain}) {
      comparison.leave_out(kOsmesa, what, reason.why);
    }
    return;
  }
  const IndexedTriangles indexed = indexed_triangles(mesh);
  OpenGlMesh opengl(indexed,
                    {size_of(task.scene), 24, mesh.back_faces_removed, pixel_of(Background{})});
  opengl.set_matrix(opengl_matrix(mesh.views.front(), mesh));

  GraphicsSystem system;
  system.set_threads(task.threads);
  set_view(mesh.views.front(), system);
  Renderer renderer;
  const DrawOptions options = by_z_buffer(task);
  comparison.time(
      kOsmesa, kNewVertices,
      [&] {
        enter(mesh, system);
        renderer.draw(system, options);
      },
      [&] { opengl.draw_with_new_vertices(); });
  opengl.make_resident();
  comparison.time(
      kOsmesa, kAgain, [&] { renderer.draw(system, options); }, [&] { opengl.draw(); });
}

// ---- A moving camera -------------------------------------------------------------------

void compare_new_views(Comparison& comparison) {
  const BesideTask& task = comparison.task();
  try {
    const MovingCamera found =
        move_camera(task.scene, task.first_polygons, task.threads, task.effort);
    comparison.count(kOsmesa, kTriangles, static_cast<double>(found.triangles));
    comparison.count(kTruth, kViews, found.views);
    comparison.count(kTruth, kWrongPixels, static_cast<double>(found.wrong_pixels));
    comparison.count(kMemory, kRetainedScene, found.scene_bytes);
    comparison.count(kMemory, kView, found.view_bytes);
    comparison.count(kMemory, kDrawing, found.drawing_bytes);
    if (found.beside_first) comparison.add_ratio(kFewestPolygons, kNewViews, *found.beside_first);
    if (!found.beside_osmesa) return;
    comparison.add_ratio(kOsmesa, kNewViews, *found.beside_osmesa);
    comparison.count(kOsmesa, kOtherPixels, found.other_pixels);
  } catch (const CannotDraw& reason) {
    comparison.leave_out(kOsmesa, kNewViews, reason.why);
  }
}

// ---- Embree ----------------------------------------------------------------------------

void compare_with_embree(Comparison& comparison) {
  const BesideTask& task = comparison.task();
  const DisplayFile file = display_file_of(in_triangles(ViewedScene(task.scene.make())));
  const ViewedScene triangles(file);
  for (const auto quality : {EmbreeRays::Quality::moderate, EmbreeRays::Quality::high}) {
    const char* const name = quality == EmbreeRays::Quality::high ? kEmbreeHigh : kEmbree;
    const BesideEmbree found =
        cast_beside_embree(triangles, task.scene.size, task.threads, quality, task.effort);
    comparison.add_ratio(name, kRays, found.rays);
    comparison.add_ratio(name, kBuilding, found.building);
  }
  comparison.count(kEmbree, kPacket, EmbreeRays::packet_width());
}

// ---- gl2ps -----------------------------------------------------------------------------

/// From the polygons to the points of their pieces, exact, on one thread.
SortedPieces pieces_by(HiddenMethod method, const Primitives& polygons) {
  if (method == HiddenMethod::map) return pieces_of_map(polygons, visible_map(polygons, {}));
  return sort_hidden_surfaces(polygons, method, SortOptions{});
}

void compare_with_gl2ps(Comparison& comparison) {
  const BesideTask& task = comparison.task();
  const DisplayFile file = display_file_of(in_triangles(ViewedScene(task.scene.make())));
  const ViewedScene scene(file);
  const Triangles triangles = in_triangles(scene);
  const auto count = static_cast<double>(std::max<std::size_t>(1, triangles.size()));
  const auto left_out = [&](HiddenMethod method) {
    return task.left_out.contains(std::string(name_of(method)));
  };
  comparison.count(kGl2ps, kTriangles, static_cast<double>(triangles.size()));
  for (const HiddenMethod method : kObjectSpaceMethods) {
    const std::string name(name_of(method));
    if (left_out(method)) {
      comparison.leave_out(name, kPieces, task.left_out.at(name));
      continue;
    }
    const SortedPieces found = pieces_by(method, scene.primitives());
    comparison.count(name, kPieces, static_cast<double>(found.pieces.size()) / count);
  }
  for (const bool best_root : {false, true}) {
    const char* const name = best_root ? kGl2psBestRoot : kGl2ps;
    const Gl2psSort gl2ps{triangles.corners, size_of(task.scene), best_root};
    if (!gl2ps.ends()) {
      const char* const why = "gl2ps's sort does not come to an end";
      comparison.leave_out(name, kPieces, why);
      for (const HiddenMethod method : kObjectSpaceMethods) {
        comparison.leave_out(name, std::string(name_of(method)), why);
      }
      continue;
    }
    comparison.count(name, kPieces, static_cast<double>(gl2ps.pieces().size()) / count);
    for (const HiddenMethod method : kObjectSpaceMethods) {
      const std::string of(name_of(method));
      if (left_out(method)) {
        comparison.leave_out(name, of, task.left_out.at(of));
        continue;
      }
      const auto ours = [&] { pieces_by(method, scene.primitives()); };
      const auto round = [&] {
        const double our_seconds = seconds_each(Clock::processor, 1, ours);
        return std::pair(our_seconds, gl2ps.sort());
      };
      const auto [our_first, first] = round();
      const int rounds = std::clamp(
          static_cast<int>(task.effort.most_seconds / (our_first + first)), 1, task.effort.rounds);
      std::vector<double> ratios;
      for (int i = 0; i < rounds; ++i) {
        const auto [own, others] = round();
        ratios.push_back(others / own);
      }
      comparison.add_ratio(name, of, spread(std::move(ratios)));
    }
  }
}

// ---- Without exact stages --------------------------------------------------------------

/// What each of a method's forms does for a picture from a viewed scene: it makes ready, and finds
/// what is seen at every pixel.
void compare_image_space(Comparison& comparison, const ViewedScene& scene, HiddenMethod method) {
  const BesideTask& task = comparison.task();
  const PictureSize size = size_of(task.scene);
  const auto exact = make_image_space_method(method);
  const bool single = method == HiddenMethod::z_buffer;
  const auto rounded = single ? std::make_unique<ZBuffer>(ZBuffer::Decided::in_single_precision)
                              : make_image_space_method(method);
  std::vector<Fill> seen = room_for(size), seen_rounded = seen;
  const auto drawn = [&](ImageSpaceMethod& form, std::optional<double> roundoff,
                         std::vector<Fill>& to) {
    return [&, roundoff] {
      form.prepare({scene, size, roundoff}, 1);
      find_seen(form, size, 1, to);
    };
  };
  const std::string name(name_of(method));
  comparison.time(kRounded, name, drawn(*exact, std::nullopt, seen),
                  drawn(*rounded, single ? std::nullopt : std::optional(0.0), seen_rounded));
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) wrong += seen[i] != seen_rounded[i];
  comparison.found.back().count = static_cast<double>(wrong);
}

/// Without any ROUNDOFF a sort cuts what crosses by rounding alone.
void compare_sort(Comparison& comparison, const DisplayFile& file, HiddenMethod method) {
  const BesideTask& task = comparison.task();
  const std::string name(name_of(method));
  const Frame frame{task.scene.size, task.scene.size};
  constexpr double kRoundoff = 1e-12;
  std::unique_ptr<Drawing> exact, rounded;
  for (const Contender& contender : contenders(std::span(&kRoundoff, 1))) {
    if (contender.method != name) continue;
    (contender.exact ? exact : rounded) = contender.draw(file, frame);
  }
  comparison.time(
      kRounded, name, [&] { exact->draw_anew(); }, [&] { rounded->draw_anew(); });
  const Picture right = exact->judged(), other = rounded->judged();
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < right.ids.size(); ++i) wrong += right.ids[i] != other.ids[i];
  comparison.found.back().count = static_cast<double>(wrong);
}

void compare_without_exact_stages(Comparison& comparison) {
  const BesideTask& task = comparison.task();
  const DisplayFile file = task.scene.make();
  const ViewedScene scene(file);
  const auto is_compared = [&](HiddenMethod method) {
    const std::string name(name_of(method));
    if (std::ranges::find(task.methods, name) == task.methods.end()) return false;
    const auto why = task.left_out.find(name);
    if (why != task.left_out.end()) comparison.leave_out(kRounded, name, why->second);
    return why == task.left_out.end();
  };
  for (const ImageSpaceEntry& entry : image_space_methods()) {
    if (is_compared(entry.method)) compare_image_space(comparison, scene, entry.method);
  }
  for (const HiddenMethod method : kObjectSpaceMethods) {
    const bool is_sort = method != HiddenMethod::map;  // which has no other precision
    if (is_sort && is_compared(method)) compare_sort(comparison, file, method);
  }
}

}  // namespace

Json to_json(const BesideTask& task) {
  const BenchScene& scene = task.scene;
  return {{"kind", static_cast<int>(scene.kind)},
          {"name", scene.name},
          {"n", scene.n},
          {"severity", scene.severity},
          {"gap", scene.gap},
          {"size", scene.size},
          {"seed", scene.seed},
          {"first_polygons", task.first_polygons},
          {"threads", task.threads},
          {"others", task.others},
          {"methods", task.methods},
          {"left_out", task.left_out},
          {"rounds", task.effort.rounds},
          {"least_seconds", task.effort.least_seconds},
          {"most_seconds", task.effort.most_seconds}};
}

BesideTask beside_task_from_json(const Json& json) {
  BesideTask task;
  task.scene = {static_cast<BenchScene::Kind>(json.at("kind").get<int>()),
                json.at("name"),
                json.at("n"),
                json.at("severity"),
                json.at("gap"),
                json.at("size"),
                json.at("seed")};
  task.first_polygons = json.at("first_polygons");
  task.threads = json.at("threads");
  task.others = json.at("others").get<std::vector<std::string>>();
  task.methods = json.at("methods").get<std::vector<std::string>>();
  task.left_out = json.at("left_out").get<std::map<std::string, std::string>>();
  task.effort = {json.at("rounds"), json.at("least_seconds"), json.at("most_seconds")};
  return task;
}

std::vector<Beside> compare(const BesideTask& task) {
  Comparison comparison(task);
  for (const std::string& other : task.others) {
    if (other == "osmesa" && osmesa_available()) compare_with_osmesa(comparison);
    if (other == "views") compare_new_views(comparison);
    if (other == "embree" && EmbreeRays::version()) compare_with_embree(comparison);
    if (other == "gl2ps" && Gl2psSort::version()) compare_with_gl2ps(comparison);
    if (other == "rounded") compare_without_exact_stages(comparison);
  }
  return std::move(comparison.found);
}

std::string compared(const std::string& task) {
  Json found = Json::array();
  for (const Beside& beside : compare(beside_task_from_json(Json::parse(task)))) {
    found.push_back(to_json(beside));
  }
  return found.dump();
}

std::vector<Beside> compare_in_own_process(const BesideTask& task) {
  const std::string of_llvmpipe =
      fmt::format("LP_NUM_THREADS={}", task.threads == 1 ? 0 : task.threads);
  const Finished finished =
      run(Process{.command = {"/proc/self/exe", "bench", "--beside", to_json(task).dump()},
                  .variables = {of_llvmpipe}});
  if (!finished.succeeded) throw Error("bench: the process that compares with others failed");
  std::vector<Beside> found;
  for (const Json& json : Json::parse(finished.output)) found.push_back(beside_from_json(json));
  return found;
}

}  // namespace displayfile::bench
