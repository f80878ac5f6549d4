#include "interp/vector/svg_ramps.h"

#include <fmt/format.h>

#include <iterator>

#include "interp/vector/file_key.h"

namespace displayfile {

namespace {

/// Appends an end with at most six decimals, the precision of ramps, in the shortest form.
void append_ramp_end(std::string& out, const char* name, double v) {
  std::string digits = fmt::format("{:.6f}", v);
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  if (digits == "-0") digits = "0";
  fmt::format_to(std::back_inserter(out), " {}=\"{}\"", name, digits);
}

}  // namespace

std::size_t SvgRamps::number(const FillPaint& paint, double unit) {
  const auto [known, is_new] = numbers_.try_emplace({paint, unit}, numbers_.size() + 1);
  if (!is_new) return known->second;
  const auto [colour, new_colour] = colours_.try_emplace(paint.pixel, colours_.size() + 1);
  if (new_colour) {
    fmt::format_to(std::back_inserter(stops_),
                   "<linearGradient id=\"c{}{}\" gradientUnits=\"userSpaceOnUse\">"
                   "<stop offset=\"0\"/><stop offset=\"1\" stop-color=\"#{:02x}{:02x}{:02x}\"/>"
                   "</linearGradient>\n",
                   colour->second, kOwn, paint.pixel & 0xff, (paint.pixel >> 8) & 0xff,
                   (paint.pixel >> 16) & 0xff);
  }
  fmt::format_to(std::back_inserter(ends_),
                 "<linearGradient id=\"r{0}{2}\" xlink:href=\"#c{1}{2}\"", known->second,
                 colour->second, kOwn);
  append_ramp_end(ends_, "x1", paint.ramp->black_x / unit);
  append_ramp_end(ends_, "y1", paint.ramp->black_y / unit);
  append_ramp_end(ends_, "x2", paint.ramp->full_x / unit);
  append_ramp_end(ends_, "y2", paint.ramp->full_y / unit);
  ends_ += "/>\n";
  return known->second;
}

void SvgRamps::write(std::ostream& out) const {
  if (numbers_.empty()) return;
  out << "<defs xmlns:xlink=\"http://www.w3.org/1999/xlink\">\n" << stops_ << ends_ << "</defs>\n";
}

}  // namespace displayfile
