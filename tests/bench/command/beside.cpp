#include "tests/bench/command/beside.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "clip/base/work_budget.h"
#include "hidden/map/map_pieces.h"
#include "hidden/sort/hidden_surface_sort.h"
#include "interp/draw/renderer.h"
#include "interp/opengl/osmesa.h"
#include "interp/visibility/image_space.h"
#include "interp/visibility/z_buffer.h"
#include "programs/scenes/scene.h"
#include "tests/bench/command/application_mesh.h"
#include "tests/bench/command/contenders.h"
#include "tests/bench/command/embree_rays.h"
#include "tests/bench/command/find_seen.h"
#include "tests/bench/command/gl2ps_sort.h"
#include "tests/bench/command/indexed_triangles.h"
#include "tests/bench/command/opengl_mesh.h"
#include "tests/bench/command/process.h"

namespace displayfile::bench {

namespace {

using Fill = ViewedScene::Fill;

PictureSize size_of(const BenchScene& scene) { return {scene.size, scene.size}; }

// ---- OSMesa ----------------------------------------------------------------------------

DrawOptions by_z_buffer(const BesideTask& task) {
  DrawOptions options{.samples = 1};
  options.width = options.height = task.scene.size;
  options.surfaces.threads = task.threads;
  options.surfaces.method = HiddenMethod::z_buffer;
  return options;
}

void compare_start_up(Comparison& comparison) {
  const BesideTask& task = comparison.task();
  const std::vector<Point3> triangle{{0.25, 0.25, 0.0}, {0.75, 0.25, 0.0}, {0.5, 0.75, 0.0}};
  const auto indexed = indexed_triangles(triangle, std::vector<std::uint32_t>{0xFF0000FF});
  comparison.time(
      "OSMesa", "start-up",
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
    for (const char* what : {"new vertices", "same picture again"}) {
      comparison.leave_out("OSMesa", what, reason.why);
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
      "OSMesa", "new vertices",
      [&] {
        enter(mesh, system);
        renderer.draw(system, options);
      },
      [&] { opengl.draw_with_new_vertices(); });
  opengl.make_resident();
  comparison.time(
      "OSMesa", "same picture again", [&] { renderer.draw(system, options); },
      [&] { opengl.draw(); });
}

// ---- Embree ----------------------------------------------------------------------------

/// Both cast parallel rays through the pixel centres at the same triangles; the result is the
/// triangle hit.
void compare_with_embree(Comparison& comparison) {
  const BesideTask& task = comparison.task();
  const int threads = task.threads;
  const PictureSize picture = size_of(task.scene);
  const DisplayFile file = display_file_of(in_triangles(ViewedScene(task.scene.make())));
  const ViewedScene triangles(file);
  const ImageSpaceMethod::Request request{triangles, picture, std::nullopt};
  const auto method = make_image_space_method(HiddenMethod::ray_cast);
  const auto other = make_image_space_method(HiddenMethod::ray_cast);
  method->prepare(request, threads);
  const EmbreeRays::Input input(in_triangles(triangles), picture);
  std::vector<Fill> seen = room_for(picture);
  EmbreeRays::Hits hits(picture, false);
  for (const auto quality : {EmbreeRays::Quality::moderate, EmbreeRays::Quality::high}) {
    const bool high = quality == EmbreeRays::Quality::high;
    const char* const name = high ? "Embree, high quality" : "Embree";
    const EmbreeRays embree(input, threads, quality);
    comparison.time(
        name, "rays", [&] { find_seen(*method, picture, threads, seen); },
        [&] {
          for_rows(picture.height, threads,
                   [&](int begin, int end) { embree.cast(begin, end, hits); });
        });
    comparison.time(
        name, "building the tree", [&] { other->prepare(request, threads); },
        [&] { EmbreeRays(input, threads, quality); });
  }
  std::size_t hit = 0, differ = 0;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    hit += seen[k] != ViewedScene::kBackground ? 1 : 0;
    differ += seen[k] != hits.fills[k] ? 1 : 0;
  }
  const auto in_a_hundred = [&](std::size_t count) {
    return 100.0 * static_cast<double>(count) / static_cast<double>(seen.size());
  };
  comparison.count("Embree", "rays a packet", EmbreeRays::packet_width());
  comparison.count("Embree", "rays that hit, %", in_a_hundred(hit));
  comparison.count("Embree", "pixels that differ, %", in_a_hundred(differ));
}

// ---- gl2ps -----------------------------------------------------------------------------

/// From the polygons to the points of their pieces, exact, on one thread.
SortedPieces pieces_by(HiddenMethod method, const Primitives& polygons) {
  if (method == HiddenMethod::map) return pieces_of_map(polygons, visible_map(polygons, {}));
  return sort_hidden_surfaces(polygons, {.method = method});
}

/// Our methods that are chosen and compared: the others, and those that a limit of work stops, are
/// left out of the rows that name them.
class OurMethods {
 public:
  explicit OurMethods(Comparison& comparison)
      : comparison_(comparison), left_out_(comparison.task().left_out) {}

