// Styles of lines by kind, and of hidden lines: the routine, the recorder, and every output.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "displayfile/files.h"
#include "displayfile/looks/style.h"
#include "displayfile/user_routines/system_inside.h"
#include "interp/device/output_device.h"
#include "interp/draw/draw.h"
#include "tests/error_of.h"
#include "tests/replayed.h"
#include "tests/sides_of_kinds.h"

namespace displayfile {
namespace {

using test::dump_of;
using test::error_of;
using test::error_of_program;
using test::kCrease;
using test::kOutline;
using test::replayed;

/// A box with creases of its own style, seen so that three sides are hidden.
std::string box(const std::string& styles, const std::string& method = "franklin",
                const std::string& lines = "outline crease") {
  return "set-perspective 3 2 6\nset-hidden-line-removal on\nset-back-face-removal off\n"
         "set-hidden-method " +
         method + "\nset-hidden-lines dashed\nset-lines " + lines + "\n" + styles +
         "set-line-style solid 0 0 0 2\nopen-segment 1\nbox-3 -0.5 0.5 -0.5 0.5 -0.5 0.5\n"
         "close-segment\n";
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++n;
  return n;
}

/// The lengths of all lines of a dump, by line style.
std::map<std::string, std::size_t> lines_by_style(const std::string& dump) {
  std::map<std::string, std::size_t> lines;
  std::istringstream all(dump);
  std::string style;
  for (std::string line; std::getline(all, line);) {
    if (line.starts_with("line-style ")) style = line.substr(11);
    if (line.starts_with("line ")) ++lines[style];
  }
  return lines;
}

TEST(LineKindStyles, ReplaceWhatIsSet) {
  LineStyle line{.colour = {1, 0, 0}, .width = 2.0};
  EXPECT_EQ(side_line_style(line, kOutline), line);
  line.of_kinds =
      line.of_kinds.with(StyledLines::crease, {.width = 0.25, .colour = Colour(0, 0, 1)});
  EXPECT_EQ(side_line_style(line, kOutline).width, 2.0);
  EXPECT_EQ(side_line_style(line, kCrease).width, 0.25);
  EXPECT_EQ(side_line_style(line, kCrease).colour, Colour(0, 0, 1));
  // The first kind decides, as for layers.
  EXPECT_EQ(side_line_style(line, kOutline | kCrease).width, 2.0);
  EXPECT_EQ(side_line_style(line, kDrawn).width, 2.0);
  line.of_kinds = line.of_kinds.with(StyledLines::all, {.width = 3.0});
  EXPECT_EQ(side_line_style(line, kDrawn).width, 3.0);
  line.of_kinds = line.of_kinds.with(StyledLines::intersection,
                                     {.kind = LineStyle::Kind::dashed, .dash = 1.0, .gap = 2.0});
  const LineStyle dashed = side_line_style(line, kinds_of(LineKind::intersection));
  EXPECT_EQ(dashed.kind, LineStyle::Kind::dashed);
  EXPECT_EQ(dashed.dash, 1.0);
  EXPECT_EQ(dashed.gap, 2.0);
  EXPECT_EQ(dashed.width, 2.0);
  const LineStyle none{LineStyle::Kind::none, {}, 1.0, 6.0, 4.0, line.of_kinds};
  EXPECT_EQ(side_line_style(none, kCrease), none);
}

TEST(LineKindStyles, OfHiddenLinesAreDraftingPracticeByDefault) {
  LineStyle line{.width = 4.0};
  EXPECT_EQ(hidden_line_style(line).width, 2.0);
  EXPECT_EQ(hidden_line_style(line).dash, 12.0);
  line.of_kinds = line.of_kinds.with(StyledLines::hidden, {.width = 3.0});
  EXPECT_EQ(hidden_line_style(line).kind, LineStyle::Kind::dashed);
  EXPECT_EQ(hidden_line_style(line).width, 3.0);
  EXPECT_EQ(hidden_line_style(line).dash, 18.0);
  line.of_kinds = line.of_kinds.with(StyledLines::hidden, {.width = 3.0,
                                                           .kind = LineStyle::Kind::dashed,
                                                           .dash = 5.0,
                                                           .gap = 1.0,
                                                           .colour = Colour(1.0)});
  EXPECT_EQ(hidden_line_style(line).dash, 5.0);
  EXPECT_EQ(hidden_line_style(line).gap, 1.0);
  EXPECT_EQ(hidden_line_style(line).colour, Colour(1.0));
  line.of_kinds = line.of_kinds.with(StyledLines::hidden, {.kind = LineStyle::Kind::solid});
  EXPECT_EQ(hidden_line_style(line).kind, LineStyle::Kind::solid);
  EXPECT_EQ(hidden_line_style(line).width, 2.0);
}

TEST(LineKindStyles, AreEqualByWhatTheySet) {
  const LineKindStyles none;
  const LineKindStyles a = none.with(StyledLines::crease, {.width = 1.0});
  const LineKindStyles b = none.with(StyledLines::crease, {.width = 1.0});
  EXPECT_EQ(a, b);
  EXPECT_NE(a, none);
  EXPECT_NE(a, none.with(StyledLines::outline, {.width = 1.0}));
  EXPECT_EQ(a.with(StyledLines::crease, {}), none);
  EXPECT_TRUE(a.with(StyledLines::crease, {}).empty());
}

TEST(LineKindStyles, ProgramsSetThem) {
  const auto style_of = [](const std::string& arguments, StyledLines lines) {
    const GraphicsSystem g = replayed("set-line-kind-style " + arguments + "\n");
    return g.looks().attributes.line.of_kinds.of(lines);
  };
  using Kind = LineStyle::Kind;
  EXPECT_EQ(style_of("crease 0.18", StyledLines::crease), (LineKindStyle{.width = 0.18}));
  EXPECT_EQ(style_of("outline same 1 0 0", StyledLines::outline),
            (LineKindStyle{.colour = Colour(1, 0, 0)}));
  EXPECT_EQ(style_of("hidden 2 dashed", StyledLines::hidden),
            (LineKindStyle{.width = 2.0, .kind = Kind::dashed}));
  EXPECT_EQ(style_of("hidden 2 solid 0 1 0", StyledLines::hidden),
            (LineKindStyle{.width = 2.0, .kind = Kind::solid, .colour = Colour(0, 1, 0)}));
  EXPECT_EQ(style_of("all same dashed 3 1", StyledLines::all),
            (LineKindStyle{.kind = Kind::dashed, .dash = 3.0, .gap = 1.0}));
  EXPECT_EQ(
      style_of("material 1 dashed 3 1 0 0 1", StyledLines::material),
      (LineKindStyle{
          .width = 1.0, .kind = Kind::dashed, .dash = 3.0, .gap = 1.0, .colour = Colour(0, 0, 1)}));
  EXPECT_EQ(style_of("boundary 2\nset-line-style solid 1 1 1 5", StyledLines::boundary),
            (LineKindStyle{.width = 2.0}));
  EXPECT_EQ(style_of("boundary 2\nset-line-kind-style boundary same", StyledLines::boundary),
            LineKindStyle{});
}

TEST(LineKindStyles, WrongWordsAreRefusedWithTheirPlace) {
  const auto error = [](const std::string& arguments) {
    return error_of_program("set-line-kind-style " + arguments + "\n");
  };
  EXPECT_EQ(error("creese 1").substr(0, 16), "scene.draw:1:21:");
  EXPECT_NE(error("creese 1").find("did you mean 'crease'?"), std::string::npos)
      << error("creese 1");
  EXPECT_EQ(error("crease wide").substr(0, 16), "scene.draw:1:28:");
  for (const char* const bad : {"", "crease", "crease 1 2", "crease 1 solid 3 1", "crease 1 2 3",
                                "crease 1 dashed 3", "crease 1 1 2 3 4"}) {
    EXPECT_NE(
        error(bad).find("outline|boundary|crease|material|intersection|all|hidden|hatch width|same "
                        "[solid|dashed [dash gap]] [r g b]"),
        std::string::npos)
        << bad << ": " << error(bad);
  }
  EXPECT_NE(error("crease 0").find("expected more than 0 pixels"), std::string::npos);
  EXPECT_NE(error("crease -1").find("expected more than 0 pixels"), std::string::npos);
  EXPECT_NE(error("crease 1 dashed 0 1").find("expected more than 0 pixels"), std::string::npos);
  EXPECT_NE(error("crease 1 2 0 0").find("2"), std::string::npos);
  GraphicsSystem g;
  using Kind = LineStyle::Kind;
  for (const LineKindStyle& bad :
       {LineKindStyle{.kind = Kind::none}, LineKindStyle{.kind = Kind::dashed, .dash = 1.0},
        LineKindStyle{.dash = 1.0, .gap = 1.0},
        LineKindStyle{.kind = Kind::solid, .dash = 1.0, .gap = 1.0}}) {
    EXPECT_NE(error_of([&] { g.set_line_kind_style(StyledLines::crease, bad); }), "");
  }
  EXPECT_TRUE(g.looks().attributes.line.of_kinds.empty());
}

TEST(LineKindStyles, AreRecordedAndReplayed) {
  std::ostringstream program;
  Recorder recorder(program);
  GraphicsSystem g;
  g.set_recorder(&recorder);
  replay(box("set-line-kind-style crease 0.1\nset-line-kind-style outline same 0.3 0 1\n"
             "set-line-kind-style hidden 0.7 dashed 2.5 1.5 1 0 0\n"
             "set-line-kind-style all same\nset-line-kind-style boundary 1 solid\n"),
         "scene.draw", g);
  for (const char* const line :
       {"set-line-kind-style crease 0.1\n", "set-line-kind-style outline same 0.3 0 1\n",
        "set-line-kind-style hidden 0.7 dashed 2.5 1.5 1 0 0\n", "set-line-kind-style all same\n",
        "set-line-kind-style boundary 1 solid\n"}) {
    EXPECT_EQ(count(program.str(), line), 1u) << program.str();
  }
  const GraphicsSystem again = replayed(program.str());
  EXPECT_EQ(dump(again.display_file()), dump(g.display_file()));
  EXPECT_EQ(again.looks().attributes.line, g.looks().attributes.line);
}

TEST(LineKindStyles, ReplacedOnesStay) {
  GraphicsSystem g;
  SystemInside::replace_line_kind_style(g, StyledLines::crease, {.width = 3.0});
  replay("set-line-kind-style crease 1\nset-line-kind-style outline 1\n", "scene.draw", g);
  EXPECT_EQ(g.looks().attributes.line.of_kinds.of(StyledLines::crease).width, 3.0);
  EXPECT_EQ(g.looks().attributes.line.of_kinds.of(StyledLines::outline).width, 1.0);
  EXPECT_NE(error_of_program("set-line-kind-style crease 0\n", g), "");
}

TEST(LineKindStyles, DumpsHaveTheStyleOfEachLine) {
  const std::string styles =
      "set-line-kind-style crease 0.5 0 0 1\nset-line-kind-style hidden 0.75 dashed 3 2\n";
  const auto plain = lines_by_style(dump_of(box("")));
  EXPECT_EQ(plain,
            (std::map<std::string, std::size_t>{{"dashed 0 0 0 1 6 4", 3}, {"solid 0 0 0 2", 9}}));
  const auto styled = lines_by_style(dump_of(box(styles)));
  // The hidden sides are creases: their colour is the crease's.
  EXPECT_EQ(styled,
            (std::map<std::string, std::size_t>{
                {"dashed 0 0 1 0.75 3 2", 3}, {"solid 0 0 0 2", 6}, {"solid 0 0 1 0.5", 3}}));
  // Sides of polygons that a sort draws: of each polygon those that are its own.
  for (const char* const method : {"bsp", "depth-sort", "z-buffer", "map"}) {
    const auto sides = lines_by_style(dump_of(box(styles, method)));
    EXPECT_GE(sides.at("solid 0 0 0 2"), 6u) << method;
    EXPECT_GE(sides.at("solid 0 0 1 0.5"), 3u) << method;
  }
}

TEST(LineKindStyles, OfLinesThatFollow) {
  const std::string dumped = dump_of(
      "set-hidden-line-removal on\nset-hidden-method franklin\nset-lines boundary\n"
      "set-line-kind-style boundary 4\nopen-segment 1\npolygon-abs-3 0 0 0  0.5 0 0  0 0.5 0\n"
      "set-line-kind-style boundary 5\npolygon-abs-3 -0.1 0 0  -0.5 0 0  -0.1 -0.5 0\n"
      "move-abs-3 -0.9 -0.9 0\nline-abs-3 -0.8 -0.9 0\nclose-segment\n"
      "set-line-kind-style boundary same\nopen-segment 2\n"
      "polygon-abs-3 0.6 0 0  0.9 0 0  0.6 0.5 0\nclose-segment\n");
  // Lines of the application are of no kind.
  EXPECT_EQ(lines_by_style(dumped),
            (std::map<std::string, std::size_t>{
                {"solid 0 0 0 4", 3}, {"solid 0 0 0 5", 3}, {"solid 0 0 0 1", 4}}))
      << dumped;
}

TEST(LineKindStyles, SidesWithoutASelectionAreAll) {
  const std::string program =
      "set-line-kind-style all 3\nopen-segment 1\npolygon-abs-3 0 0 0  0.5 0 0  0 0.5 0\n"
      "move-abs-3 -0.9 -0.9 0\nline-abs-3 -0.8 -0.9 0\nclose-segment\n";
  EXPECT_EQ(lines_by_style(dump_of(program)),
            (std::map<std::string, std::size_t>{{"solid 0 0 0 3", 3}, {"solid 0 0 0 1", 1}}));
}

/// The widths of the strokes of an SVG, by the classes beside that of the style.
std::map<std::string, std::string> widths_in(const std::string& svg) {
  std::map<std::string, std::string> of_class, widths;
  const std::regex rule(R"(\.(l[^ {]*)\{stroke:[^;]*;stroke-width:([0-9.]*)([^}]*)\})");
  for (std::sregex_iterator m(svg.begin(), svg.end(), rule), end; m != end; ++m) {
    const bool dashed = (*m)[3].str().find("dasharray") != std::string::npos;
    of_class[(*m)[1]] = (*m)[2].str() + (dashed ? " dashed" : "");
  }
  const std::regex path(R"x(<path class="(l[^ "]*) ?([^"]*)")x");
  for (std::sregex_iterator m(svg.begin(), svg.end(), path), end; m != end; ++m) {
    widths[(*m)[2]] = of_class[(*m)[1]];
  }
  return widths;
}

TEST(LineKindStyles, SvgHasThemAndAClassOfHiddenLines) {
  const std::string styles =
      "set-line-kind-style outline 3\nset-line-kind-style crease 0.5\n"
      "set-line-kind-style hidden 0.25 solid\n";
  const std::string svg = draw_as(replayed(box(styles)), "svg");
  EXPECT_EQ(widths_in(svg),
            (std::map<std::string, std::string>{
                {"outline crease", "3"}, {"crease", "0.5"}, {"crease hidden", "0.25"}}))
      << svg;
  // Over fills, too.
  const std::string filled = draw_as(replayed(box(styles, "bsp")), "svg");
  EXPECT_EQ(widths_in(filled), widths_in(svg)) << filled;
  // By default as without a style, except for the class.
  const auto usual = widths_in(draw_as(replayed(box("")), "svg"));
  EXPECT_EQ(usual.at("crease hidden"), "1 dashed");
  EXPECT_EQ(widths_in(draw_as(replayed(box("", "franklin", "all")), "svg")).at("hidden"),
            "1 dashed");
}

TEST(LineKindStyles, PdfHasALayerOfHiddenLines) {
  const std::string pdf = draw_as(replayed(box("set-line-kind-style hidden 0.25\n")), "pdf");
  EXPECT_EQ(count(pdf, "/Name (outline)"), 1u);
  EXPECT_EQ(count(pdf, "/Name (crease)"), 1u);
  EXPECT_EQ(count(pdf, "/Name (hidden)"), 1u);
}

TEST(LineKindStyles, PensAreTheirWidths) {
  DrawOptions options;
  options.pens.emplace();
  options.format = "svg";
  options.vectors.paper = Paper{.width = 532.0, .height = 532.0};  // 1 mm a pixel
  std::ostringstream out;
  draw(replayed(box("set-line-kind-style outline 3\nset-line-kind-style crease 0.5\n"
                    "set-line-kind-style hidden 0.25\n")),
       out, options);
  for (const char* const width : {"\"3\"", "\"0.5\"", "\"0.25\""}) {
    EXPECT_EQ(count(out.str(), std::string("stroke-width=") + width), 1u) << width;
  }
}

TEST(LineKindStyles, PixelsHaveThem) {
  // A square whose sides are boundaries, 100 pixels from the picture's border.
  const auto dark = [](const std::string& styles, const std::string& method) {
    const GraphicsSystem g =
        replayed("set-hidden-line-removal on\nset-hidden-method " + method +
                 "\nset-lines boundary\n" + styles +
                 "set-fill-style solid 1 1 1\nset-line-style solid 0 0 0 1\nopen-segment 1\n"
                 "polygon-abs-3 -0.5 -0.5 0  0.5 -0.5 0  0.5 0.5 0  -0.5 0.5 0\nclose-segment\n");
    const Picture picture = draw(g, {.width = 400, .height = 400, .samples = 1});
    return static_cast<double>(std::ranges::count(picture.pixels, 0xff000000u));
  };
  for (const char* const method :
       {"franklin", "bsp", "z-buffer", "scan-line", "map", "colour-rule", "plain-z-buffer"}) {
    EXPECT_NEAR(dark("", method), 800.0, 10.0) << method;
    EXPECT_NEAR(dark("set-line-kind-style boundary 5\n", method), 4000.0, 40.0) << method;
    EXPECT_EQ(dark("set-line-kind-style boundary same 1 0 0\n", method), 0.0) << method;
  }
}

TEST(LineKindStyles, PiecesHaveLinesBesideThePolygons) {
  const GraphicsSystem g = replayed(
      "set-lines boundary\nset-line-kind-style boundary 4\nopen-segment 1\n"
      "polygon-abs-3 0 0 0  0.5 0 0  0 0.5 0\nclose-segment\n");
  const DrawnPieces pieces = drawn_pieces(g.display_file());
  ASSERT_EQ(pieces.size(), 4u);
  EXPECT_EQ(pieces.kinds[0], DrawnPieces::Kind::solid);
  EXPECT_EQ(std::ranges::count(pieces.sides, 0), 6);
  for (std::size_t k = 1; k < 4; ++k) {
    EXPECT_EQ(pieces.kinds[k], DrawnPieces::Kind::line);
    EXPECT_EQ(pieces.line_widths[k], 4.0);
    EXPECT_EQ(pieces.sides[pieces.first[k] + 1], kinds_of(LineKind::boundary));
  }
  const DrawnPieces hidden = drawn_pieces(replayed(box("")).display_file());
  EXPECT_EQ(std::ranges::count_if(hidden.sides, is_hidden_line), 3);
}

}  // namespace
}  // namespace displayfile
