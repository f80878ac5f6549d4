#include "displayfile/user_routines/system_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "clip/base/memory.h"
#include "clip/base/round_to_nearest.h"
#include "clip/base/work_budget.h"
#include "clip/geometry/back_face.h"
#include "clip/geometry/planarity.h"
#include "displayfile/entered/instructions.h"
#include "displayfile/solids/solid_faces.h"
#include "displayfile/user_routines/ranges.h"
#include "displayfile/user_routines/system_inside.h"

namespace displayfile {

void GraphicsSystem::State::require_open() const {
  if (!open_) throw Error("no segment open: open one first");
}

/// The pick identifier of the next polygon.
int GraphicsSystem::State::next_pick() const {
  return pick_ >= 0 ? pick_ : pick_of_ordinal(ordinal_);
}

Point3 GraphicsSystem::State::to_world(const Point3& object) const {
  if (!in_range(object)) {
    throw Error(
        fmt::format("coordinates {} {} {}: expected finite numbers of magnitude at most 1e100",
                    object.x, object.y, object.z));
  }
  const Point3 world = modelling_.apply(object);
  if (!in_range(world)) throw Error("coordinate out of range after the modelling transformation");
  return world;
}

void GraphicsSystem::polygon_abs_3(PointList<Point3> vertices) {
  if (state_->recorder_ == nullptr) [[likely]]
    return state_->polygon(vertices);
  state_->polygon(vertices);
  state_->recorder_->write("polygon-abs-3", vertices, 3);
}

void GraphicsSystem::polygon_rel_3(PointList<Point3> steps) {
  const RoundToNearest nearest;
  state_->object_points_.clear();
  Point3 p = state_->pen_.object;
  for (const Point3& step : steps) state_->object_points_.push_back(p += step);
  state_->polygon(state_->object_points_);
  if (state_->recorder_ != nullptr) state_->recorder_->write("polygon-rel-3", steps, 3);
}

void GraphicsSystem::polygon_abs_2(PointList<Point2> vertices) {
  state_->object_points_.clear();
  for (const Point2& v : vertices) state_->object_points_.emplace_back(v, state_->pen_.object.z);
  state_->polygon(state_->object_points_);
  if (state_->recorder_ != nullptr)
    state_->recorder_->write("polygon-abs-2", state_->object_points_, 2);
}

void GraphicsSystem::polygon_rel_2(PointList<Point2> steps) {
  const RoundToNearest nearest;
  state_->object_points_.clear();
  Point3 p = state_->pen_.object;
  for (const Point2& step : steps) state_->object_points_.push_back(p += Point3(step, 0.0));
  state_->polygon(state_->object_points_);
  if (state_->recorder_ == nullptr) return;
  state_->object_points_.clear();
  for (const Point2& step : steps) state_->object_points_.emplace_back(step, 0.0);
  state_->recorder_->write("polygon-rel-2", state_->object_points_, 2);
}

namespace {

void require_one_a_side(std::size_t values, std::size_t sides, std::string_view routine) {
  if (values == 0 || values == sides) return;
  throw Error(
      fmt::format("polygon of {} sides: expected {}, as many as {} has", sides, values, routine));
}

}  // namespace

/// Enters one polygon: transforms it to world coordinates, cuts it into triangles if it is not flat
/// or its vertices have normals that differ, and sends each piece through the pipeline into the
/// display file.
void GraphicsSystem::State::polygon(std::span<const Point3> object) {
  const RoundToNearest nearest;
  require_open();
  if (object.size() < 3) {
    throw Error(fmt::format("polygon of {} sides: expected at least 3", object.size()));
  }
  require_one_a_side(vertex_normals_.size(), object.size(), "set-vertex-normals");
  require_one_a_side(vertex_colours_.size(), object.size(), "set-vertex-colours");
  if (!vertex_colours_.empty()) require_no_solid("colours of vertices");
  world_points_.resize(object.size());
  for (std::size_t i = 0; i < object.size(); ++i) world_points_[i] = to_world(object[i]);
  const int pick = next_pick();
  ++ordinal_;
  const Point3 normal = looks_.attributes.light ? newell_normal(world_points_) : Point3(0.0);
  const bool smooth = looks_.attributes.light && looks_.attributes.shading != Shading::flat &&
                      !vertex_normals_.empty();
  const auto vertex_normals = smooth ? world_normals(normal) : std::span<const Point3>();
  const bool flat = is_flat(world_points_);
  const OnePolygon polygon{object, normal, vertex_normals, pick, flat};
  vertex_colours_.empty() ? enter_one(polygon) : enter_in_colours(polygon);
  triangulated_ += flat ? 0 : 1;
  if (!vertex_normals_.empty()) vertex_normals_.clear();
  if (!vertex_colours_.empty()) vertex_colours_.clear();
  pen_ = {object.back(), world_points_.back()};
}

void GraphicsSystem::State::enter_one(const OnePolygon& polygon) {
  const auto& [entered, normal, vertex_normals, pick, flat] = polygon;
  if (flat && (entered.size() == 3 || !differ(vertex_normals))) {
    enter({world_points_, {}, normal, vertex_normals, pick, entered, modelling_matrix()});
  } else {
    enter_triangles(entered, normal, vertex_normals, pick);
  }
}

/// The application's normals of the polygon's vertices, in world coordinates.
std::span<const Point3> GraphicsSystem::State::world_normals(const Point3& own) {
  world_normals_.clear();
  for (const Point3& n : vertex_normals_) world_normals_.push_back(modelling_.apply_to_normal(n));
  orient(world_normals_, own);
  return world_normals_;
}

/// Enters triangles of the polygon whose vertices are world_points_; `entered` are the same
/// vertices as the application entered them. One that crosses itself also has vertices there, but
/// not in a solid, where its neighbours have the whole sides.
void GraphicsSystem::State::enter_triangles(std::span<const Point3> entered, const Point3& normal,
                                            std::span<const Point3> vertex_normals, int pick) {
  const auto triangles = solids_.empty()
                             ? triangulation_.tile(world_points_, bent_polygons_seen_)
                             : triangulation_.triangulate(world_points_, bent_polygons_seen_);
  if (triangulation_.crossings().empty()) {
    return enter_triangles(triangles, {world_points_, entered, vertex_normals}, normal, pick);
  }
  const std::vector<Point3> all_entered = triangulation_.with_crossings(entered);
  std::vector<Point3> world = world_points_, normals;
  for (std::size_t i = world.size(); i < all_entered.size(); ++i) {
    world.push_back(to_world(all_entered[i]));
  }
  if (!vertex_normals.empty()) normals = triangulation_.with_crossings(vertex_normals);
  enter_triangles(triangles, {world, all_entered, normals}, normal, pick);
}

void GraphicsSystem::State::enter_triangles(std::span<const Triangulation::Triangle> triangles,
                                            const Corners& all, const Point3& normal, int pick) {
  const auto corners = [](std::span<const Point3> of_polygon, const auto& vertex) {
    return std::array{of_polygon[vertex[0]], of_polygon[vertex[1]], of_polygon[vertex[2]]};
  };
  for (const auto& [vertex, edge_visible] : triangles) {
    const auto triangle = corners(all.world, vertex);
    const auto as_entered = corners(all.entered, vertex);
    if (all.normals.empty()) {
      enter({triangle, edge_visible, normal, {}, pick, as_entered, modelling_matrix()});
    } else {
      const auto of_corners = corners(all.normals, vertex);
      enter({triangle, edge_visible, normal, of_corners, pick, as_entered, modelling_matrix()});
    }
  }
}

void GraphicsSystem::State::enter(const WorldPolygon& polygon) {
  if (!solids_.empty()) {
    return solids_.add(polygon, looks_.attributes, static_cast<std::uint32_t>(ordinal_));
  }
  cutting_planes_.any() ? enter_cut(polygon) : enter_whole(polygon);
}

void GraphicsSystem::State::enter_whole(const WorldPolygon& polygon) {
  if (RetainedScene* scene = retaining()) {
    scene->enter_polygon(polygon, looks_.attributes);
    if (is_viewed_later()) return;
  }
  view_stage_->enter_polygon(polygon, looks_.attributes, display_file_.segment(*open_));
}

namespace {

/// Checks the arguments of polygons_abs_3, except coordinates, and returns the number of polygons.
std::size_t require_polygons(const ManyPolygons& many) {
  std::size_t of_all = 0;
  for (const std::uint32_t n : many.sides) {
    if (n < 3) throw Error(fmt::format("polygon of {} sides: expected at least 3", n));
    of_all += n;
  }
  const std::size_t corners = many.corners.size();
  if (many.sides.empty() ? corners % 3 != 0 : of_all != corners) {
    throw Error(fmt::format("{} corners: expected {}", corners,
                            many.sides.empty() ? "three per polygon" : std::to_string(of_all)));
  }
  for (std::size_t k = 0; k < corners; ++k) {
    if (many.corners[k] < many.vertices.size()) continue;
    if (many.vertices.empty()) throw Error("corners of polygons, but no vertices");
    throw Error(fmt::format("corner {}: vertex {}: there are {} vertices: expected 0 to {}", k,
                            many.corners[k], many.vertices.size(), many.vertices.size() - 1));
  }
  return many.sides.empty() ? corners / 3 : many.sides.size();
}

/// Checks the styles, pick identifiers and normals.
void require_looks(const ManyPolygons& many, std::size_t polygons) {
  if (many.fills.size() > 1 && many.fills.size() != polygons) {
    throw Error(fmt::format("{} fill styles of {} polygons: expected one, or one per polygon",
                            many.fills.size(), polygons));
  }
  if (!many.picks.empty() && many.picks.size() != polygons) {
    throw Error(fmt::format("{} pick identifiers of {} polygons: expected one per polygon, or none",
                            many.picks.size(), polygons));
  }
  const auto require_one_a_vertex = [&](std::size_t values, std::string_view what) {
    if (values == 0 || values == many.vertices.size()) return;
    throw Error(fmt::format("{} {} of {} vertices: expected one per vertex, or none", values, what,
                            many.vertices.size()));
  };
  require_one_a_vertex(many.normals.size(), "normals");
  require_one_a_vertex(many.vertex_colours.size(), "colours");
  if (!many.vertex_colours.empty() && !many.fills.empty()) {
    throw Error("fill styles and colours of vertices: expected one of them");
  }
  for (const Colour& colour : many.vertex_colours) require_colour(colour);
  for (const FillStyle& fill : many.fills) {
    if (fill.kind == FillStyle::Kind::solid) require_colour(fill.colour);
  }
  for (const std::int32_t pick : many.picks) {
    if (pick < 0) throw Error(fmt::format("pick identifier {}: expected 0 or more", pick));
  }
  for (const Point3& n : many.normals) require_finite({n.x, n.y, n.z}, "vertex normal");
}

/// Enters a polygon as set_vertex_normals, set_vertex_colours and polygon_abs_3 do; overwrites
/// `of_corners`.
void enter_with_values(GraphicsSystem& system, const ManyPolygons& many,
                       std::span<const std::uint32_t> corners, std::vector<Point3>& of_corners) {
  const auto at_corners = [&](std::span<const Point3> of_vertices) -> std::vector<Point3>& {
    of_corners.clear();
    for (const std::uint32_t corner : corners) of_corners.push_back(of_vertices[corner]);
    return of_corners;
  };
  if (!many.normals.empty()) system.set_vertex_normals(at_corners(many.normals));
  if (!many.vertex_colours.empty()) system.set_vertex_colours(at_corners(many.vertex_colours));
  system.polygon_abs_3(at_corners(many.vertices));
}

}  // namespace

void GraphicsSystem::polygons_abs_3(const ManyPolygons& many) {
  const RoundToNearest nearest;
  const std::span vertices = many.vertices;
  const bool has_values = !many.normals.empty() || !many.vertex_colours.empty();
  const std::span corners = many.corners, sides = many.sides;
  const std::span fills = many.fills;
  const std::span picks = many.picks;
  state_->require_open();
  const std::size_t polygons = require_polygons(many);
  state_->require_no_values_of_vertices("many polygons");
  require_looks(many, polygons);
  ask_budget();  // before anything is entered; the next check is after everything is
  Segment& segment = state_->display_file_.segment(*state_->open_);
  const std::size_t styles = state_->looks_.attributes.light ? polygons : fills.size();
  const bool stays_open =
      !many.vertex_colours.empty() && state_->looks_.cut_faces.kind == CutFaces::Kind::open;
  bool is_solid = !state_->solids_.empty() || (state_->cutting_planes_.any() && !stays_open);
  const std::span<const Point3> world = with_memory(
      vertices.size() * sizeof(Point3) + corners.size() * (sizeof(Point3) + sizeof(std::int32_t)) +
          styles * sizeof(Colour),
      [&] { return fmt::format("entering {} polygons of {} corners", polygons, corners.size()); },
      [&] {
        const std::span<const Point3> of_all = state_->shared_world(vertices);
        is_solid = is_solid && !open_side(of_all, corners, sides);
        const bool is_whole = is_solid && state_->takes_whole_solids();
        if (!is_whole && state_->solids_.empty() && !has_values) {
          state_->make_room_for_shared({of_all, vertices, state_->modelling_matrix()}, polygons,
                                       corners.size(), styles);
        }
        return of_all;
      });
  const std::int32_t pick_in_force = state_->pick_;
  const RetainedScene::SharedVertices shared{world, vertices, state_->modelling_matrix()};
  const auto enter_all = [&] {
    const bool of_one_kind = sides.empty() && fills.size() <= 1 && picks.empty() && !has_values;
    const bool at_once = of_one_kind && !state_->cutting_planes_.any() && state_->solids_.empty();
    if (state_->is_viewed_later() && at_once && state_->recorder_ == nullptr) {
      if (!fills.empty() && fills[0] != state_->looks_.attributes.fill) set_fill_style(fills[0]);
      state_->retaining()->enter_shared_triangles(shared, corners, state_->looks_.attributes,
                                                  state_->next_pick(), state_->pick_ >= 0 ? 0 : 1);
      state_->ordinal_ += static_cast<std::int64_t>(polygons);
      return;
    }
    std::size_t first = 0;
    for (std::size_t k = 0; k < polygons; ++k) {
      if (k < fills.size() && fills[k] != state_->looks_.attributes.fill) set_fill_style(fills[k]);
      if (!picks.empty() && picks[k] != state_->pick_) set_pick_id(picks[k]);
      const auto polygon = corners.subspan(first, sides.empty() ? 3 : sides[k]);
      first += polygon.size();
      if (has_values) {
        enter_with_values(*this, many, polygon, state_->object_points_);
        continue;
      }
      state_->enter_shared(shared, polygon, segment);
      if (state_->recorder_ == nullptr) continue;
      state_->object_points_.clear();
      for (const std::uint32_t corner : polygon) state_->object_points_.push_back(vertices[corner]);
      state_->recorder_->write("polygon-abs-3", state_->object_points_, 3);
    }
    if (state_->pick_ != pick_in_force) set_pick_id(pick_in_force);
  };
  try {
    if (is_solid) {
      SystemInside::as_solid(
          *this, [&] { SystemInside::keep_fill_style(*this, enter_all); },
          enclosed_volume(world, corners, sides));
    } else {
      SystemInside::keep_fill_style(*this, enter_all);
    }
  } catch (...) {
    if (state_->pick_ != pick_in_force) set_pick_id(pick_in_force);
    throw;
  }
  if (!corners.empty()) state_->pen_ = {vertices[corners.back()], world[corners.back()]};
}

/// Valid until the next call, and as long as the vertices themselves.
std::span<const Point3> GraphicsSystem::State::shared_world(std::span<const Point3> vertices) {
  if (modelling_.is_identity() && std::ranges::all_of(vertices, in_range)) return vertices;
  shared_world_.resize(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) shared_world_[i] = to_world(vertices[i]);
  return shared_world_;
}

void GraphicsSystem::State::make_room_for_shared(const RetainedScene::SharedVertices& shared,
                                                 std::size_t polygons, std::size_t corners,
                                                 std::size_t fills) {
  const std::size_t vertices = shared.world.size();
  if (RetainedScene* scene = retaining()) scene->begin_shared(vertices, polygons, corners);
  if (is_viewed_later()) return;
  Segment& segment = display_file_.segment(*open_);
  view_stage_->view_vertices(shared.world);
  view_stage_->note_entered(shared.entered, shared.modelling, segment);
  segment.reserve_polygons(polygons, corners, fills);
}

/// Enters one polygon of many.
void GraphicsSystem::State::enter_shared(const RetainedScene::SharedVertices& shared,
                                         std::span<const std::uint32_t> corners, Segment& segment) {
  const std::span world = shared.world;
  const int pick = next_pick();
  ++ordinal_;
  const bool cutting = cutting_planes_.any();
  const bool whole = !cutting && solids_.empty();
  const bool plain = corners.size() == 3 && retaining() == nullptr && whole;
  if (plain &&
      view_stage_->enter_triangle(world, {{corners[0], corners[1], corners[2]}, {1, 1, 1}, pick},
                                  looks_.attributes, segment)) {
    return;
  }
  const PointRow vertices(world, corners);
  const PointRow entered(shared.entered, corners);
  const Point3 normal = looks_.attributes.light ? newell_normal(vertices) : Point3(0.0);
  if (corners.size() != 3 && !is_flat(vertices)) {
    ++triangulated_;
    world_points_.assign(vertices.begin(), vertices.end());
    return enter_triangles(entered, normal, {}, pick);
  }
  const WorldPolygon polygon{std::span<const Point3>(vertices),
                             {},
                             normal,
                             {},
                             pick,
                             std::span<const Point3>(entered),
                             shared.modelling};
  if (!solids_.empty()) return enter(polygon);
  if (cutting && is_face_of_cut_away(vertices)) return;
  if (cutting && are_cut(vertices)) return enter_cut(polygon);
  if (RetainedScene* scene = retaining()) scene->enter_shared(corners, polygon, looks_.attributes);
  if (!is_viewed_later()) view_stage_->enter_shared(corners, polygon, looks_.attributes, segment);
}

void SystemInside::cut_bent_polygons_as_seen_along_z(GraphicsSystem& system) {
  system.state_->bent_polygons_seen_ = Triangulation::SeenAlong::z_axis;
}

}  // namespace displayfile
