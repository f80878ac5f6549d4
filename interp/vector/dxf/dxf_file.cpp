#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <ios>
#include <new>
#include <string>
#include <string_view>

#include "clip/base/error.h"
#include "clip/base/module.h"
#include "displayfile/text/output.h"
#include "displayfile/text/output_file.h"
#include "interp/vector/dxf/dxf_drawing.h"
#include "interp/vector/dxf/dxf_module.h"

namespace displayfile {

const bool kWritesDxf = true;

namespace {

/// dxflib does not report whether all could be written: the file's last line shows it.
void require_whole(OutputFile& output, const std::string& name) {
  constexpr std::string_view kLast = "EOF\n";
  std::ifstream written(output.temporary_path(), std::ios::binary);
  written.seekg(-static_cast<std::streamoff>(kLast.size()), std::ios::end);
  std::string end(kLast.size(), '\0');
  written.read(end.data(), static_cast<std::streamsize>(end.size()));
  if (!written || end != kLast) throw Error(name + ": not all could be written");
}

void write_into(const DxfDrawing& drawing, OutputFile& output, const std::string& name) {
  const auto& module = module_interface<DxfModule>("displayfile-dxf", name + ": DXF");
  try {
    module.write(drawing, output.temporary_path());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(fmt::format("{}: {}", name, error.what()));
  }
  require_whole(output, name);
}

/// dxflib writes files alone: one among the temporary ones, which is copied and removed.
void write_to_stream(const DxfDrawing& drawing, const Destination& to) {
  OutputFile copied((std::filesystem::temp_directory_path() / "displayfile.dxf").string());
  write_into(drawing, copied, to.name());
  const std::unique_ptr<Output> output = output_to(to);
  output->stream() << std::ifstream(copied.temporary_path(), std::ios::binary).rdbuf();
  output->commit();
}

}  // namespace

void write_dxf(const DxfDrawing& drawing, const Destination& to) {
  if (to.stream() != nullptr) return write_to_stream(drawing, to);
  OutputFile output(to.name());
  write_into(drawing, output, to.name());
  output.commit();
}

}  // namespace displayfile
