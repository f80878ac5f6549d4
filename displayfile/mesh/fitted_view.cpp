#include "displayfile/mesh/fitted_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <iterator>
#include <optional>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "clip/geometry/bounds.h"
#include "clip/pipeline/cutting_planes.h"
#include "clip/view/view_volume.h"
#include "clip/view/window_fit.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"
#include "displayfile/user_routines/system_inside.h"
#include "displayfile/views/picture_windows.h"
#include "displayfile/views/scene_in_one_view.h"

namespace displayfile {

namespace {

constexpr double kEyeDistance = 4.0;      // of the view plane, in radii of the scene
constexpr double kDepthMargin = 0.01;     // in radii, before and behind the scene
constexpr double kNearestFront = 1e-3;    // of the front plane to the eye, in the eye's distance
constexpr double kParallelToUp = 1e-9;    // the sine of an angle
constexpr double kFreeAtEachSide = 0.05;  // of a picture with an angle of view
constexpr double kMostForLetters = 2.5;   // how much smaller letters may make the scene

/// Position of the eye relative to its target.
struct Sight {
  Point3 toward_eye;      ///< a unit vector
  Point3 upright;         ///< the direction that appears upright
  double distance = 0.0;  ///< 0 if it is not known yet
};

/// The direction of the eye and the upright direction. If the eye is exactly above or below, the
/// latter is its limit as the eye rises.
Sight from_direction(const EyeDirection& eye, const Upright& world) {
  const auto [across, along] = sine_cosine_of_degrees(eye.azimuth);
  const auto [rise, level] = sine_cosine_of_degrees(eye.elevation);
  const Point3 toward =
      world.right * (across * level) + world.up * rise + world.front * (along * level);
  if (std::abs(level) > kParallelToUp) return {toward, world.up};
  const Point3 ahead = world.right * across + world.front * along;
  return {toward, rise > 0.0 ? -ahead : ahead};
}

Sight from_position(const Point3& eye, const Point3& at, const Upright& world) {
  const double distance = glm::length(eye - at);
  if (!(distance > 0.0)) {
    throw Error("the eye is at the target: expected another point");
  }
  const Point3 toward = (eye - at) / distance;
  const bool along_up = glm::length(glm::cross(toward, world.up)) <= kParallelToUp;
  const bool above = glm::dot(toward, world.up) > 0.0;
  const Point3 upright = !along_up ? world.up : above ? -world.front : world.front;
  return {toward, upright, distance};
}

/// Half of the height visible at a distance of 1.
double slope_of(double angle_of_view) {
  if (!(angle_of_view > 0.0 && angle_of_view < 180.0)) {
    throw Error(fmt::format("angle of view {}: expected degrees, more than 0 and less than 180",
                            angle_of_view));
  }
  const auto [sine, cosine] = sine_cosine_of_degrees(0.5 * angle_of_view);
  return sine / cosine;
}

Rectangle about_the_middle(double half_height, double aspect) {
  return {-aspect * half_height, aspect * half_height, -half_height, half_height};
}

/// The points at kPlaces positions of a turn about the up axis, enough that between two of them no
/// point reaches farther out by more than a hundredth of its distance from the axis.
std::vector<Point3> turned(std::span<const Point3> world, const Point3& middle,
                           const Upright& upright) {
  constexpr int kPlaces = 32;
  std::vector<Point3> all;
  for (int k = 0; k < kPlaces; ++k) {
    const auto [sine, cosine] = sine_cosine_of_degrees(360.0 * k / kPlaces);
    for (const Point3& p : world) {
      const Point3 from_middle = p - middle;
      const double across = glm::dot(from_middle, upright.right);
      const double along = glm::dot(from_middle, upright.front);
      all.push_back(p + (across * (cosine - 1.0) + along * sine) * upright.right +
                    (along * (cosine - 1.0) - across * sine) * upright.front);
    }
  }
  return all;
}

/// The data of the points needed to fit a view to them, in the view plane's coordinates.
class FittedCamera {
 public:
  /// Fits by the camera. Without an aspect ratio no window is fitted. Letters of texts are in
  /// heights of the viewport.
  FittedCamera(std::span<const Point3> world, std::optional<double> aspect, const Camera& camera,
               std::span<const PlacedText> texts = {});
  /// Fits only the window and the depth of a view whose camera was set.
  FittedCamera(std::span<const Point3> world, double aspect, const View& set_before,
               std::span<const PlacedText> texts = {});
  const View& view() const { return view_; }
  /// Sets the window at that scale around the visible scene, if a window is fitted.
  void set_scale(const ExactScale& scale, const Rectangle& viewport);

