#include "programs/bench/new_views.h"

#include <optional>

#include "displayfile/retained_scene.h"
#include "displayfile/scene_viewer.h"
#include "interp/raster/software.h"

namespace displayfile::bench {

struct NewViews::Kept {
  RasterRequest request;
  RetainedScene scene;
  GraphicsSystem system;
  std::optional<SceneViewer> viewer;
  SoftwareRenderer renderer;
};

NewViews::NewViews(const ApplicationMesh& mesh, const PictureSize& size, int threads)
    : kept_(std::make_unique<Kept>()) {
  kept_->request.width = size.width;
  kept_->request.height = size.height;
  kept_->request.threads = threads;
  kept_->request.method = HiddenMethod::z_buffer;
  kept_->system.set_threads(threads);
  kept_->system.retain(&kept_->scene);
  enter(mesh, kept_->system);
  kept_->viewer.emplace(kept_->scene, kept_->system.display_file());
}

NewViews::~NewViews() = default;

const Picture& NewViews::draw_new_view(const View& view) {
  const PictureSize size{kept_->request.width, kept_->request.height};
  const ViewedScene& seen =
      kept_->viewer->view({.view = view, .centres_of = size, .threads = kept_->request.threads});
  return kept_->renderer.draw(seen, kept_->request);
}

}  // namespace displayfile::bench
