#include "hidden/lines/hidden_pieces.h"

#include <cassert>
#include <cstdint>

#include "hidden/lines/line_ends.h"
#include "hidden/lines/lines_on_lines.h"
#include "hidden/lines/uppermost_parts.h"

namespace displayfile {

std::vector<HiddenPiece> hidden_pieces(std::span<const LineName> lines, const SeenLines& seen) {
  std::vector<HiddenPiece> hidden;
  auto piece = seen.pieces.begin();
  for (const LineName& line : lines) {
    double from = 0.0;
    for (; piece != seen.pieces.end() && LineName{piece->item, piece->corner} == line; ++piece) {
      assert(from <= piece->from && piece->from < piece->to && piece->to <= 1.0);
      if (from < piece->from) hidden.push_back({line.item, line.corner, from, piece->from});
      from = piece->to;
    }
    if (from < 1.0) hidden.push_back({line.item, line.corner, from, 1.0});
  }
  assert(piece == seen.pieces.end());
  return hidden;
}

namespace {

/// Ranks: a hidden piece is not drawn where a visible one lies.
constexpr std::uint32_t kSeen = 0, kHidden = 1;

/// The lines that have visible or hidden pieces, and the pieces by line.
class PiecesOfPicture {
 public:
  PiecesOfPicture(const Primitives& items, std::span<const VisiblePiece> seen,
                  std::span<const HiddenPiece> hidden) {
    pieces_.reserve(seen.size() + hidden.size());
    auto s = seen.begin();
    auto h = hidden.begin();
    while (s != seen.end() || h != hidden.end()) {
      const bool seen_next = h == hidden.end() || (s != seen.end() && name(*s) < name(*h));
      const LineName next = name(seen_next ? *s : *h);
      const LineEnds ends(items, next);
      const auto line = static_cast<std::uint32_t>(lines_.size());
      lines_.push_back({Point2(ends.from), Point2(ends.to)});
      names_.push_back(next);
      for (; s != seen.end() && name(*s) == next; ++s) add(line, *s, kSeen);
      for (; h != hidden.end() && name(*h) == next; ++h) add(line, *h, kHidden);
    }
  }

  std::span<const LineOfPicture> lines() const { return lines_; }
  std::span<const RankedPiece> pieces() const { return pieces_; }
  LineName name_of(std::uint32_t piece) const { return names_[pieces_[piece].line]; }

 private:
  static LineName name(const VisiblePiece& piece) { return {piece.item, piece.corner}; }

  void add(std::uint32_t line, const VisiblePiece& piece, std::uint32_t rank) {
    pieces_.push_back({line, piece.from, piece.to, rank, 0, rank == kHidden});
  }

  std::vector<LineOfPicture> lines_;
  std::vector<RankedPiece> pieces_;
  std::vector<LineName> names_;  // of the lines
};

}  // namespace

std::vector<HiddenPiece> uncovered_pieces(const Primitives& items, const SeenLines& seen,
                                          std::span<const HiddenPiece> hidden) {
  if (hidden.empty()) return {};
  const PiecesOfPicture picture(items, seen.pieces, hidden);
  std::vector<HiddenPiece> left;
  for (const DrawnPart& part :
       uppermost_parts(picture.lines(), picture.pieces(), lines_apart(items.touching))) {
    const LineName line = picture.name_of(part.piece);
    left.push_back({line.item, line.corner, part.from, part.to});
  }
  return left;
}

}  // namespace displayfile