 private:
  void take(std::span<const Point3> world);
  void place_eye(double distance);
  void place_in_view_plane(std::span<const Point3> world, std::span<const PlacedText> texts);
  void stand_back(double slope);
  double distance_for_letters(double slope, const Point2& middle, double bare) const;
  Point2 in_window(const Point3& p) const;
  Bounds about_target(Bounds seen) const;
  Bounds with_letters(Bounds seen, std::span<const PlacedText> texts, double height) const;
  Bounds with_letters(const Bounds& seen) const;
  double height_around(const Bounds& seen) const;
  double height_for(const Bounds& seen, std::span<const PlacedText> texts, double most) const;
  void fit_window();
  void enclose_depth();

  Camera camera_;
  Upright upright_;
  double aspect_;
  Bounds scene_;
  double radius_ = 1.0;  // of the scene
  double distance_ = 0.0;
  Point2 eye_{0.0};    // of a perspective, across the view plane; its distance is distance_
  Point2 slant_{0.0};  // of projectors in parallel, for each unit toward the viewer
  Point3 toward_eye_{0.0};
  glm::dmat4 view_plane_{1.0};
  std::vector<Point3> points_;
  std::vector<PlacedText> texts_;
  std::optional<Rectangle> shown_;  // by a fitted window, on the view plane, without letters
  View view_;
};

FittedCamera::FittedCamera(std::span<const Point3> world, std::optional<double> aspect,
                           const Camera& camera, std::span<const PlacedText> texts)
    : camera_(camera), aspect_(aspect.value_or(1.0)) {
  if (const auto* axis = std::get_if<Upright>(&camera.upright)) upright_ = *axis;
  take(world);
  const double seen_radius = camera.fit ? radius_ : 1.0;
  const Point3 at = camera.look_at.value_or(camera.fit ? scene_.middle() : Point3(0.0));

  const auto* const direction = std::get_if<EyeDirection>(&camera.eye);
  const Sight sight = direction != nullptr
                          ? from_direction(*direction, upright_)
                          : from_position(std::get<Point3>(camera.eye), at, upright_);
  toward_eye_ = sight.toward_eye;
  view_.set_reference_point(at);
  view_.set_plane_normal(-toward_eye_);
  view_.set_up(sight.upright);
  place_eye(direction != nullptr ? kEyeDistance * seen_radius : sight.distance);
  view_.set_depth(-radius_, radius_);
  view_.set_window({-radius_, radius_, -radius_, radius_});

  View from_far = view_;  // any will do for the axes of the view plane
  from_far.set_parallel(toward_eye_);
  view_plane_ = ViewVolume(from_far).view_plane();
  const bool stands_back = camera.angle_of_view && direction != nullptr && camera.fit;
  std::vector<Point3> places;
  if (stands_back && camera.turning) {
    places = turned(world, scene_.middle(), upright_);
    world = places;
    texts = {};
  }
  place_in_view_plane(world, texts);
  if (camera.angle_of_view) {
    const double slope = slope_of(*camera.angle_of_view);
    if (stands_back) stand_back(slope);
    if (direction != nullptr && !camera.fit) place_eye(seen_radius / slope);
    view_.set_window(about_the_middle(slope * distance_, aspect_));
  } else if (camera.fit && aspect) {
    fit_window();
  } else {
    view_.set_window(widened(about_the_middle(1.0, 1.0), aspect_));
  }
  enclose_depth();
}

FittedCamera::FittedCamera(std::span<const Point3> world, double aspect, const View& set_before,
                           std::span<const PlacedText> texts)
    : aspect_(aspect), view_(set_before) {
  take(world);
  camera_.parallel = set_before.projection == View::Projection::parallel;
  View along_normal = set_before;  // any direction will do for the axes of the view plane
  along_normal.set_parallel(set_before.plane_normal);
  view_plane_ = ViewVolume(along_normal).view_plane();
  place_in_view_plane(world, texts);
  if (camera_.parallel) {
    const Point3 along(view_plane_ * HomogeneousPoint(set_before.direction_of_projection, 0.0));
    slant_ = Point2(along) / along.z;
  } else {
    const Point3 eye(view_plane_ * HomogeneousPoint(set_before.centre_of_projection, 1.0));
    eye_ = Point2(eye);
    distance_ = eye.z;
  }
  fit_window();
  enclose_depth();
}

void FittedCamera::take(std::span<const Point3> world) {
  for (const Point3& p : world) scene_.include(p);
  if (scene_.empty()) throw Error("no points to fit the view to");
  const double diagonal = glm::length(scene_.high - scene_.low);
  if (diagonal > 0.0) radius_ = 0.5 * diagonal;
}

void FittedCamera::place_in_view_plane(std::span<const Point3> world,
                                       std::span<const PlacedText> texts) {
  const auto placed = [&](const Point3& p) {
    return Point3(view_plane_ * HomogeneousPoint(p, 1.0));
  };
  points_.reserve(world.size());
  for (const Point3& p : world) points_.push_back(placed(p));
  for (const auto& [anchor, letters] : texts) texts_.push_back({placed(anchor), letters});
}

void FittedCamera::place_eye(double distance) {
  distance_ = distance;
  if (camera_.parallel) {
    view_.set_parallel(toward_eye_);
  } else {
    view_.set_perspective(view_.reference_point + distance * toward_eye_);
  }
}

/// Moves the eye, and its target unless that is given, so that the points just fill the angle of
/// view. A point is visible if the eye is far enough in front of it.
void FittedCamera::stand_back(double slope) {
  const double free = 1.0 - 2.0 * kFreeAtEachSide;
  const Point2 slopes(slope * aspect_ * free, slope * free);
  Point2 low(-HUGE_VAL), high(-HUGE_VAL);
  double nearest = -HUGE_VAL;
  for (const Point3& p : points_) {
    nearest = std::max(nearest, p.z);
    for (int axis = 0; axis < 2; ++axis) {
      low[axis] = std::max(low[axis], slopes[axis] * p.z - p[axis]);
      high[axis] = std::max(high[axis], slopes[axis] * p.z + p[axis]);
    }
  }
  Point2 middle(0.0);
  if (!camera_.look_at) middle = 0.5 * (high - low);
  double distance = nearest + kDepthMargin * radius_;
  for (int axis = 0; axis < 2; ++axis) {
    const double half = std::max(low[axis] + middle[axis], high[axis] - middle[axis]);
    distance = std::max(distance, half / slopes[axis]);
  }
  distance = distance_for_letters(slope, middle, distance);
  const glm::dmat4 axes = glm::transpose(view_plane_);  // rows: the viewer's right, up and back
  view_.set_reference_point(view_.reference_point + middle.x * Point3(axes[0]) +
                            middle.y * Point3(axes[1]));
  place_eye(distance);
}

/// The distance from which no letters cross the free part of a picture with an angle of view, or
/// `bare`, from which no point does. The letters, whose size does not depend on it, take their part
/// of the slope. Those that would need too much distance do not count.
double FittedCamera::distance_for_letters(double slope, const Point2& middle, double bare) const {
  constexpr double kHalves = 2.0;  // of the picture's height, in which slopes are measured
  const double free = 1.0 - 2.0 * kFreeAtEachSide;
  const Point2 whole(aspect_ * free, free);
  double distance = bare;
  for (const auto& [at, letters] : texts_) {
    double own = bare;
    for (int axis = 0; axis < 2; ++axis) {
      const double above = std::max(0.0, whole[axis] - kHalves * letters.high[axis]);
      const double below = std::max(0.0, whole[axis] + kHalves * letters.low[axis]);
      const double off = at[axis] - middle[axis];
      own = std::max({own, at.z + off / (slope * above), at.z - off / (slope * below)});
    }
    if (own <= kMostForLetters * bare) distance = std::max(distance, own);
  }
  return distance;
}

/// The point's projection on the view plane.
Point2 FittedCamera::in_window(const Point3& p) const {
  const double w = camera_.parallel ? 1.0 : 1.0 - p.z / distance_;
  if (!(w > kNearestFront)) {
    throw Error(
        "part of the scene is not in front of the eye: expected an eye farther away, an angle of "
        "view, no fitting, or a window that is set");
  }
  return eye_ + (Point2(p) - slant_ * p.z - eye_) / w;
}

/// With a target that is set in their middle.
Bounds FittedCamera::about_target(Bounds seen) const {
  if (!camera_.look_at) return seen;
  const Point3 reach = glm::max(glm::abs(seen.low), glm::abs(seen.high));
  seen.include({-reach.x, -reach.y, seen.low.z});
  seen.include({reach.x, reach.y, seen.low.z});
  return seen;
}

/// Includes the letters of the texts, as large as they are in a window of that height.
Bounds FittedCamera::with_letters(Bounds seen, std::span<const PlacedText> texts,
                                  double height) const {
  const double z = seen.low.z;
  for (const auto& [at, letters] : texts) {
    const Point2 anchor = in_window(at);
    seen.include({anchor + height * letters.low, z});
    seen.include({anchor + height * letters.high, z});
  }
  return about_target(seen);
}

double FittedCamera::height_around(const Bounds& seen) const {
  const Rectangle window = fitted_window(seen, aspect_, kDepthMargin * radius_);
  return window.y_max - window.y_min;
}

/// The height of the window around what is seen and the letters of these texts: a larger window
/// makes them larger on the view plane, so it grows until they are in it, up to `most`.
double FittedCamera::height_for(const Bounds& seen, std::span<const PlacedText> texts,
                                double most) const {
  constexpr int kMostGrowths = 200;  // each leaves a part of the rest, at most about nine tenths
  constexpr double kNearEnough = 1e-6;
  double height = height_around(seen);
  for (int k = 0; k < kMostGrowths && height < most; ++k) {
    const double next = height_around(with_letters(seen, texts, height));
    if (next <= (1.0 + kNearEnough) * height) break;
    height = next;
  }
  return std::min(height, most);
}

/// The bounds with the letters of texts, except those that need too large a window by themselves.
Bounds FittedCamera::with_letters(const Bounds& seen) const {
  const double most = kMostForLetters * height_around(seen);
  std::vector<PlacedText> kept;
  std::ranges::copy_if(texts_, std::back_inserter(kept), [&](const PlacedText& text) {
    return height_for(seen, std::span(&text, 1), most) < most;
  });
  return kept.empty() ? seen : with_letters(seen, kept, height_for(seen, kept, most));
}

void FittedCamera::fit_window() {
  Bounds points;
  for (const Point3& p : points_) points.include({in_window(p), p.z});
  const Bounds seen = about_target(points);
  view_.set_window(fitted_window(with_letters(seen), aspect_, kDepthMargin * radius_));
  shown_ = {seen.low.x, seen.high.x, seen.low.y, seen.high.y};
}

void FittedCamera::set_scale(const ExactScale& scale, const Rectangle& viewport) {
  if (!shown_) return;
  const double aspect = aspect_ / shape_of(viewport);
  view_.set_window(window_at_scale(scale, view_.projection, *shown_, viewport, aspect));
}

/// Encloses the points between the front and back planes, the front plane in front of the eye.
void FittedCamera::enclose_depth() {
  double front = -HUGE_VAL, back = HUGE_VAL;
  for (const Point3& p : points_) {
    front = std::max(front, p.z);
    back = std::min(back, p.z);
  }
  const double margin = kDepthMargin * radius_;
  front += margin;
  if (!camera_.parallel) front = std::min(front, (1.0 - kNearestFront) * distance_);
  view_.set_depth(view_.distance - front, view_.distance - std::min(back, front) + margin);
}

}  // namespace

View fit(const View& view, std::span<const Point3> points, double aspect) {
  const RoundToNearest nearest;
  if (!(aspect > 0.0 && aspect <= kCoordinateLimit)) {
    throw Error(fmt::format("aspect ratio {}: expected a positive number", aspect));
  }
  return FittedCamera(points, aspect, view).view();
}

View fit(const View& view, const Point3& low, const Point3& high, double aspect) {
  std::array<Point3, 8> corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    corners[k] = {(k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y,
                  (k & 4) != 0 ? high.z : low.z};
  }
  return fit(view, corners, aspect);
}

View fit(const View& view, const GraphicsSystem& system) {
  const RetainedScene* const scene = system.retained();
  if (scene == nullptr) throw Error("no scene is retained to fit the view to: expected retain()");
  std::vector<Point3> points;
  for (const RetainedScene::Segment& segment : scene->segments()) {
    if (!system.display_file().segment(segment.name).visible) continue;
    const std::span<const Point3> of_segment = scene->points(segment);
    points.insert(points.end(), of_segment.begin(), of_segment.end());
  }
  return fit(view, points, shape_in_picture(view.viewport, system.aspect_ratio()));
}

void append_used_vertices(const Mesh& mesh, const ModellingTransformation& modelling,
                          std::vector<Point3>& world) {
  std::vector<std::uint8_t> is_used(mesh.vertices.size(), 0);
  for (const std::uint32_t corner : mesh.corners) is_used[corner] = 1;
  world.reserve(world.size() + mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (is_used[v] != 0) world.push_back(modelling.apply(mesh.vertices[v]));
  }
}

namespace {

/// Appends the vertices of a cut polygon, except those that lie in a plane between two others that
/// do: they are between these, or ends of what the cut left of no area.
void append_outermost(std::span<const Point3> vertices, const CuttingPlanes& planes,
                      std::vector<Point3>& points) {
  const auto planes_at = [&](std::size_t k) {
    return planes.on() & ~planes.sides(vertices[k % vertices.size()]).inside;
  };
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const unsigned here = planes_at(k);
    if (here != 0 && (here & planes_at(k + vertices.size() - 1) & planes_at(k + 1)) != 0) continue;
    points.push_back(vertices[k]);
  }
}

}  // namespace

