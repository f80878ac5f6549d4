#include "programs/options/empty_values.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "programs/manual/value_name.h"

namespace displayfile {

void refuse_empty_values(CLI::App& command) {
  constexpr std::array<std::string_view, 3> kMayBeEmpty{"--title", "--date", "--labels"};
  for (CLI::Option* const option : command.get_options()) {
    if (std::ranges::find(kMayBeEmpty, option->get_name()) != kMayBeEmpty.end()) continue;
    const std::string expected = value_name(*option).name;
    const auto refuse = [expected](const std::string& value) {
      return value.empty() ? "is empty: expected " + expected : "";
    };
    option->transform(CLI::Validator(refuse, ""));  // before all else that is checked
  }
}

}  // namespace displayfile
