#include "displayfile/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "clip/base/files.h"
#include "clip/base/round_to_nearest.h"
#include "clip/base/work_budget.h"
#include "displayfile/text/characters.h"
#include "displayfile/text/program_line.h"

namespace displayfile {

namespace {

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// "FILE:LINE:COLUMN: message" for a place in the text.
Error error_at(std::string_view file_name, std::string_view text, const char* at,
               std::string_view message) {
  const auto before = text.substr(0, static_cast<std::size_t>(at - text.data()));
  const auto line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return Error(fmt::format("{}:{}:{}: {}", file_name, 1 + std::ranges::count(before, '\n'),
                           1 + std::ranges::count_if(before.substr(line_start),
                                                     [](char c) { return !is_continuation(c); }),
                           message));
}

/// True for printable ASCII, line ends and tabs.
bool is_plain(char c) { return (c >= ' ' && c <= '~') || c == '\n' || c == '\t' || c == '\r'; }

/// Length in bytes of the character at the text's start; 0 if a drawing program may not hold it: a
/// control character or not UTF-8.
std::size_t character_length(std::string_view text) {
  if (is_plain(text[0])) return 1;
  return static_cast<unsigned char>(text[0]) < 0x80 ? 0 : utf8_length(text);
}

constexpr std::size_t kBytesAtOnce = 64;

/// is_plain for a block, in bytes and without branches, so that it runs on vectors.
bool is_plain_block(const char* block) {
  std::uint8_t other = 0;
  for (std::size_t i = 0; i < kBytesAtOnce; ++i) {
    const auto c = static_cast<std::int8_t>(block[i]);  // above 0x7F: negative
    const bool other_control = (c < ' ') & (c != '\n') & (c != '\t') & (c != '\r');
    other |= static_cast<std::uint8_t>(other_control | (c > '~'));
  }
  return other == 0;
}

/// Throws Error if the text is binary.
void require_text(std::string_view text, std::string_view file_name) {
  if (begins_in_utf16(text)) {
    throw error_at(file_name, text, text.data(),
                   "not a drawing program: UTF-16, expected UTF-8 text");
  }
  for (std::size_t i = 0; i < text.size();) {
    if (text.size() - i >= kBytesAtOnce && is_plain_block(&text[i])) {
      i += kBytesAtOnce;
      continue;
    }
    const std::size_t block_end = std::min(i + kBytesAtOnce, text.size());
    while (i < block_end) {
      const std::size_t length = character_length(text.substr(i));
      if (length == 0) {
        throw error_at(file_name, text, &text[i],
                       fmt::format("not a drawing program: byte {:#04x}, expected UTF-8 text",
                                   static_cast<unsigned char>(text[i])));
      }
      i += length;
    }
  }
}

}  // namespace

void replay(std::string_view text, std::string_view file_name, GraphicsSystem& system) {
  replay_lines(text, file_name, system, nullptr);
}

void replay_lines(std::string_view text, std::string_view file_name, GraphicsSystem& system,
                  const AfterLine& after_line) {
  const RoundToNearest nearest;
  text = without_byte_order_mark(text);
  require_text(text, file_name);
  const std::optional<int> open_before = system.open_segment_name();
  const std::size_t saved_before = system.counts().transformations_saved;
  const std::size_t solids_before = system.counts().solids_open;
  ProgramLine line;
  WorkSteps lines;
  std::size_t number = 0;
  for (std::string_view rest = text; !rest.empty();) {
    ++number;
    const std::size_t length = std::min(rest.find('\n'), rest.size());
    line.split(rest.substr(0, length));
    rest.remove_prefix(std::min(length + 1, rest.size()));
    if (line.empty()) continue;
    try {
      lines.step();
      call_routine(line, system);
      if (after_line) after_line(number, line.name());
    } catch (const ErrorAt& error) {
      throw error_at(file_name, text, error.at, error.what());
    } catch (const LimitReached& reached) {
      const Error there = error_at(file_name, text, line.name().data(), reached.what());
      throw LimitReached(there.what());
    } catch (const Error& error) {
      throw error_at(file_name, text, line.name().data(), error.what());
    }
  }
  const auto at_end = [&](const std::string& message) {
    const std::size_t last = text.find_last_not_of(" \t\r\n") + 1;
    return error_at(file_name, text, text.data() + last, message);
  };
  if (const std::size_t solids = system.counts().solids_open; solids > solids_before) {
    throw at_end(fmt::format("{} solid{} still open at the end: expected end-solid",
                             solids - solids_before, solids - solids_before == 1 ? "" : "s"));
  }
  if (const auto open = system.open_segment_name(); open && open != open_before) {
    throw at_end(fmt::format("segment {} still open at the end: expected close-segment", *open));
  }
  if (const std::size_t saved = system.counts().transformations_saved; saved > saved_before) {
    throw at_end(
        fmt::format("{} transformation{} still saved at the end: expected restore-transformation-3",
                    saved - saved_before, saved - saved_before == 1 ? "" : "s"));
  }
}

void replay_file(const std::string& path, GraphicsSystem& system) {
  replay(read_text_file(path), input_name(path), system);
}

}  // namespace displayfile
