// Pictures of many inputs in one call of the command, and pictures on standard output.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <csignal>
#include <regex>
#include <string>
#include <vector>

#include "tests/command_fixture.h"

namespace {

std::string square(const std::string& colour) {
  return "set-window 0 1 0 1\nset-window-fit stretch\nset-line-style none\nset-fill-style solid " +
         colour +
         "\nopen-segment 1\npolygon-abs-3 0 0 0  0.5 0 0  0.5 0.5 0  0 0.5 0\nclose-segment\n";
}

const std::string kRed = square("1 0 0"), kGreen = square("0 1 0"), kBlue = square("0 0 1");
const std::string kMesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

class Batch : public Command {
 protected:
  Batch() {
    write("red.draw", kRed);
    write("green.draw", kGreen);
    write("mesh.obj", kMesh);
    for (const char* folder : {"a", "b", "a/deep"}) fs::create_directory(folder_ / folder);
    write("a/house.draw", kRed);
    write("b/house.draw", kGreen);
    write("a/deep/house.draw", kBlue);
  }

  /// The picture equals that of the input drawn alone.
  void expect_picture_of(const std::string& input, const std::string& picture) {
    ASSERT_EQ(run("draw '" + input + "' --size 40x30 -o alone.png"), 0) << err_;
    EXPECT_EQ(read(folder_ / "alone.png"), read(folder_ / picture)) << picture;
  }
};

TEST_F(Batch, DrawsAPictureOfEachInput) {
  for (const char* threads : {"1", "2", "7"}) {
    EXPECT_EQ(run("draw red.draw mesh.obj green.draw -o '{name}.png' --ids '{name}.npy' "
                  "--size 40x30 --threads " +
                  std::string(threads)),
              0)
        << err_;
    EXPECT_EQ(out_ + err_, "");
    expect_picture_of("red.draw", "red.png");
    expect_picture_of("mesh.obj", "mesh.png");
    expect_picture_of("green.draw", "green.png");
    EXPECT_TRUE(fs::exists(folder_ / "green.npy"));
    for (const char* file : {"red.png", "mesh.png", "green.png"}) fs::remove(folder_ / file);
  }
}

/// Annotation that is cut off is that of one picture: its file is named, not the pattern.
TEST_F(Batch, WarningsOfAnnotationNameThePicture) {
  write("cut.draw", kRed + "open-segment 2\nleader-3 0.4 0.4 0 \"Far\" 400 0\nclose-segment\n");
  ASSERT_EQ(run("draw green.draw cut.draw -o '{name}.png' --size 40x30"), 0) << err_;
  EXPECT_NE(err_.find("cut.png: annotation reaches beyond the picture"), std::string::npos) << err_;
  EXPECT_EQ(err_.find("{name}"), std::string::npos) << err_;
}

TEST_F(Batch, FieldsAreTheInputsFolderNameExtensionAndPlace) {
  const std::string inputs = " --size 40x30 a/house.draw b/house.draw a/deep/house.draw ";
  EXPECT_EQ(run("draw" + inputs + "-o '{folder}/{name}.png'"), 0) << err_;
  expect_picture_of("a/deep/house.draw", "a/deep/house.png");
  EXPECT_EQ(run("draw" + inputs + "-o '{folder}-{name}.png'"), 0) << err_;
  expect_picture_of("a/deep/house.draw", "a/deep-house.png");
  fs::create_directory(folder_ / "out");
  EXPECT_EQ(run("draw" + inputs + "-o 'out/{folder}/{name}.png' --ids 'out/{folder}/i/{name}.npy'"),
            0)
      << err_;
  expect_picture_of("b/house.draw", "out/b/house.png");
  expect_picture_of("a/deep/house.draw", "out/a/deep/house.png");
  EXPECT_TRUE(fs::exists(folder_ / "out/a/deep/i/house.npy"));
  EXPECT_EQ(run("draw" + inputs + "-o 'out/{number}.{ext}.png'"), 0) << err_;
  expect_picture_of("a/deep/house.draw", "out/002.draw.png");
  EXPECT_EQ(run("draw red.draw -o '{{{name}}}.png' --size 40x30"), 0) << err_;
  expect_picture_of("red.draw", "{red}.png");
  EXPECT_EQ(run("draw red.draw --size 40x30 -o 'out/{folder}/{name}.png'"), 0) << err_;
  expect_picture_of("red.draw", "out/red.png");
  EXPECT_EQ(run("draw - --size 40x30 -o '{name}.png'", "red.draw"), 0) << err_;
  expect_picture_of("red.draw", "stdin.png");
}

/// An input without an extension gives a name like any other, and not the root folder.
TEST_F(Batch, InputsWithoutAnExtension) {
  write("triangle",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float "
        "y\nproperty float z\nelement face 1\nproperty list uchar int "
        "vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  for (const auto& [pattern, made] : {std::pair("{name}.{ext}.png", "triangle.png"),
                                      std::pair("{name}-{ext}.png", "triangle-.png"),
                                      std::pair("{ext}/{name}-2.png", "triangle-2.png"),
                                      std::pair("a/{ext}/{name}-3.png", "a/triangle-3.png")}) {
    EXPECT_EQ(run("draw triangle --size 40x30 -o '" + std::string(pattern) + "'"), 0) << err_;
    EXPECT_TRUE(fs::exists(folder_ / made)) << pattern;
  }
}

