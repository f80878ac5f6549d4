#include "programs/bench/beside_embree.h"

#include <vector>

#include "interp/visibility/image_space.h"
#include "programs/bench/find_seen.h"

namespace displayfile::bench {

BesideEmbree cast_beside_embree(const ViewedScene& triangles, int size, int threads,
                                EmbreeRays::Quality quality, const Effort& effort) {
  const PictureSize picture{size, size};
  const ImageSpaceMethod::Request request{triangles, picture, std::nullopt};
  const auto method = make_image_space_method(HiddenMethod::ray_cast);
  method->prepare(request, threads);
  const EmbreeRays::Input input(in_triangles(triangles), picture);
  const EmbreeRays embree(input, threads, quality);
  std::vector<ViewedScene::Fill> seen = room_for(picture);
  EmbreeRays::Hits hits(picture, false);
  BesideEmbree result{};
  result.rays = warm_ratio(
      effort, threads,
      [&] { for_rows(size, threads, [&](int begin, int end) { embree.cast(begin, end, hits); }); },
      [&] { find_seen(*method, picture, threads, seen); });
  const auto other = make_image_space_method(HiddenMethod::ray_cast);
  result.building = warm_ratio(
      effort, threads, [&] { EmbreeRays(input, threads, quality); },
      [&] { other->prepare(request, threads); });
  std::size_t covered = 0;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    covered += seen[k] != ViewedScene::kBackground;
    result.others += seen[k] != hits.fills[k];
  }
  result.hit = static_cast<double>(covered) / static_cast<double>(seen.size());
  return result;
}

}  // namespace displayfile::bench
