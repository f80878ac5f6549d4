#include "programs/sheet/detail_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "programs/sheet/text_fit.h"

namespace displayfile {

namespace {

constexpr double kCaptionHeight = 3.5, kCaptionGap = 3.0;  // mm

double mm_of(const DetailWanted& detail, const SheetWords& words) {
  return words.unit * detail.scale.factor();
}
double radius_on_paper(const DetailWanted& detail, const SheetWords& words) {
  return detail.radius * mm_of(detail, words);
}
std::string caption_of(std::size_t index, const DetailWanted& detail) {
  return fmt::format("{} ({})", kDetailLetters[index], detail.scale.text());
}

Point2 size_of(std::size_t index, const DetailWanted& detail, const SheetWords& words) {
  const double across = 2.0 * radius_on_paper(detail, words);
  return {std::max(across, text_width(caption_of(index, detail), kCaptionHeight)),
          across + kCaptionGap + kCaptionHeight};
}

/// The circle's middle; the caption is above it.
Point2 middle_of(const PaperBox& box, double radius) {
  return {0.5 * (box.low.x + box.high.x), box.low.y + radius};
}

/// The polygon's part on one side of a line across an axis. Where it runs to and fro along the
/// line, nothing is enclosed.
std::vector<Point2> on_side(const std::vector<Point2>& polygon, int axis, double at, double sign) {
  std::vector<Point2> kept;
  if (polygon.empty()) return kept;
  Point2 from = polygon.back();
  for (const Point2& to : polygon) {
    const double a = sign * (from[axis] - at), b = sign * (to[axis] - at);
    if ((a < 0.0) != (b < 0.0)) kept.push_back(from + (a / (a - b)) * (to - from));
    if (b >= 0.0) kept.push_back(to);
    from = to;
  }
  return kept;
}

/// Sutherland and Hodgman's clipping.
std::vector<Point2> within(std::vector<Point2> polygon, const PaperBox& square) {
  for (const int axis : {0, 1}) {
    polygon = on_side(polygon, axis, square.low[axis], 1.0);
    polygon = on_side(polygon, axis, square.high[axis], -1.0);
  }
  return polygon;
}

/// Returns the part of a line inside a circle: from and to, as fractions of its length.
std::optional<std::pair<double, double>> in_circle(const Point2& from, const Point2& to,
                                                   const Point2& middle, double radius) {
  const Point2 along = to - from, start = from - middle;
  const double a = glm::dot(along, along), b = glm::dot(along, start);
  const double root = b * b - a * (glm::dot(start, start) - radius * radius);
  if (!(a > 0.0) || root <= 0.0) return std::nullopt;
  const double half = std::sqrt(root);
  const double enters = std::max(0.0, (-b - half) / a), leaves = std::min(1.0, (-b + half) / a);
  if (enters >= leaves) return std::nullopt;
  return std::pair(enters, leaves);
}

/// Returns the part of a view that may be visible in a circle, and little more: it is drawn at a
/// larger scale.
PartDrawing near_circle(const PartDrawing& view, const Point2& middle, double radius) {
  constexpr double kMargin = 1.5;
  const PaperBox square{middle - kMargin * radius, middle + kMargin * radius};
  PartDrawing part = view;
  std::erase_if(part.lines, [&](const PartDrawing::Line& line) {
    return !in_circle(line.from, line.to, middle, kMargin * radius);
  });
  std::erase_if(part.centre_lines, [&](const PartDrawing::CentreLine& line) {
    return !in_circle(line.from, line.to, middle, kMargin * radius);
  });
  for (PartDrawing::CutLoop& loop : part.cut) loop.points = within(loop.points, square);
  std::erase_if(part.cut, [](const auto& loop) { return loop.points.size() < 3; });
  for (auto& polygon : part.before) polygon = within(polygon, square);
  std::erase_if(part.before, [](const auto& polygon) { return polygon.size() < 3; });
  return part;
}

void add_within_circle(const DrawingSheet::Line& line, const Point2& middle, double radius,
                       DrawingSheet& sheet) {
  std::vector<Point2> points = line.points;
  const auto is_outside = [&](const Point2& p) { return glm::distance(p, middle) > radius; };
  if (std::ranges::none_of(points, is_outside)) return sheet.lines.push_back(line);
  if (line.closed) points.push_back(points.front());
  std::vector<Point2> piece;
  const auto end_piece = [&] {
    if (piece.size() > 1) sheet.lines.push_back({line.layer, std::exchange(piece, {}), false});
    piece.clear();
  };
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const auto inside = in_circle(points[k], points[k + 1], middle, radius);
    if (!inside) {
      end_piece();
      continue;
    }
    const auto at = [&](double t) { return points[k] + t * (points[k + 1] - points[k]); };
    if (inside->first > 0.0) end_piece();
    if (piece.empty()) piece.push_back(at(inside->first));
    piece.push_back(at(inside->second));
    if (inside->second < 1.0) end_piece();
  }
  end_piece();
}

void add_detail_circle(const Point2& middle, double radius, DrawingSheet& sheet) {
  constexpr int kSides = 180;
  DrawingSheet::Line circle{SheetLayer::detail, {}, true};
  for (int k = 0; k < kSides; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kSides;
    circle.points.push_back(middle + radius * Point2(std::cos(angle), std::sin(angle)));
  }
  sheet.lines.push_back(std::move(circle));
}

bool meets(const DrawingSheet::Line& line, const PaperBox& box) {
  const std::size_t sides = line.points.size() - (line.closed ? 0 : 1);
  for (std::size_t k = 0; k < sides; ++k) {
    const Point2 &from = line.points[k], &to = line.points[(k + 1) % line.points.size()];
    if (std::max(from.x, to.x) < box.low.x || std::min(from.x, to.x) > box.high.x ||
        std::max(from.y, to.y) < box.low.y || std::min(from.y, to.y) > box.high.y) {
      continue;
    }
    const auto side = [&](const Point2& p) {
      return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
    };
    const double a = side(box.low), b = side({box.high.x, box.low.y}), c = side(box.high),
                 d = side({box.low.x, box.high.y});
    if (std::min({a, b, c, d}) <= 0.0 && std::max({a, b, c, d}) >= 0.0) return true;
  }
  return false;
}

/// Beside the circle, in the first direction in which nothing is drawn.
PaperBox add_letter(const Point2& middle, double radius, char letter, DrawingSheet& sheet) {
  constexpr int kDirections = 16;
  constexpr double kApart = 1.0;
  const std::string text(1, letter);
  const Point2 half(0.5 * text_width(text, kCaptionHeight), 0.5 * kCaptionHeight);
  std::optional<Point2> first, found;
  for (int k = 0; k < kDirections && !found; ++k) {
    const double angle = std::numbers::pi * (0.25 + 2.0 * k / kDirections);
    const Point2 at =
        middle + (radius + kApart + glm::length(half)) * Point2(std::cos(angle), std::sin(angle));
    if (!first) first = at;
    const PaperBox box = PaperBox{at - half, at + half}.widened(Point2(0.5));
    const auto is_drawn = [&](const DrawingSheet::Line& line) { return meets(line, box); };
    if (std::ranges::none_of(sheet.lines, is_drawn)) found = at;
  }
  const Point2 at = found.value_or(*first);
  sheet.texts.push_back(
      {at - Point2(0.0, half.y), kCaptionHeight, text, TextStyle::Alignment::centre});
  return {at - half, at + half};
}

double distance_between(const Point2& p, const PaperBox& box) {
  return glm::distance(p, 0.5 * (box.low + box.high));
}

/// The free rectangle of a size whose middle is nearest to a point.
std::optional<PaperBox> nearest_free(const Point2& size, const Point2& to, const PaperBox& frame,
                                     std::span<const PaperBox> taken) {
  constexpr double kStep = 2.0;
  std::optional<PaperBox> nearest;
  for (double x = frame.low.x; x + size.x <= frame.high.x; x += kStep) {
    for (double y = frame.low.y; y + size.y <= frame.high.y; y += kStep) {
      const PaperBox box{{x, y}, Point2(x, y) + size};
      if (nearest && distance_between(to, box) >= distance_between(to, *nearest)) continue;
      const auto overlaps = [&](const PaperBox& other) { return other.overlaps(box); };
      if (std::ranges::none_of(taken, overlaps)) nearest = box;
    }
  }
  return nearest;
}

}  // namespace

