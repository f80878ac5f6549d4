// Our hidden lines, as one of the peers that lines-beside-peers runs (README.md).
//   our_lines                            lists the degenerate meshes, a line of JSON each
//   our_lines MESH VIEW KINDS FOLDER     answers requests about a mesh, or a degenerate one by its
//   name

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "hidden/lines/intersection_lines.h"
#include "hidden/lines/visible_lines.h"
#include "interp/truth/true_lines.h"
#include "tests/bench/command/timing.h"
#include "tests/bench/lines_beside_peers/degenerate_meshes.h"
#include "tests/bench/lines_beside_peers/drawn_length.h"
#include "tests/bench/lines_beside_peers/peer_scene.h"

namespace displayfile::bench {
namespace {

PeerScene scene_of(const std::string& mesh, const std::string& view) {
  for (const DegenerateMesh& degenerate : degenerate_meshes()) {
    if (mesh == degenerate.name) return degenerate.make();
  }
  Camera camera;
  camera.parallel = view != "perspective";
  if (view == "front") camera.eye = EyeDirection{0.0, 0.0};
  if (view == "top") camera.eye = EyeDirection{0.0, 90.0};
  if (view == "right") camera.eye = EyeDirection{90.0, 0.0};
  if (view == "isometric") {
    camera.eye = EyeDirection{45.0, std::asin(1.0 / std::sqrt(3.0)) * 180.0 / std::numbers::pi};
  }
  return peer_scene(mesh, view, read_mesh(mesh), camera);
}

SeenLines found(const EnteredMesh& entered, int threads) {
  const Primitives items = entered.scene->primitives();
  std::vector<IntersectionLine> intersections;
  if (entered.intersections) intersections = intersection_lines(items, threads);
  return visible_lines(items, entered.lines, {.method = HiddenMethod::franklin, .threads = threads},
                       intersections);
}

class OurLines {
 public:
  OurLines(const PeerScene& scene, const LineKinds& kinds)
      : scene_(scene), kinds_(kinds), entered_(enter(scene, kinds)), retained_(scene, kinds) {}

  std::string ready() const {
    return fmt::format("ready {} {}", entered_.lines.size(), scene_.mesh.faces());
  }

  std::string answer(const std::string& word, std::istream& words) {
    std::string path, form;
    int threads = 1;
    if (word == "round") {
      words >> form >> threads;
      return round(threads);
    }
    if (word == "truth") {
      words >> threads >> tolerance_;
      return "truth " + truth(threads).dump();
    }
    if (word == "errors") {
      words >> path >> form;
      const LineDrawing all = form == "world" ? read_world_segments(path, scene_.view)
                                              : read_view_plane_segments(path, scene_.view);
      return "errors " + errors(drawn_once(all, tolerance_)).dump();
    }
    throw Error("no question " + word);
  }

 private:
  /// From the mesh, of a new view, and of hiding alone.
  std::string round(int threads) {
    const Clock clock = clock_of(threads);
    const double from_mesh = seconds_each(clock, 1, [&] { found(enter(scene_, kinds_), threads); });
    retained_.look_elsewhere();
    const double new_view = seconds_each(clock, 1, [&] { retained_.draw(threads); });
    const EnteredMesh entered = enter(scene_, kinds_);
    const double hiding = seconds_each(clock, 1, [&] { found(entered, threads); });
    return fmt::format("seconds {} {} {}", from_mesh, new_view, hiding);
  }

  /// The true visible lines, each place once, and the error of ours.
  nlohmann::ordered_json truth(int threads) {
    const LineItems items(entered_.file);
    std::vector<LineId> ids;
    for (const LineName& line : entered_.lines) ids.push_back({line.item, line.corner});
    const std::vector<TrueLine> lines = true_lines(items, ids, threads);
    std::vector<VisiblePiece> seen;
    for (const LinePiece& piece : visible_pieces(lines)) {
      seen.push_back({piece.line.item, piece.line.corner, piece.from, piece.to});
    }
    std::vector<LinePiece> claimed;
    for (const VisiblePiece& piece : found(entered_, threads).pieces) {
      claimed.push_back({{piece.item, piece.corner}, piece.from, piece.to});
    }
    truth_ = drawn_once(drawing_of(*entered_.scene, seen), tolerance_);
    lines_ = drawing_of(*entered_.scene, entered_.lines);
    const LineErrors ours = compare_lines(items, lines, claimed);
    const double length = total_length(truth_);
    return {{"length", length}, {"ours", (ours.missing + ours.extra) / length}};
  }

  /// In shares of the true length.
  nlohmann::ordered_json errors(const LineDrawing& drawing) const {
    const double length = total_length(truth_);
    return {{"length", total_length(drawing) / length},
            {"missing", length_beside(truth_, drawing, tolerance_) / length},
            {"extra", length_beside(drawing, truth_, tolerance_) / length},
            {"off the lines", length_beside(drawing, lines_, tolerance_) / length}};
  }

  PeerScene scene_;
  LineKinds kinds_;
  EnteredMesh entered_;
  RetainedMesh retained_;
  double tolerance_ = 0.0;
  LineDrawing truth_, lines_;  ///< lines: whole, seen or not
};

void serve(const std::string& mesh, const std::string& view, const std::string& kinds,
           const std::filesystem::path& folder) {
  const PeerScene scene = scene_of(mesh, view);
  write_mesh(scene, folder / "mesh.obj");
  write_view(scene, folder / "view");
  OurLines ours(scene, line_kinds(kinds));
  std::cout << "peer: " << ours.ready() << std::endl;
  for (std::string line, word; std::getline(std::cin, line);) {
    std::istringstream words(line);
    words >> word;
    std::cout << "peer: " << ours.answer(word, words) << std::endl;
  }
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  using namespace displayfile::bench;
  try {
    if (argc == 5) {
      serve(argv[1], argv[2], argv[3], argv[4]);
      return 0;
    }
    for (const DegenerateMesh& mesh : degenerate_meshes()) {
      std::cout << nlohmann::ordered_json{{"scene", mesh.name}, {"what", mesh.what}} << "\n";
    }
    return 0;
  } catch (const std::exception& error) {
    std::cout << "peer: failed " << error.what() << std::endl;
    return 1;
  }
}
