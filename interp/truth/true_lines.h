#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/base/work_progress.h"
#include "interp/truth/line_items.h"

namespace displayfile {

// The visible parts of a picture's lines, by the definition of truth alone: in integers of any
// length, without tolerance, and sharing no code with the methods that are checked.
// interp/truth/true_lines.md has the details. Lengths are in device coordinates, whose unit is the
// picture.

/// A part of a line between two parameters along its projection, 0 <= from < to <= 1: 0 is its
/// start, 1 its end.
struct LinePiece {
  LineId line;
  double from, to;
  bool operator==(const LinePiece&) const = default;
};

/// A visible piece shorter than this may be omitted, a hidden one drawn; in units of the picture.
inline constexpr double kLineCrumb = 1e-9;

/// A line, which polygons may share, and its visible parts.
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

/// The visible parts of the given lines: for each with a length in the projection, together with
/// all that share it, given or not, in order of the first sharer. Each is computed once. Exact; for
/// small scenes and, slowly, for large ones: progress counts lines. Throws Error for an invalid
/// line.
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

/// All intersection lines, in order of item_b, item_a, and position along the line, with the
/// visible parts of each: of the exact line, not of the one between the rounded ends. Every pair is
/// examined.
std::vector<TrueIntersection> true_intersections(const LineItems& items, int threads = 1);

/// The visible parts, named for the lines' first sharers, in order.
std::vector<LinePiece> visible_pieces(std::span<const TrueLine> lines);

/// Errors of pieces claimed to be the visible parts of lines.
struct LineErrors {
  double missing = 0.0;  ///< length that should be visible, but has no piece
  double extra = 0.0;    ///< length that should be hidden
  double length = 0.0;   ///< of all lines
};

/// Compares claimed pieces with the truth. A piece may be named for any sharer of its line, in that
/// one's direction; pieces of one line are combined. Wrong parts shorter than kLineCrumb, or than
/// the rounding of ends, 2^-52 of the line, are ignored. A piece of a line that is not among the
/// true ones is extra. Throws Error for a piece of an invalid line, or not with 0 <= from < to <=
/// 1.
LineErrors compare_lines(const LineItems& items, std::span<const TrueLine> truth,
                         std::span<const LinePiece> claimed);

/// A place on a line where a claim is wrong.
struct WrongSample {
  LineId line;   ///< the first sharer
  double at;     ///< along it
  bool missing;  ///< it should be visible; otherwise it should be hidden
};

struct LineJudgement {
  std::size_t samples = 0;         ///< that were judged
  std::vector<WrongSample> wrong;  ///< in order of the lines, and of places on them
  LineErrors errors;               ///< the share of a line's samples that are wrong, of its length
};

/// Compares pieces as compare_lines does, by exact tests at points of the lines: `samples` on each,
/// one at a random place in each of that many equal parts, against all polygons that may cover it.
/// Places within kLineCrumb of an end of a piece, or on a part shorter than that, are ignored. For
/// large scenes: progress counts lines. The same seed gives the same places. Throws as both others
/// do.
LineJudgement judge_lines(const LineItems& items, std::span<const LineId> lines,
                          std::span<const LinePiece> claimed, std::size_t samples_of_line,
                          std::uint64_t seed, int threads = 1, const WorkProgress& progress = {});

}  // namespace displayfile
