#include "interp/steps/step_lines.h"

#include <fmt/format.h>

#include "hidden/lines/line_ends.h"

namespace displayfile {

namespace {

Primitives with_drawn(Primitives items, const std::vector<std::uint8_t>& drawn) {
  items.visible = drawn;
  return items;
}

}  // namespace

StepLines::StepLines(const StepItems& scene, StepRecord& record)
    : record_(record),
      drawn_(scene.viewed().drawn_sides()),
      items_(with_drawn(scene.viewed().primitives(), drawn_)),
      names_(drawn_lines(items_)),
      lines_(items_, names_, 1),
      policy_(Definitions{items_.points, {}}) {}

std::string StepLines::name(const Line& line) const {
  const auto [item, corner] = lines_.name(line.name);
  if (items_.items[item].kind == Primitives::Kind::line) {
    return fmt::format("line {}", record_.name(item));
  }
  return fmt::format("side {} of {}", corner + 1, record_.name(item));
}

Point2 StepLines::at(const Line& line, double share) const {
  return flat(LineEnds(items_, lines_.name(line.name)).at(share));
}

void StepLines::mark(StepRole role, const Line& line, const PartOfLine& part) {
  record_.mark(role, {at(line, part.from), at(line, part.to)}, StepMark::Kind::line);
}

std::vector<StepLines::Covered> StepLines::covered_by(std::uint32_t polygon, const Line& line) {
  struct Parts {
    std::vector<Covered> all;
    void add_both(const PartOfLine& part) { all.push_back({part, kBoth}); }
    void add_left(const PartOfLine& part) { all.push_back({part, kLeft}); }
    void add_right(const PartOfLine& part) { all.push_back({part, kRight}); }
  } parts;
  LineAgainstPolygon<ExactLines> against(lines_, policy_);
  against.look_at(line);
  against.hide(polygon, parts);
  return parts.all;
}

void StepLines::tell_covered(std::uint32_t polygon, const Line& line, const CoveredLines& listing,
                             std::vector<StepRow>& hidden) {
  const auto covered = covered_by(polygon, line);
  const std::string of = record_.name(polygon);
  if (covered.empty()) {
    record_.step(listing.misses, fmt::format("{} hides no part of the line.", of));
    record_.mark(StepRole::back, polygon);
    return;
  }
  std::string parts;
  for (const auto& [part, sides] : covered) {
    parts += fmt::format("{}{}, on {} of it", parts.empty() ? "" : "; ", words_of(part), sides);
    hidden.push_back(
        {{of, fmt::format("{:.3g}", part.from), fmt::format("{:.3g}", part.to), std::string(sides)},
         polygon});
  }
  record_.step(listing.hides, fmt::format("{} is before the line from {}.", of, parts));
  record_.mark(StepRole::front, polygon);
  for (const auto& [part, sides] : covered) mark(StepRole::hidden, line, part);
}

void StepLines::tell_seen(const Line& line, std::span<const SeenPart> seen, int listing_line) {
  const LineName named = lines_.name(line.name);
  const std::string of = name(line);
  const bool whole = seen.size() == 1 && seen[0].part.from == 0.0 && seen[0].part.to == 1.0;
  std::string parts;
  for (const SeenPart& s : seen) parts += (parts.empty() ? "" : ", ") + words_of(s.part);
  Step& step = record_.step(
      listing_line, seen.empty() ? fmt::format("All of {} is hidden.", of)
                    : whole
                        ? fmt::format("Nothing hides any of {}: it is drawn.", of)
                        : fmt::format("Of {} what is left is drawn: {} of its length.", of, parts));
  const auto add = [&](const PartOfLine& part, bool hidden) {
    if (part.from >= part.to) return;
    step.lines.push_back({named.item, named.corner, part.from, part.to, at(line, part.from),
                          at(line, part.to), hidden});
  };
  double from = 0.0;
  for (const SeenPart& s : seen) {
    add({from, s.part.from}, true);
    add(s.part, false);
    from = s.part.to;
  }
  add({from, 1.0}, true);
  for (const SeenPart& s : seen) mark(StepRole::seen, line, s.part);
}

std::string words_of(const PartOfLine& part) {
  return fmt::format("{:.3g} to {:.3g}", part.from, part.to);
}

}  // namespace displayfile
