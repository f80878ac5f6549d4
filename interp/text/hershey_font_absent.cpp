// A build that reads no files, for pages: there are no Hershey fonts.

#include "clip/base/error.h"
#include "interp/text/hershey_font.h"

namespace displayfile {

HersheyFont::HersheyFont(const std::string& name) : name_(name) {
  throw Error("font hershey:" + name + ": this build reads no fonts: expected a font's name");
}

double HersheyFont::width(std::string_view) const { return 0.0; }

std::vector<std::vector<Point2>> HersheyFont::strokes(std::string_view, const Point2&, double,
                                                      double) const {
  return {};
}

void HersheyFont::add_lacking(std::string_view, std::set<std::string>&) const {}

const HersheyFont& hershey_font(const std::string& name) {
  static const HersheyFont font(name);
  return font;
}

}  // namespace displayfile
