// Several SVG files in one page: ids, classes and style rules apply to the whole page, so that
// those of a file must be unique (interp/vector/file_key.h).

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
#include "tests/without_keys.h"

namespace displayfile {
namespace {

using namespace test;

constexpr int kSize = 64;

struct File {
  std::string what, svg;
};

/// A drawing of which files are made.
struct Drawing {
  std::string what, program;
  DrawOptions options = {};
};

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

/// Drawings that differ in the meaning of ids and classes, in every way that files have. Some have
/// the same styles and differ only in places.
std::vector<Drawing> drawings() {
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
      Drawing{"red and yellow", neighbours("1 0 0", "1 1 0", 0.3), map},
      Drawing{"blue and green", neighbours("0 0 1", "0 0.5 0", 0.7), map},
      Drawing{"red and yellow, elsewhere", neighbours("1 0 0", "1 1 0", 0.45), map},
      Drawing{"painted", neighbours("0 1 1", "1 0 1", 0.5)},
      Drawing{"painted, shaded", shaded("0 1 0", "0.5 1 0")},
      Drawing{"outlined", outlined("0 1 0", "solid 0.5 0 0.5 3")},
      Drawing{"coarse", neighbours("0 0 0", "1 0.5 0", 0.4),
              [&] {
                DrawOptions coarse = map;
                coarse.vectors.precision = 0.5;
                return coarse;
              }()},
      Drawing{"shaded red", shaded("1 0 0", "1 0 0.5"), map},
      Drawing{"shaded blue", shaded("0 0 1", "0 1 0.5"), map},
      Drawing{"thick lines", lines_and_text("solid 1 0 0 6", "1 1 0.8", 0.3, "left"), lines},
      Drawing{"thin lines", lines_and_text("dashed 0 0 1 2", "0.8 1 1", 0.15, "right"), lines},
      Drawing{"on paper", neighbours("0.5 0 0", "0 0.5 0.5", 0.45), on_paper},
      Drawing{"for pens", lines_and_text("solid 0 0.5 0 4", "1 1 1", 0.2, "centre"), pens},
      Drawing{"for another pen", lines_and_text("solid 0.5 0 0 8", "1 1 1", 0.2, "centre"), pens},
  };
}

/// With the files' keys, or each with a prefix of its own in place of that.
std::vector<File> files(bool with_prefixes = false) {
  std::vector<File> all;
  for (const Drawing& drawing : drawings()) {
    DrawOptions options = drawing.options;
    options.width = options.height = kSize;
    options.vectors.is_inline = with_prefixes;
    if (with_prefixes) options.vectors.id_prefix = fmt::format("figure_{}-", all.size());
    all.push_back({drawing.what, draw_as(replayed(drawing.program), ".svg", options)});
  }
  return all;
}

std::set<std::string> matches(const std::string& text, const char* pattern) {
  const std::regex expression(pattern);
  std::set<std::string> all;
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it) {
    all.insert((*it)[1]);
  }
  return all;
}
/// Without the text before it in a file.
std::string element(const File& file) { return file.svg.substr(file.svg.find("<svg")); }

std::set<std::string> ids(const File& file) { return matches(file.svg, " id=\"([^\"]+)\""); }
/// The elements that the style rules apply to, by their selectors.
std::set<std::string> selectors(const File& file) {
  const std::size_t begin = file.svg.find("<style>"), end = file.svg.find("</style>");
  if (begin == std::string::npos) return {};
  return matches(file.svg.substr(begin + 7, end - begin - 7), "([^\\n{},]+)(?=[{,])");
}

class SvgNames : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(WithKeysAndPrefixes, SvgNames, testing::Bool());

