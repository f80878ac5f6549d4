#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "clip/geometry/back_face.h"
#include "displayfile/segments/polygon_stage.h"
#include "displayfile/views/scene_viewer.h"
#include "hidden/exact/few_centres.h"
#include "hidden/exact/orientation.h"
#include "hidden/exact/support_plane.h"

namespace displayfile {

/// Calls visit(first, end) for consecutive ranges of at most `most`, from `first` on.
template <class Visit>
void for_each_run(std::uint32_t first, std::uint32_t end, std::uint32_t most, Visit&& visit) {
  for (; first < end; first += std::min(most, end - first)) {
    visit(first, first + std::min(most, end - first));
  }
}

/// Some primitives of one segment, and their items in the view, whose points are those of the whole
/// scene followed by its own.
class SceneViewer::Part {
 public:
  Part(std::uint32_t segment, std::uint32_t first, std::uint32_t end)
      : segment_(segment), first_(first), end_(end) {}

  std::uint32_t segment() const { return segment_; }
  /// The result in own memory.
  const ViewedScene& seen() const { return own_; }
  /// The primitives of the items; empty without shadows.
  std::span<const std::uint32_t> primitives() const { return own_primitives_; }
  std::size_t bytes() const { return own_.bytes() + primitives().size_bytes(); }

  /// Finds runs of triangles that need individual treatment only if the sieve requires it.
  void find_rows(const SceneViewer& viewer) {
    const RetainedScene& scene = *viewer.scene_;
    for (std::uint32_t i = first_; i < end_; ++i) {
      const Primitive& primitive = scene[i];
      const std::uint32_t attributes = scene.attributes_of_look(primitive.look);
      const bool sieved = viewer.looks_[attributes].is_plain && primitive.sides == 3 &&
                          viewer.points_.size() < kMostSieved;
      const bool goes_on = !rows_.empty() && rows_.back().sieved == sieved &&
                           rows_.back().attributes == attributes &&
                           primitive.first == scene[i - 1].first + scene[i - 1].sides;
      if (!goes_on) rows_.push_back({i, i, attributes, sieved});
      ++rows_.back().end;
    }
  }

  /// Data common to all parts.
  struct InView {
    const SceneViewer& viewer;
    const Wanted& wanted;
    const ViewVolume& volume;
    bool by_centres;
  };
  /// Views into own memory.
  void view(const InView& in_view, const ImageTransformation& image) {
    own_primitives_.clear();
    own_.clear();
    own_.own_points_.clear();
    own_.palette_ = in_view.viewer.scene_->fill_colours();
    own_.items_.reserve(end_ - first_);
    own_.pick_.reserve(end_ - first_);
    view(in_view, image, own_, {0, 0}, own_primitives_);
  }
  /// Data of the scene that is not the parts'.
  struct Shared {
    std::size_t points, corners;
  };
  /// Appends to a scene.
  void view(const InView& in_view, const ImageTransformation& image, ViewedScene& seen,
            const Shared& shared, std::vector<std::uint32_t>& primitives) {
    seen_ = &seen;
    shared_ = shared;
    in_view_ = &in_view;
    if (!stage_) stage_.emplace(in_view.volume);
    stage_->set_volume(in_view.volume);
    matrix_.reset();
    if (!image.is_identity()) matrix_.emplace(image);
    in_force_ = kNone;
    const SceneViewer& viewer = in_view.viewer;
    for (const Row& row : rows_) {
      const Look& look = viewer.looks_[row.attributes];
      if (look.is_nothing) continue;
      if (row.sieved && in_view.by_centres && !matrix_) {
        view_sieved(row, look);
        continue;
      }
      for (std::uint32_t i = row.first; i < row.end; ++i) {
        view_one(i, look);
        if (viewer.shows_shadows_ && primitives.size() < seen_->items()) primitives.push_back(i);
      }
    }
  }

 private:
  using Primitive = RetainedScene::Primitive;
  /// Successive primitives with the same attributes and consecutive corners.
  struct Row {
    std::uint32_t first, end;
    std::uint32_t attributes;
    bool sieved;  ///< where centres count: plain triangles
  };
  static constexpr std::size_t kMostSieved = std::size_t{1} << 30;  // points

  /// Plain triangles, many at once.
  void view_sieved(const Row& row, const Look& look) {
    const SceneViewer& viewer = in_view_->viewer;
    const RetainedScene& scene = *viewer.scene_;
    constexpr auto kMost = static_cast<std::uint32_t>(SievedTriangles::kMost);
    for_each_run(row.first, row.end, kMost, [&](std::uint32_t first, std::uint32_t end) {
      const std::uint32_t* const corners = viewer.viewed_.corners_.data() + scene[first].first;
      const SievedTriangles found = sieve_triangles(corners, end - first, viewer.places_.data());
      if (found.needs_more == 0 && !look.is_lit) {
        const std::uint64_t seen = found.stays & ~(look.removes_back_faces ? found.turned_away : 0);
        return seen_->add_triangles(seen, [&](int k) {
          const Primitive& primitive = scene[first + static_cast<std::uint32_t>(k)];
          return ViewedScene::Triangle{primitive.first, primitive.look, primitive.pick};
        });
      }
      for (std::uint64_t left = found.stays | found.needs_more; left != 0; left &= left - 1) {
        const std::uint32_t i = first + static_cast<std::uint32_t>(std::countr_zero(left));
        if (const std::uint64_t bit = left & -left; (found.needs_more & bit) != 0) {
          view_one(i, look);
        } else {
          add_triangle(i, scene[i], look, (found.turned_away & bit) != 0);
        }
      }
    });
  }

