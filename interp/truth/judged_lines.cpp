#include "interp/truth/judged_lines.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <tuple>
#include <utility>

#include "displayfile/segments/scene_lines.h"
#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/segments/sorted_scene.h"
#include "displayfile/segments/viewed_scene.h"

namespace displayfile {

namespace {

SeenLines lines_by(const DisplayFile& display_file, SurfacePlan plan) {
  plan.progress = {};  // that of the judgement
  return find_lines(ViewedScene(display_file), plan).seen;
}

}  // namespace

std::vector<LinePiece> claimed_pieces(const SeenLines& seen) {
  std::vector<LinePiece> pieces;
  pieces.reserve(seen.pieces.size());
  for (const VisiblePiece& piece : seen.pieces) {
    pieces.push_back({{piece.item, piece.corner}, piece.from, piece.to});
  }
  return pieces;
}

JudgedLines judged_lines(const DisplayFile& display_file, const SurfacePlan& plan,
                         std::size_t samples) {
  const std::vector<LinePiece> pieces = claimed_pieces(lines_by(display_file, plan));
  const LineItems items(display_file);
  const std::vector<LineId> lines = items.drawn_lines();
  JudgedLines judged;
  judged.pieces = pieces.size();
  judged.lines = items.shared(lines).size();
  if (samples == 0) {
    const auto truth = true_lines(items, lines, plan.threads, plan.progress);
    judged.errors = compare_lines(items, truth, pieces);
    return judged;
  }
  const std::size_t of_line = samples / std::max<std::size_t>(1, judged.lines) + 1;
  const LineJudgement judgement =
      judge_lines(items, lines, pieces, of_line, 1, plan.threads, plan.progress);
  judged.samples = judgement.samples;
  judged.wrong = judgement.wrong.size();
  judged.errors = judgement.errors;
  return judged;
}

// ---- The truth as a drawing ----------------------------------------------------------------

namespace {

/// The truth's pieces, each named for the first sharer that is drawn; in order of these names.
std::vector<VisiblePiece> pieces_as_drawn(const LineItems& items, int threads,
                                          const WorkProgress& progress) {
  const std::vector<LineId> drawn = items.drawn_lines();
  std::vector<VisiblePiece> pieces;
  for (const TrueLine& line : true_lines(items, drawn, threads, progress)) {
    const LineId name = *std::ranges::find_if(
        line.sharers, [&](LineId sharer) { return std::ranges::binary_search(drawn, sharer); });
    const bool turned = items.from(name) != items.from(line.sharers.front());
    for (const auto& [from, to] : line.visible) {
      pieces.push_back(
          {name.item, name.corner, turned ? 1.0 - to : from, turned ? 1.0 - from : to});
    }
  }
  std::ranges::sort(pieces, [](const VisiblePiece& a, const VisiblePiece& b) {
    return std::tie(a.item, a.corner, a.from) < std::tie(b.item, b.corner, b.from);
  });
  return pieces;
}

/// The range of each visible segment's items among those of the whole picture: they are
/// consecutive.
class ItemsOfSegments {
 public:
  explicit ItemsOfSegments(const DisplayFile& display_file) {
    for (const Segment* segment : display_file.visible_segments()) {
      const std::uint32_t begin = ranges_.empty() ? 0 : ranges_.back().end;
      const auto items = ViewedScene(std::span(&segment, 1)).items();
      ranges_.push_back({segment, begin, begin + static_cast<std::uint32_t>(items)});
    }
  }

  /// The pieces of a group's segments, with the items' numbers in a scene of the group.
  SeenLines of_group(const SegmentGroup& group, std::span<const VisiblePiece> pieces) const {
    SeenLines found;
    std::uint32_t before = 0;
    for (const Segment* segment : group) {
      const Range& range = *std::ranges::find(ranges_, segment, &Range::segment);
      const auto of_item = [](const VisiblePiece& piece) { return piece.item; };
      const auto first = std::ranges::lower_bound(pieces, range.begin, {}, of_item);
      const auto last = std::ranges::lower_bound(pieces, range.end, {}, of_item);
      for (auto piece = first; piece != last; ++piece) {
        found.pieces.push_back(*piece);
        found.pieces.back().item += before - range.begin;
      }
      before += range.end - range.begin;
    }
    return found;
  }

 private:
  struct Range {
    const Segment* segment;
    std::uint32_t begin, end;
  };
  std::vector<Range> ranges_;
};

}  // namespace

DisplayFile true_line_drawing(const DisplayFile& display_file, int threads,
                              const WorkProgress& progress) {
  const auto pieces = pieces_as_drawn(LineItems(display_file), threads, progress);
  const ItemsOfSegments items(display_file);
  auto sorted = std::make_shared<SortedScene>();
  for (const SegmentGroup& group : overlapping_groups(display_file.visible_segments())) {
    auto scene = std::make_shared<ViewedScene>(group);
    const FoundLines true_lines{lines_to_draw(*scene), {}, items.of_group(group, pieces)};
    SortedPieces order = lines_in_order(*scene, true_lines, HiddenLines::none);
    sorted->counts.pieces += order.pieces.size();
    auto ordered = std::make_shared<OrderedScene>();
    ordered->scene = std::move(scene);
    ordered->pieces = std::move(order);
    sorted->parts.push_back(std::move(ordered));
  }
  DisplayFile drawing = display_file;
  drawing.set_sorted(std::move(sorted));
  return drawing;
}

}  // namespace displayfile
