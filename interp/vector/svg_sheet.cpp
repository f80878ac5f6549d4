#include "interp/vector/svg_sheet.h"

#include <fmt/format.h>

namespace displayfile {

void write_on_sheet(std::string_view document, const PaperFit& sheet, std::ostream& out) {
  const std::size_t svg = document.find("<svg");
  out << document.substr(0, svg)
      << fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"{0}mm\" "
             "height=\"{1}mm\" viewBox=\"0 0 {0} {1}\">\n"
             "<g transform=\"translate({2} {3}) scale({4})\">\n",
             sheet.width, sheet.height, sheet.left, sheet.top, sheet.pixel)
      << document.substr(svg) << "</g>\n</svg>\n";
}

}  // namespace displayfile
