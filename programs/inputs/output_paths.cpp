#include "programs/inputs/output_paths.h"

#include <fmt/format.h>

#include <map>
#include <system_error>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "displayfile/text/output_file.h"
#include "programs/inputs/output_name.h"

namespace displayfile {

namespace fs = std::filesystem;

namespace {

std::optional<fs::path> file_at(const fs::path& name) {
  if (name.empty()) return std::nullopt;
  std::error_code error;
  const fs::file_status status = fs::status(name, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) return std::nullopt;
  const fs::path file = real_path(name, error);
  if (error) return std::nullopt;
  return file;
}

}  // namespace

std::optional<fs::path> output_at(const fs::path& name) {
  return is_standard_output(name.string()) ? file_at("/dev/stdout").value_or("-") : file_at(name);
}

std::optional<fs::path> input_at(const fs::path& name) {
  return file_at(name == "-" ? "/dev/stdin" : name);
}

void require_files_of_their_own(std::span<const std::string> outputs,
                                std::span<const std::string> inputs,
                                std::span<const std::string> lists) {
  std::map<fs::path, std::string> names;
  bool is_any_there = false;
  for (const std::string& output : outputs) {
    const auto file = output_at(output);
    if (!file) continue;
    const auto [other, is_new] = names.emplace(*file, output);
    if (!is_new && is_standard_output(output) && is_standard_output(other->second)) {
      throw Error("-: two outputs on standard output: expected one, and file names for the others");
    }
    if (!is_new) {
      throw Error(fmt::format("{} and {}: two outputs are one file: expected a file for each",
                              other->second, output));
    }
    std::error_code error;
    is_any_there = is_any_there || fs::exists(*file, error);
  }
  if (!is_any_there) return;  // nor is any an input
  for (const auto files_read : {inputs, lists}) {
    for (const std::string& input : files_read) {
      const auto file = input_at(input);
      if (file && names.contains(*file)) {
        throw Error(
            fmt::format("{}: is an input and an output: expected another file for the output",
                        names.at(*file)));
      }
    }
  }
}

void require_files_of_their_own(std::initializer_list<std::string> outputs,
                                std::span<const std::string> inputs,
                                std::span<const std::string> lists) {
  for (const std::string& output : outputs) require_no_field(output);
  require_files_of_their_own(std::span(outputs.begin(), outputs.size()), inputs, lists);
}

void require_no_field(const std::string& output) {
  if (!has_field(output)) return;
  throw Error(fmt::format(
      "{}: this command writes one file: expected a name without fields, which draw and check have",
      output));
}

void require_extension(const std::string& output, const char* extension, const char* what) {
  if (output == "-" || extension_of(output) == extension) return;
  throw Error(fmt::format("{}: expected {} that ends in {}, or -", output, what, extension));
}

}  // namespace displayfile
