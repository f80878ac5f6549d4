#include "interp/view_renderer.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "clip/error.h"
#include "clip/round_to_nearest.h"
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
  const bool in_image_space =
      is_image_space(request.method) && surfaces_of(request.method) != HiddenMethod::world_ray_cast;
  if (!in_image_space && !finds_lines(request.method)) {
    throw Error(
        fmt::format("a view renderer finds hidden surfaces in image space, or lines, not by {}: "
                    "expected a method of image space or of lines",
                    name_of(request.method)));
  }
  if (!finds_lines(request.method)) require_scope_of_view(options);
  require_drawable_by(request.method, options);
  require_hidden_lines_drawn(options.hidden_lines.value_or(HiddenLines::none), request.method,
                             options);
  if (options.precision && !options.precision->exact) {
    request.roundoff = options.precision->roundoff;
  }
  return request;
}

}  // namespace

struct ViewRenderer::Kept {
  SceneViewer viewer;
  SoftwareRenderer software = {};
  std::unique_ptr<RetainedCasters> casters = nullptr;
  std::size_t caster_trees = 0, caster_lists = 0;  // that were made; lists of former casters
  Picture picture = {};
  DisplayFile lines_for_pens = {};

  /// The casters are those of the scene as it was.
  void bring_up_to_date() {
    if (!viewer.bring_up_to_date() || casters == nullptr) return;
    caster_lists += casters->lists_made();
    casters.reset();
  }

  /// Null where no shadows are seen.
  RetainedCasters* casters_of_shadows(int threads) {
    if (viewer.shows_shadows() && casters == nullptr) {
      casters = std::make_unique<RetainedCasters>(viewer.scene(), threads);
      ++caster_trees;
    }
    return casters.get();
  }

  /// What draw(source, request) returns, of the scene in that view.
  template <class Draw>
  auto in_view(const View& view, const glm::dmat3& lights_turned, const DrawOptions& options,
               RasterRequest request, const Draw& draw) {
    bring_up_to_date();
    const RetainedScene& scene = viewer.scene();
    if (finds_lines(request.method)) {
      SortedDisplayFile lines;
      HiddenSurfaceOptions asked = hidden_surface_options(options);
      asked.intersections = scene.has_intersections();
      const DisplayFile& seen =
          lines.update(viewer.display_file(view, lights_turned), request.method, asked);
      request.sorted = has_exact_order(seen);
      if (options.pens) lines_for_pens = seen;
      return draw(DisplayFileSource(seen, false, options, software), request);
    }
    request.hidden_lines = options.hidden_lines.value_or(HiddenLines::none);
    request.intersections = scene.has_intersections();
    return draw(ViewSource(viewer, view, lights_turned, options, software,
                           casters_of_shadows(options.threads)),
                request);
  }
};

ViewRenderer::ViewRenderer(const RetainedScene& scene, const DisplayFile& attributes)
    : kept_(std::make_unique<Kept>(Kept{SceneViewer(scene, attributes)})) {}
ViewRenderer::~ViewRenderer() = default;
ViewRenderer::ViewRenderer(ViewRenderer&& other) noexcept = default;
ViewRenderer& ViewRenderer::operator=(ViewRenderer&& other) noexcept = default;

const Picture& ViewRenderer::draw(const View& view, const DrawOptions& options,
                                  const glm::dmat3& lights_turned) {
  const RasterRequest request = raster_request_of_view(options);
  device_of(options.device);
  const BudgetInForce in_force(options.budget);
  Kept& kept = *kept_;
  kept.software.give_back(std::exchange(kept.picture, Picture()));
  kept.picture = with_memory_of_picture(options, kept.software, [&] {
    return kept.in_view(view, lights_turned, options, request,
                        [&](const PictureSource& source, const RasterRequest& asked) {
                          return draw_pixels(source, asked, options);
                        });
  });
  return kept.picture;
}

void ViewRenderer::draw(const View& view, const Destination& to, const DrawOptions& options,
                        const glm::dmat3& lights_turned) {
  const RasterRequest request = raster_request_of_view(options);
  require_drawable(to, options);
  const BudgetInForce in_force(options.budget);
  Kept& kept = *kept_;
  with_memory_of_drawing(kept.viewer.bytes(), to, options, [&] {
    kept.in_view(view, lights_turned, options, request,
                 [&](const PictureSource& source, const RasterRequest& asked) {
                   write_picture(source, asked, to, options);
                 });
  });
}

Picture ViewRenderer::take_picture() { return std::exchange(kept_->picture, Picture()); }

void ViewRenderer::give_back(Picture picture) { kept_->picture = std::move(picture); }

const DisplayFile& ViewRenderer::lines_for_pens() const { return kept_->lines_for_pens; }

ViewRenderer::Made ViewRenderer::made() const {
  const RetainedCasters* const casters = kept_->casters.get();
  return {kept_->software.surfaces_found(), kept_->caster_trees,
          kept_->caster_lists + (casters != nullptr ? casters->lists_made() : 0u)};
}

std::size_t ViewRenderer::bytes_of_casters() const {
  return kept_->casters == nullptr ? 0 : kept_->casters->bytes();
}

DisplayFile ViewRenderer::display_file(const View& view, const glm::dmat3& lights_turned) const {
  const RoundToNearest nearest;
  return kept_->viewer.display_file(view, lights_turned);
}

}  // namespace displayfile
