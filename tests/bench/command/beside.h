#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/bench/command/bench_scene.h"
#include "tests/bench/command/report.h"
#include "tests/bench/command/timing.h"

namespace displayfile::bench {

/// Comparisons by one rule: the other side gets its best documented options, is warm, has the same
/// primitives, the same number of threads, and is used as its applications use it.
///
/// | other | what | ours | the other's |
/// |---|---|---|---|
/// | OSMesa | start-up | a new system, one triangle, its picture | a new context, one triangle |
/// | | new vertices | the mesh entered anew, and drawn | its vertices passed, and drawn |
/// | | moving camera | a retained scene in eight views | a resident mesh, as many matrices |
/// | | same picture again | the same display file again | the resident mesh again |
/// | fewest polygons | moving camera | as above | ours, of its name the scene of fewest polygons |
/// | Embree (, high quality) | rays | rays cast at a tree that is there | the same |
/// | | building the tree | making that tree | the same |
/// | gl2ps (, best root) | a sort's name | that sort of the triangles | its BSP sort of them |
/// | | map | their map, and its pieces | likewise |
/// | without exact stages | a method's name | the method | the same code without its exact stages |
///
/// Without them the z-buffer decides in single precision, sorts with a ROUNDOFF of 1e-12, and the
/// others with one of 0; the map has none. Eight views are those of ApplicationMesh.
///
/// and counts: triangles that OSMesa and gl2ps got; of a moving camera the views that were
/// compared with the truth, and in all of them wrong pixels; bytes a triangle, of the retained
/// scene, of what viewing it keeps (view) and of what drawing it keeps besides (drawing); pieces a
/// triangle, of gl2ps, our sorts and the map; of OSMesa pixels that differ, in a hundred, the most
/// of all views; of Embree how many rays a packet has, which part of all rays hits and where it
/// sees another triangle, in a hundred; of each method without exact stages, with its time, wrong
/// pixels.
///
/// A task is what is compared in one process: llvmpipe reads its number of threads once, when the
/// process makes its first context.
struct BesideTask {
  BenchScene scene;
  int threads = 1;
  std::string other;                            ///< "osmesa", "views", "embree", "gl2ps", "rounded"
  std::vector<std::string> methods;             ///< ours that "gl2ps" and "rounded" stand beside
  std::map<std::string, std::string> left_out;  ///< our methods that take too long here, and why
  Effort effort;
  std::size_t first_polygons =
      0;  ///< of the smallest scene that is made; 0: the scene is the mesh itself
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BenchScene, kind, name, n, severity, gap, size, seed)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Effort, rounds, least_seconds, most_seconds)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BesideTask, scene, threads, other, methods, left_out, effort,
                                   first_polygons)
/// Different for different tasks.
inline std::string text_of(const BesideTask& task) { return nlohmann::json(task).dump(); }

/// Collects the comparisons of one task.
class Comparison {
 public:
  explicit Comparison(const BesideTask& task) : task_(task) {}

  const BesideTask& task() const { return task_; }
  void add_ratio(const std::string& other, const std::string& what, const Spread& times_faster) {
    add(other, what)["times_faster"] = figures(times_faster);
  }
  /// In turn; the ratio is the factor by which ours is faster.
  void time(const char* other, const std::string& what, const auto& ours, const auto& others) {
    add_ratio(other, what, warm_ratio(task_.effort, task_.threads, others, ours));
  }
  void count(const std::string& other, const std::string& what, double value) {
    add(other, what)["count"] = value == std::floor(value) ? value : figure(value);
  }
  void leave_out(const std::string& other, const std::string& what, const std::string& why) {
    add(other, what)["left_out"] = why;
  }
  Json& add(const std::string& other, const std::string& what) {
    return found.emplace_back(Json{
        {"scene", task_.scene.id()}, {"threads", task_.threads}, {"other", other}, {"what", what}});
  }

  Json found = Json::array();

 private:
  const BesideTask& task_;
};

/// A moving camera (moving_camera.cpp).
void compare_new_views(Comparison& comparison);

/// The limit of pieces in force; WorkLimits::kNone if there is none.
std::uint64_t pieces_allowed();

/// In a process of its own, this program started again. Throws Error, with its words, if that
/// fails.
Json compare_in_own_process(const BesideTask& task);

/// The output of the process: the task as text in, the comparisons out.
std::string compared(const std::string& task);

}  // namespace displayfile::bench
