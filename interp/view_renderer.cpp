#include "interp/view_renderer.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "clip/error.h"
#include "displayfile/scene_viewer.h"
#include "interp/picture_checks.h"
#include "interp/picture_source.h"
#include "interp/raster/software.h"
#include "interp/visibility/image_space.h"

namespace displayfile {

namespace {

/// A retained scene in a view. Throws Error for a method that does not draw one.
RasterRequest raster_request_of_view(const DrawOptions& options) {
  RasterRequest request = raster_request(options);
  request.method = options.hidden.value_or(HiddenMethod::automatic);
  if (!is_image_space(request.method) ||
      surfaces_of(request.method) == HiddenMethod::world_ray_cast) {
    throw Error(
        fmt::format("a view renderer finds hidden surfaces in image space, not by {}: "
                    "expected a method of image space",
                    name_of(request.method)));
  }
  if (options.precision && !options.precision->exact) {
    request.roundoff = options.precision->roundoff;
  }
  return request;
}

}  // namespace

struct ViewRenderer::Kept {
  const RetainedScene& scene;
  SceneViewer viewer;
  SoftwareRenderer software = {};
  std::unique_ptr<RetainedCasters> casters = nullptr;
  Picture picture = {};

  /// Null where no shadows are seen.
  RetainedCasters* casters_of_shadows(int threads) {
    if (viewer.shows_shadows() && casters == nullptr) {
      casters = std::make_unique<RetainedCasters>(scene, threads);
    }
    return casters.get();
  }
};

ViewRenderer::ViewRenderer(const RetainedScene& scene, const DisplayFile& attributes)
    : kept_(std::make_unique<Kept>(Kept{scene, SceneViewer(scene, attributes)})) {}
ViewRenderer::~ViewRenderer() = default;
ViewRenderer::ViewRenderer(ViewRenderer&& other) noexcept = default;
ViewRenderer& ViewRenderer::operator=(ViewRenderer&& other) noexcept = default;

const Picture& ViewRenderer::draw(const View& view, const DrawOptions& options,
                                  const glm::dmat3& lights_turned) {
  const RasterRequest request = raster_request_of_view(options);
  device_of(options.device);
  Kept& kept = *kept_;
  kept.software.give_back(std::exchange(kept.picture, Picture()));
  kept.picture = with_memory_of_picture(options, kept.software, [&] {
    const ViewSource source(kept.viewer, view, lights_turned, options, kept.software,
                            kept.casters_of_shadows(options.threads));
    return draw_pixels(source, request, options);
  });
  return kept.picture;
}

void ViewRenderer::draw(const View& view, const std::filesystem::path& file,
                        const DrawOptions& options, const glm::dmat3& lights_turned) {
  const RasterRequest request = raster_request_of_view(options);
  require_drawable(file, options);
  Kept& kept = *kept_;
  with_memory_of_drawing(kept.viewer.bytes(), file, options, [&] {
    const ViewSource source(kept.viewer, view, lights_turned, options, kept.software,
                            kept.casters_of_shadows(options.threads));
    write_picture(source, request, file, options);
  });
}

ViewRenderer::Made ViewRenderer::made() const {
  const RetainedCasters* const casters = kept_->casters.get();
  return {kept_->software.surfaces_found(), casters != nullptr ? 1u : 0u,
          casters != nullptr ? casters->lists_made() : 0u};
}

std::size_t ViewRenderer::bytes_of_casters() const {
  return kept_->casters == nullptr ? 0 : kept_->casters->bytes();
}

DisplayFile ViewRenderer::display_file(const View& view, const glm::dmat3& lights_turned) const {
  return kept_->viewer.display_file(view, lights_turned);
}

}  // namespace displayfile
