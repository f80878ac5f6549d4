// The command `displayfile` as its users meet it: outputs, messages, exit statuses.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <utility>

#include "interp/draw/draw.h"
#include "tests/command_fixture.h"

namespace {

TEST_F(Command, DrawsEveryFormatWithIdsAndDepth) {
  write("t.draw", "set-window-fit stretch\n" + kTriangle);
  for (const char* format : {"png", "ppm", "svg", "pdf"}) {
    const std::string out = std::string("t.") + format;
    EXPECT_EQ(run("draw t.draw -o " + out + " --size 64x32 --ids ids.npy --depth z.npy"), 0)
        << err_;
    EXPECT_GT(fs::file_size(folder_ / out), 100u);
    EXPECT_EQ(err_, "");  // no progress where there is no terminal
    const std::string ids = read(folder_ / "ids.npy");
    EXPECT_EQ(ids.substr(1, 5), "NUMPY");
    EXPECT_NE(ids.find("'shape': (32, 64)"), std::string::npos);
    EXPECT_EQ(ids.size(), 128u + 64 * 32 * 4);
    EXPECT_EQ(read(folder_ / "z.npy").size(), 128u + 64 * 32 * 8);
  }
  EXPECT_EQ(read(folder_ / "t.ppm").substr(0, 13), "P6\n64 32\n255\n");
}

TEST_F(Command, ReadsStandardInput) {
  write("t.draw", kTriangle);
  EXPECT_EQ(run("draw - -o a.png", "t.draw"), 0) << err_;
  EXPECT_EQ(run("draw t.draw -o b.png"), 0);
  EXPECT_EQ(run("compare a.png b.png"), 0);
}

TEST_F(Command, DumpCheckAndCompareTellDifferences) {
  write("t.draw", kTriangle);
  EXPECT_EQ(run("dump t.draw"), 0);
  EXPECT_EQ(out_.substr(0, 20), "displayfile-dump 1\ns");
  const std::string dumped = out_;
  EXPECT_EQ(run("dump t.draw -o t.txt"), 0);
  EXPECT_EQ(read(folder_ / "t.txt"), dumped);
  EXPECT_EQ(run("check t.draw --golden gold --update"), 0);
  EXPECT_EQ(read(folder_ / "gold/t.txt"), dumped);
  EXPECT_EQ(run("check t.draw --golden gold"), 0);
  EXPECT_EQ(out_, "");
  write("t.draw",
        "set-window 0 1 0 1\nset-line-style none\nopen-segment 1\n"
        "polygon-abs-3 0 0 0  1 0 0  0 0.5 0\nclose-segment\n");
  EXPECT_EQ(run("check t.draw --golden gold"), 1);
  EXPECT_NE(out_.find("segment 1"), std::string::npos) << out_;
  EXPECT_NE(out_.find("0.5"), std::string::npos) << out_;
  EXPECT_EQ(run("dump t.draw -o u.txt"), 0);
  EXPECT_EQ(run("compare t.txt u.txt"), 1);
  EXPECT_EQ(run("compare t.txt t.txt"), 0);
  write("cut.txt", "displayfile-dump 1\nsegment 1 visible\n");
  expect_error("compare t.txt cut.txt", "cut.txt:3:1: the dump is cut short");
  expect_error("compare t.draw t.txt", "t.draw:1:1: not a display-file dump");
}

TEST_F(Command, CompareCountsWrongPixels) {
  write("t.draw", kTriangle);
  EXPECT_EQ(run("draw t.draw -o a.png --size 8x8 --ids a.npy"), 0);
  write("u.draw",
        "set-window 0 1 0 1\nset-line-style none\nopen-segment 1\nset-pick-id 5\n"
        "polygon-abs-3 0 0 0  1 0 0  1 1 0  0 1 0\nclose-segment\n");
  EXPECT_EQ(run("draw u.draw -o b.png --size 8x8 --ids b.npy"), 0);
  EXPECT_EQ(run("compare a.png b.png"), 1);
  EXPECT_NE(out_.find("36 wrong pixels of 64"), std::string::npos) << out_;
  EXPECT_EQ(run("compare a.npy b.npy"), 1);
  EXPECT_NE(out_.find("64 wrong pixels of 64"), std::string::npos) << out_;
  EXPECT_EQ(run("draw u.draw -o c.png --size 9x8"), 0);
  EXPECT_EQ(run("compare b.png c.png"), 1);
  EXPECT_EQ(out_, "the sizes differ: 8x8 and 9x8\n");
}

TEST_F(Command, ImportedMeshDrawsTheSamePicture) {
  write("m.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
  EXPECT_EQ(run("import m.obj -o m.draw"), 0) << err_;
  EXPECT_EQ(run("draw m.obj -o a.png --ids a.npy"), 0) << err_;
  EXPECT_EQ(run("draw m.draw -o b.png --ids b.npy"), 0) << err_;
  EXPECT_EQ(run("compare a.png b.png"), 0);
  EXPECT_EQ(run("compare a.npy b.npy"), 0);
  EXPECT_EQ(run("dump m.obj -o a.txt"), 0);
  EXPECT_EQ(run("dump m.draw -o b.txt"), 0);
  EXPECT_EQ(run("compare a.txt b.txt"), 0);
}

/// The loader reports on standard error what it loads.
TEST_F(Command, LoadsTheImportLibraryOnlyForItsFormats) {
  const std::string corners = "0 0 0\n1 0 0\n0 1 0\n";
  write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write("a.off", "OFF\n3 1 0\n" + corners + "3 0 1 2\n");
  write("a.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
            corners + "3 0 1 2\n");
  write("a.stl",
        "solid\nfacet normal 0 0 1\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
        "endfacet\nendsolid\n");
  write("a.gltf", "{}");
  setenv("LD_DEBUG", "files", 1);
  for (const char* format : {"obj", "off", "ply", "stl"}) {
    EXPECT_EQ(run(std::string("draw -o a.png a.") + format), 0);
    ASSERT_NE(err_.find("libpng"), std::string::npos) << "this loader does not say what it loads";
    EXPECT_EQ(err_.find("assimp"), std::string::npos) << format;
  }
  EXPECT_EQ(run("draw -o a.png a.gltf"), 2);
  unsetenv("LD_DEBUG");
  if (err_.find("built without the import library") != std::string::npos) GTEST_SKIP() << err_;
  EXPECT_NE(err_.find("assimp"), std::string::npos);
}

TEST_F(Command, SaysThatTheImportLibraryIsNotThere) {
  write("a.gltf", "{}");
  write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  for (const char* version : {"5", "6", "7"}) write(std::string("libassimp.so.") + version, "none");
  setenv("LD_LIBRARY_PATH", ".", 1);
  expect_error("draw a.gltf -o a.png", "the import library (Assimp)");
  EXPECT_EQ(run("draw a.obj -o a.png"), 0) << err_;
  unsetenv("LD_LIBRARY_PATH");
}

TEST_F(Command, ShadingIsThatOfMeshesDrawnOrImported) {
  write("m.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
  EXPECT_EQ(run("draw m.obj -o flat.png --ids flat.npy"), 0) << err_;
  EXPECT_EQ(run("draw m.obj -o a.png --ids a.npy --shading gouraud"), 0) << err_;
  EXPECT_EQ(run("compare flat.png a.png"), 1);
  EXPECT_EQ(run("compare flat.npy a.npy"), 0);
  EXPECT_EQ(run("import m.obj -o m.draw --shading gouraud"), 0) << err_;
  EXPECT_EQ(run("draw m.draw -o b.png"), 0) << err_;
  EXPECT_EQ(run("compare a.png b.png"), 0);
  EXPECT_EQ(run("draw m.obj -o v.png --shading gouraud --turntable 2"), 0) << err_;
  EXPECT_EQ(run("draw m.obj -o f.png --turntable 2"), 0) << err_;
  EXPECT_EQ(run("compare v-000.png f-000.png"), 1);
  expect_error("draw m.obj -o a.png --shading round",
               "shading is flat, gouraud or phong, not 'round'");
}

TEST_F(Command, HiddenMethodReplacesTheProgramsOwn) {
  write("t.draw",
        "set-window 0 1 0 1\nset-line-style none\nset-z-buffer on\nopen-segment 1\n"
        "set-pick-id 1\npolygon-abs-3 0 0 1  1 0 1  1 1 1  0 1 1\n"
        "set-pick-id 2\npolygon-abs-3 0 0 0  1 0 0  1 1 0  0 1 0\nclose-segment\n");
  const auto id = [&] { return static_cast<int>(read(folder_ / "i.npy")[128]); };
  EXPECT_EQ(run("draw t.draw -o t.png --size 1x1 --ids i.npy"), 0);
  EXPECT_EQ(id(), 1);
  EXPECT_EQ(run("draw t.draw -o t.png --size 1x1 --ids i.npy --hidden none"), 0);
  EXPECT_EQ(id(), 2);
  EXPECT_EQ(run("draw t.draw -o t.png --size 1x1 --ids i.npy --hidden auto"), 0);
  EXPECT_EQ(id(), 1);
}

TEST_F(Command, PlainZBufferTellsDepthsApartByItsFormat) {
  const auto sheets = [](const std::string& method) {
    return "set-window 0 1 0 1\nset-view-depth -1 1\nset-line-style none\n" + method +
           "open-segment 1\nset-pick-id 1\npolygon-abs-3 0 0 0.000002  1 0 0.000002  1 1 0.000002  "
           "0 1 0.000002\nset-pick-id 2\npolygon-abs-3 0 0 0  1 0 0  1 1 0  0 1 0\nclose-segment\n";
  };
  write("t.draw", sheets(""));
  const auto id = [&] { return static_cast<int>(read(folder_ / "i.npy")[128]); };
  for (const auto& [method, seen] :
       {std::pair("plain-z-buffer=16", 2), std::pair("plain-z-buffer=32", 1),
        std::pair("plain-z-buffer=double", 1), std::pair("z-buffer", 1)}) {
    EXPECT_EQ(run(std::string("draw t.draw -o t.png --size 1x1 --ids i.npy --hidden ") + method), 0)
        << err_;
    EXPECT_EQ(id(), seen) << method;
  }
  write("u.draw", sheets("set-hidden-line-removal on\nset-hidden-method plain-z-buffer=16\n"));
  EXPECT_EQ(run("draw u.draw -o u.png --size 1x1 --ids i.npy"), 0) << err_;
  EXPECT_EQ(id(), 2);
  expect_error("draw t.draw -o t.png --hidden plain-z-buffer=8", "plain-z-buffer=8");
}

TEST_F(Command, StatsSayWhatWasDrawn) {
  write("t.draw", kTriangle);
  EXPECT_EQ(run("draw t.draw -o t.png --stats"), 0);
  EXPECT_NE(out_.find("polygons entered   1"), std::string::npos) << out_;
}

/// The picture that auto chooses for lines over invisible fills is the surface method's: each of
/// its lines is one that the painter shows (tests/auto_method_test.cpp).
TEST_F(Command, AutoDrawsLinesAlone) {
  write("t.draw",
        "set-window 0 1 0 1\nset-fill-style solid 1 1 1\nset-line-style solid 0 0 0\n"
        "open-segment 1\npolygon-abs-3 0.1 0.1 0  0.9 0.1 0  0.9 0.5 0  0.1 0.5 0\n"
        "polygon-abs-3 0.3 0.3 0.5  0.7 0.3 0.5  0.7 0.9 0.5  0.3 0.9 0.5\nclose-segment\n");
  EXPECT_EQ(run("draw t.draw --hidden auto -o a.svg --explain"), 0) << err_;
  EXPECT_NE(out_.find("auto: franklin: vectors whose fills have the background's colour"),
            out_.npos)
      << out_;
  EXPECT_EQ(run("draw t.draw --hidden franklin -o f.svg"), 0) << err_;
  EXPECT_EQ(read(folder_ / "a.svg"), read(folder_ / "f.svg"));
  EXPECT_EQ(run("draw t.draw --hidden auto -o b.svg --background none --explain"), 0) << err_;
  EXPECT_NE(out_.find("auto: map"), out_.npos) << out_;
  EXPECT_EQ(run("draw t.draw --hidden auto -o c.svg --ids i.npy"), 0) << err_;
  EXPECT_TRUE(fs::exists(folder_ / "i.npy"));
}

TEST_F(Command, CastsRaysBeforeViewing) {
  const std::string text =
      "set-perspective 0.3 0.4 3\nset-light 1 2 3\nset-shadows on\nopen-segment 1\n"
      "set-fill-style solid 0.9 0.5 0.2\npolygon-abs-3 -0.8 -0.7 0.3  0.7 -0.6 -0.4  0.1 0.8 0.2\n"
      "set-fill-style solid 0.2 0.5 0.9\npolygon-abs-3 0.6 -0.7 0.4  -0.7 -0.5 -0.3  -0.1 0.7 0\n"
      "close-segment\n";
  write("t.draw", text);
  const std::string drawn = "draw t.draw --size 60x50 ";
  const std::string by_rays = drawn + "--hidden world-ray-cast ";
  EXPECT_EQ(run(drawn + "-o z.png --ids z.npy --depth zd.npy --hidden z-buffer"), 0) << err_;
  EXPECT_EQ(run(by_rays + "-o w.png --ids w.npy --depth wd.npy --threads 2"), 0) << err_;
  EXPECT_EQ(run("compare z.png w.png"), 0) << out_;
  EXPECT_EQ(run("compare z.npy w.npy"), 0) << out_;
  EXPECT_EQ(run("compare zd.npy wd.npy"), 0) << out_;
  EXPECT_EQ(run(by_rays + "-o s.svg"), 0) << err_;
  EXPECT_EQ(run(by_rays + "-o t.png --turntable 3 --stats"), 0) << err_;
  EXPECT_NE(out_.find("3, from 1 tree of boxes"), std::string::npos) << out_;
  EXPECT_EQ(run("compare t-000.png w.png"), 0) << out_;
  EXPECT_EQ(run(drawn + "-o b.png --turntable 3"), 0) << err_;
  EXPECT_EQ(run("compare b-001.png t-001.png"), 0) << out_;
  write("own.draw",
        "set-hidden-line-removal on\nset-back-face-removal off\n"
        "set-hidden-method world-ray-cast\n" +
            text);
  EXPECT_EQ(run("draw own.draw --size 60x50 -o own.png"), 0) << err_;
  EXPECT_EQ(run("compare own.png w.png"), 0) << out_;
  write("late.draw", text + "set-hidden-method world-ray-cast\n");
  expect_error("draw late.draw -o late.png", "late.draw:10:1: world-ray-cast needs world");
  write("image.draw", text + "set-image-scale 1 0.5 0.5\n");
  expect_error("draw image.draw -o i.png --hidden world-ray-cast", "image transformation");
}

TEST_F(Command, BadInputGivesOneMessageWithItsPlace) {
  write("t.draw", kTriangle);
  write("bad.draw", "open-segment 1\npolygon-abs-3 0 0 0  1 0 0\nclose-segment\n");
  expect_error("draw bad.draw -o x.png", "bad.draw:2:");
  write("unknown.draw", "\n\n  polygon-abs-9 1 2 3\n");
  expect_error("draw unknown.draw -o x.png", "unknown.draw:3:3: unknown routine");
  write("arguments.draw", "set-window 0 1 0\n");
  expect_error("dump arguments.draw -o x.txt", "arguments.draw:1:");
  write("close.draw", "close-segment\n");
  expect_error("draw close.draw -o x.svg", "close.draw:1:1: no segment open");
  write("nan.draw", "open-segment 1\nmove-abs-3 0 nan 0\n");
  expect_error("draw nan.draw -o x.pdf", "nan.draw:2:14:");
  write("open.draw", "open-segment 1\nmove-abs-2 0 0\n");
  expect_error("draw open.draw -o x.png", "open.draw:");
  write("binary.draw", std::string("\x7f"
                                   "ELF\0\1\2\3",
                                   8));
  expect_error("draw binary.draw -o x.png", "binary.draw");
  expect_error("draw missing.draw -o x.png", "missing.draw");
  expect_error("draw . -o x.png", ".");
  write("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  expect_error("draw index.obj -o x.png", "index.obj");
  write("nan.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n");
  expect_error("draw nan.obj -o x.png", "nan.obj");
  write("inf.obj", "v 0 0 0\nv 1 1e999 0\nv 0 1 0\nf 1 2 3\n");
  expect_error("draw inf.obj -o x.png", "inf.obj");
  write("huge.ply",
        "ply\nformat ascii 1.0\nelement vertex 1000000000\nproperty float x\n"
        "property float y\nproperty float z\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n0 0 0\n");
  expect_error("draw huge.ply -o x.png", "huge.ply");
  write("empty.obj", "");
  expect_error("import empty.obj -o x.draw", "empty.obj");
  write("text.xyzzy", "hello");
  expect_error("draw text.xyzzy -o x.png", "text.xyzzy");
}

TEST_F(Command, BadCommandLinesAndOutputs) {
  write("t.draw", kTriangle);
  expect_error("draw t.draw -o x.png --size 0x0", "0x0");
  expect_error("draw t.draw -o x.png --size 1000000x1000000", "1000000x1000000");
  expect_error("draw t.draw -o x.png --size 12", "WIDTHxHEIGHT");
  expect_error("draw t.draw -o x.png --size 12x-5", "12x-5");
  expect_error("draw t.draw -o x.gif", ".gif");
  expect_error("draw t.draw -o nowhere/x.png", "nowhere/x.png");
  expect_error("draw t.draw -o .", ".");
  expect_error("draw t.draw -o x.png --ids nowhere/i.npy", "nowhere/i.npy");
  expect_error("draw t.draw -o x.png --depth nowhere/z.npy", "nowhere/z.npy");
  expect_error("draw t.draw -o x.png --hidden appel --ids i.npy", "'appel' does not draw");
  expect_error("draw t.draw -o x.png --hidden franklin --ids i.npy", "'franklin' does not draw");
  expect_error("draw t.draw -o x.png --hidden roberts --depth z.npy", "'roberts' does not draw");
  expect_error("draw t.draw -o x.png --hidden franklin --device osmesa", "expected the software");
  expect_error("draw t.draw -o x.png --hidden nonsense", "nonsense");
  expect_error("draw t.draw -o x.png --device plotter", "plotter");
  expect_error("draw t.draw -o x.svg --device osmesa", "osmesa");
  expect_error("draw t.draw -o x.png --precision fuzzy", "fuzzy");
  expect_error("dump t.draw -o nowhere/x.txt", "nowhere/x.txt");
  expect_error("check t.draw --golden nowhere", "nowhere");
  expect_error("compare t.draw missing.txt", "missing.txt");
  write("broken.png", "\x89PNG\r\n");
  expect_error("compare broken.png broken.png", "broken.png");
  expect_error("import t.draw -o x.draw", "t.draw");
  EXPECT_EQ(run("fly"), 2);
  EXPECT_EQ(run(""), 2);
  EXPECT_EQ(run("draw"), 2);
  EXPECT_EQ(run("--help"), 0);
}

/// Whatever they begin with.
TEST_F(Command, NumbersAreDecimal) {
  write("t.draw", kTriangle);
  EXPECT_EQ(run("draw t.draw -o a.ppm --size 40x40 --samples 08"), 0) << err_;
  EXPECT_EQ(run("draw t.draw -o b.ppm --size 40x40 --samples 8"), 0) << err_;
  EXPECT_EQ(read(folder_ / "a.ppm"), read(folder_ / "b.ppm"));
  EXPECT_EQ(run("draw t.draw -o c.ppm --size 40x40 --samples 010"), 0) << err_;
  EXPECT_EQ(run("draw t.draw -o d.ppm --size 40x40 --samples +10"), 0) << err_;
  EXPECT_EQ(read(folder_ / "c.ppm"), read(folder_ / "d.ppm"));
  EXPECT_NE(read(folder_ / "c.ppm"), read(folder_ / "a.ppm"));
  expect_error("draw t.draw -o x.png --samples 0x2",
               "--samples: 0x2: expected a whole number, 1 to 16: displayfile draw --help");
  expect_error("draw t.draw -o x.png --threads -1", "--threads: -1: expected a whole number");
  expect_error("truth t.draw --hidden roberts --line-samples -1", "--line-samples: -1: expected");
  expect_error("draw t.draw -o x.svg --paper a4 --margin nan", "--margin: nan: expected");
  expect_error("sheet t.draw -o x.svg --hatch inf", "--hatch: inf: expected");
}

TEST_F(Command, EmptyValuesAreRefused) {
  write("t.draw", kTriangle);
  for (const char* option : {"--size", "--fov", "--background", "--precision", "--hidden", "--ids",
                             "--samples", "--limit-seconds", "--paper", "--import-memory"}) {
    expect_error(fmt::format("draw t.draw -o x.png {} ''", option),
                 fmt::format("{}: is empty: expected ", option));
  }
  expect_error("draw t.draw -o ''", "--output: is empty: expected OUT.");
  expect_error("draw t.draw '' -o x.png", "INPUT: is empty: expected FILE.draw|MESH");
  expect_error("check t.draw --golden ''", "--golden: is empty: expected FOLDER|FILE");
  expect_error("sheet t.draw -o x.svg --scale ''", "--scale: is empty: expected PAPER:PART");
  expect_error("sheet t.draw -o x.svg --margin ''", "--margin: is empty: expected MM");
  expect_error("surface x -o x.svg --x ''", "--x: is empty: expected A:B");
  EXPECT_EQ(run("sheet t.draw -o s.svg --title '' --date ''"), 0) << err_;
}

TEST_F(Command, SaysWhatAnUnknownWordMayHaveMeant) {
  write("t.draw", kTriangle);
  expect_error("drew t.draw -o x.png", "unknown command 'drew': did you mean 'draw'? expected one");
  expect_error("frobnicate", "unknown command 'frobnicate': expected one of draw dump check");
  expect_error("t.draw -o x.png", "unknown command 't.draw': it is a file: expected draw, dump, ");
  expect_error("draw t.draw --sise 5x5 -o x.png",
               "unknown option '--sise': did you mean '--size'?");
  expect_error("draw t.draw --sise=5x5 -o x.png",
               "unknown option '--sise': did you mean '--size'?");
  expect_error("draw --otput x.png", "unknown option '--otput': did you mean '--output'?");
  expect_error("check t.draw --glden g", "did you mean '--golden'? displayfile check --help lists");
  expect_error("draw t.draw -o x.png -q", "unknown option '-q': displayfile draw --help lists all");
  expect_error("--hepl", "unknown option '--hepl': did you mean '--help'? displayfile --help");
  expect_error("draw t.draw", "--output is required: displayfile draw --help lists all");
  expect_error("draw -- t.draw -o x.png", "--output is required: displayfile draw --help lists");
  expect_error("draw t.draw -o x.png --hidden bps", "'bps': did you mean 'bsp'? expected one of");
  expect_error("draw t.draw -o x.png --device osmsea", "did you mean 'osmesa'? expected software");
  expect_error("draw t.draw -o x.pngg", "did you mean '.png'? expected one of .png");
  expect_error("draw t.draw -o x --format pgn", "did you mean '.png'? expected one of .png");
  write("u.draw", "set-hidden-method bps\n");
  expect_error("draw u.draw -o x.png", "u.draw:1:19: unknown hidden-surface method 'bps': did you");
  write("v.draw", "opensegment 1\n");
  expect_error("draw v.draw -o x.png",
               "unknown routine 'opensegment': did you mean 'open-segment'?");
}

TEST_F(Command, VersionIsTheProjectsAndTellsLibraries) {
  EXPECT_EQ(run("--version"), 0) << err_;
  EXPECT_TRUE(out_.starts_with("displayfile " DISPLAYFILE_VERSION "\n")) << out_;
  EXPECT_NE(out_.find("\nimport library (Assimp)  "), std::string::npos) << out_;
  EXPECT_NE(out_.find("\nOSMesa  "), std::string::npos) << out_;
}

/// CGAL and dxflib are under the GPL, and so are the modules that are compiled with them.
TEST_F(Command, VersionAndManualPagesHaveTheLicencesOfThisBuild) {
  EXPECT_EQ(run("--version"), 0) << err_;
  const std::size_t at = out_.find("\nbuilt without ");
  const std::string without = at == out_.npos ? "" : out_.substr(at);
  const auto has = [&](const char* library) { return without.find(library) == without.npos; };
  std::string modules;
  if (has("CGAL")) modules += "; modules: displayfile-solids (CGAL) GPL-3.0-or-later";
  if (has("dxflib")) {
    modules += modules.empty() ? "; modules: " : ", ";
    modules += "displayfile-dxf (dxflib) GPL-2.0-or-later";
  }
  EXPECT_NE(out_.find("\nlicence                  MIT" + modules + "\n"), out_.npos) << out_;
  for (const char* page : {"--manual", "--manual draw", "--manual bench"}) {
    EXPECT_EQ(run(page), 0) << err_;
    EXPECT_NE(out_.find(".SH LICENCE\nMIT"), out_.npos) << page << out_;
    EXPECT_EQ(out_.find("displayfile\\-solids (CGAL) GPL\\-3.0\\-or\\-later") != out_.npos,
              has("CGAL"))
        << page << out_;
  }
}

/// The modules alone contain code under the GPL.
TEST_F(Command, WithoutItsModulesTheCommandNamesThem) {
  const std::string folder = "DISPLAYFILE_MODULES=/nonexistent ";
  EXPECT_EQ(run("--version"), 0) << err_;
  if (out_.find("displayfile-solids") != out_.npos) {
    write("solid.draw",
          "open-segment 1\nbegin-solid difference\nbox-3 0 1 0 1 0 1\n"
          "box-3 0.5 2 0.5 2 0.5 2\nend-solid\nclose-segment\n");
    before_ = folder;
    expect_error("draw solid.draw -o x.png", "displayfile-solids.so." DISPLAYFILE_VERSION);
    expect_error("draw solid.draw -o x.png", "/nonexistent/displayfile-solids.so");
    before_.clear();
  }
  EXPECT_EQ(run("--version"), 0) << err_;
  if (out_.find("displayfile-dxf") != out_.npos) {
    write("part.draw", "open-segment 1\nbox-3 0 1 0 1 0 1\nclose-segment\n");
    before_ = folder;
    expect_error("sheet part.draw -o x.dxf", "/nonexistent/displayfile-dxf.so");
    before_.clear();
  }
}

TEST_F(Command, HelpGroupsOptionsByWhatTheyAreFor) {
  for (const char* command : {"draw", "check", "dump"}) {
    EXPECT_EQ(run(std::string(command) + " --help"), 0);
    EXPECT_NE(out_.find("\nHidden surfaces:\n"), std::string::npos) << out_;
  }
  EXPECT_EQ(run("draw --help"), 0);
  EXPECT_LT(out_.find("\nOutput:\n  -o,--output"), out_.find("\nPicture:\n  --size")) << out_;
}

TEST_F(Command, WarnsWhyNothingIsSeen) {
  write("t.draw", "translate-3 9 0 0\n" + kTriangle);
  EXPECT_EQ(run("draw t.draw -o t.png"), 0);
  EXPECT_EQ(err_,
            "t.draw: nothing is seen: the only polygon or line is to the right of the window\n");
  EXPECT_TRUE(fs::exists(folder_ / "t.png"));
  EXPECT_EQ(run("draw t.draw -o t.svg --hidden world-ray-cast"), 0);
  EXPECT_EQ(err_,
            "t.draw: nothing is seen: the only polygon or line is to the right of the window\n");
  EXPECT_EQ(run("draw - -o t.png", "t.draw"), 0);
  EXPECT_NE(err_.find("standard input: nothing is seen: "), std::string::npos) << err_;
  write("u.draw", kTriangle);
  EXPECT_EQ(run("draw t.draw u.draw -o '{name}.png'"), 0);
  EXPECT_EQ(err_,
            "t.draw: nothing is seen: the only polygon or line is to the right of the window\n");
  write("away.draw", "set-view-reference-point 50 0 0\nset-window -1 1 -1 1\n");
  write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\np 1\n");
  EXPECT_EQ(run("draw away.draw m.obj -o m.png"), 0);
  EXPECT_NE(err_.find("away.draw and others: nothing is seen: the only polygon or line is to the "
                      "left of the window\n"),
            std::string::npos)
      << err_;
  EXPECT_EQ(run("check t.draw --golden gold --picture --update"), 0);
  EXPECT_NE(err_.find("t.draw: nothing is seen"), std::string::npos) << err_;
}

TEST_F(Command, WarnsOfWhatIsSeenEdgeOnOrSmallerThanAPixel) {
  const std::string fill = "set-line-style none\nopen-segment 1\npolygon-abs-3 ";
  write("edge.draw", fill + "0.1 0 0  0.1 0.5 0  0.1 0 0.5\nclose-segment\n");
  write("small.draw", fill + "0.001 0.001 0  0.003 0.001 0  0.001 0.003 0\nclose-segment\n");
  write("small.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string edge_on =
      "edge.draw: nothing is seen: the only polygon or line is seen edge-on, with no line style\n";
  const std::string thin =
      ": nothing is seen: the only polygon or line is smaller or thinner than a pixel, over no "
      "sample of a pixel\n";
  for (const std::string hidden : {"", " --hidden z-buffer", " --hidden map"}) {
    for (const std::string file : {"t.png", "t.svg"}) {
      EXPECT_EQ(run("draw edge.draw -o " + file + hidden), 0);
      EXPECT_EQ(err_, edge_on);
    }
    EXPECT_EQ(run("draw small.draw -o t.png --size 100x100" + hidden), 0);
    EXPECT_EQ(err_, "small.draw" + thin);
    EXPECT_EQ(run("draw small.draw -o t.svg --size 100x100" + hidden), 0);
    EXPECT_EQ(err_, "");
    EXPECT_EQ(run("draw small.draw -o t.png --samples 1 --size 4000x4000" + hidden), 0);
    EXPECT_EQ(err_, "");
  }
  EXPECT_EQ(run("draw - -o t.png --size 100x100", "small.draw"), 0);
  EXPECT_EQ(err_, "standard input" + thin);  // which cannot be read again, and is retained
  write("right.draw", fill + "5 0 0  6 0 0  5 1 0\nclose-segment\n");
  EXPECT_EQ(run("draw - -o t.png --hidden world-ray-cast", "right.draw"), 0);
  EXPECT_NE(err_.find("the only polygon or line is to the right of the window"), std::string::npos)
      << err_;
  EXPECT_EQ(run("draw small.obj -o t.png --size 1x1"), 0);  // retained alone
  EXPECT_EQ(run("check edge.draw --golden gold --picture --update"), 0);
  EXPECT_NE(err_.find(edge_on), std::string::npos) << err_;
}

TEST_F(Command, HelpNamesEveryFormatAndDevice) {
  ASSERT_EQ(run("draw --help"), 0);
  const std::string help = std::regex_replace(out_, std::regex("\\s+"), " ");
  for (const auto& format : displayfile::picture_formats()) {
    EXPECT_NE(help.find(" " + std::string(format.name) + " ("), help.npos) << format.name;
  }
  for (const auto& device : displayfile::raster_devices()) {
    EXPECT_NE(help.find(std::string(device.name) + " ("), help.npos) << device.name;
  }
  write("t.draw", kTriangle);
  expect_error("draw t.draw -o x.gif", "expected one of .png .ppm .svg .pdf .eps .dxf");
  expect_error("draw t.draw -o x.png --device plotter", "expected software or osmesa");
  expect_error("draw t.draw -o x.svg --device osmesa", "expected .png or .ppm");
}

/// Libraries that most pictures do not need are loaded only when they are needed.
TEST_F(Command, LoadsWhatAPictureNeeds) {
  write("t.draw", kTriangle);
  const auto loaded = [&](const std::string& arguments) {
    setenv("LD_DEBUG", "files", 1);  // the loader reports on standard error what it loads
    EXPECT_EQ(run(arguments), 0);
    unsetenv("LD_DEBUG");
    return err_;
  };
  const std::string png = loaded("draw t.draw -o t.png --hidden z-buffer");
  ASSERT_NE(png.find("libpng"), png.npos) << "this loader does not say what it loads";
  for (const char* name :
       {"libOSMesa", "libLLVM", "libcairo", "libX11", "libembree", "libgl2ps", "libhwy"}) {
    EXPECT_EQ(png.find(name), png.npos) << name;
  }
  EXPECT_NE(loaded("draw t.draw -o t.pdf").find("libcairo"), png.npos);
  write("text.draw", "open-segment 1\ntext \"x\"\nclose-segment\n");
  EXPECT_NE(loaded("draw text.draw -o t.png").find("libcairo"), png.npos);
  EXPECT_EQ(loaded("draw text.draw -o t.svg --ids t.npy").find("libcairo"), png.npos);
}

TEST_F(Command, SaysThatALibraryIsNotThere) {
  write("t.draw", kTriangle);
  write("libcairo.so.2", "no library");
  write("libOSMesa.so.8", "no library");
  setenv("LD_LIBRARY_PATH", ".", 1);
  expect_error("draw t.draw -o t.pdf", "libcairo.so.2");
  expect_error("draw t.draw -o t.png --device osmesa", "has no OSMesa");
  EXPECT_EQ(run("draw t.draw -o t.png"), 0) << err_;
  write("text.draw", "open-segment 1\ntext \"x\"\nclose-segment\n");
  expect_error("draw text.draw -o text.png", "texts in pixels are drawn by Cairo");
  expect_error("draw text.draw -o text.ppm --samples 3 --hidden scan-line-z", "libcairo.so.2");
  EXPECT_EQ(run("draw text.draw -o text.svg --ids text.npy"), 0) << err_;
  unsetenv("LD_LIBRARY_PATH");
}

TEST_F(Command, PickSaysWhatIsSeenThere) {
  write("p.draw",
        "open-segment 3\nset-pick-id 12\npolygon-abs-3 -1 -1 0  1 -1 0  1 0 0  -1 0 0\n"
        "set-pick-id -1\nmove-abs-2 -1 0.5\nline-abs-2 1 0.5\nclose-segment\n");
  const auto picked = [&](const std::string& at) {
    EXPECT_EQ(run("draw p.draw -o p.png --size 100x100 --pick " + at), 0) << err_;
    return out_;
  };
  EXPECT_EQ(picked("50,70"), "at 50,70: polygon 12 of segment 3, depth 0.75\n");
  EXPECT_EQ(picked("50,98.5,2"), "at 50,98.5: an edge of polygon 12 of segment 3, depth 0.75\n");
  EXPECT_EQ(picked("50,26,2"), "at 50,26: line of segment 3, depth 0.75\n");
  EXPECT_EQ(picked("50,26"), "at 50,26: nothing\n");
  EXPECT_EQ(picked("500,26"), "at 500,26: outside of the picture, 100 x 100 pixels\n");
  fs::remove(folder_ / "p.png");
  for (const char* wrong : {"x", "1", "1,", "1,2,", "1,2,3,4", "1;2", "nan,1", "1,inf", "1,2,-1",
                            "1,2,1e9", "1,2 ", "''"}) {
    expect_error(std::string("draw p.draw -o p.png --pick \"") + wrong + "\"", "--pick");
  }
}

/// A picture in which nothing is visible is drawn, however little of the limits is left to find the
/// reason.
TEST_F(Command, NothingSeenIsToldWithinTheLimits) {
  std::string program = "open-segment 1\n";
  for (int i = 0; i < 100000; ++i) program += "polygon-abs-3 5 5 0 6 5 0 5 6 0\n";
  write("off.draw", program + "close-segment\n");
  write("x.svg", "old");
  int failed = 0;
  for (int megabytes = 16; megabytes < 160; megabytes += 8) {
    write("x.svg", "old");
    const int status =
        run("draw off.draw -o x.svg --limit-memory " + std::to_string(megabytes) + "M");
    EXPECT_EQ(status == 0, read(folder_ / "x.svg") != "old") << megabytes;
    failed += status != 0;
  }
  EXPECT_GT(failed, 0);
}

/// A picture too large for the memory is refused before any work, with its bytes in the message,
/// and nothing is written.
TEST_F(Command, OutOfMemoryStatesTheBytes) {
  write("cube.draw", "open-segment 1\npolygon-abs-3 0 0 0  1 0 0  0 1 0\nclose-segment\n");
  before_ = "ulimit -v 2000000 && ";
  expect_error("truth cube.draw --size 60000x60000 --ids ids.npy",
               "out of memory: the truth of 60000 x 60000 pixels needs at least 61200000000 bytes, "
               "and the limit is 2048000000");
  expect_error("draw cube.draw -o out.png --size 16384x16384 --samples 1 --device osmesa",
               "out of memory: out.png of 16384 x 16384 needs at least 2147483");
  EXPECT_EQ(run("truth cube.draw --size 60x60 --ids ids.npy"), 0) << err_;
}

TEST_F(Command, OptionsOfVectorsOutOfTheirRangesAreRefused) {
  write("t.draw", kTriangle);
  expect_error("draw t.draw -o t.svg --seams glued", "expected trapped or butted");
  for (const char* precision : {"0", "2", "fine", "0.01,0.01", "nan"}) {
    expect_error(std::string("draw t.draw -o t.svg --vector-precision ") + precision,
                 "expected 0.001 to 1 pixels");
  }
  EXPECT_EQ(run("draw t.draw -o t.svg --seams butted --vector-precision 0.05 --pick-ids"), 0);
}
/// An error in a program is reported, not the limit that sorting its first half would exceed.
TEST_F(Command, AWrongProgramBeforeAMeshIsTold) {
  std::string program = "set-hidden-line-removal on\nset-hidden-method bsp\nopen-segment 9\n";
  for (int k = 0; k < 30; ++k) {
    program +=
        fmt::format("polygon-abs-3 0 {} 0  1 {} .3  .5 1 {}\n", 0.03 * k, 0.9 - 0.03 * k, 0.02 * k);
  }
  write("p.draw", program + "no-such-routine 1\n");
  write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  expect_error("draw p.draw m.obj -o x.svg --limit-pieces 31", "p.draw:34:1: unknown routine");
}

}  // namespace
