#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/memory.h"
#include "clip/view.h"
#include "displayfile/files.h"
#include "interp/device/picture.h"
#include "interp/draw/draw.h"
#include "interp/draw/picture_plan.h"
#include "interp/raster/software.h"

/// Checks before any work is done, in addition to those of resolve (interp/draw/picture_plan.h):
/// whether a method can draw this, files can be written, and there is memory.
namespace displayfile {

/// Throws Error if a file that the plan writes cannot be written: every output must be writable
/// before any is written.
void require_writable(const PicturePlan& plan);

/// Throws Error if the method shows lines only and the device draws surfaces, or if it finds lines
/// and the plan wants data of fills.
void require_drawable_by(HiddenMethod method, const PicturePlan& plan);

/// True if a method's output is all visible, or at least hides nothing, so that pens need not paint
/// over anything. `of_fills`: and it includes fills, for hatching.
bool draws_for_pens(HiddenMethod method, bool of_fills);
/// Throws Error for another method.
void require_drawn_by_pens(HiddenMethod method, const Pens& pens);

/// Throws Error if hidden lines are to be drawn and nothing finds them: the colour rule and the
/// OSMesa device draw their input, and only an order of fills has hidden lines.
void require_hidden_lines_drawn(HiddenLines hidden_lines, HiddenMethod method,
                                const PicturePlan& plan);

/// True if lines that overlap are drawn in order of depth.
bool draws_lines_by_depth(HiddenMethod method, const PicturePlan& plan, PictureKind kind);
/// Throws Error if the options set line order `depth` and the method, or the device, draws in order
/// of entry. (If the application set it, a warning says so.)
void require_line_order_obeyed(HiddenMethod method, const PicturePlan& plan, PictureKind kind);

/// Throws Error for scope `segment` in a view of a retained scene: all its segments are drawn
/// together.
void require_scope_of_view(const DrawOptions& options);
/// Throws Error if the options have hidden-surface settings that differ from those of the display
/// file's order.
void require_order_as_it_is(const DisplayFile& display_file, const DrawOptions& options);
/// The first visible segment that an image transformation turns by other than half turns, if the
/// picture is not square; otherwise null. Image transformations apply in normalised device
/// coordinates, whose units differ in x and y there.
const Segment* distorted_by_turning(const DisplayFile& file, int width, int height);
/// Calls the options' `warn` if a system's windows are stretched by default in a picture of this
/// aspect ratio, or its images are distorted by turning.
void warn_if_stretched(const GraphicsSystem& system, const DrawOptions& options);
/// The same for a view; `settings` may be null.
void warn_if_stretched(const View& view, const GraphicsSystem* settings,
                       const DrawOptions& options);

/// How a picture's surfaces are found by a method of image space.
enum class FoundBy {
  method,  ///< by that method, or in vectors by the map
  device,  ///< by a device's own z-buffer
  nobody,  ///< not at all: a dump
};
/// The options for hidden surfaces that are set and have no effect, a sentence each: a ROUNDOFF
/// that decides nothing, and a scope where no segments are sorted. `drawn` has the sorts drawn.
std::vector<std::string> options_without_effect(const HiddenSurfaceOptions& set,
                                                const SurfacePlan& plan, HiddenMethod method,
                                                const DisplayFile& drawn, FoundBy by);
/// Calls the plan's `warn` with them.
void warn_of_options_without_effect(const PicturePlan& plan, const DisplayFile& drawn);
/// Calls it with the faults of annotation (annotation_faults, hidden_anchors).
void warn_of_annotation(const PicturePlan& plan, const DisplayFile& drawn);
void warn_of_annotation(const PicturePlan& plan, const ViewedScene& drawn);
/// Throws Error for a method that does not draw by rays in a retained scene.
void require_drawn_by_rays(const PicturePlan& plan);

/// The bytes of the colours of a picture with `samples` x `samples` samples a pixel, on a device or
/// by a method that holds all of them; 0 if only a few rows are held.
std::size_t bytes_of_samples(const PicturePlan& plan, int samples);
/// True if a picture of `bytes` bytes without its samples does not fit, but would with one sample a
/// pixel.
bool needs_fewer_samples(std::size_t bytes, const PicturePlan& plan);
/// Throws LimitReached, which names the picture and --samples 1.
[[noreturn]] void throw_needs_fewer_samples(std::size_t bytes, const PicturePlan& plan,
                                            const std::string& what);
/// The drawing's name in messages, and what to do instead.
WorkDone drawing_work(const PicturePlan& plan);

/// Returns the result of `draw`, a picture in memory, after checking that there is memory for it.
template <class Draw>
Picture with_memory_of_picture(const PicturePlan& plan, const SoftwareRenderer& kept, Draw&& draw) {
  const DrawOptions& options = plan.options;
  const int rows = options.drawn_rows();
  const auto pixels = static_cast<std::size_t>(options.width) * static_cast<std::size_t>(rows);
  const std::size_t of_pixel = sizeof(Picture::pixels[0]) +
                               (options.with_ids ? sizeof(Picture::ids[0]) : 0) +
                               (options.with_depth ? sizeof(Picture::depth[0]) : 0);
  const auto what = [&] { return fmt::format("a picture of {} x {} pixels", options.width, rows); };
  const std::size_t bytes = pixels * of_pixel;
  if (needs_fewer_samples(bytes, plan)) throw_needs_fewer_samples(bytes, plan, what());
  return with_memory(
      bytes + bytes_of_samples(plan, plan.samples), what,
      [&] {
        const NamedWork named(drawing_work(plan));
        return draw();
      },
      kept.bytes_of_picture());
}

/// Draws into a file or a stream: by rows, except for a device or a method that holds all samples
/// in memory. A method's data for a scene take at least `bytes_of_scene`.
template <class Draw>
void with_memory_of_drawing(std::size_t bytes_of_scene, const PicturePlan& plan, Draw&& draw) {
  const DrawOptions& options = plan.options;
  const auto what = [&] {
    return fmt::format("{} of {} x {}", plan.to->name(), options.width, options.height);
  };
  if (needs_fewer_samples(bytes_of_scene, plan)) {
    throw_needs_fewer_samples(bytes_of_scene, plan, what());
  }
  with_memory(bytes_of_scene + bytes_of_samples(plan, plan.samples), what, [&] {
    const NamedWork named(drawing_work(plan));
    draw();
  });
}

}  // namespace displayfile
