#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/base/work_progress.h"
#include "interp/truth/line_items.h"

namespace displayfile {

// What is seen of the lines of a picture, by the definition of truth alone: whole numbers of any
// length, no tolerance, and nothing shared with the methods that are judged.
// interp/truth/true_lines.md explains. Lengths are in device coordinates, whose unit is the
// picture.

/// A part of a line between two parameters along its projection, 0 <= from < to <= 1: 0 is where it
/// starts, 1 where it ends.
struct LinePiece {
  LineId line;
  double from, to;
  bool operator==(const LinePiece&) const = default;
};

/// A visible piece that is shorter than this may be left out, a hidden one drawn; of the picture.
inline constexpr double kLineCrumb = 1e-9;

/// One line, which polygons may share, and what is seen of it.
struct TrueLine {
  std::vector<LineId> sharers;  ///< in order; the first names the line, and gives its direction
  double length;                ///< of the projection
  struct Part {
    double from, to;
    bool operator==(const Part&) const = default;
  };
  /// In order, disjoint, along the first sharer; exact ends, each rounded once to the nearest
  /// double. A part whose ends are the same double is left out.
  std::vector<Part> visible;
};

/// What is seen of the given lines: of each that has a length in the projection, together with all
/// that share it, whether given or not, in order of the first sharer. Each is looked at once.
/// Exact; for small scenes and, with patience, for large ones: progress is told of lines. Throws
/// Error for a line that there is not.
std::vector<TrueLine> true_lines(const LineItems& items, std::span<const LineId> lines,
                                 int threads = 1, const WorkProgress& progress = {});

/// A part of a line along which two solid polygons pass through each other: where their support
/// planes have the same depth, and both cover the points close to the line on either side.
struct TrueIntersection {
  std::uint32_t item_a, item_b;  ///< a was entered before b
  /// The end that is lower by x, then y, and the other; each coordinate rounded once to the nearest
  /// double. Different in the projection.
  Point3 from, to;
  std::vector<TrueLine::Part> visible;  ///< as those of a TrueLine, from `from`
};

/// All there are, in order of item_b, item_a, and of places along the line; and what is seen of
/// each: of the exact line, not of the one between the rounded ends. Every pair is looked at.
std::vector<TrueIntersection> true_intersections(const LineItems& items, int threads = 1);

/// The parts that are seen, named for the lines' first sharers, in order.
std::vector<LinePiece> visible_pieces(std::span<const TrueLine> lines);

/// How wrong pieces are that claim to be what is seen of lines.
struct LineErrors {
  double missing = 0.0;  ///< length that should be seen, but no piece is there
  double extra = 0.0;    ///< length that should not be seen
  double length = 0.0;   ///< of all lines
};

/// What pieces say is seen against what is. A piece may be named for any sharer of its line, in
/// that one's direction; pieces of one line count together. Wrong parts shorter than kLineCrumb, or
/// than the rounding of ends, 2^-52 of the line, are forgiven. A piece of a line that is not among
/// the true ones is extra. Throws Error for a piece of a line that there is not, or not of 0 <=
/// from < to <= 1.
LineErrors compare_lines(const LineItems& items, std::span<const TrueLine> truth,
                         std::span<const LinePiece> claimed);

/// A place on a line where a claim is wrong.
struct WrongSample {
  LineId line;   ///< the first sharer
  double at;     ///< along it
  bool missing;  ///< it should be seen; if not, it should not
};

struct LineJudgement {
  std::size_t samples = 0;         ///< that were judged
  std::vector<WrongSample> wrong;  ///< in order of the lines, and of places on them
  LineErrors errors;               ///< the share of a line's samples that are wrong, of its length
};

/// Judges pieces as compare_lines does, by exact judgement of points of the lines: so many on each,
/// one at a random place in each of as many equal parts, by all polygons that may cover it. Places
/// closer than kLineCrumb to an end of a piece do not count, nor do those on a part that is
/// shorter. For large scenes: progress is told of lines. The same seed gives the same places.
/// Throws as both others do.
LineJudgement judge_lines(const LineItems& items, std::span<const LineId> lines,
                          std::span<const LinePiece> claimed, std::size_t samples_of_line,
                          std::uint64_t seed, int threads = 1, const WorkProgress& progress = {});

}  // namespace displayfile
