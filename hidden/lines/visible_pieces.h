#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/parallel.h"
#include "clip/base/work_budget.h"
#include "clip/base/work_progress.h"
#include "hidden/lines/hidden_parts.h"
#include "hidden/lines/line_table.h"
#include "hidden/lines/visible_lines.h"

namespace displayfile {

/// A visible part of a line.
struct SeenPart {
  std::uint32_t name;
  PartOfLine part;
};

/// Adds the visible parts of the line of one name, which begins at lines[first]. A method finds the
/// hidden parts at one depth: finder.hidden_parts(line) is united, and valid until the next call. A
/// line with more than one depth is hidden where it is hidden at each.
template <class Finder>
void find_seen(std::span<const LineTable::Line> lines, std::size_t first, Finder& finder,
               std::vector<SeenPart>& seen) {
  const std::uint32_t name = lines[first].name;
  const auto add = [&](const std::vector<PartOfLine>& hidden) {
    double from = 0.0;
    for (const PartOfLine& part : hidden) {
      assert(from <= part.from && part.to <= 1.0);
      if (from < part.from) seen.push_back({name, {from, part.from}});
      from = part.to;
    }
    if (from < 1.0) seen.push_back({name, {from, 1.0}});
  };
  const auto is_last = [&](std::size_t i) {
    return i + 1 == lines.size() || lines[i + 1].name != name;
  };
  if (is_last(first)) return add(finder.hidden_parts(lines[first]));
  std::vector<PartOfLine> hidden = finder.hidden_parts(lines[first]), common;
  for (std::size_t i = first; !is_last(i) && !hidden.empty(); ++i) {
    common.clear();
    intersect(hidden, finder.hidden_parts(lines[i + 1]), common);
    std::swap(hidden, common);
  }
  add(hidden);
}

/// A pool of finders, at most one per thread: a thread takes one and returns it.
template <class MakeFinder>
class Finders {
 public:
  using Finder = std::invoke_result_t<const MakeFinder&>;

  explicit Finders(const MakeFinder& make) : make_(make) {}

  template <class Work>
  void use(const Work& work) {
    std::unique_ptr<Finder> finder = take();
    work(*finder);
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(finder));
  }

 private:
  std::unique_ptr<Finder> take() {
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        std::unique_ptr<Finder> finder = std::move(idle_.back());
        idle_.pop_back();
        return finder;
      }
    }
    return std::make_unique<Finder>(make_());
  }

  const MakeFinder& make_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Finder>> idle_;
};

/// Orders the parts found for all lines by names, keeping each line's parts together.
inline SeenLines by_names(const LineTable& scene, std::span<const std::vector<SeenPart>> seen) {
  const std::size_t names = scene.names(), intersections = scene.intersections().size();
  std::vector<std::size_t> place(names + intersections + 1, 0);  // of each name's pieces
  for (const auto& parts : seen) {
    for (const SeenPart& part : parts) {
      assert(part.name < names + intersections);
      ++place[part.name + 1];
    }
  }
  for (std::size_t n = 1; n < place.size(); ++n) place[n] += place[n - 1];
  SeenLines all;
  const std::size_t of_names = place[names];
  all.pieces.resize(of_names);
  all.intersections.resize(place.back() - of_names);
  for (const auto& parts : seen) {
    for (const auto& [name, part] : parts) {
      const std::size_t at = place[name]++;
      if (name < names) {
        const auto [item, corner] = scene.name(name);
        all.pieces[at] = {item, corner, part.from, part.to};
      } else {
        const auto line = static_cast<std::uint32_t>(name - names);
        all.intersections[at - of_names] = {line, part.from, part.to};
      }
    }
  }
  return all;
}

/// The pieces of all lines, in order of names. make_finder makes a finder for one thread. `order`
/// has the first line of each name in processing order, preferably with nearby lines adjacent.
template <class MakeFinder>
SeenLines visible_pieces(const LineTable& scene, std::span<const std::uint32_t> order,
                         const SurfacePlan& plan, const MakeFinder& make_finder) {
  constexpr std::size_t kPart = 512;
  std::vector<std::vector<SeenPart>> seen((order.size() + kPart - 1) / kPart);
  Finders finders(make_finder);
  CountedWork work(plan.progress, order.size());
  PieceCount pieces(order.size(), sizeof(SeenPart));
  in_parallel(plan.threads, seen.size(), [&](std::size_t part) {
    const std::size_t begin = part * kPart, end = std::min(order.size(), begin + kPart);
    finders.use([&](auto& finder) {
      for (std::size_t k = begin; k < end; ++k) {
        find_seen(scene.lines(), order[k], finder, seen[part]);
      }
    });
    pieces.add(seen[part].size());
    work.add(end - begin);
  });
  return by_names(scene, seen);
}

}  // namespace displayfile
