// The sheet of a mesh, four views with hidden lines dashed: the whole command, from the file to the
// SVG, beside OpenCASCADE's polygonal algorithm on the same four views, warm, from a shape that is
// made to compounds of the visible and the hidden edges.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "programs/bench/temporary_folder.h"
#include "tests/bench/lines_beside_peers/peer_process.h"
#include "tests/bench/lines_beside_peers/peer_scene.h"
#include "tests/bench/surfaces_and_sheets/rows.h"

namespace displayfile::bench {
namespace {

/// From where a sheet by the third angle shows a part: front, top, right, isometric.
std::array<EyeDirection, 4> eyes_of_sheet() {
  const double isometric = std::asin(1.0 / std::sqrt(3.0)) * 180.0 / std::numbers::pi;
  return {EyeDirection{0.0, 0.0}, EyeDirection{0.0, 90.0}, EyeDirection{90.0, 0.0},
          EyeDirection{45.0, isometric}};
}

/// Seconds of the processor, of which the peer has one, for all views, each view's least; throws
/// PeerStopped.
double seconds_of_peer(const std::vector<PeerScene>& views, const TemporaryFolder& folder,
                       const TableOptions& options) {
  const std::string mesh = folder.file("mesh.obj"), view = folder.file("view");
  double sum = 0.0;
  for (const PeerScene& scene : views) {
    write_view(scene, view);
    PeerProcess peer({DISPLAYFILE_OCCT_LINES, mesh, view, "polygonal"}, options.limit);
    const auto round = [&] { return std::stod(peer.ask("round processor hidden", "seconds")); };
    round();  // the first warms up
    double least = round();
    for (int k = 1; k < options.rounds; ++k) least = std::min(least, round());
    sum += least;
  }
  return sum;
}

void add_rows_of(const std::string& path, const TableOptions& options,
                 std::vector<Result>& results) {
  const std::string name = std::filesystem::path(path).stem().string();
  const std::string work = fmt::format("sheet of {}, four views to SVG", name);
  const std::string peer = "OpenCASCADE polygonal, the four views, warm";
  if (!std::filesystem::exists(DISPLAYFILE_OCCT_LINES)) {
    results.push_back({work, ">= 10", "occt_lines is not built", "", peer, ""});
    return;
  }
  const Mesh mesh = read_mesh(path);
  std::vector<PeerScene> views;
  for (const EyeDirection& eye : eyes_of_sheet()) {
    Camera camera;
    camera.parallel = true;
    camera.eye = eye;
    views.push_back(peer_scene(name, "sheet", mesh, camera));
  }
  const TemporaryFolder folder;
  write_mesh(views.front(), folder.file("mesh.obj"));
  const auto ours = [&](const char* lines) {
    return least_cost({DISPLAYFILE_COMMAND, "sheet", folder.file("mesh.obj"), "--lines", lines,
                       "-o", folder.file("sheet.svg")},
                      options.rounds)
        .processor;
  };
  try {
    const double theirs = seconds_of_peer(views, folder, options);
    const double faster = theirs / ours("outline,boundary,crease");
    results.push_back(
        {work, ">= 10", fmt::format("{:.1f}", faster), "", peer, holds_if(faster >= 10.0)});
    results.push_back({work + ", of all edges", "", fmt::format("{:.1f}", theirs / ours("all")), "",
                       peer + ": it has all edges in any case", ""});
  } catch (const PeerStopped& why) {
    results.push_back({work, ">= 10", why.what(), "", peer, ""});
  }
}

}  // namespace

void add_sheet_rows(const TableOptions& options, std::vector<Result>& results) {
  for (const std::string& path : options.meshes) add_rows_of(path, options, results);
}

}  // namespace displayfile::bench
