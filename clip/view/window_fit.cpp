#include "clip/view/window_fit.h"

#include <cmath>

#include "clip/base/words.h"

namespace displayfile {

namespace {

constexpr Word<WindowFit> kWindowFits[] = {{WindowFit::widen, "widen"},
                                           {WindowFit::stretch, "stretch"}};

}  // namespace

WindowFit window_fit(std::string_view text) { return value_of(kWindowFits, text, "window fit is"); }
std::string_view name_of(WindowFit fit) { return word_of(kWindowFits, fit); }

double shape_of(const Rectangle& rectangle) {
  return (rectangle.x_max - rectangle.x_min) / (rectangle.y_max - rectangle.y_min);
}

double shape_in_picture(const Rectangle& viewport, double aspect) {
  return aspect * shape_of(viewport);
}

bool shapes_differ(double a, double b) {
  constexpr double kRounding = 1e-9;
  return !(std::abs(a / b - 1.0) <= kRounding);
}

Rectangle widened(const Rectangle& window, double shape) {
  if (!shapes_differ(shape_of(window), shape)) return window;
  const double width = window.x_max - window.x_min, height = window.y_max - window.y_min;
  Rectangle wide = window;
  if (width < shape * height) {
    const double middle = window.x_min + 0.5 * width, half = 0.5 * shape * height;
    wide.x_min = middle - half;
    wide.x_max = middle + half;
  } else {
    const double middle = window.y_min + 0.5 * height, half = 0.5 * width / shape;
    wide.y_min = middle - half;
    wide.y_max = middle + half;
  }
  return wide;
}

}  // namespace displayfile
