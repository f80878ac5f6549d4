#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "displayfile/entered/kept_annotation.h"
#include "displayfile/text/characters.h"
#include "displayfile/user_routines/ranges.h"
#include "displayfile/user_routines/system_state.h"

namespace displayfile {

namespace {

constexpr double kLargestOffset = 1e6;
constexpr double kUsualOffset = 3.0;         // times the annotation's size
constexpr int kHalvingsOfArc = 5;            // an arc is 2^5 chords
constexpr std::string_view kMeasure = "<>";  // its place in the text of dimensions
constexpr double kDegrees = 57.295779513082320877;

/// The measure with at most this many decimals, without trailing zeros.
std::string measure_text(double measure, int decimals) {
  std::string text = fmt::format("{:.{}f}", measure, decimals);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

/// Uses the square root, which is rounded correctly everywhere, unlike a library's hypot. The
/// division keeps squares in range.
double length_of(const Point3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0.0)) return 0.0;
  const Point3 part = v / largest;
  return largest * std::sqrt(glm::dot(part, part));
}

Point3 unit_direction(const Point3& v, std::string_view what) {
  const double length = length_of(v);
  if (!(length > 0.0)) throw Error(fmt::format("{}: expected two different points", what));
  return v / length;
}

/// Unit vectors from one to the other, in even steps, by halving: sine and cosine differ between
/// libraries.
std::vector<Point3> arc_between(const Point3& from, const Point3& to) {
  std::vector<Point3> arc{from, to};
  for (int k = 0; k < kHalvingsOfArc; ++k) {
    std::vector<Point3> halved;
    for (std::size_t i = 0; i + 1 < arc.size(); ++i) {
      const Point3 sum = arc[i] + arc[i + 1];
      halved.insert(halved.end(), {arc[i], sum / length_of(sum)});
    }
    halved.push_back(arc.back());
    arc = std::move(halved);
  }
  return arc;
}

std::string words_of(const Point3& p) { return fmt::format("{} {} {}", p.x, p.y, p.z); }

void require_dimension_text(std::string_view text) {
  require_characters(text);
  if (text.empty()) return;
  const std::size_t at = text.find(kMeasure);
  if (at != text.npos && text.find(kMeasure, at + kMeasure.size()) == text.npos) return;
  throw Error(fmt::format("dimension text {}: expected {} once, in place of the measure",
                          in_quotation_marks(text), kMeasure));
}

/// Both numbers, each after a blank; empty if there are none.
std::string words_of(const std::optional<Point2>& offset) {
  return offset ? fmt::format(" {} {}", offset->x, offset->y) : std::string();
}

}  // namespace

/// Makes the annotation that a segment keeps, with the settings in force, and writes the arguments
/// with which it is recorded.
struct GraphicsSystem::State::AnnotationEntry {
  using Kind = KeptAnnotation::Kind;
  const State& state;
  std::string_view routine = {};
  std::string arguments = {};

