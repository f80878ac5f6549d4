#pragma once

#include <optional>
#include <string>

#include "clip/error.h"
#include "interp/device/paper.h"

namespace displayfile {

/// How disjoint fills, which tile the picture, are written next to each other in vectors
/// (interp/vector/seams.md).
enum class Seams {
  trapped,  ///< none is seen: the earlier of two neighbours reaches under the later
  butted    ///< side to side, in a smaller file; where it is antialiased, what is behind shows
};

/// What is asked of disjoint fills in vectors.
struct VectorOptions {
  /// Vertices are rounded to multiples of so many pixels, kFinestPrecision to kCoarsestPrecision.
  double precision = 0.01;
  Seams seams = Seams::trapped;
  /// The picture as large as fits, on a sheet of this size; none: in pixels, or points.
  std::optional<Paper> paper = std::nullopt;
  bool crumbs = false;    ///< strokes are drawn that are shorter than they are wide, and join none
  bool pick_ids = false;  ///< each pick identifier is an element of its own, and named; of SVG

  static constexpr double kFinestPrecision = 0.001, kCoarsestPrecision = 1.0;
};

/// Throws Error for a precision out of its range.
inline void require_vector_options(const VectorOptions& options) {
  constexpr double kFinest = VectorOptions::kFinestPrecision;
  constexpr double kCoarsest = VectorOptions::kCoarsestPrecision;
  if (options.precision >= kFinest && options.precision <= kCoarsest) return;
  throw Error("precision of vectors " + std::to_string(options.precision) +
              ": expected 0.001 to 1 pixels");
}

}  // namespace displayfile
