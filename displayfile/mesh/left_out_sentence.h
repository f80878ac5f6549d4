#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace displayfile {

/// A warning about skipped contents: "left out: the skins of 2 objects". The singular and the
/// plural each have a {} for the count.
inline std::string left_out_sentence(std::size_t count, std::string_view one,
                                     std::string_view many) {
  return "left out: " + fmt::format(fmt::runtime(count == 1 ? one : many), count);
}

}  // namespace displayfile
