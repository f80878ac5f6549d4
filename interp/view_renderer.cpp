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
  if (!is_image_space(request.method) || request.method == HiddenMethod::world_ray_cast) {
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
  SceneViewer viewer;
  SoftwareRenderer software;
  Picture picture;
};

ViewRenderer::ViewRenderer(const RetainedScene& scene, const DisplayFile& attributes)
    : kept_(std::make_unique<Kept>(Kept{SceneViewer(scene, attributes), {}, {}})) {}
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
    return draw_pixels(ViewSource(kept.viewer, view, lights_turned, options, kept.software),
                       request, options);
  });
  return kept.picture;
}

void ViewRenderer::draw(const View& view, const std::filesystem::path& file,
                        const DrawOptions& options, const glm::dmat3& lights_turned) {
  const RasterRequest request = raster_request_of_view(options);
  require_drawable(file, options);
  const SceneViewer& viewer = kept_->viewer;
  with_memory_of_drawing(viewer.bytes(), file, options, [&] {
    write_picture(ViewSource(kept_->viewer, view, lights_turned, options, kept_->software), request,
                  file, options);
  });
}

DisplayFile ViewRenderer::display_file(const View& view, const glm::dmat3& lights_turned) const {
  return kept_->viewer.display_file(view, lights_turned);
}

}  // namespace displayfile
