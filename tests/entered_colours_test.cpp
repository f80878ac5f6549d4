// A mesh's colours in a display file.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <span>
#include <sstream>
#include <string>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/display_file.h"
#include "tests/mesh_colours.h"

namespace displayfile {
namespace {

using test::kFourCorners;
using test::MeshColours;

// ---- Entering --------------------------------------------------------------------------

/// The colour of each polygon, lines between them where segments begin.
std::string fills_of(const DisplayFile& file) {
  struct Fills {
    std::string text, now = "unset";
    void fill(const FillStyle& style) {
      const Colour& c = style.colour;
      now =
          style.kind == FillStyle::Kind::hollow ? "hollow" : fmt::format("{} {} {}", c.r, c.g, c.b);
    }
    void line_style(const LineStyle&) {}
    void pick(int) {}
    void move(const Point3&) {}
    void line(const Point3&) {}
    void polygon(std::span<const Point3>, std::span<const std::int32_t>) { text += now + ";"; }
  };
  std::string text;
  for (const Segment& segment : file.segments()) {
    Fills fills;
    segment.walk_drawn(fills);
    text += fills.text + "|";
  }
  return text;
}

class EnteredColours : public MeshColours {
 protected:
  EnteredColours() {
    file("a.mtl", "newmtl r\nKd 1 0 0\nnewmtl g\nKd 0 1 0\n");
    path_ = file("a.obj", "mtllib a.mtl\n" + std::string(kFourCorners) +
                              "o mixed\nf 1 3 2\nusemtl r\nf 1 2 4\nusemtl g\nf 1 4 3\n"
                              "o green\nf 2 3 4\no \xC3\xA4 none\xFF\nusemtl none\nf 1 2 3\n");
  }

  /// In the default view, where all is seen, in light that is the same everywhere.
  std::string fills(const std::string& program, const MeshOptions& options = {}) const {
    GraphicsSystem system;
    replay("set-window -9 9 -9 9\nset-light 0 0 1 1\n" + program, "program", system);
    import_mesh(path_, system, options);
    system.open_segment(99);
    system.polygon_abs_3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    system.close_segment();
    return fills_of(system.display_file());
  }

  std::string path_;
};

TEST_F(EnteredColours, AreFillStylesOfFacesAlone) {
  EXPECT_EQ(fills(""), "0.87 0.85 0.81;1 0 0;0 1 0;|0 1 0;|0.87 0.85 0.81;|0.8 0.8 0.8;|");
  EXPECT_EQ(fills("set-shading gouraud\n"),
            "0.87 0.85 0.81;1 0 0;0 1 0;|0 1 0;|0.87 0.85 0.81;|0.8 0.8 0.8;|")
      << "with normals of vertices";
}

TEST_F(EnteredColours, GiveWayToTheProgramsFillStyleAndToTheOption) {
  EXPECT_EQ(fills("set-fill-style solid 0 0 1\n"), "0 0 1;0 0 1;0 0 1;|0 0 1;|0 0 1;|0 0 1;|");
  EXPECT_EQ(fills("set-fill-style hollow\n"), "hollow;hollow;hollow;|hollow;|hollow;|hollow;|");
  const MeshOptions purple{.camera = {}, .colour = Colour(0.5, 0, 0.5)};
  EXPECT_EQ(fills("", purple),
            "0.5 0 0.5;0.5 0 0.5;0.5 0 0.5;|0.5 0 0.5;|0.5 0 0.5;|0.8 0.8 0.8;|");
  EXPECT_EQ(fills("set-fill-style solid 0 0 1\n", purple),
            "0.5 0 0.5;0.5 0 0.5;0.5 0 0.5;|0.5 0 0.5;|0.5 0 0.5;|0 0 1;|");
}

/// The defaults that a bare mesh sets do not count as a program's settings.
TEST_F(EnteredColours, OfASecondMeshHoldToo) {
  GraphicsSystem system;
  import_mesh(path_, system);
  EXPECT_FALSE(system.explicit_settings().contains(Setting::fill_style));
  import_mesh(path_, system);
  EXPECT_FALSE(system.explicit_settings().contains(Setting::fill_style));
  const std::string twice = fills_of(system.display_file());
  EXPECT_EQ(twice.substr(0, twice.size() / 2), twice.substr(twice.size() / 2)) << twice;
  system.set_fill_style({FillStyle::Kind::hollow});
  EXPECT_TRUE(system.explicit_settings().contains(Setting::fill_style));
}

TEST_F(EnteredColours, AreRecordedWithTheNamesOfObjects) {
  for (const MeshOptions& options :
       {MeshOptions{}, MeshOptions{.camera = {}, .colour = Colour(0.5, 0.25, 0)}}) {
    for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
      GraphicsSystem imported, replayed;
      std::ostringstream program;
      Recorder recorder(program);
      imported.set_recorder(&recorder);
      imported.set_shading(shading);
      import_mesh(path_, imported, options);
      replay(program.str(), "recorded", replayed);
      EXPECT_EQ(dump(imported.display_file()), dump(replayed.display_file()));
      EXPECT_NE(program.str().find("# mixed\nopen-segment 1\n"), std::string::npos);
      EXPECT_NE(program.str().find("# green\nopen-segment 2\n"), std::string::npos);
      EXPECT_NE(program.str().find("# \xC3\xA4 none?\nopen-segment 3\n"), std::string::npos);
      EXPECT_EQ(imported.looks().attributes.fill, replayed.looks().attributes.fill);
    }
  }
}

TEST_F(EnteredColours, ThatAreBadChangeNothing) {
  for (const Colour& colour : {Colour(1.5, 0, 0), Colour(0, -1, 0), Colour(0, 0, std::nan(""))}) {
    GraphicsSystem system;
    EXPECT_THROW(import_mesh(path_, system, {.camera = {}, .colour = colour}), Error);
    EXPECT_FALSE(system.explicit_settings().contains_view());
    EXPECT_TRUE(system.display_file().segments().empty());
    system.set_window(-9, 9, -9, 9);
    EXPECT_THROW(enter_mesh(read_mesh(path_), system, 1, {.camera = {}, .colour = colour}), Error);
    EXPECT_TRUE(system.display_file().segments().empty());
  }
}

}  // namespace
}  // namespace displayfile
