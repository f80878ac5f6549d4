// Sorts, the map and methods of lines in object space, each way in turn with the first of its
// table: times over that one's, and the output's size. Times with several threads are by the clock.
//   lines          hidden lines of all sides: Franklin's, exact, is the first
//   map            the visible-surface map is the first; sorts, and one with writing
//   intersections  lines along which polygons pass through each other; hidden lines are the first
//   sorts          each sort exact is the first of its own; beside gl2ps, on one thread
//   roots          choices of a BSP root: `free` is the first
//   traversal      a retained tree, in units of 20 million a second
//   memory         the most bytes that entering and sorting hold at a time
// Each on the meshes and on generated scenes; growth with --low and --high.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <sstream>
#include <tuple>
#include <vector>

#include "displayfile/segments/hidden_surface_check.h"
#include "hidden/lines/visible_lines.h"
#include "hidden/map/map_pieces.h"
#include "hidden/sort/world_tree.h"
#include "interp/device/interpreter.h"
#include "interp/vector/svg_device.h"
#include "programs/scenes/generated_scenes.h"
#include "tests/bench/benchmark.h"
#include "tests/bench/command/counted_memory.h"
#include "tests/bench/command/gl2ps_sort.h"
#include "tests/bench/command/timing.h"
#include "tests/bench/device_scene.h"

namespace displayfile::bench {

const char* const kAbout =
    "Object space: lines, map, intersections, sorts, roots, traversal, memory";

namespace {

/// The counts of an alternative's output, and its seconds if they are not of all its work.
struct Way {
  std::string name;
  std::function<Json()> find;
  std::function<double()> seconds = nullptr;
};
using Ways = std::vector<Way>;
using WaysOf = std::function<Ways(const DeviceScene&, const Options&)>;

double seconds_of(const Way& way, const Options& options) {
  return way.seconds ? way.seconds() : seconds_each(clock_of(options.threads), 1, way.find);
}

void compare(const std::string& part, const DeviceScene& scene, const Ways& ways,
             const Options& options) {
  for (const Way& way : ways) {
    Json row{{"table", part}, {"scene", scene.name}, {"polygons", scene.size()}, {"way", way.name}};
    row.update(way.find());
    if (&way != &ways.front()) {
      row["time"] = figures(ratio_of_seconds(
          options.rounds, [&] { return seconds_of(ways.front(), options); },
          [&] { return seconds_of(way, options); }));
    }
    print_row(row);
  }
}

void print_growth(const std::string& part, const std::vector<std::string>& names,
                  const WaysOf& ways_of, const Options& options) {
  for (const std::string& name : names) {
    for (const std::size_t n : options.sizes()) {
      const DeviceScene scene = name == "sphere" ? sphere(n) : generated(name, n);
      const double overlaps = overlaps_per_polygon(scene);
      for (const Way& way : ways_of(scene, options)) {
        double least = seconds_of(way, options);
        for (int i = 0; i < 2; ++i) least = std::min(least, seconds_of(way, options));
        Json row{{"table", part + ", growth"}, {"scene", name},          {"way", way.name},
                 {"n", scene.size()},          {"overlapped", overlaps}, {"seconds", least}};
        row.update(way.find());
        print_row(row);
      }
    }
  }
}

// ---- Lines -------------------------------------------------------------------------------

/// A scene whose polygons share their corners, as in a mesh.
struct SharedScene {
  explicit SharedScene(const DeviceScene& scene) : polygons(scene.polygons) {
    std::map<std::tuple<double, double, double>, std::uint32_t> known;
    for (const Point3& p : scene.points) {
      const auto next = static_cast<std::uint32_t>(points.size());
      const auto [at, is_new] = known.try_emplace({p.x, p.y, p.z}, next);
      if (is_new) points.push_back(p);
      corners.push_back(at->second);
    }
    lines = drawn_lines(items());
  }
  Primitives items() const { return {points, corners, {}, polygons}; }

