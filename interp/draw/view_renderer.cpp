#include "interp/draw/view_renderer.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "clip/error.h"
#include "clip/round_to_nearest.h"
#include "displayfile/scene_viewer.h"
#include "displayfile/sorted_display_file.h"
#include "interp/device/raster_request.h"
#include "interp/draw/picture_checks.h"
#include "interp/draw/picture_source.h"
#include "interp/raster/software.h"
#include "interp/visibility/image_space.h"

namespace displayfile {

namespace {

/// A retained scene in a view. Throws Error for a method that does not draw one.
PicturePlan plan_of_view(const DrawOptions& options, const Destination* to = nullptr) {
  PicturePlan plan = resolve(options, to);
  plan.method = plan.surfaces.method;
  const HiddenMethod method = plan.method;
  const bool in_image_space =
      is_image_space(method) && surfaces_of(method) != HiddenMethod::world_ray_cast;
  if (!in_image_space && !finds_lines(method)) {
    throw Error(
        fmt::format("a view renderer finds hidden surfaces in image space, or lines, not by {}: "
                    "expected a method of image space or of lines",
                    name_of(method)));
  }
  if (!finds_lines(method)) require_scope_of_view(options);
  require_drawable_by(method, plan);
  require_hidden_lines_drawn(plan.surfaces.hidden_lines, method, plan);
  return plan;
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

  /// What draw(source, request, plan) returns, of the scene in that view.
  template <class Draw>
  auto in_view(const View& view, const glm::dmat3& lights_turned, PicturePlan plan,
               const Draw& draw) {
    bring_up_to_date();
    const RetainedScene& scene = viewer.scene();
    plan.surfaces.intersections = plan.surfaces.options.intersections = scene.has_intersections();
    RasterRequest request = raster_request(plan);
    if (finds_lines(plan.method)) {
      SortedDisplayFile lines;
      const DisplayFile& seen = lines.update(viewer.display_file(view, lights_turned), plan.method,
                                             plan.surfaces.options);
      request.sorted = has_exact_order(seen);
      if (plan.options.pens) lines_for_pens = seen;
      return draw(DisplayFileSource(seen, false, plan, software), request, plan);
    }
    return draw(ViewSource(viewer, view, lights_turned, plan, software,
                           casters_of_shadows(plan.options.threads)),
                request, plan);
  }
};

ViewRenderer::ViewRenderer(const RetainedScene& scene, const DisplayFile& attributes)
    : kept_(std::make_unique<Kept>(Kept{SceneViewer(scene, attributes)})) {}
ViewRenderer::~ViewRenderer() = default;
ViewRenderer::ViewRenderer(ViewRenderer&& other) noexcept = default;
ViewRenderer& ViewRenderer::operator=(ViewRenderer&& other) noexcept = default;

const Picture& ViewRenderer::draw(const View& view, const DrawOptions& options,
                                  const glm::dmat3& lights_turned) {
  const PicturePlan plan = plan_of_view(options);
  const BudgetInForce in_force(options.budget);
  Kept& kept = *kept_;
  kept.software.give_back(std::exchange(kept.picture, Picture()));
  kept.picture = with_memory_of_picture(
      plan, kept.software, [&] { return kept.in_view(view, lights_turned, plan, draw_pixels); });
  return kept.picture;
}

void ViewRenderer::draw(const View& view, const Destination& to, const DrawOptions& options,
                        const glm::dmat3& lights_turned) {
  const PicturePlan plan = plan_of_view(options, &to);
  require_writable(to, plan);
  const BudgetInForce in_force(options.budget);
  Kept& kept = *kept_;
  with_memory_of_drawing(kept.viewer.bytes(), to, plan, [&] {
    kept.in_view(view, lights_turned, plan,
                 [&](const PictureSource& source, const RasterRequest& request,
                     const PicturePlan& drawn) { write_picture(source, request, to, drawn); });
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
