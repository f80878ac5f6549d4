#include "displayfile/text/dump_compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "displayfile/files.h"
#include "displayfile/text/output_file.h"

namespace displayfile {

namespace {

constexpr std::string_view kFirstLine = "displayfile-dump 1\n";
constexpr std::string_view kLastLine = "\nend\n";

std::string_view take_line(std::string_view& rest) {
  const std::size_t length = std::min(rest.find('\n'), rest.size());
  const std::string_view line = rest.substr(0, length);
  rest.remove_prefix(std::min(length + 1, rest.size()));
  return line;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (;;) {
    const bool is_text = line.starts_with('"');  // the last word
    const std::size_t length = is_text ? line.size() : std::min(line.find(' '), line.size());
    words.push_back(line.substr(0, length));
    if (length == line.size()) return words;
    line.remove_prefix(length + 1);
  }
}

bool starts_segment(std::string_view line) { return line.starts_with("segment "); }
bool ends_segment(std::string_view line) { return line == "end" || starts_segment(line); }
std::string_view segment_name(std::string_view line) { return words_of(line)[1]; }

/// The names of an instruction's words in messages.
struct InstructionFields {
  std::string_view start;  ///< of the instructions meant
  std::span<const std::string_view> fields;
};
constexpr std::string_view kPoint[] = {"x", "y", "z"};
constexpr std::string_view kNormal[] = {"normal x", "normal y", "normal z"};
constexpr std::string_view kPolygon[] = {"number of sides", "x", "y", "z"};
constexpr std::string_view kText[] = {"x", "y", "z", "text"};
constexpr std::string_view kTextStyle[] = {"size", "alignment"};
constexpr std::string_view kPick[] = {"pick identifier"};
constexpr std::string_view kStyle[] = {"kind", "red", "green", "blue", "line width", "dash", "gap"};
constexpr std::string_view kShadow[] = {"red",     "green",   "blue",   "light x",
                                        "light y", "light z", "light w"};
constexpr std::string_view kLight[] = {"light x", "light y", "light z", "ambient light"};
constexpr std::string_view kAnnotationWords[] = {"kind", "size",  "unit", "end",      "placement",
                                                 "red",  "green", "blue", "right by", "up by"};
constexpr InstructionFields kInstructions[] = {
    {"line ", kPoint},
    {"move ", kPoint},
    {"polygon ", kPolygon},
    {"pick ", kPick},
    {"fill ", kStyle},
    {"line-style ", kStyle},
    {"shadow ", kShadow},
    {"text ", kText},
    {"text-style ", kTextStyle},
    {"light ", kLight},
    {"annotation ", kAnnotationWords},
};

std::string_view field_name(std::string_view instruction, std::size_t field) {
  for (const auto& [start, fields] : kInstructions) {
    if (instruction.starts_with(start) && field < fields.size()) return fields[field];
  }
  if (instruction.starts_with("intensities ")) return "intensity";
  if (instruction.starts_with("normals ")) return kNormal[field % std::size(kNormal)];
  return "operand";
}

/// The difference between two instructions.
std::string instruction_difference(std::string_view place, std::string_view actual,
                                   std::string_view expected) {
  const auto a = words_of(actual), e = words_of(expected);
  if (a[0] == e[0] && a.size() == e.size()) {
    const std::size_t word = static_cast<std::size_t>(std::ranges::mismatch(a, e).in1 - a.begin());
    return fmt::format("{} ({}): {} is {}, expected {}", place, actual,
                       field_name(actual, word - 1), a[word], e[word]);
  }
  return fmt::format("{} is {}, expected {}", place, actual, expected);
}

bool has_segment(std::string_view rest, std::string_view name) {
  return rest.find(fmt::format("\nsegment {} ", name)) != std::string_view::npos;
}

/// The difference between two lines, one or both of which start or end a segment; the rests are the
/// dumps from there.
std::string segment_difference(std::string_view actual, std::string_view expected,
                               std::string_view actual_rest, std::string_view expected_rest) {
  if (!starts_segment(actual)) return fmt::format("segment {} is missing", segment_name(expected));
  const std::string_view name = segment_name(actual);
  if (!starts_segment(expected)) return fmt::format("segment {} is not expected", name);
  const std::string_view expected_name = segment_name(expected);
  if (name == expected_name) {
    return fmt::format("segment {} is {}, expected {}", name, words_of(actual).back(),
                       words_of(expected).back());
  }
  const bool comes_later = has_segment(actual_rest, expected_name);
  const bool expected_later = has_segment(expected_rest, name);
  if (expected_later && !comes_later) return fmt::format("segment {} is missing", expected_name);
  if (comes_later && !expected_later) return fmt::format("segment {} is not expected", name);
  return fmt::format("segment {} in the place of segment {}", name, expected_name);
}

DumpDifference whole_segment(std::string_view actual, std::size_t at, const std::string& text) {
  if (!starts_segment(actual) || text.ends_with("is missing")) return {text};
  return {text, std::string(segment_name(actual)), at};
}

std::optional<DumpDifference> first_difference_of_dumps(std::string_view actual,
                                                        std::string_view expected) {
  const char* const begin = actual.data();
  std::string_view segment;
  std::size_t segment_at = 0;
  std::size_t instruction = 0;  // the last one that was the same
  while (!actual.empty() || !expected.empty()) {
    const std::string_view actual_from = actual, expected_from = expected;
    const std::string_view a = take_line(actual), e = take_line(expected);
    const auto at = static_cast<std::size_t>(actual_from.data() - begin);
    if (a == e) {
      ++instruction;
      if (starts_segment(a)) {
        segment = segment_name(a);
        segment_at = at;
        instruction = 0;
      }
      continue;
    }
    if (ends_segment(a) && ends_segment(e)) {
      return whole_segment(a, at, segment_difference(a, e, actual_from, expected_from));
    }
    const std::string place = fmt::format("segment {}, instruction {}", segment, instruction + 1);
    const auto there = [&](const std::string& text) {
      return DumpDifference{text, std::string(segment), segment_at, instruction + 1};
    };
    if (ends_segment(a)) return there(fmt::format("{} is missing, expected {}", place, e));
    if (ends_segment(e)) {
      return there(
          fmt::format("{} ({}) is not expected: expected {} instructions", place, a, instruction));
    }
    return there(instruction_difference(place, a, e));
  }
  return std::nullopt;
}

}  // namespace

void require_dump(std::string_view text, std::string_view name) {
  if (!text.starts_with(kFirstLine)) {
    throw Error(fmt::format(
        "{}:1:1: not a display-file dump: expected 'displayfile-dump 1' in the first line", name));
  }
  if (!text.ends_with(kLastLine)) {
    throw Error(fmt::format("{}:{}:1: the dump is cut short: expected 'end' in the last line", name,
                            std::ranges::count(text, '\n') + 1));
  }
}

std::optional<DumpDifference> find_difference(std::string_view actual, std::string_view expected,
                                              std::string_view actual_name,
                                              std::string_view expected_name) {
  require_dump(actual, actual_name);
  require_dump(expected, expected_name);
  return first_difference_of_dumps(actual, expected);
}

std::optional<std::string> first_difference(std::string_view actual, std::string_view expected,
                                            std::string_view actual_name,
                                            std::string_view expected_name) {
  const auto difference = find_difference(actual, expected, actual_name, expected_name);
  if (!difference) return std::nullopt;
  return difference->text;
}

void update_golden(const DisplayFile& display_file, const std::string& golden_file,
                   const std::optional<Colour>& fills) {
  OutputFile file(golden_file);
  dump(display_file, file.stream(), fills);
  file.commit();
}

}  // namespace displayfile
