#include "displayfile/user_routines/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "clip/geometry/rectangle.h"
#include "displayfile/graphics_system.h"
#include "displayfile/looks/letters.h"
#include "displayfile/looks/style.h"
#include "displayfile/user_routines/ranges.h"

namespace displayfile {

namespace {

/// Lengths relative to the size of the texts, as seen.
constexpr double kTick = 0.4, kGap = 0.45, kCapital = kCapitalHeight;
constexpr double kBeside = 2.8, kAbove = 1.4;  // from a number to the next in a row, in a column
constexpr double kNearest = kTick + 2.0 * kGap, kFarthest = 30.0, kFarther = 0.25;  // of names
constexpr double kFarthestNumbers = 5.0;
const Point2 kAroundNumbers(0.5, 0.15);  // closer in a row they would be read as one
const Point2 kAroundNames(1.0, kGap);    // beside a number a name would be read as its unit
constexpr int kMostSteps = 5;            // between the ends of an axis
constexpr double kStep = 1e-3;           // of the box, to see which way a direction goes
constexpr double kUnseen = 1e-6;         // a length where the picture's height is 1

double dot(const Point2& a, const Point2& b) { return a.x * b.x + a.y * b.y; }
double cross(const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; }
double length(const Point2& a) { return std::sqrt(dot(a, a)); }

// ---- Numbers at ticks ----------------------------------------------------------------------

/// digits times a power of ten, rounded once.
double decimal(std::int64_t digits, int exponent) {
  const std::string text = fmt::format("{}e{}", digits, exponent);
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

// ---- Positions of axes ---------------------------------------------------------------------

struct Label {
  Point3 at;
  std::string text;
  TextStyle::Alignment alignment;
};

/// True if a line enters a box, by Liang and Barsky's test.
bool comes_into(const PaperBox& box, const Point2& from, const Point2& to) {
  double first = 0.0, last = 1.0;
  for (int a = 0; a < 2; ++a) {
    const double along = to[a] - from[a];
    if (along == 0.0) {
      if (from[a] <= box.low[a] || from[a] >= box.high[a]) return false;
      continue;
    }
    const double enters = (box.low[a] - from[a]) / along, leaves = (box.high[a] - from[a]) / along;
    first = std::max(first, std::min(enters, leaves));
    last = std::min(last, std::max(enters, leaves));
  }
  return first < last;
}

/// The drawn parts of all axes.
struct Axes {
  std::vector<std::array<Point3, 2>> lines;
  std::vector<Label> labels;
  std::vector<PaperBox> boxes;  ///< of the labels
};

class AxesOfBox {
 public:
  AxesOfBox(const GraphicsSystem& system, const Point3& low, const Point3& high)
      : system_(system), ends_{low, high}, size_(system.looks().attributes.text.size) {
    const Point3 extent = high - low;
    const double widest = std::max({extent.x, extent.y, extent.z});
    for (int a = 0; a < 3; ++a) unit_[a] = extent[a] > 0.0 ? extent[a] : widest;
    for (int across = 0; across < 3; ++across) {
      for (int end = 0; end < 2; ++end) {
        const double area = seen_area(across, end);
        is_turned_[across][end] = area > kUnseen * kUnseen;
        has_faces_ = has_faces_ || is_turned_[across][end];
      }
    }
  }

  Axes axes(const std::array<std::string_view, 3>& names) const {
    Axes axes;
    std::array<std::optional<Edge>, 3> edges;
    for (int along = 0; along < 3; ++along) {
      auto& edge = edges[static_cast<std::size_t>(along)];
      edge = edge_of(along);
      if (edge) append_scale(along, *edge, axes);
    }
    for (std::size_t along = 0; along < 3; ++along) {
      if (edges[along] && !names[along].empty()) append_name(*edges[along], names[along], axes);
    }
    return axes;
  }

 private:
  struct Edge {
    Point3 from, to;
    Point2 outward, ticks;  ///< directions as they are seen, of length 1
  };

  void append_scale(int along, const Edge& edge, Axes& axes) const {
    axes.lines.push_back({edge.from, edge.to});
    const Point2 all = seen(edge.to) - seen(edge.from);
    const double apart =
        (std::abs(all.x) * kBeside + std::abs(all.y) * kAbove) * size_ / length(all);
    const int most_steps =
        static_cast<int>(std::clamp(std::floor(length(all) / apart), 1.0, 1.0 * kMostSteps));
    for (const double value : axis_ticks(edge.from[along], edge.to[along], most_steps)) {
      Point3 at = edge.from;
      at[along] = value;
      axes.lines.push_back({at, moved(at, edge.ticks * (kTick * size_))});
      append_number(at, edge.ticks, axis_number(value), axes);
    }
  }

  /// Appends a number far enough out to be beside its axis and clear of the box, even if it is long
  /// and across the axis; farther out if another number is in the way, and omitted if that does not
  /// help.
  void append_number(const Point3& at, const Point2& outward, const std::string& number,
                     Axes& axes) const {
    double distance = kTick + kGap;
    while (distance < kFarthestNumbers && meets_box(label(at, outward, distance, number))) {
      distance += kFarther;
    }
    for (double farther = 0.0; farther <= 1.5; farther += kFarther) {
      Label placed = label(at, outward, distance + farther, number);
      if (has_room(placed, kAroundNumbers, axes)) return append(std::move(placed), axes);
    }
  }

  /// Appends a name in the picture, beside the middle of its axis, as near to it as there is room
  /// beside the box, the numbers and the other names; or beside another place of the axis; or
  /// beyond its high end, or its low one; or the same over the box. If there is no room, beside the
  /// middle, even if it is cut off there.
  void append_name(const Edge& edge, std::string_view name, Axes& axes) const {
    for (const bool over_box : {false, true}) {
      for (const double t : {0.5, 0.6, 0.4, 0.7, 0.3, 0.8, 0.2, 0.9, 0.1}) {
        auto placed = beside(edge, t, name, over_box, axes);
        if (placed && is_in_picture(*placed)) return append(std::move(*placed), axes);
      }
      for (const bool high : {true, false}) {
        auto placed = beyond(edge, high, name, over_box, axes);
        if (placed) return append(std::move(*placed), axes);
      }
    }
    auto placed = beside(edge, 0.5, name, true, axes);
    if (!placed)
      placed = label(middle(edge.from, edge.to), edge.outward, kNearest, std::string(name));
    append(std::move(*placed), axes);
  }

  /// The nearest place beside an axis at which there is room, if any.
  std::optional<Label> beside(const Edge& edge, double t, std::string_view name, bool over_box,
                              const Axes& axes) const {
    for (double distance = kNearest; distance <= kFarthest; distance += kFarther) {
      Label placed =
          label((1.0 - t) * edge.from + t * edge.to, edge.outward, distance, std::string(name));
      if (has_room(placed, kAroundNames, axes) && (over_box || !meets_box(placed))) return placed;
    }
    return std::nullopt;
  }

  /// Above or below an end of an axis, as seen, if there is room in the picture; moved along its
  /// line as far as the picture requires.
  std::optional<Label> beyond(const Edge& edge, bool high, std::string_view name, bool over_box,
                              const Axes& axes) const {
    const Point3& end = high ? edge.to : edge.from;
    const Point2 away(0.0, seen(end).y >= seen(high ? edge.from : edge.to).y ? 1.0 : -1.0);
    for (double distance = kNearest; distance <= kFarthest; distance += kFarther) {
      Label placed = label(end, away, distance, std::string(name));
      const PaperBox box = box_of(placed);
      const double right_by = std::max(0.0, picture().low.x - box.low.x);
      const double left_by = std::max(0.0, box.high.x - picture().high.x);
      placed.at = moved(placed.at, Point2(right_by - left_by, 0.0));
      const bool has_place = is_in_picture(placed) && has_room(placed, kAroundNames, axes);
      if (has_place && (over_box || !meets_box(placed))) return placed;
    }
    return std::nullopt;
  }

  bool has_room(const Label& label, const Point2& around, const Axes& axes) const {
    const PaperBox box = box_of(label).widened(around * size_);
    return std::ranges::none_of(axes.boxes,
                                [&](const PaperBox& other) { return box.overlaps(other); });
  }
  PaperBox picture() const {
    return PaperBox{Point2(0.0), Point2(system_.aspect_ratio(), 1.0)}.widened(
        Point2(-0.5 * kGap * size_));
  }
  bool is_in_picture(const Label& label) const { return box_of(label).lies_in(picture()); }

  /// True if the letters overlap an edge of the box.
  bool meets_box(const Label& label) const {
    const PaperBox letters = box_of(label).widened(Point2(kGap * size_));
    for (int from = 0; from < 8; ++from) {
      for (int along = 0; along < 3; ++along) {
        const int to = from | (1 << along);
        if (to != from && comes_into(letters, seen(corner(bits(from))), seen(corner(bits(to))))) {
          return true;
        }
      }
    }
    return false;
  }
  static glm::ivec3 bits(int corner) { return {corner & 1, (corner >> 1) & 1, corner >> 2}; }

  void append(Label label, Axes& axes) const {
    axes.boxes.push_back(box_of(label));
    axes.labels.push_back(std::move(label));
  }

  PaperBox box_of(const Label& label) const {
    const PaperBox letters =
        letters_at_anchor({.size = size_, .alignment = label.alignment}, label.text);
    const Point2 at = seen(label.at);
    return {at + letters.low, at + letters.high};
  }

  /// The position of a point in the picture, whose height is 1.
  Point2 seen(const Point3& p) const {
    const std::optional<Point3> device = system_.to_device(p);
    if (!device)
      throw Error(
          "axes: the box or the numbers and names beside it are not entirely in front of the eye");
    return {device->x * system_.aspect_ratio(), device->y};
  }

  static Point3 middle(const Point3& a, const Point3& b) { return 0.5 * a + 0.5 * b; }

  Point3 corner(const glm::ivec3& end) const {
    return {ends_[end[0]].x, ends_[end[1]].y, ends_[end[2]].z};
  }

  /// Twice the area of a face as seen, with the sign of its orientation about its outward
  /// direction.
  double seen_area(int across, int end) const {
    Point2 corners[4];
    for (int k = 0; k < 4; ++k) {
      glm::ivec3 at(0);
      at[across] = end;
      at[(across + 1) % 3] = k == 1 || k == 2 ? 1 : 0;
      at[(across + 2) % 3] = k / 2;
      corners[k] = seen(corner(at));
    }
    const double area = cross(corners[2] - corners[0], corners[3] - corners[1]);
    return end == 1 ? area : -area;
  }

  /// The edge on which an axis is drawn: the lowest, or if they are steep the leftmost, among those
  /// on the box's outline as seen, where one of the two adjacent faces is turned to the viewer.
  std::optional<Edge> edge_of(int along) const {
    if (ends_[0][along] == ends_[1][along]) return std::nullopt;
    const glm::ivec2 others{(along + 1) % 3, (along + 2) % 3};
    std::optional<Edge> found;
    double best = 0.0;
    for (int k = 0; k < 4; ++k) {
      const glm::ivec2 end{k & 1, k >> 1};
      if (is_turned_[others[0]][end[0]] == is_turned_[others[1]][end[1]] && has_faces_) continue;
      glm::ivec3 at(0);
      for (int i = 0; i < 2; ++i) at[others[i]] = end[i];
      const Point3 from = corner(at);
      at[along] = 1;
      const Point3 to = corner(at);
      const Point2 direction = seen(to) - seen(from);
      if (length(direction) < kUnseen) continue;
      const bool is_steep = std::abs(direction.y) > 2.0 * std::abs(direction.x);
      const Point2 outward = outward_of(direction, seen(middle(from, to)), is_steep);
      const double preferred = is_steep ? -outward.x : -outward.y;
      if (found && preferred < best + kUnseen) continue;
      best = preferred;
      found = {from, to, outward, ticks_at(middle(from, to), others, end, outward)};
    }
    return found;
  }

  /// The direction across an edge as seen, of length 1: away from the box's middle; if the edge
  /// passes through it, downward, or to the left of a steep one.
  Point2 outward_of(const Point2& direction, const Point2& from, bool is_steep) const {
    const Point2 across = Point2(direction.y, -direction.x) / length(direction);
    const double away = dot(from - seen(middle(ends_[0], ends_[1])), across);
    if (std::abs(away) > kUnseen) return away > 0.0 ? across : -across;
    return (is_steep ? across.x > 0.0 : across.y > 0.0) ? -across : across;
  }

  /// A small step along an axis of the box as seen: a perspective view is straight enough there.
  Point2 seen_step(const Point3& p, int along) const {
    Point3 before = p, after = p;
    before[along] -= 0.5 * kStep * unit_[along];
    after[along] += 0.5 * kStep * unit_[along];
    return seen(after) - seen(before);
  }

  /// The direction of ticks: they continue another axis of the box that ends there, the one of the
  /// two that leads outward more.
  Point2 ticks_at(const Point3& p, const glm::ivec2& others, const glm::ivec2& end,
                  const Point2& outward) const {
    Point2 best = outward;
    double farthest = 0.1;
    for (int i = 0; i < 2; ++i) {
      const Point2 step = seen_step(p, others[i]) * (end[i] == 1 ? 1.0 : -1.0);
      if (length(step) < kStep * kUnseen) continue;
      const double distance = dot(step, outward) / length(step);
      if (distance <= farthest) continue;
      farthest = distance;
      best = step / length(step);
    }
    return best;
  }

  /// The point that appears at this offset from p, in the plane of the two directions of the box
  /// that appear farthest apart.
  Point3 moved(const Point3& p, const Point2& by) const {
    Point2 seen_steps[3];
    for (int a = 0; a < 3; ++a) seen_steps[a] = seen_step(p, a);
    int a = 0, b = 1;
    double widest = 0.0;
    for (int k = 0; k < 3; ++k) {
      const double area = std::abs(cross(seen_steps[k], seen_steps[(k + 1) % 3]));
      if (area <= widest) continue;
      widest = area;
      a = k;
      b = (k + 1) % 3;
    }
    if (widest == 0.0) return p;
    const double whole = cross(seen_steps[a], seen_steps[b]);
    Point3 to = p;
    to[a] += kStep * unit_[a] * (cross(by, seen_steps[b]) / whole);
    to[b] += kStep * unit_[b] * (cross(seen_steps[a], by) / whole);
    return to;
  }

  /// A text beside a point of an axis, whose letters are `distance` away from it.
  Label label(const Point3& at, const Point2& outward, double distance, std::string text) const {
    using enum TextStyle::Alignment;
    const Point2 below(0.0, 0.5 * kCapital * (outward.y - 1.0));  // from the letters' middle or top
    return {moved(at, (outward * distance + below) * size_), std::move(text),
            outward.x < -0.4  ? right
            : outward.x > 0.4 ? left
                              : centre};
  }

  const GraphicsSystem& system_;
  Point3 ends_[2];
  double size_;
  Point3 unit_{};           ///< the box's sizes; its greatest for those that are 0
  bool is_turned_[3][2]{};  ///< faces: to the viewer, or all away from the viewer
  bool has_faces_ = false;
};

void require_box(const Point3& low, const Point3& high) {
  for (int a = 0; a < 3; ++a) {
    if (!(low[a] > high[a])) continue;
    const char axis = "xyz"[a];
    throw Error(
        fmt::format("axes from {} {} to {}: expected {}-min <= {}-max, in this order: "
                    "x-min x-max y-min y-max z-min z-max",
                    axis, low[a], high[a], axis, axis));
  }
  if (low == high) throw Error("axes of a point: expected x-min < x-max, or likewise for y or z");
}

/// Throws Error if any of the points cannot be entered.
void require_in_range(const GraphicsSystem& system, const Axes& axes) {
  for (const auto& [from, to] : axes.lines) {
    system.to_device(from);
    system.to_device(to);
  }
  for (const Label& label : axes.labels) system.to_device(label.at);
}

}  // namespace

std::vector<double> axis_ticks(double low, double high, int most_steps) {
  const RoundToNearest nearest;
  const double range = high - low;
  int exponent = static_cast<int>(std::floor(std::log10(range))) - 2;  // too small for sure
  std::int64_t digit = 1;
  while (!(range <= (most_steps + 1e-6) * decimal(digit, exponent))) {
    exponent += digit == 5 ? 1 : 0;
    digit = digit == 1 ? 2 : digit == 2 ? 5 : 1;
  }
  const double step = decimal(digit, exponent);
  std::vector<double> values;
  const auto first = static_cast<std::int64_t>(std::floor(low / step)) - 1;
  const auto last = static_cast<std::int64_t>(std::ceil(high / step)) + 1;
  for (std::int64_t i = first; i <= last; ++i) {
    const double value = decimal(digit * i, exponent);
    const bool is_new = values.empty() || value > values.back();
    if (value >= low && value <= high && is_new) values.push_back(value);
  }
  return values;
}

std::string axis_number(double value) {
  const RoundToNearest nearest;
  const std::string text = fmt::format("{}", value == 0.0 ? 0.0 : value);
  return text.starts_with('-') ? "\u2212" + text.substr(1) : text;
}

void axes_3(GraphicsSystem& system, const Point3& low, const Point3& high,
            const std::array<std::string_view, 3>& names) {
  const RoundToNearest nearest;
  if (!system.open_segment_name()) throw Error("no segment open: open one first");
  system.to_device(low);
  system.to_device(high);
  require_box(low, high);
  std::ranges::for_each(names, require_characters);
  const Axes axes = AxesOfBox(system, low, high).axes(names);
  require_in_range(system, axes);

  const TextStyle in_force = system.looks().attributes.text;
  for (const auto& [from, to] : axes.lines) {
    system.move_abs_3(from.x, from.y, from.z);
    system.line_abs_3(to.x, to.y, to.z);
  }
  for (const Label& label : axes.labels) {
    TextStyle style = in_force;
    style.alignment = label.alignment;
    if (system.looks().attributes.text != style) system.set_text_style(style);
    system.move_abs_3(label.at.x, label.at.y, label.at.z);
    system.text(label.text);
  }
  if (system.looks().attributes.text != in_force) system.set_text_style(in_force);
  system.move_abs_3(low.x, low.y, low.z);
}

}  // namespace displayfile
