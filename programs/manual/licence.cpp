#include "programs/manual/licence.h"

#include <string_view>

namespace displayfile {

std::string licence_text() {
  constexpr std::string_view kModules = DISPLAYFILE_MODULE_LICENCES;
  std::string text = "MIT";
  if (!kModules.empty()) text.append("; modules: ").append(kModules);
  return text;
}

}  // namespace displayfile
