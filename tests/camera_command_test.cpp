// The options of the command for the camera and the background.

#include <gtest/gtest.h>

#include <string>

#include "tests/command_fixture.h"

namespace {

const std::string kPyramid =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
const std::string kAxes =
    "open-segment 90\nmove-abs-3 0 0 0\nline-abs-3 1.5 0 0\nmove-abs-3 0 0 0\n"
    "line-abs-3 0 1.5 0\nclose-segment\n";
const std::string kSquare =
    "open-segment 1\npolygon-abs-2 -0.5 -0.5  0.5 -0.5  0.5 0.5  -0.5 0.5\nclose-segment\n";

class Camera : public Command {
 protected:
  void same(const std::string& a, const std::string& b) {
    EXPECT_EQ(run("compare " + a + " " + b), 0) << a << ' ' << b << '\n' << out_;
  }
  void differ(const std::string& a, const std::string& b) {
    EXPECT_EQ(run("compare " + a + " " + b), 1) << a << ' ' << b;
  }
  void draw(const std::string& arguments) {
    EXPECT_EQ(run("draw " + arguments), 0) << arguments << '\n' << err_;
    EXPECT_EQ(err_, "");
  }
};

TEST_F(Camera, EveryCommandTakesIt) {
  write("m.obj", kPyramid);
  const std::string camera = " --eye -40,25 --up z --fov 35 --size 90x60";
  draw("m.obj -o d.png --ids d.npy" + camera);
  EXPECT_EQ(run("truth m.obj --ids t.npy" + camera), 0) << err_;
  same("d.npy", "t.npy");
  EXPECT_EQ(run("import m.obj -o m.draw" + camera), 0) << err_;
  draw("m.draw -o i.png --ids i.npy --size 90x60");
  same("d.npy", "i.npy");
  same("d.png", "i.png");
  EXPECT_EQ(run("dump m.obj -o a.txt" + camera), 0) << err_;
  EXPECT_EQ(run("dump m.draw -o b.txt --size 90x60"), 0) << err_;
  same("a.txt", "b.txt");
  EXPECT_EQ(run("check m.obj --golden gold --update" + camera), 0) << err_;
  same("a.txt", "gold/m.txt");
  draw("m.obj -o t.png --turntable 3" + camera);
  differ("t-000.png", "t-001.png");
}

TEST_F(Camera, AnImportedMeshIsNotDistortedWhateverTheSize) {
  write("m.obj", kPyramid);
  EXPECT_EQ(run("import m.obj -o m.draw"), 0) << err_;
  EXPECT_EQ(run("import m.obj -o wide.draw --size 90x60"), 0) << err_;
  draw("m.draw -o a.png --size 90x60");
  draw("m.obj -o b.png --size 90x60");
  draw("wide.draw -o c.png --size 90x60");
  same("b.png", "c.png");
}

/// Seen straight from above, the axis of a turntable is the line of sight.
TEST_F(Camera, TurntableTurnsAboutTheUpAxis) {
  write("m.obj", kPyramid);
  draw("m.obj -o a.png --turntable 4 --up z --eye 0,90 --parallel --size 60x60 --ids a.npy");
  draw("m.obj -o b.png --up z --eye -90,90 --parallel --size 60x60 --ids b.npy --hidden bsp");
  differ("a-000.npy", "a-001.npy");
  // Each of the four sides around the axis takes its neighbour's place.
  EXPECT_EQ(run("compare a-001.npy b.npy"), 0) << out_;
}

/// STL has z up, which is noted once a call; not where another axis is set.
TEST_F(Camera, StlStandsUpright) {
  write("m.stl",
        "solid m\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 4\n"
        "endloop\nendfacet\nendsolid m\n");
  write("n.STL", read(folder_ / "m.stl"));
  write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 4\nf 1 2 3\n");
  write("view.draw", "set-view-up 0 1 0\nset-view-plane-normal 0 0 -1\nset-window -5 5 -5 5\n");
  const std::string note = ": STL has z up: --up sets another axis\n";
  EXPECT_EQ(run("draw m.stl -o up.png"), 0);
  EXPECT_EQ(err_, "m.stl" + note);
  EXPECT_EQ(run("draw m.stl m.obj -o up.png"), 0);
  EXPECT_EQ(err_, "m.stl" + note);
  EXPECT_EQ(run("draw m.stl n.STL -o '{name}.png' --threads 1"), 0);
  EXPECT_EQ(err_, "m.stl" + note);
  for (const char* set : {"m.stl --up z", "m.stl --up y", "view.draw m.stl", "m.obj",
                          "m.stl --quiet", "m.obj --up auto"}) {
    draw(set + std::string(" -o z.png"));
    EXPECT_EQ(err_, "") << set;
  }
}

TEST_F(Camera, UpAutoIsTheCustomOfAFormat) {
  write("m.stl",
        "solid m\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 4\n"
        "endloop\nendfacet\nendsolid m\n");
  write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 4\nf 1 2 3\n");
  draw("m.stl -o y.png --up y");
  EXPECT_EQ(run("draw m.stl -o usual.png"), 0);
  draw("m.stl -o z.png --up z");
  same("usual.png", "z.png");
  draw("m.stl -o auto.png --up auto");
  draw("m.obj -o in-y.png --up auto");
  same("auto.png", "z.png");
  same("in-y.png", "y.png");
  differ("y.png", "z.png");
  draw("m.stl m.obj -o auto.png --up auto --turntable 2");
  draw("m.stl m.obj -o z.png --up z --turntable 2");
  same("auto-001.png", "z-001.png");
  draw("m.stl m.obj -o {ext}.png --up auto");  // each picture stands by itself
  same("stl.png", "z.png");
  same("obj.png", "y.png");
}

TEST_F(Camera, BadValues) {
  write("m.obj", kPyramid);
  fs::create_directory(folder_ / "gold");
  write("gold/m.txt", "displayfile-dump 1\nend\n");
  const auto refused = [&](const std::string& options, const std::string& words) {
    for (const char* command :
         {"draw m.obj -o x.png ", "truth m.obj --ids x.npy ", "dump m.obj -o x.txt ",
          "import m.obj -o x.draw ", "check m.obj --golden gold ",
          "draw m.obj -o x.png --turntable 2 "}) {
      expect_error(command + options, words);
    }
  };
  for (const char* eye : {"30", "1,2,3,4", "a,b", "30,20,", ",30", "30,91", "30,-91", "nan,0",
                          "1e999,0", "1,inf,0"}) {
    refused(std::string("--eye ") + eye,
            std::string("--eye ") + eye + ": expected AZIMUTH,ELEVATION in degrees");
  }
  refused("--look-at 1,2", "--look-at 1,2: expected X,Y,Z");
  refused("--look-at x", "--look-at x: expected X,Y,Z");
  refused("--up w", "--up w: expected x, y, z, -x, -y, -z or auto");
  for (const char* fov : {"0", "180", "-5", "wide", "nan", "40,50"}) {
    refused(std::string("--fov ") + fov, std::string("--fov ") + fov + ": expected degrees");
  }
  refused("--eye 0.5,0.5,0.4", "part of the scene is not in front of the eye");
  refused("--eye 1,2,3 --look-at 1,2,3", "the eye is at the target");
  EXPECT_EQ(run("draw m.obj -o x.png --parallel --fov 30"), 2);
  EXPECT_FALSE(fs::exists(folder_ / "x.png"));
}

TEST_F(Camera, NeedsAMeshWhoseViewNoProgramSets) {
  write("m.obj", kPyramid);
  write("square.draw", kSquare);
  write("view.draw", "set-perspective 1 2 9\n");
  const std::string words = "expected a mesh before which no program sets the camera";
  expect_error("draw square.draw -o x.png --eye 30,20", "--eye: " + words);
  expect_error("draw view.draw m.obj -o x.png --up z --fov 30", "--up --fov: " + words);
  expect_error("dump square.draw --parallel", "--parallel: " + words);
  expect_error("truth view.draw m.obj --no-fit --ids x.npy", "--no-fit: " + words);
  draw("m.obj view.draw -o x.png --up z");
  write("half.draw", "set-viewport 0 0.5 0 1\n");
  draw("half.draw m.obj -o x.png --up z --eye 10,5");
}

/// A mesh in a viewport is the picture of the mesh by itself, as large as the viewport.
TEST_F(Camera, AViewportBeforeAMeshKeepsTheFit) {
  write("m.obj", kPyramid);
  write("half.draw", "set-viewport 0 0.5 0 1\n");
  draw("half.draw m.obj -o half.png --size 80x60 --ids half.npy");
  draw("m.obj -o m.png --size 40x60 --ids m.npy");
  write("empty.draw", "# nothing\n");
  const auto seen = [&](const std::string& file, const std::string& size) {
    EXPECT_EQ(run("draw empty.draw -o e.png --ids e.npy --size " + size), 0);
    EXPECT_EQ(run("compare " + file + " e.npy"), 1);
    return std::stoi(out_);  // pixels that differ
  };
  const int pixels = seen("m.npy", "40x60");
  EXPECT_GT(pixels, 200);
  EXPECT_NEAR(seen("half.npy", "80x60"), pixels, 3);
  write("eye.draw",
        "set-perspective 1 2 9\nopen-segment 7\nmove-abs-3 0 0 0\nline-abs-3 0 4 0\n"
        "close-segment\n");
  draw("eye.draw m.obj -o eye.png --ids eye.npy");
  EXPECT_GT(seen("eye.npy", "512x512"), 1000) << "what is not said is fitted";
}

TEST_F(Camera, ProgramsBeforeAMeshAndAfterItShareItsView) {
  write("m.obj", kPyramid);
  write("n.obj", "v 3 0 0\nv 4 0 0\nv 3 1 0\nf 1 2 3\n");
  write("axes.draw", kAxes);
  draw("axes.draw m.obj -o a.png --size 90x60");
  draw("m.obj axes.draw -o b.png --size 90x60");
  same("a.png", "b.png");
  draw("m.obj -o c.png --size 90x60");
  differ("a.png", "c.png");
  // One view of all meshes, wherever the program stands. A program's drawing beside a mesh is shown
  // whole, however far it reaches.
  write("far.draw", "open-segment 7\nmove-abs-3 0 0 0\nline-abs-3 0 40 0\nclose-segment\n");
  draw("m.obj far.draw --background none -o far.png --size 90x90");
  write("far-2.draw", "open-segment 7\nmove-abs-3 0 0 0\nline-abs-3 0 80 0\nclose-segment\n");
  draw("m.obj far-2.draw --background none -o far-2.png --size 90x90 --ids far-2.npy");
  EXPECT_EQ(run("compare far.png far-2.png"), 1);
  // A program may name a mesh's segments.
  write("moved.draw", "set-image-translation 1 0.25 0\n");
  draw("m.obj moved.draw -o moved.png --size 90x60");
  EXPECT_EQ(run("compare a.png moved.png"), 1);
  draw("m.obj axes.draw n.obj -o d.png");
  draw("axes.draw m.obj n.obj -o e.png");
  draw("m.obj n.obj axes.draw -o f.png");
  same("d.png", "e.png");
  same("d.png", "f.png");
  write("moved.draw", "translate-3 9 0 0\nscale-3 3 3 3\n");
  draw("moved.draw m.obj -o g.png --size 90x60");
  draw("m.obj -o h.png --size 90x60");
  EXPECT_EQ(run("truth moved.draw m.obj --ids g.npy --size 90x60"), 0) << err_;
  EXPECT_EQ(run("truth m.obj --ids h.npy --size 90x60"), 0) << err_;
  same("g.npy", "h.npy");  // the view is fitted to the mesh where it is
  EXPECT_EQ(run("draw - m.obj -o s.png --size 90x60", "axes.draw"), 0) << err_;
  same("a.png", "s.png");
  // Invisible segments need no room.
  write("unseen.draw",
        "open-segment 7\nmove-abs-3 0 0 0\nline-abs-3 0 40 0\nclose-segment\n"
        "set-visibility 7 off\n");
  for (const char* inputs : {"unseen.draw m.obj", "m.obj unseen.draw"}) {
    draw(std::string(inputs) + " -o u.png --size 90x60");
    same("u.png", "c.png");
  }
}

/// A program may change a mesh's segments; its other settings apply to all inputs that follow.
TEST_F(Camera, AProgramThatNamesAMeshsSegmentPlacesTheNextMesh) {
  write("m.obj", kPyramid);
  write("n.obj", "v 3 0 0\nv 4 0 0\nv 3 1 0\nf 1 2 3\n");
  const std::string says =
      "translate-3 5 0 0\nset-shading gouraud\nopen-segment 9\nmove-abs-3 0 3 0\n"
      "line-abs-3 1 3 0\nclose-segment\n";
  write("plain.draw", says);
  for (const std::string first :
       {"set-visibility 1 on\n", "set-visibility 2 on\n", "set-image-translation 1 0 0\n",
        "rename-segment 2 5\nrename-segment 5 2\n"}) {
    SCOPED_TRACE(first);
    EXPECT_EQ(run("dump m.obj n.obj plain.draw n.obj"), 0) << err_;
    const std::string expected = out_;
    write("naming.draw", first + says);
    EXPECT_EQ(run("dump m.obj n.obj naming.draw n.obj"), 0) << err_;
    EXPECT_EQ(out_, expected);
  }
  // Axes too, for which programs are replayed once more.
  write("axes.draw", "open-segment 8\naxes-3 0 0 0 1 1 1\nclose-segment\n");
  write("naming.draw", "set-visibility 1 on\n" + says);
  EXPECT_EQ(run("dump m.obj plain.draw axes.draw"), 0) << err_;
  const std::string expected = out_;
  EXPECT_EQ(run("dump m.obj naming.draw axes.draw"), 0) << err_;
  EXPECT_EQ(out_, expected);
}

/// The edges of the box with axes depend on the view, and the fitted view on the axes.
TEST_F(Camera, AxesBesideAMeshAreInThePicture) {
  write("m.obj", kPyramid);
  write("axes.draw", "open-segment 90\naxes-3 0 1 0 1 0 1\nclose-segment\n");
  for (const char* eye : {"30,20", "120,30", "-100,-40", "210,60 --fov 40", "45,35 --parallel"}) {
    const std::string camera = std::string(" --up z --eye=") + eye;
    EXPECT_EQ(run("dump m.obj axes.draw" + camera), 0) << err_;
    for (const char* name : {" \"x\"\n", " \"y\"\n", " \"z\"\n"}) {
      EXPECT_NE(out_.find(name), std::string::npos) << name << eye;
    }
    EXPECT_EQ(run("draw m.obj axes.draw -o a.png --stats" + camera), 0) << err_;
    EXPECT_NE(out_.find(" (0 hidden)\n"), std::string::npos) << out_;
    draw("axes.draw m.obj -o b.png" + camera);
    same("a.png", "b.png");
  }
}

TEST_F(Camera, SettingsBeforeAMeshChangeItsPicture) {
  write("m.obj", kPyramid);
  draw("m.obj -o bare.png");
  for (const char* line :
       {"set-fill-style solid 1 0 0", "set-light 1 0 0", "set-line-style solid 0 0 1",
        "set-shading gouraud", "rotate-z-3 20", "set-hidden-line-removal off"}) {
    write("s.draw", std::string(line) + "\n");
    draw("s.draw m.obj -o s.png");
    differ("bare.png", "s.png");
  }
  write("empty.draw", "# nothing\n");
  draw("empty.draw m.obj -o e.png");
  same("bare.png", "e.png");
}

TEST_F(Camera, WindowsAreWidenedUnlessAProgramSetThem) {
  write("plain.draw", kSquare);
  write("own.draw", "set-window -1 1 -1 1\n" + kSquare);
  write("wide.draw", "set-window -1.5 1.5 -1 1\n" + kSquare);
  write("meant.draw", "set-window-fit stretch\nset-window -1 1 -1 1\n" + kSquare);
  const std::string size = " --size 90x60 --ids ";
  draw("plain.draw -o plain.png" + size + "plain.npy");
  draw("wide.draw -o wide.png" + size + "wide.npy");
  same("plain.npy", "wide.npy");
  EXPECT_EQ(run("draw own.draw -o own.png" + size + "own.npy"), 0);
  EXPECT_NE(err_.find("own.png: segment 1: a window 1 times as wide as high is stretched to "
                      "a viewport 1.5 times as wide as high"),
            std::string::npos)
      << err_;
  EXPECT_NE(err_.find("--widen"), std::string::npos);
  EXPECT_EQ(std::ranges::count(err_, '\n'), 1);
  differ("own.npy", "wide.npy");
  EXPECT_EQ(run("draw own.draw -o t.png --turntable 2 --size 90x60"), 0);
  EXPECT_NE(err_.find("is stretched"), std::string::npos);
  draw("meant.draw -o meant.png" + size + "meant.npy");
  same("meant.npy", "own.npy");
  draw("own.draw --widen -o widened.png" + size + "widened.npy");
  same("widened.npy", "wide.npy");
  for (const char* program : {"plain", "own", "meant"}) {
    EXPECT_EQ(run("truth " + std::string(program) + ".draw --size 90x60 --ids t.npy"), 0);
    same("t.npy", std::string(program) + ".npy");
    draw(std::string(program) + ".draw -o square.png --size 60x60");
    EXPECT_EQ(run("dump " + std::string(program) + ".draw -o dump.txt"), 0);
    EXPECT_EQ(run("dump plain.draw -o plain.txt"), 0);
    same("dump.txt", "plain.txt");
  }
  draw("own.draw -o near.png --size 60x60");
}

TEST_F(Camera, Background) {
  write("t.draw", kSquare);
  write("none.draw", "set-background none\n" + kSquare);
  write("blue.draw", "set-background 0 0 1\n" + kSquare);
  draw("t.draw -o white.png");
  for (const char* white : {"white", "1,1,1", "'#ffffff'", "'#FFFFFF'", "'#fff'"}) {
    draw(std::string("none.draw -o a.png --background ") + white);
    EXPECT_EQ(read(folder_ / "a.png"), read(folder_ / "white.png")) << white;
  }
  draw("t.draw -o none.png --background none");
  draw("none.draw -o own.png");
  same("none.png", "own.png");
  differ("none.png", "white.png");
  draw("blue.draw -o blue.png");
  draw("t.draw -o transparent.png --background transparent");
  same("transparent.png", "none.png");
  for (const char* blue : {"0,0,1", "'#0000ff'", "blue"}) {
    draw(std::string("t.draw -o a.png --background ") + blue);
    same("a.png", "blue.png");
  }
  draw("none.draw -o t.png --turntable 2 --size 40x40");
  draw("none.draw -o n.png --size 40x40 --hidden bsp");
  same("t-000.png", "n.png");
  draw("none.draw -o t.png --turntable 2 --size 40x40 --hidden world-ray-cast");
  same("t-000.png", "n.png");
  draw("none.draw -o s.png --size 40x40 --samples 4");
  for (const char* format : {"svg", "pdf"}) {
    draw(std::string("t.draw --background none -o n.") + format);
    draw(std::string("t.draw -o w.") + format);
    EXPECT_LT(fs::file_size(folder_ / (std::string("n.") + format)),
              fs::file_size(folder_ / (std::string("w.") + format)));
  }
  expect_error("draw none.draw -o x.ppm", "x.ppm: .ppm files have no alpha");
  expect_error("draw t.draw -o x.ppm --background none", "x.ppm: .ppm files have no alpha");
  expect_error("draw none.draw -o x.ppm --turntable 2", ".ppm files have no alpha");
  draw("none.draw -o x.ppm --background black");
  for (const char* bad :
       {"Red", "1,1", "0,0,1.5", "0,0,-1", "'#12345'", "'#12345g'", "1,1,1,1", "nan,0,0", "None"}) {
    expect_error(std::string("draw t.draw -o y.png --background ") + bad, "--background");
  }
  expect_error(
      "draw t.draw -o y.png --background bleu",
      "--background bleu: did you mean 'blue'? expected R,G,B, each 0 to 1, #rrggbb, a CSS "
      "name, none or transparent");
  expect_error("draw t.draw -o x.ppm --background transparent", "x.ppm: .ppm files have no alpha");
}

}  // namespace
