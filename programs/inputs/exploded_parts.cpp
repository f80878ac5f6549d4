#include "programs/inputs/exploded_parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <optional>
#include <sstream>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "clip/view/view_volume.h"
#include "displayfile/segments/display_file.h"
#include "programs/inputs/assembled_inputs.h"
#include "programs/inputs/inputs.h"
#include "programs/process/warnings.h"

namespace displayfile {

namespace {

constexpr double kEqual = 1e-6;  // of the longest part, by which places of equal parts may differ

Point3 middle_of(const AssemblyPart& part) { return 0.5 * part.low + 0.5 * part.high; }

/// For each part its place among those that the explosion names; others have the number of these.
std::vector<std::size_t> places_in_order(std::span<const AssemblyPart> parts,
                                         const Explosion& explosion) {
  const std::vector<std::string>& order = explosion.order;
  std::vector<std::size_t> places;
  for (const AssemblyPart& part : parts) {
    const auto place = std::ranges::find(order, part.name);
    places.push_back(static_cast<std::size_t>(place - order.begin()));
  }
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (std::find(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(k), order[k]) !=
        order.begin() + static_cast<std::ptrdiff_t>(k)) {
      throw Error(fmt::format("--explode {}: {} is there twice: expected each part once",
                              explosion.word, order[k]));
    }
    if (std::ranges::find(places, k) != places.end()) continue;
    std::vector<std::string_view> names;
    for (const AssemblyPart& part : parts) names.push_back(part.name);
    throw Error(fmt::format("--explode {}: no part has the name {}: expected some of {}",
                            explosion.word, order[k], fmt::join(names, ", ")));
  }
  return places;
}

/// The parts of an assembly along an axis, in the order of their moves: each level is a part, or
/// several equal ones side by side.
class Levels {
 public:
  Levels(std::span<const AssemblyPart> parts, int axis, double reach)
      : parts_(parts), axis_(axis), reach_(reach) {}
  const std::vector<std::vector<std::size_t>>& all() const { return all_; }

  /// Parts must be added in order; those in different places of an order that is set stay apart.
  void add(std::size_t part, std::size_t place) {
    std::vector<std::size_t>& of_kind = of_kinds_[{place, parts_[part].points}];
    for (const std::size_t level : of_kind) {
      const auto beside = [&](std::size_t other) { return are_side_by_side(part, other); };
      if (std::ranges::all_of(all_[level], beside)) return all_[level].push_back(part);
    }
    of_kind.push_back(all_.size());
    all_.push_back({part});
  }

 private:
  bool are_side_by_side(std::size_t a, std::size_t b) const {
    const AssemblyPart &p = parts_[a], &q = parts_[b];
    if (std::abs(p.low[axis_] - q.low[axis_]) > reach_) return false;
    if (std::abs(p.high[axis_] - q.high[axis_]) > reach_) return false;
    const auto are_apart = [&](int across) {  // flat ones in one place are not
      const double apart = std::max(q.low[across] - p.high[across], p.low[across] - q.high[across]);
      return apart >= -reach_ && std::abs(p.low[across] - q.low[across]) > reach_;
    };
    return are_apart((axis_ + 1) % 3) || are_apart((axis_ + 2) % 3);
  }

  std::span<const AssemblyPart> parts_;
  int axis_;
  double reach_;
  std::vector<std::vector<std::size_t>> all_;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> of_kinds_;
};

/// Along an axis; coordinates are multiplied by `sign`, so that it is upward.
void move_along(std::vector<AssemblyPart>& parts, int axis, const Explosion& explosion) {
  const double sign = explosion.downward ? -1.0 : 1.0, factor = explosion.factor;
  const std::vector<std::size_t> places = places_in_order(parts, explosion);
  const auto begins = [&](const AssemblyPart& p) {
    return sign > 0.0 ? p.low[axis] : -p.high[axis];
  };
  const auto ends = [&](const AssemblyPart& p) { return sign > 0.0 ? p.high[axis] : -p.low[axis]; };
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) {
    return std::tuple(places[i], begins(parts[i]), ends(parts[i]));
  });
  double lengths = 0.0, longest = 0.0;
  for (const AssemblyPart& part : parts) {
    lengths += part.high[axis] - part.low[axis];
    longest = std::max(longest, glm::length(part.high - part.low));
  }
  const double mean = lengths / static_cast<double>(parts.size());
  const double gap = factor * (mean > 0.0 ? mean : longest);  // all of them flat
  Levels levels(parts, axis, kEqual * longest);
  for (const std::size_t part : order) levels.add(part, places[part]);
  if (levels.all().size() == 1) {
    throw Error(
        fmt::format("--explode {}: the parts are equal and side by side: expected another axis, "
                    "radial, or an order such as {}:{},{}",
                    explosion.word, explosion.word.substr(0, explosion.word.find(':')),
                    parts[order[0]].name, parts[order[1]].name));
  }
  double end = ends(parts[order.front()]), move = 0.0;
  for (const std::vector<std::size_t>& level : std::span(levels.all()).subspan(1)) {
    const double before = move;
    const AssemblyPart& first = parts[level.front()];
    move = std::max(end - begins(first), move) + gap;
    for (const std::size_t part : level) {
      parts[part].neighbour[axis] = sign * before;
      parts[part].move[axis] = sign * move;
    }
    end = ends(first) + move;
  }
}

