// New views of a retained scene, one after another, by NewViews.

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <vector>

#include "interp/opengl/osmesa.h"
#include "interp/truth/entered_truth.h"
#include "interp/truth/truth.h"
#include "tests/bench/command/application_mesh.h"
#include "tests/bench/command/beside.h"
#include "tests/bench/command/contenders.h"
#include "tests/bench/command/counted_memory.h"
#include "tests/bench/command/indexed_triangles.h"
#include "tests/bench/command/new_views.h"
#include "tests/bench/command/opengl_mesh.h"

namespace displayfile::bench {

namespace {

/// As many views as there are, in the order of a turn.
void draw_all(const ApplicationMesh& mesh, NewViews& ours) {
  for (const View& view : mesh.views) ours.draw_new_view(view);
}

/// Bytes a triangle, of the retained scene, of the data that viewing keeps after a turn of all
/// views, and of those that drawing keeps besides, without the picture. On one thread: with
/// several, memory depends on how they share the work.
void count_memory(const ApplicationMesh& mesh, Comparison& comparison) {
  const PictureSize size{comparison.task().scene.size, comparison.task().scene.size};
  std::array<std::int64_t, 3> held{};  // beyond the memory held before it
  counted_memory([&] {
    NewViews ours(mesh, size, 1);
    held[0] = bytes_held_now();
    for (const View& view : mesh.views) ours.new_view(view);
    held[1] = bytes_held_now() - held[0];
    std::size_t of_picture = 0;
    for (const View& view : mesh.views) {
      const auto& pixels = ours.draw_new_view(view).pixels;
      of_picture = pixels.capacity() * sizeof(pixels[0]);
    }
    held[2] = bytes_held_now() - held[0] - held[1] - static_cast<std::int64_t>(of_picture);
  });
  const auto triangles = static_cast<double>(mesh.triangles());
  comparison.count("bytes a triangle", "retained scene", static_cast<double>(held[0]) / triangles);
  comparison.count("bytes a triangle", "view", static_cast<double>(held[1]) / triangles);
  comparison.count("bytes a triangle", "drawing", static_cast<double>(held[2]) / triangles);
}

std::size_t wrong_pixels(const ApplicationMesh& mesh, const PictureSize& size, NewViews& ours) {
  std::size_t wrong = 0;
  for (const View& view : mesh.views) {
    const Picture right = truth_as_entered(ours.display_file(view), size.width, size.height, false);
    const Picture& drawn = ours.draw_items_of_new_view(view);
    for (std::size_t i = 0; i < right.ids.size(); ++i) wrong += drawn.ids[i] != right.ids[i];
  }
  return wrong;
}

/// In a hundred, at which the two pictures differ.
double other_pixels(const Picture& a, const Picture& b) {
  std::size_t others = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) others += a.pixels[i] != b.pixels[i];
  return 100.0 * static_cast<double>(others) / static_cast<double>(a.pixels.size());
}

/// The resident, indexed mesh, and a new matrix for each view.
void compare_with_osmesa(const ApplicationMesh& mesh, const PictureSize& size, NewViews& ours,
                         Comparison& comparison) {
  std::vector<glm::dmat4> matrices;
  for (const View& view : mesh.views) matrices.push_back(opengl_matrix(view, mesh));
  const IndexedTriangles indexed = indexed_triangles(mesh);
  OpenGlMesh opengl(indexed, {size, 24, mesh.back_faces_removed, pixel_of(Background{})});
  opengl.make_resident();
  double others = 0.0;
  for (std::size_t k = 0; k < mesh.views.size(); ++k) {
    opengl.set_matrix(matrices[k]);
    opengl.draw();
    others = std::max(others, other_pixels(opengl.picture(), ours.draw_new_view(mesh.views[k])));
  }
  comparison.time(
      "OSMesa", "moving camera", [&] { draw_all(mesh, ours); },
      [&] {
        for (const glm::dmat4& matrix : matrices) {
          opengl.set_matrix(matrix);
          opengl.draw();
        }
      });
  comparison.count("OSMesa", "pixels that differ, %", others);
}

}  // namespace

void compare_new_views(Comparison& comparison) {
  const BesideTask& task = comparison.task();
  const PictureSize size{task.scene.size, task.scene.size};
  try {
    const ApplicationMesh mesh = application_mesh(task.scene);
    comparison.count("OSMesa", "triangles", static_cast<double>(mesh.triangles()));
    count_memory(mesh, comparison);
    NewViews ours(mesh, size, task.threads);
    comparison.count("truth", "views", static_cast<double>(mesh.views.size()));
    comparison.count("truth", "wrong pixels", static_cast<double>(wrong_pixels(mesh, size, ours)));
    if (task.first_polygons != 0) {
      BenchScene first_scene = task.scene;
      first_scene.n = task.first_polygons;
      const ApplicationMesh first_mesh = application_mesh(first_scene);
      NewViews first(first_mesh, size, task.threads);
      comparison.time(
          "fewest polygons", "moving camera", [&] { draw_all(mesh, ours); },
          [&] { draw_all(first_mesh, first); });
    }
    if (osmesa_available()) compare_with_osmesa(mesh, size, ours, comparison);
  } catch (const CannotDraw& reason) {
    comparison.leave_out("OSMesa", "moving camera", reason.why);
  }
}

}  // namespace displayfile::bench
