#include "displayfile/mesh/followed_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <sstream>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "clip/geometry/unit.h"
#include "clip/pipeline/cutting_planes.h"
#include "clip/view/transformation.h"
#include "displayfile/looks/letters.h"
#include "displayfile/mesh/fitted_view.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/text/program_in_view.h"
#include "displayfile/user_routines/system_inside.h"

namespace displayfile {

namespace {

void append_points(const RetainedScene& scene, const RetainedScene::Segment& segment,
                   std::vector<Point3>& points) {
  const auto of_segment = scene.points(segment);
  points.insert(points.end(), of_segment.begin(), of_segment.end());
  for (const RetainedScene::Text& text : scene.texts(segment)) points.push_back(text.anchor);
  for (const KeptAnnotation& annotation : segment.annotations) {
    points.insert(points.end(), annotation.points.begin(), annotation.points.end());
  }
}

void append_texts(const RetainedScene& scene, const RetainedScene::Segment& segment,
                  std::vector<PlacedText>& texts) {
  for (const RetainedScene::Text& text : scene.texts(segment)) {
    texts.push_back({text.anchor, letters_at_anchor(scene.attributes(text).text, text.characters)});
  }
}

std::array<Point3, 8> corners_of(const Bounds& box) {
  std::array<Point3, 8> corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    corners[k] = {(k & 1) != 0 ? box.high.x : box.low.x, (k & 2) != 0 ? box.high.y : box.low.y,
                  (k & 4) != 0 ? box.high.z : box.low.z};
  }
  return corners;
}

/// The bounding box of a ball of radius 1, used where there are no points to fit a view to.
Bounds unit_ball_at(const Point3& middle) {
  Bounds box;
  box.include(middle - Point3(1.0));
  box.include(middle + Point3(1.0));
  return box;
}

constexpr double kLeastForScene = 0.3;  // of the picture's width, beside columns

/// The part of the picture's width for a column of that width in parts of its height, or of its
/// width if that is smaller.
double width_of_column(double width, double aspect) {
  constexpr double kLeast = 0.12, kMost = 0.4, kMostOfNarrow = 0.67;
  const double of_height = std::clamp(width, kLeast, kMost);
  return aspect < 1.0 ? std::min(of_height / aspect, kMostOfNarrow) : of_height;
}

/// True if the segment is empty and as open_segment leaves it.
bool is_fresh(const Segment& segment) {
  return segment.polygons() == 0 && segment.lines() == 0 && !segment.has_texts() &&
         !segment.has_annotations() && segment.title().empty() && segment.visible &&
         segment.image.is_identity();
}

std::uint32_t opened_so_far(const RetainedScene& scene) {
  return scene.segments().empty() ? 0 : scene.segments().back().opened + 1;
}

}  // namespace

bool FollowedView::is_beside(const RetainedScene::Segment& segment) const {
  return std::ranges::find(beside_, segment.opened, &Beside::opened) != beside_.end();
}

bool FollowedView::is_followed(const RetainedScene::Segment& segment) const {
  return segment.opened >= first_ && !is_beside(segment);
}

std::vector<std::uint32_t> FollowedView::followed(const RetainedScene& scene) const {
  std::vector<std::uint32_t> opened;
  for (const RetainedScene::Segment& segment : scene.segments()) {
    if (is_followed(segment)) opened.push_back(segment.opened);
  }
  return opened;
}

/// The settings of the application, with the part of the picture left for the scene as the viewport
/// unless that is set.
CameraAsSet FollowedView::as_set(const GraphicsSystem& system) const {
  CameraAsSet set{system.view(), system.explicit_settings()};
  if (set.settings.contains(Setting::viewport)) return set;
  set.view.viewport = {0.0, right_, 0.0, 1.0};
  set.settings.insert(Setting::viewport);
  return set;
}

/// The view fitted to the followed segments; none if there is nothing to fit to.
std::optional<View> FollowedView::view_of(const GraphicsSystem& system,
                                          const Camera& camera) const {
  if (system.retained() == nullptr) return std::nullopt;
  const RetainedScene& scene = *system.retained();
  std::vector<Point3> points;
  std::vector<PlacedText> texts;
  for (const RetainedScene::Segment& segment : scene.segments()) {
    if (!is_followed(segment)) continue;
    append_points(scene, segment, points);
    append_texts(scene, segment, texts);
  }
  if (points.empty()) return std::nullopt;
  return fitted_view(points, system, camera, as_set(system), texts);
}

/// The view of a ball of radius 1 if nothing is entered yet; otherwise fitted to the bounding box.
View FollowedView::view_before_fit(const GraphicsSystem& system) const {
  const CameraAsSet set = as_set(system);
  Camera camera = *camera_;
  camera.turning = false;
  if (!bounds_.empty()) {
    try {
      return *fitted_view(corners_of(bounds_), system, camera, set);
    } catch (const Error&) {  // the box may reach behind the eye, where nothing in it does
    }
  }
  camera.fit = false;
  const Bounds box = bounds_.empty() ? unit_ball_at(camera.look_at.value_or(Point3(0.0))) : bounds_;
  return *fitted_view(corners_of(box), system, camera, set);
}

