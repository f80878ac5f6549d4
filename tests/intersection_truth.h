#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "displayfile/segments/display_file.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/lines/intersection_lines.h"
#include "hidden/lines/visible_lines.h"
#include "interp/truth/true_lines.h"

// Intersection lines, and their visible parts by each method, compared with their truth.

namespace displayfile::test {

/// Lines with their visible parts, as claims for the truth.
inline std::vector<TrueIntersection> claimed(const std::vector<IntersectionLine>& lines,
                                             const SeenLines& seen) {
  std::vector<TrueIntersection> all;
  for (const IntersectionLine& line : lines) {
    all.push_back({line.item_a, line.item_b, line.from.near, line.to.near, {}});
  }
  for (const auto& [line, from, to] : seen.intersections) all[line].visible.push_back({from, to});
  return all;
}

inline std::string text(const std::vector<TrueIntersection>& lines) {
  std::ostringstream out;
  out.precision(17);
  for (const TrueIntersection& line : lines) {
    out << line.item_a << " and " << line.item_b << ":";
    for (const Point3& p : {line.from, line.to})
      out << "  " << p.x + 0.0 << " " << p.y + 0.0 << " " << p.z + 0.0;
    for (const auto& [from, to] : line.visible) out << "  [" << from << ", " << to << "]";
    out << "\n";
  }
  return out.str();
}

/// Describes the errors in the intersection lines, and in the visible parts of them that each
/// method finds beside all other lines; empty if there are none: all are the truth's to the last
/// bit.
inline std::string wrong_intersections(const DisplayFile& file, int more_threads = 3) {
  const LineItems items(file);
  const ViewedScene scene(file);
  if (items.size() != scene.items()) return "other items";
  const std::string right = text(true_intersections(items));
  const std::vector<LineName> names = drawn_lines(scene.primitives());
  std::ostringstream wrong;
  for (int threads = 1; threads <= more_threads; threads += 2) {
    const std::vector<IntersectionLine> lines = intersection_lines(scene.primitives(), threads);
    for (const HiddenMethod method :
         {HiddenMethod::roberts, HiddenMethod::appel, HiddenMethod::franklin}) {
      const SurfacePlan options{.threads = threads};
      const SeenLines seen = visible_lines(scene.primitives(), names, options.by(method), lines);
      const std::string found = text(claimed(lines, seen));
      if (found != right) {
        wrong << name_of(method) << " on " << threads << " threads:\n"
              << found << "and not\n"
              << right;
      }
      if (seen.pieces != visible_lines(scene.primitives(), names, options.by(method)).pieces) {
        wrong << name_of(method) << ": other lines change\n";
      }
    }
  }
  return wrong.str();
}

}  // namespace displayfile::test
