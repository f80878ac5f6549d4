#include "interp/annotation/annotation_marks.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <span>

#include "clip/base/round_to_nearest.h"
#include "displayfile/entered/instructions.h"
#include "interp/annotation/page_annotation.h"
#include "interp/annotation/placement.h"

namespace displayfile {

namespace {

using AnnotationKind = KeptAnnotation::Kind;

constexpr double kFarthestOnPage = 10'000.0;  // pixels outside of the picture

/// The points of what is drawn, in device coordinates.
class OutlinePoints {
 public:
  explicit OutlinePoints(std::vector<Point2>& points) : points_(points) {}
  void fill(const FillStyle& style) { fills_ = style.kind == FillStyle::Kind::solid; }
  void line_style(const LineStyle& style) { lines_ = style.kind != LineStyle::Kind::none; }
  void pick(std::int32_t /*id*/) {}
  void move(const Point3& p) { pen_ = p; }
  void line(const Point3& p) {
    if (lines_) points_.insert(points_.end(), {Point2(pen_), Point2(p)});
    pen_ = p;
  }
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t> /*sides*/) {
    pen_ = vertices.back();
    if (!fills_ && !lines_) return;
    for (const Point3& v : vertices) points_.emplace_back(v);
  }

 private:
  std::vector<Point2>& points_;
  bool fills_ = true, lines_ = true;
  Point3 pen_{0.0};
};

std::vector<Point2> points_drawn(const DisplayFile& display_file) {
  std::vector<Point2> points;
  for (const Segment* const segment : display_file.visible_segments()) {
    segment->walk_entered_drawn(OutlinePoints(points));
  }
  return points;
}

std::vector<Point2> points_drawn(const ViewedScene& scene) {
  std::vector<Point2> points;
  for (ViewedScene::Item item = 0; item < scene.items(); ++item) {
    const PointRow of_item = scene.points(item);
    for (const Point3& p : of_item) points.emplace_back(p);
  }
  return points;
}

std::vector<KeptAnnotation> annotations_of(const DisplayFile& display_file) {
  std::vector<KeptAnnotation> all;
  for (const Segment* const segment : display_file.visible_segments()) {
    for (const KeptAnnotation& kept : segment->entered()->annotations()) {
      all.push_back(transformed(kept, segment->image));
      all.back().segment = segment->name();
    }
  }
  return all;
}

/// By number; the name is the first.
std::vector<PartsListRow> rows_of(std::span<const KeptAnnotation> all) {
  std::map<int, PartsListRow> rows;
  for (const KeptAnnotation& balloon : all) {
    if (balloon.kind != AnnotationKind::balloon || balloon.name.empty()) continue;
    int number = 0;
    const std::string& digits = balloon.characters;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    ++rows.try_emplace(number, PartsListRow{number, balloon.name, 0}).first->second.quantity;
  }
  std::vector<PartsListRow> result;
  result.reserve(rows.size());
  for (const auto& [number, row] : rows) result.push_back(row);
  return result;
}

bool is_near(const Point2& p, const AnnotationPage& page) {
  return p.x >= -kFarthestOnPage && p.x <= page.width + kFarthestOnPage &&
         p.y >= -kFarthestOnPage && p.y <= page.height + kFarthestOnPage;
}

/// At the places where it was entered; none if it is far outside.
std::optional<PageAnnotation> on_page(const KeptAnnotation& kept, const AnnotationPage& page) {
  const bool in_pixels = kept.style.unit == AnnotationStyle::Unit::pixels;
  const double unit = in_pixels ? page.pixel : page.millimetre;
  PageAnnotation result{&kept, kept.style.size * unit, {}};
  for (const Point3& p : kept.points) {
    result.points.emplace_back(p.x * page.width, p.y * page.height);
    if (!is_near(result.points.back(), page)) return std::nullopt;
  }
  result.corner = kept.offset;
  if (kept.kind == AnnotationKind::leader || kept.kind == AnnotationKind::balloon) {
    result.at = result.points[0] + unit * kept.offset;
    result.side = kept.offset.x < 0.0 ? PageAnnotation::Side::left : PageAnnotation::Side::right;
    if (!is_near(result.at, page)) return std::nullopt;
  }
  return result;
}

template <class Scene>
std::vector<AnnotationMark> marks_of(std::span<const KeptAnnotation> kept, const Scene& scene,
                                     const AnnotationPage& page) {
  const RoundToNearest nearest;
  std::vector<PageAnnotation> all;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (const auto annotation = on_page(kept[i], page)) {
      all.push_back(*annotation);
      numbers.push_back(i);
    }
  }
  const std::vector<PartsListRow> rows = rows_of(kept);
  if (std::ranges::any_of(all, &PageAnnotation::is_automatic)) {
    std::vector<Point2> figure = points_drawn(scene);
    for (Point2& p : figure) p = {p.x * page.width, p.y * page.height};
    place_annotation(all, figure, rows, page);
  }
  std::vector<AnnotationMark> marks;
  AnnotationPencil pencil(page, marks);
  for (std::size_t i = 0; i < all.size(); ++i) pencil.draw(all[i], numbers[i], rows);
  return marks;
}

}  // namespace

std::vector<AnnotationMark> annotation_marks(const DisplayFile& display_file,
                                             const AnnotationPage& page) {
  if (!display_file.has_annotations()) return {};
  const std::vector<KeptAnnotation> kept = annotations_of(display_file);
  return marks_of(kept, display_file, page);
}

std::vector<AnnotationMark> annotation_marks(const ViewedScene& scene, const AnnotationPage& page) {
  if (scene.annotations().empty()) return {};
  return marks_of(scene.annotations(), scene, page);
}

}  // namespace displayfile