void move_radially(std::vector<AssemblyPart>& parts, const Explosion& explosion) {
  Point3 low = parts.front().low, high = parts.front().high;
  for (const AssemblyPart& part : parts) {
    low = glm::min(low, part.low);
    high = glm::max(high, part.high);
  }
  const Point3 centre = 0.5 * low + 0.5 * high;
  for (AssemblyPart& part : parts) part.move = explosion.factor * (middle_of(part) - centre);
  const bool any =
      std::ranges::any_of(parts, [](const AssemblyPart& part) { return part.move != Point3(0.0); });
  if (any) return;
  throw Error(
      fmt::format("--explode {}: the parts have one middle: expected an axis, such as --explode z",
                  explosion.word));
}

}  // namespace

void move_apart(std::vector<AssemblyPart>& parts, const Explosion& explosion) {
  if (!explosion.axis) return move_radially(parts, explosion);
  move_along(parts, *explosion.axis, explosion);
}

void append_dash_dots(const Point3& from, const Point3& to, double period,
                      std::vector<std::pair<Point3, Point3>>& pieces) {
  constexpr double kDash = 0.58, kGap = 0.15, kDot = 0.12;  // of the period; two gaps
  const double length = glm::distance(from, to);
  if (!(length > period * kDash)) {
    if (length > 0.0) pieces.emplace_back(from, to);
    return;
  }
  // An integral number of periods and one more dash.
  const double periods = std::max(1.0, std::round(length / period - kDash));
  const double unit = 1.0 / (periods + kDash);
  const auto at = [&](double t) { return glm::mix(from, to, std::min(t * unit, 1.0)); };
  for (int k = 0; k <= static_cast<int>(periods); ++k) {
    pieces.emplace_back(at(k), at(k + kDash));
    if (k == static_cast<int>(periods)) break;
    pieces.emplace_back(at(k + kDash + kGap), at(k + kDash + kGap + kDot));
  }
}

namespace {

/// The part of each segment that is opened; kNoPart for those that show nothing.
constexpr std::size_t kNoPart = static_cast<std::size_t>(-1);

std::string name_of(const AssembledInputs& assembly, const RetainedScene::Segment& segment) {
  const std::string& title = assembly.system.display_file().segment(segment.name).title();
  if (!title.empty()) return title;
  const std::string& object = assembly.opening(segment).object;
  return object.empty() ? fmt::format("{}", segment.name) : object;
}

/// Segments with only annotation belong to the part that has their title as its name.
void join_annotation_by_title(const AssembledInputs& assembly, std::span<const AssemblyPart> parts,
                              std::vector<std::size_t>& part_of_opening) {
  for (const RetainedScene::Segment& segment : assembly.scene.segments()) {
    std::size_t& part = part_of_opening[segment.opened];
    if (part != kNoPart || segment.annotations.empty()) continue;
    const std::string& title = assembly.system.display_file().segment(segment.name).title();
    const auto found = std::ranges::find(parts, title, &AssemblyPart::name);
    if (found != parts.end()) part = static_cast<std::size_t>(found - parts.begin());
  }
}

std::vector<std::size_t> parts_of(const AssembledInputs& assembly,
                                  std::span<const std::string> inputs,
                                  std::vector<AssemblyPart>& parts) {
  std::vector<std::size_t> visible;  // segments of the scene
  const auto& segments = assembly.scene.segments();
  for (std::size_t k = 0; k < segments.size(); ++k) {
    if (assembly.is_visible(segments[k]) && !assembly.scene.points(segments[k]).empty())
      visible.push_back(k);
  }
  const auto input_of = [&](std::size_t k) { return assembly.opening(segments[k]).input; };
  const bool of_inputs = std::ranges::any_of(
      visible, [&](std::size_t k) { return input_of(k) != input_of(visible.front()); });
  std::vector<std::size_t> part_of_opening(assembly.openings.size(), kNoPart);
  std::map<std::size_t, std::size_t> known;  // parts, by input or segment
  for (const std::size_t k : visible) {
    const auto [part, is_new] = known.emplace(of_inputs ? input_of(k) : k, parts.size());
    const auto points = assembly.scene.points(segments[k]);
    if (is_new) {
      parts.push_back({points.front(), points.front()});
      parts.back().name = of_inputs ? std::filesystem::path(inputs[input_of(k)]).stem().string()
                                    : name_of(assembly, segments[k]);
    }
    AssemblyPart& box = parts[part->second];
    box.points += points.size();
    for (const Point3& p : points) {
      box.low = glm::min(box.low, p);
      box.high = glm::max(box.high, p);
    }
    part_of_opening[segments[k].opened] = part->second;
  }
  join_annotation_by_title(assembly, parts, part_of_opening);
  return part_of_opening;
}

/// A line for each part that moved against the one before it, through its middle.
std::vector<std::pair<Point3, Point3>> traces_of(std::span<const AssemblyPart> parts) {
  Point3 low = parts.front().low, high = parts.front().high;
  for (const AssemblyPart& part : parts) {
    low = glm::min(low, part.low + part.move);
    high = glm::max(high, part.high + part.move);
  }
  constexpr double kPeriods = 30.0;  // across all parts
  const double period = glm::length(high - low) / kPeriods;
  std::vector<std::pair<Point3, Point3>> pieces;
  for (const AssemblyPart& part : parts) {
    append_dash_dots(middle_of(part) + part.neighbour, middle_of(part) + part.move, period, pieces);
  }
  return pieces;
}

}  // namespace

