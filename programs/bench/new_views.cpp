#include "programs/bench/new_views.h"

#include <optional>

#include "displayfile/retained_scene.h"
#include "interp/raster/software.h"
#include "interp/world_views.h"

namespace displayfile::bench {

struct NewViews::Kept {
  RasterRequest request;
  RetainedScene scene;
  GraphicsSystem system;
  std::optional<WorldViews> views;
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
  kept_->views.emplace(kept_->scene, kept_->system.display_file());
}

NewViews::~NewViews() = default;

const Picture& NewViews::draw_new_view(const View& view) {
  return kept_->renderer.draw(kept_->views->view(view).display_file, kept_->request);
}

}  // namespace displayfile::bench
