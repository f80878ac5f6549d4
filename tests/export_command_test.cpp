// `displayfile export`.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/command_fixture.h"

namespace {

using Corner = std::array<double, 3>;
using Facet = std::array<Corner, 3>;

double volume(const std::vector<Facet>& facets) {
  double six = 0.0;
  for (const auto& [a, b, c] : facets) {
    six += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return six / 6.0;
}

/// The facets' area, whichever way they face: a lid over a hole has one, and no volume.
double area_of_facets(const std::vector<Facet>& facets) {
  double sum = 0.0;
  for (const auto& [a, b, c] : facets) {
    const Corner u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const Corner v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    sum += std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                      u[0] * v[1] - u[1] * v[0]) /
           2.0;
  }
  return sum;
}

/// True if each side is used as often in one direction as in the other.
bool is_closed(const std::vector<Facet>& facets) {
  std::map<std::pair<Corner, Corner>, int> sides;
  for (const Facet& facet : facets) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner &from = facet[k], &to = facet[(k + 1) % 3];
      if (from == to) return false;
      sides[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  return std::ranges::all_of(sides, [](const auto& side) { return side.second == 0; });
}

/// Calls of polygon-abs-3 for the faces of a box, first the lower one; of an inward one they are
/// reversed.
std::string faces_of_box(const std::array<double, 6>& box, bool is_inward = false,
                         std::size_t first = 0, std::size_t end = 6) {
  constexpr std::array<std::array<std::size_t, 4>, 6> kFaces{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}}};
  std::string text;
  for (std::size_t i = first; i < end; ++i) {
    text += "polygon-abs-3";
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t corner = kFaces[i][is_inward ? 3 - k : k];
      text += fmt::format("  {} {} {}", box[corner & 1], box[2 + (corner >> 1 & 1)],
                          box[4 + (corner >> 2)]);
    }
    text += "\n";
  }
  return text;
}

std::string segment(int name, const std::string& contents) {
  return fmt::format("open-segment {}\n{}close-segment\n", name, contents);
}

class ExportCommand : public Command {
 protected:
  ExportCommand() {
    write("box.draw",
          "open-segment 1\nset-fill-style solid 1 0 0\nbox-3 0 2  0 3  0 4\nclose-segment\n");
    // A box whose lower face has a corner in the middle of a side of the front face.
    write("t.draw",
          "open-segment 7\npolygon-abs-3 0 0 0  0 1 0  0.5 1 0  0.5 0 0\n"
          "polygon-abs-3 0.5 0 0  0.5 1 0  1 1 0  1 0 0\npolygon-abs-3 0 0 1  1 0 1  1 1 1  0 1 1\n"
          "polygon-abs-3 0 0 0  1 0 0  1 0 1  0 0 1\npolygon-abs-3 0 1 0  0 1 1  1 1 1  1 1 0\n"
          "polygon-abs-3 0 0 0  0 0 1  0 1 1  0 1 0\npolygon-abs-3 1 0 0  1 1 0  1 1 1  1 0 1\n"
          "close-segment\n");
  }

  void exported(const std::string& arguments) {
    ASSERT_EQ(run("export " + arguments), 0) << err_;
    EXPECT_EQ(out_, "");
  }

  std::vector<Facet> stl(const std::string& file) {
    const std::string data = read(folder_ / file);
    std::vector<Facet> facets((data.size() - 84) / 50);
    std::uint32_t announced = 0;
    std::memcpy(&announced, &data[80], 4);
    EXPECT_EQ(announced, facets.size());
    EXPECT_EQ(data.size(), 84 + 50 * facets.size());
    EXPECT_NE(data.substr(0, 5), "solid");
    for (std::size_t i = 0; i < facets.size(); ++i) {
      std::array<float, 12> numbers;
      std::memcpy(numbers.data(), &data[84 + 50 * i], sizeof numbers);
      for (std::size_t k = 0; k < 9; ++k)
        facets[i][k / 3][k % 3] = static_cast<double>(numbers[3 + k]);
      EXPECT_NEAR(std::hypot(numbers[0], numbers[1], numbers[2]), 1.0, 1e-6);
    }
    return facets;
  }

