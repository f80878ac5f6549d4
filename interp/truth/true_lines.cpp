#include "interp/truth/true_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <optional>
#include <utility>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "clip/base/parallel.h"
#include "clip/base/work_budget.h"
#include "interp/truth/line_hiders.h"

namespace displayfile {

namespace {

using Part = TrueLine::Part;

/// The lines to which the given sides belong, except those that are points in the projection.
std::vector<LineItems::Sharers> lines_with_length(const LineItems& items,
                                                  std::span<const LineId> lines) {
  std::vector<LineItems::Sharers> found = items.shared(lines);
  std::erase_if(found, [&](const LineItems::Sharers& sharers) {
    return Point2(items.from(sharers.front())) == Point2(items.to(sharers.front()));
  });
  return found;
}

double length(const LineItems& items, LineId line) {
  // std::hypot is not used: its last digit differs between C libraries.
  return glm::distance(Point2(items.from(line)), Point2(items.to(line)));
}

/// Parts in doubles, without parts and gaps that have lost their length by rounding.
std::vector<Part> rounded(const ExactParts& exact) {
  Division division;
  std::vector<Part> parts;
  for (const auto& [from, to] : exact) {
    const Part part{division.nearest_double(from.over, from.under),
                    division.nearest_double(to.over, to.under)};
    if (!(part.from < part.to)) continue;
    if (!parts.empty() && parts.back().to == part.from) {
      parts.back().to = part.to;
    } else {
      parts.push_back(part);
    }
  }
  return parts;
}

}  // namespace

std::vector<TrueIntersection> true_intersections(const LineItems& items, int threads) {
  const LineHiders hiders(items, threads);
  std::vector<std::vector<TrueIntersection>> with_earlier(items.size());
  in_parallel(threads, items.size(), [&](std::size_t k) {
    const auto b = static_cast<std::uint32_t>(k);
    for (std::uint32_t a = 0; a < b; ++a) {
      for (const ExactLine& line : hiders.intersections(a, b)) {
        if (Point2(line.start) == Point2(line.end)) continue;
        with_earlier[k].push_back(
            {a, b, line.start, line.end, rounded(visible_parts(line, hiders.hiders(line)))});
      }
    }
  });
  std::vector<TrueIntersection> all;
  for (auto& found : with_earlier) {
    all.insert(all.end(), std::move_iterator(found.begin()), std::move_iterator(found.end()));
  }
  return all;
}

std::vector<TrueLine> true_lines(const LineItems& items, std::span<const LineId> lines, int threads,
                                 const WorkProgress& progress) {
  const NamedWork named({"the truth of lines", "a random part of them (samples)"});
  const LineHiders hiders(items, threads);
  std::vector<LineItems::Sharers> shared = lines_with_length(items, lines);
  std::vector<TrueLine> found(shared.size());
  CountedWork work(progress, shared.size());
  in_parallel(threads, shared.size(), [&](std::size_t k) {
    const ExactLine line = hiders.line(shared[k]);
    const double long_ = length(items, shared[k].front());
    found[k] = {std::move(shared[k]), long_, rounded(visible_parts(line, hiders.hiders(line)))};
    work.add(1);
  });
  return found;
}

std::vector<LinePiece> visible_pieces(std::span<const TrueLine> lines) {
  std::vector<LinePiece> pieces;
  for (const TrueLine& line : lines) {
    for (const auto& [from, to] : line.visible) pieces.push_back({line.sharers[0], from, to});
  }
  return pieces;
}

// ---- Claims --------------------------------------------------------------------------------

namespace {

/// The parts claimed to be visible on each line, along its first sharer.
struct Claims {
  std::vector<std::vector<Part>> of_line;
  double elsewhere = 0.0;  // length of pieces of other lines
};

void require_piece(const LineItems& items, const LinePiece& piece) {
  const auto& [line, from, to] = piece;
  if (items.contains(line) && 0.0 <= from && from < to && to <= 1.0) return;
  throw Error(
      fmt::format("a piece of line ({}, {}) from {} to {}: expected a line of the {} items and "
                  "0 <= from < to <= 1",
                  line.item, line.corner, from, to, items.size()));
}

std::vector<Part> united(std::vector<Part> parts) {
  std::ranges::sort(parts, {}, &Part::from);
  std::vector<Part> all;
  for (const Part& part : parts) {
    if (all.empty() || all.back().to < part.from) {
      all.push_back(part);
    } else {
      all.back().to = std::max(all.back().to, part.to);
    }
  }
  return all;
}

/// Lines are given by their sharers.
template <class SharersOf>
Claims claims(const LineItems& items, std::size_t lines, const SharersOf& sharers_of,
              std::span<const LinePiece> pieces) {
  struct Named {
    LineId sharer;
    std::size_t line;
  };
  std::vector<Named> named;
  for (std::size_t k = 0; k < lines; ++k) {
    for (const LineId sharer : sharers_of(k)) named.push_back({sharer, k});
  }
  std::ranges::sort(named, {}, &Named::sharer);
  Claims claims;
  claims.of_line.resize(lines);
  for (const LinePiece& piece : pieces) {
    require_piece(items, piece);
    const auto found = std::ranges::lower_bound(named, piece.line, {}, &Named::sharer);
    if (found == named.end() || found->sharer != piece.line) {
      claims.elsewhere += (piece.to - piece.from) * length(items, piece.line);
      continue;
    }
    const bool reversed = items.from(sharers_of(found->line)[0]) != items.from(piece.line);
    claims.of_line[found->line].push_back(reversed ? Part{1.0 - piece.to, 1.0 - piece.from}
                                                   : Part{piece.from, piece.to});
  }
  for (std::vector<Part>& parts : claims.of_line) parts = united(std::move(parts));
  return claims;
}

/// An end in doubles, reversed or not, is off by less than this fraction of the line.
constexpr double kEndRounding = 0x1p-52;

/// The length of a without b, in parts no shorter than `least`; both in order and disjoint.
double length_without(const std::vector<Part>& a, const std::vector<Part>& b, double least) {
  double sum = 0.0;
  const auto add = [&](double from, double to) {
    if (to > from && to - from >= least) sum += to - from;
  };
  for (const Part& part : a) {
    double from = part.from;
    for (const Part& taken : b) {
      if (taken.to <= from) continue;
      if (taken.from >= part.to) break;
      add(from, taken.from);
      from = std::max(from, taken.to);
    }
    add(from, part.to);
  }
  return sum;
}

}  // namespace

LineErrors compare_lines(const LineItems& items, std::span<const TrueLine> truth,
                         std::span<const LinePiece> claimed) {
  const Claims claims = displayfile::claims(
      items, truth.size(), [&](std::size_t k) { return std::span(truth[k].sharers); }, claimed);
  LineErrors errors;
  errors.extra = claims.elsewhere;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const auto& [sharers, length, visible] = truth[k];
    const double least = std::max(kLineCrumb / length, kEndRounding);
    errors.missing += length_without(visible, claims.of_line[k], least) * length;
    errors.extra += length_without(claims.of_line[k], visible, least) * length;
    errors.length += length;
  }
  return errors;
}