std::optional<std::vector<PaperBox>> places_of_details(const std::array<PartDrawing, 4>& views,
                                                       std::span<const ViewPlace> places,
                                                       const SheetWords& words) {
  constexpr double kFrame = 3.0, kViews = 6.0, kCutViews = 13.0;  // clear of these
  const Point2 paper(words.width, words.height);
  const PaperBox frame{Point2(words.margin + kFrame), paper - (words.margin + kFrame)};
  const bool has_sections =
      std::ranges::any_of(views, [](const PartDrawing& view) { return view.position.has_value(); });
  std::vector<PaperBox> taken{block_of_titles(words).widened(Point2(kFrame))};
  for (std::size_t k = 0; k < views.size(); ++k) {
    const PaperBox box{places[k].at, places[k].on_paper(views[k], views[k].high)};
    taken.push_back(box.widened(Point2(has_sections ? kCutViews : kViews)));
  }
  std::vector<PaperBox> boxes;
  for (std::size_t i = 0; i < words.details.size(); ++i) {
    const DetailWanted& detail = words.details[i];
    const Point2 shown = places[detail.view].on_paper(views[detail.view], detail.middle);
    const auto box = nearest_free(size_of(i, detail, words), shown, frame, taken);
    if (!box) return std::nullopt;
    boxes.push_back(*box);
    taken.push_back(box->widened(Point2(kViews)));
  }
  return boxes;
}

std::vector<PaperBox> add_details(const std::array<PartDrawing, 4>& views,
                                  std::span<const ViewPlace> places,
                                  std::span<const PaperBox> boxes, const SheetWords& words,
                                  const std::vector<BodyHatching>& hatching, DrawingSheet& sheet) {
  for (std::size_t i = 0; i < words.details.size(); ++i) {
    const DetailWanted& detail = words.details[i];
    const PartDrawing& view = views[detail.view];
    const double mm = mm_of(detail, words), radius = radius_on_paper(detail, words);
    const Point2 middle = middle_of(boxes[i], radius);
    DrawingSheet enlarged;
    add_view(near_circle(view, detail.middle, detail.radius),
             {middle - mm * (detail.middle - view.low), mm}, hatching, enlarged);
    for (const auto& line : enlarged.lines) add_within_circle(line, middle, radius, sheet);
    add_detail_circle(middle, radius, sheet);
    sheet.texts.push_back({{middle.x, middle.y + radius + kCaptionGap},
                           kCaptionHeight,
                           caption_of(i, detail),
                           TextStyle::Alignment::centre});
    add_detail_circle(places[detail.view].on_paper(view, detail.middle),
                      detail.radius * places[detail.view].mm, sheet);
  }
  std::vector<PaperBox> letters;
  for (std::size_t i = 0; i < words.details.size(); ++i) {
    const DetailWanted& detail = words.details[i];
    const ViewPlace& place = places[detail.view];
    letters.push_back(add_letter(place.on_paper(views[detail.view], detail.middle),
                                 detail.radius * place.mm, kDetailLetters[i], sheet));
  }
  return letters;
}

}  // namespace displayfile
