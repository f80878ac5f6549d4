#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace displayfile {

/// Decodes a part of a URI: %20 is a blank (RFC 3986, section 2.1). Nothing if a percent sign is
/// not followed by two hexadecimal digits, or by 00, which no file name holds.
std::optional<std::string> percent_decoded(std::string_view text);

}  // namespace displayfile