  std::vector<Facet> obj(const std::string& file) {
    std::istringstream text(read(folder_ / file));
    std::vector<Corner> corners;
    std::vector<Facet> facets;
    for (std::string line, word; std::getline(text, line);) {
      std::istringstream words(line);
      words >> word;
      if (word == "v") {
        Corner& c = corners.emplace_back();
        words >> c[0] >> c[1] >> c[2];
      } else if (word == "f") {
        std::array<std::size_t, 3> i{};
        words >> i[0] >> i[1] >> i[2];
        facets.push_back({corners.at(i[0] - 1), corners.at(i[1] - 1), corners.at(i[2] - 1)});
      }
    }
    return facets;
  }
};

TEST_F(ExportCommand, ABoxHasItsVolumeInEachFormat) {
  exported("box.draw -o a.stl");
  EXPECT_EQ(err_, "");
  EXPECT_EQ(stl("a.stl").size(), 12u);
  EXPECT_TRUE(is_closed(stl("a.stl")));
  EXPECT_EQ(volume(stl("a.stl")), 24.0);
  exported("box.draw -o a.obj");
  EXPECT_TRUE(is_closed(obj("a.obj")));
  EXPECT_EQ(volume(obj("a.obj")), 24.0);
  exported("box.draw -o a.ply");
  exported("a.ply -o b.obj");
  EXPECT_EQ(volume(obj("b.obj")), 24.0);
  // Equal inputs are equal files.
  exported("box.draw -o b.stl");
  EXPECT_EQ(read(folder_ / "a.stl"), read(folder_ / "b.stl"));
}

TEST_F(ExportCommand, ThreeMfIsReadBack) {
  if (!can_run("export box.draw -o a.3mf", "minizip")) GTEST_SKIP() << err_;
  EXPECT_EQ(err_, "");
  exported("box.draw -o b.3mf");
  EXPECT_EQ(read(folder_ / "a.3mf"), read(folder_ / "b.3mf"));
  if (!can_run("export a.3mf -o c.obj", "Assimp")) GTEST_SKIP() << err_;
  EXPECT_NEAR(volume(obj("c.obj")), 24.0, 1e-5);
  EXPECT_TRUE(is_closed(obj("c.obj")));
  EXPECT_NE(read(folder_ / "c.mtl").find("Kd 1 0 0"), std::string::npos) << read(folder_ / "c.mtl");
}

/// A T-vertex becomes a corner of the face whose side it is on.
TEST_F(ExportCommand, VerticesOnSidesBecomeCorners) {
  for (const std::string file : {"a.stl", "a.obj"}) {
    exported("t.draw -o " + file);
    EXPECT_EQ(err_, "");
    const std::vector<Facet> facets = file == "a.stl" ? stl(file) : obj(file);
    EXPECT_TRUE(is_closed(facets)) << file;
    EXPECT_EQ(facets.size(), 16u);  // 14, and one more for each of two vertices
    EXPECT_DOUBLE_EQ(volume(facets), 1.0);
    for (const auto& [a, b, c] : facets) {  // none is without area
      const Corner u{b[0] - a[0], b[1] - a[1], b[2] - a[2]},
          v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
      EXPECT_GT(std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                           u[0] * v[1] - u[1] * v[0]),
                0.1);
    }
  }
}

TEST_F(ExportCommand, CombinedSolidsAreClosed) {
  write("drilled.draw",
        "open-segment 1\nbegin-solid difference\nbox-3 0 2  0 2  0 1\ncylinder-3 1 1 -1  0.5 3 24\n"
        "end-solid\nclose-segment\n");
  if (!can_run("export drilled.draw -o a.obj", "CGAL")) GTEST_SKIP() << err_;
  EXPECT_EQ(err_, "");
  const std::vector<Facet> facets = obj("a.obj");
  EXPECT_TRUE(is_closed(facets));
  const double hole = 12.0 * 0.25 * std::sin(2.0 * 3.14159265358979 / 24.0);
  EXPECT_NEAR(volume(facets), 4.0 - hole, 1e-12);
  exported("drilled.draw -o a.stl");
  EXPECT_TRUE(is_closed(stl("a.stl")));
  EXPECT_NEAR(volume(stl("a.stl")), 4.0 - hole, 1e-6);
}