  std::vector<Point3> points;
  std::vector<std::uint32_t> corners;
  std::vector<Primitives::Item> polygons;
  std::vector<LineName> lines;
};

Ways lines(const DeviceScene& scene, const Options& options) {
  const auto shared = std::make_shared<SharedScene>(scene);
  const auto by = [=](HiddenMethod method, bool exact, int threads) {
    return [=] {
      const SeenLines seen =
          visible_lines(shared->items(), shared->lines,
                        {.method = method, .precision = {.exact = exact}, .threads = threads});
      return Json{{"lines", shared->lines.size()}, {"pieces", seen.pieces.size()}};
    };
  };
  const int n = options.threads;
  Ways ways{{"franklin", by(HiddenMethod::franklin, true, n)},
            {"franklin, roundoff", by(HiddenMethod::franklin, false, n)},
            {"roberts", by(HiddenMethod::roberts, true, n)},
            {"appel", by(HiddenMethod::appel, true, n)},
            {"appel, roundoff", by(HiddenMethod::appel, false, n)}};
  if (n > 1) ways.push_back({"franklin, one thread", by(HiddenMethod::franklin, true, 1)});
  return ways;
}
Ways growing_lines(const DeviceScene& scene, const Options& options) {
  const Ways all = lines(scene, options);
  return {all[0], all[3]};
}

Ways intersections(const DeviceScene& scene, const Options& options) {
  const auto shared = std::make_shared<SharedScene>(scene);
  const int threads = options.threads;
  const auto found = intersection_lines(shared->items(), threads);
  const auto seen = [=](const std::vector<LineName>& of, const std::vector<IntersectionLine>& at) {
    const SeenLines all = visible_lines(shared->items(), of,
                                        {.method = HiddenMethod::franklin, .threads = threads}, at);
    return Json{{"lines", of.size()}, {"pieces of intersections", all.intersections.size()}};
  };
  return {{"hidden lines", [=] { return seen(shared->lines, {}); }},
          {"finding intersections",
           [=] {
             return Json{{"intersections", intersection_lines(shared->items(), threads).size()}};
           }},
          {"all lines with them", [=] { return seen(shared->lines, found); }},
          {"seeing them alone", [=] { return seen({}, found); }}};
}

/// The scene twice: the second copy is moved by a part of its size and turned round.
DeviceScene twice(const DeviceScene& scene) {
  DeviceScene both = scene;
  both.name += ", twice";
  Point3 low = scene.points[0], high = low;
  for (const Point3& p : scene.points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  std::vector<Point3> moved;
  for (const Point3& p : scene.points) {
    const Point3 turned{low.x + high.x - p.x, p.y, low.z + high.z - p.z};
    moved.push_back(turned + Point3{0.3, 0.1, 0.05} * (high - low));
  }
  for (const Primitives::Item& item : scene.polygons) both.add(&moved[item.first], item.sides);
  return both;
}

// ---- Sorts and the map -------------------------------------------------------------------

/// A scene in one segment of a display file, each polygon in its own shade.
DisplayFile entered(const DeviceScene& scene) {
  DisplayFile file;
  Segment& segment = file.create(1);
  segment.set_style(LineStyle{LineStyle::Kind::none});
  for (std::size_t k = 0; k < scene.polygons.size(); ++k) {
    const double grey = static_cast<double>(k % 200) / 255.0;
    segment.set_style(FillStyle{.colour = {grey, grey, 0.2 + grey}});
    const auto& polygon = scene.polygons[k];
    segment.enter_polygon(std::span(scene.points).subspan(polygon.first, polygon.sides),
                          std::vector<std::uint8_t>(polygon.sides, 0));
  }
  return file;
}

Ways map_and_sorts(const DeviceScene& scene, const Options& options) {
  const auto file = std::make_shared<DisplayFile>(entered(scene));
  const auto find = [=](HiddenMethod method, int threads) {
    return hidden_surface_check(file->visible_segments(), {.method = method, .threads = threads});
  };
  const auto by = [=](HiddenMethod method, int threads) {
    return [=] { return Json{{"pieces", find(method, threads)->counts.pieces}}; };
  };
  const auto written = [=, threads = options.threads] {
    DisplayFile sorted = *file;
    sorted.set_sorted(find(HiddenMethod::depth_sort, threads));
    SvgDevice device(512, 512);
    interpret(sorted, device);
    std::ostringstream text;
    device.finish(text);
    return Json{{"pieces", sorted.sorted()->counts.pieces}};
  };
  const int n = options.threads;
  Ways ways{{"map", by(HiddenMethod::map, n)},
            {"depth-sort, written", written},
            {"depth-sort", by(HiddenMethod::depth_sort, n)},
            {"bsp", by(HiddenMethod::bsp, n)}};
  if (n > 1) ways.push_back({"map, one thread", by(HiddenMethod::map, 1)});
  return ways;
}
Ways map_alone(const DeviceScene& scene, const Options& options) {
  return {map_and_sorts(scene, options).front()};
}

/// Counts of a sort, for each polygon.
Json sorted(const DeviceScene& scene, HiddenMethod method, const SurfacePlan& options) {
  const SortedPieces made = sort_hidden_surfaces(scene.items(), options.by(method));
  const auto n = static_cast<double>(scene.size());
  return {{"pieces a polygon", figure(static_cast<double>(made.pieces.size()) / n)},
          {"comparisons a polygon", figure(static_cast<double>(made.comparisons) / n)},
          {"depth", made.depth}};
}

Ways sort_by(HiddenMethod method, const DeviceScene& scene, const Options& options) {
  const auto by = [&scene, method, threads = options.threads](bool exact) {
    return [=, &scene] {
      return sorted(scene, method, {.precision = {.exact = exact}, .threads = threads});
    };
  };
  const std::string name(name_of(method));
  Ways ways{{name, by(true)}, {name + ", roundoff", by(false)}};
  if (!Gl2psSort::version() || options.threads > 1) return ways;
  // Its sort alone is timed, in a window of 1024 x 1024 pixels.
  for (const Gl2psSort::Options& of_gl2ps : Gl2psSort::kOptions) {
    const Gl2psSort gl2ps{scene.points, {1024, 1024}, of_gl2ps};
    if (!gl2ps.ends()) continue;
    ways.push_back({"gl2ps" + std::string(of_gl2ps.name),
                    [=, n = static_cast<double>(scene.size())] {
                      const auto pieces = static_cast<double>(gl2ps.pieces().size());
                      return Json{{"pieces a polygon", figure(pieces / n)}};
                    },
                    [=] { return gl2ps.sort(); }});
  }
  return ways;
}
Ways growing_sorts(const DeviceScene& scene, const Options& options) {
  return {sort_by(HiddenMethod::bsp, scene, options)[0],
          sort_by(HiddenMethod::depth_sort, scene, options)[0]};
}

Ways roots(const DeviceScene& scene, const Options& options) {
  Ways ways;
  for (const auto& [name, root] : {std::pair("free", RootChoice::free),
                                   {"sample", RootChoice::sample},
                                   {"last", RootChoice::last}}) {
    // The textbook's choice costs n^2 on convex surfaces: beyond this size it is left out.
    if (root == RootChoice::last && scene.size() > 100'000) continue;
    ways.push_back({name, [&scene, root = root, threads = options.threads] {
                      return sorted(scene, HiddenMethod::bsp, {.root = root, .threads = threads});
                    }});
  }
  return ways;
}

/// Eye k of `eyes`, evenly over all directions, for a scene in the unit cube.
Eye eye(int k, int of) {
  const double z = 1.0 - (2.0 * k + 1.0) / of, angle = 2.399963229728653 * k;  // golden
  const double r = std::sqrt(1.0 - z * z);
  const Point3 from(r * std::cos(angle), r * std::sin(angle), z);
  if (k % 2 == 0) return Eye::toward(from);
  return Eye::at(Point3(0.5) + (k % 4 == 1 ? 2.0 : 0.3) * from);
}

void print_traversal(const DeviceScene& scene) {
  constexpr double kUnit = 20e6;
  constexpr int kEyes = 64;
  const WorldTree tree(scene.items(), {});
  std::vector<WorldTree::Index> order;
  tree.far_to_near(eye(0, kEyes), order);  // the order's memory is there from now on
  std::vector<double> polygons, pieces;
  for (int k = 0; k < kEyes; ++k) {
    const double time = seconds([&] { tree.far_to_near(eye(k, kEyes), order); });
    polygons.push_back(static_cast<double>(scene.size()) / time / kUnit);
    pieces.push_back(static_cast<double>(order.size()) / time / kUnit);
  }
  print_row({{"table", "traversal"},
             {"scene", scene.name},
             {"polygons", scene.size()},
             {"pieces", tree.size()},
             {"polygons, of 20 million a second", figures(spread(polygons))},
             {"pieces, of 20 million a second", figures(spread(pieces))}});
}

void print_memory(const Options& options) {
  const Scene scene = generated_scene("terrain").make(options.polygons, 1);
  for (const HiddenMethod method : {HiddenMethod::bsp, HiddenMethod::depth_sort}) {
    GraphicsSystem system;
    system.set_hidden_surfaces({.removal = true});
    system.set_back_face_removal(false);
    system.set_hidden_surfaces({.method = method});
    system.set_threads(options.threads);
    const auto bytes = static_cast<double>(most_bytes_held([&] { enter(scene, system); }));
    print_row({{"table", "memory"},
               {"scene", "terrain"},
               {"polygons", scene.polygons()},
               {"way", name_of(method)},
               {"bytes a polygon", figure(bytes / static_cast<double>(scene.polygons()))}});
  }
}

/// The scenes of a part: meshes with all faces, generated ones, and crossing planes.
std::vector<DeviceScene> scenes_of(const std::vector<Model>& models, const Options& options) {
  std::vector<DeviceScene> scenes;
  std::ranges::transform(models, std::back_inserter(scenes), &Model::all);
  for (const std::string& name : options.scenes_or({"terrain", "village", "soup", "planes"})) {
    scenes.push_back(generated(name, name == "planes" ? options.polygons / 100 : options.polygons));
  }
  return scenes;
}

}  // namespace

void run(const Options& options) {
  std::vector<Model> models;
  for (const std::string& path : options.inputs) models.push_back(read_model(path));
  const auto names = options.scenes_or({"village", "terrain", "soup", "city"});
  const auto measure = [&](const char* part, const WaysOf& ways_of, const WaysOf& growing) {
    if (!options.has(part)) return;
    for (const DeviceScene& scene : scenes_of(models, options)) {
      compare(part, scene, ways_of(scene, options), options);
    }
    print_growth(part, names, growing, options);
  };
  measure("lines", lines, growing_lines);
  measure("map", map_and_sorts, map_alone);
  measure("intersections", intersections, intersections);
  if (options.has("intersections")) {
    for (const Model& model : models) {
      const DeviceScene both = twice(model.all);
      compare("intersections", both, intersections(both, options), options);
    }
  }
  if (options.has("sorts")) {
    for (const Model& model : models) {
      for (const DeviceScene* scene : {&model.entered, &model.all}) {
        if (!model.closed && scene == &model.entered) continue;
        for (const HiddenMethod method : {HiddenMethod::bsp, HiddenMethod::depth_sort}) {
          compare("sorts", *scene, sort_by(method, *scene, options), options);
        }
      }
    }
    print_growth("sorts", names, growing_sorts, options);
  }
  if (options.has("roots")) {
    for (const Model& model : models) {
      compare("roots", model.entered, roots(model.entered, options), options);
    }
    const DeviceScene ball = sphere(options.polygons);
    compare("roots", ball, roots(ball, options), options);
    print_growth("roots", options.scenes_or({"sphere", "terrain", "soup"}), roots, options);
  }
  if (options.has("traversal")) {
    for (const Model& model : models) print_traversal(model.all);
    print_traversal(generated("soup", options.polygons));
  }
  if (options.has("memory")) print_memory(options);
}

}  // namespace displayfile::bench
