// Cutting planes before meshes and programs, as the command's users meet them: hatching, its style,
// planes without effect, and the view that is fitted.

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "tests/command_fixture.h"

namespace {

class CutCommand : public Command {
 protected:
  void SetUp() override {
    Command::SetUp();
    write("cube.obj", box(-1, 1));
    write("high.obj", box(3, 5));
    write("open.obj", box(-1, 1, "f 1 2 3 4\n"));
    write("cut.draw", kCut);
  }
  static inline const std::string kCut = "set-cutting-plane 1 0 -1 0 0\nset-cut-faces hatched\n";

  /// A box from -1 to 1 and from low to high in y; by default with all faces.
  static std::string box(int low, int high, const std::string& last = "f 5 6 7 8\nf 1 4 3 2\n") {
    std::string text;
    for (const int y : {low, high}) {
      for (const char* const xz : {"-1 {} -1", "-1 {} 1", "1 {} 1", "1 {} -1"}) {
        std::string vertex = xz;
        text += "v " + vertex.replace(vertex.find("{}"), 2, std::to_string(y)) + "\n";
      }
    }
    return text + "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n" + last;
  }
  /// The line styles in which a dump has lines, each once, sorted.
  std::vector<std::string> styles(const std::string& arguments) {
    EXPECT_EQ(run("dump " + arguments), 0) << err_;
    std::vector<std::string> found;
    std::istringstream all(out_);
    std::string style;
    for (std::string line; std::getline(all, line);) {
      if (line.starts_with("line-style ")) style = line.substr(11);
      if (line.starts_with("polygon ")) {
        for (int sides = std::stoi(line.substr(8)); sides > 0; --sides) std::getline(all, line);
      } else if (line.starts_with("line ")) {
        found.push_back(style);
      }
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }
  std::string warning(const std::string& arguments) {
    EXPECT_EQ(run("draw " + arguments + " -o a.ppm --size 32x32"), 0) << err_;
    return err_;
  }
};

using Styles = std::vector<std::string>;

TEST_F(CutCommand, HatchingOfABareMeshIsDrawn) {
  EXPECT_EQ(styles("cube.obj"), Styles{});
  EXPECT_EQ(styles("cut.draw cube.obj"), (Styles{"solid 0 0 0 1"}));
  EXPECT_EQ(err_, "");
  write("none.draw", kCut + "set-line-style none\n");
  EXPECT_EQ(styles("none.draw cube.obj"), Styles{});
  write("red.draw", kCut + "set-line-style solid 1 0 0 2\n");
  EXPECT_EQ(styles("red.draw cube.obj"), (Styles{"solid 1 0 0 2"}));
  // Only the hatching: no side of the mesh is drawn, and none of a program that follows.
  ASSERT_EQ(run("draw cut.draw cube.obj -o a.svg"), 0) << err_;
  const std::string svg = read(folder_ / "a.svg");
  EXPECT_NE(svg.find("<path class=\"l"), std::string::npos);
  ASSERT_EQ(run("draw cut.draw cube.obj -o b.svg --line-width 3"), 0) << err_;
  EXPECT_NE(read(folder_ / "b.svg").find("stroke-width:3"), std::string::npos);
}

TEST_F(CutCommand, HatchingHasAStyleOfItsOwn) {
  const Styles own{"dashed 1 0 0 0.25 3 2"};
  EXPECT_EQ(styles("cut.draw cube.obj --lines 'hatch=0.25 dashed 3 2 #ff0000'"), own);
  EXPECT_EQ(err_, "");
  write("own.draw", kCut + "set-line-kind-style hatch 0.25 dashed 3 2 1 0 0\n");
  EXPECT_EQ(styles("own.draw cube.obj"), own);
  // Where the line style is none, too; and beside sides of a style of theirs.
  write("alone.draw", kCut + "set-line-style none\nset-line-kind-style hatch 0.25\n");
  EXPECT_EQ(styles("alone.draw cube.obj"), (Styles{"solid 0 0 0 0.25"}));
  EXPECT_EQ(styles("own.draw cube.obj --lines hatch=2"), (Styles{"solid 0 0 0 2"}));
  ASSERT_EQ(run("draw cut.draw cube.obj -o a.svg --hidden franklin "
                "--lines outline=2,crease=1,hatch=0.5 --line-width 7"),
            0)
      << err_;
  const std::string svg = read(folder_ / "a.svg");
  for (const char* const width : {"stroke-width:2", "stroke-width:1", "stroke-width:0.5"}) {
    EXPECT_NE(svg.find(width), std::string::npos) << width;
  }
  EXPECT_EQ(svg.find("stroke-width:7"), std::string::npos);
}

TEST_F(CutCommand, AStyleOfNoHatchingIsTold) {
  const std::string words = "--lines hatch= has no effect: no cut face is hatched";
  EXPECT_NE(warning("cube.obj --lines hatch=2").find("cube.obj: " + words), std::string::npos)
      << err_;
  write("closed.draw", "set-cutting-plane 1 0 -1 0 0\nset-cut-faces closed\n");
  EXPECT_NE(warning("closed.draw cube.obj --lines hatch=2").find(words), std::string::npos) << err_;
  EXPECT_EQ(warning("cut.draw cube.obj --lines hatch=2"), "");
  expect_error("draw cut.draw cube.obj -o a.svg --lines outline,hatch", "expected hatch=WIDTH");
  expect_error("draw cut.draw cube.obj -o a.svg --lines hatch=", "expected KIND=WIDTH");
}

TEST_F(CutCommand, LinesListsAllKindsThatItKnows) {
  expect_error("draw cube.obj -o a.svg --lines edges",
               "--lines: expected outline, boundary, crease, material, intersection, all, hidden "
               "or hatch=WIDTH, not 'edges'");
  expect_error("sheet cube.obj -o a.svg --lines edges",
               "--lines: expected outline, boundary, crease, material, intersection or all, not "
               "'edges'");
  expect_error("draw cube.obj -o a.svg --lines hiden", "did you mean 'hidden'?");
}

TEST_F(CutCommand, CutFacesOfAMeshThatIsNotClosedAreTold) {
  EXPECT_EQ(warning("cut.draw open.obj"),
            "open.obj: set-cut-faces hatched has no effect: not closed\n");
  write("two.obj", "o a\n" + box(-1, 1, "f 1 2 3 4\n") + "o b\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\n" +
                       "f 4 1 5 8\nf 5 6 7 8\nf 1 4 3 2\n");
  EXPECT_EQ(warning("cut.draw two.obj"),
            "two.obj: set-cut-faces hatched has no effect on 1 of 2 objects: not closed\n");
  write("far.draw", "set-cutting-plane 1 0 -1 0 9\nset-cut-faces hatched\n");
  EXPECT_EQ(warning("far.draw open.obj").find("not closed"), std::string::npos) << err_;
  write("faces.draw", "set-cutting-plane 1 0 -1 0 0\n");
  EXPECT_EQ(warning("faces.draw open.obj"), "");
}

TEST_F(CutCommand, APlaneThatCutsNothingIsToldOnceByName) {
  write("far.draw", "set-cutting-plane 2 0 -1 0 2.5\n");
  const std::string of_cube = "far.draw: set-cutting-plane 2 0 -1 0 2.5 cuts nothing of cube.obj\n";
  EXPECT_EQ(warning("far.draw cube.obj"), of_cube);
  EXPECT_EQ(warning("far.draw cube.obj cube.obj"),
            "far.draw: set-cutting-plane 2 0 -1 0 2.5 cuts nothing of cube.obj and cube.obj\n");
  EXPECT_EQ(warning("far.draw cube.obj high.obj").find("far.draw: set-cutting-plane 2 0 -1 0 2.5"),
            std::string::npos)
      << err_;
  EXPECT_EQ(warning("cut.draw cube.obj"), "");
  // By every command that enters inputs.
  ASSERT_EQ(run("dump far.draw cube.obj"), 0);
  EXPECT_EQ(err_, of_cube);
  ASSERT_EQ(run("export far.draw cube.obj -o e.obj"), 0);
  EXPECT_EQ(err_, of_cube);
  ASSERT_EQ(run("sheet far.draw cube.obj -o s.svg"), 0);
  EXPECT_EQ(err_, of_cube);
}

TEST_F(CutCommand, OfManyPicturesThoseThatAreNotCutAreNamed) {
  write("far.draw", "set-cutting-plane 1 0 -1 0 2.5\n");
  ASSERT_EQ(run("draw --with far.draw cube.obj high.obj -o '{name}.ppm' --size 32x32"), 0) << err_;
  EXPECT_NE(err_.find("far.draw: set-cutting-plane 1 0 -1 0 2.5 cuts nothing of cube.obj"),
            std::string::npos)
      << err_;
  EXPECT_NE(err_.find("far.draw: set-cutting-plane 1 0 -1 0 2.5 cuts away all of high.obj"),
            std::string::npos)
      << err_;
}

TEST_F(CutCommand, APlaneThatCutsEverythingAwayIsTold) {
  write("all.draw", "set-cutting-plane 1 0 1 0 -2\n");
  EXPECT_NE(warning("all.draw cube.obj")
                .find("all.draw: set-cutting-plane 1 0 1 0 -2 cuts away all of cube.obj\n"),
            std::string::npos)
      << err_;
  EXPECT_EQ(warning("all.draw cube.obj high.obj"), "");
  // With a face in the plane, too.
  write("flush.draw", "set-cutting-plane 1 0 1 0 -1\n");
  EXPECT_NE(warning("flush.draw cube.obj").find("cuts away all of cube.obj"), std::string::npos);
}

TEST_F(CutCommand, PlanesOfProgramsCountForAllThatIsEnteredWhileTheyAreSet) {
  const std::string begin = "set-window -9 9 -9 9\nset-view-depth -9 9\n";
  const auto box_at = [](int name, int y) {
    return "open-segment " + std::to_string(name) + "\nbox-3 -1 1 " + std::to_string(y) + " " +
           std::to_string(y + 1) + " -1 1\nclose-segment\n";
  };
  const auto warned = [&](const std::string& program) {
    write("p.draw", begin + program);
    return warning("p.draw");
  };
  const std::string plane = "set-cutting-plane 1 0 -1 0 2.5\n";  // cuts away what is above 2.5
  const std::string nothing =
      "p.draw: set-cutting-plane 1 0 -1 0 2.5 cuts nothing of what is entered after it\n";
  EXPECT_EQ(warned(plane + box_at(1, 0)), nothing);
  EXPECT_EQ(warned(plane + box_at(1, 0) + "set-cutting-plane 1 off\n" + box_at(2, 2)), nothing);
  EXPECT_EQ(warned(plane + box_at(1, 0) + box_at(2, 2)), "");
  EXPECT_EQ(warned(plane + box_at(1, 0) + box_at(2, 3)), "");
  EXPECT_EQ(warned(plane), "p.draw: nothing is seen: no polygon or line was entered\n") << err_;
  EXPECT_EQ(warned(plane + "set-cutting-plane 1 off\n" + box_at(1, 0)), "");
  EXPECT_EQ(warned(plane + plane + box_at(1, 2)), "");
  EXPECT_EQ(warned(box_at(1, 2) + plane +
                   "open-segment 2\nmove-abs-3 0 0 0\nline-abs-3 0 3 0\n"
                   "close-segment\n"),
            "");
  EXPECT_EQ(warned(box_at(1, 2) + plane +
                   "open-segment 2\nmove-abs-3 0 0 0\nline-abs-3 0 1 0\n"
                   "close-segment\n"),
            nothing);
  EXPECT_EQ(warned(box_at(1, 2) + plane +
                   "open-segment 2\nmove-abs-3 0 4 0\ntext \"a\"\n"
                   "move-abs-3 0 1 0\ntext \"b\"\nclose-segment\n"),
            "");
  // A face in the plane: it stays without cut faces, and is a cut face with them.
  const std::string flush = "set-cutting-plane 1 0 -1 0 1\n";
  EXPECT_NE(warned(flush + box_at(1, 0)), "");
  EXPECT_EQ(warned("set-cut-faces closed\n" + flush + box_at(1, 0)), "");
  EXPECT_NE(warned("set-cut-faces closed\n" + plane + box_at(1, 0)), "");
}

TEST_F(CutCommand, AnExplodedViewIsCutAsAssembled) {
  // The upper box is moved beyond the place of the plane, which moves with it.
  write("pair.draw",
        "set-window -9 9 -9 9\nset-view-depth -9 9\nset-cutting-plane 1 0 -1 0 2.5\n"
        "open-segment 1\nbox-3 -1 1 0 1 -1 1\nclose-segment\n"
        "open-segment 2\nbox-3 -1 1 1 2 -1 1\nclose-segment\n");
  EXPECT_NE(warning("pair.draw").find("cuts nothing"), std::string::npos) << err_;
  EXPECT_EQ(warning("pair.draw --explode y=1"), warning("pair.draw"));
}

TEST_F(CutCommand, TheViewIsFittedToWhatIsLeft) {
  write("half.obj", box(-1, 0));
  write("closed.draw", "set-cutting-plane 1 0 -1 0 0\nset-cut-faces closed\n");
  write("open.draw", "set-cutting-plane 1 0 -1 0 0\n");
  write("low.draw", "set-cutting-plane 1 0 -1 0 1\n");
  const auto drawn = [&](const std::string& inputs) {
    EXPECT_EQ(run("draw " + inputs + " -o a.ppm --size 64x64"), 0) << err_;
    return read(folder_ / "a.ppm");
  };
  for (const std::string options : {"", " --eye 0,90", " --parallel", " --fov 30", " --fit each"}) {
    EXPECT_TRUE(drawn("closed.draw cube.obj" + options) == drawn("half.obj" + options)) << options;
    EXPECT_FALSE(drawn("open.draw cube.obj" + options) == drawn("cube.obj" + options)) << options;
  }
  // A ledge in the plane whose solid is cut away is not seen.
  write("step.obj",
        "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n"
        "v 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\nf 6 5 4 3 2 1\n"
        "f 7 8 9 10 11 12\nf 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\n"
        "f 6 1 7 12\n");
  write("upper.obj",
        "v 0 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\n"
        "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  write("ledge.draw", "set-cutting-plane 1 0 1 0 -1\nset-cut-faces closed\n");
  EXPECT_TRUE(drawn("ledge.draw step.obj") == drawn("upper.obj"));
  // The remaining parts of several meshes are fitted; one that is cut away counts only if all are.
  EXPECT_TRUE(drawn("low.draw cube.obj high.obj") == drawn("cube.obj"));
  EXPECT_TRUE(drawn("low.draw high.obj cube.obj") == drawn("cube.obj"));
  EXPECT_EQ(run("draw low.draw high.obj -o a.ppm --size 64x64"), 0) << err_;
  ASSERT_EQ(run("draw --with closed.draw cube.obj -o '{name}.ppm' --size 64x64 --fit all"), 0);
  const std::string of_cut = read(folder_ / "cube.ppm");
  EXPECT_TRUE(of_cut == drawn("half.obj"));
}

}  // namespace
