#include "displayfile/retained_views.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "clip/back_face.h"
#include "clip/clip_pipeline.h"
#include "clip/error.h"
#include "displayfile/lighting.h"
#include "hidden/plane.h"
#include "hidden/support_plane.h"
#include "hidden/world_tree.h"

namespace displayfile {

namespace {

using Attributes = RetainedScene::Attributes;

Eye eye_of(const View& view) {
  if (view.projection == View::Projection::perspective) return Eye::at(view.centre_of_projection);
  const Point3& along = view.direction_of_projection;
  return Eye::toward(glm::dot(unit(along), unit(view.plane_normal)) < 0.0 ? along : -along);
}

bool draws(const RetainedScene::Primitive& primitive, const Attributes& attributes) {
  return primitive.is_line() || attributes.fill.kind == FillStyle::Kind::solid ||
         attributes.line.kind != LineStyle::Kind::none;
}

SortItems::Kind kind_of(const RetainedScene::Primitive& primitive, const Attributes& attributes) {
  if (primitive.is_line()) return SortItems::Kind::line;
  return attributes.fill.kind == FillStyle::Kind::solid ? SortItems::Kind::solid
                                                        : SortItems::Kind::hollow;
}

/// How far the vertices lie from the plane that the tree takes the polygon to be in.
double off_plane(std::span<const Point3> polygon) {
  if (polygon.size() == 3) return 0.0;
  const SupportVertices support = spread_vertices(polygon);
  if (support.edge_on) return 0.0;
  const auto& [p, q, r] = support.index;
  const Plane plane(polygon[p], polygon[q], polygon[r]);
  double most = 0.0;
  for (const Point3& v : polygon) most = std::max(most, std::abs(plane_value(v, plane).value));
  return most / glm::length(plane.normal);
}

void require_countable(std::size_t points) {
  if (points >= std::numeric_limits<std::uint32_t>::max()) {
    throw Error("too many points to sort hidden surfaces: expected fewer than 2^32 - 1");
  }
}

}  // namespace

/// The segments that share a tree.
class RetainedViews::Part {
 public:
  Part(std::vector<const RetainedScene::Segment*> segments, const ImageTransformation& image,
       bool together, const Precision& precision)
      : image_(image), together_(together), precision_(precision) {
    for (const RetainedScene::Segment* segment : segments) add(*segment);
    SortOptions options;
    options.precision = precision;
    tree_.emplace(SortItems{points_, edge_visible_, items_}, options);
    moving_eye_.emplace(*tree_);
  }
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  SortCounts counts() const {
    const SortedPieces& pieces = tree_->pieces();
    return {pieces.pieces.size(), pieces.cuts, pieces.comparisons, pieces.depth};
  }
  std::uint64_t walks() const { return moving_eye_->walks(); }
  std::uint64_t reused() const { return moving_eye_->reused(); }

  /// Enters the segments, whole polygons in order of entry; returns them sorted.
  std::shared_ptr<const SortedInstructions> draw(const View& view, const glm::dmat3& lights_turned,
                                                 DisplayFile& file) {
    const ViewVolume volume(view);
    ClipPipeline pipeline(volume);
    device_points_.clear();
    device_visible_.clear();
    enter_whole(pipeline, lights_turned, file);
    auto sorted = std::make_shared<SortedInstructions>();
    sorted->image = {};
    sorted->method = HiddenMethod::bsp;
    sorted->precision = precision_;
    sorted->counts = counts();
    sorted->boundary_error = boundary_error(volume);
    enter_pieces(pipeline, moving_eye_->far_to_near(eye_of(view)), sorted->instructions);
    return sorted;
  }

 private:
  /// A primitive, and what this view makes of it.
  struct Shown {
    RetainedScene::Primitive primitive;
    std::uint32_t segment;  ///< index
    std::size_t first = 0;  ///< of its device points
    std::uint32_t sides = 0;
    FillStyle fill;
  };
  struct SegmentPart {
    int name;
    std::size_t end;  ///< of its primitives
    std::vector<Attributes> attributes;
  };

  void add(const RetainedScene::Segment& segment) {
    const std::size_t before = points_.size();
    require_countable(before + segment.points.size());
    points_.insert(points_.end(), segment.points.begin(), segment.points.end());
    edge_visible_.insert(edge_visible_.end(), segment.edge_visible.begin(),
                         segment.edge_visible.end());
    for (RetainedScene::Primitive primitive : segment.primitives) {
      const Attributes& attributes = segment.attributes[primitive.attributes];
      primitive.first += before;
      if (draws(primitive, attributes)) {
        items_.push_back({static_cast<std::uint32_t>(primitive.first), primitive.sides,
                          kind_of(primitive, attributes)});
        shown_of_.push_back(static_cast<std::uint32_t>(shown_.size()));
        off_plane_ = std::max(off_plane_, off_plane(points_of(primitive)));
      }
      shown_.push_back({primitive, static_cast<std::uint32_t>(segments_.size()), 0, 0, {}});
    }
    segments_.push_back({segment.name, shown_.size(), segment.attributes});
  }

