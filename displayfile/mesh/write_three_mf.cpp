// 3MF: 3MF Consortium, "3D Manufacturing Format, Core Specification & Reference Guide", 1.3.

#include <fmt/format.h>
#include <minizip/zip.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/shared_library.h"
#include "displayfile/mesh/write_mesh.h"
#include "displayfile/text/output_file.h"

namespace displayfile {

namespace {

struct ZipWriter {
  SharedLibrary library{"libminizip.so.1"};
  DISPLAYFILE_LIBRARY_FUNCTION(library, zip, Open64);
  DISPLAYFILE_LIBRARY_FUNCTION(library, zip, OpenNewFileInZip64);
  DISPLAYFILE_LIBRARY_FUNCTION(library, zip, WriteInFileInZip);
  DISPLAYFILE_LIBRARY_FUNCTION(library, zip, CloseFileInZip);
  DISPLAYFILE_LIBRARY_FUNCTION(library, zip, Close);
};

const ZipWriter& zip_writer() {
  static const ZipWriter library;
  return library;
}

/// A ZIP archive. All parts have the same date, so that equal contents give equal files.
class ZipFile {
 public:
  ZipFile(const std::string& path, const std::string& name)
      : name_(name), zip_(zip_writer()), file_(zip_.Open64(path.c_str(), APPEND_STATUS_CREATE)) {
    require(file_ != nullptr);
  }
  ZipFile(const ZipFile&) = delete;
  ZipFile& operator=(const ZipFile&) = delete;
  ~ZipFile() {
    if (file_ != nullptr) zip_.Close(file_, nullptr);
  }

  void add(const char* part, std::string_view content) {
    constexpr uLong kDate = 0x210000;  // the first day of 1980, the earliest there is
    constexpr std::size_t kAtATime = std::size_t{1} << 30;
    zip_fileinfo info{};
    info.dosDate = kDate;
    require(zip_.OpenNewFileInZip64(file_, part, &info, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED,
                                    Z_DEFAULT_COMPRESSION, 1) == ZIP_OK);
    for (; !content.empty(); content.remove_prefix(std::min(content.size(), kAtATime))) {
      const auto bytes = static_cast<unsigned>(std::min(content.size(), kAtATime));
      require(zip_.WriteInFileInZip(file_, content.data(), bytes) == ZIP_OK);
    }
    require(zip_.CloseFileInZip(file_) == ZIP_OK);
  }

  void finish() {
    const zipFile file = std::exchange(file_, nullptr);
    require(zip_.Close(file, nullptr) == ZIP_OK);
  }

 private:
  void require(bool done) const {
    if (!done) throw Error(name_ + ": not all could be written");
  }

  std::string name_;
  const ZipWriter& zip_;
  zipFile file_;
};

std::string escaped_attribute(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out.push_back(static_cast<unsigned char>(c) < ' ' ? ' ' : c);
    }
  }
  return out;
}

constexpr int kMaterials = 1;  // the identifier of the colours; objects follow

void append_materials(const SolidTriangles& solid, std::string& out) {
  if (solid.colours.empty()) return;
  fmt::format_to(std::back_inserter(out), "<basematerials id=\"{}\">\n", kMaterials);
  for (const Colour& c : solid.colours) {
    fmt::format_to(
        std::back_inserter(out),
        "<base name=\"#{0:02X}{1:02X}{2:02X}\" displaycolor=\"#{0:02X}{1:02X}{2:02X}\"/>\n",
        part_of_255(c.r), part_of_255(c.g), part_of_255(c.b));
  }
  out += "</basematerials>\n";
}

/// An object has the colour of its first triangle; triangles of other colours have their own.
void append_object(const SolidTriangles::Object& object, std::size_t id, std::string& out) {
  const auto to = std::back_inserter(out);
  const std::uint32_t colour = object.colours.front();
  fmt::format_to(to, "<object id=\"{}\" type=\"model\" name=\"{}\"", id,
                 escaped_attribute(object.name));
  if (colour != SolidTriangles::kNoColour) {
    fmt::format_to(to, " pid=\"{}\" pindex=\"{}\"", kMaterials, colour);
  }
  out += "><mesh>\n<vertices>\n";
  for (const Point3& p : object.vertices) {
    fmt::format_to(to, "<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", p.x, p.y, p.z);
  }
  out += "</vertices>\n<triangles>\n";
  for (std::size_t i = 0; i < object.triangles.size(); ++i) {
    const auto& [a, b, c] = object.triangles[i];
    fmt::format_to(to, "<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"", a, b, c);
    if (object.colours[i] != colour && object.colours[i] != SolidTriangles::kNoColour) {
      fmt::format_to(to, " pid=\"{}\" p1=\"{}\"", kMaterials, object.colours[i]);
    }
    out += "/>\n";
  }
  out += "</triangles>\n</mesh></object>\n";
}

std::string model_of(const SolidTriangles& solid) {
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<model unit=\"millimeter\" xml:lang=\"en-US\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n<resources>\n";
  append_materials(solid, out);
  constexpr std::size_t kFirstObject = kMaterials + 1;
  for (std::size_t k = 0; k < solid.objects.size(); ++k) {
    append_object(solid.objects[k], kFirstObject + k, out);
  }
  out += "</resources>\n<build>\n";
  for (std::size_t k = 0; k < solid.objects.size(); ++k) {
    out += fmt::format("<item objectid=\"{}\"/>\n", kFirstObject + k);
  }
  return out + "</build>\n</model>\n";
}

}  // namespace

void require_3mf(const std::string& file) {
  try {
    zip_writer();
  } catch (const Error& e) {
    throw Error(
        fmt::format("{}: 3MF is written by minizip, which cannot be loaded: {}; expected Debian's "
                    "package libminizip1 to be installed, or another format",
                    file, e.what()));
  }
}

void write_3mf(const SolidTriangles& solid, const std::string& file) {
  require_3mf(file);
  OutputFile output(file);
  ZipFile zip(output.temporary_path(), file);
  zip.add("[Content_Types].xml",
          "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
          "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
          "<Default Extension=\"rels\" "
          "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
          "<Default Extension=\"model\" "
          "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n</Types>\n");
  zip.add("_rels/.rels",
          "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
          "<Relationships "
          "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n"
          "<Relationship Target=\"/3D/3dmodel.model\" Id=\"model\" "
          "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>\n"
          "</Relationships>\n");
  zip.add("3D/3dmodel.model", model_of(solid));
  zip.finish();
  output.commit();
}

}  // namespace displayfile
