#include "interp/annotation/annotation_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>

#include "clip/base/round_to_nearest.h"
#include "displayfile/entered/instructions.h"
#include "displayfile/text/characters.h"
#include "interp/annotation/page_annotation.h"
#include "interp/annotation/page_shapes.h"
#include "interp/annotation/placement.h"

namespace displayfile {

namespace {

using AnnotationKind = KeptAnnotation::Kind;

constexpr double kFarthestOnPage = 10'000.0;  // pixels outside of the picture

/// Collects the figure drawn on the page: its points and rectangles, in pixels.
class DrawnFigure {
 public:
  DrawnFigure(const AnnotationPage& page, PageFigure& figure) : page_(page), figure_(figure) {}
  void fill(const FillStyle& style) { fills_ = style.kind == FillStyle::Kind::solid; }
  void line_style(const LineStyle& style) { lines_ = style.kind != LineStyle::Kind::none; }
  void pick(std::int32_t /*id*/) {}
  void move(const Point3& p) { pen_ = p; }
  void line(const Point3& p) {
    if (lines_) add(std::array{pen_, p});
    pen_ = p;
  }
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t> /*sides*/) {
    pen_ = vertices.back();
    if (fills_ || lines_) add(vertices);
  }
  template <class Points>
  void add(const Points& points) {
    item_.clear();
    for (const Point3& p : points) item_.emplace_back(p.x * page_.width, p.y * page_.height);
    figure_.add(item_);
  }

 private:
  const AnnotationPage& page_;
  PageFigure& figure_;
  std::vector<Point2> item_;
  bool fills_ = true, lines_ = true;
  Point3 pen_{0.0};
};

PageFigure figure_drawn(const DisplayFile& display_file, const AnnotationPage& page) {
  PageFigure figure;
  for (const Segment* const segment : display_file.visible_segments()) {
    segment->walk_entered_drawn(DrawnFigure(page, figure));
  }
  return figure;
}

PageFigure figure_drawn(const ViewedScene& scene, const AnnotationPage& page) {
  PageFigure figure;
  DrawnFigure drawn(page, figure);
  for (ViewedScene::Item item = 0; item < scene.items(); ++item) {
    drawn.add(PointRow(scene.points(item)));
  }
  return figure;
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

bool is_near(const Point2& p, const AnnotationPage& page) {
  return p.x >= -kFarthestOnPage && p.x <= page.width + kFarthestOnPage &&
         p.y >= -kFarthestOnPage && p.y <= page.height + kFarthestOnPage;
}

/// Converts to pixels of the page, at the entered places; none if a point is far outside.
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

/// All annotation of a page in its final places.
struct LaidOut {
  std::vector<PageAnnotation> all;
  std::vector<std::size_t> numbers;  // of each, in order of entry
  std::vector<PartsListRow> rows;
};

template <class Scene>
LaidOut laid_out(std::span<const KeptAnnotation> kept, const Scene& scene,
                 const AnnotationPage& page) {
  LaidOut result;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (const auto annotation = on_page(kept[i], page)) {
      result.all.push_back(*annotation);
      result.numbers.push_back(i);
    }
  }
  result.rows = parts_list_rows(kept);
  if (std::ranges::any_of(result.all, &PageAnnotation::is_automatic)) {
    place_annotation(result.all, figure_drawn(scene, page), result.rows, page);
  }
  return result;
}

template <class Scene>
std::vector<AnnotationMark> marks_of(std::span<const KeptAnnotation> kept, const Scene& scene,
                                     const AnnotationPage& page) {
  const RoundToNearest nearest;
  const LaidOut laid = laid_out(kept, scene, page);
  std::vector<AnnotationMark> marks;
  AnnotationPencil pencil(page, marks);
  for (std::size_t i = 0; i < laid.all.size(); ++i) {
    pencil.draw(laid.all[i], laid.numbers[i], laid.rows);
  }
  return marks;
}

}  // namespace

std::string name_in_message(const KeptAnnotation& kept) {
  switch (kept.kind) {
    case AnnotationKind::list: return "the parts list";
    case AnnotationKind::title: return "the title";
    case AnnotationKind::balloon: return "balloon " + kept.characters;
    case AnnotationKind::leader: return "leader " + in_quotation_marks(kept.characters);
    case AnnotationKind::linear:
    case AnnotationKind::diameter:
    case AnnotationKind::radius:
    case AnnotationKind::angle: break;
  }
  return "dimension " + kept.characters;
}

namespace {

constexpr std::string_view kMoreRoom = "expected larger paper, a larger window or a smaller scale";

/// True if the drawn annotation reaches beyond the picture by more than a line's width, and its
/// points of the model do not: otherwise it is beyond with its figure.
bool is_cut_off(const PageAnnotation& one, std::span<const AnnotationMark> marks,
                const AnnotationPage& page) {
  const double by = AnnotationPencil::line_width(one.height);
  const Rectangle picture{-by, page.width + by, -by, page.height + by};
  const auto is_inside = [&](std::span<const Point2> points) {
    return points.empty() || is_within(rectangle_of(points), picture);
  };
  return is_inside(std::span(one.points).first(one.kept->anchors())) &&
         !is_inside(points_of(marks, page));
}

template <class Scene>
std::vector<std::string> faults_of(std::span<const KeptAnnotation> kept, const Scene& scene,
                                   const AnnotationPage& page) {
  const RoundToNearest nearest;
  const LaidOut laid = laid_out(kept, scene, page);
  std::vector<std::string> without_room, cut_off;
  std::vector<bool> is_drawn(kept.size(), false);
  bool is_entered = false;  // with its place
  std::vector<AnnotationMark> marks;
  AnnotationPencil pencil(page, marks);
  for (std::size_t i = 0; i < laid.all.size(); ++i) {
    const PageAnnotation& one = laid.all[i];
    is_drawn[laid.numbers[i]] = true;
    marks.clear();
    pencil.draw(one, i, laid.rows);
    if (is_cut_off(one, marks, page)) {
      cut_off.push_back(name_in_message(*one.kept));
      is_entered = is_entered || (!one.is_automatic() && one.kept->anchors() > 0);
    } else if (!one.has_place) {
      without_room.push_back(name_in_message(*one.kept));
    }
  }
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (!is_drawn[i]) cut_off.push_back(name_in_message(kept[i]));
  }
  std::vector<std::string> faults;
  if (!without_room.empty()) {
    faults.push_back(
        fmt::format("annotation placement auto has no room for {}, which may cover the figure: {}",
                    fmt::join(without_room, ", "), kMoreRoom));
  }
  if (!cut_off.empty()) {
    faults.push_back(fmt::format("annotation reaches beyond the picture and is cut off: {}: {}{}",
                                 fmt::join(cut_off, ", "), kMoreRoom,
                                 is_entered ? ", or set-annotation-placement auto" : ""));
  }
  const bool has_list = std::ranges::any_of(
      kept, [](const KeptAnnotation& one) { return one.kind == AnnotationKind::list; });
  if (has_list) std::ranges::copy(parts_list_faults(laid.rows), std::back_inserter(faults));
  return faults;
}

}  // namespace

std::vector<std::string> annotation_faults(const DisplayFile& display_file,
                                           const AnnotationPage& page) {
  if (!display_file.has_annotations()) return {};
  return faults_of(annotations_of(display_file), display_file, page);
}

std::vector<std::string> annotation_faults(const ViewedScene& scene, const AnnotationPage& page) {
  return faults_of(scene.annotations(), scene, page);
}

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
