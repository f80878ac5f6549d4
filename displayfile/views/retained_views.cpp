#include "displayfile/views/retained_views.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "clip/pipeline/clip_pipeline.h"
#include "displayfile/segments/polygon_stage.h"
#include "displayfile/segments/scene_lines.h"
#include "displayfile/views/shared_planes.h"
#include "displayfile/views/view_rounding.h"
#include "hidden/sort/world_tree.h"

namespace displayfile {

/// The segments that share a tree.
class RetainedViews::Part {
 public:
  Part(RetainedScene world, const ImageTransformation& image, const SurfacePlan& plan)
      : image_(image),
        together_(plan.scope != HiddenScope::segment),
        plan_(plan.by(HiddenMethod::bsp).kept()),
        world_(std::move(world)),
        items_(world_.items(primitive_of_)),
        shared_planes_(of_items(shared_planes(world_))),
        any_sides_(world_.selects_lines() ? world_.sides_in_any_view() : std::vector<LineKinds>()),
        tree_(sorted_in_world(), plan, world_.selects_lines()),
        moving_eye_(tree_) {
    plan_.intersections = world_.has_intersections();
    for (std::uint32_t i = 0; i < world_.size(); ++i) {
      off_plane_.push_back(world_.off_plane(i));
    }
    const std::span<const Point3> points = world_.primitives(items_).points;
    for (std::size_t item = 0; item < shared_planes_.size(); ++item) {
      const auto& [p, q, r] = shared_planes_[item];
      if (p == Primitives::kOwnPlane) continue;
      const Plane plane(points[p], points[q], points[r]);
      double& off = off_plane_[primitive_of_[item]];
      off = std::max(off, world_.off_plane(primitive_of_[item], plane));
    }
  }
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  SortCounts counts() const {
    const SortedPieces& pieces = tree_.pieces();
    return {pieces.pieces.size(), pieces.cuts, pieces.comparisons, pieces.depth};
  }
  /// The largest number of pieces that the tree had while it was built.
  std::uint64_t pieces() const { return items_.size() + tree_.pieces().cuts; }
  const MovingEye& moving_eye() const { return moving_eye_; }

  /// Enters the segments, whole polygons in order of entry; returns them sorted.
  std::shared_ptr<const SortedScene> draw(const View& view, const glm::dmat3& lights_turned,
                                          DisplayFile& file) {
    const ViewVolume volume(view);
    PolygonStage stage(volume);
    const std::size_t first = file.segments().size();
    const Eye eye = Eye::of(view);
    if (!any_sides_.empty()) world_.sides_in_view(eye, sides_);
    enter_whole(eye, stage, lights_turned, file);
    auto scene = std::make_shared<ViewedScene>(scene_of(file, first));
    auto sorted = std::make_shared<SortedScene>();
    sorted->plan = plan_;
    sorted->counts = counts();
    sorted->boundary_error =
        boundary_error(ViewRounding(view, volume), *scene) + scene->boundary_error();
    SortedPieces order = order_of_pieces(moving_eye_.far_to_near(eye), stage.pipeline());
    append_lines(*scene, plan_, order);
    auto ordered = std::make_shared<OrderedScene>();
    ordered->scene = std::move(scene);
    ordered->pieces = std::move(order);
    sorted->parts.push_back(std::move(ordered));
    return sorted;
  }

 private:
  using Index = WorldTree::Index;
  static constexpr ViewedScene::Item kNotSeen = ~ViewedScene::Item{0};

  /// The primitives in world coordinates. The tree's pieces keep the sides that are drawn in some
  /// view.
  Primitives sorted_in_world() const {
    Primitives world = world_.primitives(items_);
    if (!any_sides_.empty()) world.visible = any_sides_;
    if (plan_.precision.exact) world.planes = shared_planes_;
    return world;
  }

  std::vector<Primitives::PlanePoints> of_items(
      const std::vector<Primitives::PlanePoints>& of_primitives) const {
    std::vector<Primitives::PlanePoints> planes;
    if (of_primitives.empty()) return planes;
    for (const std::uint32_t primitive : primitive_of_) planes.push_back(of_primitives[primitive]);
    return planes;
  }