/// Faces in two parts and faces with holes have no lids.
TEST_F(ExportCommand, HolesAndGapsOfFacesAreOpen) {
  const std::string box = "difference\nbox-3 0 4  0 2  0 2\n";
  const std::tuple<std::string, double, double> solids[] = {
      {box + "box-3 1.5 2.5  0.5 1.5  -1 3\n", 46.0, 14.0},
      {box + "box-3 1.5 2.5  -1 3  1 3\n", 42.0, 14.0},
      {box + "box-3 0.5 1  0.5 1.5  -1 3\nbox-3 3 3.5  0.5 1.5  -1 3\n", 50.0, 14.0},
      {"union\nbox-3 0 4  0 2  0 2\nbox-3 1 2  -1 3  0.5 1\n", 46.0, 17.0},
  };
  for (const auto& [solid, area, bulk] : solids) {
    SCOPED_TRACE(solid);
    write("s.draw", "open-segment 1\nbegin-solid " + solid + "end-solid\nclose-segment\n");
    if (!can_run("export s.draw -o s.stl", "CGAL")) GTEST_SKIP() << err_;
    const std::vector<Facet> facets = stl("s.stl");
    EXPECT_TRUE(is_closed(facets));
    EXPECT_NEAR(area_of_facets(facets), area, 1e-5);
    EXPECT_NEAR(volume(facets), bulk, 1e-5);
  }
}

/// Turned, faces of two parts that are flush are apart by rounding: loops of a face then lie along
/// each other, on either side, or have no area.
TEST_F(ExportCommand, FlushPartsThatAreTurnedAreClosed) {
  const std::tuple<std::string, double> solids[] = {
      {"box-3 5 6 4 6 2 5\nbox-3 2 6 5 6 0 5\n", 23.0},
      {"box-3 0 3 5 6 2 4\nbox-3 2 4 4 5 2 5\nbox-3 1 6 3 6 2 5\n", 47.0},
  };
  for (const auto& [boxes, bulk] : solids) {
    SCOPED_TRACE(boxes);
    write("s.draw",
          "rotate-x-3 37\nrotate-y-3 11\ntranslate-3 0.1 0.2 0.3\nopen-segment 1\n"
          "begin-solid union\n" +
              boxes + "end-solid\nclose-segment\n");
    if (!can_run("export s.draw -o s.obj", "CGAL")) GTEST_SKIP() << err_;
    EXPECT_EQ(err_, "");
    EXPECT_TRUE(is_closed(obj("s.obj")));
    EXPECT_NEAR(volume(obj("s.obj")), bulk, 1e-9);
  }
}

TEST_F(ExportCommand, NamesAndColoursAreKept) {
  write("two.obj",
        "mtllib two.mtl\no lid\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl red\nf 1 3 2\nf 1 2 "
        "4\nf 2 3 4\n"
        "f 1 4 3\no base & <1>\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\nusemtl odd\nf 5 7 6\nf 5 6 "
        "8\nf 6 7 8\nusemtl red\nf 5 8 7\n");
  write("two.mtl", "newmtl red\nKd 1 0 0\nnewmtl odd\nKd 0.1 0.2 0.3\n");
  exported("two.obj -o out.obj");
  EXPECT_EQ(err_, "");
  const std::string text = read(folder_ / "out.obj");
  EXPECT_NE(text.find("mtllib out.mtl\no lid\n"), text.npos) << text;
  EXPECT_NE(text.find("\no base & <1>\n"), text.npos) << text;
  EXPECT_EQ(read(folder_ / "out.mtl"),
            "newmtl colour-1\nKd 1 0 0\nnewmtl colour-2\nKd 0.1 0.2 0.3\n");
  const auto lines_of = [&](const std::string& program) {
    EXPECT_EQ(run("import " + program + " -o p.draw --no-fit"), 0) << err_;
    std::istringstream lines(read(folder_ / "p.draw"));
    std::set<std::string> fills;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("set-fill-style")) fills.insert(line);
    }
    return fills;
  };
  EXPECT_EQ(lines_of("out.obj"), lines_of("two.obj"));
  exported("two.obj -o out.ply");
  EXPECT_EQ(lines_of("out.ply").size(), lines_of("two.obj").size());
  if (!can_run("export two.obj -o out.3mf", "minizip")) return;
  if (!can_run("export out.3mf -o back.obj", "Assimp")) return;
  // Assimp drops names of 3MF, and has one colour for an object.
  const std::string back = read(folder_ / "back.obj");
  EXPECT_NE(back.find("\no "), back.rfind("\no ")) << back;
}