  std::span<const Point3> points_of(const RetainedScene::Primitive& primitive) const {
    return std::span(points_).subspan(primitive.first, primitive.sides);
  }
  const Attributes& attributes_of(const Shown& shown) const {
    return segments_[shown.segment].attributes[shown.primitive.attributes];
  }

  void enter_whole(ClipPipeline& pipeline, const glm::dmat3& lights_turned, DisplayFile& file) {
    std::size_t i = 0;
    for (const SegmentPart& part : segments_) {
      Segment& segment = file.create(part.name);
      segment.image = image_;
      for (; i < part.end; ++i) {
        Shown& shown = shown_[i];
        const Attributes& attributes = attributes_of(shown);
        view_whole(shown, attributes, pipeline, lights_turned);
        if (shown.sides == 0) continue;
        const auto points = std::span(device_points_).subspan(shown.first, shown.sides);
        segment.set_style(attributes.line);
        if (shown.primitive.is_line()) {
          segment.enter_line(points[0], points[1]);
          continue;
        }
        segment.set_style(shown.fill);
        segment.set_pick(shown.primitive.pick);
        segment.enter_polygon(points, std::span(device_visible_).subspan(shown.first, shown.sides));
      }
      segment.close();
    }
  }

  /// Clips, checks for a back face, and lights: of the whole polygon, since a piece of a polygon
  /// that crosses itself may turn the other way.
  void view_whole(Shown& shown, const Attributes& attributes, ClipPipeline& pipeline,
                  const glm::dmat3& lights_turned) {
    shown.sides = 0;
    shown.first = device_points_.size();
    const auto world = points_of(shown.primitive);
    if (shown.primitive.is_line()) {
      Point3 a, b;
      if (!pipeline.clip_line(world[0], world[1], a, b)) return;
      device_points_.insert(device_points_.end(), {a, b});
      device_visible_.insert(device_visible_.end(), {0, 1});
      shown.sides = 2;
      return;
    }
    const ClippedPolygon clipped = pipeline.clip_polygon(
        world, std::span(edge_visible_).subspan(shown.primitive.first, shown.primitive.sides));
    if (clipped.vertices.size() < 3) return;
    const double c = newell_c(clipped.vertices);
    if (attributes.back_face_removal && c <= 0.0) return;
    shown.fill = attributes.fill;
    if (attributes.light) {
      Light light = *attributes.light;
      light.toward = lights_turned * light.toward;
      shown.fill = lit(shown.fill, light, shown.primitive.normal, c < 0.0);
    }
    device_points_.insert(device_points_.end(), clipped.vertices.begin(), clipped.vertices.end());
    device_visible_.insert(device_visible_.end(), clipped.edge_visible.begin(),
                           clipped.edge_visible.end());
    shown.sides = static_cast<std::uint32_t>(clipped.vertices.size());
  }

  /// SAVE-POLYGONS-IN-ORDER, SEND-TO-DF and CHECK-STYLE (algorithms 9.16 to 9.18) for an eye
  /// anywhere.
  void enter_pieces(ClipPipeline& pipeline, std::span<const WorldTree::Index> order,
                    Instructions& out) {
    const SortedPieces& sorted = tree_->pieces();
    constexpr std::size_t kOtherCodes = 3;  // the polygon's own, and a pick identifier
    out.reserve(device_points_.size() + kOtherCodes * order.size(), device_points_.size());
    std::optional<std::uint32_t> segment;
    for (const WorldTree::Index i : order) {
      const SortedPiece& piece = sorted.pieces[i];
      const Shown& shown = shown_[shown_of_[piece.item]];
      if (shown.sides == 0) continue;
      if (together_ && segment != shown.segment) {
        segment = shown.segment;
        out.enter_segment(segments_[*segment].name);
      }
      const bool whole = piece.first == SortedPiece::kWhole;
      const auto world = whole ? std::span<const Point3>{}
                               : std::span(sorted.points).subspan(piece.first, piece.sides);
      if (shown.primitive.is_line()) {
        Point3 a, b;
        if (whole) {
          enter_line(shown, device_points_[shown.first], device_points_[shown.first + 1], out);
        } else if (pipeline.clip_line(world[0], world[1], a, b)) {
          enter_line(shown, a, b, out);
        }
      } else if (whole) {
        enter_polygon(shown, std::span(device_points_).subspan(shown.first, shown.sides),
                      std::span(device_visible_).subspan(shown.first, shown.sides), out);
      } else if (piece.sides == 2) {  // a side of a polygon whose vertices are in line
        Point3 a, b;
        if (pipeline.clip_line(world[0], world[1], a, b)) enter_line(shown, a, b, out);
      } else {
        const ClippedPolygon clipped = pipeline.clip_polygon(
            world, std::span(sorted.visible).subspan(piece.first, piece.sides));
        if (clipped.vertices.size() >= 3) {
          enter_polygon(shown, clipped.vertices, clipped.edge_visible, out);
        }
      }
    }
  }

