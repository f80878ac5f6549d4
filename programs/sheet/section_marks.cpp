#include "programs/sheet/section_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <span>
#include <utility>

#include "clip/geometry/rectangle.h"
#include "programs/sheet/text_fit.h"

namespace displayfile {

namespace {

constexpr double kLetter = 3.5;  // height
constexpr Point2 kClearOfMarks(1.0);

PaperBox box_around(std::span<const Point2> points) {
  PaperBox box{points.front(), points.front()};
  for (const Point2& p : points) box = {glm::min(box.low, p), glm::max(box.high, p)};
  return box;
}
double distance(const PaperBox& a, const PaperBox& b) {
  const Point2 apart = glm::max(a.low - b.high, b.low - a.high);
  return glm::length(glm::max(apart, Point2(0.0)));
}

PaperBox box_of(const PlacedDrawing& view) { return {view.low, view.high}; }

PaperBox box_of_text(const Point2& middle_of_baseline, const std::string& text) {
  const double half = text_width(text, kLetter) / 2.0;
  return {middle_of_baseline - Point2(half, 0.0), middle_of_baseline + Point2(half, kLetter)};
}

/// The parts of the paper that are drawn on.
class Taken {
 public:
  Taken(const std::array<PlacedDrawing, 4>& views, const SheetWords& words) {
    const Point2 paper(words.width, words.height);
    frame_ = {Point2(words.margin), paper - words.margin};
    boxes_.push_back(block_of_titles(words));
    for (const PlacedDrawing& view : views) boxes_.push_back(box_of(view));
  }
  void add(const PaperBox& box) { boxes_.push_back(box); }
  bool is_free(const PaperBox& box) const {
    return box.lies_in(frame_) &&
           std::ranges::none_of(boxes_, [&](const PaperBox& other) { return box.overlaps(other); });
  }

 private:
  PaperBox frame_{};
  std::vector<PaperBox> boxes_;
};

/// An end of a cutting line: thick for a little, and an arrow that points along the direction in
/// which the section is seen, with the section's letter behind it (ISO 128-3).
struct CuttingEnd {
  static constexpr double kThick = 3.5, kArrow = 6.0, kHead = 2.2, kHalfHead = 0.7;
  Point2 end, along, seen;
  std::string letter;
  double beyond;  ///< the view

  Point2 tail() const { return end - kArrow * seen; }
  Point2 letter_at() const { return tail() - (0.9 * kLetter) * seen - Point2(0.0, kLetter / 2.0); }
  /// The corners of the arrow's head besides its tip.
  std::array<Point2, 2> barbs() const {
    const Point2 middle = end - kHead * seen;
    return {middle + kHalfHead * along, middle - kHalfHead * along};
  }
  std::array<PaperBox, 3> boxes() const {
    constexpr double kBesideView = 1.5;
    const std::array line{end - (beyond - kBesideView) * along, end};
    const std::array arrow{end, tail(), barbs()[0], barbs()[1]};
    return {box_around(line), box_around(arrow), box_of_text(letter_at(), letter)};
  }
  void draw(DrawingSheet& sheet) const {
    sheet.lines.push_back({SheetLayer::cutting_ends, {end - kThick * along, end, tail()}});
    sheet.lines.push_back({SheetLayer::cutting_ends, {end, barbs()[0], barbs()[1]}, true});
    sheet.texts.push_back({letter_at(), kLetter, letter, TextStyle::Alignment::centre});
  }
};

/// A line across a view, so far beyond it, with an end on each side.
struct CuttingLine {
  std::array<CuttingEnd, 2> ends;

  bool is_free(const Taken& taken) const {
    return std::ranges::all_of(ends, [&](const CuttingEnd& end) {
      return std::ranges::all_of(end.boxes(), [&](const PaperBox& box) {
        return taken.is_free(box.widened(kClearOfMarks));
      });
    });
  }
  void draw(DrawingSheet& sheet) const {
    sheet.lines.push_back({SheetLayer::cutting, {ends[0].end, ends[1].end}});
    for (const CuttingEnd& end : ends) end.draw(sheet);
  }
  void take(Taken& taken) const {
    taken.add(box_around(std::array{ends[0].end, ends[1].end}));
    for (const CuttingEnd& end : ends) {
      for (const PaperBox& box : end.boxes()) taken.add(box);
    }
  }
};

CuttingLine cutting_line(const PlacedDrawing& other, const PartDrawing& cut, double mm_of_unit,
                         const std::string& letter, double beyond) {
  const PartDrawing& view = *other.view;
  const Point3 p = in_view(view.kind, *cut.position * toward_viewer(cut.kind));
  const Point2 seen(in_view(view.kind, -toward_viewer(cut.kind)));
  const bool upright = toward_viewer(cut.kind).x != 0.0;
  const Point2 place = other.low + mm_of_unit * (Point2(p) - view.low);
  Point2 from(other.low.x - beyond, place.y), to(other.high.x + beyond, place.y), along(1.0, 0.0);
  if (upright) {
    from = {place.x, other.low.y - beyond};
    to = {place.x, other.high.y + beyond};
    along = {0.0, 1.0};
  }
  return {{{{from, -along, seen, letter, beyond}, {to, along, seen, letter, beyond}}}};
}

/// A cut with its letter, and the view in which a line shows its position.
struct ShownCut {
  const PartDrawing* cut;
  const PlacedDrawing* shown_in;
  std::string letter;

