#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>

#include "clip/base/budgeted_work.h"
#include "clip/base/memory.h"
#include "clip/base/work_budget.h"
#include "clip/base/work_progress.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"
#include "interp/truth/true_picture.h"

namespace displayfile {

/// Enters the solid polygons of a retained scene's visible segments, in order of entry, into a
/// picture of this size. view_of(part, segment, picture) returns for each segment an object that
/// enters its polygons, by enter(primitive). Errors as in truth().
template <class ViewOf>
Picture retained_picture(const RetainedScene& retained, const DisplayFile& display_file, int width,
                         int height, bool depth, const WorkProgress& progress, ViewOf&& view_of,
                         DepthTies* ties = nullptr) {
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const auto each_segment = [&](auto&& visit) {
    for (const RetainedScene::Segment& part : retained.segments()) {
      const Segment& segment = display_file.segment(part.name);
      if (segment.visible) visit(part, segment);
    }
  };
  const auto is_solid_polygon = [&](std::uint32_t i) {
    return !retained[i].is_line() &&
           retained.shared_attributes(i).fill.kind == FillStyle::Kind::solid;
  };
  return with_memory(
      TruePicture::kBytesOfPixel * pixels,
      [&] { return fmt::format("the truth of {} x {} pixels", width, height); },
      [&] {
        TruePicture picture(width, height, ties);
        std::size_t done = 0, all = 0;
        each_segment([&](const RetainedScene::Segment& part, const Segment&) {
          all += part.end - part.first;
        });
        each_segment([&](const RetainedScene::Segment& part, const Segment& segment) {
          auto view = view_of(part, segment, picture);
          for (std::uint32_t i = part.first; i < part.end; ++i) {
            ask_budget();
            if (is_solid_polygon(i)) view.enter(i);
            ++done;
            if (progress) progress(done, all);
          }
        });
        return picture.take(depth);
      });
}

}  // namespace displayfile
