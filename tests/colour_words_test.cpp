// Colours in one word: in drawing programs, where # begins a comment as well.

#include "displayfile/looks/colour_words.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <utility>

#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "tests/replayed.h"

namespace displayfile {
namespace {

using test::error_of_program;

TEST(ColourWords, AreDigitsOrNames) {
  EXPECT_EQ(colour_of_word("#336699"), Colour(0.2, 0.4, 0.6));
  EXPECT_EQ(colour_of_word("#FfCc00"), Colour(1, 0.8, 0));
  EXPECT_EQ(colour_of_word("#369"), colour_of_word("#336699"));
  EXPECT_EQ(colour_of_word("white"), Colour(1));
  EXPECT_EQ(colour_of_word("grey"), colour_of_word("gray"));
  EXPECT_EQ(colour_of_word("darkorange"), colour_of_word("#ff8c00"));
  for (const char* other : {"", "#", "White", "#12", "#1234", "#12345", "#12345g", "#1234567",
                            "336699", "# 36", "transparent", "none"}) {
    EXPECT_EQ(colour_of_word(other), std::nullopt) << other;
  }
  EXPECT_EQ(nearest_colour_name("darkornage"), " did you mean 'darkorange'?");
  EXPECT_EQ(nearest_colour_name("xyzzy"), "");
}

std::string recorded(const std::string& program) {
  GraphicsSystem system;
  std::ostringstream calls;
  Recorder recorder(calls);
  system.set_recorder(&recorder);
  EXPECT_EQ(error_of_program(program, system), "") << program;
  return calls.str();
}

/// A colour may be one word; its # begins a comment everywhere but where a colour is expected.
TEST(ColourWords, ColoursInOneWord) {
  const std::pair<const char*, const char*> cases[] = {
      {"set-fill-style solid #ff0033", "set-fill-style solid 1 0 0.2"},
      {"set-fill-style solid #F03\r", "set-fill-style solid 1 0 0.2"},
      {"set-fill-style solid #f03\t# comment", "set-fill-style solid 1 0 0.2"},
      {"set-fill-style solid #f03 #fff", "set-fill-style solid 1 0 0.2"},
      {"set-fill-style solid 1 0 0 #fff", "set-fill-style solid 1 0 0"},
      {"set-fill-style solid 1 0 0#ffffff", "set-fill-style solid 1 0 0"},
      {"set-fill-style solid yellow#ffffff", "set-fill-style solid 1 1 0"},
      {"set-fill-style hollow #ffffff", "set-fill-style hollow"},
      {"set-fill-style solid rebeccapurple", "set-fill-style solid 0.4 0.2 0.6"},
      {"set-line-style solid #333333", "set-line-style solid 0.2 0.2 0.2"},
      {"set-line-style solid #333 2", "set-line-style solid 0.2 0.2 0.2 2"},
      {"set-line-style dashed blue 2 6 4", "set-line-style dashed 0 0 1 2 6 4"},
      {"set-line-style none #333333", "set-line-style none"},
      {"set-lower-line-style solid red 3", "set-lower-line-style solid 1 0 0 3"},
      {"set-lower-line-style same #ff0000", "set-lower-line-style same"},
      {"set-background #ff0033 # paper", "set-background 1 0 0.2"},
      {"set-background white #ff0000", "set-background 1 1 1"},
      {"set-background none #ff0000", "set-background none"},
      {"set-background transparent", "set-background none"},
      {"set-view-distance 2 #ff0000", "set-view-distance 2"},
  };
  for (const auto& [word, numbers] : cases) EXPECT_EQ(recorded(word), recorded(numbers)) << word;
}

TEST(ColourWords, ErrorsNameTheirPlace) {
  const std::pair<const char*, const char*> cases[] = {
      {"set-background whit\n",
       "1:16: unknown colour 'whit': did you mean 'white'? expected r g b, each 0 to 1, #rrggbb, "
       "a CSS name or none"},
      {"set-background 0\n", "1:17: set-background: 1 argument, expected r g b | none"},
      {"set-background # none\n", "1:15: set-background: 0 arguments, expected r g b | none"},
      {"set-fill-style solid reed\n",
       "1:22: unknown colour 'reed': did you mean 'red'? expected r g b, each 0 to 1, #rrggbb, "
       "a CSS name"},
      {"set-fill-style solid none\n", "1:22: unknown colour 'none'"},
      {"set-fill-style solid red 0\n", "1:27: set-fill-style: 3 arguments, expected"},
      {"set-fill-style solid #12345\n", "1:21: set-fill-style: 1 argument, expected"},
      {"set-fill-style solid #ff0000ff\n", "1:21: set-fill-style: 1 argument, expected"},
      {"set-fill-style solid #ff000g\n", "1:21: set-fill-style: 1 argument, expected"},
      {"set-fill-style solid #fff#\n", "1:21: set-fill-style: 1 argument, expected"},
      {"set-fill-style solid #ff0000 0\n", "1:31: set-fill-style: 3 arguments, expected"},
      {"set-line-style solid #ff0000 1 2 3\n", "1:35: set-line-style: 5 arguments, expected"},
  };
  for (const auto& [program, message] : cases) {
    EXPECT_EQ(error_of_program(program).find("scene.draw:" + std::string(message)), 0u)
        << program << error_of_program(program);
  }
}

}  // namespace
}  // namespace displayfile
