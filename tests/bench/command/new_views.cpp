#include "tests/bench/command/new_views.h"

#include <optional>

#include "displayfile/segments/retained_scene.h"
#include "displayfile/user_routines/system_inside.h"
#include "displayfile/views/scene_viewer.h"
#include "interp/device/raster_request.h"
#include "interp/raster/software.h"

namespace displayfile::bench {

struct NewViews::Kept {
  RasterRequest request;
  RetainedScene scene;
  GraphicsSystem system;
  std::optional<SceneViewer> viewer;
  SoftwareRenderer renderer;

  SceneViewer& made_ready() {
    if (!viewer) viewer.emplace(scene, system.display_file());
    return *viewer;
  }
};

NewViews::NewViews(const ApplicationMesh& mesh, const PictureSize& size, int threads)
    : kept_(std::make_unique<Kept>()) {
  kept_->request.width = size.width;
  kept_->request.height = size.height;
  kept_->request.surfaces.threads = threads;
  kept_->request.surfaces.method = HiddenMethod::z_buffer;
  kept_->system.set_threads(threads);
  SystemInside::retain_alone(kept_->system, kept_->scene);
  enter(mesh, kept_->system);
}

NewViews::~NewViews() = default;

const ViewedScene& NewViews::new_view(const View& view) {
  const PictureSize size{kept_->request.width, kept_->request.height};
  return kept_->made_ready().view(
      {.view = view, .centres_of = size, .threads = kept_->request.surfaces.threads});
}

const Picture& NewViews::draw_new_view(const View& view) {
  return kept_->renderer.draw(new_view(view), kept_->request);
}

const Picture& NewViews::draw_items_of_new_view(const View& view) {
  RasterRequest with_ids = kept_->request;
  with_ids.ids = true;
  return kept_->renderer.draw(new_view(view), with_ids);
}

DisplayFile NewViews::display_file(const View& view) {
  return kept_->made_ready().display_file(view);
}

}  // namespace displayfile::bench
