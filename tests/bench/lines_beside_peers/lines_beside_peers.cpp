// Hidden lines beside Blender's Line Art and OpenCASCADE's hidden-line removal: time and error, of
// the same meshes in the same views (README.md).
//   lines_beside_peers [MESH...] [--degenerate]
// Prints ratios, and shares of lengths; run it on a machine that does nothing else.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clip/error.h"
#include "hidden/lines/intersection_lines.h"
#include "hidden/lines/visible_lines.h"
#include "interp/truth/true_lines.h"
#include "programs/bench/temporary_folder.h"
#include "programs/bench/timing.h"
#include "tests/bench/command_line.h"
#include "tests/bench/lines_beside_peers/degenerate_meshes.h"
#include "tests/bench/lines_beside_peers/drawn_length.h"
#include "tests/bench/lines_beside_peers/peer_process.h"
#include "tests/bench/lines_beside_peers/peer_scene.h"
#include "tests/bench/result_table.h"

namespace displayfile::bench {
namespace {

constexpr const char* kLineArt = "Line Art";
constexpr const char* kPolygonal = "OCCT polygonal";
constexpr const char* kExact = "OCCT exact";

struct Options {
  std::vector<std::string> meshes;
  bool degenerate = false;
  std::vector<std::string> kinds = {"outline,crease", "all", "all,intersection"};
  std::vector<std::string> views = {"perspective", "parallel"};
  std::vector<std::string> peers = {kLineArt, kPolygonal, kExact};
  std::vector<int> threads = {1, 2};
  int rounds = 5;
  double limit = 120.0, tolerance = 1e-6;
  std::string blender = "blender", line_art_options = "use_back_face_culling=1";
};

/// Which peer, of what.
struct Task {
  const PeerScene& scene;
  LineKinds kinds;
  std::string peer;
  int threads;
};

/// OpenCASCADE's has one thread, takes parallel views, and all edges alone are the same as ours.
bool takes(const Task& task) {
  if (task.peer == kLineArt) return true;
  return task.threads == 1 && task.kinds.all && !task.kinds.intersection &&
         task.scene.view.projection == View::Projection::parallel;
}

/// A peer that has the scene.
class Peer {
 public:
  Peer(const Task& task, const Options& options)
      : view_(task.scene.view),
        is_line_art_(task.peer == kLineArt),
        clock_(task.threads == 1 ? "processor" : "wall"),
        process_((write_mesh(task.scene, folder_.file("mesh.obj")),
                  write_view(task.scene, folder_.file("view")), command(task, options)),
                 options.limit) {}

  double seconds() { return std::stod(process_.ask("round " + clock_, "seconds")); }
  LineDrawing drawing() {
    const std::string path = folder_.file("segments");
    process_.ask("segments " + path, "segments");
    return is_line_art_ ? read_world_segments(path, view_) : read_view_plane_segments(path, view_);
  }

 private:
  std::vector<std::string> command(const Task& task, const Options& options) const {
    const std::string mesh = folder_.file("mesh.obj"), view = folder_.file("view");
    if (is_line_art_) {
      return {options.blender,
              "--background",
              "--threads",
              std::to_string(task.threads),
              "--factory-startup",
              "--python",
              DISPLAYFILE_LINE_ART,
              "--",
              mesh,
              view,
              task.kinds.words,
              options.line_art_options};
    }
    const auto ours = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    return {ours / "occt_lines", mesh, view, task.peer == kExact ? "exact" : "polygonal"};
  }

