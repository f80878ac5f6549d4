// `displayfile check`: golden files of instructions and of pictures, of one input and of many.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>

#include "tests/command_fixture.h"

namespace {

std::string square(const std::string& colour, const std::string& side = "0.5") {
  return "set-window 0 1 0 1\nset-line-style none\nset-fill-style solid " + colour +
         "\nopen-segment 1\npolygon-abs-3 0 0 0  " + side + " 0 0  " + side + " 1 0  0 1 0\n" +
         "close-segment\n";
}

class Check : public Command {
 protected:
  Check() {
    for (const char* folder : {"a", "b"}) fs::create_directory(folder_ / folder);
    write("a/house.draw", square("1 0 0"));
    write("b/house.draw", square("0 1 0"));
    write("tree.draw", square("0 0 1"));
  }
};

TEST_F(Check, GoldenFilesOfOneNameKeepTheirFolders) {
  EXPECT_EQ(run("check a/house.draw b/house.draw tree.draw --golden gold --update"), 0) << err_;
  for (const char* file : {"gold/a/house.txt", "gold/b/house.txt", "gold/tree.txt"}) {
    EXPECT_TRUE(fs::exists(folder_ / file)) << file;
  }
  EXPECT_EQ(run("check a/house.draw b/house.draw tree.draw --golden gold"), 0) << out_ << err_;
  EXPECT_EQ(out_ + err_, "");
  EXPECT_EQ(run("check b/house.draw --golden gold"), 0) << out_ << err_;  // alone, it is the same
  write("b/house.draw", square("1 0 0"));
  EXPECT_EQ(run("check b/house.draw --golden gold"), 1);
  EXPECT_EQ(run("check b/house.draw --golden gold --update"), 0) << err_;
  EXPECT_FALSE(fs::exists(folder_ / "gold/house.txt"));
  EXPECT_EQ(run("check b/house.draw --golden gold"), 0) << out_;
  EXPECT_EQ(run("check b/house.draw --golden flat --update"), 0) << err_;
  EXPECT_TRUE(fs::exists(folder_ / "flat/house.txt"));
  EXPECT_EQ(run("check " + folder_.string() + "/b/../b/house.draw --golden flat"), 0) << err_;
}

TEST_F(Check, TwoInputsOfOneGoldenFileAreAnError) {
  expect_error("check a/house.draw ./a/house.draw --golden gold --update",
               "two inputs have the golden file gold/a/house.txt");
  write("a/house.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  expect_error("check a/house.draw a/house.obj --golden gold", "two inputs have the golden file");
  expect_error("check - --golden gold", "check needs files");
}

TEST_F(Check, MissingGoldenFileNamesTheOptionThatWritesIt) {
  expect_error("check tree.draw --golden gold",
               "tree.draw: there is no golden file gold/tree.txt: --update writes it");
  expect_error("check tree.draw --golden gold.txt",
               "there is no golden file gold.txt: --update writes it");
  expect_error("check tree.draw --golden gold --picture", "gold/tree.png: --update writes it");
}

TEST_F(Check, MissingInputIsNamedBeforeItsGoldenFile) {
  expect_error("check missing.draw --golden gold", "displayfile: missing.draw: no such file\n");
}

TEST_F(Check, GoldenPictureNeedsTheOptionForPictures) {
  EXPECT_EQ(run("draw tree.draw -o tree.png"), 0) << err_;
  const std::string message = "tree.png: a picture: expected --picture too, or a dump";
  expect_error("check tree.draw --golden tree.png", message);
}

TEST_F(Check, OneGoldenFileForAllInputs) {
  EXPECT_EQ(run("check a/house.draw --golden gold.txt --update"), 0) << err_;
  EXPECT_EQ(run("draw a/house.draw -o gold.png --size 20x10"), 0) << err_;
  for (const char* golden :
       {"gold.txt", "a/house.draw", "gold.png --picture", "a/house.draw --picture --size 30x30"}) {
    const std::string options = std::string(" --golden ") + golden;
    EXPECT_EQ(run("check a/house.draw a/house.draw" + options), 0) << out_ << err_;
    EXPECT_EQ(run("check a/house.draw b/house.draw tree.draw" + options), 1) << err_;
    EXPECT_NE(out_.find("b/house.draw:"), std::string::npos) << out_;
    EXPECT_NE(out_.find("tree.draw:"), std::string::npos) << out_;
    EXPECT_NE(out_.find("3 inputs: 1 passed, 2 differ, 0 bad\n"), std::string::npos) << out_;
  }
  expect_error("check a/house.draw b/house.draw --golden gold.txt --update", "expected a folder");
  expect_error("check a/house.draw --golden tree.draw --update", "expected a folder");
  write("bad.draw", "fly\n");
  expect_error("check a/house.draw b/house.draw --golden bad.draw", "bad.draw:1:1");
  write("bad.txt", "nothing\n");
  expect_error("check a/house.draw b/house.draw --golden bad.txt", "bad.txt:1:1");
  write("bad.png", "nothing\n");
  expect_error("check a/house.draw --picture --golden bad.png", "bad.png: not a PNG file");
}

/// A wrong name never costs a file.
TEST_F(Check, UpdateWritesOverNothingButGoldenFiles) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  write("m.obj", corners);
  write("other.obj", corners);
  write("gold.ppm", "a picture");
  const std::string is_input = ": is an input and an output: expected another file";
  const auto is_there = [&](const std::string& name, const std::string& text) {
    EXPECT_EQ(read(folder_ / name), text) << name;
  };
  expect_error("check m.obj --golden m.obj --update",
               "m.obj: expected a golden file that ends in .txt, or a folder");
  expect_error("check m.obj --golden other.obj --update",
               "other.obj: expected a golden file that ends in .txt, or a folder");
  expect_error("check tree.draw --golden gold.ppm --picture --update",
               "gold.ppm: expected a golden file that ends in .png, or a folder");
  is_there("m.obj", corners);
  is_there("other.obj", corners);
  is_there("gold.ppm", "a picture");
  // A mesh may have any extension, and lists of inputs are read, too.
  write("m.txt", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  fs::create_symlink("m.txt", folder_ / "same.txt");
  write("class.txt", "a/house.draw\nclass.draw\n");
  write("class.draw", square("1 0 0"));
  expect_error("check m.txt --golden . --update", "./m.txt" + is_input);
  expect_error("check m.txt --golden same.txt --update", "same.txt" + is_input);
  expect_error("check @class.txt --golden . --update", "./class.txt" + is_input);
  is_there("class.txt", "a/house.draw\nclass.draw\n");
  EXPECT_EQ(run("check @class.txt --golden gold --update"), 0) << err_;
}

/// A bad input is reported, and the others are checked.
TEST_F(Check, SummaryOfAllInputs) {
  write("bad.draw", "open-segment 1\nfly\n");
  const std::string all = "check a/house.draw bad.draw b/house.draw --golden a/house.draw";
  EXPECT_EQ(run(all + " --summary"), 2);
  EXPECT_EQ(err_, "");  // the table reports it
  EXPECT_EQ(
      out_,
      "passed   a/house.draw\n"
      "bad      bad.draw      2:1: unknown routine 'fly': expected a user routine, such as "
      "open-segment or polygon-abs-3\n"
      "differs  b/house.draw  3: segment 1, instruction 1 (fill solid 0 1 0): red is 0, expected "
      "1\n"
      "3 inputs: 1 passed, 1 differ, 1 bad\n");
  EXPECT_EQ(run(all), 2);
  EXPECT_EQ(err_,
            "displayfile: bad.draw:2:1: unknown routine 'fly': expected a user routine, such as "
            "open-segment or polygon-abs-3\n");
  EXPECT_EQ(out_,
            "b/house.draw:3: segment 1, instruction 1 (fill solid 0 1 0): red is 0, expected 1\n"
            "3 inputs: 1 passed, 1 differ, 1 bad\n");
  EXPECT_EQ(run("check a/house.draw --golden a/house.draw --summary"), 0) << err_;
  EXPECT_EQ(out_, "passed   a/house.draw\n1 input: 1 passed, 0 differ, 0 bad\n");
  EXPECT_EQ(run("check tree.draw bad.draw --golden gold --update"), 2);
  EXPECT_TRUE(fs::exists(folder_ / "gold/tree.txt"));
  EXPECT_FALSE(fs::exists(folder_ / "gold/bad.txt"));
}

/// The line of the input that the first instruction that differs comes from.
TEST_F(Check, ADifferenceNamesTheLineOfTheProgram) {
  const std::string right =
      "# solution\nset-fill-style solid 1 0 0\nset-line-style solid 0 0 0\nopen-segment 1\n"
      "move-abs-3 0 0 0\nline-abs-3 1 0 0\n\npolygon-abs-3 0 0 0  1 0 0  0 1 0\n"
      "box-3 0 0.5 0 0.5 0 0.5\nset-fill-style solid 0 0 1\n"
      "polygon-abs-3 0 0 0.5  1 0 0.5  0 1 0.5\nclose-segment\n"
      "open-segment 2\npolygon-abs-3 0 0 0  -1 0 0  0 -1 0\nclose-segment\n";
  write("solution.draw", right);
  const auto line_of = [&](const std::string& from, const std::string& to,
                           const std::string& options = "") {
    std::string program = right;
    program.replace(program.find(from), from.size(), to);
    write("a.draw", program);
    EXPECT_EQ(run("check a.draw --golden solution.draw" + options), 1) << to << err_;
    return out_.substr(0, out_.find(" "));
  };
  EXPECT_EQ(line_of("line-abs-3 1 0", "line-abs-3 1 0.5"), "a.draw:6:");
  EXPECT_EQ(line_of("0.5  0 1 0.5", "0.5  0 0.9 0.5"), "a.draw:11:");
  EXPECT_EQ(line_of("solid 0 0 1", "solid 0 0 0.5"), "a.draw:10:");
  EXPECT_EQ(line_of("solid 1 0 0", "solid 0 0 1"), "a.draw:2:");
  EXPECT_EQ(line_of("box-3 0 0.5", "box-3 0 0.25"), "a.draw:9:");
  EXPECT_EQ(line_of("-1 0 0  0 -1", "-1 0 0  0 -0.5"), "a.draw:14:");
  EXPECT_EQ(line_of("0 -1 0\nclose-segment\n",
                    "0 -1 0\nmove-abs-3 0 0 0\nline-abs-3 1 1 0\n"
                    "close-segment\n"),
            "a.draw:16:");
  EXPECT_EQ(line_of("polygon-abs-3 0 0 0  -1 0 0  0 -1 0\n", ""), "a.draw:14:") << "its end";
  EXPECT_EQ(line_of("open-segment 2", "open-segment 3"), "a.draw:13:");
  EXPECT_EQ(line_of("open-segment 2\npolygon-abs-3 0 0 0  -1 0 0  0 -1 0\nclose-segment\n", ""),
            "a.draw:")
      << "what is missing has no line";
  for (const char* sorted : {" --hidden depth-sort", " --hidden bsp --scope all"}) {
    EXPECT_EQ(line_of("0.5  0 1 0.5", "0.5  0 0.9 0.5", sorted), "a.draw:11:") << sorted;
  }
  write("view.draw", "set-perspective 3 1 6\n");
  EXPECT_EQ(line_of("solid 0 0 1", "solid 0 0 0.5", " --with view.draw"), "a.draw:10:");
  write("view.draw", "set-perspective 3 1 6\nopen-segment 1\nclose-segment\n");
  EXPECT_EQ(line_of("solid 0 0 1", "solid 0 0 0.5", " --with view.draw"), "a.draw:10:");
}

/// --with is entered before each input, and before the one that they are compared with.
TEST_F(Check, ACommonProgramAndFiguresOfSeveralInputs) {
  write("view.draw", "set-viewport 0 0.5 0 0.5\n");
  write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(run("dump view.draw tree.draw -o tree.txt"), 0) << err_;
  EXPECT_EQ(run("check --with view.draw tree.draw mesh.obj --golden gold --update"), 0) << err_;
  EXPECT_EQ(read(folder_ / "gold/tree.txt"), read(folder_ / "tree.txt"));
  EXPECT_TRUE(fs::exists(folder_ / "gold/mesh.txt"));
  EXPECT_FALSE(fs::exists(folder_ / "gold/view.txt"));
  EXPECT_EQ(run("check tree.draw --golden gold"), 1);
  EXPECT_EQ(run("check --with view.draw tree.draw --golden tree.draw"), 0) << out_;
  EXPECT_EQ(run("check --with view.draw tree.draw --golden tree.draw --picture"), 0) << out_;
  write("list.txt", "view.draw tree.draw\nmesh.obj\n");
  EXPECT_EQ(run("check @list.txt --golden gold --summary"), 1) << err_;
  EXPECT_NE(out_.find("passed   tree.draw\n"), std::string::npos) << out_;
  EXPECT_NE(out_.find("differs  mesh.obj"), std::string::npos) << out_;
  expect_error("check --with tree.txt tree.draw --golden . --update", "./tree.txt: is an input");
}

TEST_F(Check, QuietTellsOnlyWhatDoesNotPass) {
  write("bad.draw", "open-segment 1\nfly\n");
  write("empty.draw", "");
  const std::string all =
      "check a/house.draw bad.draw empty.draw b/house.draw --picture --quiet --golden ";
  EXPECT_EQ(run(all + "a/house.draw"), 2);
  EXPECT_EQ(err_, "");  // no warning that nothing is seen of empty.draw
  EXPECT_EQ(out_,
            "bad      bad.draw      2:1: unknown routine 'fly': expected a user routine, such as "
            "open-segment or polygon-abs-3\n"
            "differs  empty.draw    131072 wrong pixels of 262144 (50.00%), largest difference "
            "255\n"
            "differs  b/house.draw  131072 wrong pixels of 262144 (50.00%), largest difference "
            "255\n"
            "4 inputs: 1 passed, 2 differ, 1 bad\n");
  EXPECT_EQ(run("check a/house.draw a/house.draw --quiet --golden a/house.draw"), 0);
  EXPECT_EQ(out_ + err_, "");
  EXPECT_EQ(run("check a/house.draw tree.draw --quiet --golden gold --update"), 0);
  EXPECT_EQ(out_ + err_, "");
  EXPECT_EQ(run("check empty.draw --picture --golden empty.draw"), 0);
  EXPECT_NE(err_.find("empty.draw: nothing is seen"), std::string::npos) << err_;
  EXPECT_EQ(run("check empty.draw --picture --quiet --golden empty.draw"), 0);
  EXPECT_EQ(out_ + err_, "");
}

/// A class's list: missing submissions are reported too.
TEST_F(Check, InputsOfAList) {
  write("class.txt", "a/house.draw\nc/house.draw\n");
  EXPECT_EQ(run("check @class.txt --golden a/house.draw --summary"), 2);
  EXPECT_EQ(out_,
            "passed   a/house.draw\n"
            "bad      c/house.draw  cannot be read: No such file or directory\n"
            "2 inputs: 1 passed, 0 differ, 1 bad\n");
}

TEST_F(Check, NothingIsLeftOfBadInputsWithUpdate) {
  write("a/bad.draw", "fly\n");
  write("b/bad.draw", "fly\n");
  EXPECT_EQ(run("check a/bad.draw b/bad.draw --golden new/gold --update"), 2);
  EXPECT_FALSE(fs::exists(folder_ / "new"));
  EXPECT_EQ(run("check a/bad.draw b/bad.draw a/house.draw --golden new/gold --update"), 2);
  EXPECT_TRUE(fs::exists(folder_ / "new/gold/house.txt"));
  EXPECT_FALSE(fs::exists(folder_ / "new/gold/a"));
  fs::create_directory(folder_ / "there");
  EXPECT_EQ(run("check a/bad.draw --golden there --update"), 2);
  EXPECT_TRUE(fs::exists(folder_ / "there"));
}

TEST_F(Check, PicturesWithinATolerance) {
  EXPECT_EQ(run("check a/house.draw --golden gold --picture --update --size 20x10"), 0) << err_;
  // It is another program and the same picture.
  write("a/house.draw",
        "set-line-style none\n" + square("1 0 0", "0.25") +
            square("1 0 0").replace(square("1 0 0").find("segment 1"), 9, "segment 2"));
  EXPECT_EQ(run("check a/house.draw --golden gold --picture"), 0) << out_ << err_;
  // 10 of the 200 pixels are wrong, by 255.
  write("a/house.draw", square("1 0 0", "0.55"));
  EXPECT_EQ(run("check a/house.draw --golden gold --picture"), 1);
  EXPECT_EQ(out_, "a/house.draw: 10 wrong pixels of 200 (5.00%), largest difference 255\n");
  for (const auto& [tolerance, status] :
       {std::pair("--wrong-pixels 9", 1), std::pair("--wrong-pixels 10", 0),
        std::pair("--wrong-pixels 4.9%", 1), std::pair("--wrong-pixels 5%", 0),
        std::pair("--tolerance 254", 1), std::pair("--tolerance 255", 0)}) {
    EXPECT_EQ(run("check a/house.draw --golden gold --picture " + std::string(tolerance)), status)
        << tolerance << out_ << err_;
  }
  write("a/house.draw", square("0.99 0.01 0"));
  EXPECT_EQ(run("check a/house.draw --golden gold --picture --tolerance 2"), 1);
  EXPECT_EQ(run("check a/house.draw --golden gold --picture --tolerance 3"), 0) << out_;
  EXPECT_EQ(run("check a/house.draw --golden gold --picture --size 21x10"), 1);
  EXPECT_EQ(out_, "a/house.draw: the picture is 21 x 10 pixels, expected 20 x 10\n");
  EXPECT_EQ(run("draw a/house.draw -o x.png --size 20x10"), 0);
  EXPECT_EQ(run("compare x.png gold/house.png"), 1);
  EXPECT_EQ(run("compare x.png gold/house.png --tolerance 3 --marks m.png"), 0) << out_;
  EXPECT_EQ(run("compare x.png gold/house.png --wrong-pixels 50%"), 0) << out_;
  EXPECT_EQ(run("compare x.png gold/house.png --wrong-pixels 49%"), 1) << out_;
}

/// A share has its decimal value, whatever its product with the pixels is in binary. A figure that
/// draw wrote is checked with the options that it was drawn with.
TEST_F(Check, PicturesWithTheOptionsOfDraw) {
  fs::create_directory(folder_ / "gold");
  write("slanted.draw", "set-background 0.9 0.9 1\n" + square("1 0 0", "0.37"));
  for (const std::string options :
       {"--samples 1", "--samples 4", "--samples 3 --background 0,0,1", "--samples 1 --crumbs",
        "--samples 2 --shading gouraud --threads 1 --hidden scan-line"}) {
    SCOPED_TRACE(options);
    ASSERT_EQ(run("draw slanted.draw -o gold/slanted.png --size 31x21 --widen " + options), 0)
        << err_;
    EXPECT_EQ(run("check slanted.draw --golden gold --picture --widen " + options), 0)
        << out_ << err_;
  }
  ASSERT_EQ(run("draw slanted.draw -o gold/slanted.png --size 31x21 --widen --samples 4"), 0);
  EXPECT_EQ(run("check slanted.draw --golden gold --picture --widen"), 1) << "one sample";
  for (const char* option :
       {"--samples 1", "--shading flat", "--background 1,1,1", "--device software", "--crumbs"}) {
    const std::string words(option);
    expect_error("check slanted.draw --golden gold " + words,
                 words.substr(0, words.find(' ')) + " is of pictures: expected --picture too");
  }
  expect_error("check slanted.draw --golden gold --picture --background none",
               "--background none: a picture without alpha: expected R,G,B");
  expect_error("check slanted.draw --golden gold --picture --device x", "x");
  EXPECT_EQ(run("check slanted.draw --golden text --update --threads 2"), 0) << err_;
}

TEST_F(Check, ASharePassesAsManyPixelsAsItSays) {
  const auto write_picture = [&](const std::string& name, int pixels, int wrong) {
    std::string text = "P6\n" + std::to_string(pixels) + " 1\n255\n";
    text += std::string(3 * static_cast<std::size_t>(wrong), '\xFF');
    text += std::string(3 * static_cast<std::size_t>(pixels - wrong), '\0');
    write(name, text);
  };
  struct Share {
    int pixels, wrong;
    const char *passes, *differs;
  };
  for (const auto& [pixels, wrong, passes, differs] :
       {Share{100, 29, "29%", "28.9%"}, Share{100, 57, "57%", "56.9%"},
        Share{100, 58, "58%", "57.99%"}, Share{1000, 1, "0.1%", "0.09%"},
        Share{1000, 289, "28.9%", "28.8%"}, Share{10000, 29, "0.29%", "0.2899%"},
        Share{100, 100, "100%", "99.99%"}}) {
    write_picture("black.ppm", pixels, 0);
    write_picture("x.ppm", pixels, wrong);
    const std::string compare = "compare black.ppm x.ppm --wrong-pixels ";
    EXPECT_EQ(run(compare + passes), 0) << passes << out_ << err_;
    EXPECT_EQ(run(compare + differs), 1) << differs << out_ << err_;
  }
}

TEST_F(Check, UpdateSaysThatItWrote) {
  EXPECT_EQ(run("check a/house.draw b/house.draw --golden gold --update --summary"), 0) << err_;
  EXPECT_EQ(
      out_,
      "written  a/house.draw\nwritten  b/house.draw\n2 inputs: 2 golden files written, 0 bad\n");
}

TEST_F(Check, APipeStopsNothing) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe.draw").c_str(), 0600), 0);
  EXPECT_EQ(run("check a/house.draw pipe.draw --golden a/house.draw --summary"), 2);
  EXPECT_NE(out_.find("bad      pipe.draw     not a regular file"), std::string::npos) << out_;
  EXPECT_NE(out_.find("passed   a/house.draw\n"), std::string::npos) << out_;
}

TEST_F(Check, BadOptions) {
  EXPECT_EQ(run("check tree.draw --golden gold --picture --update"), 0) << err_;
  for (const char* wrong : {"-1", "1.5", "many", "101%", "-1%", "%", "nan", "1e99", "2 %"}) {
    expect_error(
        "check tree.draw --golden gold --picture --wrong-pixels='" + std::string(wrong) + "'",
        "expected a number of pixels, such as 20, or 0% to 100% of all");
  }
  for (const char* wrong : {"-1", "256", "one"}) {
    expect_error("check tree.draw --golden gold --picture --tolerance=" + std::string(wrong),
                 "--tolerance");
  }
  expect_error("check tree.draw --golden gold --picture --size 5", "--size 5");
  expect_error("check tree.draw --golden gold --size 5", "--size 5");
  expect_error("check tree.draw --golden gold --tolerance 1", "expected --picture too");
  expect_error("check tree.draw --golden gold --wrong-pixels 1", "expected --picture too");
  write("t.txt", "displayfile-dump 1\nend\n");
  expect_error("compare t.txt t.txt --tolerance 1", "apply to pictures");
  expect_error("compare gold/tree.png gold/tree.png --wrong-pixels x", "--wrong-pixels x");
}

}  // namespace