// ---- Samples -------------------------------------------------------------------------------

namespace {

/// Random numbers in [0,1) of 53 binary places, the same for the same seed and line whatever other
/// lines are sampled: the generator SplitMix64 (Steele, Lea and Flood, "Fast splittable
/// pseudorandom number generators", OOPSLA 2014).
class RandomPlaces {
 public:
  RandomPlaces(std::uint64_t seed, LineId line) : state_(seed) {
    state_ = next() ^ (std::uint64_t{line.item} << 32 | line.corner);
    next();
  }
  double place() { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

Fraction fraction(double value) {
  const int places = binary_places(value);
  return {scaled(value, places), Integer(1) << static_cast<std::size_t>(places)};
}

bool contains(const std::vector<Part>& parts, double t) {
  return std::ranges::any_of(parts, [&](const Part& p) { return p.from <= t && t < p.to; });
}

bool is_close_to_an_end(const std::vector<Part>& parts, double t, double reach) {
  return std::ranges::any_of(parts, [&](const Part& p) {
    return std::abs(p.from - t) < reach || std::abs(p.to - t) < reach;
  });
}

/// The length of the part around t that is entirely visible or entirely hidden.
double length_around(const std::vector<Part>& visible, double t) {
  double from = 0.0, to = 1.0;
  for (const Part& part : visible) {
    for (const double end : {part.from, part.to}) {
      if (end <= t) from = std::max(from, end);
      if (end > t) to = std::min(to, end);
    }
  }
  return to - from;
}

/// The judgement of one line.
LineJudgement judge_line(const LineHiders& scene, const LineItems::Sharers& sharers, double length,
                         const std::vector<Part>& claimed, std::size_t samples,
                         std::uint64_t seed) {
  LineJudgement judgement;
  judgement.errors.length = length;
  const ExactLine line = scene.line(sharers);
  const std::vector<Hider> hiders = scene.hiders(line);
  const double crumb = kLineCrumb / length;
  std::optional<std::vector<Part>> visible;  // found where a sample seems to be wrong
  RandomPlaces random(seed, sharers.front());
  std::size_t missing = 0;
  for (std::size_t k = 0; k < samples; ++k) {
    const double t = (static_cast<double>(k) + random.place()) / static_cast<double>(samples);
    if (t >= 1.0 || is_close_to_an_end(claimed, t, crumb)) continue;
    const bool is_seen = !is_hidden_after(line, hiders, fraction(t));
    if (is_seen != contains(claimed, t)) {
      if (!visible) visible = rounded(visible_parts(line, hiders));
      if (length_around(*visible, t) < crumb) continue;
      judgement.wrong.push_back({sharers.front(), t, is_seen});
      missing += is_seen ? 1 : 0;
    }
    ++judgement.samples;
  }
  if (judgement.samples == 0) return judgement;
  const double of_one = length / static_cast<double>(judgement.samples);
  judgement.errors.missing = static_cast<double>(missing) * of_one;
  judgement.errors.extra = static_cast<double>(judgement.wrong.size() - missing) * of_one;
  return judgement;
}

}  // namespace

LineJudgement judge_lines(const LineItems& items, std::span<const LineId> lines,
                          std::span<const LinePiece> claimed, std::size_t samples_of_line,
                          std::uint64_t seed, int threads, const WorkProgress& progress) {
  const NamedWork named({"the truth of lines", "a random part of them (samples)"});
  const std::vector<LineItems::Sharers> shared = lines_with_length(items, lines);
  const Claims claims = displayfile::claims(
      items, shared.size(), [&](std::size_t k) { return std::span(shared[k]); }, claimed);
  const LineHiders scene(items, threads);
  std::vector<LineJudgement> of_line(shared.size());
  CountedWork work(progress, shared.size());
  in_parallel(threads, shared.size(), [&](std::size_t k) {
    of_line[k] = judge_line(scene, shared[k], length(items, shared[k].front()), claims.of_line[k],
                            samples_of_line, seed);
    work.add(1);
  });
  LineJudgement all;
  all.errors.extra = claims.elsewhere;
  for (const LineJudgement& one : of_line) {
    all.samples += one.samples;
    all.wrong.insert(all.wrong.end(), one.wrong.begin(), one.wrong.end());
    all.errors.missing += one.errors.missing;
    all.errors.extra += one.errors.extra;
    all.errors.length += one.errors.length;
  }
  return all;
}

}  // namespace displayfile