TEST_F(ExportCommand, TitlesAreNames) {
  write("titled.draw",
        "open-segment 1\nbox-3 0 2  0 3  0 4\nclose-segment\nopen-segment 2\nbox-3 5 6  0 3  0 4\n"
        "close-segment\nset-segment-title 1 \"Cover plate\"\n");
  exported("titled.draw -o titled.obj");
  const std::string obj = read(folder_ / "titled.obj");
  EXPECT_NE(obj.find("\no Cover plate\n"), obj.npos);
  EXPECT_NE(obj.find("\no segment 2\n"), obj.npos);
  EXPECT_EQ(obj.find("segment 1"), obj.npos);
}

/// Vertices 1e-9 apart at 1 are one in single precision; the triangle between them is left out.
TEST_F(ExportCommand, SinglePrecisionSaysWhatItMerges) {
  write("near.obj",
        "v 0 0 0\nv 1 0 0\nv 1.000000001 0 0\nv 0 1 0\nv 0 0 1\n"
        "f 1 4 3 2\nf 1 2 3 5\nf 3 4 5\nf 1 5 4\n");
  exported("near.obj -o a.stl");
  EXPECT_NE(err_.find("a.stl: in single precision 1 vertex lies on others, and 2 triangles without "
                      "area are left out"),
            err_.npos)
      << err_;
  EXPECT_TRUE(is_closed(stl("a.stl")));
  EXPECT_EQ(stl("a.stl").size(), 4u);
  exported("near.obj -o a.obj");
  EXPECT_EQ(err_, "");
  EXPECT_TRUE(is_closed(obj("a.obj")));
  EXPECT_EQ(obj("a.obj").size(), 6u);
  write("far.draw", "open-segment 1\nbox-3 0 1e39  0 1  0 1\nclose-segment\n");
  expect_error("export far.draw -o b.stl", "too large for single precision");
  exported("far.draw -o b.ply");
}

TEST_F(ExportCommand, WhatIsOpenIsNamed) {
  write("open.draw", "open-segment 4\npolygon-abs-3 0 0 0  1 0 0  1 1 0  0 1 0\nclose-segment\n" +
                         read(folder_ / "box.draw"));
  exported("open.draw -o a.stl");
  EXPECT_EQ(
      err_,
      "a.stl: segment 4 is not closed: 4 sides of triangles have no face beside them: programs "
      "that print refuse it, or close it in their own way\n");
  EXPECT_EQ(stl("a.stl").size(), 14u);
}

/// Objects that are closed only together are one.
TEST_F(ExportCommand, PartsOfOneSurfaceAreJoined) {
  write("halves.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no first\nf 1 3 2\nf 1 2 4\no second\nf 2 3 4\nf 1 4 "
        "3\n");
  exported("halves.obj -o a.obj");
  EXPECT_EQ(err_, "");
  EXPECT_TRUE(is_closed(obj("a.obj")));
  EXPECT_EQ(read(folder_ / "a.obj").find("o second"), std::string::npos);
}

