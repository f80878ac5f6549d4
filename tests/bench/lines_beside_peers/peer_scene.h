#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clip/view.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"
#include "displayfile/segments/viewed_scene.h"
#include "displayfile/views/scene_viewer.h"
#include "hidden/lines/visible_lines.h"
#include "hidden/sort/hidden_surface_sort.h"
#include "tests/bench/lines_beside_peers/drawn_length.h"

namespace displayfile::bench {

/// The kinds of lines of a mesh that are requested.
struct LineKinds {
  std::string words;  ///< as the peers get them
  bool all = false, outline = false, crease = false, intersection = false;
};
/// Reads kinds joined by commas: all, outline, crease, intersection. Throws Error for another.
LineKinds line_kinds(const std::string& words);

/// An edge is a crease where its faces' normals are farther apart than this, in degrees.
inline constexpr double kCreaseDegrees = 30.0;

/// A mesh in a view, the same for us and for the peers: its coordinates are single, its faces flat.
struct PeerScene {
  std::string name, seen_from;
  Mesh mesh;
  View view;
};
/// The mesh in triangles, its vertices rounded to single precision, in a view fitted to it.
PeerScene peer_scene(std::string name, std::string seen_from, const Mesh& mesh,
                     const Camera& camera);

/// Writes the peers' input (README.md): the mesh as OBJ, the view as words.
void write_mesh(const PeerScene& scene, const std::string& path);
void write_view(const PeerScene& scene, const std::string& path);

/// A mesh entered for methods of hidden lines.
struct EnteredMesh {
  DisplayFile file;
  std::unique_ptr<ViewedScene> scene;
  std::vector<LineName> lines;  ///< of the requested kinds, each shared one once
  bool intersections;           ///< are requested, too
};
EnteredMesh enter(const PeerScene& scene, const LineKinds& kinds);

/// The mesh retained, with the requested kinds of lines: each view is drawn from there.
class RetainedMesh {
 public:
  RetainedMesh(const PeerScene& scene, const LineKinds& kinds);
  /// The line drawing of the scene's view, in chains: as a view renderer finds it.
  SortedPieces draw(int threads);
  /// Draws another view, so that nothing is left of the previous one.
  void look_elsewhere();

 private:
  View view_;
  bool intersections_;
  RetainedScene retained_;
  GraphicsSystem system_;
  std::optional<SceneViewer> viewer_;
};

/// Reads a peer's output: segments' ends in world or view-plane coordinates, transformed to the
/// picture. Throws Error if the file cannot be read.
LineDrawing read_world_segments(const std::string& path, const View& view);
LineDrawing read_view_plane_segments(const std::string& path, const View& view);

/// Pieces of lines, by the parts of them that are seen.
LineDrawing drawing_of(const ViewedScene& scene, std::span<const VisiblePiece> pieces);
LineDrawing drawing_of(const ViewedScene& scene, std::span<const LineName> lines);

}  // namespace displayfile::bench
