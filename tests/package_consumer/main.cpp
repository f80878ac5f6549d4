#include "displayfile/graphics_system.h"
#include "interp/draw.h"

int main(int, char** argv) {
  displayfile::GraphicsSystem g;
  g.open_segment(1);
  g.polygon_abs_3({{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 0}});
  g.close_segment();
  displayfile::draw(g, argv[1]);
}
