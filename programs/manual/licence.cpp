#include "programs/manual/licence.h"

#include <fmt/format.h>

#include <string_view>

namespace displayfile {

std::string licence_text() {
  constexpr std::string_view kBecauseOf =
      DISPLAYFILE_LICENCE_BECAUSE_OF;  // empty: the source's own
  if (kBecauseOf.empty()) return DISPLAYFILE_LICENCE;
  return fmt::format("{}, because of {}; the source is under MIT", DISPLAYFILE_LICENCE, kBecauseOf);
}

}  // namespace displayfile