namespace {

/// The names of segments that were whole in their view and are clipped after the moves. With meshes
/// and no window set, the view is fitted to the moved parts.
std::vector<int> cut_off_by_moves(const AssembledInputs& assembly,
                                  std::span<const std::string> inputs,
                                  std::span<const Point3> places) {
  const bool is_fitted = !std::ranges::all_of(inputs, is_drawing_program) &&
                         !assembly.system.explicit_settings().contains(Setting::window);
  if (is_fitted) return {};
  std::vector<int> names;
  for (const RetainedScene::Segment& segment : assembly.scene.segments()) {
    const Point3& move = places[segment.opened];
    if (move == Point3(0.0)) continue;
    const ViewVolume volume(segment.view);
    bool was_whole = true, is_whole = true;
    for (const Point3& p : assembly.scene.points(segment)) {
      was_whole = was_whole && volume.outcode(volume.transform(p)) == 0;
      is_whole = is_whole && volume.outcode(volume.transform(p + move)) == 0;
    }
    if (was_whole && !is_whole) names.push_back(segment.name);
  }
  return names;
}

/// Annotation of a segment without polygons and lines does not move, and would point at nothing.
void warn_of_annotation_without_part(const AssembledInputs& assembly,
                                     std::span<const std::string> inputs,
                                     std::span<const std::size_t> part_of_opening,
                                     const std::string& word) {
  for (const RetainedScene::Segment& segment : assembly.scene.segments()) {
    if (part_of_opening[segment.opened] != kNoPart || !assembly.is_visible(segment)) continue;
    const bool has_anchors = std::ranges::any_of(
        segment.annotations,
        [](const KeptAnnotation& annotation) { return annotation.anchors() > 0; });
    if (!has_anchors) continue;
    warnings() << fmt::format(
        "{}: --explode {}: annotation of segment {} stays where it is: expected it in the segment "
        "of its part, or the part's name as the segment's title\n",
        inputs[assembly.opening(segment).input], word, segment.name);
  }
}

}  // namespace

ExplodedParts exploded_parts(std::span<const std::string> inputs, const Explosion& explosion,
                             const ImportLimits& limits, double aspect) {
  if (std::ranges::find(inputs, "-") != inputs.end()) {
    throw Error(
        fmt::format("--explode {}: standard input can be read once only, and its parts are looked "
                    "for before it is drawn: expected a file",
                    explosion.word));
  }
  std::ostringstream warned_when_they_are_drawn;
  std::optional<CollectedWarnings> collected(std::in_place, warned_when_they_are_drawn);
  const AssembledInputs assembly(inputs, limits, aspect);
  collected.reset();
  std::vector<AssemblyPart> parts;
  const std::vector<std::size_t> part_of_opening = parts_of(assembly, inputs, parts);
  if (parts.size() < 2) {
    throw Error(
        fmt::format("--explode {}: {}{} {}: expected several inputs, or one of several segments or "
                    "objects",
                    explosion.word, inputs.front(), inputs.size() > 1 ? " and others" : "",
                    inputs.size() > 1 ? (parts.empty() ? "have no part" : "are one part")
                    : parts.empty()   ? "has no part"
                                      : "is one part"));
  }
  move_apart(parts, explosion);
  warn_of_annotation_without_part(assembly, inputs, part_of_opening, explosion.word);
  ExplodedParts exploded;
  for (const std::size_t part : part_of_opening) {
    exploded.places.push_back(part == kNoPart ? Point3(0.0) : parts[part].move);
  }
  exploded.traces = traces_of(parts);
  exploded.cut_off = cut_off_by_moves(assembly, inputs, exploded.places);
  return exploded;
}

}  // namespace displayfile
