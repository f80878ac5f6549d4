#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "displayfile/files.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/text/dump_compare.h"
#include "hidden/triangulation.h"
#include "programs/bench/temporary_folder.h"
#include "tests/bench/worst_scenes.h"

namespace displayfile::bench {

namespace {

// Reading

Cost replayed(const std::string& text) {
  return cost_of([&] {
    GraphicsSystem g;
    replay(text, "worst.draw", g);
    return text.size();
  });
}

/// n lines between the opening and the closing of a segment.
template <class Line>
std::string program(std::size_t n, const Line& line) {
  std::string text = "open-segment 1\n";
  for (std::size_t k = 0; k < n; ++k) text += line(k);
  return text + "close-segment\n";
}

Cost read_polygons(std::size_t n) {
  return replayed(program(n, [](std::size_t k) {
    return fmt::format("polygon-abs-3 0 0 {0} 1 0 {0} 1 1 {0}\n", 1.0 / real(k + 2));
  }));
}

Cost read_styles(std::size_t n) {
  return replayed(program(n, [n](std::size_t k) {
    return fmt::format("set-fill-style solid {} 0 0\nset-pick-id {}\nline-abs-2 0 0\n",
                       real(k) / real(n), k);
  }));
}

Cost read_one_polygon(std::size_t n) {
  std::string text = "open-segment 1\npolygon-abs-3";
  for (const Point3& p : comb(n, 0.5)) text += fmt::format(" {} {} {}", p.x, p.y, p.z);
  return replayed(text + "\nclose-segment\n");
}

Cost read_comments(std::size_t n) { return replayed(std::string(n, '#') + "\n"); }

/// On top of as many as may be saved, but one.
Cost read_saved_transformations(std::size_t n) {
  std::string text;
  for (int k = 0; k < 1023; ++k) text += "save-transformation-3\nrotate-z-3 1\n";
  for (std::size_t k = 0; k < n; ++k) {
    text += "save-transformation-3\nrotate-z-3 1\nrestore-transformation-3\n";
  }
  for (int k = 0; k < 1023; ++k) text += "restore-transformation-3\n";
  return replayed(text);
}

Cost read_mesh_of(const std::string& name, const std::string& text) {
  const TemporaryFolder folder;
  std::ofstream(folder.file(name), std::ios::binary) << text;
  return cost_of([&] { return read_mesh(folder.file(name)).vertices.size() + text.size(); });
}

std::string obj(std::size_t n, const auto& before_face) {
  std::string text;
  for (std::size_t k = 0; k < n; ++k) {
    text += fmt::format("v {0} 0 0\nv {0} 1 0\nv {0} 0 1\n", k);
    text += before_face(k) + "f -3 -2 -1\n";
  }
  return text;
}

Cost read_obj(std::size_t n) {
  return read_mesh_of("worst.obj", obj(n, [](std::size_t) { return std::string(); }));
}
Cost read_obj_names(std::size_t n) {
  return read_mesh_of("worst.obj", obj(n, [](std::size_t k) {
                        return fmt::format("o object {0}\ng group {0}\nusemtl material {0}\n", k);
                      }));
}
Cost read_obj_face(std::size_t n) {
  const Polygon face = comb(n, 0.5);
  std::string text;
  for (const Point3& p : face) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  text += "f";
  for (std::size_t k = 1; k <= face.size(); ++k) text += fmt::format(" {}", k);
  return read_mesh_of("worst.obj", text + "\n");
}

Cost read_off(std::size_t n) {
  std::string text = fmt::format("OFF\n{} {} 0\n", 3 * n, n);
  for (std::size_t k = 0; k < n; ++k) text += fmt::format("{0} 0 0\n{0} 1 0\n{0} 0 1\n", k);
  for (std::size_t k = 0; k < n; ++k)
    text += fmt::format("3 {} {} {}\n", 3 * k, 3 * k + 1, 3 * k + 2);
  return read_mesh_of("worst.off", text);
}

Cost read_stl(std::size_t n) {
  std::string text = "solid worst\n";
  for (std::size_t k = 0; k < n; ++k) {
    text += fmt::format(
        "facet normal 0 0 1\nouter loop\nvertex {0} 0 0\nvertex {0} 1 0\nvertex {0} 0 "
        "1\nendloop\nendfacet\n",
        k);
  }
  return read_mesh_of("worst.stl", text + "endsolid worst\n");
}

/// Elements without properties, each of as many as may be.
Cost read_ply_elements(std::size_t n) {
  std::string text = "ply\nformat ascii 1.0\n";
  for (std::size_t k = 0; k < n; ++k) text += fmt::format("element e{} {}\n", k, n);
  text +=
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  return read_mesh_of("worst.ply", text + std::string(n, '\n'));
}

// Entering

std::vector<Polygon> bent(const test::Outline& outline) { return {in_square(outline, 0.5, 0.1)}; }

Cost triangulated(const test::Outline& outline) {
  const Polygon polygon = bent(outline).front();
  return cost_of([&] { return Triangulation().triangulate(polygon).size(); });
}
Cost triangulate_comb(std::size_t n) { return triangulated(test::comb_outline(n, 1, false)); }
Cost triangulate_spiral(std::size_t n) { return triangulated(test::spiral_outline(n)); }
Cost triangulate_star(std::size_t n) { return triangulated(test::star_outline(n, 1)); }
Cost triangulate_tree(std::size_t n) {
  return triangulated(test::tree_outline(static_cast<std::size_t>(std::sqrt(real(n) / 2)), 1));
}
Cost triangulate_crossing(std::size_t n) {
  const Polygon star = crossing_star(n, 0.5);
  return cost_of([&] { return Triangulation().triangulate(star).size(); });
}
Cost triangulate_tangle(std::size_t n) {
  std::mt19937_64 random(1);
  Polygon tangle;
  for (std::size_t k = 0; k < n; ++k) {
    tangle.emplace_back(random() % 1000, random() % 1000, random() % 1000);
  }
  return cost_of([&] { return Triangulation().triangulate(tangle).size(); });
}

Cost clip_comb(std::size_t n) {
  Polygon teeth = comb(n, 0.5);
  for (Point3& p : teeth) p = Point3(1.5 * p.x - 0.25, 1.5 * p.y - 0.25, p.y);
  return cost_of([&] { return entered_polygons({teeth}).display_file().bytes(); });
}

// Segments

/// With one line each.
void open_segments(GraphicsSystem& g, std::size_t n) {
  for (std::size_t k = 1; k <= n; ++k) {
    g.open_segment(static_cast<int>(k));
    g.line_abs_3(0.5, 0.5, 0.5);
    g.close_segment();
  }
}

template <class Work>
Cost with_segments(std::size_t n, const Work& work) {
  GraphicsSystem g;
  begin(g);
  open_segments(g, n);
  return cost_of([&] {
    for (std::size_t k = 1; k <= n; ++k) work(g, static_cast<int>(k));
    return n;
  });
}

Cost open_many(std::size_t n) {
  return cost_of([&] {
    GraphicsSystem g;
    begin(g);
    open_segments(g, n);
    return n;
  });
}
Cost delete_oldest(std::size_t n) {
  return with_segments(n, [](GraphicsSystem& g, int k) { g.delete_segment(k); });
}
/// From the middle outwards: as many are before each as after it.
Cost delete_middle(std::size_t n) {
  return with_segments(n, [middle = static_cast<int>(n / 2)](GraphicsSystem& g, int k) {
    g.delete_segment(k % 2 == 0 ? middle + k / 2 : middle - k / 2);
  });
}
Cost rename_many(std::size_t n) {
  return with_segments(
      n, [n](GraphicsSystem& g, int k) { g.rename_segment(k, k + static_cast<int>(n)); });
}
Cost move_many(std::size_t n) {
  return with_segments(n, [](GraphicsSystem& g, int k) {
    g.set_image_translation(k, 0.1, 0.1);
    g.set_visibility(k, false);
  });
}
/// As an animation does: the oldest is deleted, and a new one opened.
Cost replace_many(std::size_t n) {
  return with_segments(n, [n](GraphicsSystem& g, int k) {
    g.delete_segment(k);
    g.open_segment(k + static_cast<int>(n));
    g.close_segment();
  });
}

// Writing

Cost record_many(std::size_t n) {
  return cost_of([&] {
    std::ostringstream out;
    Recorder recorder(out);
    GraphicsSystem g;
    begin(g);
    g.set_recorder(&recorder);
    open_segments(g, n);
    return out.str().size();
  });
}

Cost dump_polygons(std::size_t n) {
  const GraphicsSystem g = entered_polygons(stack(n));
  return cost_of([&] { return dump(g.display_file()).size(); });
}
Cost compare_dumps(std::size_t n) {
  const std::string text = dump(entered_polygons(stack(n)).display_file());
  return cost_of([&] { return first_difference(text, text).has_value() ? 0 : text.size(); });
}

Cost written(const GraphicsSystem& g, const std::string& format, HiddenMethod method,
             const std::optional<Pens>& pens = std::nullopt) {
  const TemporaryFolder folder;
  const std::string file = folder.file("worst." + format);
  DrawOptions options;
  options.hidden = method;
  options.pens = pens;
  return cost_of([&] {
    draw(g, file, options);
    return std::filesystem::file_size(file);
  });
}

/// n small squares side by side, each in a segment of its own, of a colour of its own.
GraphicsSystem squares(std::size_t n, bool with_lines = false) {
  GraphicsSystem g;
  begin(g);
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(real(n))));
  for (std::size_t k = 0; k < n; ++k) {
    const double step = 0.98 / real(side), x = 0.01 + step * real(k % side),
                 y = 0.01 + step * real(k / side);
    const Colour colour(real(k % 256) / 255, real(k / 256 % 256) / 255, real(k / 65536) / 255);
    g.set_fill_style({.colour = colour});
    if (with_lines) g.set_line_style({.colour = colour});
    g.open_segment(static_cast<int>(k) + 1);
    g.polygon_abs_3(
        {{x, y, 0.5}, {x + step, y, 0.5}, {x + step, y + step, 0.5}, {x, y + step, 0.5}});
    g.close_segment();
  }
  return g;
}