void FollowedView::set_view(GraphicsSystem& system, const View& view) {
  const CameraAsSet set = as_set(system);
  const Rectangle& viewport = set.view.viewport;
  SystemInside::by_default(system, Setting::camera, [&] {
    system.set_viewport(viewport.x_min, viewport.x_max, viewport.y_min, viewport.y_max);
    set_fitted_view(view, system, set);
  });
  if (system.explicit_settings().contains(Setting::light)) return;
  const Point3 light = mesh_light(system);
  SystemInside::turn_light(system, unit(light));
  if (lights_.empty() || lights_.back() != light) lights_.push_back(light);
}

/// Places the columns for pictures with that aspect ratio, narrower ones where the scene would have
/// no room.
void FollowedView::arrange_columns(double aspect) {
  double right = columns_right_, all = 0.0;
  for (const Beside& column : beside_) {
    if (column.opened < first_) {
      right = column.view.viewport.x_min;  // which it keeps
    } else {
      all += width_of_column(column.width, aspect);
    }
  }
  const double room = right - kLeastForScene;
  const double scale = all > room ? room / all : 1.0;
  for (Beside& column : beside_) {
    if (column.opened < first_) continue;
    const double left = right - scale * width_of_column(column.width, aspect);
    column.view.set_viewport({left, right, 0.0, 1.0});
    right = left;
  }
  right_ = right;
}

void FollowedView::stop() {
  camera_.reset();
  viewed_.reset();
  lights_.clear();
  bounds_ = Bounds();
}

void FollowedView::begin(GraphicsSystem& system, const Camera& camera) {
  SystemInside::view_on_demand(system, true);
  if (!camera_ && has_followed_) first_ = opened_so_far(*system.retained());
  camera_ = camera;
  has_followed_ = true;
  viewed_.reset();
}

bool FollowedView::is_view_set(const GraphicsSystem& system) {
  const ExplicitSettings& set = system.explicit_settings();
  return set.contains(Setting::camera) || set.contains(Setting::window);
}

void FollowedView::look(GraphicsSystem& system, const Camera& camera) {
  const RoundToNearest nearest;
  if (system.open_segment_name()) {
    throw Error("a segment is open: expected close_segment before the camera is set");
  }
  if (is_view_set(system)) {
    throw Error("the view was set before: expected either a camera or view parameters");
  }
  const std::optional<Camera> before = camera_;
  const std::optional<RetainedScene::Edition> viewed = viewed_;
  if (!camera_) {
    system.retain();  // or refuses
  }
  const std::uint32_t first = first_;
  begin(system, camera);
  try {
    if (!view_of(system, camera)) view_before_fit(system);  // or refuses
  } catch (...) {
    camera_ = before;
    viewed_ = viewed;
    first_ = first;
    if (!camera_) SystemInside::view_on_demand(system, false);
    throw;
  }
  place(system);
}

bool FollowedView::would_begin(const GraphicsSystem& system) const {
  if (camera_ || is_view_set(system)) return false;
  const DisplayFile& all = system.display_file();
  if (system.open_segment_name()) {
    return all.segments().size() == 1 && is_fresh(all.segments().front()) &&
           system.counts().solids_open == 0;
  }
  return all.segments().empty() || (system.retained() != nullptr && has_followed_);
}

void FollowedView::begin_by_default(GraphicsSystem& system) {
  const RoundToNearest nearest;
  if (!would_begin(system)) return;
  const auto open = system.open_segment_name();
  if (open) {  // the open segment was not retained: it is opened again
    system.close_segment();
    system.delete_segment(*open);
  }
  Camera camera;
  camera.upright = upright("z");
  begin(system, camera);
  if (!open) return;
  place(system);
  system.open_segment(*open);
}

void FollowedView::count_bounds(const RetainedScene& scene) {
  if (scene.segments().empty()) {
    bounds_ = Bounds();
    counted_ = 0;
  }
  std::vector<Point3> points;
  for (const RetainedScene::Segment& segment : scene.segments()) {
    if (segment.opened < counted_ || !is_followed(segment)) continue;
    append_points(scene, segment, points);
    counted_ = segment.opened + 1;
  }
  for (const Point3& p : points) bounds_.include(p);
}

void FollowedView::place_in_segment(GraphicsSystem& system) {
  const RoundToNearest nearest;
  if (!camera_ || !system.open_segment_name()) return;
  const std::uint32_t counted = counted_;
  count_bounds(*system.retained());
  counted_ = counted;  // there may be more in it
  SystemInside::replace_view(system, view_before_fit(system));
}

void FollowedView::place(GraphicsSystem& system) {
  const RoundToNearest nearest;
  if (!camera_ || system.open_segment_name()) return;
  SystemInside::view_on_demand(system, true);  // a program may have left a segment open
  count_bounds(*system.retained());
  set_view(system, view_before_fit(system));
}

