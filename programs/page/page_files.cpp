#include "programs/page/page_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <system_error>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "clip/system/own_files.h"

namespace displayfile {

namespace {

std::filesystem::path own_folder() {
  std::error_code failed;
  const auto program = file_of_program(failed);
  return failed ? std::filesystem::path() : program.parent_path();
}

}  // namespace

PageFiles::PageFiles(const std::filesystem::path& package) {
  const std::filesystem::path own = own_folder();
  folders_ = {own / "page", (own / DISPLAYFILE_DATA_FOLDER / "page").lexically_normal()};
  if (!package.empty()) {
    folders_.push_back(package);
    return;
  }
  folders_.push_back((own / DISPLAYFILE_DATA_FOLDER / "web").lexically_normal());
  folders_.push_back((own / "../../web/interp/web/package").lexically_normal());
}

std::string PageFiles::text(const std::string& name) const {
  std::vector<std::string> places;
  for (const auto& folder : folders_) {
    const std::filesystem::path file = folder / name;
    std::error_code failed;
    if (std::filesystem::is_regular_file(file, failed)) return read_text_file(file.string());
    places.push_back(folder.string());
  }
  throw Error(
      fmt::format("{} is not in {}: in the source folder, interp/web/make-package builds the "
                  "WebAssembly of pages, and with --prefix PREFIX installs it beside the command "
                  "in PREFIX/bin; --package FOLDER names another place",
                  name, fmt::join(places, ", nor in ")));
}

std::vector<std::filesystem::path> PageFiles::gallery() const {
  std::vector<std::filesystem::path> programs;
  for (const auto& folder : {own_folder() / "gallery", own_folder() / DISPLAYFILE_GALLERY_FOLDER}) {
    std::error_code failed;
    for (const auto& entry : std::filesystem::directory_iterator(folder, failed)) {
      if (entry.path().extension() == ".draw") programs.push_back(entry.path());
    }
    if (!programs.empty()) break;
  }
  std::ranges::sort(programs);
  return programs;
}

}  // namespace displayfile