TEST_P(SvgNames, OfTwoFilesAreNeverTheSame) {
  std::set<std::string> all_ids, all_selectors;
  for (const File& file : files(GetParam())) {
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

TEST_P(SvgNames, OfAFileAllLeadToSomethingInIt) {
  std::size_t references = 0;
  for (const File& file : files(GetParam())) {
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

TEST_P(SvgNames, AreAFunctionOfTheDrawing) {
  const auto again = files(GetParam());
  std::size_t k = 0;
  for (const File& file : files(GetParam())) EXPECT_EQ(file.svg, again[k++].svg) << file.what;
}

/// Every id and selector of a file begins with its prefix, and except for these names it is the
/// file with a key.
TEST(SvgPrefix, IsBeforeEveryName) {
  const std::vector<File> with_keys = files(), with_prefixes = files(true);
  for (std::size_t k = 0; k < with_prefixes.size(); ++k) {
    const File& file = with_prefixes[k];
    const std::string prefix = fmt::format("figure_{}-", k);
    for (const std::string& id : ids(file)) EXPECT_TRUE(id.starts_with(prefix)) << id;
    for (const std::string& selector : selectors(file)) {
      for (const std::string& name : matches(selector, "\\.([^ .{]+)")) {
        EXPECT_TRUE(name.starts_with(prefix)) << file.what << ": " << name;
      }
    }
    EXPECT_TRUE(file.svg.starts_with("<svg ")) << file.what << ": " << file.svg.substr(0, 40);
    std::string without = file.svg;
    for (std::size_t at = without.find(prefix); at != without.npos; at = without.find(prefix)) {
      without.erase(at, prefix.size());
    }
    EXPECT_EQ(without, without_keys(element(with_keys[k]))) << file.what;
  }
}

TEST(SvgPrefix, IsOfLettersDigitsAndLinesAndOfSvg) {
  const GraphicsSystem g = replayed(neighbours("1 0 0", "1 1 0", 0.3));
  for (const char* const bad : {"1", "-a", "a b", "a.", "\u00e9", "a#", "a\""}) {
    const DrawOptions options{.vectors = {.id_prefix = bad}};
    EXPECT_NE(error_of([&] { draw_as(g, "svg", options); }).find("prefix of ids"),
              std::string::npos)
        << bad;
  }
  for (const char* const format : {"pdf", "eps", "png", "ppm"}) {
    const auto refused = [&](const VectorOptions& vectors) {
      return error_of([&] { draw_as(g, format, {.vectors = vectors}); });
    };
    EXPECT_NE(refused({.id_prefix = "a"}).find("expected .svg"), std::string::npos) << format;
    EXPECT_NE(refused({.is_inline = true}).find("expected .svg"), std::string::npos) << format;
    const bool has_layers = std::string_view(format) == "pdf";
    EXPECT_EQ(refused({.layers = true}).empty(), has_layers) << format;
  }
  const DrawOptions pens{.pens = Pens{}, .vectors = {.layers = true}};
  EXPECT_NE(error_of([&] { draw_as(g, "svg", pens); }).find("a layer for each pen"),
            std::string::npos);
}

/// Segments with titles, drawn as SVG by a method.
std::string titled(const std::vector<std::string>& titles, HiddenMethod method, bool layers,
                   const char* format = "svg") {
  std::string program = "set-window 0 1 0 1\nset-line-style solid 0 0 0 1\n";
  for (std::size_t k = 0; k < titles.size(); ++k) {
    const double low = 0.9 * static_cast<double>(k) / static_cast<double>(titles.size());
    program += fmt::format(
        "open-segment {0}\nset-fill-style solid 0.{0} 0.5 1\nset-segment-title {0} {1}\n"
        "polygon-abs-2 {2} {2}  {3} {2}  {3} {3}\nclose-segment\n",
        k + 1, titles[k], low, low + 0.2);
  }
  DrawOptions options;
  options.surfaces.method = method;
  options.vectors.layers = layers;
  options.vectors.id_prefix = std::string_view(format) == "svg" ? "p-" : "";
  return draw_as(replayed(program), format, options);
}

TEST(SvgTitles, AreTitlesAndIdsThatAreValidAndUnique) {
  for (const HiddenMethod method :
       {HiddenMethod::map, HiddenMethod::franklin, HiddenMethod::none}) {
    const std::string svg = titled({"\"Bolt M6\"", "\"a < b & c\"", "\"\u00d8 \u00e9\"", "\"r1\"",
                                    "\"Bolt M6\"", "\"Bolt_M6-2\"", "\"2 \\\"in\\\"\"", "\"\""},
                                   method, false);
    const std::set<std::string> all = matches(svg, "<g id=\"([^\"]+)\"");
    for (const char* const id : {"p-Bolt_M6", "p-a___b___c", "p-___", "p-_r1", "p-Bolt_M6-2",
                                 "p-Bolt_M6-2-2", "p-_2__in_", "p-segment-8"}) {
      EXPECT_TRUE(all.contains(id)) << id << "\n" << svg;
    }
    for (const std::string& id : all) {
      EXPECT_TRUE(std::regex_match(id, std::regex("[A-Za-z_][A-Za-z0-9_-]*"))) << id;
      EXPECT_EQ(svg.find("id=\"" + id + "\""), svg.rfind("id=\"" + id + "\"")) << id;
    }
    for (const char* const title :
         {"Bolt M6", "a &lt; b &amp; c", "\u00d8 \u00e9", "r1", "2 \"in\""}) {
      EXPECT_NE(svg.find(fmt::format("<title>{}</title>", title)), std::string::npos) << title;
    }
    EXPECT_EQ(svg.find("<title></title>"), std::string::npos);
    EXPECT_EQ(svg.find("inkscape"), std::string::npos);
  }
}

TEST(SvgTitles, AreLayers) {
  for (const HiddenMethod method :
       {HiddenMethod::map, HiddenMethod::franklin, HiddenMethod::none}) {
    const std::string svg =
        titled({"\"Bolt & \\\"nut\\\"\"", "\"\"", "\"pin\"", "\"pin\""}, method, true);
    EXPECT_NE(svg.find("xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\""),
              std::string::npos);
    for (const char* const label :
         {"Bolt &amp; &quot;nut&quot;", "segment 2", "pin (segment 3)", "pin (segment 4)"}) {
      EXPECT_NE(svg.find(fmt::format("inkscape:groupmode=\"layer\" inkscape:label=\"{}\"", label)),
                std::string::npos)
          << label << svg;
    }
  }
}

/// A title may be a name that a segment without one gets, or one that tells equal titles apart.
TEST(SvgTitles, LayersHaveNamesOfTheirOwn) {
  const std::string svg = titled({"\"\"", "\"segment 1\"", "\"pin\"", "\"pin\"",
                                  "\"pin (segment 3)\"", "\"pin (segment 3) (segment 3)\""},
                                 HiddenMethod::map, true);
  EXPECT_EQ(matches(svg, "inkscape:label=\"((?:segment|pin)[^\"]+)\"").size(), 6u) << svg;
}

std::size_t times_in(const std::string& text, const std::string& words) {
  std::size_t n = 0;
  for (std::size_t at = text.find(words); at != text.npos; at = text.find(words, at + 1)) ++n;
  return n;
}

TEST(PdfTitles, AreLayers) {
  for (const HiddenMethod method :
       {HiddenMethod::map, HiddenMethod::franklin, HiddenMethod::none}) {
    const std::vector<std::string> titles{"\"Bolt M6\"", "\"\"", "\"pin\"", "\"pin\""};
    const std::string pdf = titled(titles, method, true, "pdf");
    EXPECT_EQ(times_in(pdf, "/Type /OCG"), 4u);
    for (const char* const name : {"(Bolt M6)", "(segment 2)"}) {
      EXPECT_EQ(times_in(pdf, std::string("/Name ") + name), 1u) << name;
    }
    EXPECT_EQ(times_in(titled(titles, method, false, "pdf"), "/OC"), 0u);
  }
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

/// Known keys, so that files are the same on every machine.
TEST(FileKey, IsTheSameOnEveryMachine) {
  EXPECT_EQ(file_key({""}), "r3d8d7n");
  EXPECT_EQ(file_key({"M0 0l1 1Z", "and more"}), "0rq3s1w");
}

/// Drawn by librsvg, which takes rules and ids of nested files for those of the whole document. The
/// parameter: with a prefix for each file.
class SvgPage : public TemporaryFolder, public testing::WithParamInterface<bool> {
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
  /// The number of pixels of the place-th of the squares side by side in which two pictures differ.
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
  /// The file alone, in its place among `places`.
  Picture alone(const File& file, std::size_t place, std::size_t places, int size) {
    std::vector<const File*> files(places, nullptr);
    files[place] = &file;
    return rasterised(page(files, size));
  }
};

constexpr int kPlace = 240;  // a sheet of 60 mm is some 227 pixels wide

INSTANTIATE_TEST_SUITE_P(WithKeysAndPrefixes, SvgPage, testing::Bool());

TEST_P(SvgPage, EveryFileShowsWhatItShowsAlone) {
  const std::vector<File> all = files(GetParam());
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
TEST_P(SvgPage, TheSameFileTwiceIsTheSamePictureTwice) {
  for (const File& file : files(GetParam())) {
    const Picture twice = rasterised(page({&file, &file}, kPlace));
    for (const std::size_t place : {0U, 1U}) {
      EXPECT_EQ(differ(twice, alone(file, place, 2, kPlace), place, kPlace), 0) << file.what;
    }
  }
}

}  // namespace
}  // namespace displayfile