/// The output never leaves the folder before the field, whatever the input's folder is.
TEST_F(Batch, FoldersStayBelowWhatStandsBeforeThem) {
  fs::create_directory(folder_ / "out");
  const std::string root = folder_.string();
  EXPECT_EQ(run("draw --size 40x30 a/../../" + folder_.filename().string() + "/b/house.draw " +
                root + "/a/house.draw -o 'out/{folder}/{name}.png'"),
            0)
      << err_;
  EXPECT_TRUE(fs::exists(folder_ / "out" / folder_.filename() / "b/house.png"));
  EXPECT_TRUE(fs::exists(fs::path(root + "/out" + root) / "a/house.png"));
  EXPECT_EQ(run("draw --size 40x30 " + root + "/a/house.draw -o '{folder}/beside.png'"), 0) << err_;
  EXPECT_TRUE(fs::exists(folder_ / "a/beside.png"));
}

/// Nor does it depending on its name: the text before the last dot may be one that leads elsewhere.
TEST_F(Batch, NamesStayBelowWhatStandsBeforeThem) {
  fs::create_directory(folder_ / "out");
  fs::create_directory(folder_ / "sub");
  write("sub/...draw", kRed);
  write("sub/..draw", kRed);
  write("picture.png", "precious");
  EXPECT_EQ(run("draw --size 40x30 sub/...draw sub/..draw -o 'out/{name}/picture.png'"), 0) << err_;
  EXPECT_EQ(read(folder_ / "picture.png"), "precious");
  EXPECT_TRUE(fs::exists(folder_ / "out/...draw/picture.png"));
  EXPECT_TRUE(fs::exists(folder_ / "out/..draw/picture.png"));
}

/// --with is entered before each input: its view holds for meshes, its styles for programs.
TEST_F(Batch, ACommonProgram) {
  write("view.draw", "set-background 0 0 1\nset-perspective 3 1 6\nset-fill-style solid gold\n");
  write("plain.draw", "open-segment 1\npolygon-abs-3 0 0 0  1 0 0  0 1 0\nclose-segment\n");
  const std::string size = " --size 40x30";
  ASSERT_EQ(run("draw view.draw mesh.obj -o 1.png" + size), 0) << err_;
  ASSERT_EQ(run("draw view.draw plain.draw -o 2.png" + size), 0) << err_;
  ASSERT_EQ(run("draw view.draw plain.draw mesh.obj -o both.png" + size), 0) << err_;
  EXPECT_EQ(run("draw --with view.draw mesh.obj plain.draw -o 'with-{name}.png'" + size), 0)
      << err_;
  EXPECT_EQ(read(folder_ / "with-mesh.png"), read(folder_ / "1.png"));
  EXPECT_EQ(read(folder_ / "with-plain.png"), read(folder_ / "2.png"));
  EXPECT_FALSE(fs::exists(folder_ / "with-view.png"));
  EXPECT_EQ(run("draw --with view.draw plain.draw mesh.obj -o with.png" + size), 0) << err_;
  EXPECT_EQ(read(folder_ / "with.png"), read(folder_ / "both.png"));
  expect_error("draw --with - mesh.obj -o x.png", "--with -: is read for each input");
  expect_error("draw --with none.draw mesh.obj -o x.png", "none.draw: cannot be read");
  fs::create_directory(folder_ / "out");
  fs::create_symlink("../view.draw", folder_ / "out/mesh.png");
  expect_error("draw --with view.draw mesh.obj -o 'out/{name}.png'", "and an input");
}

