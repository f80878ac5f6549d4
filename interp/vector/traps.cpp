#include "interp/vector/traps.h"

#include <algorithm>
#include <cstdint>

namespace displayfile {

namespace {

/// The first region that has each side.
class FirstRegions {
 public:
  explicit FirstRegions(std::span<const FigureRegion> regions) {
    for (std::uint32_t r = 0; r < regions.size(); ++r) {
      for_each_side(regions[r].loops, [&](const LatticePoint& from, const LatticePoint& to) {
        sides_.push_back({LatticeSide(from, to), r});
      });
    }
    std::ranges::sort(sides_);
  }

  std::uint32_t of(const LatticeSide& side) const {
    return std::ranges::lower_bound(sides_, side, {}, &SideOfRegion::side)->region;
  }

 private:
  struct SideOfRegion {
    LatticeSide side;
    std::uint32_t region;
    friend auto operator<=>(const SideOfRegion&, const SideOfRegion&) = default;
  };
  std::vector<SideOfRegion> sides_;
};

/// Writes traps, and starts a new path before one becomes too long.
class TrapWriter {
 public:
  TrapWriter(std::vector<FigureTrap>& traps, const FillPaint& paint)
      : traps_(traps), paint_(paint) {}

  void begin() {
    if (new_path_ || sides().points.size() >= Figure::kMostVertices / 2) {
      traps_.push_back({paint_, {}});
      new_path_ = false;
    }
  }
  /// A chain with more vertices than a path may have continues in another path.
  void add(const LatticePoint& p) {
    if (sides().points.size() >= Figure::kMostVertices) {
      const LatticePoint last = sides().points.back();
      end(false);
      traps_.push_back({paint_, {}});
      sides().points.push_back(last);
    }
    sides().points.push_back(p);
  }
  void end(bool closed) {
    sides().ends.push_back(sides().points.size());
    sides().closed.push_back(closed);
  }
  /// The number of paths, by which a caller detects that a chain began in an earlier one.
  std::size_t paths() const { return traps_.size(); }

 private:
  LatticeChains& sides() { return traps_.back().sides; }

  std::vector<FigureTrap>& traps_;
  FillPaint paint_;
  bool new_path_ = true;
};

/// Adds the loop's sides for which `own` is true: the whole loop, or runs.
template <class Own>
void add_sides(TrapWriter& writer, std::span<const LatticePoint> loop, const Own& own) {
  const std::size_t n = loop.size();
  const auto at = [&](std::size_t i) { return loop[i % n]; };
  const auto owns = [&](std::size_t i) { return own(LatticeSide(at(i), at(i + 1))); };
  std::size_t start = 0;  // a side before which a run ends
  while (start < n && owns(start)) ++start;
  if (start == n) {
    writer.begin();
    const std::size_t paths = writer.paths();
    for (const LatticePoint& p : loop) writer.add(p);
    const bool whole = writer.paths() == paths;
    if (!whole) writer.add(loop[0]);
    return writer.end(whole);
  }
  bool running = false;
  for (std::size_t i = start + 1; i <= start + n; ++i) {
    const bool owned = owns(i);
    if (owned && !running) {
      writer.begin();
      writer.add(at(i));
    }
    if (owned) writer.add(at(i + 1));
    if (!owned && running) writer.end(false);
    running = owned;
  }
}

}  // namespace

std::vector<FigureTrap> traps_of(std::span<const FigureRegion> regions) {
  const FirstRegions first(regions);
  std::vector<FigureTrap> traps;
  for (std::size_t r = regions.size(); r-- > 0;) {
    TrapWriter writer(traps, regions[r].paint);
    const LatticeLoops& loops = regions[r].loops;
    for (std::size_t k = 0; k < loops.size(); ++k) {
      add_sides(writer, loops.loop(k),
                [&](const LatticeSide& side) { return first.of(side) == r; });
    }
  }
  return traps;
}

}  // namespace displayfile