void append_corners_left(const Mesh& mesh, const Mesh::Object& object,
                         const ModellingTransformation& modelling, const CuttingPlanes& planes,
                         std::vector<Point3>& world) {
  const glm::dmat4x3& columns = modelling.affine();
  CuttingPlanes cutting = planes;
  cutting.set_reach(
      {entered_reach(mesh) *
           std::max({glm::length(columns[0]), glm::length(columns[1]), glm::length(columns[2])}),
       entered_reach(kUnlessSet, 1.0)});
  std::vector<Point3> face, in_planes;
  const std::size_t before = world.size();
  for (std::size_t i = object.first_face; i < object.first_face + object.faces; ++i) {
    face.clear();
    for (const std::uint32_t corner : mesh.face(i)) {
      face.push_back(modelling.apply(mesh.vertices[corner]));
    }
    const CutPolygon left = cutting.cut(face, {}, {});
    const std::size_t before_face = world.size();
    append_outermost(left.vertices, cutting, world);
    if (world.size() > before_face) continue;
    in_planes.insert(in_planes.end(), left.vertices.begin(), left.vertices.end());
  }
  if (world.size() == before) world.insert(world.end(), in_planes.begin(), in_planes.end());
}

void append_vertices_left(const Mesh& mesh, const GraphicsSystem& system,
                          std::vector<Point3>& world) {
  const ModellingTransformation& modelling = system.modelling_transformation();
  const CuttingPlanes& planes = SystemInside::cutting_planes(system);
  if (!planes.any()) return append_used_vertices(mesh, modelling, world);
  for (const Mesh::Object& object : mesh.objects) {
    append_corners_left(mesh, object, modelling, planes, world);
  }
}