/// A line of a list that names several inputs is one figure.
TEST_F(Batch, AFigureOfSeveralInputs) {
  write("view.draw", "set-perspective 3 1 6\nset-fill-style solid 0 0.5 0\n");
  write("my part.obj", kMesh);
  write("list.txt", "view.draw mesh.obj\nred.draw\n\nview.draw\t\"my part.obj\"\nmy part.obj\n");
  const std::string size = " --size 40x30";
  ASSERT_EQ(run("draw view.draw mesh.obj -o mesh.png" + size), 0) << err_;
  expect_error("draw @list.txt -o '{name}.png'", "the output of my part.obj and of my part.obj");
  EXPECT_EQ(run("draw @list.txt -o 'f-{number}-{name}.png'" + size), 0) << err_;
  EXPECT_EQ(read(folder_ / "f-000-mesh.png"), read(folder_ / "mesh.png"));
  expect_picture_of("red.draw", "f-001-red.png");
  EXPECT_EQ(read(folder_ / "f-002-my part.png"), read(folder_ / "mesh.png"));
  expect_picture_of("my part.obj", "f-003-my part.png");
  write("one.txt", "view.draw none.obj\nno part.obj\n");
  EXPECT_EQ(run("draw @one.txt -o 'g-{name}.png'" + size), 2);
  EXPECT_NE(err_.find("none.obj: no such file"), std::string::npos) << err_;
  EXPECT_NE(err_.find("no part.obj: no such file"), std::string::npos) << err_;
  ASSERT_EQ(run("draw red.draw view.draw mesh.obj -o all.png" + size), 0) << err_;
  write("two.txt", "red.draw\nview.draw mesh.obj\n");
  EXPECT_EQ(run("draw @two.txt -o list.png" + size), 0) << err_;
  EXPECT_EQ(read(folder_ / "list.png"), read(folder_ / "all.png")) << "one picture of all";
}

TEST_F(Batch, OddNames) {
  const std::vector<std::string> names{"with space", "üñï",   "semi;colon", "quote\"",
                                       "new\nline",  "-dash", "{brace}",    "a.b.c",
                                       ".hidden",    "100%"};
  std::string inputs;
  for (const std::string& name : names) {
    write(name + ".draw", kRed);
    inputs += " './" + name + ".draw'";
  }
  EXPECT_EQ(run("draw" + inputs + " -o 'p-{name}.png' --size 40x30"), 0) << err_;
  for (const std::string& name : names) expect_picture_of("red.draw", "p-" + name + ".png");
}

