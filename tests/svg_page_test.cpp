// Several SVG files in one page: ids, classes and rules of style are the page's there, so that
// those of a file must be its own (interp/vector/file_key.h).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "interp/draw/draw.h"
#include "interp/files/png_file.h"
#include "interp/vector/file_key.h"
#include "tests/replayed.h"
#include "tests/temporary_folder.h"

namespace displayfile {
namespace {

using namespace test;

constexpr int kSize = 64;

struct File {
  std::string what, svg;
};

File drawn(const std::string& what, const std::string& program, const DrawOptions& more = {}) {
  DrawOptions options = more;
  options.width = options.height = kSize;
  return {what, draw_as(replayed(program), ".svg", options)};
}

/// Two neighbours, of which the first has a trap under the second, in two colours.
std::string neighbours(const char* first, const char* second, double middle) {
  return fmt::format(
      "set-window 0 1 0 1\nset-line-style none\nopen-segment 1\n"
      "set-fill-style solid {0}\npolygon-abs-2 0.1 0.1  {2} 0.1  0.6 0.9  0.1 0.9\n"
      "set-fill-style solid {1}\npolygon-abs-2 {2} 0.1  0.9 0.2  0.9 0.9  0.6 0.9\nclose-segment\n",
      first, second, middle);
}

std::string shaded(const char* colour, const char* light) {
  return fmt::format(
      "set-window 0 1 0 1\nset-line-style none\nset-light {1} 0.2\nset-shading gouraud\n"
      "open-segment 1\nset-fill-style solid {0}\n"
      "set-vertex-normals 1 0 0.2  0 1 0.2  -1 -1 0.3\n"
      "polygon-abs-3 0.1 0.1 0  0.9 0.2 0  0.5 0.9 0\nclose-segment\n",
      colour, light);
}

std::string lines_and_text(const char* style, const char* fill, double size, const char* where) {
  return fmt::format(
      "set-window 0 1 0 1\nset-background {1}\nset-line-style {0}\nopen-segment 1\n"
      "move-abs-2 0.1 0.1\nline-abs-2 0.9 0.6\nset-text-style {2} {3}\nmove-abs-2 0.5 0.7\n"
      "text \"Aa\"\nclose-segment\n",
      style, fill, size, where);
}

/// A fill and its outline, which are one path.
std::string outlined(const char* fill, const char* style) {
  return fmt::format(
      "set-window 0 1 0 1\nset-line-style {1}\nopen-segment 1\nset-fill-style solid {0}\n"
      "polygon-abs-2 0.2 0.2  0.8 0.3  0.5 0.8\nclose-segment\n",
      fill, style);
}

/// Drawings that differ in what ids and classes stand for, in every way that files have. Some have
/// the same styles, and differ in places alone.
std::vector<File> files() {
  DrawOptions map;
  map.surfaces.method = HiddenMethod::map;
  DrawOptions lines;
  lines.surfaces.method = HiddenMethod::franklin;
  DrawOptions on_paper = map;
  on_paper.vectors.paper = paper_of("60x60");
  DrawOptions pens;
  pens.pens.emplace();
  pens.vectors.paper = paper_of("60x60");
  pens.surfaces.method = HiddenMethod::none;
  return {
      drawn("red and yellow", neighbours("1 0 0", "1 1 0", 0.3), map),
      drawn("blue and green", neighbours("0 0 1", "0 0.5 0", 0.7), map),
      drawn("red and yellow, elsewhere", neighbours("1 0 0", "1 1 0", 0.45), map),
      drawn("painted", neighbours("0 1 1", "1 0 1", 0.5)),
      drawn("painted, shaded", shaded("0 1 0", "0.5 1 0")),
      drawn("outlined", outlined("0 1 0", "solid 0.5 0 0.5 3")),
      drawn("coarse", neighbours("0 0 0", "1 0.5 0", 0.4),
            [&] {
              DrawOptions coarse = map;
              coarse.vectors.precision = 0.5;
              return coarse;
            }()),
      drawn("shaded red", shaded("1 0 0", "1 0 0.5"), map),
      drawn("shaded blue", shaded("0 0 1", "0 1 0.5"), map),
      drawn("thick lines", lines_and_text("solid 1 0 0 6", "1 1 0.8", 0.3, "left"), lines),
      drawn("thin lines", lines_and_text("dashed 0 0 1 2", "0.8 1 1", 0.15, "right"), lines),
      drawn("on paper", neighbours("0.5 0 0", "0 0.5 0.5", 0.45), on_paper),
      drawn("for pens", lines_and_text("solid 0 0.5 0 4", "1 1 1", 0.2, "centre"), pens),
      drawn("for another pen", lines_and_text("solid 0.5 0 0 8", "1 1 1", 0.2, "centre"), pens),
  };
}

std::set<std::string> matches(const std::string& text, const char* pattern) {
  const std::regex expression(pattern);
  std::set<std::string> all;
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it) {
    all.insert((*it)[1]);
  }
  return all;
}
std::set<std::string> ids(const File& file) { return matches(file.svg, " id=\"([^\"]+)\""); }
/// What the rules of style are about, as their selectors have it.
std::set<std::string> selectors(const File& file) {
  const std::size_t begin = file.svg.find("<style>"), end = file.svg.find("</style>");
  if (begin == std::string::npos) return {};
  return matches(file.svg.substr(begin + 7, end - begin - 7), "([^\\n{},]+)(?=[{,])");
}

TEST(SvgNames, OfTwoFilesAreNeverTheSame) {
  std::set<std::string> all_ids, all_selectors;
  for (const File& file : files()) {
    const auto of_file = ids(file);
    EXPECT_FALSE(of_file.empty()) << file.what;
    for (const std::string& id : of_file) {
      EXPECT_TRUE(all_ids.insert(id).second) << file.what << ": " << id;
      EXPECT_EQ(file.svg.find("id=\"" + id + "\""), file.svg.rfind("id=\"" + id + "\"")) << id;
    }
    for (const std::string& selector : selectors(file)) {
      EXPECT_EQ(selector.front(), '.') << file.what << ": " << selector << " is of the whole page";
      EXPECT_TRUE(all_selectors.insert(selector).second) << file.what << ": " << selector;
    }
  }
  EXPECT_GT(all_ids.size(), 20U);
  EXPECT_GT(all_selectors.size(), 30U);
}

TEST(SvgNames, OfAFileAllLeadToSomethingInIt) {
  std::size_t references = 0;
  for (const File& file : files()) {
    EXPECT_EQ(file.svg.find(kOwn.back()), std::string::npos) << file.what;
    const auto of_file = ids(file);
    for (const char* const pattern : {"url\\(#([^)]+)\\)", "href=\"#([^\"]+)\""}) {
      for (const std::string& name : matches(file.svg, pattern)) {
        EXPECT_TRUE(of_file.contains(name)) << file.what << ": " << name;
        ++references;
      }
    }
    const auto rules = selectors(file);
    for (const std::string& names : matches(file.svg, " class=\"([^\"]+)\"")) {
      for (const std::string& name : matches(names, "([^ ]+)")) {
        if (name == "shaded") continue;  // for pages to style
        const bool has_rule = std::ranges::any_of(rules, [&](const std::string& rule) {
          return (rule + ' ').find('.' + name + ' ') != std::string::npos;
        });
        EXPECT_TRUE(has_rule) << file.what << ": " << name;
      }
    }
  }
  EXPECT_GE(references, 10U);
}

TEST(SvgNames, AreAFunctionOfTheDrawing) {
  const auto again = files();
  std::size_t k = 0;
  for (const File& file : files()) EXPECT_EQ(file.svg, again[k++].svg) << file.what;
}

TEST(FileKey, ChangesWithAnyByte) {
  std::set<std::string> keys;
  std::string text(40, 'a');
  EXPECT_TRUE(std::regex_match(file_key({text}), std::regex("[0-9a-z]{7}")));
  EXPECT_EQ(file_key({text}), file_key({std::string(40, 'a')}));
  std::size_t texts = 0;
  const auto add = [&](std::initializer_list<std::string_view> parts) {
    keys.insert(file_key(parts));
    ++texts;
  };
  for (char& c : text) {
    for (int byte = 0; byte < 256; ++byte) {
      if (static_cast<char>(byte) == 'a') continue;
      c = static_cast<char>(byte);
      add({text});
    }
    c = 'a';
  }
  for (std::size_t length = 0; length <= text.size(); ++length) {
    const std::string_view all = text;
    add({all.substr(0, length)});
    add({all.substr(0, length), all.substr(length)});
  }
  EXPECT_EQ(keys.size(), texts);
}

/// What is known of it, so that files are the same on every machine.
TEST(FileKey, IsTheSameOnEveryMachine) {
  EXPECT_EQ(file_key({""}), "r3d8d7n");
  EXPECT_EQ(file_key({"M0 0l1 1Z", "and more"}), "0rq3s1w");
}

/// Drawn by librsvg, which takes rules and ids of nested files for those of the whole document.
class SvgPage : public TemporaryFolder {
 protected:
  void SetUp() override {
    if (std::system("command -v rsvg-convert > /dev/null 2>&1") != 0) {
      GTEST_SKIP() << "rsvg-convert is not installed";
    }
  }
  Picture rasterised(const std::string& svg) {
    const std::string name = file("page.svg", svg).string();
    EXPECT_EQ(std::system(fmt::format("rsvg-convert '{0}' -o '{0}.png'", name).c_str()), 0);
    return read_png(name + ".png");
  }
  /// Without what stands before it in a file.
  static std::string element(const File& file) { return file.svg.substr(file.svg.find("<svg")); }
  /// Side by side; null: nothing.
  static std::string page(const std::vector<const File*>& files, int size) {
    std::string text =
        fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\">\n",
                    size * static_cast<int>(files.size()), size);
    for (std::size_t k = 0; k < files.size(); ++k) {
      if (files[k] == nullptr) continue;
      text += fmt::format("<g transform=\"translate({} 0)\">\n{}</g>\n", size * static_cast<int>(k),
                          element(*files[k]));
    }
    return text + "</svg>\n";
  }
  /// In how many pixels of the place-th of the squares side by side two pictures differ.
  static int differ(const Picture& a, const Picture& b, std::size_t place, int size) {
    int number = 0;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const std::size_t column =
            place * static_cast<std::size_t>(size) + static_cast<std::size_t>(x);
        const auto at = [&](const Picture& p) {
          return p.pixels[static_cast<std::size_t>(y * p.width) + column];
        };
        number += at(a) != at(b) ? 1 : 0;
      }
    }
    return number;
  }
  /// The file alone, where it stands among so many.
  Picture alone(const File& file, std::size_t place, std::size_t places, int size) {
    std::vector<const File*> files(places, nullptr);
    files[place] = &file;
    return rasterised(page(files, size));
  }
};

