#pragma once

#include <cstdint>
#include <functional>

#include "interp/vector/disjoint_fills.h"

struct _cairo;

namespace displayfile {

/// Sets the colour of the next drawing operations, as from pixel_of.
void set_cairo_colour(_cairo* context, std::uint32_t pixel);

/// The same for a region's paint.
void set_cairo_paint(_cairo* context, const FillPaint& paint);

/// Paints a figure into a document with groups and masks, such as PDF. The fill rule is even-odd,
/// line joins are round, and there are no dashes.
void paint_cairo_figure(_cairo* context, const Figure& figure);

/// The same into a document without them, such as EPS: with tents in place of traps. Calls
/// `before`, if not empty, before each drawing operation, with the segment of the region.
void paint_cairo_figure_without_masks(_cairo* context, const Figure& figure,
                                      const std::function<void(int segment)>& before = {});

}  // namespace displayfile
