#include "displayfile/user_routines/system_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "clip/base/work_budget.h"
#include "displayfile/segments/hidden_surface_check.h"
#include "displayfile/text/characters.h"
#include "displayfile/user_routines/ranges.h"
#include "displayfile/user_routines/system_inside.h"

namespace displayfile {

namespace {

/// Device coordinates stay in the range for which the interpreter's predicates are proven; so do
/// the products of a scale and a centre.
constexpr Limit kOfImageParts{1e90, "1e90"}, kOfImageCentres{1e9, "1e9"};

void require_no_segments(const DisplayFile& display_file) {
  if (display_file.segments().empty()) return;
  throw Error("there are segments already: expected retain, or a camera, before the first one");
}

}  // namespace

void GraphicsSystem::open_segment(int name) {
  const RoundToNearest nearest;
  if (state_->open_)
    throw Error(fmt::format("segment already open: segment {}; close it first", *state_->open_));
  const View view = state_->windows_.in_picture(state_->view_, state_->explicit_);
  const ViewVolume volume(view);
  Segment& segment = state_->display_file_.create(name);
  state_->views_at_close_ = state_->retaining() != nullptr && !state_->retains_alone_ &&
                            !state_->views_on_demand_ && !state_->surfaces_.lines.is_all_alone();
  if (!state_->is_viewed_later()) segment.keep_entered(state_->surfaces_.touching, volume);
  state_->view_stage_.emplace(volume);
  state_->open_ = name;
  if (const std::size_t k = state_->segments_opened_++; !state_->places_.empty()) {
    const Point3 place = k < state_->places_.size() ? state_->places_[k] : Point3(0.0);
    state_->modelling_.place(place);
    state_->cutting_planes_.place(place);
  }
  if (RetainedScene* scene = state_->retaining())
    scene->open_segment(name, view, state_->surfaces_.touching);
  state_->windows_.opened(name, view, state_->explicit_);
  state_->record("open-segment", {name});
}

/// Algorithm 9.5, CLOSE-SEGMENT. The polygons are already in the display file, in order of entry;
/// if hidden surfaces are to be sorted they are added back to front.
void GraphicsSystem::close_segment() {
  const BudgetInForce as_it_is(nullptr);  // rounds to nearest, and other work begins
  if (!state_->open_) throw Error("no segment open");
  if (!state_->solids_.empty()) throw Error("a solid is still open: end it first, by end-solid");
  try {
    state_->close(state_->display_file_.segment(*state_->open_));
  } catch (...) {
    if (RetainedScene* scene = state_->retaining()) scene->reopen_segment();
    throw;
  }
  state_->open_.reset();
  if (state_->is_viewed_later() || state_->view_stage_->met() != 0) state_->is_all_in_view_ = false;
  state_->view_stage_.reset();  // vertices that polygons shared are in them
  state_->shared_world_ = decltype(state_->shared_world_)();
  state_->record("close-segment", {});
}

void GraphicsSystem::State::close(Segment& segment) {
  std::optional<Segment> selected;
  if (retaining() != nullptr) selected = with_lines_selected(segment.name());
  Segment& whole = selected ? *selected : segment;
  keep_entered_once(whole);
  whole.free_room();
  sort(whole);
  std::shared_ptr<const SortedScene> sorted = whole.sorted();
  const std::optional<SurfacePlan> put_off = whole.put_off;
  if (selected) segment.take_instructions(std::move(*selected));
  if (sorted) segment.set_sorted(std::move(sorted));
  segment.put_off = put_off;
  segment.close();
}

/// Sorts the hidden surfaces of a complete segment, by the settings in force; or records that they
/// are to be sorted with those of all others.
void GraphicsSystem::State::sort(Segment& whole) const {
  const bool each_on_its_own =
      surfaces_.scope.value_or(HiddenScope::segment) == HiddenScope::segment;
  SurfacePlan plan = surfaces_;
  plan.scope.reset();
  plan.line_order = LineOrder::entry;  // that of depth takes all segments together
  plan.line_halo = 0.0;
  plan.intersections = contains(surfaces_.lines.kinds, LineKind::intersection);
  if (surfaces_.removal && is_object_space(plan.method)) {
    if (each_on_its_own) {
      whole.set_sorted(hidden_surface_check(whole.entered(), {}, plan));
    } else {
      whole.put_off = plan.kept();
    }
  }
}

/// Entered polygons are in the retained scene too: keeps them only there.
void GraphicsSystem::State::keep_entered_once(Segment& closing) {
  const RetainedScene* const scene = retained();
  if (scene == nullptr || retains_alone_) return;
  const RetainedPolygons polygons = scene->entered_polygons(scene->segments().back());
  if (EnteredPolygons* const kept = closing.entered_alone()) kept->keep_in(polygons);
  follow_retained();
}

/// If the scene's arrays were replaced since, as it has grown or shrunk, makes segments refer to
/// the new ones, so that none keeps the old ones.
void GraphicsSystem::State::follow_retained() {
  const RetainedScene* const scene = retained();
  if (scene == nullptr || retains_alone_ || scene->segments().empty()) return;
  const auto place = scene->entered_polygons(scene->segments().back()).place();
  if (place == retained_in_) return;
  retained_in_ = place;
  for (const RetainedScene::Segment& part : scene->segments()) {
    EnteredPolygons* const kept = display_file_.segment(part.name).entered_alone();
    if (kept != nullptr && kept->are_retained()) kept->move_in(scene->entered_polygons(part));
  }
}

GraphicsSystem::State::Entered GraphicsSystem::State::entered() const {
  return {.segments = display_file_.segments().size(),
          .segments_opened = segments_opened_,
          .pen = pen_,
          .ordinal = ordinal_,
          .triangulated = triangulated_,
          .empty_solids = empty_solids_,
          .pick = pick_,
          .has_hatching = has_hatching_,
          .explicit_settings = explicit_,
          .modelling = modelling_,
          .looks = looks_,
          .vertex_normals = vertex_normals_,
          .vertex_colours = vertex_colours_,
          .cutting_planes = cutting_planes_,
          .plane_uses = plane_uses_};
}

void GraphicsSystem::State::take_back(const Entered& before) {
  while (!solids_.empty()) discard_solid();
  open_.reset();
  while (display_file_.segments().size() > before.segments) {
    const int name = display_file_.segments().back().name();
    display_file_.remove(name);
    if (RetainedScene* scene = retaining()) scene->remove(name);
  }
  follow_retained();
  segments_opened_ = before.segments_opened;
  pen_ = before.pen;
  ordinal_ = before.ordinal;
  triangulated_ = before.triangulated;
  empty_solids_ = before.empty_solids;
  pick_ = before.pick;
  has_hatching_ = before.has_hatching;
  explicit_ = before.explicit_settings;
  modelling_ = before.modelling;
  looks_ = before.looks;
  vertex_normals_ = before.vertex_normals;
  vertex_colours_ = before.vertex_colours;
  cutting_planes_ = before.cutting_planes;
  plane_uses_ = before.plane_uses;
}

void GraphicsSystem::enter_segments(const std::function<void()>& enter) {
  const State::Entered before = state_->entered();
  Recorder::Hold recorded(state_->recorder_);
  try {
    enter();
    recorded.end();
  } catch (...) {
    state_->take_back(before);
    throw;
  }
}

void GraphicsSystem::all_or_nothing(const std::function<void()>& change) {
  State before(*state_);
  Recorder::Hold recorded(state_->recorder_);
  try {
    change();
    recorded.end();
  } catch (...) {
    *state_ = std::move(before);
    throw;
  }
}

void GraphicsSystem::delete_segment(int name) {
  const RoundToNearest nearest;
  if (state_->open_ == name)
    throw Error(fmt::format("segment {} still open: close it first", name));
  state_->display_file_.remove(name);
  if (RetainedScene* scene = state_->retaining()) scene->remove(name);
  state_->follow_retained();
  state_->record("delete-segment", {name});
}

void GraphicsSystem::delete_all_segments() {
  if (state_->open_)
    throw Error(fmt::format("segment {} still open: close it first", *state_->open_));
  state_->display_file_.remove_all();
  state_->has_hatching_ = false;
  if (RetainedScene* scene = state_->retaining()) scene->remove_all();
  state_->record("delete-all-segments", {});
}

void GraphicsSystem::rename_segment(int from, int to) {
  if (state_->open_ == from)
    throw Error(fmt::format("segment {} still open: close it first", from));
  state_->display_file_.rename(from, to);
  if (RetainedScene* scene = state_->retaining()) scene->rename(from, to);
  state_->record("rename-segment", {from, to});
}

void GraphicsSystem::set_visibility(int name, bool on) {
  state_->display_file_.segment(name).visible = on;
  state_->record("set-visibility", {name, on});
}

void GraphicsSystem::set_image_translation(int name, double tx, double ty) {
  const RoundToNearest nearest;
  require_within(kOfImageParts, {tx, ty}, "image translation");
  state_->display_file_.segment(name).image.translation = {tx, ty};
  state_->record("set-image-translation", {name, tx, ty});
}

void GraphicsSystem::set_image_scale(int name, double sx, double sy) {
  const RoundToNearest nearest;
  require_within(kOfImageParts, {sx, sy}, "image scale");
  state_->display_file_.segment(name).image.scale = {sx, sy};
  state_->record("set-image-scale", {name, sx, sy});
}

void GraphicsSystem::set_image_rotation(int name, double angle) {
  const RoundToNearest nearest;
  require_finite({angle}, "angle");
  state_->display_file_.segment(name).image.rotation = angle;
  state_->record("set-image-rotation", {name, angle});
}

void GraphicsSystem::set_segment_title(int name, std::string_view title) {
  require_characters(title);
  state_->display_file_.segment(name).set_title(title);
  if (state_->recorder_ == nullptr) return;
  const std::string quoted = in_quotation_marks(title);
  state_->record("set-segment-title", {name, std::string_view(quoted)});
}

void GraphicsSystem::set_image_centre(int name, double x, double y) {
  const RoundToNearest nearest;
  require_within(kOfImageCentres, {x, y}, "image centre");
  state_->display_file_.segment(name).image.centre = {x, y};
  state_->record("set-image-centre", {name, x, y});
}

void GraphicsSystem::retain(RetainedScene* scene) {
  if (scene != nullptr) require_no_segments(state_->display_file_);
  if (scene == nullptr && !state_->surfaces_.lines.is_all_alone()) {
    throw Error("the selection of lines needs the retained scene: expected set-lines all first");
  }
  state_->retained_ = scene;
  state_->own_retained_.reset();
  state_->retains_alone_ = false;
}

void GraphicsSystem::retain() {
  if (state_->retained() != nullptr) return;
  require_no_segments(state_->display_file_);
  state_->own_retained_.emplace();
}

void SystemInside::retain_alone(GraphicsSystem& system, RetainedScene& scene) {
  system.retain(&scene);
  system.state_->retains_alone_ = true;
}

void SystemInside::place_segments(GraphicsSystem& system, std::vector<Point3> places) {
  system.state_->places_ = std::move(places);
  system.state_->segments_opened_ = 0;
}

const std::vector<Point3>& SystemInside::places(const GraphicsSystem& system) {
  return system.state_->places_;
}

std::size_t SystemInside::segments_opened(const GraphicsSystem& system) {
  return system.state_->segments_opened_;
}

void SystemInside::enter_segment_of_lines(GraphicsSystem& system,
                                          std::span<const std::pair<Point3, Point3>> lines,
                                          double narrower) {
  GraphicsSystem::State& s = *system.state_;
  int last = 0;
  for (const Segment& segment : s.display_file_.segments()) last = std::max(last, segment.name());
  if (last == std::numeric_limits<int>::max()) {
    throw Error(fmt::format("segment {} is in use: expected smaller names", last));
  }
  const Attributes before = s.looks_.attributes;
  system.open_segment(last + 1);
  const LineStyle style = before.line;
  s.looks_.attributes.line = {LineStyle::Kind::solid, style.colour, narrower * style.width};
  s.attributes_changed();
  for (const auto& [from, to] : lines) s.enter_world_line(from, to);
  s.looks_.attributes = before;
  s.attributes_changed();
  system.close_segment();
}

bool SystemInside::retains_alone(const GraphicsSystem& system) {
  return system.state_->retains_alone_;
}

}  // namespace displayfile
