#pragma once

#include <memory>
#include <optional>

#include "displayfile/files.h"
#include "interp/device/picture.h"
#include "interp/draw/draw.h"

namespace displayfile {

/// Draws a system's pictures one after another, and tells what is seen in them: as draw
/// (interp/draw/draw.h) does, but with what is made ready for a picture kept for the next. While
/// the display file, the size and the method stay the same, nothing is made anew; where only some
/// segments changed, only these are sorted again. What world_ray_cast needs is made anew each time:
/// WorldViews (interp/draw/world_views.h) keeps that. For one thread.
class Renderer {
 public:
  Renderer();
  ~Renderer();
  Renderer(Renderer&& other) noexcept;
  Renderer& operator=(Renderer&& other) noexcept;

  /// The visible segments in memory. The picture stays until the next call, which uses its memory
  /// again. Throws Error as draw does, here as below.
  const Picture& draw(const GraphicsSystem& system, const DrawOptions& options = {});
  void draw(const GraphicsSystem& system, const Destination& to, const DrawOptions& options = {});

  /// The picture that draw made last, for a caller that keeps it: the next one gets memory of its
  /// own, or that of a picture that was given back. Empty if there is none.
  Picture take_picture();
  void give_back(Picture picture);

  /// What is seen, in a picture of the options' size, at the pixel that holds the point (x, y):
  /// in pixels from the picture's upper left corner, y down, as the rows of Picture::pixels; so the
  /// pixel in column i of row j from the top holds i <= x < i + 1, j <= y < j + 1. Nothing beyond
  /// the picture, and where there is only the background.
  ///
  /// It is what is seen at the pixel's centre by the definition of truth (interp/truth/truth.md):
  /// what the item buffer holds that the exact methods draw, decided as exactly, whatever the
  /// method in force. A line, or a drawn side of a polygon, that is seen within `reach` pixels of
  /// the centre, or within half its width, comes before the fill there; with a reach of 0 only
  /// fills are picked, as they are in an item buffer. Of lines the one that is seen nearest to the
  /// centre.
  ///
  /// The first pick of a display file makes a tree of boxes, and costs about as much as a picture;
  /// those that follow, while it stays the same, look only at what lies around the pixel. Errors: x
  /// or y is not finite, a reach outside of 0 to kLargestSide.
  std::optional<Pick> pick(const GraphicsSystem& system, double x, double y,
                           const DrawOptions& options = {}, double reach = 0.0);

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

}  // namespace displayfile