/// Each group of objects whose open sides meet is judged by itself, whatever else there is.
TEST_F(ExportCommand, GroupsAreJoinedEachByItself) {
  const std::array<double, 6> box{5, 6, 0, 1, 0, 1}, far{15, 17, 0, 1, 0, 1};
  const std::string halves =
      segment(4, faces_of_box(box, false, 0, 5)) + segment(5, faces_of_box(box, false, 5));
  write("lid.draw", segment(9, "box-3 0 1  0 1  0 1\n") + "set-segment-title 9 \"Lid\"\n" + halves);
  exported("lid.draw -o lid.obj");
  EXPECT_EQ(err_, "");
  const auto names = [&](const std::string& file) {
    std::vector<std::string> found;
    std::istringstream lines(read(folder_ / file));
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("o ")) found.push_back(line.substr(2));
    }
    return found;
  };
  EXPECT_EQ(names("lid.obj"), (std::vector<std::string>{"Lid", "segment 4"}));
  EXPECT_DOUBLE_EQ(volume(obj("lid.obj")), 2.0);
  write("open.draw", halves + segment(6, "polygon-abs-3 9 0 0  10 0 0  9 1 0\n") +
                         segment(7, faces_of_box(far, false, 0, 2)) +
                         segment(8, faces_of_box(far, false, 2)));
  exported("open.draw -o open.obj");
  EXPECT_EQ(names("open.obj"), (std::vector<std::string>{"segment 4", "segment 6", "segment 7"}));
  EXPECT_EQ(err_.find("segment 4"), err_.npos) << err_;
  EXPECT_EQ(err_.find("segment 7"), err_.npos) << err_;
  EXPECT_NE(err_.find("open.obj: segment 6 is not closed: 3 sides"), err_.npos) << err_;
  EXPECT_DOUBLE_EQ(volume(obj("open.obj")), 3.0);
  // Sides meet in parts, too: a half's side has the other's vertex along it.
  write("t.draw", segment(1, "polygon-abs-3 0 0 0  0 1 0  0.5 1 0  0.5 0 0\n") +
                      segment(2, "polygon-abs-3 0.5 0 0  0.5 1 0  1 1 0  1 0 0\n" +
                                     faces_of_box({0, 1, 0, 1, 0, 1}, false, 1)));
  exported("t.draw -o t.obj");
  EXPECT_EQ(err_, "");
  EXPECT_EQ(names("t.obj"), (std::vector<std::string>{"segment 1"}));
  EXPECT_DOUBLE_EQ(volume(obj("t.obj")), 1.0);
}

/// Bodies of one segment are turned each by itself; a cavity stays.
TEST_F(ExportCommand, BodiesInsideOutAreTurned) {
  const auto inward = [](const std::array<double, 6>& box) { return faces_of_box(box, true); };
  const auto outward = [](const std::array<double, 6>& box) { return faces_of_box(box); };
  const std::tuple<std::string, std::string, double> bodies[] = {
      {"beside", outward({20, 23, 0, 3, 0, 3}) + inward({30, 31, 1, 2, 1, 2}), 28.0},
      {"a cavity", outward({20, 23, 0, 3, 0, 3}) + inward({21, 22, 1, 2, 1, 2}), 26.0},
      {"all inside out", inward({20, 23, 0, 3, 0, 3}) + outward({21, 22, 1, 2, 1, 2}), 26.0},
      {"a body in a cavity",
       outward({0, 9, 0, 9, 0, 9}) + inward({1, 8, 1, 8, 1, 8}) + inward({2, 7, 2, 7, 2, 7}),
       729.0 - 343.0 + 125.0},
      {"along an edge", outward({0, 1, 0, 1, 0, 1}) + inward({1, 2, 1, 2, 0, 1}), 2.0},
      {"in its box, but outside",  // two walls of an L around it
       outward({0, 9, 0, 1, 0, 9}) + outward({0, 1, 2, 9, 0, 9}) + inward({3, 4, 3, 4, 3, 4}),
       81.0 + 63.0 + 1.0},
  };
  for (const auto& [what, faces, bulk] : bodies) {
    SCOPED_TRACE(what);
    write("s.draw", segment(1, faces));
    exported("s.draw -o s.obj");
    EXPECT_EQ(err_, "");
    EXPECT_TRUE(is_closed(obj("s.obj")));
    EXPECT_NEAR(volume(obj("s.obj")), bulk, 1e-10);
  }
  const std::array<double, 6> box{5, 6, 0, 1, 0, 1};  // after two are joined, too
  write("s.draw",
        segment(4, faces_of_box(box, true, 0, 5)) + segment(5, faces_of_box(box, true, 5)));
  exported("s.draw -o s.obj");
  EXPECT_DOUBLE_EQ(volume(obj("s.obj")), 1.0);
  // Rounding leaves a wall without thickness before a slot, which is a cavity then.
  write("s.draw",
        "rotate-x-3 37\nrotate-y-3 15\ntranslate-3 0.4 2.2 0\nopen-segment 1\n"
        "begin-solid difference\nbox-3 0 4 0 5 0 6\nbox-3 4 6 1 3 3 6\nbox-3 2 3 0 4 0 4\n"
        "end-solid\nclose-segment\n");
  if (!can_run("export s.draw -o s.obj", "CGAL")) GTEST_SKIP() << err_;
  EXPECT_NEAR(volume(obj("s.obj")), 104.0, 1e-9);
}

