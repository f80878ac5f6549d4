#include "programs/drawing_statistics.h"

#include <fmt/format.h>

#include <cstddef>

#include "hidden/exact/predicate_counts.h"
#include "interp/visibility/auto_method.h"

namespace displayfile {

namespace {

/// How often the predicates' filters were undecided.
std::string exact_stage_counts() {
  std::string text;
  const PredicateCounts counts = predicate_counts();
  for (std::size_t i = 0; i < kPredicates; ++i) {
    const StageCounts& count = counts[i];
    if (count.exact + count.by_definition == 0) continue;
    text += fmt::format("exact stage        {}: {} times, and {} zero by definition\n",
                        name_of(static_cast<Predicate>(i)), count.exact, count.by_definition);
  }
  return text.empty() ? "exact stage        never asked\n" : text;
}

/// What sorting the hidden surfaces cost; nothing if none were sorted.
std::string sort_counts(const DisplayFile& file, std::size_t polygons_and_lines) {
  const SortCounts counts = counts_of_sorts(file);
  if (counts.pieces == 0) return "";
  return fmt::format(
      "pieces             {} ({:.4f} a polygon or line)\n"
      "cuts               {}\n"
      "comparisons        {}\n"
      "depth of the tree  {}\n",
      counts.pieces, static_cast<double>(counts.pieces) / static_cast<double>(polygons_and_lines),
      counts.cuts, counts.comparisons, counts.depth);
}

}  // namespace

std::string drawing_statistics(const GraphicsSystem& system, const DisplayFile& file,
                               const DrawOptions& options, PictureKind kind) {
  std::size_t lines = 0, visible = 0, drawn = 0;
  for (const Segment& segment : file.segments()) {
    lines += segment.lines();
    visible += segment.visible ? 1 : 0;
    drawn += segment.visible ? segment.polygons() + segment.lines() : 0;
  }
  const std::size_t polygons = file.polygons();
  std::string text = fmt::format(
      "segments           {} ({} visible)\n"
      "polygons entered   {} ({} not flat, triangulated)\n"
      "polygons stored    {}\n"
      "lines stored       {}\n"
      "display file       {} bytes ({:.1f} a polygon)\n"
      "picture            {} x {}, hidden surfaces by {}\n",
      file.segments().size(), visible, system.polygons_entered(), system.polygons_triangulated(),
      polygons, lines, file.bytes(),
      polygons == 0 ? 0.0 : static_cast<double>(file.bytes()) / static_cast<double>(polygons),
      options.width, options.height, name_of(drawing_method(system, options, kind)));
  return text + sort_counts(file, drawn) + exact_stage_counts();
}

std::string explanation_of_method(const GraphicsSystem& system, const DrawOptions& options,
                                  PictureKind kind) {
  const HiddenMethod method = method_in_force(system, hidden_surface_options(options));
  if (method != HiddenMethod::automatic) return fmt::format("{}: as asked for\n", name_of(method));
  const MethodChoice choice = choose_method(system.display_file(), kind);
  return fmt::format("auto: {}: {}\n", name_of(choice.method), choice.reason);
}

}  // namespace displayfile
