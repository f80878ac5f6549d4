#include "displayfile/files.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <optional>
#include <ostream>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "clip/base/collected_text.h"
#include "clip/base/round_to_nearest.h"
#include "displayfile/entered/styled_sides.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/text/characters.h"

namespace displayfile {

namespace {

/// Writes one line per instruction; collects them in a buffer, as streams are slow.
class Dumper {
 public:
  Dumper(std::ostream& out, const std::optional<Colour>& fills) : out_(out), fills_(fills) {}

  template <class... Value>
  void write_line(const Value&... values) {
    fmt::format_to(fmt::appender(buffer_), values...);
    buffer_.push_back('\n');
    if (buffer_.size() > kFlushAt) flush();
  }
  void flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
  }

  bool has_met(int segment) const { return met_.contains(segment); }

  void fill(const FillStyle& style) {
    const bool solid = style.kind == FillStyle::Kind::solid;
    const bool same = fills_ && solid && fills_written_;
    fills_written_ = fills_ && solid;
    if (!solid) return write_line(FMT_COMPILE("fill hollow"));
    if (same) return;
    if (fills_)
      return write_line(FMT_COMPILE("fill solid {} {} {}"), fills_->r, fills_->g, fills_->b);
    const Colour& c = style.colour;
    write_line(FMT_COMPILE("fill solid {} {} {}"), c.r, c.g, c.b);
    if (style.shadow) shadow(*style.shadow);
  }
  void shadow(const FillShadow& shadow) {
    const auto& [c, light] = shadow;
    write_line(FMT_COMPILE("shadow {} {} {} {} {} {} {}"), c.r, c.g, c.b, light.x, light.y, light.z,
               light.w);
  }
  void line_style(const LineStyle& style) {
    line_ = style;
    line_is_written_ = true;
    write_style(style);
  }
  void write_style(const LineStyle& style) {
    const Colour& c = style.colour;
    switch (style.kind) {
      case LineStyle::Kind::none: return write_line(FMT_COMPILE("line-style none"));
      case LineStyle::Kind::solid:
        return write_line(FMT_COMPILE("line-style solid {} {} {} {}"), c.r, c.g, c.b, style.width);
      case LineStyle::Kind::dashed:
        return write_line(FMT_COMPILE("line-style dashed {} {} {} {} {} {}"), c.r, c.g, c.b,
                          style.width, style.dash, style.gap);
    }
  }
  void text_style(const TextStyle& style) {
    write_line(FMT_COMPILE("text-style {} {}{}"), style.size, name_of(style.alignment),
               style.always ? " always" : "");
  }
  void text(const Point3& p, std::string_view characters) {
    check_line_style();
    write_line(FMT_COMPILE("text {} {} {} {}"), p.x, p.y, p.z, in_quotation_marks(characters));
  }
  /// Writes an annotation: its kind and style, its points and texts.
  void annotation(const KeptAnnotation& a) {
    const AnnotationStyle& s = a.style;
    components_.clear();
    for (const Point3& p : a.points) components_.insert(components_.end(), {p.x, p.y, p.z});
    write_line(FMT_COMPILE("annotation {} {} {} {} {} {} {} {} {} {}{}{} {}{}{}"), name_of(a.kind),
               s.size, name_of(s.unit), name_of(s.ends), name_of(s.placement), a.colour.r,
               a.colour.g, a.colour.b, a.offset.x, a.offset.y, components_.empty() ? "" : " ",
               fmt::join(components_, " "), in_quotation_marks(a.characters),
               a.name.empty() ? "" : " ", a.name.empty() ? "" : in_quotation_marks(a.name));
  }
  void segment(int name, bool visible = true) {
    met_.insert(name);
    fills_written_ = false;
    light_.reset();
    write_line(FMT_COMPILE("segment {} {}"), name, visible ? "visible" : "invisible");
  }
  void pick(int id) { write_line(FMT_COMPILE("pick {}"), id); }
  void move(const Point3& p) { write_line(FMT_COMPILE("move {} {} {}"), p.x, p.y, p.z); }
  void line(const Point3& p) {
    check_line_style();
    write_line(FMT_COMPILE("line {} {} {}"), p.x, p.y, p.z);
  }
  void side_kinds(std::span<const LineKinds> kinds) { kinds_ = kinds; }
  void intensities(std::span<const double> values) {
    if (!fills_) write_line(FMT_COMPILE("intensities {}"), fmt::join(values, " "));
  }
  void normals(std::span<const Point3> values, const Light& light) {
    if (fills_) return;
    if (light_ != light) {
      light_ = light;
      const Point3& toward = light.toward;
      write_line(FMT_COMPILE("light {} {} {} {}"), toward.x, toward.y, toward.z, light.ambient);
    }
    components_.clear();
    for (const Point3& n : values) components_.insert(components_.end(), {n.x, n.y, n.z});
    write_line(FMT_COMPILE("normals {}"), fmt::join(components_, " "));
  }
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t> sides) {
    const auto kinds = std::exchange(kinds_, {});
    check_line_style();
    if (line_.kind == LineStyle::Kind::none || line_.of_kinds.empty()) {
      return write_polygon(vertices, sides);
    }
    own_.assign(sides.size(), op::move);
    styled_.for_each(line_, kinds, sides, [&](const LineStyle& style, const auto& of_style) {
      if (style == line_) own_.assign(of_style.begin(), of_style.end());
    });
    write_polygon(vertices, own_);
    styled_.for_each(line_, kinds, sides, [&](const LineStyle& style, const auto& of_style) {
      if (style != line_) write_sides(style, vertices, of_style);
    });
  }