  CuttingLine line(double mm_of_unit, double beyond) const {
    return cutting_line(*shown_in, *cut, mm_of_unit, letter, beyond);
  }
};
constexpr double kBeyond = 5.0;

/// A line longer than usual where that would meet something; nothing if any does.
std::optional<CuttingLine> free_line(const ShownCut& cut, double mm_of_unit, const Taken& taken) {
  constexpr double kStep = 1.0, kMost = 40.0;
  for (double beyond = kBeyond; beyond <= kMost; beyond += kStep) {
    CuttingLine line = cut.line(mm_of_unit, beyond);
    if (line.is_free(taken)) return line;
  }
  return std::nullopt;
}

/// Lines that keep clear of each other, found in this order.
std::optional<std::vector<CuttingLine>> free_lines(std::span<const ShownCut* const> order,
                                                   double mm_of_unit, Taken taken) {
  std::vector<CuttingLine> lines;
  for (const ShownCut* cut : order) {
    auto line = free_line(*cut, mm_of_unit, taken);
    if (!line) return std::nullopt;
    line->take(taken);
    lines.push_back(std::move(*line));
  }
  return lines;
}

/// By the first order of finding them in which all have room.
std::vector<CuttingLine> cutting_lines(std::span<const ShownCut> cuts, double mm_of_unit,
                                       const Taken& taken) {
  std::vector<const ShownCut*> order;
  for (const ShownCut& cut : cuts) order.push_back(&cut);
  do {
    if (auto lines = free_lines(order, mm_of_unit, taken)) return *std::move(lines);
  } while (std::next_permutation(order.begin(), order.end()));
  std::vector<CuttingLine> lines;
  for (const ShownCut& cut : cuts) lines.push_back(cut.line(mm_of_unit, kBeyond));
  return lines;
}

/// Where the letters of a cut view may stand, the best first: below or above its middle, and
/// otherwise beside that. The middles of baselines.
std::vector<Point2> caption_places(const PlacedDrawing& view) {
  constexpr double kBelow = 7.0, kAbove = 3.5, kRow = 5.0, kStep = 1.0;
  const double middle = 0.5 * (view.low.x + view.high.x);
  const double farthest = 0.5 * (view.high.x - view.low.x) + 30.0;
  std::vector<Point2> places;
  for (double aside = 0.0; aside <= farthest; aside += kStep) {
    for (const double row : {0.0, kRow, 2.0 * kRow}) {
      for (const double x : {middle - aside, middle + aside}) {
        places.emplace_back(x, view.low.y - kBelow - row);
        places.emplace_back(x, view.high.y + kAbove + row);
      }
    }
  }
  return places;
}

/// The first place that is free, and nearer to its view than to any other.
void add_caption(std::size_t k, const std::array<PlacedDrawing, 4>& views,
                 const std::string& letters, Taken& taken, DrawingSheet& sheet) {
  constexpr Point2 kClear(2.5, 1.5);
  const std::vector<Point2> places = caption_places(views[k]);
  const auto fits = [&](const Point2& place) {
    const PaperBox box = box_of_text(place, letters);
    const double own = distance(box, box_of(views[k]));
    for (std::size_t other = 0; other < views.size(); ++other) {
      if (other != k && distance(box, box_of(views[other])) <= own) return false;
    }
    return taken.is_free(box.widened(kClear));
  };
  const auto found = std::ranges::find_if(places, fits);
  const Point2 place = found == places.end() ? places.front() : *found;
  sheet.texts.push_back({place, kLetter, letters, TextStyle::Alignment::centre});
  taken.add(box_of_text(place, letters));
}

/// The cuts of views, lettered in their order.
std::vector<ShownCut> cuts_of(const std::array<PlacedDrawing, 4>& views) {
  std::vector<ShownCut> cuts;
  for (std::size_t k = 0; k < views.size(); ++k) {
    if (!views[k].view->position) continue;
    const std::string letter(1, static_cast<char>('A' + cuts.size()));
    cuts.push_back({views[k].view, &views[k == 0 ? 1 : 0], letter});
  }
  return cuts;
}

}  // namespace

std::vector<PaperBox> usual_places_of_section_marks(const std::array<PlacedDrawing, 4>& views,
                                                    double mm_of_unit) {
  std::vector<PaperBox> boxes;
  for (const ShownCut& cut : cuts_of(views)) {
    for (const CuttingEnd& end : cut.line(mm_of_unit, kBeyond).ends) {
      for (const PaperBox& box : end.boxes()) boxes.push_back(box.widened(kClearOfMarks));
    }
  }
  return boxes;
}

void add_section_marks(const std::array<PlacedDrawing, 4>& views,
                       std::span<const PaperBox> occupied, const SheetWords& words,
                       double mm_of_unit, DrawingSheet& sheet) {
  Taken taken(views, words);
  for (const PaperBox& box : occupied) taken.add(box);
  const std::vector<ShownCut> cuts = cuts_of(views);
  for (const CuttingLine& line : cutting_lines(cuts, mm_of_unit, taken)) {
    line.draw(sheet);
    line.take(taken);
  }
  for (const ShownCut& cut : cuts) {
    const auto k = static_cast<std::size_t>(
        std::ranges::find(views, cut.cut, &PlacedDrawing::view) - views.begin());
    add_caption(k, views, cut.letter + "-" + cut.letter, taken, sheet);
  }
}

}  // namespace displayfile