  void view_one(std::uint32_t i, const Look& look) {
    const Primitive& primitive = (*in_view_->viewer.scene_)[i];
    if (look.is_plain && primitive.sides == 3 && !matrix_) {
      view_triangle(i, primitive, look);
    } else {
      view_any(i, primitive);
    }
  }

  /// Sets its attributes except the colour; lights are rotated for the view.
  void take_shared(const Primitive& primitive) {
    const RetainedScene& scene = *in_view_->viewer.scene_;
    const std::uint32_t attributes = scene.attributes_of_look(primitive.look);
    if (in_force_ == attributes) return;
    in_force_ = attributes;
    attributes_ = scene.all_attributes()[attributes];
    light_ = attributes_.light ? &*attributes_.light : nullptr;
    if (light_ != nullptr) light_->toward = in_view_->wanted.lights_turned * light_->toward;
    outlined_ = attributes_.is_outlined();
  }

  void view_any(std::uint32_t i, const Primitive& primitive) {
    take_shared(primitive);
    attributes_.fill.colour = in_view_->viewer.scene_->fill_colours()[primitive.look];
    if (!view_whole(i, primitive)) view_in_stage(i, primitive);
  }

  /// The same for the usual case of large meshes: triangles without drawn sides.
  void view_triangle(std::uint32_t i, const Primitive& primitive, const Look& look) {
    const SceneViewer& viewer = in_view_->viewer;
    const std::uint32_t* const corner = viewer.viewed_.corners_.data() + primitive.first;
    const std::uint8_t* const outcodes = viewer.outcodes_.data();
    const int a = outcodes[corner[0]], b = outcodes[corner[1]], c = outcodes[corner[2]];
    if ((a | b | c) != 0) [[unlikely]] {
      if ((a & b & c) == 0) view_any(i, primitive);
      return;
    }
    const Point3* const points = viewer.viewed_.own_points_.data();
    const Point3 &p = points[corner[0]], &q = points[corner[1]], &r = points[corner[2]];
    if (in_view_->by_centres) {
      const auto [columns, rows] = centres_in_box({corner, 3});
      if (columns.count == 0 || rows.count == 0) return;
      if (columns.count <= kFewCentres && rows.count <= kFewCentres &&
          covers_none_of_few(p, q, r, *in_view_->wanted.centres_of, columns.first, columns.count,
                             rows.first, rows.count)) {
        return;
      }
    }
    const auto [twice_area, bound] = orientation_value(Point2(p), Point2(q), Point2(r));
    if (!(std::abs(twice_area) > bound)) [[unlikely]]
      return view_any(i, primitive);
    const double facing =
        look.is_lit || look.removes_back_faces ? newell_c(std::array{p, q, r}) : 0.0;
    if (look.removes_back_faces && facing <= 0.0) return;
    add_triangle(i, primitive, look, facing < 0.0);
  }

  void add_triangle(std::uint32_t i, const Primitive& primitive, const Look& look,
                    bool turned_away) {
    if (look.removes_back_faces && turned_away) return;
    if (!look.is_lit) {
      return seen_->add_triangle({primitive.first, primitive.look, primitive.pick});
    }
    const RetainedScene& scene = *in_view_->viewer.scene_;
    if (scene.is_smooth(i)) return view_any(i, primitive);
    take_shared(primitive);
    const Colour colour =
        lit(scene.fill_colours()[primitive.look], *attributes_.light, scene.normal(i), turned_away);
    seen_->add_triangle({primitive.first, seen_->number_of(colour), primitive.pick});
  }

  struct Centres {
    CentresBetween columns, rows;
  };
  /// The centres that a polygon with these corners may cover; all corners are inside.
  Centres centres_in_box(std::span<const std::uint32_t> corners) const {
    const PicturePlace* const places = in_view_->viewer.places_.data();
    PicturePlace low = places[corners[0]], high = low;
    for (const std::uint32_t corner : corners.subspan(1)) {
      const auto [x, y] = places[corner];
      low = {std::min(low.x, x), std::min(low.y, y)};
      high = {std::max(high.x, x), std::max(high.y, y)};
    }
    return {{low.x, high.x}, {low.y, high.y}};
  }