  void enter_line(const Shown& shown, const Point3& a, const Point3& b, Instructions& out) {
    out.set_style(attributes_of(shown).line);
    out.enter_line(moved(a), moved(b));
  }

  void enter_polygon(const Shown& shown, std::span<const Point3> points,
                     std::span<const std::uint8_t> visible, Instructions& out) {
    out.set_style(shown.fill);
    out.set_style(attributes_of(shown).line);
    out.set_pick(shown.primitive.pick);
    if (!together_ || image_.is_identity()) return out.enter_polygon(points, visible);
    moved_.clear();
    for (const Point3& p : points) moved_.push_back(moved(p));
    out.enter_polygon(moved_, visible);
  }
  Point3 moved(const Point3& p) const { return together_ ? ImageMatrix(image_).apply(p) : p; }

  /// How far a boundary of a piece may lie from where the whole polygons have it, in device
  /// coordinates: three points of it were transformed, each rounded in every step, and the cut's
  /// once before; and the tree's polygons are flat (hidden/world_tree.md, section 5).
  double boundary_error(const ViewVolume& volume) const {
    constexpr double kRoundings = 32.0;
    constexpr double kNearestW = 1e-6;  // where a perspective view is clipped at the latest
    constexpr double kMostForFlatness = 0x1p-20;  // of the picture
    const glm::dmat4& m = volume.matrix();
    const auto row_size = [&](int row, const Point3& p) {
      return std::abs(m[0][row] * p.x) + std::abs(m[1][row] * p.y) + std::abs(m[2][row] * p.z);
    };
    double largest = 0.0, nearest_w = 1.0;
    for (const Point3& p : points_) {
      const double size = std::max(row_size(0, p), row_size(1, p)) + row_size(3, p);
      largest = std::max(largest, size);
      nearest_w = std::min(nearest_w, volume.transform(p).w);
    }
    largest += std::max(std::abs(m[3][0]), std::abs(m[3][1])) + std::abs(m[3][3]);
    const double w = std::max(nearest_w, kNearestW);
    const double scale =
        image_.is_identity() ? 1.0 : std::abs(image_.scale.x) + std::abs(image_.scale.y);
    const double step =
        std::max(row_size(0, Point3(1.0)), row_size(1, Point3(1.0))) + row_size(3, Point3(1.0));
    const double of_flatness = std::min(4.0 * step * off_plane_ / w, kMostForFlatness);
    return scale * (kRoundings * kUnit * largest / w + of_flatness);
  }

  ImageTransformation image_;
  bool together_;  // if so, sorted points are those after the image transformation
  Precision precision_;
  std::vector<Point3> points_;  // world
  std::vector<std::uint8_t> edge_visible_;
  std::vector<SortItems::Item> items_;
  std::vector<std::uint32_t> shown_of_;  // the items' primitives
  std::vector<Shown> shown_;             // in order of entry
  std::vector<SegmentPart> segments_;
  double off_plane_ = 0.0;  // of the vertices, at most
  std::optional<WorldTree> tree_;
  std::optional<MovingEye> moving_eye_;

  std::vector<Point3> device_points_;  // of this view's whole primitives
  std::vector<std::uint8_t> device_visible_;
  std::vector<Point3> moved_;
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
      parts_.push_back(std::make_unique<Part>(std::vector{segment}, image_of(segment), false,
                                              options.precision));
    }
  } else if (!visible.empty()) {
    for (const RetainedScene::Segment* segment : visible) {
      if (image_of(segment) == image_of(visible.front())) continue;
      throw Error(fmt::format(
          "segments {} and {} have different image transformations, which act after viewing: "
          "expected each segment to be sorted on its own",
          visible.front()->name, segment->name));
    }
    parts_.push_back(
        std::make_unique<Part>(visible, image_of(visible.front()), true, options.precision));
  }
  for (const auto& part : parts_) {
    const SortCounts counts = part->counts();
    counts_.pieces += counts.pieces;
    counts_.cuts += counts.cuts;
    counts_.comparisons += counts.comparisons;
    counts_.depth = std::max(counts_.depth, counts.depth);
  }
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
  for (const auto& part : parts_) sum += part->walks();
  return sum;
}

std::uint64_t RetainedViews::reused() const {
  std::uint64_t sum = 0;
  for (const auto& part : parts_) sum += part->reused();
  return sum;
}

}  // namespace displayfile
