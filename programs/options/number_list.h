#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace displayfile {

/// Finite numbers with commas between them; none if the text is anything else.
std::optional<std::vector<double>> number_list(std::string_view text);

}  // namespace displayfile
