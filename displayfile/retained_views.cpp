#include "displayfile/retained_views.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <span>
#include <utility>

#include "clip/clip_pipeline.h"
#include "clip/error.h"
#include "displayfile/intensity_plane.h"
#include "displayfile/retained_primitives.h"
#include "displayfile/view_rounding.h"
#include "displayfile/viewed_primitives.h"
#include "hidden/sort/world_tree.h"

namespace displayfile {

namespace {

Eye eye_of(const View& view) {
  if (view.projection == View::Projection::perspective) return Eye::at(view.centre_of_projection);
  const Point3& along = view.direction_of_projection;
  return Eye::toward(glm::dot(unit(along), unit(view.plane_normal)) < 0.0 ? along : -along);
}

RetainedPrimitives primitives_of(std::span<const RetainedScene::Segment* const> segments) {
  RetainedPrimitives primitives;
  for (const RetainedScene::Segment* segment : segments) primitives.add(*segment);
  return primitives;
}

}  // namespace

/// The segments that share a tree.
class RetainedViews::Part {
 public:
  Part(std::span<const RetainedScene::Segment* const> segments, const ImageTransformation& image,
       HiddenScope scope, const Precision& precision)
      : image_(image),
        together_(scope == HiddenScope::all),
        precision_(precision),
        world_(primitives_of(segments)),
        tree_(world_.items(), SortOptions{.precision = precision}),
        moving_eye_(tree_) {}
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  SortCounts counts() const {
    const SortedPieces& pieces = tree_.pieces();
    return {pieces.pieces.size(), pieces.cuts, pieces.comparisons, pieces.depth};
  }
  const MovingEye& moving_eye() const { return moving_eye_; }

  /// Enters the segments, whole polygons in order of entry; returns them sorted.
  std::shared_ptr<const SortedInstructions> draw(const View& view, const glm::dmat3& lights_turned,
                                                 DisplayFile& file) {
    const ViewVolume volume(view);
    ClipPipeline pipeline(volume);
    viewed_.view(world_, pipeline, lights_turned);
    enter_whole(file);
    auto sorted = std::make_shared<SortedInstructions>();
    sorted->method = HiddenMethod::bsp;
    sorted->precision = precision_;
    sorted->counts = counts();
    sorted->boundary_error = boundary_error(ViewRounding(view, volume));
    save_polygons_in_order(moving_eye_.far_to_near(eye_of(view)), pipeline, sorted->instructions);
    return sorted;
  }

 private:
  using Index = WorldTree::Index;

  void enter_whole(DisplayFile& file) const {
    std::size_t i = 0;
    for (const RetainedPrimitives::Segment& part : world_.segments()) {
      Segment& segment = file.create(part.name);
      segment.image = image_;
      for (; i < part.end; ++i) {
        if (!viewed_.is_left(i)) continue;
        const auto points = viewed_.points(i);
        if (world_[i].is_line()) {
          segment.set_style(world_.attributes(i).line);
          segment.enter_line(points[0], points[1]);
        } else {
          segment.set_style(viewed_.fill(i));
          segment.set_style(world_.attributes(i).line);
          segment.set_pick(world_[i].pick);
          segment.enter_polygon(points, viewed_.edge_visible(i), viewed_.intensities(i));
        }
      }
      segment.close();
    }
  }

  /// Of what is left, the most, after the image transformation.
  double boundary_error(const ViewRounding& rounding) const {
    double most = 0.0;
    for (std::size_t i = 0; i < world_.size(); ++i) {
      if (!viewed_.is_left(i)) continue;
      most = std::max(most, rounding.of(world_.points(i), viewed_.points(i), world_.off_plane(i)));
    }
    const double image_scale = std::abs(image_.scale.x) + std::abs(image_.scale.y);
    return image_.is_identity() ? most : most * image_scale;
  }

  /// Algorithm 9.16 for an eye anywhere.
  void save_polygons_in_order(std::span<const Index> order, ClipPipeline& pipeline,
                              Instructions& out) {
    constexpr std::size_t kOtherCodes = 3;  // the polygon's own, and a pick identifier
    out.reserve(viewed_.points() + kOtherCodes * order.size(), viewed_.points());
    std::optional<int> segment;
    for (const Index i : order) {
      const SortedPiece& piece = tree_.pieces().pieces[i];
      const std::uint32_t primitive = world_.primitive_of(piece.item);
      if (!viewed_.is_left(primitive)) continue;
      if (together_ && segment != world_.segment_name(primitive)) {
        segment = world_.segment_name(primitive);
        out.enter_segment(*segment);
      }
      if (piece.first == SortedPiece::kWhole) {
        send_to_df(primitive, viewed_.points(primitive), viewed_.edge_visible(primitive),
                   viewed_.intensities(primitive), out);
      } else {
        send_clipped_to_df(primitive, piece, pipeline, out);
      }
    }
  }

