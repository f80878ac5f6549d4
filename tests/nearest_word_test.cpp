// Known words, and suggestions for unknown ones.

#include "clip/base/nearest_word.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/words.h"

namespace displayfile {
namespace {

TEST(NearestWord, EditDistanceCountsWhatIsChanged) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("bsp", "bsp"), 0u);
  EXPECT_EQ(edit_distance("bsp", "BSP"), 0u);
  EXPECT_EQ(edit_distance("", "bsp"), 3u);
  EXPECT_EQ(edit_distance("bsp", ""), 3u);
  EXPECT_EQ(edit_distance("bps", "bsp"), 1u);  // neighbours exchanged
  EXPECT_EQ(edit_distance("bs", "bsp"), 1u);
  EXPECT_EQ(edit_distance("bspp", "bsp"), 1u);
  EXPECT_EQ(edit_distance("bst", "bsp"), 1u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("sitting", "kitten"), 3u);
}

TEST(NearestWord, NearestComesFirstAndOfEqualOnesTheFirst) {
  const std::vector<std::string_view> known{"scan-line", "z-buffer", "scan-line-z", "bsp", "asp"};
  EXPECT_EQ(nearest_words("scanline-z", known).front(), "scan-line-z");
  EXPECT_EQ(nearest_words("csp", known).front(), "bsp");
  EXPECT_EQ(nearest_words("csp", known)[1], "asp");
  const std::vector<std::string_view> options{"--widen", "--hidden"};
  EXPECT_EQ(nearest_words("--hiden", options).front(), "--hidden") << "which begins alike";
}

TEST(NearestWord, OnlyWordsThatAreNearAreMeant) {
  const std::vector<std::string_view> known{"--size", "--samples", "--shading", "depth-sort"};
  EXPECT_EQ(did_you_mean("--sise", known), " did you mean '--size'?");
  EXPECT_EQ(did_you_mean("--SIZE", known), " did you mean '--size'?");
  EXPECT_EQ(did_you_mean("--sample", known), " did you mean '--samples'?");
  EXPECT_EQ(did_you_mean("depth", known), " did you mean 'depth-sort'?");  // its start
  EXPECT_EQ(did_you_mean("sort", known), " did you mean 'depth-sort'?");   // its end
  EXPECT_EQ(did_you_mean("frobnicate", known), "");
  EXPECT_EQ(did_you_mean("", known), "");
  EXPECT_EQ(did_you_mean("x", known), "");
  EXPECT_EQ(did_you_mean("--size", {}), "");
  EXPECT_EQ(did_you_mean(std::string(100000, '-'), known), "");
}

enum class Size { small, large, any };
constexpr Word<Size> kSizes[] = {
    {Size::small, "small"}, {Size::large, "large"}, {Size::any, "any"}};

TEST(Words, EachIsReadAndTold) {
  for (const auto& [size, word] : kSizes) {
    EXPECT_EQ(value_of(kSizes, word, "size is"), size);
    EXPECT_EQ(word_of(kSizes, size), word);
  }
}

TEST(Words, AnUnknownOneIsToldThoseThatThereAre) {
  const auto message_for = [](std::string_view word) -> std::string {
    try {
      value_of(kSizes, word, "size is");
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message_for("tall"), "size is small, large or any, not 'tall'");
  EXPECT_EQ(message_for("larg"), "size is small, large or any, not 'larg': did you mean 'large'?");
  EXPECT_EQ(message_for("Small"),
            "size is small, large or any, not 'Small': did you mean 'small'?");
  EXPECT_EQ(message_for(""), "size is small, large or any, not ''");
}

}  // namespace
}  // namespace displayfile
