#include "displayfile/text/routine.h"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace displayfile {

void wrong_count(const ProgramLine& line, const Routine& routine) {
  const std::size_t count = line.arguments();
  std::string message =
      fmt::format("{}: {} argument{}, expected ", routine.name, count, count == 1 ? "" : "s");
  if (routine.arguments == 0) {
    message += "none";
  } else if (routine.arguments == UserRoutine::kVaries) {
    message += routine.expected;
  } else {
    message += fmt::format("{}: {}", routine.arguments, routine.expected);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (const std::string_view hint = hint_at(line.argument(i)); !hint.empty()) {
      message += hint;
      break;
    }
  }
  const bool too_many =
      routine.arguments != UserRoutine::kVaries && std::cmp_greater(count, routine.arguments);
  if (too_many) {
    throw ErrorAt(line.argument(static_cast<std::size_t>(routine.arguments)).data(), message);
  }
  const std::string_view last = count == 0 ? line.name() : line.argument(count - 1);
  throw ErrorAt(last.data() + last.size(), message);
}

}  // namespace displayfile