TEST_F(Batch, OneBadFileIsReportedAndTheOthersAreDrawn) {
  write("bad.draw", "open-segment 1\nfly\n");
  write("bad.obj", "v 0 0 0\nf 1 2 3\n");
  for (const char* threads : {"1", "3"}) {
    const std::string options = " -o '{name}-{ext}.png' --size 40x30 --threads ";
    EXPECT_EQ(
        run("draw red.draw bad.draw missing.obj green.draw bad.obj mesh.obj" + options + threads),
        2);
    expect_picture_of("red.draw", "red-draw.png");
    expect_picture_of("green.draw", "green-draw.png");
    expect_picture_of("mesh.obj", "mesh-obj.png");
    for (const char* file : {"bad-draw.png", "missing-obj.png", "bad-obj.png"}) {
      EXPECT_FALSE(fs::exists(folder_ / file)) << file;
    }
    EXPECT_EQ(
        run("draw red.draw bad.draw missing.obj green.draw bad.obj mesh.obj" + options + threads),
        2);
    const auto place = [&](const std::string& words) {
      EXPECT_NE(err_.find(words), std::string::npos) << words << " in\n" << err_;
      return err_.find(words);
    };
    EXPECT_LT(place("displayfile: bad.draw:2:1: unknown routine 'fly'"),
              place("displayfile: missing.obj: no such file"));
    EXPECT_LT(place("missing.obj: no such file"), place("displayfile: bad.obj:2:"));
    EXPECT_NE(err_.find("displayfile: 3 of 6 inputs not drawn:\n  bad.draw\n  missing.obj\n  "
                        "bad.obj\n"),
              std::string::npos)
        << err_;
    EXPECT_EQ(out_, "");
  }
}

/// The list has the reason for each input that was not drawn, and nothing else is printed.
TEST_F(Batch, QuietListsWhatWasNotDrawnAndWhy) {
  write("bad.draw", "open-segment 1\nfly\n");
  write("empty.draw", "");
  write("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n");
  const std::string options = " --size 40x30 --quiet";
  EXPECT_EQ(run("draw red.draw bad.draw empty.draw two.obj missing.obj -o '{name}.png'" + options),
            2);
  EXPECT_EQ(out_, "");
  EXPECT_EQ(err_,
            "displayfile: 2 of 5 inputs not drawn:\n"
            "  bad.draw:2:1: unknown routine 'fly': expected a user routine, such as open-segment "
            "or polygon-abs-3\n"
            "  missing.obj: no such file: expected a mesh\n");
  expect_picture_of("red.draw", "red.png");
  EXPECT_EQ(run("draw empty.draw -o empty.svg --samples 2" + options), 0);
  EXPECT_EQ(out_ + err_, "");
  EXPECT_EQ(run("draw empty.draw red.draw -o '{name}.svg' --samples 2" + options), 0);
  EXPECT_EQ(out_ + err_, "");
  EXPECT_EQ(run("draw red.draw -o - --stats" + options), 0);
  EXPECT_NE(err_.find("polygons entered   1"), std::string::npos) << "what was asked for is said";
  expect_error("draw bad.draw -o x.png" + options, "bad.draw:2:1: unknown routine 'fly'");
}

/// Names may be more than a command line holds.
TEST_F(Batch, InputsOfAList) {
  write("list.txt", "red.draw\r\n\na/house.draw\nmesh.obj");
  write("@odd.draw", kBlue);
  EXPECT_EQ(run("draw @list.txt ./@odd.draw -o '{number}.png' --size 40x30"), 0) << err_;
  expect_picture_of("red.draw", "000.png");
  expect_picture_of("a/house.draw", "001.png");
  expect_picture_of("mesh.obj", "002.png");
  expect_picture_of("./@odd.draw", "003.png");
  EXPECT_EQ(run("draw @- -o 'in-{number}.png' --size 40x30", "list.txt"), 0) << err_;
  expect_picture_of("a/house.draw", "in-001.png");
  EXPECT_EQ(run("dump red.draw a/house.draw mesh.obj"), 0) << "one segment's name twice";
  write("one.txt", "\xEF\xBB\xBFred.draw\n");  // as some editors begin a text
  EXPECT_EQ(run("dump red.draw"), 0) << err_;
  const std::string dumped = out_;
  EXPECT_EQ(run("dump @one.txt"), 0) << err_;
  EXPECT_EQ(out_, dumped);
  EXPECT_EQ(run("truth @one.txt --ids i.npy --size 40x30"), 0) << err_;
  write("meshes.txt", "mesh.obj\n");
  EXPECT_EQ(run("import @meshes.txt -o mesh.draw"), 0) << err_;
  write("many.txt", [] {
    std::string names;
    for (int i = 0; i < 30000; ++i) names += "red.draw\n";
    return names;
  }());
  EXPECT_EQ(run("draw @many.txt -o x.draw"), 2);
  EXPECT_NE(err_.find("x.draw: unknown picture format"), std::string::npos) << err_;

  expect_error("draw @none.txt -o '{name}.png'",
               "none.txt: cannot be read: No such file or directory");
  write("empty.txt", "\n\r\n");
  expect_error("draw @empty.txt -o '{name}.png'",
               "empty.txt: is empty: expected names of inputs, one per line");
  write("zeros.txt", std::string("red.draw\0mesh.obj\0", 18));
  expect_error("draw @zeros.txt -o '{name}.png'",
               "zeros.txt: holds a zero byte: expected names of inputs, one per line");
  expect_error("draw @- - -o '{number}.png'", "standard input is read twice", "list.txt");
  expect_error("draw @- @- -o '{number}.png'", "standard input is read twice", "list.txt");
  expect_error("draw @ -o x.png", "@: no such file: expected a mesh");
  expect_error("draw @list.txt -o '{name}.png' --sise 3", "unknown option '--sise'");
}

