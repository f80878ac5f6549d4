
#include <algorithm>
#include <iterator>

#include "displayfile/mesh/cad_import.h"
#include "displayfile/mesh/import_library.h"
#include "displayfile/mesh/mesh_file.h"

namespace displayfile {

std::vector<std::string> mesh_extensions() {
  std::vector<std::string> extensions = extensions_read_here();
  std::ranges::move(import_library_extensions(), std::back_inserter(extensions));
  std::ranges::move(cad_extensions_read(), std::back_inserter(extensions));
  std::ranges::sort(extensions);
  extensions.erase(std::unique(extensions.begin(), extensions.end()), extensions.end());
  return extensions;
}

}  // namespace displayfile
