// Kinds of lines in the files that are drawn: classes in SVG, layers in PDF.

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "interp/draw/draw.h"
#include "tests/quad_meshes.h"
#include "tests/temporary_folder.h"
#include "tests/without_keys.h"

namespace displayfile {
namespace {

using test::box;
using test::drawn_with;
using test::enter;

class LineKindsFiles : public test::TemporaryFolder {
 protected:
  /// The content of the file into which a box with those lines is drawn.
  std::string box_in(const std::string& name, const std::string& words, HiddenMethod method) {
    const GraphicsSystem g =
        drawn_with(words, [](GraphicsSystem& system) { enter(system, box()); });
    draw(g, file(name), {.surfaces = {.method = method}});
    return test::without_keys(test::content(file(name)));
  }
};

TEST_F(LineKindsFiles, EachKindIsAClassInSvg) {
  const auto draw_box = [&](const std::string& words, HiddenMethod method) {
    return box_in("box.svg", words, method);
  };
  for (const HiddenMethod method :
       {HiddenMethod::franklin, HiddenMethod::bsp, HiddenMethod::z_buffer, HiddenMethod::none}) {
    const std::string svg = draw_box("outline,crease", method);
    EXPECT_NE(svg.find("class=\"l1 outline crease\""), std::string::npos) << name_of(method);
    EXPECT_NE(svg.find("class=\"l1 crease\""), std::string::npos) << name_of(method);
    EXPECT_EQ(svg.find("class=\"l1\""), std::string::npos) << name_of(method);
    EXPECT_EQ(draw_box("all", method).find("crease"), std::string::npos);
  }
  EXPECT_NE(draw_box("all,outline", HiddenMethod::franklin).find("class=\"l1 all\""),
            std::string::npos);
}

std::size_t occurrences(const std::string& text, const std::string& words) {
  std::size_t n = 0;
  for (std::size_t at = text.find(words); at != text.npos; at = text.find(words, at + 1)) ++n;
  return n;
}

/// A line of several kinds stands in the layer of the first.
TEST_F(LineKindsFiles, EachKindIsALayerInPdf) {
  const auto draw_box = [&](const std::string& words, HiddenMethod method) {
    return box_in("box.pdf", words, method);
  };
  for (const HiddenMethod method : {HiddenMethod::franklin, HiddenMethod::bsp}) {
    const std::string pdf = draw_box("outline,crease", method);
    EXPECT_EQ(occurrences(pdf, "/Type /OCG"), 2u);
    EXPECT_EQ(occurrences(pdf, "/Name (outline)"), 1u);
    EXPECT_EQ(occurrences(pdf, "/Name (crease)"), 1u);
    EXPECT_EQ(occurrences(pdf, "StructTreeRoot"), 0u);
    EXPECT_EQ(draw_box("outline,crease", method), pdf);
    EXPECT_EQ(occurrences(draw_box("outline", method), "/Type /OCG"), 1u);
    EXPECT_EQ(occurrences(draw_box("all", method), "/OC"), 0u);
  }
}

}  // namespace
}  // namespace displayfile
