#include "programs/inputs/program_place.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

#include "clip/base/files.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/text/program_line.h"
#include "programs/inputs/inputs.h"
#include "programs/inputs/segment_names.h"

namespace displayfile {

namespace {

/// Where an instruction of a segment comes from.
struct Source {
  enum class Kind { segment, end, polygon, line, unknown };
  Kind kind = Kind::unknown;
  std::size_t ordinal = 0;        ///< of the primitive, among those of its kind in the segment
  std::int64_t pick = -1;         ///< in force
  std::string_view routine = {};  ///< the routine that sets the attribute, if any
};

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kAttributes{{
    {"fill", "set-fill-style"},
    {"line-style", "set-line-style"},
    {"pick", "set-pick-id"},
    {"text-style", "set-text-style"},
    {"light", "set-light"},
    {"shadow", "set-shadows"},
}};

std::string_view first_word(std::string_view line) { return line.substr(0, line.find(' ')); }

std::int64_t number_after(std::string_view line) {
  std::int64_t number = -1;
  const std::string_view digits = line.substr(std::min(line.find(' ') + 1, line.size()));
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

/// Walks the lines of a segment's dump up to an instruction, and for an attribute on to the
/// primitive that it is entered before.
class SegmentDump {
 public:
  Source source_of(std::string_view lines, std::size_t instruction) {
    while (!lines.empty()) {
      const std::string_view line = lines.substr(0, lines.find('\n'));
      lines.remove_prefix(std::min(line.size() + 1, lines.size()));
      const std::string_view word = first_word(line);
      if (word == "segment" || word == "end") break;
      ++at_;
      const bool is_past = at_ >= instruction;
      if (at_ == instruction) note_attribute(word);
      if (is_of_primitive(word, line) && is_past) return source_;
      if (is_past && (word == "text" || word == "annotation")) return {};
    }
    return {.kind = Source::Kind::end};
  }

 private:
  void note_attribute(std::string_view word) {
    const auto* const attribute =
        std::ranges::find(kAttributes, word, &std::pair<std::string_view, std::string_view>::first);
    if (attribute != kAttributes.end()) source_.routine = attribute->second;
  }

  bool is_of_primitive(std::string_view word, std::string_view line) {
    if (sides_left_ > 0) {
      --sides_left_;
      return true;
    }
    if (word == "polygon") {
      sides_left_ = number_after(line);
      source_.kind = Source::Kind::polygon;
      source_.ordinal = polygons_++;
      return true;
    }
    if (word == "pick") source_.pick = number_after(line);
    if (word != "line" && word != "move") return false;
    source_.kind = Source::Kind::line;
    source_.ordinal = word == "line" ? lines_++ : lines_;
    return true;
  }

  Source source_;
  std::size_t at_ = 0, polygons_ = 0, lines_ = 0;
  std::int64_t sides_left_ = 0;
};

Source source_of(const DumpDifference& difference, std::string_view dump) {
  if (difference.instruction == 0) return {.kind = Source::Kind::segment};
  const std::string_view lines = dump.substr(difference.segment_at);
  return SegmentDump().source_of(lines.substr(lines.find('\n') + 1), difference.instruction);
}

/// Watches a replay for the line that a source denotes.
class LineFinder {
 public:
  LineFinder(const GraphicsSystem& system, const Source& source, int segment, bool is_sorted)
      : system_(system), source_(source), segment_(segment), is_sorted_(is_sorted) {}

  void after_line(std::size_t line, std::string_view routine) {
    if (routine == "rename-segment") is_known_ = false;
    if (routine == "set-pick-id" && is_sorted_) is_known_ = false;
    const auto open = system_.open_segment_name();
    if (routine == "open-segment" && open == segment_) {
      opened_ = line;
      found_.reset();
    }
    if (routine == "close-segment" && was_open_ == segment_) closed_ = line;
    was_open_ = open;
    if (!found_ && routine == source_.routine) attribute_ = line;
    if (!found_ && is_entered()) found_ = line;
  }

  std::optional<std::size_t> line() const {
    if (!is_known_) return std::nullopt;
    switch (source_.kind) {
      case Source::Kind::segment: return opened_;
      case Source::Kind::end: return closed_;
      case Source::Kind::unknown: return std::nullopt;
      case Source::Kind::polygon:
      case Source::Kind::line: break;
    }
    return found_ && attribute_ ? attribute_ : found_;
  }

 private:
  bool is_entered() const {
    const DisplayFile& file = system_.display_file();
    if (!file.contains(segment_)) return false;
    const Segment& segment = file.segment(segment_);
    if (source_.kind == Source::Kind::line) {
      return !is_sorted_ && segment.lines() > source_.ordinal;
    }
    if (source_.kind != Source::Kind::polygon) return false;
    return is_sorted_ ? source_.pick >= 0 && system_.counts().polygons > source_.pick
                      : segment.polygons() > source_.ordinal;
  }

  const GraphicsSystem& system_;
  Source source_;
  int segment_;
  bool is_sorted_, is_known_ = true;
  std::optional<int> was_open_;
  std::optional<std::size_t> opened_, closed_, attribute_, found_;
};

}  // namespace

std::optional<std::size_t> program_line_of(const DumpDifference& difference,
                                           const DumpedInputs& dumped, const MeshWords& meshes,
                                           double aspect) {
  const auto& [inputs, file, dump] = dumped;
  const auto may_be_read = [](const std::string& input) {
    return input != "-" && is_drawing_program(input);
  };
  if (difference.segment.empty() || !std::ranges::all_of(inputs, may_be_read)) return std::nullopt;
  const int segment = static_cast<int>(number_after(" " + difference.segment));
  if (!file.contains(segment)) return std::nullopt;
  const bool is_sorted = file.sorted() != nullptr || file.segment(segment).sorted() != nullptr;
  GraphicsSystem system;
  meshes.start(system, aspect);
  LineFinder finder(system, source_of(difference, dump), segment, is_sorted);
  for (const std::string& before : inputs.first(inputs.size() - 1)) {
    replay_beside(read_text_file(before), before, system);
  }
  const std::string program = read_text_file(inputs.back());
  make_room_for_names(program, system);
  replay_lines(program, inputs.back(), system, [&](std::size_t line, std::string_view routine) {
    finder.after_line(line, routine);
  });
  return finder.line();
}

}  // namespace displayfile