/// Nothing is left of a file that could not be written, nor of a folder for a bad input.
TEST_F(Batch, NothingIsLeftOfWhatIsNotDrawn) {
  write("a/bad.draw", "fly\n");
  write("b/bad.draw", "fly\n");
  fs::create_directory(folder_ / "out");
  EXPECT_EQ(run("draw a/bad.draw b/bad.draw -o 'out/{folder}/{name}.png'"), 2);
  EXPECT_TRUE(fs::is_empty(folder_ / "out"));
  // It is read well, and cannot be drawn.
  fs::create_directories(folder_ / "out/b/bad.png");
  EXPECT_EQ(run("draw a/house.draw b/house.draw -o 'out/{folder}/bad.png' --ids "
                "'out/{folder}/ids/{name}.npy'"),
            2);
  EXPECT_TRUE(fs::exists(folder_ / "out/a/ids/house.npy"));
  EXPECT_FALSE(fs::exists(folder_ / "out/b/ids"));
  fs::create_directory(folder_ / "red.png");
  EXPECT_EQ(run("draw green.draw red.draw -o '{name}.png' --size 40x30"), 2);
  EXPECT_NE(err_.find("red.draw: red.png: is a folder"), std::string::npos) << err_;
  expect_picture_of("green.draw", "green.png");
}

