#pragma once

#include <cstdint>
#include <span>
#include <sstream>
#include <string>

#include "displayfile/graphics_system.h"
#include "displayfile/segments/display_file.h"

// Instructions as short text, to compare with the application's calls.

namespace displayfile::test {

struct Listing {
  std::ostringstream out;
  void fill(const FillStyle& s) {
    if (s.kind == FillStyle::Kind::hollow) {
      out << "hollow;";
    } else {
      out << "fill " << s.colour.r << ' ' << s.colour.g << ' ' << s.colour.b << ';';
    }
  }
  void line_style(const LineStyle& s) {
    out << (s.kind == LineStyle::Kind::none    ? "none;"
            : s.kind == LineStyle::Kind::solid ? "solid;"
                                               : "dashed;");
  }
  void pick(int id) { out << "pick " << id << ';'; }
  void point(const Point3& p) { out << p.x << ' ' << p.y << ' ' << p.z << ';'; }
  void move(const Point3& p) {
    out << "move ";
    point(p);
  }
  void line(const Point3& p) {
    out << "line ";
    point(p);
  }
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t>) {
    out << "polygon " << vertices.size() << ';';
    for (const Point3& p : vertices) point(p);
  }
};

/// A segment's instructions.
inline std::string listing(const GraphicsSystem& g, int name) {
  Listing l;
  g.display_file().segment(name).walk_drawn(l);
  return l.out.str();
}

}  // namespace displayfile::test