  /// Fast path for a polygon without outside vertices and with flat shading: its points are shared.
  /// False if it needs more.
  bool view_whole(std::uint32_t i, const Primitive& primitive) {
    if (matrix_ || primitive.is_line()) return false;
    const SceneViewer& viewer = in_view_->viewer;
    const std::uint32_t* const corners = viewer.viewed_.corners_.data() + primitive.first;
    unsigned any = 0, all = ~0u;
    for (std::uint32_t k = 0; k < primitive.sides; ++k) {
      any |= viewer.outcodes_[corners[k]];
      all &= viewer.outcodes_[corners[k]];
    }
    if (any != 0) return all != 0;
    if (in_view_->by_centres && !outlined_) {
      const auto [columns, rows] = centres_in_box({corners, primitive.sides});
      if (columns.count == 0 || rows.count == 0) return true;
    }
    const RetainedScene& scene = *viewer.scene_;
    if (light_ != nullptr && scene.is_smooth(i)) return false;
    const PointRow vertices(viewer.viewed_.own_points_, {corners, primitive.sides});
    const bool has_two_styles = attributes_.dark_line.has_value();
    if (has_two_styles && attributes_.fill.kind != FillStyle::Kind::solid) return false;
    const bool turns = attributes_.back_face_removal || light_ != nullptr || has_two_styles;
    const double c = turns ? newell_c(vertices) : 0.0;
    if (attributes_.back_face_removal && c <= 0.0) return true;
    const FillStyle* fill = &attributes_.fill;
    if (light_ != nullptr) {
      const bool turned_away = !attributes_.back_face_removal && c < 0.0;
      lit_ = lit(*fill, *light_, scene.normal(i), turned_away);
      if (attributes_.shadows) {
        lit_.shadow = shadow_on(lit_, *fill, *light_, in_view_->volume);
      }
      fill = &lit_;
    }
    if (shows_nothing(vertices)) return true;
    const std::uint32_t colour = light_ != nullptr ? ViewedScene::kNone : primitive.look;
    seen_->add_polygon(primitive.first, vertices,
                       {*fill, attributes_.line_of(c < 0.0), primitive.pick, colour});
    return true;
  }

  /// A fill that is edge-on covers no centre.
  template <class Vertices>
  bool shows_nothing(const Vertices& vertices) const {
    return in_view_->by_centres && !outlined_ && support_vertices(vertices).edge_on;
  }

  void view_in_stage(std::uint32_t i, const Primitive& primitive) {
    const RetainedScene& scene = *in_view_->viewer.scene_;
    const std::size_t own_corner = seen_->own_points_.size() - shared_.points;
    const auto first = static_cast<std::uint32_t>(in_view_->viewer.corners_ + own_corner);
    if (primitive.is_line()) {
      const PointRow ends = scene.points(i);
      std::array<Point3, 2> clipped;
      if (!outlined_ || !stage_->pipeline().clip_line(ends[0], ends[1], clipped[0], clipped[1])) {
        return;
      }
      take_points(clipped);
      seen_->entered_of_item_.push_back(i);
      return seen_->add_item({first, 2, Primitives::Kind::line},
                             {attributes_.fill, attributes_.line, primitive.pick});
    }
    WorldPolygon world = scene.polygon(i);
    if (const auto& selected = in_view_->viewer.sides_; !selected.empty()) {
      world.edge_visible = std::span(selected).subspan(primitive.first, primitive.sides);
    }
    const StagedPolygon viewed = stage_->view_polygon(world, attributes_);
    const ClippedPolygon& polygon = viewed.polygon;
    if (polygon.vertices.empty() || (!matrix_ && shows_nothing(polygon.vertices))) return;
    const FillStyle* fill = viewed.fill;
    if (matrix_ && fill->shadow) {
      lit_ = *fill;
      lit_.shadow->light = matrix_->apply(lit_.shadow->light);
      fill = &lit_;
    }
    if (!std::ranges::all_of(polygon.edge_visible, [](LineKinds k) { return k == kDrawn; })) {
      seen_->note_edges(shared_.corners + own_corner, polygon.edge_visible);
    }
    take_points(polygon.vertices);
    seen_->entered_of_item_.push_back(i);
    const auto vertices = std::span(seen_->own_points_).last(polygon.vertices.size());
    seen_->add_polygon(first, vertices, {*fill, *viewed.line, primitive.pick}, viewed.shading());
  }

  void take_points(std::span<const Point3> points) {
    for (const Point3& p : points) {
      seen_->own_points_.push_back(matrix_ ? matrix_->apply(p) : p);
    }
  }

  std::uint32_t segment_, first_, end_;
  std::vector<Row> rows_;
  ViewedScene own_;
  std::vector<std::uint32_t> own_primitives_;
  ViewedScene* seen_ = nullptr;
  Shared shared_{};  // in seen_
  const InView* in_view_ = nullptr;
  std::optional<PolygonStage> stage_;
  std::optional<ImageMatrix> matrix_;
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t in_force_ = kNone;  // of the attributes
  Attributes attributes_;
  Light* light_ = nullptr;  // theirs
  bool outlined_ = false;
  FillStyle lit_;
};

}  // namespace displayfile
