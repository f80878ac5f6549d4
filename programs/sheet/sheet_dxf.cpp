#include <fmt/format.h>

#include <exception>
#include <fstream>
#include <ios>
#include <new>
#include <string>
#include <string_view>

#include "clip/base/error.h"
#include "clip/base/module.h"
#include "displayfile/text/output_file.h"
#include "programs/sheet/drawing_sheet.h"
#include "programs/sheet/dxf_module.h"

namespace displayfile {

const bool kWritesDxf = true;

namespace {

/// dxflib does not report whether all could be written: the file's last line shows it.
void require_whole(OutputFile& output) {
  constexpr std::string_view kLast = "EOF\n";
  std::ifstream written(output.temporary_path(), std::ios::binary);
  written.seekg(-static_cast<std::streamoff>(kLast.size()), std::ios::end);
  std::string end(kLast.size(), '\0');
  written.read(end.data(), static_cast<std::streamsize>(end.size()));
  if (!written || end != kLast) throw Error(output.name() + ": not all could be written");
}

}  // namespace

void write_sheet_dxf(const DrawingSheet& sheet, const std::string& file) {
  const auto& module = module_interface<DxfModule>("displayfile-dxf", file + ": DXF");
  OutputFile output(file);
  try {
    module.write(sheet, output.temporary_path());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(fmt::format("{}: {}", file, error.what()));
  }
  require_whole(output);
  output.commit();
}

}  // namespace displayfile