TEST_F(ExportCommand, WhatIsTurnedInsideOutIsTurned) {
  write("in.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 1 3 4\n");
  exported("in.obj -o a.obj");
  EXPECT_DOUBLE_EQ(volume(obj("a.obj")), 1.0 / 6.0);
  write("mirrored.draw", "scale-3 -1 1 1\n" + read(folder_ / "box.draw"));
  exported("mirrored.draw -o a.obj");
  EXPECT_DOUBLE_EQ(volume(obj("a.obj")), 24.0);
}

TEST_F(ExportCommand, OnlyWhatIsVisibleAndFilled) {
  write("more.draw",
        read(folder_ / "box.draw") +
            "open-segment 2\nbox-3 5 6  5 6  5 6\nclose-segment\nset-visibility 2 off\n"
            "open-segment 3\nmove-abs-3 0 0 0\nline-abs-3 1 1 1\ntext \"A\"\n"
            "set-fill-style hollow\npolygon-abs-3 0 0 0  1 0 0  0 1 0\nclose-segment\n");
  exported("more.draw -o a.stl");
  EXPECT_EQ(err_, "a.stl: left out: 1 line, 1 hollow polygon, 1 text\n");
  EXPECT_EQ(volume(stl("a.stl")), 24.0);
}

/// Readers of OBJ join objects of one name, and a line that ends in a backslash with the next one.
TEST_F(ExportCommand, NamesInObjAreUniqueLines) {
  const std::string names[] = {"pin", "pin", "pin (2)", "pin ", "end\\\\", "end/"};
  std::string text;
  for (int k = 0; k < 6; ++k) {
    text += segment(k + 1, fmt::format("box-3 {} {}  0 1  0 1\n", 2 * k, 2 * k + 1));
    text += fmt::format("set-segment-title {} \"{}\"\n", k + 1, names[k]);
  }
  write("names.draw", text);
  exported("names.draw -o names.obj");
  const std::string written = read(folder_ / "names.obj");
  EXPECT_EQ(written.find('\\'), written.npos);
  std::vector<std::string> found;
  std::istringstream lines(written);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("o ")) found.push_back(line.substr(2));
  }
  EXPECT_EQ(found,
            (std::vector<std::string>{"pin", "pin (3)", "pin (2)", "pin (4)", "end/", "end/ (2)"}));
  exported("names.obj -o again.obj");
  const std::string again = read(folder_ / "again.obj");  // but for the name of its materials
  EXPECT_EQ(again.substr(again.find('\n')), written.substr(written.find('\n')));
}