/// Once for all pictures, and only where something is left out.
TEST_F(Batch, WhatVectorsLeaveOutIsSaidOnce) {
  const std::string all = "draw red.draw tent.obj a/house.draw --size 40x30 -o '{number}";
  write("tent.obj", "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 1\nv 1 2 0\nv 0 2 0\nf 1 2 3 4\nf 4 3 5 6\n");
  EXPECT_EQ(run(all + ".svg'"), 0);
  EXPECT_EQ(err_, "");
  EXPECT_EQ(run(all + ".svg' --samples 3"), 0);
  EXPECT_EQ(err_, "{number}.svg: vectors leave out --samples\n");
  for (const char* turned : {"", " --turntable 2"}) {
    EXPECT_EQ(run(all + ".pdf' --samples 3 --shading gouraud" + turned), 0);
    EXPECT_EQ(err_, "{number}.pdf: vectors leave out --samples\n");
    EXPECT_EQ(run(all + ".pdf' --shading gouraud" + turned), 0);
    EXPECT_EQ(err_, "");
    EXPECT_EQ(run(all + ".png' --samples 3 --shading gouraud" + turned), 0);
    EXPECT_EQ(err_, "");
    EXPECT_EQ(run(all + ".svg' --shading phong" + turned), 0);
    EXPECT_EQ(err_, "{number}.svg: vectors leave out Phong shading (drawn as Gouraud shading)\n");
  }
  // Options of vectors are for the methods that the vectors are by.
  for (const auto& [option, left] :
       {std::pair{"--seams butted", "--seams, which are between fills of map"},
        {"--vector-precision 1", "--vector-precision, to which fills of map are rounded"},
        {"--crumbs", "--crumbs, of visible lines, which this method does not find"}}) {
    EXPECT_EQ(run(fmt::format("draw red.draw -o s.svg --size 40x30 --hidden bsp {}", option)), 0);
    EXPECT_EQ(err_, fmt::format("s.svg: vectors leave out {}\n", left));
    for (const char* by : {"map", "z-buffer"}) {
      EXPECT_EQ(run(fmt::format("draw red.draw -o s.svg --size 40x30 --hidden {} {}", by, option)),
                0);
      EXPECT_EQ(err_, "") << by;
    }
  }
  EXPECT_EQ(run("draw red.draw -o s.svg --size 40x30 --hidden franklin --crumbs"), 0);
  EXPECT_EQ(err_, "");
  write("shadows.draw",
        "set-light 0.3 0.2 1\nset-shadows on\nset-fill-style solid 1 1 1\nopen-segment "
        "1\npolygon-abs-3 0 0 0  1 0 0  1 1 0  0 1 0\n"
        "polygon-abs-3 0.2 0.2 0.3  0.6 0.2 0.3  0.6 0.6 0.3  0.2 0.6 0.3\nclose-segment\n");
  const std::string left_out =
      "s.svg: vectors leave out shadows (those of map are drawn, of all segments)\n";
  for (const char* by : {" --hidden none", " --hidden bsp", " --hidden map --scope segment"}) {
    EXPECT_EQ(run(std::string("draw shadows.draw -o s.svg") + by), 0);
    EXPECT_EQ(err_, left_out) << by;
  }
  for (const char* drawn : {"s.png", "s.svg", "s.svg --hidden franklin", "s.svg --hidden map",
                            "s.svg --hidden z-buffer", "s.svg --hidden auto --turntable 2"}) {
    EXPECT_EQ(run(std::string("draw shadows.draw -o ") + drawn), 0) << drawn;
    EXPECT_EQ(err_, "") << drawn;
  }
}

TEST_F(Batch, EveryMessageNamesItsFile) {
  write("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\nl 1 2\n");
  EXPECT_EQ(run("draw two.obj red.draw -o '{name}.png' --stats --explain"), 0) << err_;
  EXPECT_TRUE(err_.starts_with("two.obj: left out: 1 points and lines, 1 faces")) << err_;
  EXPECT_TRUE(out_.starts_with("two.obj:\nauto: ")) << out_;
  EXPECT_NE(out_.find("\nred.draw:\n"), std::string::npos) << out_;
}

/// The costs of one input are not counted for the next. Times vary.
TEST_F(Batch, StatisticsAreThoseOfEachInput) {
  const auto without_times = [](const std::string& text) {
    return std::regex_replace(text, std::regex("times .*\n"), "");
  };
  const std::string options = " --size 40x30 --stats -o ";
  std::string each;
  for (const char* input : {"red.draw", "mesh.obj", "mesh.obj"}) {
    EXPECT_EQ(run("draw " + std::string(input) + options + "alone.png"), 0) << err_;
    each += std::string(input) + ":\n" + out_;
  }
  EXPECT_EQ(run("draw red.draw mesh.obj mesh.obj" + options + "'{number}.png'"), 0) << err_;
  EXPECT_EQ(without_times(out_), without_times(each));
}

TEST_F(Batch, StatisticsNameHiddenTexts) {
  write(
      "texts.draw",
      "set-hidden-line-removal on\nopen-segment 1\npolygon-abs-3 -0.5 -0.5 0  0.5 -0.5 0  0.5 0.5 "
      "0  -0.5 0.5 0\nmove-abs-3 0 0 -1\ntext \"be\\\"hind\"\nmove-abs-3 0 0 1\ntext \"before\"\n"
      "move-abs-3 5 0 0\ntext \"outside\"\nset-text-style 0.03 always\nmove-abs-3 0.1 0 -1\n"
      "text \"always\"\nclose-segment\n");
  for (const char* format : {"png", "svg", "png --hidden bsp", "svg --hidden bsp"}) {
    EXPECT_EQ(run(std::string("draw texts.draw --stats -o x.") + format), 0) << err_;
    EXPECT_NE(out_.find("texts stored       3 (1 hidden: \"be\\\"hind\")\n"), std::string::npos)
        << format << '\n'
        << out_;
  }
  EXPECT_EQ(run("draw texts.draw --stats -o x.svg --hidden none"), 0) << err_;
  EXPECT_NE(out_.find("texts stored       3 (0 hidden)\n"), std::string::npos) << out_;
  EXPECT_EQ(run("draw red.draw --stats -o x.svg"), 0) << err_;
  EXPECT_EQ(out_.find("texts"), std::string::npos) << out_;
}

