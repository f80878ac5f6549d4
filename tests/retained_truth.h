#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/segments/retained_scene.h"
#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "interp/truth/truth.h"

// Views of a retained scene, compared with the truth of each view.

namespace displayfile::test {

/// A scene as the application drew it and as it was retained.
struct Retained {
  RetainedScene scene;
  GraphicsSystem system;
  Retained() { system.retain(&scene); }
  Retained(const Retained&) = delete;
  Retained& operator=(const Retained&) = delete;
};

/// A quadrilateral with a vertex off its plane by less than the tolerance, from so near that this
/// is a fifth of the picture.
inline void draw_vertex_off_its_plane(GraphicsSystem& g) {
  g.set_parallel({0.0, 1.0, 1.0});
  g.set_window(-0.500002, -0.499998, 0.499998, 0.500002);
  g.open_segment(1);
  g.polygon_abs_3({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-0.5, 0.5, 8e-7}});
  g.close_segment();
}

/// All its segments were entered in one view, and there are some.
inline bool is_of_one_view(const RetainedScene& scene) {
  for (const auto& segment : scene.segments()) {
    if (!(segment.view == scene.segments().front().view)) return false;
  }
  return !scene.segments().empty();
}

/// These act after viewing, which a retained scene does not see.
inline bool has_image_transformations(const DisplayFile& file) {
  return std::ranges::any_of(file.segments(),
                             [](const Segment& segment) { return !segment.image.is_identity(); });
}

inline Picture drawn(const DisplayFile& file, int size) {
  RasterRequest request;
  request.width = request.height = size;
  request.ids = request.sorted = true;
  return draw_with_software(file, request);
}

struct Pixel {
  PixelCentre centre;
  std::int32_t drawn, truth;
};
inline std::string text_of(const Pixel& pixel) {
  std::ostringstream out;
  out << "pixel " << pixel.centre.column << "," << pixel.centre.row << ": " << pixel.drawn
      << " was drawn in place of " << pixel.truth;
  return out.str();
}

/// A picture compared with the truth of the same view, whole polygons in order of entry.
struct Judged {
  std::vector<Pixel> wrong;
  std::size_t pixels = 0;
  std::size_t undecided = 0;  ///< not decided by the order of the tree
};
inline Judged judged(const DisplayFile& file, int size) {
  const Picture picture = drawn(file, size);
  const std::vector<std::int32_t> right = truth(file, size, size, false).ids;
  Judged judged{{}, right.size(), picture.undecided_centres};
  for (int i = 0; i < size * size; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (picture.ids[k] == right[k]) continue;
    judged.wrong.push_back(
        {{i % size, size - 1 - i / size, {size, size}}, picture.ids[k], right[k]});
  }
  return judged;
}

/// Two segments with styles, outlines, lines, a light, back faces and a polygon that is not flat.
inline void enter_two_segments(GraphicsSystem& g) {
  g.set_perspective({0.4, 0.7, 4.0});
  g.set_light({0.3, 1.0, 0.7}, 0.2);
  g.open_segment(4);
  g.set_fill_style({FillStyle::Kind::solid, {0.9, 0.4, 0.2}});
  g.polygon_abs_3({{-0.5, -0.5, 0.2}, {0.6, -0.4, -0.3}, {0.1, 0.7, 0.1}});
  g.polygon_abs_3({{-0.5, -0.5, 0.2}, {0.1, 0.7, 0.1}, {0.6, -0.4, -0.3}});
  g.set_line_style({LineStyle::Kind::dashed, {0, 0, 1}, 2.0, 5.0, 3.0});
  g.move_abs_3(-0.8, 0.0, -0.5);
  g.line_abs_3(0.8, 0.1, 0.5);
  g.polygon_abs_3({{-0.6, -0.6, 0.0}, {0.6, -0.6, 0.1}, {0.6, 0.6, 0.0}, {-0.6, 0.6, 0.1}});
  g.close_segment();
  g.create_transformation_3();
  g.rotate_y_3(40.0);
  g.open_segment(2);
  g.set_back_face_removal(true);
  g.set_pick_id(70);
  g.set_fill_style({FillStyle::Kind::hollow});
  g.polygon_abs_3({{-0.7, 0.1, 0.4}, {0.7, 0.0, 0.4}, {0.0, 0.8, -0.4}});
  g.set_line_style({LineStyle::Kind::none});
  g.polygon_abs_3({{-0.3, 0.1, 0.4}, {0.7, 0.0, 0.4}, {0.0, 0.8, -0.4}});  // draws nothing
  g.set_fill_style({FillStyle::Kind::solid, {0.2, 0.4, 0.9}});
  g.polygon_abs_3({{-0.9, -0.1, 0.3}, {0.9, 0.0, 0.3}, {0.0, 0.3, -0.3}});
  g.polygon_abs_3({{0.0, 0.3, -0.3}, {0.9, 0.0, 0.3}, {-0.9, -0.1, 0.3}});  // a back face
  g.close_segment();
}

inline std::string entered_text(DisplayFile file) {
  file.set_sorted(nullptr);
  for (const Segment& segment : file.segments()) file.segment(segment.name()).set_sorted(nullptr);
  std::ostringstream out;
  dump(file, out);
  return out.str();
}

}  // namespace displayfile::test
