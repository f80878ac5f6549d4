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

/// What is checked before any work is done, beside what resolve (interp/draw/picture_plan.h)
/// refuses: what a method can draw, that files can be written, and that there is memory.
namespace displayfile {

/// Throws Error if a file that the plan writes cannot be written: every output must be writable
/// before any is written.
void require_writable(const Destination& to, const PicturePlan& plan);

/// Throws Error if the method shows lines only and the device draws surfaces, or if it finds lines
/// and something of fills is wanted.
void require_drawable_by(HiddenMethod method, const PicturePlan& plan);

/// True if all that a method hands on is to be seen, or at least hides nothing, so that nothing
/// needs to be painted over: as pens need it. `of_fills`: and it hands on fills, for hatching.
bool draws_for_pens(HiddenMethod method, bool of_fills);
/// Throws Error for another method.
void require_drawn_by_pens(HiddenMethod method, const Pens& pens);

/// Throws Error if lines are to be drawn where they are hidden and nothing draws them there: the
/// colour rule and the OSMesa device draw what comes, and only an order of fills has such lines.
void require_hidden_lines_drawn(HiddenLines hidden_lines, HiddenMethod method,
                                const PicturePlan& plan);

/// Throws Error for scope `segment`, of a view of a retained scene: all its segments are drawn
/// together.
void require_scope_of_view(const DrawOptions& options);
/// Throws Error if the options say how hidden surfaces are found, and the display file, which is
/// drawn in the order that it has, was put in order otherwise.
void require_order_as_it_is(const DisplayFile& display_file, const DrawOptions& options);
/// Calls the options' `warn` if what the system viewed is stretched in a picture of their shape,
/// and the application did not set that it should be.
void warn_if_stretched(const GraphicsSystem& system, const DrawOptions& options);
/// The same of a view; `settings` may be null.
void warn_if_stretched(const View& view, const GraphicsSystem* settings,
                       const DrawOptions& options);

/// Where a display file goes to: how its surfaces are found by a method of image space.
enum class FoundBy {
  method,  ///< by that method, or in vectors by the map
  device,  ///< by a device's own z-buffer
  nobody,  ///< not at all: a dump
};
/// The options for hidden surfaces that were set and have no effect, a sentence each: a ROUNDOFF
/// where nothing is decided by it, and a scope where no segments are sorted. `drawn` has the orders
/// that are drawn.
std::vector<std::string> options_without_effect(const HiddenSurfaceOptions& set,
                                                const SurfacePlan& plan, HiddenMethod method,
                                                const DisplayFile& drawn, FoundBy by);
/// Calls the plan's `warn` with them.
void warn_of_options_without_effect(const PicturePlan& plan, const DisplayFile& drawn);
/// Throws Error for a method that a retained scene's rays do not draw.
void require_drawn_by_rays(const PicturePlan& plan);

/// What the colours of a picture take with so many samples along a pixel's side, on a device or by
/// a method that holds all of them; 0 where a few rows are held.
std::size_t bytes_of_samples(const PicturePlan& plan, int samples);
/// Throws LimitReached if a picture of so many bytes beside its samples does not fit, and would
/// with one sample a pixel.
void require_samples_fit(std::size_t bytes, const PicturePlan& plan, const std::string& what);
/// What the drawing is called in messages, and what may be done instead.
WorkDone drawing_work(const PicturePlan& plan);

/// What `draw` returns: a picture in memory, for which there must be room before any work is done.
template <class Draw>
Picture with_memory_of_picture(const PicturePlan& plan, const SoftwareRenderer& kept, Draw&& draw) {
  const DrawOptions& options = plan.options;
  const int rows = options.drawn_rows();
  const auto pixels = static_cast<std::size_t>(options.width) * static_cast<std::size_t>(rows);
  const std::size_t of_pixel = sizeof(Picture::pixels[0]) +
                               (options.with_ids ? sizeof(Picture::ids[0]) : 0) +
                               (options.with_depth ? sizeof(Picture::depth[0]) : 0);
  const auto what = [&] { return fmt::format("a picture of {} x {} pixels", options.width, rows); };
  require_samples_fit(pixels * of_pixel, plan, what());
  return with_memory(
      pixels * of_pixel + bytes_of_samples(plan, plan.samples), what,
      [&] {
        const NamedWork named(drawing_work(plan));
        return draw();
      },
      kept.bytes_of_picture());
}

/// Draws into a file or a stream: by rows, but for a device or a method that has all samples in
/// memory. What a method makes of a scene of so many bytes is no smaller than it is.
template <class Draw>
void with_memory_of_drawing(std::size_t bytes_of_scene, const Destination& to,
                            const PicturePlan& plan, Draw&& draw) {
  const DrawOptions& options = plan.options;
  const auto what = [&] {
    return fmt::format("{} of {} x {}", to.name(), options.width, options.height);
  };
  require_samples_fit(bytes_of_scene, plan, what());
  with_memory(bytes_of_scene + bytes_of_samples(plan, plan.samples), what, [&] {
    const NamedWork named(drawing_work(plan));
    draw();
  });
}

}  // namespace displayfile
