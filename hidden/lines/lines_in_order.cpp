#include "hidden/lines/lines_in_order.h"

#include "hidden/lines/chains.h"
#include "hidden/lines/hidden_pieces.h"
#include "hidden/lines/line_ends.h"
#include "hidden/lines/visible_lines.h"

namespace displayfile {

namespace {

/// Adds pieces in order of chains.
class ChainWriter {
 public:
  ChainWriter(const Primitives& items, std::span<const std::uint32_t> groups, SortedPieces& all)
      : items_(items), groups_(groups), all_(all) {}

  void add(std::span<const VisiblePiece> pieces) {
    links_.clear();
    links_.reserve(pieces.size());
    for (const VisiblePiece& piece : pieces) {
      const LineEnds ends(items_, {piece.item, piece.corner});
      links_.push_back({ends.at(piece.from), ends.at(piece.to), key(piece)});
    }
    for (const auto& [piece, reversed] : chains_of(links_).places) {
      const auto first = static_cast<std::uint32_t>(all_.points.size());
      all_.pieces.push_back({pieces[piece].item, first, 2});
      const ChainLink& link = links_[piece];
      all_.points.push_back(reversed ? link.to : link.from);
      all_.points.push_back(reversed ? link.from : link.to);
    }
  }

 private:
  std::uint64_t key(const VisiblePiece& piece) const {
    return groups_.empty() ? 0 : groups_[piece.item];
  }

  const Primitives& items_;
  std::span<const std::uint32_t> groups_;
  SortedPieces& all_;
  std::vector<ChainLink> links_;
};

}  // namespace

SortedPieces lines_in_order(const Primitives& items, HiddenMethod method,
                            const SortOptions& options, std::span<const std::uint32_t> groups) {
  const std::vector<LineName> lines = drawn_lines(items);
  const SeenLines seen = visible_lines(
      items, lines, method, {.precision = options.precision, .threads = options.threads});
  SortedPieces pieces;
  pieces.are_lines = true;
  ChainWriter writer(items, groups, pieces);
  if (options.hidden_lines == HiddenLines::dashed) {
    writer.add(uncovered_pieces(items, seen, hidden_pieces(lines, seen)));
    pieces.hidden.assign(pieces.pieces.size(), 1);
  }
  writer.add(seen.pieces);
  if (!pieces.hidden.empty()) pieces.hidden.resize(pieces.pieces.size(), 0);
  pieces.visible.assign(pieces.points.size(), 1);
  return pieces;
}

}  // namespace displayfile
