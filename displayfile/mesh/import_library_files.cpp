#include "displayfile/mesh/import_library_files.h"

#include <cstdio>
#include <optional>
#include <string>

namespace displayfile {

namespace {

std::FILE* file_of(aiFile* file) { return reinterpret_cast<std::FILE*>(file->UserData); }

// The library's file access knows only these of a file; exceptions must not cross it.

extern "C" {

static size_t read_neighbour(aiFile* file, char* to, size_t size, size_t count) {
  return std::fread(to, size, count, file_of(file));
}

static size_t write_nothing(aiFile*, const char*, size_t, size_t) { return 0; }

static size_t place_in_neighbour(aiFile* file) {
  const long place = std::ftell(file_of(file));
  return place < 0 ? 0 : static_cast<size_t>(place);
}

static size_t size_of_neighbour(aiFile* file) {
  std::FILE* const f = file_of(file);
  const long place = std::ftell(f);
  if (place < 0 || std::fseek(f, 0, SEEK_END) != 0) return 0;
  const long size = std::ftell(f);
  std::fseek(f, place, SEEK_SET);
  return size < 0 ? 0 : static_cast<size_t>(size);
}

static aiReturn seek_in_neighbour(aiFile* file, size_t offset, aiOrigin origin) {
  const int from = origin == aiOrigin_SET ? SEEK_SET : origin == aiOrigin_CUR ? SEEK_CUR : SEEK_END;
  return std::fseek(file_of(file), static_cast<long>(offset), from) == 0 ? aiReturn_SUCCESS
                                                                         : aiReturn_FAILURE;
}

static void flush_nothing(aiFile*) {}

/// A neighbour's path as the library requests it, or the path that an alias stands for; nothing if
/// it may not be opened.
static std::optional<std::string> path_of_neighbour(const OpenFiles& files,
                                                    const std::string& path) {
  for (const auto& [written, meant] : files.meant_names) {
    if (!path.ends_with(written)) continue;
    const std::string folder = path.substr(0, path.size() - written.size());
    if (!folder.empty() && folder.back() != '/' && folder.back() != '\\') continue;
    if (files.neighbours.allows(folder + meant)) return folder + meant;
  }
  if (!files.neighbours.allows(path)) return std::nullopt;
  return path;
}

static aiFile* open_neighbour(aiFileIO* io, const char* path, const char* mode) {
  const auto& files = *reinterpret_cast<const OpenFiles*>(io->UserData);
  try {
    if (mode == nullptr || mode[0] != 'r') return nullptr;
    const auto allowed = path_of_neighbour(files, path);
    if (!allowed) return nullptr;
    std::FILE* const opened = std::fopen(allowed->c_str(), "rb");
    if (opened == nullptr) return nullptr;
    return new aiFile{read_neighbour,
                      write_nothing,
                      place_in_neighbour,
                      size_of_neighbour,
                      seek_in_neighbour,
                      flush_nothing,
                      reinterpret_cast<aiUserData>(opened)};
  } catch (...) {
    return nullptr;
  }
}

static void close_neighbour(aiFileIO*, aiFile* file) {
  if (file == nullptr) return;
  std::fclose(file_of(file));
  delete file;
}

}  // extern "C"

}  // namespace

aiFileIO files_among(const OpenFiles& files) {
  // The library's own type for it is not const.
  auto* const data = reinterpret_cast<aiUserData>(const_cast<OpenFiles*>(&files));
  return {open_neighbour, close_neighbour, data};
}

}  // namespace displayfile