constexpr int kPlace = 240;  // a sheet of 60 mm is some 227 pixels wide

TEST_F(SvgPage, EveryFileShowsWhatItShowsAlone) {
  const std::vector<File> all = files();
  std::vector<const File*> forward, backward;
  for (const File& file : all) forward.push_back(&file);
  backward.assign(forward.rbegin(), forward.rend());
  const Picture nothing = rasterised(page(std::vector<const File*>(all.size()), kPlace));
  for (const auto& order : {forward, backward}) {
    const Picture together = rasterised(page(order, kPlace));
    for (std::size_t k = 0; k < order.size(); ++k) {
      const Picture one = alone(*order[k], k, order.size(), kPlace);
      EXPECT_EQ(differ(together, one, k, kPlace), 0) << order[k]->what;
      EXPECT_GT(differ(one, nothing, k, kPlace), 100) << order[k]->what;
    }
  }
}

/// The same drawing, twice: both have the same names, which mean the same.
TEST_F(SvgPage, TheSameFileTwiceIsTheSamePictureTwice) {
  for (const File& file : files()) {
    const Picture twice = rasterised(page({&file, &file}, kPlace));
    for (const std::size_t place : {0U, 1U}) {
      EXPECT_EQ(differ(twice, alone(file, place, 2, kPlace), place, kPlace), 0) << file.what;
    }
  }
}

}  // namespace
}  // namespace displayfile