  KeptAnnotation operator()(const Leader& leader) {
    require_characters(leader.text);
    recorded("leader-3", "{} {}{}", words_of(leader.at), in_quotation_marks(leader.text),
             words_of(leader.offset));
    return kept(Kind::leader, {state.to_world(leader.at)}, leader.text, offset_of(leader.offset));
  }
  KeptAnnotation operator()(const Balloon& balloon) {
    if (balloon.number < 1) {
      throw Error(fmt::format("balloon number {}: expected 1 or more", balloon.number));
    }
    require_characters(balloon.name);
    const bool names = !balloon.name.empty() || balloon.offset;
    recorded("balloon-3", "{} {}{}{}{}", words_of(balloon.at), balloon.number, names ? " " : "",
             names ? in_quotation_marks(balloon.name) : "", words_of(balloon.offset));
    KeptAnnotation result = kept(Kind::balloon, {state.to_world(balloon.at)},
                                 fmt::format("{}", balloon.number), offset_of(balloon.offset));
    result.name = balloon.name;
    return result;
  }
  KeptAnnotation operator()(const LinearDimension& d) {
    const auto axis = static_cast<int>(d.axis);
    recorded("linear-dimension-3", "{}  {}  {}  {}", name_of(d.axis), words_of(d.from),
             words_of(d.to), words_of(d.offset));
    const glm::dmat4x3* const modelling = state.modelling_matrix();
    Point3 along(0.0);
    along[axis] = 1.0;
    if (modelling != nullptr) along = (*modelling)[axis];
    along = unit_direction(along, "linear dimension, of an axis that is scaled by 0");
    return dimension_line(d.from, d.to, d.offset, along);
  }
  KeptAnnotation operator()(const AlignedDimension& d) {
    recorded("aligned-dimension-3", "{}  {}  {}", words_of(d.from), words_of(d.to),
             words_of(d.offset));
    const Point3 along =
        unit_direction(state.to_world(d.to) - state.to_world(d.from), "aligned dimension");
    return dimension_line(d.from, d.to, d.offset, along);
  }
  KeptAnnotation operator()(const DiameterDimension& d) {
    recorded("diameter-dimension-3", "{}  {}", words_of(d.from), words_of(d.to));
    return of_circle(Kind::diameter, "\u00d8", d.from, d.to);
  }
  KeptAnnotation operator()(const RadiusDimension& d) {
    recorded("radius-dimension-3", "{}  {}", words_of(d.centre), words_of(d.at));
    return of_circle(Kind::radius, "R", d.centre, d.at);
  }
  KeptAnnotation operator()(const AngleDimension& d) {
    recorded("angle-dimension-3", "{}  {}  {}  {}", words_of(d.vertex), words_of(d.from),
             words_of(d.to), d.radius);
    require_finite({d.radius}, "radius of an angle dimension");
    if (!(d.radius > 0.0)) {
      throw Error(fmt::format("radius of an angle dimension {}: expected more than 0", d.radius));
    }
    const Point3 vertex = state.to_world(d.vertex), from = state.to_world(d.from),
                 to = state.to_world(d.to);
    const Point3 u = unit_direction(from - vertex, "angle dimension"),
                 v = unit_direction(to - vertex, "angle dimension");
    const double sine = length_of(glm::cross(u, v)), cosine = glm::dot(u, v);
    if (!(sine > kLeastSine)) {
      throw Error("angle dimension: expected points in different directions, not opposite");
    }
    std::vector<Point3> points{vertex, from, to};
    const double radius = d.radius * scale_of(d.from - d.vertex, from - vertex);
    for (const Point3& direction : arc_between(u, v)) points.push_back(vertex + radius * direction);
    return kept(Kind::angle, std::move(points),
                dimension_text("", std::atan2(sine, cosine) * kDegrees, "\u00b0"));
  }
  KeptAnnotation operator()(const Title& title) {
    require_characters(title.text);
    recorded("title", "{}", in_quotation_marks(title.text));
    return kept(Kind::title, {}, title.text);
  }
  KeptAnnotation operator()(const PartsList& list) {
    using enum PartsList::Corner;
    recorded("parts-list", "{}", name_of(list.corner));
    const bool right = list.corner == top_right || list.corner == bottom_right;
    const bool top = list.corner == top_left || list.corner == top_right;
    return kept(Kind::list, {}, "", {right ? 1.0 : -1.0, top ? 1.0 : -1.0});
  }

 private:
  static constexpr double kLeastSine = 1e-9;   // of an angle that has a plane
  static constexpr double kLeastPart = 1e-12;  // of the distance, along the axis; less is rounding

