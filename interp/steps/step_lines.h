#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hidden/lines/line_against_polygon.h"
#include "hidden/lines/line_table.h"
#include "hidden/lines/visible_pieces.h"
#include "interp/steps/step_items.h"
#include "interp/steps/step_record.h"

namespace displayfile {

/// The lines that a scene draws, in the form that methods of lines use, and shared parts of these
/// methods' steps.
class StepLines {
 public:
  using Line = LineTable::Line;

  StepLines(const StepItems& scene, StepRecord& record);
  StepLines(const StepLines&) = delete;
  StepLines& operator=(const StepLines&) = delete;

  const Primitives& items() const { return items_; }
  const LineTable& lines() const { return lines_; }
  std::span<const LineName> names() const { return names_; }
  /// The first line of that name, by its number.
  const Line& line_of(std::uint32_t name) const {
    return lines_.lines()[lines_.first_lines()[name]];
  }
  const ExactLines& policy() const { return policy_; }

  /// "side 2 of A", or "line B"; sides are numbered from 1, by the corners at which they end.
  std::string name(const Line& line) const;
  /// A point in the projection: an end, or a place between the ends as a fraction of the line.
  Point2 at(const Line& line, double share) const;
  void mark(StepRole role, const Line& line, const PartOfLine& part = {0.0, 1.0});

  /// The part of a line that one polygon covers, and the sides of the line on which it does.
  struct Covered {
    PartOfLine part;
    std::string_view sides;  ///< kBoth, kLeft or kRight
  };
  static constexpr std::string_view kBoth = "both sides", kLeft = "the left", kRight = "the right";
  std::vector<Covered> covered_by(std::uint32_t polygon, const Line& line);
  /// Records the covered parts, in a step at one of two lines of the listing, and adds to a table a
  /// row for each part: polygon, from, to, and the sides.
  struct CoveredLines {
    int misses, hides;
  };
  void tell_covered(std::uint32_t polygon, const Line& line, const CoveredLines& listing,
                    std::vector<StepRow>& hidden);

  /// Processes the lines in this order of the first line of each name: the finder records its
  /// steps, followed by a step, at that line of the listing, with the visible parts, which are
  /// added to the picture.
  template <class Finder>
  void find_all(std::span<const std::uint32_t> order, Finder& finder, int listing_line) {
    for (const std::uint32_t first : order) {
      std::vector<SeenPart> seen;
      find_seen(lines_.lines(), first, finder, seen);
      tell_seen(lines_.lines()[first], seen, listing_line);
    }
  }
  void tell_seen(const Line& line, std::span<const SeenPart> seen, int listing_line);

 private:
  StepRecord& record_;
  std::vector<std::uint8_t> drawn_;  // of the sides
  Primitives items_;
  std::vector<LineName> names_;
  LineTable lines_;
  ExactLines policy_;
};

/// "0.25 to 0.5", as fractions of a line.
std::string words_of(const PartOfLine& part);

}  // namespace displayfile