TEST_F(ExportCommand, AnnotationAndPolygonsWithoutAreaAreNamed) {
  write("named.draw", segment(1,
                              "box-3 0 1  0 1  0 1\npolygon-abs-3 3 0 0  4 0 0  5 0 0\n"
                              "polygon-abs-3 3 0 0  4 0 0  3 0 0\nleader-3 0 0 0 \"hole\" 9 9\n"
                              "linear-dimension-3 x  0 0 0  1 0 0  0 -1 0\n"
                              "balloon-3 0 0 0  1 \"box\"\n"));
  exported("named.draw -o a.stl");
  EXPECT_EQ(err_, "a.stl: left out: 2 polygons without area, 1 dimension, 1 leader, 1 balloon\n");
  EXPECT_EQ(stl("a.stl").size(), 12u);
}

TEST_F(ExportCommand, WhatSinglePrecisionLeavesNothingOfIsRefused) {
  write("tiny.draw",
        "open-segment 1\nscale-3 1e-60 1e-60 1e-60\nbox-3 0 1  0 1  0 1\nclose-segment\n");
  expect_error("export tiny.draw -o a.stl",
               "a.stl: segment 1 is too small for single precision: nothing would be left of it: "
               "expected .ply, .obj or .3mf");
  write("both.draw", segment(2, "box-3 0 1  0 1  0 1\n") + read(folder_ / "tiny.draw"));
  expect_error("export both.draw -o a.stl", "segment 1 is too small");
  EXPECT_FALSE(fs::exists(folder_ / "a.stl"));
  exported("tiny.draw -o a.ply");
}

/// Walls have the whole sides of the ends, so these are not cut where they cross themselves.
TEST_F(ExportCommand, PolygonsThatCrossThemselvesAreNamed) {
  constexpr std::array<std::array<double, 2>, 5> kStar{
      {{1, 0}, {-0.8, 0.6}, {0.3, -0.95}, {0.3, 0.95}, {-0.8, -0.6}}};
  std::string low = "polygon-abs-3", high = "polygon-abs-3", walls;
  for (std::size_t k = 0; k < 5; ++k) {
    const auto& [x, y] = kStar[k];
    const auto& [u, v] = kStar[(k + 1) % 5];
    high += fmt::format("  {} {} 1", x, y);
    low += fmt::format("  {} {} 0", kStar[4 - k][0], kStar[4 - k][1]);
    walls +=
        fmt::format("polygon-abs-3 {} {} 0  {} {} 0  {} {} 1  {} {} 1\n", x, y, u, v, u, v, x, y);
  }
  write("star.draw", segment(3, low + "\n" + high + "\n" + walls));
  exported("star.draw -o a.obj");
  EXPECT_EQ(err_,
            "a.obj: segment 3: 2 polygons cross themselves and are not cut, as drawn by the "
            "even-odd rule: its volume counts each part as often as they wind around it\n");
  EXPECT_TRUE(is_closed(obj("a.obj")));
  exported("star.draw -o a.stl");
  EXPECT_NE(err_.find("2 polygons cross themselves"), err_.npos) << err_;
}

TEST_F(ExportCommand, BadValuesLeaveNothing) {
  expect_error("export box.draw -o a.step",
               "unknown format of solids '.step': expected one of .stl .obj .ply .3mf");
  expect_error("export box.draw -o a", "unknown format of solids ''");
  expect_error("export box.draw -o box.draw", "box.draw");
  expect_error("export missing.draw -o a.stl", "missing.draw");
  expect_error("export box.draw -o nowhere/a.stl", "nowhere");
  expect_error("export box.draw -o nowhere/a.3mf", "nowhere");
  expect_error("export box.draw -o nowhere/a.obj", "nowhere");
  write("empty.draw", "open-segment 1\nmove-abs-3 0 0 0\nline-abs-3 1 1 1\nclose-segment\n");
  expect_error("export empty.draw -o a.stl", "empty.draw: no filled polygons: expected solids");
  write("bad.draw", "open-segment 1\nnonsense\n");
  expect_error("export bad.draw -o a.stl", "bad.draw:2:1");
  write("mtl.mtl", "newmtl a\n");
  write("m.obj", "mtllib mtl.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  expect_error("export m.obj -o m.obj", "m.obj");
  // A folder where the materials should be written: the other file is not written either.
  fs::create_directory(folder_ / "b.mtl");
  expect_error("export box.draw -o b.obj", "b.mtl");
}

}  // namespace
