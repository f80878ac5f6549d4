#include "displayfile/mesh/cad_format.h"

#include <algorithm>
#include <cstddef>
#include <fstream>

#include "clip/base/files.h"

namespace displayfile {

namespace {

struct Extension {
  std::string_view extension;
  CadFormat format;
};

constexpr Extension kExtensions[] = {{".iges", CadFormat::iges},
                                     {".igs", CadFormat::iges},
                                     {".p21", CadFormat::step},
                                     {".step", CadFormat::step},
                                     {".stp", CadFormat::step}};

/// The beginning of the file, long enough for a usual STEP header.
std::string beginning_of(const std::string& path) {
  constexpr std::size_t kBytes = std::size_t{1} << 16;
  std::string beginning(kBytes, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(in.gcount()));
  return beginning;
}

/// ISO 10303-21: the header's FILE_SCHEMA names the schema of the data, such as IFC2X3 for a
/// building.
bool is_building(std::string_view beginning) {
  const std::size_t schema = beginning.find("FILE_SCHEMA");
  if (schema == beginning.npos) return false;
  const std::string_view names = beginning.substr(schema);
  return names.substr(0, names.find(';')).find("IFC") != names.npos;
}

/// IGES 5.3, 2.2.4.2: a line has 80 columns; the first is of the start section, S, and its number
/// is 1.
bool begins_as_iges(std::string_view beginning) {
  constexpr std::size_t kSection = 72, kColumns = 80;
  if (beginning.size() < kColumns || beginning[kSection] != 'S') return false;
  if (beginning.substr(0, kColumns).find('\n') != beginning.npos) return false;
  const std::string_view number = beginning.substr(kSection + 1, kColumns - kSection - 1);
  return number.ends_with('1') && number.find_first_not_of(" 0") == number.size() - 1;
}

}  // namespace

std::string_view name_of(CadFormat format) { return format == CadFormat::step ? "STEP" : "IGES"; }

std::optional<CadFormat> cad_format(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension == ".ifc") return std::nullopt;
  const std::string beginning = beginning_of(path);
  if (is_building(beginning)) return std::nullopt;
  const auto* const named = std::ranges::find(kExtensions, extension, &Extension::extension);
  if (named != std::end(kExtensions)) return named->format;
  if (beginning.starts_with("ISO-10303-21;")) return CadFormat::step;
  if (begins_as_iges(beginning)) return CadFormat::iges;
  return std::nullopt;
}

std::vector<std::string> cad_extensions() {
  std::vector<std::string> extensions;
  for (const Extension& known : kExtensions) extensions.emplace_back(known.extension);
  return extensions;
}

}  // namespace displayfile