  bool are_chosen(HiddenMethod method) const {
    return std::ranges::find(comparison_.task().methods, name_of(method)) !=
           comparison_.task().methods.end();
  }
  /// Calls compare(), unless the method is left out: then the row has the reason.
  void compare(HiddenMethod method, const std::string& other, const std::string& what,
               const auto& compared) {
    const std::string name(name_of(method));
    if (!left_out_.contains(name)) {
      try {
        return compared();
      } catch (const LimitReached& reached) {
        ask_budget();  // a limit on all work stops it
        left_out_.emplace(name, reached.what());
      }
    }
    comparison_.leave_out(other, what, left_out_.at(name));
  }

 private:
  Comparison& comparison_;
  std::map<std::string, std::string> left_out_;  // and why
};

std::vector<HiddenMethod> chosen_sorts(const OurMethods& ours) {
  std::vector<HiddenMethod> chosen;
  std::ranges::copy_if(kObjectSpaceMethods, std::back_inserter(chosen),
                       [&](HiddenMethod method) { return ours.are_chosen(method); });
  return chosen;
}

void compare_with_gl2ps(Comparison& comparison) {
  const BesideTask& task = comparison.task();
  const DisplayFile file = display_file_of(in_triangles(ViewedScene(task.scene.make())));
  const ViewedScene scene(file);
  const Triangles triangles = in_triangles(scene);
  const auto count = static_cast<double>(std::max<std::size_t>(1, triangles.size()));
  OurMethods ours(comparison);
  const std::vector<HiddenMethod> methods = chosen_sorts(ours);
  comparison.count("gl2ps", "triangles", static_cast<double>(triangles.size()));
  for (const HiddenMethod method : methods) {
    const std::string name(name_of(method));
    ours.compare(method, name, "pieces a triangle", [&] {
      const SortedPieces found = pieces_by(method, scene.primitives());
      comparison.count(name, "pieces a triangle", static_cast<double>(found.pieces.size()) / count);
    });
  }
  for (const Gl2psSort::Options& options : Gl2psSort::kOptions) {
    const std::string name = fmt::format("gl2ps{}", options.name);
    const Gl2psSort gl2ps{triangles.corners, size_of(task.scene), options};
    const auto leave_all_out = [&](const std::string& why) {
      comparison.leave_out(name, "pieces a triangle", why);
      for (const HiddenMethod method : methods) {
        comparison.leave_out(name, std::string(name_of(method)), why);
      }
    };
    if (!gl2ps.ends()) {
      leave_all_out("gl2ps's sort does not come to an end");
      continue;
    }
    try {
      const auto pieces = static_cast<double>(gl2ps.pieces().size());
      comparison.count(name, "pieces a triangle", pieces / count);
    } catch (const Error& reason) {
      leave_all_out(reason.what());
      continue;
    }
    for (const HiddenMethod method : methods) {
      const std::string of(name_of(method));
      ours.compare(method, name, of, [&] {
        const auto sort_ours = [&] { pieces_by(method, scene.primitives()); };
        const auto round = [&] {
          const double our_seconds = seconds_each(Clock::processor, 1, sort_ours);
          return std::pair(our_seconds, gl2ps.sort());
        };
        const auto [our_first, first] = round();
        const int rounds =
            std::clamp(static_cast<int>(task.effort.most_seconds / (our_first + first)), 1,
                       task.effort.rounds);
        std::vector<double> ratios;
        for (int i = 0; i < rounds; ++i) {
          const auto [own, others] = round();
          ratios.push_back(others / own);
        }
        comparison.add_ratio(name, of, spread(std::move(ratios)));
      });
    }
  }
}

// ---- Without exact stages --------------------------------------------------------------

/// The work of each form of a method for a picture from a viewed scene: it prepares, and finds the
/// visible polygon at every pixel.
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
  comparison.time("without exact stages", name, drawn(*exact, std::nullopt, seen),
                  drawn(*rounded, single ? std::nullopt : std::optional(0.0), seen_rounded));
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) wrong += seen[i] != seen_rounded[i];
  comparison.found.back()["count"] = wrong;
}

