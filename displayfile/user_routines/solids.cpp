#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "clip/base/words.h"
#include "clip/geometry/unit.h"
#include "clip/point.h"
#include "clip/view.h"
#include "clip/view/transformation.h"
#include "displayfile/looks/gouraud.h"
#include "displayfile/solids/hatched_loops.h"
#include "displayfile/solids/solid_faces.h"
#include "displayfile/user_routines/ranges.h"
#include "displayfile/user_routines/system_inside.h"
#include "displayfile/user_routines/system_state.h"

namespace displayfile {

namespace {

constexpr Word<SolidOperation> kOperations[] = {{SolidOperation::unite, "union"},
                                                {SolidOperation::intersect, "intersection"},
                                                {SolidOperation::difference, "difference"}};

constexpr Word<CutFaces::Kind> kCutFaces[] = {{CutFaces::Kind::open, "open"},
                                              {CutFaces::Kind::closed, "closed"},
                                              {CutFaces::Kind::hatched, "hatched"}};

}  // namespace

SolidOperation solid_operation(std::string_view text) {
  return value_of(kOperations, text, "the operation on solids is");
}
std::string_view name_of(SolidOperation operation) { return word_of(kOperations, operation); }

CutFaces::Kind cut_faces_kind(std::string_view text) {
  return value_of(kCutFaces, text, "cut faces are");
}
std::string_view name_of(CutFaces::Kind kind) { return word_of(kCutFaces, kind); }

void GraphicsSystem::State::require_no_solid(std::string_view what) const {
  if (solids_.empty()) return;
  throw Error(fmt::format("{} within a solid: expected shapes and polygons until end-solid", what));
}

void GraphicsSystem::begin_solid(SolidOperation operation) {
  state_->require_open();
  state_->solids_.begin(operation);
  state_->before_solids_.push_back({state_->pen_, state_->ordinal_, state_->triangulated_});
  state_->record("begin-solid", {name_of(operation)});
}

void GraphicsSystem::end_solid() {
  const RoundToNearest nearest;
  if (state_->solids_.empty()) throw Error("no solid open: expected begin-solid before");
  const bool is_hatched = state_->solids_.depth() == 1 && state_->hatches_cut_faces();
  std::optional<OpenSolids> before;  // in case there are too many hatching lines
  if (is_hatched) before = state_->solids_;
  std::optional<SolidFaces> whole = state_->solids_.end();
  double spacing = 1.0;
  try {
    if (is_hatched && whole) spacing = state_->hatching_spacing(*whole);
  } catch (...) {
    state_->solids_ = std::move(*before);
    throw;
  }
  state_->before_solids_.pop_back();
  if (whole) state_->enter_solid(*whole, spacing);
  state_->record("end-solid", {});
}

void GraphicsSystem::State::discard_solid() {
  if (solids_.empty()) throw Error("no solid open: expected begin-solid before");
  solids_.discard();
  const BeforeSolid before = before_solids_.back();
  before_solids_.pop_back();
  pen_ = before.pen;
  ordinal_ = before.ordinal;
  triangulated_ = before.triangulated;
  vertex_normals_.clear();
  vertex_colours_.clear();
  record("discard-solid", {});
}

void GraphicsSystem::discard_solid() { state_->discard_solid(); }

bool SystemInside::takes_whole_solids(const GraphicsSystem& system) {
  return system.state_->takes_whole_solids();
}

bool GraphicsSystem::State::takes_whole_solids() const {
  const bool is_cut_open = looks_.cut_faces.kind == CutFaces::Kind::open;
  return !solids_.empty() || (cutting_planes_.any() && (!is_cut_open || recorder_ != nullptr));
}

void SystemInside::as_solid(GraphicsSystem& system, const std::function<void()>& enter,
                            double volume) {
  if (!system.state_->takes_whole_solids()) return system.state_->as_faces_of_solid(volume, enter);
  const std::size_t depth = system.counts().solids_open;
  system.begin_solid();
  try {
    enter();
    system.end_solid();
  } catch (...) {
    if (system.counts().solids_open > depth) system.discard_solid();
    throw;
  }
}

void GraphicsSystem::set_cut_faces(const CutFaces& faces) {
  const RoundToNearest nearest;
  require_finite({faces.angle}, "angle");
  if (faces.spacing && !(*faces.spacing > 0.0 && *faces.spacing <= kCoordinateLimit)) {
    throw Error(
        fmt::format("hatching {} apart: expected a number above 0, at most 1e100", *faces.spacing));
  }
  state_->looks_.cut_faces = {faces.kind};
  if (faces.kind == CutFaces::Kind::hatched)
    state_->looks_.cut_faces = faces;  // or they have no meaning
  const std::string_view kind = name_of(faces.kind);
  if (state_->looks_.cut_faces.spacing) {
    state_->record("set-cut-faces",
                   {kind, *state_->looks_.cut_faces.spacing, state_->looks_.cut_faces.angle});
  } else if (state_->looks_.cut_faces.angle != CutFaces{}.angle) {
    state_->record("set-cut-faces", {kind, kUsualSpacing, state_->looks_.cut_faces.angle});
  } else {
    state_->record("set-cut-faces", {kind});
  }
}

bool GraphicsSystem::State::hatches_cut_faces() const {
  return looks_.cut_faces.kind == CutFaces::Kind::hatched && cutting_planes_.any();
}

namespace {

/// An estimate, or a slight overestimate, of the number of crossings of cut faces' outlines and
/// hatching lines: each side of a cut face is in a face of the solid.
double hatching_crossings(const SolidFaces& solid, double spacing) {
  double lengths = 0.0;
  for (std::size_t i = 0; i < solid.faces.size(); ++i) {
    if (solid.first_loop(i) == solid.faces[i].end_loop) continue;
    Point3 low(HUGE_VAL), high(-HUGE_VAL);
    for (const SolidFaces::Corner& corner : solid.loop(solid.first_loop(i))) {  // its outline
      low = glm::min(low, solid.vertices[corner.vertex]);
      high = glm::max(high, solid.vertices[corner.vertex]);
    }
    lengths += glm::length(high - low);
  }
  return lengths / spacing;
}

}  // namespace

/// The spacing of hatching lines on a solid. Error: there would be too many, or they would be cut
/// into too many parts.
double GraphicsSystem::State::hatching_spacing(const SolidFaces& solid) const {
  if (solid.corners.empty()) return 1.0;
  Point3 low = solid.vertices[solid.corners.front().vertex], high = low, farthest(0.0);
  for (const SolidFaces::Corner& corner : solid.corners) {
    const Point3& p = solid.vertices[corner.vertex];
    low = glm::min(low, p);
    high = glm::max(high, p);
    farthest = glm::max(farthest, glm::abs(p));
  }
  const Point3 extent = high - low;
  const double longest = std::max({extent.x, extent.y, extent.z});
  constexpr double kParts = 24.0;
  const double spacing = looks_.cut_faces.spacing.value_or(longest > 0.0 ? longest / kParts : 1.0);
  if (2.0 * longest / spacing > kMostHatchingLines ||
      std::max({farthest.x, farthest.y, farthest.z}) / spacing > 1e12) {
    throw Error(fmt::format(
        "cut faces hatched {} apart: expected at most {} lines on a solid {:.6g} long, and less "
        "than 1e12 from it to the origin",
        spacing, kMostHatchingLines, longest));
  }
  constexpr double kMostCrossings = 40.0 * kMostHatchingLines;
  if (hatching_crossings(solid, spacing) > kMostCrossings) {
    throw Error(fmt::format(
        "cut faces hatched {} apart: expected a spacing at which the sides of the solid cross "
        "hatching lines at most {} times in all",
        spacing, kMostCrossings));
  }
  return spacing;
}

/// A face in a plane counts as cut away, as in cut_solid: it becomes a cut face.
void GraphicsSystem::State::note_planes_met(const SolidFaces& solid) {
  for (int n = 1; n <= CuttingPlanes::kMost; ++n) {
    if (!cutting_planes_.is_on(n)) continue;
    const auto is_cut_away = [&](const SolidFaces::Corner& corner) {
      return !(cutting_planes_.distance(n, solid.vertices[corner.vertex]) > 0.0);
    };
    const unsigned bit = 1u << (n - 1);
    plane_uses_.met(bit, std::ranges::any_of(solid.corners, is_cut_away) ? bit : 0u,
                    std::ranges::all_of(solid.corners, is_cut_away) ? bit : 0u);
  }
}

/// Cuts the solid if its cut faces are to be closed, and enters its polygons, each with its own
/// attributes; then restores those in force.
void GraphicsSystem::State::enter_solid(const SolidFaces& whole, double spacing) {
  if (whole.faces.empty()) {
    ++empty_solids_;
    return;
  }
  const bool is_cut = looks_.cut_faces.kind != CutFaces::Kind::open && cutting_planes_.any();
  const Attributes in_force = looks_.attributes;
  const SolidFaces* solid = &whole;
  SolidFaces cut;
  if (is_cut) {
    set_reach_of_planes();
    note_planes_met(whole);
    cut = cut_solid(whole, cutting_planes_, static_cast<std::uint32_t>(whole.attributes.size()));
    cut.attributes.push_back(in_force);
    solid = &cut;
  }
  const auto restore = [&] {
    looks_.attributes = in_force;
    attributes_changed();
  };
  // Back-face removal removes a face that is turned away, and its hatching with it; the retained
  // scene has both for other views.
  const Segment& segment = display_file_.segment(*open_);
  std::vector<bool> is_there;
  const auto enter_faces = [&] {
    for (std::size_t i = 0; i < solid->faces.size(); ++i) {
      const std::size_t before = segment.polygons();
      enter_face(*solid, i, !is_cut);
      is_there.push_back(segment.polygons() > before);
    }
  };
  const bool is_closed =
      !is_cut && cutting_planes_.any() && !open_side(whole, 0, whole.faces.size());
  try {
    is_closed ? as_faces_of_solid(enclosed_volume(whole), enter_faces) : enter_faces();
  } catch (...) {
    restore();
    throw;
  }
  restore();
  if (!is_cut || looks_.cut_faces.kind != CutFaces::Kind::hatched) return;
  for (std::size_t i = 0; i < solid->faces.size(); ++i) {
    if (solid->faces[i].cut_by != 0) enter_hatching(*solid, i, {spacing, is_there[i]});
  }
}

/// Enters a face of a solid as a polygon, or as triangles if its normals differ.
void GraphicsSystem::State::enter_face(const SolidFaces& solid, std::size_t i, bool is_to_be_cut) {
  const SolidFaces::Face& face = solid.faces[i];
  FacePolygon polygon;
  set_to_face(polygon, solid, i);
  if (const Attributes& own = solid.attributes[face.attributes]; looks_.attributes != own) {
    looks_.attributes = own;
    attributes_changed();
  }
  int pick = face.pick;
  if (face.cut_by != 0) {
    pick = next_pick();
    if (pick_ < 0) ++ordinal_;
  }
  const Point3 normal = looks_.attributes.light ? face.normal : Point3(0.0);
  const auto enter_one = [&](const WorldPolygon& one) {
    is_to_be_cut ? enter(one) : enter_whole(one);
  };
  if (polygon.vertices.size() == 3 || !differ(polygon.normals)) {
    return enter_one({polygon.vertices, polygon.edge_visible, normal, polygon.normals, pick});
  }
  for (const auto& [vertex, edge_visible] : triangulation_.triangulate(polygon.vertices)) {
    std::array<Point3, 3> corners, normals;
    std::array<std::uint8_t, 3> drawn{};
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = polygon.vertices[vertex[k]];
      normals[k] = polygon.normals[vertex[k]];
      drawn[k] = edge_visible[k] != 0 ? polygon.edge_visible[vertex[k]] : std::uint8_t{0};
    }
    enter_one({corners, drawn, normal, normals, pick});
  }
}