 private:
  void write_polygon(std::span<const Point3> vertices, std::span<const std::int32_t> sides) {
    const Point3& start = vertices.back();
    write_line(FMT_COMPILE("polygon {} {} {} {}"), vertices.size(), start.x, start.y, start.z);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      sides[i] == op::line ? line(vertices[i]) : move(vertices[i]);
    }
  }
  /// Writes sides as lines after the polygon. The pen returns to its last vertex.
  void write_sides(const LineStyle& style, std::span<const Point3> vertices,
                   std::span<const std::int32_t> sides) {
    write_style(style);
    line_is_written_ = true;  // this one, for its lines
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (sides[i] != op::line) continue;
      move(vertices[i == 0 ? sides.size() - 1 : i - 1]);
      line(vertices[i]);
    }
    move(vertices.back());
    line_is_written_ = false;
  }
  void check_line_style() {
    if (line_is_written_) return;
    line_is_written_ = true;
    write_style(line_);
  }

  static constexpr std::size_t kFlushAt = std::size_t{1} << 16;
  std::ostream& out_;
  std::optional<Colour> fills_;         // of all that is solid
  bool fills_written_ = false;          // and in force
  std::optional<Light> light_;          // in force
  LineStyle line_;                      // in force
  bool line_is_written_ = true;         // not that of a polygon's sides
  std::span<const LineKinds> kinds_{};  // of the sides of the polygon that follows
  StyledSides styled_;
  std::vector<std::int32_t> own_;  // sides in the line style
  std::vector<double> components_;
  fmt::memory_buffer buffer_;
  std::unordered_set<int> met_;  // segments
};

/// Dumps the visible segments in their shared order, followed by those without output and the
/// invisible ones.
void dump_sorted_together(const DisplayFile& display_file, Dumper& dumper) {
  display_file.sorted()->walk(dumper);
  for (const Segment& segment : display_file.segments()) {
    if (dumper.has_met(segment.name())) continue;
    dumper.segment(segment.name(), segment.visible);
    if (!segment.visible) segment.walk_drawn(dumper);
  }
}

}  // namespace

void dump(const DisplayFile& display_file, std::ostream& out, const std::optional<Colour>& fills) {
  const RoundToNearest nearest;
  Dumper dumper(out, fills);
  dumper.write_line(FMT_COMPILE("displayfile-dump 1"));
  if (display_file.sorted() != nullptr) {
    dump_sorted_together(display_file, dumper);
  } else {
    for (const Segment& segment : display_file.segments()) {
      dumper.segment(segment.name(), segment.visible);
      segment.walk_drawn(dumper);
    }
  }
  dumper.write_line(FMT_COMPILE("end"));
  dumper.flush();
}

std::string dump(const DisplayFile& display_file, const std::optional<Colour>& fills) {
  CollectedText text;
  dump(display_file, text, fills);
  return std::move(text).str();
}

}  // namespace displayfile
