#include "tests/bench/beside_embree.h"

#include <algorithm>
#include <span>
#include <vector>

#include "displayfile/display_file.h"
#include "hidden/parallel.h"
#include "interp/visibility/image_space.h"
#include "programs/bench/embree_rays.h"

namespace displayfile::bench {

namespace {

constexpr int kRowsOfTask = 16;

/// Rows in tasks, on so many threads.
void for_rows(int size, int threads, const auto& draw) {
  const int tasks = (size + kRowsOfTask - 1) / kRowsOfTask;
  in_parallel(threads, static_cast<std::size_t>(tasks), [&](std::size_t k) {
    const auto task = static_cast<int>(k);
    draw(task * kRowsOfTask, std::min(size, (task + 1) * kRowsOfTask));
  });
}

}  // namespace

ViewedScene scene_of_triangles(const ViewedScene& scene) {
  DisplayFile file;
  Segment& segment = file.create(1);
  segment.set_style(LineStyle{LineStyle::Kind::none});
  segment.set_style(FillStyle{FillStyle::Kind::solid});
  const std::vector<std::uint8_t> edges(3, 1);
  const Triangles triangles = in_triangles(scene);
  const std::span<const Point3> corners = triangles.corners;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    segment.enter_polygon(corners.subspan(i, 3), edges);
  }
  return ViewedScene(file);
}

BesideEmbree cast_beside_embree(const ViewedScene& triangles, int size, int threads, int rounds) {
  using Fill = ViewedScene::Fill;
  const auto width = static_cast<std::size_t>(size);
  const PictureSize picture{size, size};
  const auto method = make_image_space_method(HiddenMethod::ray_cast);
  const ImageSpaceMethod::Request request{triangles, picture, std::nullopt};
  method->prepare(request, threads);
  std::vector<Fill> seen(width * width);
  EmbreeRays::Hits hits(picture, false);
  const auto ours = [&] {
    for_rows(size, threads, [&](int begin, int end) {
      method->draw_rows(begin, end, [&](int row, int first, std::span<const Fill> fills) {
        const std::size_t start = static_cast<std::size_t>(row) * width;
        std::ranges::copy(fills, seen.data() + start + first);
      });
    });
  };
  const Triangles cut = in_triangles(triangles);
  const EmbreeRays embree(cut, picture, threads);
  const auto embrees = [&] {
    for_rows(size, threads, [&](int begin, int end) { embree.cast(begin, end, hits); });
  };
  BesideEmbree result;
  result.rays = times_faster(rounds, ours, embrees);
  result.building = times_faster(
      3, [&] { method->prepare(request, threads); }, [&] { EmbreeRays(cut, picture, threads); });
  std::size_t covered = 0;
  result.others = 0;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    covered += seen[k] != ViewedScene::kBackground;
    result.others += seen[k] != hits.fills[k];
  }
  result.hit = static_cast<double>(covered) / static_cast<double>(seen.size());
  return result;
}

}  // namespace displayfile::bench