/// With no ROUNDOFF a sort cuts polygons that cross only by rounding.
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
      "without exact stages", name, [&] { exact->draw_anew(); }, [&] { rounded->draw_anew(); });
  const Picture right = exact->judged(), other = rounded->judged();
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < right.ids.size(); ++i) wrong += right.ids[i] != other.ids[i];
  comparison.found.back()["count"] = wrong;
}

void compare_without_exact_stages(Comparison& comparison) {
  const BesideTask& task = comparison.task();
  const DisplayFile file = task.scene.make();
  const ViewedScene scene(file);
  OurMethods ours(comparison);
  const auto compare = [&](HiddenMethod method, const auto& compared) {
    if (!ours.are_chosen(method)) return;
    ours.compare(method, "without exact stages", std::string(name_of(method)), compared);
  };
  for (const ImageSpaceEntry& entry : image_space_methods()) {
    compare(entry.method, [&] { compare_image_space(comparison, scene, entry.method); });
  }
  for (const HiddenMethod method : kObjectSpaceMethods) {
    const bool is_sort = method != HiddenMethod::map;  // which has no other precision
    if (is_sort) compare(method, [&] { compare_sort(comparison, file, method); });
  }
}

}  // namespace

std::string compared(const std::string& text) {
  const BesideTask task = nlohmann::json::parse(text).get<BesideTask>();
  Comparison comparison(task);
  if (task.other == "osmesa" && osmesa_available()) compare_with_osmesa(comparison);
  if (task.other == "views") compare_new_views(comparison);
  if (task.other == "embree" && EmbreeRays::version()) compare_with_embree(comparison);
  if (task.other == "gl2ps" && Gl2psSort::version()) compare_with_gl2ps(comparison);
  if (task.other == "rounded") compare_without_exact_stages(comparison);
  return comparison.found.dump();
}

std::uint64_t pieces_allowed() {
  const WorkBudget* const budget = work_in_force().budget;
  return budget == nullptr ? WorkLimits::kNone : budget->limits().pieces;
}

Json compare_in_own_process(const BesideTask& task) {
  const std::string of_llvmpipe =
      fmt::format("LP_NUM_THREADS={}", task.threads == 1 ? 0 : task.threads);
  std::vector<std::string> command{"/proc/self/exe", "bench", "--beside", text_of(task)};
  const std::uint64_t pieces = pieces_allowed();
  if (pieces != WorkLimits::kNone) {
    command.insert(command.end(), {"--limit-pieces", std::to_string(pieces)});
  }
  const Finished finished = run(Process{.command = std::move(command), .variables = {of_llvmpipe}});
  if (!finished.succeeded) throw Error("bench: the process that compares with others failed");
  return Json::parse(finished.output);
}

}  // namespace displayfile::bench