void FollowedView::bring_up_to_date(GraphicsSystem& system, std::optional<double> aspect) {
  const RoundToNearest nearest;
  if (!camera_) return;
  const bool is_open = system.open_segment_name().has_value();
  if (aspect && *aspect != system.aspect_ratio() && !is_open) {
    system.set_aspect_ratio(*aspect);
    viewed_.reset();
  }
  const RetainedScene& scene = *system.retained();
  if (viewed_ && *viewed_ == scene.edition()) return;
  arrange_columns(system.aspect_ratio());
  const std::optional<View> fitted = view_of(system, *camera_);
  const View view = fitted ? *fitted : view_before_fit(system);
  if (!is_open) set_view(system, view);
  View in_picture = view;
  in_picture.viewport = as_set(system).view.viewport;
  fitted_ = SystemInside::view_again(system, in_picture, followed(scene));
  for (Beside& segment : beside_) {
    if (segment.opened < first_) continue;
    segment.in_picture = SystemInside::view_again(system, segment.view, {&segment.opened, 1});
  }
  viewed_ = scene.edition();
}

void FollowedView::running(GraphicsSystem& system, bool sets_view,
                           const std::function<void()>& run) {
  if (!camera_ || system.open_segment_name()) return run();
  bring_up_to_date(system);
  place(system);
  const bool is_empty = opened_so_far(*system.retained()) <= first_;
  SystemInside::view_on_demand(system, false);  // there may be other views
  const auto go_on = [&] {
    if (!system.open_segment_name()) SystemInside::view_on_demand(system, true);
  };
  try {
    run();
  } catch (...) {
    go_on();
    throw;
  }
  const bool ends = is_view_set(system) || (sets_view && !is_empty);
  ends ? stop() : go_on();
}

namespace {

/// Calls enter() with a light that leaves colours as they are, and without shadows.
void without_light(GraphicsSystem& system, const std::function<void()>& enter) {
  const Attributes before = system.looks().attributes;
  const auto set = [&](double ambient, bool shadows) {
    if (before.light) system.set_light(before.light->toward, ambient);
    if (before.shadows) system.set_shadows(shadows);
  };
  set(1.0, false);
  restoring(enter, [&] { set(before.light ? before.light->ambient : 1.0, true); });
}

}  // namespace

void FollowedView::enter_beside(GraphicsSystem& system, double width,
                                const std::function<void()>& enter) {
  const RoundToNearest nearest;
  if (!system.modelling_transformation().is_identity() ||
      SystemInside::cutting_planes(system).any()) {
    throw Error(
        "a modelling transformation or a cutting plane is in force: expected none for what stands "
        "beside the scene");
  }
  const double left = right_ - width_of_column(width, system.aspect_ratio());
  if (left < kLeastForScene) throw Error("no room is left beside the scene");
  View view;
  view.set_window({0.0, width, 0.0, 1.0});
  view.set_viewport({left, right_, 0.0, 1.0});
  SystemInside::in_other_view(system, view, [&] { without_light(system, enter); });
  right_ = left;
  const RetainedScene* const scene = system.retained();
  if (!camera_ || scene == nullptr) {
    columns_right_ = left;
    return;
  }
  const RetainedScene::Segment& entered = scene->segments().back();
  beside_.push_back({entered.opened, entered.name, width, view, view});
  viewed_.reset();
}

namespace {

/// True if the line, as a recorder writes it, sets one of these lights.
bool sets_light_of(std::string_view line, std::span<const Point3> lights) {
  std::istringstream words{std::string(line)};
  std::string routine;
  Point3 toward;
  words >> routine;
  if (routine != "set-light") return false;
  for (int axis = 0; axis < 3; ++axis) {
    std::string number;
    words >> number;
    std::from_chars(number.data(), number.data() + number.size(), toward[axis]);
  }
  return std::ranges::find(lights, toward) != lights.end();
}

}  // namespace

/// The program in the fitted view. If the default light was replaced, each earlier default light in
/// the program becomes the last one.
std::string FollowedView::recorded(std::string_view program) const {
  if (!fitted_) return std::string(program);
  std::string viewed = program_in_views(program, [&](int opened) -> const View& {
    const auto segment = std::ranges::find(beside_, opened, &Beside::name);
    return segment == beside_.end() ? *fitted_ : segment->in_picture;
  });
  if (lights_.size() < 2) return viewed;
  std::string result;
  std::istringstream lines(viewed);
  for (std::string line; std::getline(lines, line);) {
    if (!sets_light_of(line, lights_)) {
      result += line + "\n";
      continue;
    }
    const Point3& now = lights_.back();
    const std::string ambient = line.substr(line.rfind(' '));
    result += fmt::format("set-light {} {} {}{}\n", now.x, now.y, now.z, ambient);
  }
  return result;
}

}  // namespace displayfile