  TemporaryFolder folder_;
  View view_;
  bool is_line_art_;
  std::string clock_;
  PeerProcess process_;
};

SeenLines found(const EnteredMesh& entered, int threads) {
  const Primitives items = entered.scene->primitives();
  std::vector<IntersectionLine> intersections;
  if (entered.intersections) intersections = intersection_lines(items, threads);
  return visible_lines(items, entered.lines, HiddenMethod::franklin,
                       {.precision = {}, .threads = threads}, intersections);
}

/// The least of several rounds, the peer's over ours.
struct Times {
  double from_mesh, new_view, hiding;
};
Times times(const Task& task, Peer& peer, int rounds) {
  const Clock clock = clock_of(task.threads);
  double theirs = peer.seconds();  // the first warms up
  double from_mesh = 0.0, new_view = 0.0, hiding = 0.0;
  RetainedMesh retained(task.scene, task.kinds);
  for (int i = 0; i <= rounds; ++i) {
    const double mesh_and_lines =
        seconds_each(clock, 1, [&] { found(enter(task.scene, task.kinds), task.threads); });
    retained.look_elsewhere();
    const double view = seconds_each(clock, 1, [&] { retained.draw(task.threads); });
    const EnteredMesh entered = enter(task.scene, task.kinds);
    const double lines = seconds_each(clock, 1, [&] { found(entered, task.threads); });
    const double peers = peer.seconds();
    from_mesh = i <= 1 ? mesh_and_lines : std::min(from_mesh, mesh_and_lines);
    new_view = i <= 1 ? view : std::min(new_view, view);
    hiding = i <= 1 ? lines : std::min(hiding, lines);
    theirs = i <= 1 ? peers : std::min(theirs, peers);
  }
  return {theirs / from_mesh, theirs / new_view, theirs / hiding};
}

/// What should be seen, and how wrong ours is.
struct Truth {
  LineDrawing drawing;  ///< each place once
  LineDrawing lines;    ///< whole
  double length = 0.0;  ///< of the drawing
  LineErrors ours;
};
Truth truth_of(const PeerScene& scene, const LineKinds& kinds, const Options& options) {
  const EnteredMesh entered = enter(scene, kinds);
  const LineItems items(entered.file);
  std::vector<LineId> ids;
  for (const LineName& line : entered.lines) ids.push_back({line.item, line.corner});
  const int threads = *std::ranges::max_element(options.threads);
  const std::vector<TrueLine> lines = true_lines(items, ids, threads);
  std::vector<VisiblePiece> seen;
  for (const LinePiece& piece : visible_pieces(lines)) {
    seen.push_back({piece.line.item, piece.line.corner, piece.from, piece.to});
  }
  std::vector<LinePiece> claimed;
  for (const VisiblePiece& piece : found(entered, threads).pieces) {
    claimed.push_back({{piece.item, piece.corner}, piece.from, piece.to});
  }
  Truth truth;
  truth.drawing = drawn_once(drawing_of(*entered.scene, seen), options.tolerance);
  truth.lines = drawing_of(*entered.scene, entered.lines);
  truth.length = total_length(truth.drawing);
  truth.ours = compare_lines(items, lines, claimed);
  return truth;
}

/// In shares of the true length.
struct Errors {
  double length, missing, extra, off_lines;
};
Errors errors_of(const LineDrawing& all, const Truth& truth, double tolerance) {
  const LineDrawing drawing = drawn_once(all, tolerance);
  return {total_length(drawing) / truth.length,
          length_beside(truth.drawing, drawing, tolerance) / truth.length,
          length_beside(drawing, truth.drawing, tolerance) / truth.length,
          length_beside(drawing, truth.lines, tolerance) / truth.length};
}

std::string share(double x) { return x == 0.0 ? "0" : fmt::format("{:.2g}", x); }

/// The columns of a peer: how many times as long it takes, and how wrong it is.
std::vector<std::string> beside(const Task& task, const std::optional<Truth>& truth,
                                const Options& options) {
  try {
    Peer peer(task, options);
    const Times ratio = times(task, peer, options.rounds);
    std::vector<std::string> columns{fmt::format("{:.2f}", ratio.from_mesh),
                                     fmt::format("{:.2f}", ratio.new_view),
                                     fmt::format("{:.2f}", ratio.hiding)};
    if (!truth) return columns;
    const Errors errors = errors_of(peer.drawing(), *truth, options.tolerance);
    columns.push_back(share((truth->ours.missing + truth->ours.extra) / truth->length));
    columns.push_back(fmt::format("{:.6f}", errors.length));
    for (const double x : {errors.missing, errors.extra, errors.off_lines}) {
      columns.push_back(share(x));
    }
    return columns;
  } catch (const PeerStopped& why) {
    return {why.what()};
  }
}

std::vector<PeerScene> views_of(const std::string& path, const Options& options) {
  const Mesh mesh = read_mesh(path);
  std::vector<PeerScene> scenes;
  for (const std::string& view : options.views) {
    Camera camera;
    camera.parallel = view != "perspective";
    if (view == "front") camera.eye = EyeDirection{0.0, 0.0};
    scenes.push_back(peer_scene(std::filesystem::path(path).stem().string(), view, mesh, camera));
  }
  return scenes;
}

void print_meshes(const Options& options) {
  const std::vector<std::string> heads{"mesh",
                                       "view",
                                       "lines",
                                       "how many",
                                       "threads",
                                       "peer",
                                       "times as long, from the mesh",
                                       "new view",
                                       "hiding",
                                       "ours wrong",
                                       "length",
                                       "missing",
                                       "extra",
                                       "off the lines"};
  std::vector<std::vector<std::string>> rows;
  for (const std::string& path : options.meshes) {
    for (const PeerScene& scene : views_of(path, options)) {
      for (const std::string& words : options.kinds) {
        const LineKinds kinds = line_kinds(words);
        std::optional<Truth> truth;
        if (!kinds.intersection) truth = truth_of(scene, kinds, options);
        const std::size_t lines = truth ? truth->lines.size() : enter(scene, kinds).lines.size();
        for (const int threads : options.threads) {
          for (const std::string& peer : options.peers) {
            const Task task{scene, kinds, peer, threads};
            if (!takes(task)) continue;
            std::vector<std::string> row{
                scene.name, scene.seen_from, words, std::to_string(lines), std::to_string(threads),
                peer};
            const auto columns = beside(task, truth, options);
            row.insert(row.end(), columns.begin(), columns.end());
            row.resize(heads.size());
            rows.push_back(row);
            fmt::print(stderr, "{}\n", fmt::join(row, " | "));
          }
        }
      }
    }
  }
  fmt::print("{}", text_table(heads, rows));
}

/// Missing and extra together, as a share of the true length.
std::string wrong_length(const Task& task, const Truth& truth, const Options& options) {
  try {
    const Errors errors = errors_of(Peer(task, options).drawing(), truth, options.tolerance);
    return share(errors.missing + errors.extra);
  } catch (const PeerStopped& why) {
    return why.what();
  }
}

/// Line Art's back faces stay: these scenes have open sheets.
void print_degenerate(Options options) {
  options.line_art_options.clear();
  std::vector<std::string> heads{"scene", "what", "faces", "length", "ours"};
  heads.insert(heads.end(), options.peers.begin(), options.peers.end());
  std::vector<std::vector<std::string>> rows;
  for (const DegenerateMesh& mesh : degenerate_meshes()) {
    const PeerScene scene = mesh.make();
    const LineKinds kinds = line_kinds("all");
    const Truth truth = truth_of(scene, kinds, options);
    std::vector<std::string> row{std::string(mesh.name), std::string(mesh.what),
                                 std::to_string(scene.mesh.faces()),
                                 fmt::format("{:.2f}", truth.length),
                                 share((truth.ours.missing + truth.ours.extra) / truth.length)};
    for (const std::string& peer : options.peers) {
      row.push_back(wrong_length({scene, kinds, peer, 1}, truth, options));
    }
    rows.push_back(row);
  }
  fmt::print("{}", text_table(heads, rows));
}

void run(const Options& options) {
  fmt::print(
      "Errors are shares of the true length; of peers, what is farther than {:g} of the "
      "picture from where it should be.\n\n",
      options.tolerance);
  if (!options.meshes.empty()) print_meshes(options);
  if (options.degenerate) print_degenerate(options);
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  displayfile::bench::Options options;
  CLI::App app("Hidden lines beside Blender's Line Art and OpenCASCADE", "lines_beside_peers");
  app.add_option("meshes", options.meshes, "meshes")->check(CLI::ExistingFile);
  app.add_flag("--degenerate", options.degenerate, "the table of degenerate meshes");
  app.add_option("--kinds", options.kinds, "all; outline,crease; all,intersection; again for more")
      ->delimiter('\0');
  app.add_option("--views", options.views, "perspective, parallel, front")->delimiter(',');
  app.add_option("--peers", options.peers, "Line Art, OCCT polygonal, OCCT exact")->delimiter(',');
  app.add_option("--threads", options.threads)->delimiter(',')->check(CLI::Range(1, 1024));
  app.add_option("--rounds", options.rounds)->check(CLI::Range(1, 1000));
  app.add_option("--limit", options.limit, "seconds that a peer may take for a round");
  app.add_option("--tolerance", options.tolerance, "of the picture, of peers' lines");
  app.add_option("--blender", options.blender, "the program");
  app.add_option("--line-art", options.line_art_options,
                 "NAME=VALUE,... of the modifier, for meshes");
  return displayfile::bench::parsed_and_run(app, argc, argv,
                                            [&] { displayfile::bench::run(options); });
}
