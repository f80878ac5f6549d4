#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "clip/base/memory.h"
#include "clip/base/round_to_nearest.h"
#include "clip/base/work_budget.h"
#include "displayfile/mesh/cad_format.h"
#include "displayfile/mesh/cad_import.h"
#include "displayfile/mesh/compressed_data.h"
#include "displayfile/mesh/format_not_read.h"
#include "displayfile/mesh/import_process.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/mesh/mesh_file.h"
#include "displayfile/mesh/up_axis.h"
#include "displayfile/text/characters.h"

namespace displayfile {

namespace {

struct Format {
  std::string_view extension;
  std::string_view beginning;  ///< of every such file; empty if none is known
  Mesh (*read)(const MeshFile&);
};

constexpr Format kFormats[] = {
    {".ply", "ply", read_ply},
    {".obj", "", read_obj},
    {".off", "OFF", read_off},
    {".stl", "", read_stl},
};

/// The built-in format of a file, by its beginning, or otherwise by its name.
const Format* format_of(const std::string& path, std::string_view beginning) {
  const std::string extension = extension_of(path);
  for (const Format& format : kFormats) {
    if (!format.beginning.empty() && beginning.starts_with(format.beginning)) return &format;
  }
  const auto* named = std::ranges::find(kFormats, extension, &Format::extension);
  return named == std::end(kFormats) ? nullptr : named;
}

/// Reads a file from its beginning in several steps.
class InputFile {
 public:
  explicit InputFile(const std::string& path) : path_(path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
      throw Error(fmt::format("{}: no such file: expected a mesh", path));
    }
    if (!std::filesystem::is_regular_file(status)) {
      throw Error(fmt::format("{}: not a regular file: expected a mesh", path));
    }
    constexpr std::uintmax_t kMost = std::numeric_limits<std::size_t>::max();
    size_ = static_cast<std::size_t>(std::min(std::filesystem::file_size(path, error), kMost));
    errno = 0;
    in_.open(path, std::ios::binary);
    if (!in_) throw Error(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
    if (error) fail();
    if (size_ == 0) throw Error(fmt::format("{}: empty file: expected a mesh", path));
  }

  std::size_t size() const { return size_; }

  /// Reads until `data` holds `bytes` bytes.
  void read_to(std::string& data, std::size_t bytes) {
    const std::size_t had = data.size();
    data.resize(bytes);
    if (!in_.read(data.data() + had, static_cast<std::streamsize>(bytes - had))) fail();
  }

 private:
  [[noreturn]] void fail() const { throw Error(fmt::format("{}: cannot read the file", path_)); }

  const std::string& path_;
  std::ifstream in_;
  std::size_t size_ = 0;
};

/// Reads a file of a CAD program. No such format defines which axis is up.
Mesh read_cad(const std::string& path, CadFormat format, bool with_normals,
              const ImportLimits& limits) {
  Mesh mesh = read_by_cad_process(path, with_normals, limits);
  set_upright_of_format(mesh, format == CadFormat::step ? ".step" : ".iges", "");
  return mesh;
}

/// Some of the import library's readers may read UTF-16 text; no built-in reader does. The message
/// of one that does not is replaced, since it would refer to bytes that the author of the text
/// never saw.
Mesh read_utf16(const std::string& path, bool with_normals, const ImportLimits& limits,
                const Format* format) {
  try {
    if (format == nullptr) return read_by_import_process(path, with_normals, limits);
  } catch (const NotRead&) {
  }
  throw Error(fmt::format("{}: not a mesh that can be read: UTF-16, expected UTF-8 text", path));
}

/// `name` is the path without the extension of a compressed file.
void require_format_that_is_read(const std::string& path, const std::string& name) {
  if (const auto format = format_not_read(name)) {
    throw Error(fmt::format("{}: {}, which is not read: export it as STL, OBJ, PLY or glTF", path,
                            *format));
  }
}

/// The import library reads files, not memory.
[[noreturn]] void fail_compressed(const std::string& path) {
  throw Error(fmt::format(
      "{}: compressed, which is read of OBJ, OFF, PLY and STL only, by names such as part.stl.gz: "
      "decompress it first",
      path));
}

Mesh read_any(const std::string& path, bool with_normals, const ImportLimits& limits) {
  constexpr std::size_t kBeginning = 4;
  InputFile in(path);
  MeshFile file{path, {}, with_normals};
  in.read_to(file.data, std::min(in.size(), kBeginning));
  const bool is_compressed = begins_compressed(file.data);
  if (is_compressed) {
    in.read_to(file.data, in.size());
    file.data = uncompressed(path, file.data);
  }
  const std::string name = name_uncompressed(path).string();
  const Format* format = format_of(name, file.data);
  if (format == nullptr) {
    require_format_that_is_read(path, name);
    if (is_compressed) fail_compressed(path);
    if (const auto cad = cad_format(path)) return read_cad(path, *cad, with_normals, limits);
  }
  if (begins_in_utf16(file.data)) return read_utf16(path, with_normals, limits, format);
  const std::string extension =
      format != nullptr ? std::string(format->extension) : extension_of(path);
  if (!is_compressed && (format != nullptr || text_says_upright(extension))) {
    in.read_to(file.data, in.size());
  }
  Mesh mesh =
      format != nullptr ? format->read(file) : read_by_import_process(path, with_normals, limits);
  set_upright_of_format(mesh, extension, file.data);
  const bool is_known = mesh.upright || mesh.usual_upright;
  if (format == nullptr && !is_known) mesh.upright = upright("y");  // as the library gives them
  if (limits.deflection > 0.0) {
    mesh.skipped.warnings.emplace_back(
        "--deflection has no effect: it has polygons, no curved surfaces");
  }
  return mesh;
}

/// True for no name, and for names that programs give to every solid.
bool is_generic(std::string_view name) {
  constexpr std::array<std::string_view, 13> kGeneric{
      "",       "ascii",  "ASCII",          "default", "Default", "mesh",   "Mesh",
      "object", "Object", "OpenSCAD_Model", "model",   "Model",   "unnamed"};
  return name.starts_with("Exported from ") || name.starts_with("Created by ") ||
         std::ranges::find(kGeneric, name) != kGeneric.end();
}

/// Gives objects without a name of their own that of the file, without folder and extension; after
/// the first with a number.
void name_after_file(Mesh& mesh, const std::string& path) {
  const bool names_solids = extension_of(name_uncompressed(path).string()) == ".stl";
  const std::string stem = drawable(name_uncompressed(path).stem().string());
  std::size_t number = 0;
  for (Mesh::Object& object : mesh.objects) {
    if (names_solids ? !is_generic(object.name) : !object.name.empty()) continue;
    object.name = ++number == 1 ? stem : fmt::format("{} {}", stem, number);
  }
}

}  // namespace

std::vector<std::string> extensions_read_here() {
  std::vector<std::string> extensions;
  for (const Format& format : kFormats) extensions.emplace_back(format.extension);
  return extensions;
}

Mesh read_mesh(const std::string& path, bool with_normals, const ImportLimits& limits) {
  const RoundToNearest nearest;
  try {
    Mesh mesh = read_any(path, with_normals, limits);
    name_after_file(mesh, path);
    return mesh;
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw LimitReached(fmt::format("{}: {}", path, out_of_memory_message()));
  } catch (const std::exception& e) {
    throw Error(fmt::format("{}: not a mesh that can be read: {}", path, e.what()));
  }
}

}  // namespace displayfile
