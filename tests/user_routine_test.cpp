// User routines called by their names.

#include "displayfile/files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "tests/error_of.h"
#include "tests/gallery.h"
#include "tests/temporary_folder.h"

namespace displayfile {
namespace {

using test::expect_error;

/// Every line of a program without comments: its name, and the rest.
void call_lines(std::string_view program, GraphicsSystem& system) {
  for (std::size_t at = 0; at < program.size();) {
    const std::size_t end = std::min(program.find('\n', at), program.size());
    const std::string_view line = program.substr(at, end - at);
    at = end + 1;
    if (line.empty() || line.starts_with('#')) continue;
    const std::size_t blank = std::min(line.find(' '), line.size());
    call_user_routine(system, line.substr(0, blank), line.substr(blank));
  }
}

TEST(UserRoutines, CalledByNameDrawWhatTheProgramDraws) {
  int programs = 0;
  test::for_each_in_gallery([&](const std::string& name, const test::Retained& retained) {
    // A record has no comments behind arguments.
    std::ostringstream record;
    Recorder recorder(record);
    GraphicsSystem recorded, called;
    recorded.set_recorder(&recorder);
    replay_file(fmt::format(DISPLAYFILE_SOURCE_DIR "/programs/{}.draw", name), recorded);
    call_lines(record.view(), called);
    EXPECT_EQ(dump(called.display_file()), dump(retained.system.display_file()));
    ++programs;
  });
  EXPECT_GT(programs, 20);
}

TEST(UserRoutines, TheTableNamesEachOnce) {
  std::set<std::string_view> names;
  for (const UserRoutine& routine : user_routines()) {
    EXPECT_TRUE(names.insert(routine.name).second) << routine.name;
    EXPECT_EQ(routine.arguments == 0, routine.expected.empty()) << routine.name;
  }
  EXPECT_TRUE(names.contains("polygon-abs-3"));
  EXPECT_GT(names.size(), 70u);
}

/// The table has each routine's meaning, which bindings in other languages show; the document has
/// each routine.
TEST(UserRoutines, TheTableSaysWhatEachMeans) {
  const std::string document =
      test::content(DISPLAYFILE_SOURCE_DIR "/displayfile/text/drawing_programs.md");
  std::set<std::string_view> sections;
  std::string_view before;
  for (const UserRoutine& routine : user_routines()) {
    EXPECT_TRUE(routine.meaning.size() > 5 && routine.meaning.ends_with('.')) << routine.name;
    std::string name(routine.name);
    if (name.ends_with("-2")) name.back() = '3';  // they stand together
    EXPECT_NE(document.find(name), document.npos) << routine.name;
    if (routine.section != before) {
      EXPECT_TRUE(sections.insert(routine.section).second) << routine.section;
    }
    before = routine.section;
  }
  EXPECT_GT(sections.size(), 5u);
}

TEST(UserRoutines, WrongCallsAreErrorsThatNameThem) {
  GraphicsSystem system;
  const auto call = [&](std::string_view name, std::string_view arguments) {
    return [&system, name, arguments] { call_user_routine(system, name, arguments); };
  };
  expect_error(call("polygon-abs-3", "0 0 0"), "no segment open");
  call("open-segment", "1")();
  expect_error(call("polygon-abs-3", "0 0"),
               "polygon-abs-3: 2 arguments, expected a multiple of 3");
  expect_error(call("move-abs-3", "0 0 x"), "move-abs-3: expected a number, not 'x'");
  expect_error(call("move-abs-3", "0 0 nan"), "move-abs-3: expected a finite number");
  expect_error(call("move-abs-3", "0 0 1e999"), "out of range of a double");
  expect_error(call("polygon-abs3", "0 0 0"),
               "unknown routine 'polygon-abs3': did you mean 'polygon-abs-3'?");
  expect_error(call("", ""), "unknown routine ''");
  expect_error(call("#", ""), "unknown routine '#'");
  expect_error(call("move-abs-3 0 0 0", ""), "unknown routine 'move-abs-3 0 0 0'");
  expect_error(call("move-abs-3", "0 0 0\nclose-segment"), "move-abs-3");
  expect_error(call("text", "\"\xff\""), "text");
  EXPECT_EQ(system.open_segment_name(), 1);
  EXPECT_EQ(system.display_file().polygons(), 0u);
}

/// Numbers in their shortest form are the doubles that they were.
TEST(UserRoutines, NumbersAreTakenExactly) {
  GraphicsSystem by_name, direct;
  for (GraphicsSystem* system : {&by_name, &direct}) {
    system->set_window(0, 1, 0, 1);
    system->open_segment(1);
  }
  const Point3 p(0.1 + 0.2, 1.0 / 3.0, std::numeric_limits<double>::denorm_min());
  call_user_routine(by_name, "line-abs-3", fmt::format("{} {} {}", p.x, p.y, p.z));
  direct.line_abs_3(p.x, p.y, p.z);
  EXPECT_EQ(dump(by_name.display_file()), dump(direct.display_file()));
}

}  // namespace
}  // namespace displayfile
