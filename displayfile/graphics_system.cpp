#include "displayfile/graphics_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "clip/back_face.h"
#include "clip/error.h"
#include "clip/memory.h"
#include "displayfile/characters.h"
#include "displayfile/hidden_surface_check.h"

namespace displayfile {

namespace {

/// A limit of magnitudes, and how messages write it.
struct Limit {
  double most;
  const char* text;
};
constexpr Limit kOfCoordinates{kCoordinateLimit, "1e100"};
/// Device coordinates stay within what the interpreter's predicates are proven for; so do the
/// products of a scale and a centre.
constexpr Limit kOfImageParts{1e90, "1e90"}, kOfImageCentres{1e9, "1e9"};

void require_within(const Limit& limit, std::initializer_list<double> values, const char* what) {
  for (double v : values) {
    if (!(std::abs(v) <= limit.most)) {
      throw Error(fmt::format("{} is {}: expected a finite number of magnitude at most {}", what, v,
                              limit.text));
    }
  }
}

void require_finite(std::initializer_list<double> values, const char* what) {
  require_within(kOfCoordinates, values, what);
}

void require_colour(const Colour& c) {
  for (int i = 0; i < 3; ++i) {
    if (!(c[i] >= 0.0 && c[i] <= 1.0)) {
      throw Error(fmt::format("colour component {} out of range: expected 0 to 1", c[i]));
    }
  }
}

}  // namespace

// ---- View parameters -------------------------------------------------------------------

void GraphicsSystem::require_view_may_change() const {
  if (open_) {
    throw Error(fmt::format(
        "segment {} is open: view parameters are set before a segment is opened", *open_));
  }
}

void GraphicsSystem::set_view_reference_point(const Point3& p) {
  require_view_may_change();
  view_.set_reference_point(p);
  record_said(Setting::camera, "set-view-reference-point", {p.x, p.y, p.z});
}

void GraphicsSystem::set_view_plane_normal(const Point3& n) {
  require_view_may_change();
  view_.set_plane_normal(n);
  record_said(Setting::camera, "set-view-plane-normal", {n.x, n.y, n.z});
}

void GraphicsSystem::set_view_distance(double d) {
  require_view_may_change();
  view_.set_distance(d);
  record_said(Setting::camera, "set-view-distance", {d});
}

void GraphicsSystem::set_view_up(const Point3& up) {
  require_view_may_change();
  view_.set_up(up);
  record_said(Setting::camera, "set-view-up", {up.x, up.y, up.z});
}

void GraphicsSystem::set_parallel(const Point3& direction) {
  require_view_may_change();
  view_.set_parallel(direction);
  record_said(Setting::camera, "set-parallel", {direction.x, direction.y, direction.z});
}

void GraphicsSystem::set_perspective(const Point3& centre) {
  require_view_may_change();
  view_.set_perspective(centre);
  record_said(Setting::camera, "set-perspective", {centre.x, centre.y, centre.z});
}

void GraphicsSystem::set_view_depth(double front, double back) {
  require_view_may_change();
  view_.set_depth(front, back);
  record_said(Setting::view_depth, "set-view-depth", {front, back});
}

void GraphicsSystem::set_front_plane_clipping(bool on) {
  require_view_may_change();
  view_.front_clipping = on;
  record_said(Setting::front_plane_clipping, "set-front-plane-clipping", {on});
}

void GraphicsSystem::set_back_plane_clipping(bool on) {
  require_view_may_change();
  view_.back_clipping = on;
  record_said(Setting::back_plane_clipping, "set-back-plane-clipping", {on});
}

void GraphicsSystem::set_window(double x_min, double x_max, double y_min, double y_max) {
  require_view_may_change();
  view_.set_window({x_min, x_max, y_min, y_max});
  record_said(Setting::window, "set-window", {x_min, x_max, y_min, y_max});
}

void GraphicsSystem::set_viewport(double x_min, double x_max, double y_min, double y_max) {
  require_view_may_change();
  view_.set_viewport({x_min, x_max, y_min, y_max});
  record_said(Setting::viewport, "set-viewport", {x_min, x_max, y_min, y_max});
}

void GraphicsSystem::set_window_fit(WindowFit fit) {
  require_view_may_change();
  window_fit_ = fit;
  record_said(Setting::window_fit, "set-window-fit", {name_of(fit)});
}

void GraphicsSystem::set_aspect_ratio(double aspect) {
  require_view_may_change();
  if (!(aspect > 0.0 && aspect <= kCoordinateLimit)) {
    throw Error(fmt::format("aspect ratio {}: expected a positive number", aspect));
  }
  aspect_ = aspect;
}

bool GraphicsSystem::view_was_set() const {
  constexpr std::array kOfView{Setting::camera,
                               Setting::view_depth,
                               Setting::front_plane_clipping,
                               Setting::back_plane_clipping,
                               Setting::window,
                               Setting::viewport};
  return std::ranges::any_of(kOfView, [&](Setting setting) { return said_.contains(setting); });
}

/// The view in force, its window in the shape that the picture wants.
View GraphicsSystem::view_in_picture() const {
  View view = view_;
  const bool mapping_was_set = said_.contains(Setting::window) || said_.contains(Setting::viewport);
  const bool widen =
      said_.contains(Setting::window_fit) ? window_fit_ == WindowFit::widen : !mapping_was_set;
  if (widen) view.window = widened(view.window, shape_in_picture(view.viewport, aspect_));
  return view;
}

/// Keeps the stretched window of the segment just opened for a warning, unless the application
/// said that its window should be stretched.
void GraphicsSystem::note_stretched_window(const View& view) {
  if (said_.contains(Setting::window_fit)) return;
  const StretchedWindow stretched{*open_, shape_of(view.window),
                                  shape_in_picture(view.viewport, aspect_)};
  const auto how_far = [](const StretchedWindow& w) {
    return std::max(w.window / w.viewport, w.viewport / w.window);
  };
  if (!shapes_differ(stretched.window, stretched.viewport)) return;
  if (!stretched_ || how_far(stretched) > how_far(*stretched_)) stretched_ = stretched;
}

// ---- The modelling transformation ------------------------------------------------------

void GraphicsSystem::create_transformation_3() {
  modelling_.create();
  record("create-transformation-3", {});
}

void GraphicsSystem::translate_3(double tx, double ty, double tz) {
  require_finite({tx, ty, tz}, "translation");
  modelling_.translate({tx, ty, tz});
  record("translate-3", {tx, ty, tz});
}

void GraphicsSystem::scale_3(double sx, double sy, double sz) {
  require_finite({sx, sy, sz}, "scale");
  modelling_.scale({sx, sy, sz});
  record("scale-3", {sx, sy, sz});
}

void GraphicsSystem::rotate_x_3(double angle) {
  require_finite({angle}, "angle");
  modelling_.rotate_x(angle);
  record("rotate-x-3", {angle});
}

void GraphicsSystem::rotate_y_3(double angle) {
  require_finite({angle}, "angle");
  modelling_.rotate_y(angle);
  record("rotate-y-3", {angle});
}

void GraphicsSystem::rotate_z_3(double angle) {
  require_finite({angle}, "angle");
  modelling_.rotate_z(angle);
  record("rotate-z-3", {angle});
}

void GraphicsSystem::save_transformation_3() {
  if (modelling_.saved() == kMostSaved) {
    throw Error(fmt::format("{} transformations are saved: expected no more, or one to be restored",
                            kMostSaved));
  }
  modelling_.save();
  record("save-transformation-3", {});
}

void GraphicsSystem::restore_transformation_3() {
  if (modelling_.saved() == 0) throw Error("no transformation saved");
  modelling_.restore();
  record("restore-transformation-3", {});
}

void GraphicsSystem::retain(RetainedScene* scene) {
  if (scene != nullptr && !display_file_.segments().empty()) {
    throw Error("there are segments already: expected to retain from the first one on");
  }
  retained_ = scene;
  own_retained_.reset();
}

// ---- Segments --------------------------------------------------------------------------

void GraphicsSystem::open_segment(int name) {
  if (open_) throw Error(fmt::format("segment already open: segment {}; close it first", *open_));
  const View view = view_in_picture();
  const ViewVolume volume(view);
  display_file_.create(name);
  view_stage_.emplace(volume);
  open_ = name;
  if (RetainedScene* scene = retaining()) scene->open_segment(name, view);
  note_stretched_window(view);
  record("open-segment", {name});
}

/// Algorithm 9.5, CLOSE-SEGMENT. The polygons are already in the display file, in order of entry;
/// if hidden surfaces are to be sorted they are added back to front.
void GraphicsSystem::close_segment() {
  if (!open_) throw Error("no segment open");
  Segment& segment = display_file_.segment(*open_);
  const bool each_on_its_own = scope_.value_or(HiddenScope::segment) == HiddenScope::segment;
  if (hidden_ && sorts(method_) && each_on_its_own) {
    segment.set_sorted(hidden_surface_check(segment.entered(), {}, method_, sort_options_));
  }
  segment.close();
  open_.reset();
  record("close-segment", {});
}

void GraphicsSystem::delete_segment(int name) {
  if (open_ == name) throw Error(fmt::format("segment {} still open: close it first", name));
  display_file_.remove(name);
  if (RetainedScene* scene = retaining()) scene->remove(name);
  record("delete-segment", {name});
}

void GraphicsSystem::delete_all_segments() {
  if (open_) throw Error(fmt::format("segment {} still open: close it first", *open_));
  display_file_.remove_all();
  if (RetainedScene* scene = retaining()) scene->remove_all();
  record("delete-all-segments", {});
}

void GraphicsSystem::rename_segment(int from, int to) {
  if (open_ == from) throw Error(fmt::format("segment {} still open: close it first", from));
  display_file_.rename(from, to);
  if (RetainedScene* scene = retaining()) scene->rename(from, to);
  record("rename-segment", {from, to});
}

void GraphicsSystem::set_visibility(int name, bool on) {
  display_file_.segment(name).visible = on;
  record("set-visibility", {name, on});
}

void GraphicsSystem::set_image_translation(int name, double tx, double ty) {
  require_within(kOfImageParts, {tx, ty}, "image translation");
  display_file_.segment(name).image.translation = {tx, ty};
  record("set-image-translation", {name, tx, ty});
}

void GraphicsSystem::set_image_scale(int name, double sx, double sy) {
  require_within(kOfImageParts, {sx, sy}, "image scale");
  display_file_.segment(name).image.scale = {sx, sy};
  record("set-image-scale", {name, sx, sy});
}

void GraphicsSystem::set_image_rotation(int name, double angle) {
  require_finite({angle}, "angle");
  display_file_.segment(name).image.rotation = angle;
  record("set-image-rotation", {name, angle});
}

void GraphicsSystem::set_image_centre(int name, double x, double y) {
  require_within(kOfImageCentres, {x, y}, "image centre");
  display_file_.segment(name).image.centre = {x, y};
  record("set-image-centre", {name, x, y});
}

// ---- Primitives ------------------------------------------------------------------------

void GraphicsSystem::require_open() const {
  if (!open_) throw Error("no segment open");
}

Point3 GraphicsSystem::to_world(const Point3& object) const {
  if (!in_range(object)) {
    throw Error(
        fmt::format("coordinates {} {} {}: expected finite numbers of magnitude at most 1e100",
                    object.x, object.y, object.z));
  }
  const Point3 world = modelling_.apply(object);
  if (!in_range(world)) throw Error("coordinate out of range after the modelling transformation");
  return world;
}

void GraphicsSystem::move_to(const Point3& object) {
  require_open();
  pen_ = {object, to_world(object)};
}

void GraphicsSystem::line_to(const Point3& object) {
  require_open();
  const Pen end{object, to_world(object)};
  if (attributes_.line.kind != LineStyle::Kind::none) {
    Segment& segment = display_file_.segment(*open_);
    segment.set_line_pick(pick_);
    if (RetainedScene* scene = retaining()) {
      scene->enter_line(pen_.world, end.world, attributes_, pick_);
    }
    view_stage_->enter_line(pen_.world, end.world, attributes_.line, segment);
  }
  pen_ = end;
}

void GraphicsSystem::move_abs_3(double x, double y, double z) {
  move_to({x, y, z});
  record("move-abs-3", {x, y, z});
}

void GraphicsSystem::line_abs_3(double x, double y, double z) {
  line_to({x, y, z});
  record("line-abs-3", {x, y, z});
}

void GraphicsSystem::move_rel_3(double dx, double dy, double dz) {
  move_to(pen_.object + Point3(dx, dy, dz));
  record("move-rel-3", {dx, dy, dz});
}

void GraphicsSystem::line_rel_3(double dx, double dy, double dz) {
  line_to(pen_.object + Point3(dx, dy, dz));
  record("line-rel-3", {dx, dy, dz});
}

void GraphicsSystem::move_abs_2(double x, double y) {
  move_to({x, y, pen_.object.z});
  record("move-abs-2", {x, y});
}

void GraphicsSystem::line_abs_2(double x, double y) {
  line_to({x, y, pen_.object.z});
  record("line-abs-2", {x, y});
}

void GraphicsSystem::move_rel_2(double dx, double dy) {
  move_to(pen_.object + Point3(dx, dy, 0.0));
  record("move-rel-2", {dx, dy});
}

void GraphicsSystem::line_rel_2(double dx, double dy) {
  line_to(pen_.object + Point3(dx, dy, 0.0));
  record("line-rel-2", {dx, dy});
}

void GraphicsSystem::polygon_abs_3(std::span<const Point3> vertices) {
  polygon(vertices);
  if (recorder_ != nullptr) recorder_->write("polygon-abs-3", vertices, 3);
}

void GraphicsSystem::polygon_rel_3(std::span<const Point3> steps) {
  object_points_.clear();
  Point3 p = pen_.object;
  for (const Point3& step : steps) object_points_.push_back(p += step);
  polygon(object_points_);
  if (recorder_ != nullptr) recorder_->write("polygon-rel-3", steps, 3);
}

void GraphicsSystem::polygon_abs_2(std::span<const Point2> vertices) {
  object_points_.clear();
  for (const Point2& v : vertices) object_points_.emplace_back(v, pen_.object.z);
  polygon(object_points_);
  if (recorder_ != nullptr) recorder_->write("polygon-abs-2", object_points_, 2);
}

void GraphicsSystem::polygon_rel_2(std::span<const Point2> steps) {
  object_points_.clear();
  Point3 p = pen_.object;
  for (const Point2& step : steps) object_points_.push_back(p += Point3(step, 0.0));
  polygon(object_points_);
  if (recorder_ == nullptr) return;
  object_points_.clear();
  for (const Point2& step : steps) object_points_.emplace_back(step, 0.0);
  recorder_->write("polygon-rel-2", object_points_, 2);
}

/// The way of one polygon: to world coordinates, to triangles if it is not flat or its vertices
/// have normals that differ, and each piece through the pipeline into the display file.
void GraphicsSystem::polygon(std::span<const Point3> object) {
  require_open();
  if (object.size() < 3) {
    throw Error(fmt::format("polygon of {} sides: expected at least 3", object.size()));
  }
  if (!vertex_normals_.empty() && vertex_normals_.size() != object.size()) {
    throw Error(fmt::format("polygon of {} sides: expected {}, as many as set-vertex-normals has",
                            object.size(), vertex_normals_.size()));
  }
  world_points_.resize(object.size());
  for (std::size_t i = 0; i < object.size(); ++i) world_points_[i] = to_world(object[i]);
  const int pick = pick_ >= 0 ? pick_ : static_cast<int>(ordinal_);
  const Point3 normal = attributes_.light ? newell_normal(world_points_) : Point3(0.0);
  const bool smooth = attributes_.light && shading_ == Shading::gouraud && !vertex_normals_.empty();
  const auto vertex_normals = smooth ? world_normals(normal) : std::span<const Point3>();
  const bool flat = is_flat(world_points_);
  if (flat && (object.size() == 3 || !differ(vertex_normals))) {
    enter({world_points_, {}, normal, vertex_normals, pick});
  } else {
    enter_triangles(normal, vertex_normals, pick);
  }
  triangulated_ += flat ? 0 : 1;
  ++ordinal_;
  vertex_normals_.clear();
  pen_ = {object.back(), world_points_.back()};
}

/// The normals that the application gave the polygon's vertices, in world coordinates.
std::span<const Point3> GraphicsSystem::world_normals(const Point3& own) {
  world_normals_.clear();
  for (const Point3& n : vertex_normals_) world_normals_.push_back(modelling_.apply_to_normal(n));
  orient(world_normals_, own);
  return world_normals_;
}

void GraphicsSystem::enter_triangles(const Point3& normal, std::span<const Point3> vertex_normals,
                                     int pick) {
  const auto corners = [](std::span<const Point3> of_polygon, const auto& vertex) {
    return std::array{of_polygon[vertex[0]], of_polygon[vertex[1]], of_polygon[vertex[2]]};
  };
  for (const auto& [vertex, edge_visible] : triangulation_.triangulate(world_points_)) {
    const auto triangle = corners(world_points_, vertex);
    if (vertex_normals.empty()) {
      enter({triangle, edge_visible, normal, {}, pick});
    } else {
      const auto of_corners = corners(vertex_normals, vertex);
      enter({triangle, edge_visible, normal, of_corners, pick});
    }
  }
}

void GraphicsSystem::enter(const WorldPolygon& polygon) {
  if (RetainedScene* scene = retaining()) scene->enter_polygon(polygon, attributes_);
  view_stage_->enter_polygon(polygon, attributes_, display_file_.segment(*open_));
}

namespace {

/// Checks what polygons_abs_3 is given, but for coordinates.
void require_polygons(std::size_t vertices, std::span<const std::uint32_t> corners,
                      std::span<const std::uint32_t> sides, std::size_t fills) {
  std::size_t of_all = 0;
  for (const std::uint32_t n : sides) {
    if (n < 3) throw Error(fmt::format("polygon of {} sides: expected at least 3", n));
    of_all += n;
  }
  if (sides.empty() ? corners.size() % 3 != 0 : of_all != corners.size()) {
    throw Error(fmt::format("{} corners: expected {}", corners.size(),
                            sides.empty() ? "three of each polygon" : std::to_string(of_all)));
  }
  const std::size_t polygons = sides.empty() ? corners.size() / 3 : sides.size();
  if (fills > 1 && fills != polygons) {
    throw Error(fmt::format("{} fill styles of {} polygons: expected one, or one for each", fills,
                            polygons));
  }
  for (const std::uint32_t corner : corners) {
    if (corner >= vertices) {
      throw Error(fmt::format("vertex {} of {}: expected an index from 0", corner, vertices));
    }
  }
}

}  // namespace

void GraphicsSystem::polygons_abs_3(std::span<const Point3> vertices,
                                    std::span<const std::uint32_t> corners,
                                    std::span<const std::uint32_t> sides,
                                    std::span<const FillStyle> fills) {
  require_open();
  require_polygons(vertices.size(), corners, sides, fills.size());
  if (!vertex_normals_.empty()) {
    throw Error("normals of one polygon's vertices are set: expected none before many polygons");
  }
  for (const FillStyle& fill : fills) {
    if (fill.kind == FillStyle::Kind::solid) require_colour(fill.colour);
  }
  Segment& segment = display_file_.segment(*open_);
  const std::size_t polygons = sides.empty() ? corners.size() / 3 : sides.size();
  const std::span<const Point3> world = with_memory(
      vertices.size() * sizeof(Point3) + corners.size() * (sizeof(Point3) + sizeof(std::int32_t)),
      [&] { return fmt::format("entering {} polygons of {} corners", polygons, corners.size()); },
      [&] {
        const std::span<const Point3> of_all = shared_world(vertices);
        view_stage_->view_vertices(of_all);
        segment.reserve_polygons(polygons, corners.size());
        return of_all;
      });
  if (RetainedScene* scene = retaining()) scene->begin_shared(world.size());
  keep_fill_style([&] {
    std::size_t first = 0;
    for (std::size_t k = 0; k < polygons; ++k) {
      if (k < fills.size() && fills[k] != attributes_.fill) set_fill_style(fills[k]);
      const auto polygon = corners.subspan(first, sides.empty() ? 3 : sides[k]);
      first += polygon.size();
      enter_shared(world, polygon, segment);
      if (recorder_ == nullptr) continue;
      object_points_.clear();
      for (const std::uint32_t corner : polygon) object_points_.push_back(vertices[corner]);
      recorder_->write("polygon-abs-3", object_points_, 3);
    }
  });
  if (!corners.empty()) pen_ = {vertices[corners.back()], world[corners.back()]};
}

/// Valid until the next call, and as long as the vertices themselves.
std::span<const Point3> GraphicsSystem::shared_world(std::span<const Point3> vertices) {
  if (modelling_.is_identity() && std::ranges::all_of(vertices, in_range)) return vertices;
  shared_world_.resize(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) shared_world_[i] = to_world(vertices[i]);
  return shared_world_;
}

/// One polygon of many.
void GraphicsSystem::enter_shared(std::span<const Point3> world,
                                  std::span<const std::uint32_t> corners, Segment& segment) {
  const int pick = pick_ >= 0 ? pick_ : static_cast<int>(ordinal_);
  ++ordinal_;
  const bool plain = corners.size() == 3 && retaining() == nullptr;
  if (plain && view_stage_->enter_plain(corners, pick, attributes_, segment)) return;
  const PointRow vertices(world, corners);
  const Point3 normal = attributes_.light ? newell_normal(vertices) : Point3(0.0);
  if (corners.size() != 3 && !is_flat(vertices)) {
    ++triangulated_;
    world_points_.assign(vertices.begin(), vertices.end());
    return enter_triangles(normal, {}, pick);
  }
  const WorldPolygon polygon{std::span(vertices), {}, normal, {}, pick};
  if (RetainedScene* scene = retaining()) scene->enter_shared(corners, polygon, attributes_);
  view_stage_->enter_shared(corners, polygon, attributes_, segment);
}

void GraphicsSystem::text(std::string_view characters) {
  require_open();
  if (characters.size() > kLongestText) {
    throw Error(
        fmt::format("text of {} bytes: expected at most {}", characters.size(), kLongestText));
  }
  if (const std::size_t good = drawable_length(characters); good < characters.size()) {
    throw Error(not_drawable(characters.substr(good)));
  }
  if (!characters.empty()) {
    if (RetainedScene* scene = retaining()) {
      scene->enter_text(pen_.world, characters, attributes_);
    }
    view_stage_->enter_text(pen_.world, characters, attributes_, display_file_.segment(*open_));
  }
  if (recorder_ == nullptr) return;
  const std::string quoted = in_quotation_marks(characters);
  record("text", {std::string_view(quoted)});
}

// ---- Attributes ------------------------------------------------------------------------

void GraphicsSystem::set_fill_style(const FillStyle& style) {
  attributes_changed();
  if (style.kind == FillStyle::Kind::hollow) {
    attributes_.fill = {
        FillStyle::Kind::hollow};  // a colour has no meaning here: one representation
    return record_said(Setting::fill_style, "set-fill-style", {"hollow"});
  }
  require_colour(style.colour);
  attributes_.fill = {FillStyle::Kind::solid, style.colour};
  record_said(Setting::fill_style, "set-fill-style",
              {"solid", style.colour.r, style.colour.g, style.colour.b});
}

void GraphicsSystem::set_line_style(const LineStyle& style) {
  attributes_changed();
  if (style.kind == LineStyle::Kind::none) {
    attributes_.line = {LineStyle::Kind::none};
    return record_said(Setting::line_style, "set-line-style", {"none"});
  }
  require_colour(style.colour);
  const bool dashed = style.kind == LineStyle::Kind::dashed;
  for (double length : {style.width, style.dash, style.gap}) {
    if (!(length > 0.0 && length <= 1e6)) {
      throw Error(fmt::format("line width or dash {}: expected more than 0 pixels and at most 1e6",
                              length));
    }
  }
  attributes_.line = style;
  const Colour& c = style.colour;
  if (dashed) {
    record_said(Setting::line_style, "set-line-style",
                {"dashed", c.r, c.g, c.b, style.width, style.dash, style.gap});
  } else {
    attributes_.line.dash = LineStyle{}.dash;  // of no meaning here: one style, one representation
    attributes_.line.gap = LineStyle{}.gap;
    record_said(Setting::line_style, "set-line-style", {"solid", c.r, c.g, c.b, style.width});
  }
}

void GraphicsSystem::set_text_style(const TextStyle& style) {
  if (!(style.size > 0.0 && style.size <= 1.0)) {
    throw Error(fmt::format(
        "text size {}: expected more than 0 and at most 1, the picture's height", style.size));
  }
  attributes_.text = style;
  if (style.always) {
    record("set-text-style", {style.size, name_of(style.alignment), "always"});
  } else {
    record("set-text-style", {style.size, name_of(style.alignment)});
  }
}

void GraphicsSystem::set_light(const Point3& toward, double ambient) {
  require_finite({toward.x, toward.y, toward.z}, "light direction");
  if (toward == Point3(0.0)) throw Error("light direction is zero: expected a direction");
  if (!(ambient >= 0.0 && ambient <= 1.0)) {
    throw Error(fmt::format("ambient light {}: expected 0 to 1", ambient));
  }
  attributes_.light = {unit(toward), ambient};
  record_said(Setting::light, "set-light", {toward.x, toward.y, toward.z, ambient});
}

void GraphicsSystem::set_shading(Shading shading) {
  shading_ = shading;
  record("set-shading", {name_of(shading)});
}

void GraphicsSystem::set_shadows(bool on) {
  attributes_.shadows = on;
  record("set-shadows", {on});
}

void GraphicsSystem::set_vertex_normals(std::span<const Point3> normals) {
  if (normals.size() == 1 || normals.size() == 2) {
    throw Error(
        fmt::format("normals of {} vertices: expected at least 3, or none", normals.size()));
  }
  for (const Point3& n : normals) require_finite({n.x, n.y, n.z}, "vertex normal");
  vertex_normals_.assign(normals.begin(), normals.end());
  if (recorder_ != nullptr) recorder_->write("set-vertex-normals", normals, 3);
}

void GraphicsSystem::set_background(const Background& background) {
  if (background.kind == Background::Kind::none) {
    background_ = {Background::Kind::none};
    return record("set-background", {"none"});
  }
  require_colour(background.colour);
  background_ = background;
  const Colour& c = background.colour;
  record("set-background", {c.r, c.g, c.b});
}

void GraphicsSystem::set_pick_id(int id) {
  if (id < -1) throw Error(fmt::format("pick identifier {}: expected 0 or more, or -1", id));
  pick_ = id;
  record("set-pick-id", {id});
}

// ---- Hidden surfaces -------------------------------------------------------------------

void GraphicsSystem::set_hidden_line_removal(bool on) {
  hidden_ = on;
  attributes_.back_face_removal = on;
  said_.insert(Setting::back_face_removal);
  record_said(Setting::hidden_line_removal, "set-hidden-line-removal", {on});
}

void GraphicsSystem::set_back_face_removal(bool on) {
  attributes_.back_face_removal = on;
  record_said(Setting::back_face_removal, "set-back-face-removal", {on});
}

void GraphicsSystem::set_hidden_method(HiddenMethod method) {
  const HiddenMethod known = displayfile::hidden_method(name_of(method));  // or refuses
  if (known == HiddenMethod::world_ray_cast && retained() == nullptr) {
    if (!display_file_.segments().empty()) {
      throw Error(
          "world-ray-cast needs world coordinates, which the segments that there are have not "
          "retained: expected it before the first segment");
    }
    own_retained_.emplace();
  }
  method_ = known;
  record("set-hidden-method", {name_of(method)});
}

void GraphicsSystem::set_hidden_scope(HiddenScope scope) {
  scope_ = scope;
  record("set-hidden-scope", {name_of(scope)});
}

void GraphicsSystem::set_precision(const Precision& precision) {
  const double roundoff = precision.roundoff;
  if (!precision.exact && !(roundoff >= 0.0 && roundoff < 1.0)) {
    throw Error(fmt::format("ROUNDOFF {}: expected 0 or more and less than 1", roundoff));
  }
  sort_options_.precision = precision;
  if (recorder_ == nullptr) return;
  const std::string text = precision.exact ? "exact" : fmt::format("roundoff={}", roundoff);
  record("set-precision", {std::string_view(text)});
}

void GraphicsSystem::set_z_buffer(bool on) {
  z_buffer_ = on;
  record("set-z-buffer", {on});
}

}  // namespace displayfile