  /// Enters the whole segments and records which item of the viewed scene each primitive becomes.
  void enter_whole(const Eye& eye, PolygonStage& stage, const glm::dmat3& lights_turned,
                   DisplayFile& file) {
    item_of_.assign(world_.size(), kNotSeen);
    ViewedScene::Item items = 0;
    for (const RetainedScene::Segment& part : world_.segments()) {
      Segment& segment = file.create(part.name);
      segment.image = image_;
      world_.enter_viewed(part, eye, stage, lights_turned, segment,
                          [&](std::uint32_t i) { item_of_[i] = items++; });
      segment.close();
    }
  }

  /// Segments sorted together keep points after the image transformation; a single segment keeps
  /// those before it.
  ViewedScene scene_of(const DisplayFile& file, std::size_t first) const {
    if (!together_) return {file.segments().back().entered(), ImageTransformation{}};
    std::vector<const Segment*> segments;
    for (std::size_t k = first; k < file.segments().size(); ++k) {
      segments.push_back(&file.segments()[k]);
    }
    return ViewedScene(segments);
  }

  /// The largest error of a visible boundary, after the image transformation.
  double boundary_error(const ViewRounding& rounding, const ViewedScene& scene) const {
    double most = 0.0;
    for (std::uint32_t i = 0; i < world_.size(); ++i) {
      if (item_of_[i] == kNotSeen) continue;
      most =
          std::max(most, rounding.of(world_.points(i), scene.points(item_of_[i]), off_plane_[i]));
    }
    const double image_scale = std::abs(image_.scale.x) + std::abs(image_.scale.y);
    return image_.is_identity() ? most : most * image_scale;
  }

  /// The tree's pieces as pieces of the viewed scene, for an eye anywhere.
  SortedPieces order_of_pieces(std::span<const Index> order, ClipPipeline& pipeline) const {
    SortedPieces pieces;
    pieces.pieces.reserve(order.size());
    for (const Index i : order) {
      const SortedPiece& piece = tree_.pieces().pieces[i];
      const std::uint32_t primitive = primitive_of_[piece.item];
      if (item_of_[primitive] == kNotSeen) continue;
      if (piece.first == SortedPiece::kWhole) {
        pieces.pieces.push_back({item_of_[primitive], SortedPiece::kWhole, piece.sides});
      } else {
        add_clipped(primitive, piece, pipeline, pieces);
      }
    }
    return pieces;
  }

  /// Adds a piece of a cut polygon; one with two points is a line, or a side of a polygon with
  /// collinear vertices.
  void add_clipped(std::uint32_t primitive, const SortedPiece& piece, ClipPipeline& pipeline,
                   SortedPieces& pieces) const {
    const SortedPieces& sorted = tree_.pieces();
    const auto world = std::span(sorted.points).subspan(piece.first, piece.sides);
    const std::vector<LineKinds> sides = sides_of(primitive, piece);
    if (piece.sides == 2) {
      std::array<Point3, 2> ends;
      const bool drawn = world_.shared_attributes(primitive).is_outlined() && sides[1] != 0;
      if (drawn && pipeline.clip_line(world[0], world[1], ends[0], ends[1])) {
        add_piece(primitive, ends, std::array<std::uint8_t, 2>{0, sides[1]}, pieces);
      }
      return;
    }
    const ClippedPolygon clipped = pipeline.clip_polygon(world, sides);
    if (clipped.vertices.size() >= 3) {
      add_piece(primitive, clipped.vertices, clipped.edge_visible, pieces);
    }
  }

  /// The kinds, in this view, of a piece's sides.
  std::vector<LineKinds> sides_of(std::uint32_t primitive, const SortedPiece& piece) const {
    const SortedPieces& sorted = tree_.pieces();
    const auto visible = std::span(sorted.visible).subspan(piece.first, piece.sides);
    std::vector<LineKinds> sides(visible.begin(), visible.end());
    if (any_sides_.empty()) return sides;
    for (std::uint32_t k = 0; k < piece.sides; ++k) {
      const std::uint32_t corner = sorted.corners[piece.first + k];
      const bool is_own = sides[k] != 0 && corner != SortedPieces::kNoCorner;
      sides[k] = is_own ? sides_[world_[primitive].first + corner] : LineKinds{0};
    }
    return sides;
  }

  void add_piece(std::uint32_t primitive, std::span<const Point3> points,
                 std::span<const std::uint8_t> visible, SortedPieces& pieces) const {
    pieces.pieces.push_back({item_of_[primitive], static_cast<std::uint32_t>(pieces.points.size()),
                             static_cast<std::uint32_t>(points.size())});
    pieces.visible.insert(pieces.visible.end(), visible.begin(), visible.end());
    if (!together_ || image_.is_identity()) {
      pieces.points.insert(pieces.points.end(), points.begin(), points.end());
    } else {
      const ImageMatrix matrix(image_);
      for (const Point3& p : points) pieces.points.push_back(matrix.apply(p));
    }
  }

