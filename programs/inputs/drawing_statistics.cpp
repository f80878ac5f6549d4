#include "programs/inputs/drawing_statistics.h"

#include <fmt/format.h>

#include <cstddef>
#include <set>
#include <vector>

#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/segments/viewed_scene.h"
#include "displayfile/text/characters.h"
#include "hidden/exact/predicate_counts.h"
#include "interp/text/seen_texts.h"
#include "interp/visibility/image_space.h"

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
  return text.empty() ? "exact stage        not used\n" : text;
}

/// The cost of sorting hidden surfaces, or the visible share of lines; nothing if none were sorted.
std::string sort_counts(const DisplayFile& file, HiddenMethod method,
                        std::size_t polygons_and_lines) {
  const SortCounts counts = counts_of_sorts(file);
  if (counts.pieces == 0) return "";
  if (finds_lines(method)) return fmt::format("lines seen         {} pieces\n", counts.pieces);
  return fmt::format(
      "pieces             {} ({:.4f} a polygon or line)\n"
      "cuts               {}\n"
      "comparisons        {}\n"
      "depth of the tree  {}\n",
      counts.pieces, static_cast<double>(counts.pieces) / static_cast<double>(polygons_and_lines),
      counts.cuts, counts.comparisons, counts.depth);
}

/// Counts the strokes that a picture leaves out.
class CrumbCounter {
 public:
  explicit CrumbCounter(const Point2& pixels) : pixels_(pixels) {}
  std::size_t count() const { return count_; }

  bool is_crumb(const Point3& from, const Point3& to) const {
    const bool is_one = is_shorter_than_wide(Point2(from), Point2(to), pixels_, style_.width);
    count_ += is_one ? 1 : 0;
    return is_one;
  }
  void fill(const FillStyle&) {}
  void line_style(const LineStyle& style) { style_ = style; }
  void pick(std::int32_t) {}
  void move(const Point3&) {}
  void line(const Point3&) {}
  void polygon(std::span<const Point3>, std::span<const std::int32_t>) {}

 private:
  Point2 pixels_;
  LineStyle style_;
  mutable std::size_t count_ = 0;
};

/// Nothing where none are left out.
std::string crumb_counts(const DisplayFile& file, const DrawOptions& options) {
  if (options.crumbs) return "";
  CrumbCounter counter(Point2(options.width, options.height));
  if (file.sorted() != nullptr) {
    file.sorted()->walk(counter);
  } else {
    for (const Segment& segment : file.segments()) {
      if (segment.visible && segment.sorted() != nullptr) segment.walk_drawn(counter);
    }
  }
  if (counter.count() == 0) return "";
  return fmt::format("crumbs left out    {}\n", counter.count());
}

/// The number of polygons that lie in planes shared by others, as they were entered.
std::string touching_counts(const DisplayFile& file) {
  const ViewedScene scene(file);
  std::size_t polygons = 0;
  std::set<Primitives::PlanePoints> shared;
  for (const Primitives::PlanePoints& plane : scene.planes()) {
    if (plane[0] == Primitives::kOwnPlane) continue;
    ++polygons;
    shared.insert(plane);
  }
  return fmt::format("touching           {} polygons, in {} plane{}\n", polygons, shared.size(),
                     shared.size() == 1 ? "" : "s");
}

/// The texts within the view volume, and which of them surfaces hide; nothing if there are none.
std::string text_counts(const DisplayFile& file, HiddenMethod method) {
  if (!file.has_texts()) return "";
  const ViewedScene scene(file);
  const std::vector<DeviceText> seen = seen_texts(file, is_image_space(method));
  std::string hidden;
  auto next = seen.begin();  // both are in order of entry
  for (const DeviceText& text : scene.texts()) {
    const bool is_next = next != seen.end() && next->anchor == text.anchor &&
                         next->characters == text.characters && next->segment == text.segment;
    if (is_next) {
      ++next;
    } else {
      hidden += (hidden.empty() ? "" : ", ") + in_quotation_marks(text.characters);
    }
  }
  return fmt::format("texts stored       {} ({} hidden{}{})\n", scene.texts().size(),
                     scene.texts().size() - seen.size(), hidden.empty() ? "" : ": ", hidden);
}

/// The annotation within the view volume; nothing if there is none.
std::string annotation_counts(const DisplayFile& file) {
  std::size_t stored = 0;
  for (const Segment* const segment : file.visible_segments()) {
    stored += segment->entered()->annotations().size();
  }
  return stored == 0 ? "" : fmt::format("annotation stored  {}\n", stored);
}

}  // namespace

std::string drawing_statistics(const GraphicsSystem& system, const DisplayFile& file,
                               const PicturePlan& plan) {
  std::size_t lines = 0, visible = 0, drawn = 0;
  for (const Segment& segment : file.segments()) {
    lines += segment.lines();
    visible += segment.visible ? 1 : 0;
    drawn += segment.visible ? segment.polygons() + segment.lines() : 0;
  }
  const std::size_t polygons = file.polygons();
  const DrawOptions& options = plan.options;
  const HiddenMethod method = plan.choice.method;
  std::string text = fmt::format(
      "segments           {} ({} visible)\n"
      "polygons entered   {} ({} not flat, triangulated)\n"
      "polygons stored    {}\n"
      "lines stored       {}\n"
      "{}"
      "{}"
      "display file       {} bytes ({:.1f} a polygon)\n"
      "picture            {} x {}, hidden surfaces by {}\n",
      file.segments().size(), visible, system.counts().polygons, system.counts().triangulated,
      polygons, lines, touching_counts(file), text_counts(file, method) + annotation_counts(file),
      file.bytes(),
      polygons == 0 ? 0.0 : static_cast<double>(file.bytes()) / static_cast<double>(polygons),
      options.width, options.height, name_of(method));
  return text + sort_counts(file, method, drawn) + crumb_counts(file, options) +
         exact_stage_counts();
}

std::string times_of_drawing(double entering, double drawing) {
  return fmt::format("times              {:.3f} s to read and enter, {:.3f} s to draw and write\n",
                     entering, drawing);
}

std::string explanation_of_method(const PicturePlan& plan) {
  const bool is_set = plan.surfaces.method != HiddenMethod::automatic;
  return fmt::format("{}{}: {}\n", is_set ? "" : "auto: ", name_of(plan.choice.method),
                     plan.choice.reason);
}

}  // namespace displayfile
