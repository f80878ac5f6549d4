#pragma once

#include "displayfile/graphics_system.h"

namespace displayfile::test {

/// A system whose device coordinates are its world coordinates, depth too: nearer is larger.
inline GraphicsSystem unit_square() {
  GraphicsSystem g;
  g.set_window(0, 1, 0, 1);
  g.set_view_depth(-1, 0);
  return g;
}

inline GraphicsSystem unit_square_without_lines() {
  GraphicsSystem g = unit_square();
  g.set_line_style({LineStyle::Kind::none});
  return g;
}

}  // namespace displayfile::test
