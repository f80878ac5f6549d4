#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace displayfile {

/// Exchange formats of CAD programs: exact curves and surfaces, not facets.
enum class CadFormat { step, iges };

/// "STEP" or "IGES".
std::string_view name_of(CadFormat format);

/// The format of a file, by its extension or otherwise by its beginning; nothing for any other
/// file. A building (IFC) has the notation of STEP, but is none.
std::optional<CadFormat> cad_format(const std::string& path);

/// The extensions of both formats, with their dots.
std::vector<std::string> cad_extensions();

}  // namespace displayfile
