#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "hidden/lines/hidden_parts.h"
#include "hidden/lines/line_scene.h"
#include "hidden/parallel.h"

namespace displayfile {

/// Adds the pieces of lines, of which a method finds what is hidden: finder.hidden_parts(line) is
/// united, and valid until it is called again. A side with more than one depth is hidden where it
/// is at each.
template <class Finder>
void find_pieces(const LineScene& scene, std::span<const LineScene::Line> lines, Finder& finder,
                 std::vector<VisiblePiece>& pieces) {
  std::vector<LinePart> hidden, common;
  for (std::size_t i = 0; i < lines.size();) {
    const std::uint32_t n = lines[i].name;
    hidden = finder.hidden_parts(lines[i]);
    for (++i; i < lines.size() && lines[i].name == n; ++i) {
      common.clear();
      if (!hidden.empty()) intersect(hidden, finder.hidden_parts(lines[i]), common);
      std::swap(hidden, common);
    }
    const auto [item, corner] = scene.name(n);
    double from = 0.0;
    for (const LinePart& part : hidden) {
      if (from < part.from) pieces.push_back({item, corner, from, part.from});
      from = part.to;
    }
    if (from < 1.0) pieces.push_back({item, corner, from, 1.0});
  }
}

/// The pieces of all lines. make_finder makes a method for one thread's use. Threads take lines
/// many at a time, and the pieces are put together in order.
template <class MakeFinder>
VisibleLines visible_pieces(const LineScene& scene, int threads, const MakeFinder& make_finder) {
  constexpr std::size_t kPart = 512;
  const auto lines = scene.lines();
  std::vector<std::size_t> begins;
  for (std::size_t at = 0; at < lines.size(); at += kPart) {
    // A part begins where a name does.
    while (at > 0 && at < lines.size() && lines[at].name == lines[at - 1].name) ++at;
    if (at < lines.size()) begins.push_back(at);
  }
  begins.push_back(lines.size());
  std::vector<std::vector<VisiblePiece>> found(begins.size() - 1);
  std::atomic<std::size_t> next = 0;
  const auto workers = std::min(found.size(), static_cast<std::size_t>(useful_threads(threads)));
  in_parallel(threads, workers, [&](std::size_t) {
    auto finder = make_finder();
    for (std::size_t part = next++; part < found.size(); part = next++) {
      find_pieces(scene, lines.subspan(begins[part], begins[part + 1] - begins[part]), finder,
                  found[part]);
    }
  });
  VisibleLines all;
  std::size_t count = 0;
  for (const auto& pieces : found) count += pieces.size();
  all.pieces.reserve(count);
  for (const auto& pieces : found) {
    all.pieces.insert(all.pieces.end(), pieces.begin(), pieces.end());
  }
  return all;
}

}  // namespace displayfile
