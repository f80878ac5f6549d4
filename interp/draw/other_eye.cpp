#include "interp/draw/other_eye.h"

#include <optional>
#include <tuple>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "clip/view/view_volume.h"
#include "displayfile/files.h"
#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/text/program_in_view.h"
#include "displayfile/views/scene_in_one_view.h"
#include "displayfile/views/taken_scene.h"
#include "interp/draw/drawing_choice.h"
#include "interp/draw/picture_plan.h"
#include "interp/draw/renderer.h"
#include "interp/visibility/image_space.h"

namespace displayfile {

namespace {

/// The settings on which pictures depend besides the scene.
auto settings_of(const GraphicsSystem& system) {
  return std::tuple(system.hidden_surfaces().removal, system.hidden_surfaces().z_buffer,
                    system.hidden_surfaces().method, system.hidden_surfaces().scope,
                    system.hidden_surfaces().precision, system.hidden_surfaces().hidden_lines,
                    system.hidden_surfaces().line_order, system.hidden_surfaces().line_halo,
                    system.hidden_surfaces().lines, system.looks().background,
                    system.aspect_ratio());
}

}  // namespace

struct OtherEye::Kept {
  const GraphicsSystem& told;
  const DisplayFile* file;
  TakenScene taken;
  decltype(settings_of(std::declval<const GraphicsSystem&>())) settings;
  std::string program;
  View drawn_in, view;
  Renderer renderer = {};
  std::optional<GraphicsSystem> replayed = std::nullopt;

  /// Throws Error if the system has changed, since the recorded program is then outdated.
  void require_same() const {
    const bool is_there = !taken.is_gone() && &taken.attributes() == file;
    if (is_there && taken.is_same() && settings_of(told) == settings) return;
    throw Error(
        "another eye, and the system has changed since it was made: expected a new one, with what "
        "was recorded since");
  }
};

OtherEye::OtherEye(const GraphicsSystem& system, const RetainedScene& scene, std::string program) {
  const DisplayFile& file = system.display_file();
  const View view = scene_in_one_view(scene, file, system.view()).view;
  TakenScene taken(scene, file);
  taken.take();
  kept_ = std::make_unique<Kept>(
      Kept{system, &file, std::move(taken), settings_of(system), std::move(program), view, view});
}
OtherEye::OtherEye(OtherEye&& other) noexcept = default;
OtherEye& OtherEye::operator=(OtherEye&& other) noexcept = default;
OtherEye::~OtherEye() = default;

const View& OtherEye::as_drawn() const { return kept_->drawn_in; }

void OtherEye::set_view(const View& view) {
  if (view == kept_->view) return;
  const RoundToNearest nearest;
  const ViewVolume fits(view);
  kept_->view = view;
  kept_->replayed.reset();
}

const GraphicsSystem& OtherEye::system() {
  Kept& kept = *kept_;
  kept.require_same();
  if (!kept.replayed) {
    GraphicsSystem replayed;
    replayed.set_aspect_ratio(kept.told.aspect_ratio());
    replay(program(), "the drawing program", replayed);
    kept.replayed = std::move(replayed);
  }
  return *kept.replayed;
}

std::string OtherEye::program() const {
  kept_->require_same();
  return program_in_view(kept_->program, kept_->view);
}

bool OtherEye::draws(const DrawOptions& options) const {
  const HiddenMethod method = drawing_method(kept_->told, options);
  return !kept_->told.counts().has_hatching && is_image_space(method) &&
         surfaces_of(method) != HiddenMethod::world_ray_cast &&
         resolve(options).is_on_first_device();
}

const Picture& OtherEye::draw(const DrawOptions& options) {
  Kept& kept = *kept_;
  kept.require_same();
  return kept.renderer.draw(in_view(kept.told, kept.view), options);
}

}  // namespace displayfile
