#include "interp/vector/svg_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <ostream>
#include <string_view>
#include <utility>

#include "clip/base/collected_text.h"
#include "displayfile/text/characters.h"
#include "displayfile/text/output.h"
#include "interp/device/interpreter.h"
#include "interp/device/picture.h"
#include "interp/vector/escaped_xml.h"
#include "interp/vector/file_key.h"
#include "interp/vector/seams.h"
#include "interp/vector/svg_sheet.h"

namespace displayfile {

namespace {

long long thousandths_of(double v) { return std::llround(v * 1000.0); }

/// A number in the shortest form.
void append_thousandths(std::string& out, long long thousandths) {
  if (thousandths < 0) {
    out.push_back('-');
    thousandths = -thousandths;
  }
  const long long whole = thousandths / 1000;
  int fraction = static_cast<int>(thousandths % 1000);
  if (whole != 0 || fraction == 0) {
    std::array<char, 24> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), whole).ptr;
    out.append(digits.data(), end);
  }
  if (fraction == 0) return;
  out.push_back('.');
  for (int unit = 100; fraction != 0; fraction %= unit, unit /= 10) {
    out.push_back(static_cast<char>('0' + fraction / unit));
  }
}

/// A coordinate to a thousandth of a pixel. At most 1e6 in magnitude.
void append_coordinate(std::string& out, double v) { append_thousandths(out, thousandths_of(v)); }

/// Appends a number after another, with a blank between them where they would read as one.
void append_next_thousandths(std::string& out, long long thousandths, bool before_has_point) {
  const bool begins_with_point = thousandths > 0 && thousandths < 1000;
  if (thousandths >= 0 && !(begins_with_point && before_has_point)) out.push_back(' ');
  append_thousandths(out, thousandths);
}

std::string_view text_anchor(TextStyle::Alignment alignment) {
  switch (alignment) {
    case TextStyle::Alignment::left: return "start";
    case TextStyle::Alignment::centre: return "middle";
    case TextStyle::Alignment::right: break;
  }
  return "end";
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// True for names used as ids of ramps, masks and traps.
bool is_reserved(std::string_view name) {
  for (const std::string_view kind : {"r", "c", "figure-", "traps-"}) {
    if (name.starts_with(kind) && std::ranges::all_of(name.substr(kind.size()), is_digit)) {
      return true;
    }
  }
  return false;
}

/// Converts a title to a name: letters, digits, - and _ unchanged, and _ for each other character;
/// it begins with a letter or _.
std::string id_of_title(std::string_view title) {
  std::string id;
  while (!title.empty()) {
    const char c = title.front();
    id += is_letter(c) || is_digit(c) || c == '-' ? c : '_';
    title.remove_prefix(std::max<std::size_t>(utf8_length(title), 1));
  }
  const bool begins_as_a_name = is_letter(id.front()) || id.front() == '_';
  return begins_as_a_name && !is_reserved(id) ? id : '_' + id;
}

std::string hex(std::uint32_t pixel) {
  return fmt::format("#{:02x}{:02x}{:02x}", pixel & 0xff, (pixel >> 8) & 0xff,
                     (pixel >> 16) & 0xff);
}

}  // namespace

/// The name, with a number appended if an element already has that id.
std::string SvgDevice::new_id(const std::string& name) {
  for (int& times = times_taken_[name];;) {
    std::string id = ++times == 1 ? name : fmt::format("{}-{}", name, times);
    if (ids_.insert(id).second) return id;
  }
}

void SvgDevice::open_group(int segment_name) {
  const std::string_view title = title_of(segment_name);
  const std::string id =
      new_id(title.empty() ? fmt::format("segment-{}", segment_name) : id_of_title(title));
  fmt::format_to(std::back_inserter(body_), "<g id=\"{}{}\" class=\"segment{}\"", id, kOwn, kOwn);
  if (options().layers) append_layer(layer_of(segment_name));
  body_ += ">\n";
  if (!title.empty()) {
    body_ += "<title>";
    append_escaped(body_, title);
    body_ += "</title>\n";
  }
  joinable_ = {};
}

void SvgDevice::append_layer(std::string_view label) {
  body_ += " inkscape:groupmode=\"layer\" inkscape:label=\"";
  append_escaped_value(body_, label);
  body_ += '"';
}

