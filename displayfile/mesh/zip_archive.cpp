#include "displayfile/mesh/zip_archive.h"

#include <fmt/format.h>
#include <minizip/unzip.h>

#include <array>

#include "clip/base/error.h"

namespace displayfile {

struct ZipArchive::Library {
  explicit Library(const SharedLibrary& shared) : library(shared) {}

  const SharedLibrary& library;
  DISPLAYFILE_LIBRARY_FUNCTION(library, unz, Open64);
  DISPLAYFILE_LIBRARY_FUNCTION(library, unz, LocateFile);
  DISPLAYFILE_LIBRARY_FUNCTION(library, unz, OpenCurrentFile);
  DISPLAYFILE_LIBRARY_FUNCTION(library, unz, ReadCurrentFile);
  DISPLAYFILE_LIBRARY_FUNCTION(library, unz, CloseCurrentFile);
  DISPLAYFILE_LIBRARY_FUNCTION(library, unz, Close);
};

ZipArchive::ZipArchive(const SharedLibrary& library, const std::string& path) : path_(path) {
  try {
    library_ = std::make_unique<Library>(library);
  } catch (const Error& e) {
    throw Error(fmt::format("{}: the import library (Assimp) has no minizip: {}", path, e.what()));
  }
  archive_ = library_->Open64(path.c_str());
  if (archive_ == nullptr) {
    throw Error(fmt::format("{}: not a mesh that can be read: expected a ZIP archive", path));
  }
}

ZipArchive::~ZipArchive() {
  if (archive_ != nullptr) library_->Close(archive_);
}

std::optional<std::string> ZipArchive::content(const std::string& name) const {
  constexpr int kEitherCase = 2;
  if (library_->LocateFile(archive_, name.c_str(), kEitherCase) != UNZ_OK) return std::nullopt;
  int status = library_->OpenCurrentFile(archive_);
  std::string content;
  std::array<char, 1 << 16> part;
  while (status == UNZ_OK) {
    const int bytes = library_->ReadCurrentFile(archive_, part.data(), unsigned{part.size()});
    if (bytes <= 0) {
      status = bytes == 0 ? library_->CloseCurrentFile(archive_) : bytes;  // checks the CRC
      break;
    }
    content.append(part.data(), static_cast<std::size_t>(bytes));
  }
  if (status != UNZ_OK) {
    throw Error(fmt::format("{}: not a mesh that can be read: {} in it is damaged", path_, name));
  }
  return content;
}

}  // namespace displayfile