  ImageTransformation image_;  // the same of all segments
  bool together_;
  SurfacePlan plan_;
  RetainedScene world_;
  std::vector<std::uint32_t> primitive_of_;  // the items' primitives
  std::vector<Primitives::Item> items_;
  std::vector<Primitives::PlanePoints> shared_planes_;
  std::vector<LineKinds> any_sides_;  // empty: no segment selects any
  WorldTree tree_;
  MovingEye moving_eye_;
  std::vector<double> off_plane_;           // of the primitives
  std::vector<LineKinds> sides_;            // of all corners, in the view drawn last
  std::vector<ViewedScene::Item> item_of_;  // the primitives' items in the view drawn last
};

RetainedViews::RetainedViews(const RetainedScene& scene, const DisplayFile& attributes,
                             const SurfacePlan& plan)
    : taken_(scene, attributes), plan_(plan.kept()) {
  take();
}

bool RetainedViews::take_up(const SurfacePlan& plan) {
  const bool are_of = plan.scope == plan_.scope && plan.precision == plan_.precision &&
                      plan.hidden_lines == plan_.hidden_lines && plan.root == plan_.root &&
                      plan.orders_lines_as(plan_);
  const std::size_t limit = most_pieces_of_sort(plan, 0);
  const auto is_within = [&](const auto& part) { return part->pieces() <= limit; };
  if (!are_of || (limit < limit_ && !std::ranges::all_of(parts_, is_within))) return false;
  plan_.most_pieces = plan.most_pieces;
  return true;
}

/// Sorts the visible segments. If it throws, the state before is kept.
void RetainedViews::take() {
  const RoundToNearest nearest;
  const DisplayFile& attributes = taken_.attributes();
  std::vector<std::unique_ptr<Part>> parts;
  RetainedScene visible = taken_.scene().visible_in(attributes);
  const auto image_of = [&](const RetainedScene::Segment& segment) {
    return attributes.segment(segment.name).image;
  };
  const auto add = [&](RetainedScene world) {
    const ImageTransformation image = image_of(world.segments().front());
    parts.push_back(std::make_unique<Part>(std::move(world), image, plan_));
  };
  if (plan_.scope == HiddenScope::segment) {
    for (const RetainedScene::Segment& part : visible.segments()) {
      add(visible.selected([&](const auto& segment) { return segment.name == part.name; }));
    }
  } else if (!visible.segments().empty()) {
    const RetainedScene::Segment& first = visible.segments().front();
    for (const RetainedScene::Segment& segment : visible.segments()) {
      if (ImageMatrix(image_of(segment)) == ImageMatrix(image_of(first))) continue;
      throw Error(fmt::format(
          "segments {} and {} have different image transformations, which act after viewing: "
          "expected each segment to be sorted on its own",
          first.name, segment.name));
    }
    add(std::move(visible));
  }
  taken_.take();
  limit_ = most_pieces_of_sort(plan_, 0);
  parts_ = std::move(parts);
  counts_ = {};
  for (const auto& part : parts_) counts_ += part->counts();
}

void RetainedViews::bring_up_to_date() {
  if (!taken_.is_gone() && !taken_.is_same()) take();
}

RetainedViews::RetainedViews(RetainedViews&&) noexcept = default;
RetainedViews& RetainedViews::operator=(RetainedViews&&) noexcept = default;
RetainedViews::~RetainedViews() = default;

DisplayFile RetainedViews::view(const View& view, const glm::dmat3& lights_turned) {
  const RoundToNearest nearest;
  bring_up_to_date();
  DisplayFile file;
  for (const auto& part : parts_) {
    const auto sorted = part->draw(view, lights_turned, file);
    if (plan_.scope == HiddenScope::segment) {
      const int name = file.segments().back().name();
      file.segment(name).set_sorted(sorted);
    } else {
      file.set_sorted(sorted);
    }
  }
  return file;
}

std::uint64_t RetainedViews::walks() const {
  std::uint64_t sum = 0;
  for (const auto& part : parts_) sum += part->moving_eye().walks();
  return sum;
}

std::uint64_t RetainedViews::reused() const {
  std::uint64_t sum = 0;
  for (const auto& part : parts_) sum += part->moving_eye().reused();
  return sum;
}

}  // namespace displayfile