void SvgDevice::close_group() {
  body_ += "</g>\n";
  joinable_ = {};
}

/// Writes the first point of each run absolute, the others as differences of rounded points, so
/// that errors do not accumulate.
void SvgDevice::append_path_data(const Path& path) {
  data_.clear();
  for (std::size_t i = 0; i < path.runs.size(); ++i) {
    long long x = 0, y = 0;
    char command = 'M';
    bool before_has_point = false;
    for (const Point2& p : path.run(i)) {
      const long long to_x = thousandths_of(p.x), to_y = thousandths_of(p.y);
      if (command != 0) {
        data_.push_back(command);
        append_thousandths(data_, to_x - x);
      } else {
        append_next_thousandths(data_, to_x - x, before_has_point);
      }
      append_next_thousandths(data_, to_y - y, (to_x - x) % 1000 != 0);
      before_has_point = (to_y - y) % 1000 != 0;
      command = command == 'M' ? 'l' : char{0};
      x = to_x;
      y = to_y;
    }
    if (path.runs[i].closed) data_.push_back('Z');
  }
}

void SvgDevice::paint_fill(const Path& path, const FillPaint& paint, bool seam) {
  append_path_data(path);
  body_ += "<path";
  if (paint.ramp) {
    const std::size_t number = ramps_.number(paint, 1.0);
    fmt::format_to(std::back_inserter(body_), " fill=\"url(#r{}{})\"", number, kOwn);
    if (seam) {
      fmt::format_to(std::back_inserter(body_), " stroke=\"url(#r{}{})\"", number, kOwn);
    }
    body_ += " class=\"shaded";
  } else {
    fmt::format_to(std::back_inserter(body_), " class=\"f{}{}", fill_class({paint.pixel, seam}),
                   kOwn);
  }
  const std::size_t class_end = body_.size();
  body_ += "\" d=\"";
  joinable_ = {};
  if (!seam) joinable_ = {class_end, body_.size(), body_.size() + data_.size()};
  body_ += data_;
  body_ += "\"/>\n";
}

void SvgDevice::paint_lines(const Path& path, const LineStyle& style, LineKinds kinds,
                            LineCap cap) {
  const bool dashed = style.kind == LineStyle::Kind::dashed;
  const LineKey key{pixel_of(style.colour), style.width, dashed ? style.dash : 0.0,
                    dashed ? style.gap : 0.0, cap == LineCap::round};
  const std::size_t number = line_classes_.try_emplace(key, line_classes_.size() + 1).first->second;
  append_path_data(path);
  const auto outline_before =
      std::string_view(body_).substr(joinable_.data, joinable_.data_end - joinable_.data);
  if (joinable_.class_end != 0 && outline_before == data_ && !has_kind(kinds)) {
    body_.insert(joinable_.class_end, fmt::format(" l{}{}", number, kOwn));
  } else {
    fmt::format_to(std::back_inserter(body_), "<path class=\"l{}{}{}{}\"{} d=\"", number, kOwn,
                   has_kind(kinds) ? " " : "", names_of(kinds),
                   cap == LineCap::square ? " stroke-linecap=\"square\"" : "");
    body_ += data_;
    body_ += "\"/>\n";
  }
  joinable_ = {};
}

/// Blanks that XML would collapse are preserved.
void SvgDevice::paint_text(const DeviceText& text, const Point2& anchor, double size) {
  const TextKey key{pixel_of(text.line.colour), size, text.style.alignment};
  const std::size_t number = text_classes_.try_emplace(key, text_classes_.size() + 1).first->second;
  const std::string& characters = text.characters;
  const bool blanks = characters.front() == ' ' || characters.back() == ' ' ||
                      characters.find("  ") != std::string::npos;
  fmt::format_to(std::back_inserter(body_), "<text class=\"t{}{}\"{} x=\"", number, kOwn,
                 blanks ? " xml:space=\"preserve\"" : "");
  append_coordinate(body_, anchor.x);
  body_ += "\" y=\"";
  append_coordinate(body_, anchor.y);
  if (text.turn != 0.0) {
    body_ += "\" transform=\"rotate(";
    append_coordinate(body_, -text.turn);
    for (const double c : {anchor.x, anchor.y}) {
      body_ += ' ';
      append_coordinate(body_, c);
    }
    body_ += ')';
  }
  body_ += "\">";
  append_escaped(body_, characters);
  body_ += "</text>\n";
}