namespace {

/// The texts with their letters in heights of the viewport.
std::vector<PlacedText> in_heights_of(const Rectangle& viewport,
                                      std::span<const PlacedText> texts) {
  const double height = viewport.y_max - viewport.y_min;
  std::vector<PlacedText> all(texts.begin(), texts.end());
  for (PlacedText& text : all) {
    text.letters.low /= height;
    text.letters.high /= height;
  }
  return all;
}

}  // namespace

std::optional<View> fitted_view(std::span<const Point3> world, const GraphicsSystem& system,
                                const Camera& camera, const CameraAsSet& set_before,
                                std::span<const PlacedText> texts) {
  const RoundToNearest nearest;
  const bool has_camera = set_before.settings.contains(Setting::camera);
  if (set_before.settings.contains(Setting::window)) {
    if (has_camera || !set_before.camera_beside_window) return std::nullopt;
    if (camera.angle_of_view) {
      throw Error("an angle of view, and a window that a program sets: expected one of them");
    }
    return FittedCamera(world, std::nullopt, camera).view();
  }
  if (has_camera && !camera.fit) return std::nullopt;
  const Rectangle& viewport = set_before.view.viewport;
  const double aspect = shape_in_picture(viewport, system.aspect_ratio());
  const std::vector<PlacedText> in_viewport = in_heights_of(viewport, texts);
  FittedCamera fitted = has_camera ? FittedCamera(world, aspect, set_before.view, in_viewport)
                                   : FittedCamera(world, aspect, camera, in_viewport);
  if (const auto& scale = SystemInside::scale(system)) fitted.set_scale(*scale, viewport);
  return fitted.view();
}