Cost svg_segments(std::size_t n) { return written(squares(n), "svg", HiddenMethod::none); }
Cost svg_map_segments(std::size_t n) { return written(squares(n), "svg", HiddenMethod::map); }
Cost pdf_segments(std::size_t n) { return written(squares(n), "pdf", HiddenMethod::none); }
Cost svg_map_grid(std::size_t n) {
  return written(entered_polygons(grid(n)), "svg", HiddenMethod::map);
}
Cost pens_of_colours(std::size_t n) {
  return written(squares(n, true), "svg", HiddenMethod::none, Pens{});
}
Cost pens_of_one(std::size_t n) {
  return written(entered_polygons(needles(n), true), "svg", HiddenMethod::none, Pens{});
}

Cost svg_texts(std::size_t n) {
  GraphicsSystem g;
  begin(g);
  g.open_segment(1);
  for (std::size_t k = 0; k < n; ++k) {
    g.move_abs_3(real(k) / real(n), 0.5, 0.5);
    g.text("text");
  }
  g.close_segment();
  return written(g, "svg", HiddenMethod::z_buffer);
}

constexpr auto kCases = std::to_array<WorstCase>({
    {"read a program", "n polygons", 4000, "bytes", "its length", read_polygons},
    {"read a program", "n styles and pick identifiers", 2000, "bytes", "its length", read_styles},
    {"read a program", "one polygon of n sides", 4000, "bytes", "its length", read_one_polygon},
    {"read a program", "a comment of n characters", 1000000, "bytes", "its length", read_comments},
    {"read a program", "n transformations saved on top of 1023", 4000, "bytes", "its length",
     read_saved_transformations},
    {"read OBJ", "n triangles that share nothing", 4000, "bytes", "its length", read_obj},
    {"read OBJ", "n objects, groups and materials", 2000, "bytes", "its length", read_obj_names},
    {"read OBJ", "one face of n corners", 4000, "bytes", "its length", read_obj_face},
    {"read OFF", "n triangles that share nothing", 4000, "bytes", "its length", read_off},
    {"read STL", "n triangles that share nothing", 4000, "bytes", "its length", read_stl},
    {"read PLY", "n elements without properties", 4000, "bytes", "its length", read_ply_elements},
    {"triangulate", "a bent comb of n corners", 2000, "triangles", "n log n", triangulate_comb},
    {"triangulate", "a bent spiral of n corners", 2000, "triangles", "n log n", triangulate_spiral},
    {"triangulate", "a bent star of n corners", 2000, "triangles", "n log n", triangulate_star},
    {"triangulate", "the bent outline of a tree, n corners", 2000, "triangles", "n log n",
     triangulate_tree},
    {"triangulate", "a star whose n sides cross each other", 2000, "triangles",
     "256 n corners looked at", triangulate_crossing},
    {"triangulate", "n points at random", 2000, "triangles", "256 n corners looked at",
     triangulate_tangle},
    {"clip", "a comb whose n/2 teeth cross the window", 4000, "bytes", "n for each plane",
     clip_comb},
    {"open segments", "n, each of one line", 4000, "segments", "n", open_many},
    {"delete segments", "n, the oldest first", 1000, "segments", "n", delete_oldest},
    {"delete segments", "n, from the middle", 1000, "segments",
     "those on one side of it move up in the list, n^2 / 4 moves", delete_middle},
    {"replace segments", "n, the oldest deleted and a new one opened", 1000, "segments", "n",
     replace_many},
    {"rename segments", "n", 4000, "segments", "n", rename_many},
    {"move and hide segments", "n", 4000, "segments", "n", move_many},
    {"record", "n segments of one line", 4000, "bytes", "its length", record_many},
    {"dump", "n polygons", 4000, "bytes", "its length", dump_polygons},
    {"compare dumps", "n polygons", 4000, "bytes", "its length", compare_dumps},
    {"write SVG", "n segments of n colours", 1000, "bytes", "its length", svg_segments},
    {"write SVG, map", "n segments of n colours", 1000, "bytes", "its length", svg_map_segments},
    {"write SVG, map", "n bars that cross", 32, "bytes", "the map: n^2 / 4 pieces", svg_map_grid},
    {"write SVG", "n texts", 1000, "bytes", "its length", svg_texts},
    {"write PDF", "n segments of n colours, a layer each", 1000, "bytes", "its length",
     pdf_segments},
    {"pens", "n colours", 500, "bytes", "its length", pens_of_colours},
    {"pens", "3 n strokes of one pen that cross each other", 500, "bytes",
     "n^2 crossings of lines that lie side by side", pens_of_one},
});

}  // namespace

std::span<const WorstCase> worst_of_files() { return kCases; }

}  // namespace displayfile::bench
