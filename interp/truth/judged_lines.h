#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "clip/base/work_progress.h"
#include "clip/surfaces.h"
#include "displayfile/segments/display_file.h"
#include "hidden/lines/visible_lines.h"
#include "interp/truth/true_lines.h"

namespace displayfile {

// The lines of a display file as a method finds them, and the true ones: both share only the
// display file. Visible segments are taken together, as with scope `all`.

/// A method's visible parts of the drawn lines, compared with the truth.
struct JudgedLines {
  std::size_t lines = 0;    ///< that are drawn, by the truth; a shared side is one
  std::size_t pieces = 0;   ///< that the method found
  std::size_t samples = 0;  ///< places that were judged, if not whole sets
  std::size_t wrong = 0;    ///< of these
  LineErrors errors;        ///< in units of the picture

  bool are_right() const { return wrong == 0 && errors.missing == 0.0 && errors.extra == 0.0; }
};

/// Judges the output of the plan's method, with as many threads; its progress is called with the
/// number of lines judged. At least `samples` random places, if not 0, are judged instead of whole
/// sets: for large scenes. Throws Error as visible_lines does.
JudgedLines judged_lines(const DisplayFile& display_file, const SurfacePlan& plan,
                         std::size_t samples = 0);

/// A method's visible parts, in the form of the truth.
std::vector<LinePiece> claimed_pieces(const SeenLines& seen);

/// The display file with the visible lines as its order, found by the truth alone: its dump is that
/// of a drawing by a correct method of lines. As with the methods, a shared side is named for the
/// first polygon that draws it; where that one runs opposite to the first that has it, drawn or
/// not, the ends are exchanged in doubles.
DisplayFile true_line_drawing(const DisplayFile& display_file, int threads = 1,
                              const WorkProgress& progress = {});

}  // namespace displayfile
