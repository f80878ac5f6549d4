#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "hidden/lines/hidden_parts.h"
#include "hidden/lines/line_scene.h"
#include "hidden/parallel.h"

namespace displayfile {

/// The pieces of all lines, by a method that finds what is hidden of one: hidden_parts(line)
/// returns it united, valid until it is called again. Of a side with more than one depth that is
/// hidden what is hidden at each. make_finder makes a method for one thread's use; lines are done
/// many at a time, and the pieces are put together in order.
template <class MakeFinder>
VisibleLines visible_pieces(const LineScene& scene, int threads, const MakeFinder& make_finder) {
  constexpr std::size_t kPart = 512;
  const auto lines = scene.lines();
  // A part begins where a name does.
  std::vector<std::size_t> begins;
  for (std::size_t at = 0; at < lines.size(); at += kPart) {
    while (at > 0 && at < lines.size() && lines[at].name == lines[at - 1].name) ++at;
    if (at < lines.size()) begins.push_back(at);
  }
  begins.push_back(lines.size());
  std::vector<std::vector<VisiblePiece>> found(begins.size() - 1);
  in_parallel(threads, found.size(), [&](std::size_t part) {
    auto finder = make_finder();
    std::vector<LinePart> hidden, common;
    for (std::size_t i = begins[part]; i < begins[part + 1];) {
      const std::uint32_t n = lines[i].name;
      hidden = finder.hidden_parts(lines[i]);
      for (++i; i < begins[part + 1] && lines[i].name == n; ++i) {
        common.clear();
        if (!hidden.empty()) intersect(hidden, finder.hidden_parts(lines[i]), common);
        std::swap(hidden, common);
      }
      const auto [item, corner] = scene.name(n);
      double from = 0.0;
      for (const LinePart& part_hidden : hidden) {
        if (from < part_hidden.from) found[part].push_back({item, corner, from, part_hidden.from});
        from = part_hidden.to;
      }
      if (from < 1.0) found[part].push_back({item, corner, from, 1.0});
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