  /// A piece of a polygon that was cut; of two points a line, or a side of a polygon whose vertices
  /// are in line.
  void send_clipped_to_df(std::uint32_t primitive, const SortedPiece& piece, ClipPipeline& pipeline,
                          Instructions& out) {
    const SortedPieces& sorted = tree_.pieces();
    const auto world = std::span(sorted.points).subspan(piece.first, piece.sides);
    if (piece.sides == 2) {
      Point3 ends[2];
      const bool drawn = world_.attributes(primitive).line.kind != LineStyle::Kind::none;
      if (drawn && pipeline.clip_line(world[0], world[1], ends[0], ends[1])) {
        send_to_df(primitive, ends, {}, {}, out);
      }
      return;
    }
    const ClippedPolygon clipped =
        pipeline.clip_polygon(world, std::span(sorted.visible).subspan(piece.first, piece.sides));
    if (clipped.vertices.size() >= 3) {
      send_to_df(primitive, clipped.vertices, clipped.edge_visible,
                 intensities_of_piece(primitive, clipped.vertices), out);
    }
  }

  /// A piece of a shaded polygon lies in the picture of the whole one.
  std::span<const double> intensities_of_piece(std::uint32_t primitive,
                                               std::span<const Point3> piece) {
    const auto of_whole = viewed_.intensities(primitive);
    if (of_whole.empty()) return {};
    const IntensityPlane plane(viewed_.points(primitive), of_whole);
    intensities_.clear();
    for (const Point3& p : piece) intensities_.push_back(plane.at(p));
    return intensities_;
  }

  /// Algorithms 9.17 and 9.18: the instructions enter a style only where it changes.
  void send_to_df(std::uint32_t primitive, std::span<const Point3> points,
                  std::span<const std::uint8_t> visible, std::span<const double> intensities,
                  Instructions& out) {
    points = as_sorted(points);
    if (points.size() == 2) {
      out.set_style(world_.attributes(primitive).line);
      out.enter_line(points[0], points[1]);
      return;
    }
    out.set_style(as_sorted(viewed_.fill(primitive)));
    out.set_style(world_.attributes(primitive).line);
    out.set_pick(world_[primitive].pick);
    out.enter_polygon(points, visible, intensities);
  }

  /// Segments that are sorted together keep points after the image transformation, one by itself
  /// those before.
  std::span<const Point3> as_sorted(std::span<const Point3> points) {
    if (!together_ || image_.is_identity()) return points;
    const ImageMatrix matrix(image_);
    moved_.clear();
    for (const Point3& p : points) moved_.push_back(matrix.apply(p));
    return moved_;
  }

  FillStyle as_sorted(FillStyle fill) const {
    if (!together_ || image_.is_identity() || !fill.shadow) return fill;
    fill.shadow->light = ImageMatrix(image_).apply(fill.shadow->light);
    return fill;
  }

  ImageTransformation image_;  // the same of all segments
  bool together_;
  Precision precision_;
  RetainedPrimitives world_;
  WorldTree tree_;
  MovingEye moving_eye_;
  ViewedPrimitives viewed_;
  std::vector<Point3> moved_;
  std::vector<double> intensities_;  // of one piece
};

RetainedViews::RetainedViews(const RetainedScene& scene, const DisplayFile& attributes,
                             const Options& options)
    : options_(options) {
  std::vector<const RetainedScene::Segment*> visible;
  for (const RetainedScene::Segment& segment : scene.segments()) {
    if (attributes.segment(segment.name).visible) visible.push_back(&segment);
  }
  const auto image_of = [&](const RetainedScene::Segment* segment) {
    return attributes.segment(segment->name).image;
  };
  if (options.scope == HiddenScope::segment) {
    for (const RetainedScene::Segment* segment : visible) {
      parts_.push_back(std::make_unique<Part>(std::span(&segment, 1), image_of(segment),
                                              options.scope, options.precision));
    }
  } else if (!visible.empty()) {
    for (const RetainedScene::Segment* segment : visible) {
      if (image_of(segment) == image_of(visible.front())) continue;
      throw Error(fmt::format(
          "segments {} and {} have different image transformations, which act after viewing: "
          "expected each segment to be sorted on its own",
          visible.front()->name, segment->name));
    }
    parts_.push_back(std::make_unique<Part>(visible, image_of(visible.front()), options.scope,
                                            options.precision));
  }
  for (const auto& part : parts_) counts_ += part->counts();
}

RetainedViews::RetainedViews(RetainedViews&&) noexcept = default;
RetainedViews& RetainedViews::operator=(RetainedViews&&) noexcept = default;
RetainedViews::~RetainedViews() = default;

DisplayFile RetainedViews::view(const View& view, const glm::dmat3& lights_turned) {
  DisplayFile file;
  for (const auto& part : parts_) {
    const auto sorted = part->draw(view, lights_turned, file);
    if (options_.scope == HiddenScope::segment) {
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
