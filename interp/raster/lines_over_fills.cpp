#include "interp/raster/lines_over_fills.h"

#include <cstdint>
#include <span>
#include <utility>

namespace displayfile {

namespace {

bool same(const Precision& a, const Precision& b) {
  return a.exact == b.exact && (a.exact || a.roundoff == b.roundoff);
}

std::vector<VisiblePiece> visible_pieces_of(const ViewedScene& scene, const Precision& precision,
                                            int threads) {
  if (!scene.has_lines()) return {};
  const std::vector<std::uint8_t> drawn = scene.drawn_sides();
  Primitives outlined = scene.primitives();
  outlined.visible = drawn;
  return visible_lines(scene.primitives(), drawn_lines(outlined), HiddenMethod::franklin,
                       {.precision = precision, .threads = threads})
      .pieces;
}

bool is_sorted_in_order(const Segment& segment) {
  return segment.visible && segment.sorted() != nullptr && !finds_lines(segment.sorted()->method);
}

}  // namespace

void LinesOverFills::clear() {
  all_.reset();
  of_segments_.clear();
}

void LinesOverFills::take(const std::shared_ptr<const ViewedScene>& scene,
                          const Precision& precision, int threads) {
  of_segments_.clear();
  if (all_ && same(all_->precision, precision)) {
    all_->scene = scene;
    return;
  }
  all_.reset();  // unless it succeeds
  all_ = {scene, precision, visible_pieces_of(*scene, precision, threads)};
}

void LinesOverFills::take_sorted_segments(const DisplayFile& display_file, int threads) {
  all_.reset();
  auto before = std::exchange(of_segments_, {});
  for (const Segment& segment : display_file.segments()) {
    if (!is_sorted_in_order(segment)) continue;
    const auto kept = before.find(segment.name());
    const auto will_do = [&](const OfSegment& old) {
      return old.entered == segment.entered() && old.image == segment.image &&
             same(old.group.precision, segment.sorted()->precision);
    };
    of_segments_.emplace(segment.name(), kept != before.end() && will_do(kept->second)
                                             ? std::move(kept->second)
                                             : OfSegment{segment.entered(), segment.image,
                                                         group_of(segment, threads)});
  }
}

LinesOverFills::Group LinesOverFills::group_of(const Segment& segment, int threads) {
  const SortedScene& sorted = *segment.sorted();
  Group group{nullptr, sorted.precision, {}};
  if (segment.sorted_as_drawn() && sorted.parts.size() == 1) {
    group.scene = sorted.parts.front()->scene;
  } else {
    const Segment* const one = &segment;
    group.scene = std::make_shared<const ViewedScene>(std::span(&one, 1));
  }
  group.pieces = visible_pieces_of(*group.scene, group.precision, threads);
  return group;
}

const LinesOverFills::Group* LinesOverFills::of_segment(int name) const {
  const auto found = of_segments_.find(name);
  return found == of_segments_.end() ? nullptr : &found->second.group;
}

}  // namespace displayfile
