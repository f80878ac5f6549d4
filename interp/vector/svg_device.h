#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "displayfile/files.h"
#include "displayfile/segments/display_file.h"
#include "interp/device/picture.h"
#include "interp/vector/svg_ramps.h"
#include "interp/vector/vector_device.h"

namespace displayfile {

/// Draws an SVG picture (version 1.1 with CSS classes), in pixels of the requested size, on a
/// background, if any. Each segment is a group, `<g id="segment-NAME-KEY" class="segment-KEY">`;
/// one that is opened again is `segment-NAME-2-KEY`, and so on. The id of one with a title is made
/// of that: letters a-z and A-Z, digits and - as they are, _ for others; it has a `<title>`, and if
/// VectorOptions::layers is set each is a layer of Inkscape. Every style is a class: f1-KEY,
/// f2-KEY, ... of fills, l1-KEY, ... of lines, with round caps and without, t1-KEY, ... of texts.
/// Where lines were selected, each also has a class for every kind that it is: outline, boundary,
/// crease, material, intersection, all (displayfile/segments/line_kinds.md). These have no rule and
/// are the same in all files; every other name ends in the file's key (interp/vector/file_key.h),
/// or begins with VectorOptions::id_prefix, so that files in one page do not interfere. Coordinates
/// have three decimals at most. Disjoint fills are a group of class "figure-KEY", in coordinates of
/// its own: integer units of the stated precision (interp/vector/seams.md).
class SvgDevice : public VectorDevice {
 public:
  /// Throws Error unless both sides are 1 to kLargestSide.
  SvgDevice(int width, int height, const Background& background = {},
            const VectorOptions& options = {})
      : VectorDevice(width, height, background, options) {}

  /// Writes the document. It is kept in memory until then: the classes come first, but they and the
  /// file's key are known last. Must be called once.
  void finish(std::ostream& out);

 private:
  using FillKey = std::tuple<std::uint32_t, bool>;  // pixel_of the colour, with seam
  using TextKey = std::tuple<std::uint32_t, double, TextStyle::Alignment>;
  /// Width, dash, gap or 0, with round caps.
  using LineKey = std::tuple<std::uint32_t, double, double, double, bool>;

  void open_group(int segment_name) override;
  void close_group() override;
  void paint_fill(const Path& path, const FillPaint& paint, bool seam) override;
  void paint_figure(const Figure& figure) override;  // svg_figure.cpp
  void paint_lines(const Path& path, const LineStyle& style, LineKinds kinds, LineCap cap) override;
  void paint_text(const DeviceText& text, const Point2& anchor, double size) override;

  std::size_t fill_class(const FillKey& key) {
    return fill_classes_.try_emplace(key, fill_classes_.size() + 1).first->second;
  }
  std::string new_id(const std::string& name);
  void append_layer(std::string_view label);
  std::vector<std::string> style_rules() const;
  void write_beginning(std::ostream& out) const;
  void append_paint(const char* property, const FillPaint& paint, const Figure& figure);
  void append_traps(const Figure& figure);
  void append_regions(const Figure& figure);
  void append_path_data(const Path& path);

  std::string body_;  // with kOwn in its names
  std::map<FillKey, std::size_t> fill_classes_;
  SvgRamps ramps_;
  std::map<LineKey, std::size_t> line_classes_;
  std::map<TextKey, std::size_t> text_classes_;
  std::unordered_map<std::string, int> times_taken_;  // names of groups
  std::unordered_set<std::string> ids_;               // of groups
  std::size_t figures_ = 0;

  // The element written last, if it is a fill that edges of the same outline may join.
  struct {
    std::size_t class_end = 0, data = 0, data_end = 0;
  } joinable_;
  std::string data_;
};

/// Draws the visible segments, in order, into an SVG file. The file appears whole or not at all.
/// Throws Error, naming the file, if it cannot be written, or for a size outside of 1 to
/// kLargestSide. With paper, the picture is as large as fits, in millimetres.
void write_svg(const DisplayFile& display_file, int width, int height, const Destination& to,
               const Background& background = {}, bool colour_rule = false,
               const VectorOptions& options = {});

}  // namespace displayfile
