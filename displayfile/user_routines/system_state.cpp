#include "displayfile/user_routines/system_state.h"

#include <utility>

#include "clip/base/round_to_nearest.h"
#include "displayfile/user_routines/system_inside.h"

namespace displayfile {

GraphicsSystem::GraphicsSystem() : state_(std::make_unique<State>()) {}
GraphicsSystem::GraphicsSystem(const GraphicsSystem& other)
    : state_(std::make_unique<State>(*other.state_)) {}
GraphicsSystem::GraphicsSystem(GraphicsSystem&& other) noexcept = default;
GraphicsSystem::~GraphicsSystem() = default;

// Assigns in place if there is a state: others may refer to its display file.
GraphicsSystem& GraphicsSystem::operator=(const GraphicsSystem& other) {
  if (this == &other) return *this;
  return *this = GraphicsSystem(other);
}
GraphicsSystem& GraphicsSystem::operator=(GraphicsSystem&& other) noexcept {
  if (this == &other) return *this;
  if (state_ == nullptr) {
    state_ = std::move(other.state_);
  } else {
    *state_ = std::move(*other.state_);
  }
  return *this;
}

// Settings and counts.

const View& GraphicsSystem::view() const { return state_->view_; }
double GraphicsSystem::aspect_ratio() const { return state_->windows_.aspect(); }
const ModellingTransformation& GraphicsSystem::modelling_transformation() const {
  return state_->modelling_;
}
std::optional<int> GraphicsSystem::open_segment_name() const { return state_->open_; }
const DisplayFile& GraphicsSystem::display_file() const { return state_->display_file_; }
const Looks& GraphicsSystem::looks() const { return state_->looks_; }
const RetainedScene* GraphicsSystem::retained() const { return state_->retained(); }
const ExplicitSettings& GraphicsSystem::explicit_settings() const { return state_->explicit_; }
SystemCounts GraphicsSystem::counts() const {
  return {.polygons = state_->ordinal_,
          .triangulated = state_->triangulated_,
          .solids_open = state_->solids_.depth(),
          .empty_solids = state_->empty_solids_,
          .transformations_saved = state_->modelling_.saved(),
          .has_hatching = state_->has_hatching_,
          .stretched_window = state_->windows_.stretched()};
}

// Work and records.

void GraphicsSystem::set_threads(int threads) { state_->surfaces_.threads = threads; }
void GraphicsSystem::set_progress(WorkProgress progress) {
  state_->surfaces_.progress = std::move(progress);
}
void GraphicsSystem::set_recorder(Recorder* recorder) {
  state_->recorder_ = recorder;
  if (recorder == nullptr || recorder == state_->last_recorder_) return;
  state_->last_recorder_ = recorder;
  state_->recorded_annotation_ = {};
}

const CuttingPlanes& SystemInside::cutting_planes(const GraphicsSystem& system) {
  return system.state_->cutting_planes_;
}

const PlaneUses& SystemInside::plane_uses(const GraphicsSystem& system) {
  return system.state_->plane_uses_;
}

bool SystemInside::is_all_in_view(const GraphicsSystem& system) {
  return system.state_->is_all_in_view_;
}

void SystemInside::comment(GraphicsSystem& system, std::string_view text) {
  if (Recorder* const recorder = system.state_->recorder_) recorder->comment(text);
}

void SystemInside::by_default(GraphicsSystem& system, Setting setting,
                              const std::function<void()>& set) {
  ExplicitSettings& in_force = system.state_->explicit_;
  if (in_force.contains(setting)) return;
  const ExplicitSettings before = in_force;
  set();
  in_force = before;
}

void SystemInside::keep_fill_style(GraphicsSystem& system, const std::function<void()>& enter) {
  const FillStyle in_force = system.looks().attributes.fill;
  const ExplicitSettings before = system.explicit_settings();
  restoring(enter, [&] {
    if (system.looks().attributes.fill != in_force) system.set_fill_style(in_force);
    system.state_->explicit_ = before;
  });
}

void SystemInside::keep_line_style(GraphicsSystem& system, const std::function<void()>& enter) {
  const LineStyle in_force = system.looks().attributes.line;
  const ExplicitSettings before = system.explicit_settings();
  restoring(enter, [&] {
    if (system.looks().attributes.line != in_force) system.set_line_style(in_force);
    system.state_->explicit_ = before;
  });
}

}  // namespace displayfile