TEST_F(Batch, TurntablesOfEachInput) {
  EXPECT_EQ(run("draw red.draw mesh.obj -o '{name}.png' --turntable 3 --size 40x30"), 0) << err_;
  EXPECT_TRUE(fs::exists(folder_ / "red-002.png"));
  EXPECT_TRUE(fs::exists(folder_ / "mesh-000.png"));
}

TEST_F(Batch, RefusesBeforeAnythingIsDrawn) {
  expect_error(
      "draw a/house.draw red.draw b/house.draw -o '{name}.png'",
      "house.png: the output of a/house.draw and of b/house.draw: expected a name for each");
  expect_error("draw red.draw ./red.draw -o '{folder}/{name}.png'", "red.png: the output of");
  expect_error("draw red.draw green.draw -o '{name}.png' --ids i.npy", "i.npy: the output of");
  expect_error("draw red.draw green.draw -o '{name}.png' --depth i.npy", "i.npy: the output of");
  expect_error("draw red.draw -o '{name}.png' --depth '{name}.png'",
               "red.png: two outputs of red.draw are one file: expected a file for each");
  expect_error("draw red.draw green.draw -o '{name}.png' --ids '{name}.npy' --depth './{name}.npy'",
               "red.npy: two outputs of red.draw are one file: expected a file for each");
  expect_error("draw red.draw green.draw -o red.png --ids '{name}.npy'", "red.png has none");
  expect_error("draw red.draw -o '{nme}.png'", "unknown field '{nme}': did you mean 'name'?");
  expect_error("draw red.draw -o '{}.png'", "unknown field '{}': expected {name}");
  expect_error("draw red.draw -o '{name.png'", "a brace by itself");
  expect_error("draw red.draw -o 'name}.png'", "a brace by itself");
  expect_error("draw red.draw -o '{na{name}.png'", "a brace by itself");
  expect_error("draw red.draw green.draw -o '{name}.gif'", "{name}.gif: unknown picture format");
  expect_error("draw red.draw green.draw -o '{name}'", "unknown picture format ''");
  expect_error("draw red.draw green.draw -o 'nowhere/{name}.png'",
               "nowhere/{name}.png: cannot be written: there is no folder nowhere");
  expect_error("draw a/house.draw -o 'nowhere/in/{folder}/{name}.png'",
               "nowhere/in/{folder}/{name}.png: cannot be written: there is no folder nowhere/in");
  expect_error("draw a/house.draw -o nowhere/in.png",
               "nowhere/in.png: cannot be written: there is no folder nowhere");
  expect_error("draw red.draw -o '{name}.png' --ids 'nowhere/{name}.npy'",
               "nowhere/{name}.npy: cannot be written: there is no folder nowhere");
  expect_error("draw red.draw -o '{name}.svg' --device osmesa", "osmesa");
  expect_error("draw red.draw -o '{name}.png' --size 1x", "--size 1x");
  expect_error("draw red.draw -o '{name}.png' --turntable 0", "--turntable 0");
}

using StandardOutput = Batch;

