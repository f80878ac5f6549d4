// A build with neither GMP nor LibTomMath, and not for a web page: the truth has no integers of its
// own.

#include "clip/base/error.h"
#include "interp/truth/entered_truth.h"
#include "interp/truth/judged_lines.h"
#include "interp/truth/truth.h"
#include "interp/truth/world_truth.h"

namespace displayfile {

namespace {

[[noreturn]] void refuse_truth() {
  throw Error(
      "the truth needs GMP or LibTomMath, and this build was made without both: install one "
      "(Debian: libgmp-dev, libtommath-dev) and build again");
}

}  // namespace

Picture truth(const DisplayFile&, int, int, bool, const WorkProgress&, DepthTies*) {
  refuse_truth();
}

Picture world_truth(const RetainedScene&, const DisplayFile&, int, int, bool, const WorkProgress&) {
  refuse_truth();
}

EnteredTruth entered_truth(const RetainedScene&, const DisplayFile&, int, int, bool,
                           const std::optional<Touching>&, const WorkProgress&, DepthTies*) {
  refuse_truth();
}

Picture truth_as_entered(const DisplayFile&, int, int, bool, const WorkProgress&, DepthTies*) {
  refuse_truth();
}

std::size_t different_pixels(const Picture&, const Picture&) { refuse_truth(); }

JudgedLines judged_lines(const DisplayFile&, const SurfacePlan&, std::size_t) { refuse_truth(); }

std::vector<LinePiece> claimed_pieces(const SeenLines&) { refuse_truth(); }

DisplayFile true_line_drawing(const DisplayFile&, int, const WorkProgress&) { refuse_truth(); }

}  // namespace displayfile
