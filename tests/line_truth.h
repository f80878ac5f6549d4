#pragma once

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "displayfile/segments/display_file.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/lines/visible_lines.h"
#include "interp/truth/judged_lines.h"
#include "tests/sort_scenes.h"

// The results of line methods compared with their truth, which shares no code with them.

namespace displayfile::test {

/// Describes the errors of each method's pieces of all lines, drawn or not; empty if there are
/// none: the pieces are the truth's to the last bit, since both round the end of a piece once. Also
/// on `more_threads` threads.
inline std::string wrong_lines(const DisplayFile& file, int more_threads = 3) {
  const LineItems items(file);
  const ViewedScene scene(file);
  if (items.size() != scene.items()) return "other items";
  const std::vector<TrueLine> truth = true_lines(items, items.all_lines());
  std::vector<LineName> names;  // one of those that share a line
  for (const TrueLine& line : truth) {
    names.push_back({line.sharers.front().item, line.sharers.front().corner});
  }
  const std::vector<LinePiece> right = visible_pieces(truth);
  std::ostringstream wrong;
  for (const HiddenMethod method :
       {HiddenMethod::roberts, HiddenMethod::appel, HiddenMethod::franklin}) {
    for (int threads = 1; threads <= more_threads; threads += 2) {
      const std::vector<LinePiece> pieces = claimed_pieces(
          visible_lines(scene.primitives(), names, {.method = method, .threads = threads}));
      const LineErrors errors = compare_lines(items, truth, pieces);
      if (pieces == right && errors.missing == 0.0 && errors.extra == 0.0) continue;
      wrong << name_of(method) << " on " << threads << " threads: missing " << errors.missing
            << ", extra " << errors.extra << ", " << pieces.size() << " pieces of " << right.size()
            << "\n";
    }
  }
  return wrong.str();
}

/// The items in one segment.
inline DisplayFile entered(const ItemList& list) {
  DisplayFile file;
  Segment& segment = file.create(1);
  segment.set_style(LineStyle{});
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const auto points = list.points_of(i);
    if (list.items[i].kind == ItemList::Kind::line) {
      segment.enter_line(points[0], points[1]);
      continue;
    }
    const bool hollow = list.items[i].kind == ItemList::Kind::hollow;
    segment.set_style(hollow ? FillStyle{FillStyle::Kind::hollow} : FillStyle{});
    segment.enter_polygon(points, list.visible_of(i));
  }
  return file;
}

}  // namespace displayfile::test