TEST_F(StandardOutput, TakesAPictureInAnyFormat) {
  EXPECT_EQ(run("draw red.draw -o -"), 0) << err_;
  const std::string piped = out_;
  for (const char* format : {"png", "ppm", "svg"}) {
    EXPECT_EQ(run(std::string("draw red.draw -o file.") + format), 0) << err_;
    EXPECT_EQ(run(std::string("draw red.draw -o - --format ") + format), 0) << err_;
    EXPECT_EQ(out_, read(folder_ / (std::string("file.") + format))) << format;
    EXPECT_EQ(run(std::string("draw red.draw -o - --format .") + format), 0) << err_;
  }
  EXPECT_EQ(run("draw red.draw -o - --format pdf"), 0) << err_;
  EXPECT_EQ(out_.substr(0, 5), "%PDF-");
  EXPECT_EQ(piped, read(folder_ / "file.png"));
  EXPECT_EQ(run("draw red.draw -o - --stats"), 0);
  EXPECT_EQ(out_, piped);
  EXPECT_NE(err_.find("polygons entered   1"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "-"));
  EXPECT_EQ(run("dump red.draw"), 0);
  const std::string dumped = out_;
  EXPECT_EQ(run("dump red.draw -o -"), 0);
  EXPECT_EQ(out_, dumped);
}

TEST_F(StandardOutput, FormatIsAskedForWhateverTheNameEndsIn) {
  EXPECT_EQ(run("draw red.draw -o picture.tmp --format png"), 0) << err_;
  EXPECT_EQ(run("draw red.draw -o picture.png"), 0) << err_;
  EXPECT_EQ(read(folder_ / "picture.tmp"), read(folder_ / "picture.png"));
  EXPECT_EQ(run("draw red.draw green.draw -o '{name}' --format svg"), 0) << err_;
  EXPECT_EQ(read(folder_ / "green").substr(0, 5), "<?xml");
  expect_error("draw red.draw -o - --format gif", "expected one of .png .ppm .svg .pdf .eps .dxf");
  expect_error("draw red.draw -o - --format svg --device osmesa", "the osmesa device draws pixels");
  expect_error("draw red.draw -o - --turntable 3", "expected a file name, not -");
  expect_error("draw red.draw -o x.png --ids - --turntable 3", "expected a file name, not -");
  expect_error("draw red.draw -o - --ids -", "two outputs on standard output");
}

TEST_F(StandardOutput, SaysThatItCannotBeWritten) {
  const auto expect_failure = [&](const std::string& redirected, const std::string& why) {
    const std::string line = "cd '" + folder_.string() +
                             "' && '" DISPLAYFILE_COMMAND "' draw red.draw -o - " + redirected +
                             " 2>.err";
    const int status = std::system(line.c_str());
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 2) << status;
    EXPECT_EQ(read(folder_ / ".err"), "displayfile: standard output: cannot be written: " + why);
  };
  expect_failure(">&-", "Bad file descriptor\n");
  expect_failure(">/dev/full", "No space left on device\n");
}

TEST_F(StandardOutput, NeedsAFolderForTemporaryFiles) {
  before_ = "TMPDIR=/nonexistent ";
  expect_error("draw red.draw -o -",
               "standard output: cannot be written: TMPDIR names /nonexistent, which is no folder: "
               "expected one for temporary files");
}

/// A reader that goes away ends the command as it ends any other, or is reported if the signal is
/// ignored; no temporary file stays.
TEST_F(StandardOutput, ReaderThatGoesAway) {
  fs::create_directory(folder_ / "temporary");
  const std::string command =
      "cd '" + folder_.string() + "' && TMPDIR='" + (folder_ / "temporary").string() +
      "' bash -c '" DISPLAYFILE_COMMAND
      " draw red.draw -o - --format ppm --size 2000x2000 2>.err | true; echo ${PIPESTATUS[0]} "
      ">.status'";
  const auto run_with = [&](void (*on_pipe)(int)) {
    const auto before = std::signal(SIGPIPE, on_pipe);
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::signal(SIGPIPE, before);
    EXPECT_TRUE(fs::is_empty(folder_ / "temporary"));
    return read(folder_ / ".status");
  };
  EXPECT_EQ(run_with(SIG_DFL), "141\n");
  EXPECT_EQ(read(folder_ / ".err"), "");
  EXPECT_EQ(run_with(SIG_IGN), "2\n");
  EXPECT_EQ(read(folder_ / ".err"),
            "displayfile: standard output: cannot be written: Broken pipe\n");
}

}  // namespace