void SvgDevice::finish(std::ostream& out) {
  finish_lines();
  CollectedText beginning;
  write_beginning(beginning);
  const std::string before = std::move(beginning).str();
  write_with_own_names({before, body_}, options().id_prefix, out);
  out << "</svg>\n";
}

std::vector<std::string> SvgDevice::style_rules() const {
  std::vector<std::string> fills(fill_classes_.size()), lines(line_classes_.size()),
      texts(text_classes_.size());
  for (const auto& [key, number] : fill_classes_) {
    const auto [pixel, seam] = key;
    fills[number - 1] = fmt::format(".f{}{}{{fill:{}{}}}\n", number, kOwn, hex(pixel),
                                    seam ? fmt::format(";stroke:{}", hex(pixel)) : "");
  }
  for (const auto& [key, number] : line_classes_) {
    const auto [pixel, width, dash, gap, round] = key;
    lines[number - 1] =
        fmt::format(".l{}{}{{stroke:{};stroke-width:{}{}{}}}\n", number, kOwn, hex(pixel), width,
                    dash > 0.0 ? fmt::format(";stroke-dasharray:{} {}", dash, gap) : "",
                    round ? ";stroke-linecap:round" : "");
  }
  for (const auto& [key, number] : text_classes_) {
    const auto [pixel, size, alignment] = key;
    std::string& rule = texts[number - 1];
    rule = fmt::format(".t{}{}{{fill:{};font-family:{};font-size:", number, kOwn, hex(pixel),
                       css_font(options().lettering.family()));
    append_coordinate(rule, size);
    rule += fmt::format("px;text-anchor:{}}}\n", text_anchor(alignment));
  }
  std::vector<std::string> all = std::move(fills);
  for (auto* const more : {&lines, &texts}) std::ranges::move(*more, std::back_inserter(all));
  return all;
}

/// Writes everything before the body.
void SvgDevice::write_beginning(std::ostream& out) const {
  const bool solid = background().kind == Background::Kind::solid;
  if (!options().is_inline) out << kXmlDeclaration;
  out << fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\"{5} version=\"1.1\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\">\n"
      "<style>\n"
      "{2}.segment{4}{{fill:none;fill-rule:evenodd;stroke-width:{3};stroke-linejoin:round}}\n",
      width(), height(),
      solid ? fmt::format(".background{}{{fill:{}}}\n", kOwn, hex(pixel_of(background()))) : "",
      kSeamWidth, kOwn, options().layers ? kInkscapeNamespace : "");
  if (figures_ > 0) {
    out << fmt::format(
        ".figure{0}{{fill-rule:evenodd;stroke-linejoin:round;stroke-linecap:round}}\n"
        ".pieces{0},.pieces{0} .segment{0}{{stroke-width:0}}\n.whole{0}{{fill:#fff}}\n"
        // On the elements repeated by <use>: selectors there do not see classes outside of them.
        ".traps{0}{{stroke-width:{1:.0f}}}\n.sides{0} path{{fill:none}}\n",
        kOwn, std::ceil(kTrapWidth / options().precision));
  }
  for (const std::string& rule : style_rules()) out << rule;
  out << "</style>\n";
  ramps_.write(out);
  if (!solid) return;
  out << fmt::format("<rect class=\"background{}\" width=\"{}\" height=\"{}\"/>\n", kOwn, width(),
                     height());
}

void write_svg(const DisplayFile& display_file, int width, int height, const Destination& to,
               const Background& background, bool colour_rule, const VectorOptions& options) {
  SvgDevice device(width, height, background, options);
  if (colour_rule) device.fill_with_background();
  const std::unique_ptr<Output> file = output_to(to);
  device.take_titles(display_file);
  interpret(display_file, device);
  device.draw_texts(display_file);
  device.draw_annotation(display_file, kPixelsOfMillimetre);
  if (options.paper) {
    CollectedText document;
    device.finish(document);
    write_on_sheet(std::move(document).str(), fit_on_paper(*options.paper, width, height),
                   file->stream());
  } else {
    device.finish(file->stream());
  }
  file->commit();
}

}  // namespace displayfile