  template <class... Value>
  void recorded(std::string_view name, fmt::format_string<const Value&...> form,
                const Value&... values) {
    routine = name;
    if (state.recorder_ != nullptr) arguments = fmt::format(form, values...);
  }
  KeptAnnotation kept(Kind kind, std::vector<Point3> points, std::string characters,
                      const Point2& offset = Point2(0.0)) const {
    for (const Point3& p : points) {
      if (!in_range(p)) throw Error("annotation: coordinate out of range");
    }
    const LineStyle& line = state.looks_.attributes.line;
    const Colour colour = line.kind == LineStyle::Kind::none ? Colour(0.0) : line.colour;
    AnnotationStyle style = state.looks_.annotation;
    style.dimension_text.clear();  // `characters` have it
    return {kind, std::move(style), colour, offset, std::move(points), std::move(characters), {}};
  }
  /// The measure between its signs, or in the text that is set.
  std::string dimension_text(std::string_view before, double measure,
                             std::string_view after) const {
    const AnnotationStyle& style = state.looks_.annotation;
    const std::string number = measure_text(measure, style.decimals);
    if (style.dimension_text.empty()) return fmt::format("{}{}{}", before, number, after);
    std::string text = style.dimension_text;
    return text.replace(text.find(kMeasure), kMeasure.size(), number);
  }
  Point2 offset_of(const std::optional<Point2>& offset) const {
    if (!offset) return Point2(kUsualOffset * state.looks_.annotation.size);
    require_within({kLargestOffset, "1e6"}, {offset->x, offset->y}, "offset of annotation");
    return *offset;
  }
  /// A vector of the coordinates in force, in world coordinates.
  Point3 vector_to_world(const Point3& v) const {
    require_finite({v.x, v.y, v.z}, "offset of a dimension");
    const glm::dmat4x3* const m = state.modelling_matrix();
    return m == nullptr ? v : (*m)[0] * v.x + (*m)[1] * v.y + (*m)[2] * v.z;
  }
  static double scale_of(const Point3& entered, const Point3& world) {
    return length_of(world) / length_of(entered);
  }
  KeptAnnotation dimension_line(const Point3& from, const Point3& to, const Point3& offset,
                                const Point3& along) const {
    const Point3 a = state.to_world(from), b = state.to_world(to);
    const double measure = glm::dot(b - a, along);
    if (!(std::abs(measure) > kLeastPart * length_of(b - a))) {
      throw Error("linear dimension: expected points that differ along the axis");
    }
    const Point3 moved = vector_to_world(offset);
    const Point3 start = a + (moved - glm::dot(moved, along) * along);
    return kept(Kind::linear, {a, b, start, start + measure * along},
                dimension_text("", std::abs(measure), ""));
  }
  KeptAnnotation of_circle(Kind kind, std::string_view sign, const Point3& from,
                           const Point3& to) const {
    const Point3 a = state.to_world(from), b = state.to_world(to);
    const double measure = length_of(b - a);
    if (!(measure > 0.0)) {
      throw Error(fmt::format("{} dimension: expected two different points", name_of(kind)));
    }
    return kept(kind, {a, b}, dimension_text(sign, measure, ""));
  }
};

void GraphicsSystem::annotate(const Annotation& annotation) {
  const RoundToNearest nearest;
  state_->require_open();
  state_->require_no_solid("annotation");
  State::AnnotationEntry entry{*state_};
  KeptAnnotation kept = std::visit(entry, annotation);
  if (!state_->is_viewed_later()) {
    state_->view_stage_->enter_annotation(kept, state_->display_file_.segment(*state_->open_));
  }
  if (RetainedScene* scene = state_->retaining()) scene->enter_annotation(std::move(kept));
  state_->record(entry.routine, {std::string_view(entry.arguments)});
}

void GraphicsSystem::set_annotation_style(const AnnotationStyle& style) {
  if (!(style.size > 0.0 && style.size <= 1000.0)) {
    throw Error(
        fmt::format("annotation size {}: expected more than 0 and at most 1000", style.size));
  }
  if (style.decimals < 0 || style.decimals > 9) {
    throw Error(fmt::format("annotation decimals {}: expected 0 to 9", style.decimals));
  }
  require_dimension_text(style.dimension_text);
  state_->looks_.annotation = style;
  if (state_->recorder_ == nullptr) return;
  // The rest may have been set before recording began.
  const AnnotationStyle before = std::exchange(state_->recorded_annotation_, style);
  const auto is_recorded = [&](auto member) { return style.*member != before.*member; };
  using Style = AnnotationStyle;
  if (is_recorded(&Style::size) || is_recorded(&Style::unit)) {
    state_->record("set-annotation-size", {style.size, name_of(style.unit)});
  }
  if (is_recorded(&Style::ends)) state_->record("set-annotation-ends", {name_of(style.ends)});
  if (is_recorded(&Style::decimals)) state_->record("set-annotation-decimals", {style.decimals});
  if (is_recorded(&Style::placement)) {
    state_->record("set-annotation-placement", {name_of(style.placement)});
  }
  if (is_recorded(&Style::dimension_text)) {
    const std::string quoted = in_quotation_marks(style.dimension_text);
    state_->record("set-dimension-text", {std::string_view(quoted)});
  }
}

}  // namespace displayfile
