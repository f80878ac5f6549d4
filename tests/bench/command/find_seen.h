#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "clip/base/parallel.h"
#include "interp/visibility/image_space.h"

namespace displayfile::bench {

/// Calls draw(begin, end) for rows in tasks, on `threads` threads.
void for_rows(int rows, int threads, const auto& draw) {
  constexpr int kRowsOfTask = 16;
  const int tasks = (rows + kRowsOfTask - 1) / kRowsOfTask;
  in_parallel(threads, static_cast<std::size_t>(tasks), [&](std::size_t k) {
    const auto task = static_cast<int>(k);
    draw(task * kRowsOfTask, std::min(rows, (task + 1) * kRowsOfTask));
  });
}

/// Room for a fill a pixel.
inline std::vector<ViewedScene::Fill> room_for(const PictureSize& size) {
  return std::vector<ViewedScene::Fill>(static_cast<std::size_t>(size.width) *
                                        static_cast<std::size_t>(size.height));
}

/// Finds the visible fills by a method that has prepared a scene, the bottom row first.
inline void find_seen(const ImageSpaceMethod& method, const PictureSize& size, int threads,
                      std::vector<ViewedScene::Fill>& seen) {
  const auto width = static_cast<std::size_t>(size.width);
  for_rows(size.height, threads, [&](int begin, int end) {
    method.draw_rows(begin, end, [&](int row, int first, std::span<const ViewedScene::Fill> fills) {
      const std::size_t start = static_cast<std::size_t>(row) * width;
      std::ranges::copy(fills, seen.data() + start + first);
    });
  });
}

}  // namespace displayfile::bench
