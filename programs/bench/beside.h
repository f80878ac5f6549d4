#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "programs/bench/json_report.h"
#include "programs/bench/report.h"
#include "programs/bench/timing.h"

namespace displayfile::bench {

/// Comparisons by one rule: the other side gets its best documented options, is warm, has the same
/// primitives, the same number of threads, and is used as its applications use it.
///
/// | other | what | ours | the other's |
/// |---|---|---|---|
/// | kOsmesa | kStartUp | a new system, one triangle, its picture | a new context, one triangle |
/// | | kNewVertices | the mesh entered anew, and drawn | its vertices handed over, and drawn |
/// | | kNewViews | a retained scene in eight views | a resident mesh, as many matrices |
/// | | kAgain | the same display file again | the resident mesh again |
/// | kFewestPolygons | kNewViews | as above | ours, of its name the scene of fewest polygons |
/// | kEmbree, kEmbreeHigh | kRays | rays cast at a tree that is there | the same |
/// | | kBuilding | making that tree | the same |
/// | kGl2ps, kGl2psBestRoot | a sort's name | that sort of the triangles | its BSP sort of them |
/// | | the map's name | their map, and its pieces | likewise |
/// | kRounded | a method's name | the method | the same code without its exact stages |
///
/// Without them the z-buffer decides in single precision, sorts with a ROUNDOFF of 1e-12, and the
/// others with one of 0; the map has none. Eight views are those of moving_camera.h.
///
/// and counts: kTriangles that kOsmesa and kGl2ps got; of a moving camera the kViews that were held
/// against kTruth, and in all of them kWrongPixels; of kMemory the bytes a triangle, of
/// kRetainedScene, kView and kDrawing (MovingCamera); kPieces a triangle, of kGl2ps,
/// kGl2psBestRoot, our sorts and the map; of kOsmesa kOtherPixels, in a hundred where its picture
/// of a view is another than ours, the most of all views; of kEmbree kPacket, how many rays it
/// casts at a time; of kRounded, with its time, the wrong pixels.
namespace beside {
inline constexpr const char* kOsmesa = "OSMesa";
inline constexpr const char* kEmbree = "Embree";
inline constexpr const char* kEmbreeHigh = "Embree, high quality";
inline constexpr const char* kGl2ps = "gl2ps";
inline constexpr const char* kGl2psBestRoot = "gl2ps, best root";
/// The contender that this is.
inline constexpr const char* kGl2psBestRootColumn = "gl2ps, bsp, best root";
inline constexpr const char* kRounded = "without exact stages";
inline constexpr const char* kFewestPolygons = "fewest polygons";
inline constexpr const char* kTruth = "truth";
inline constexpr const char* kMemory = "bytes a triangle";

inline constexpr const char* kStartUp = "start-up";
inline constexpr const char* kNewVertices = "new vertices";
inline constexpr const char* kNewViews = "moving camera";
inline constexpr const char* kAgain = "same picture again";
inline constexpr const char* kRays = "rays";
inline constexpr const char* kBuilding = "building the tree";
inline constexpr const char* kTriangles = "triangles";
inline constexpr const char* kPieces = "pieces a triangle";
inline constexpr const char* kOtherPixels = "pixels that differ, %";
inline constexpr const char* kPacket = "rays a packet";
inline constexpr const char* kViews = "views";
inline constexpr const char* kWrongPixels = "wrong pixels";
inline constexpr const char* kRetainedScene = "retained scene";
inline constexpr const char* kView = "view";
inline constexpr const char* kDrawing = "drawing";
}  // namespace beside

/// What is compared in one process: llvmpipe reads its number of threads once, when the process
/// makes its first context.
struct BesideTask {
  BenchScene scene;
  int threads = 1;
  std::vector<std::string> others;              ///< "osmesa", "views", "embree", "gl2ps", "rounded"
  std::vector<std::string> methods;             ///< ours that are held against "rounded"
  std::map<std::string, std::string> left_out;  ///< our methods that take too long here, and why
  Effort effort;
  std::size_t first_polygons = 0;  ///< asked for, of kFewestPolygons; 0: the scene is that itself
};
Json to_json(const BesideTask& task);
BesideTask beside_task_from_json(const Json& json);

/// In this process.
std::vector<Beside> compare(const BesideTask& task);

/// In a process of its own, this program started again. Throws Error, with its words, if that
/// fails.
std::vector<Beside> compare_in_own_process(const BesideTask& task);

/// What the process prints: the task as text in, the comparisons out.
std::string compared(const std::string& task);

}  // namespace displayfile::bench