namespace {

/// Two directions in a plane, seen from where its normal points: right, which is horizontal, and
/// up, as in the view; in a level plane, up is away from the viewer.
struct DirectionsInPlane {
  Point3 right, up;

  DirectionsInPlane(const Point3& normal, const View& view) {
    const Point3 level = glm::cross(unit(view.up), normal);
    right = unit(level != Point3(0.0) ? level : glm::cross(unit(view.plane_normal), normal));
    up = glm::cross(normal, right);
  }
};

}  // namespace

/// The style of hatching lines; the width that replaces those of line styles is theirs, too, unless
/// `hatch` has its own.
LineStyle GraphicsSystem::State::hatching_style() const {
  const LineStyle& line = looks_.attributes.line;
  LineStyle style = hatching_line_style(line);
  if (!line.of_kinds.of(StyledLines::hatch).width) replace_width(style);
  return style;
}

/// Enters lines within the loops of a cut face, filled even-odd, in the style of hatching: a
/// millionth of the solid's size in front of it, so that rounding does not hide them behind it, and
/// ending slightly inside its outline, so that none sticks out when seen from the side.
void GraphicsSystem::State::enter_hatching(const SolidFaces& solid, std::size_t face,
                                           const Hatching& hatching) {
  const LineStyle style = hatching_style();
  if (style.kind == LineStyle::Kind::none) return;
  has_hatching_ = true;
  constexpr double kBefore = 1e-6;
  const auto [inward, offset] = cutting_planes_.unit_plane(solid.faces[face].cut_by);
  const DirectionsInPlane in_plane(-inward, view_);
  std::vector<std::vector<Point2>> loops;
  Point3 low = solid.vertices[solid.loop(solid.first_loop(face))[0].vertex], high = low;
  for (std::size_t i = solid.first_loop(face); i < solid.faces[face].end_loop; ++i) {
    auto& loop = loops.emplace_back();
    for (const SolidFaces::Corner& corner : solid.loop(i)) {
      const Point3& p = solid.vertices[corner.vertex];
      low = glm::min(low, p);
      high = glm::max(high, p);
      loop.emplace_back(glm::dot(p, in_plane.right), glm::dot(p, in_plane.up));
    }
  }
  const Point3 extent = high - low;
  const double before = kBefore * std::max({extent.x, extent.y, extent.z}), short_of = 4.0 * before;
  const Point3 origin = -(offset + before) * inward;
  const auto [sine, cosine] = sine_cosine_of_degrees(looks_.cut_faces.angle);
  const Point3 along = cosine * in_plane.right + sine * in_plane.up;
  const LineStyle in_force = std::exchange(looks_.attributes.line, style);
  attributes_changed();
  const auto restore = [&] {
    looks_.attributes.line = in_force;
    attributes_changed();
  };
  try {
    for (const auto& [from, to] :
         hatched_loops(loops, WithinLoops::odd, hatching.spacing, {cosine, sine})) {
      const Point3 a = origin + from.x * in_plane.right + from.y * in_plane.up;
      const Point3 b = origin + to.x * in_plane.right + to.y * in_plane.up;
      if (glm::distance(a, b) > 2.0 * short_of) {
        enter_world_line(a + short_of * along, b - short_of * along, hatching.is_there);
      }
    }
  } catch (...) {
    restore();
    throw;
  }
  restore();
}

}  // namespace displayfile
