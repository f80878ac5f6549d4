// Names of segments of drawing programs that the command draws together.

#include <fmt/format.h>

#include <cstddef>
#include <sstream>
#include <string>

#include "tests/command_fixture.h"

namespace {

/// The names of segments are each program's own, also beside meshes, unless a program deletes,
/// hides or renames those of an earlier one.
TEST_F(Command, ProgramsMayHaveTheSameSegmentNames) {
  const auto rectangle = [](int name, int x) {
    return fmt::format(
        "open-segment {0}\npolygon-abs-2 0.{1} 0  0.{2} 0  0.{2} 0.5\nclose-segment\n", name, x,
        x + 1);
  };
  write("a.draw", rectangle(1, 1) + rectangle(2, 2));
  write("b.draw", rectangle(1, 3) + "set-visibility 1 off\n" + rectangle(3, 4));
  write("c.draw", "delete-segment 3\nset-visibility 1 off\n" + rectangle(3, 5));
  write("flat.obj", "v 6 0 0\nv 7 0 0\nv 7 1 0\nf 1 2 3\n");
  // The visible polygons.
  const auto shown = [&](const std::string& inputs) {
    EXPECT_EQ(run("dump " + inputs + " --hidden none"), 0) << err_;
    std::size_t count = 0;
    std::istringstream dump(out_);
    bool visible = false;
    for (std::string line; std::getline(dump, line);) {
      if (line.starts_with("segment ")) visible = line.ends_with(" visible");
      count += line.starts_with("polygon ") && visible;
    }
    return count;
  };
  EXPECT_EQ(shown("a.draw"), 2U);
  EXPECT_EQ(shown("a.draw b.draw"), 3U);  // it hides its own segment 1
  EXPECT_EQ(shown("a.draw a.draw a.draw"), 6U);
  EXPECT_EQ(shown("a.draw b.draw c.draw"), 3U);  // segment 3 of the second, and 1 that is hidden
  EXPECT_EQ(shown("flat.obj a.draw b.draw"), 4U);
  EXPECT_EQ(run("draw a.draw flat.obj b.draw -o a.svg --explode x"), 0) << err_;
  EXPECT_EQ(run("draw a.draw b.draw -o a.svg --fit each"), 0) << err_;
  EXPECT_EQ(run("export a.draw b.draw -o a.obj"), 0) << err_;
}

}  // namespace