void set_fitted_view(const View& view, GraphicsSystem& system, const CameraAsSet& set_before) {
  const RoundToNearest nearest;
  const auto is_set = [&](Setting setting) { return set_before.settings.contains(setting); };
  if (!is_set(Setting::camera)) set_camera(view, system);
  if (!is_set(Setting::view_depth)) system.set_view_depth(view.front, view.back);
  if (!is_set(Setting::front_plane_clipping)) system.set_front_plane_clipping(false);
  if (!is_set(Setting::back_plane_clipping)) system.set_back_plane_clipping(false);
  if (is_set(Setting::window)) return;
  const Rectangle& window = view.window;
  system.set_window(window.x_min, window.x_max, window.y_min, window.y_max);
  if (!is_set(Setting::viewport)) system.set_viewport(0.0, 1.0, 0.0, 1.0);
}

void fit_view(std::span<const Point3> world, GraphicsSystem& system, const Camera& camera,
              const CameraAsSet& set_before) {
  const auto view = fitted_view(world, system, camera, set_before);
  if (view) set_fitted_view(*view, system, set_before);
}

void fit_view(std::span<const Point3> world, GraphicsSystem& system, const Camera& camera) {
  const RoundToNearest nearest;
  fit_view(world, system, camera, {system.view(), system.explicit_settings()});
}

CommonUpright fit_view(std::span<const Mesh> meshes, GraphicsSystem& system, const Camera& camera) {
  const RoundToNearest nearest;
  const ModellingTransformation& modelling = system.modelling_transformation();
  std::vector<Point3> world;
  CommonUpright common(camera);
  for (const Mesh& mesh : meshes) {
    append_vertices_left(mesh, system, world);
    common.add(mesh, modelling);
  }
  if (world.empty()) {
    for (const Mesh& mesh : meshes) append_used_vertices(mesh, modelling, world);
  }
  fit_view(world, system, common.camera());
  return common;
}

}  // namespace displayfile
