#include "programs/bench/moving_camera.h"

#include <algorithm>
#include <glm/mat4x4.hpp>
#include <vector>

#include "interp/opengl/osmesa.h"
#include "interp/truth/entered_truth.h"
#include "interp/truth/truth.h"
#include "programs/bench/application_mesh.h"
#include "programs/bench/counted_memory.h"
#include "programs/bench/indexed_triangles.h"
#include "programs/bench/new_views.h"
#include "programs/bench/opengl_mesh.h"

namespace displayfile::bench {

namespace {

/// As many views as there are, in the order of a turn.
void draw_all(const ApplicationMesh& mesh, NewViews& ours) {
  for (const View& view : mesh.views) ours.draw_new_view(view);
}

/// On one thread: what is held hangs on how several share the work.
void count_memory(const ApplicationMesh& mesh, const PictureSize& size, MovingCamera& found) {
  const auto triangles = static_cast<double>(found.triangles);
  counted_memory([&] {
    NewViews ours(mesh, size, 1);
    const auto scene = static_cast<double>(bytes_held_now());
    for (const View& view : mesh.views) ours.new_view(view);
    const auto viewed = static_cast<double>(bytes_held_now());
    std::size_t of_pixels = 0;
    for (const View& view : mesh.views) {
      const Picture& picture = ours.draw_new_view(view);
      of_pixels = picture.pixels.capacity() * sizeof(picture.pixels[0]);
    }
    const auto drawn = static_cast<double>(bytes_held_now());
    const auto of_picture = static_cast<double>(of_pixels);
    found.scene_bytes = scene / triangles;
    found.view_bytes = (viewed - scene) / triangles;
    found.drawing_bytes = (drawn - viewed - of_picture) / triangles;
  });
}

void count_wrong_pixels(const ApplicationMesh& mesh, const PictureSize& size, NewViews& ours,
                        MovingCamera& found) {
  for (const View& view : mesh.views) {
    const Picture right = truth_as_entered(ours.display_file(view), size.width, size.height, false);
    const Picture& drawn = ours.draw_items_of_new_view(view);
    for (std::size_t i = 0; i < right.ids.size(); ++i) {
      found.wrong_pixels += drawn.ids[i] != right.ids[i] ? 1 : 0;
    }
    ++found.views;
  }
}

/// In a hundred, at which the two pictures differ.
double other_pixels(const Picture& a, const Picture& b) {
  std::size_t others = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) others += a.pixels[i] != b.pixels[i];
  return 100.0 * static_cast<double>(others) / static_cast<double>(a.pixels.size());
}

/// The resident, indexed mesh, and a new matrix for each view.
void hold_against_osmesa(const ApplicationMesh& mesh, const PictureSize& size, int threads,
                         const Effort& effort, NewViews& ours, MovingCamera& found) {
  std::vector<glm::dmat4> matrices;
  for (const View& view : mesh.views) matrices.push_back(opengl_matrix(view, mesh));
  const IndexedTriangles indexed = indexed_triangles(mesh);
  OpenGlMesh opengl(indexed, {size, 24, mesh.back_faces_removed, pixel_of(Background{})});
  opengl.make_resident();
  for (std::size_t k = 0; k < mesh.views.size(); ++k) {
    opengl.set_matrix(matrices[k]);
    opengl.draw();
    found.other_pixels = std::max(
        found.other_pixels, other_pixels(opengl.picture(), ours.draw_new_view(mesh.views[k])));
  }
  const auto draw_all_by_osmesa = [&] {
    for (const glm::dmat4& matrix : matrices) {
      opengl.set_matrix(matrix);
      opengl.draw();
    }
  };
  found.beside_osmesa =
      warm_ratio(effort, threads, draw_all_by_osmesa, [&] { draw_all(mesh, ours); });
}

}  // namespace

MovingCamera move_camera(const BenchScene& scene, std::size_t first_polygons, int threads,
                         const Effort& effort) {
  const PictureSize size{scene.size, scene.size};
  const ApplicationMesh mesh = application_mesh(scene);
  MovingCamera found;
  found.triangles = mesh.triangles();
  count_memory(mesh, size, found);
  NewViews ours(mesh, size, threads);
  count_wrong_pixels(mesh, size, ours, found);
  if (first_polygons != 0) {
    BenchScene first_scene = scene;
    first_scene.n = first_polygons;
    const ApplicationMesh first_mesh = application_mesh(first_scene);
    NewViews first(first_mesh, size, threads);
    found.beside_first = warm_ratio(
        effort, threads, [&] { draw_all(first_mesh, first); }, [&] { draw_all(mesh, ours); });
  }
  if (osmesa_available()) hold_against_osmesa(mesh, size, threads, effort, ours, found);
  return found;
}

}  // namespace displayfile::bench
