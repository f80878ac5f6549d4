#include "programs/options/import_words.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <limits>
#include <string_view>

#include "clip/base/error.h"
#include "programs/options/number_list.h"
#include "programs/options/option_groups.h"

namespace displayfile {

namespace {

[[noreturn]] void expect(const char* option, const std::string& word, const char* expected) {
  throw Error(fmt::format("{} {}: expected {}", option, word, expected));
}

double positive_number(const char* option, const std::string& word, std::string_view digits,
                       const char* expected) {
  const auto values = number_list(std::string(digits));
  if (!values || values->size() != 1 || !(values->front() > 0.0)) expect(option, word, expected);
  return values->front();
}

std::size_t memory_of(const std::string& word) {
  constexpr const char* kName = "--import-memory";
  constexpr const char* kExpected = "bytes with K, M or G, such as 512M";
  constexpr std::string_view kUnits = "KMG";
  const std::size_t unit = word.empty() ? kUnits.npos : kUnits.find(word.back());
  if (unit == kUnits.npos) expect(kName, word, kExpected);
  const std::string_view digits = std::string_view(word).substr(0, word.size() - 1);
  const double units = positive_number(kName, word, digits, kExpected);
  const double bytes = units * static_cast<double>(std::size_t{1} << (10 * (unit + 1)));
  constexpr auto kMost = static_cast<double>(std::numeric_limits<std::ptrdiff_t>::max());
  if (!(bytes >= 1.0 && bytes < kMost)) expect(kName, word, kExpected);
  return static_cast<std::size_t>(bytes);
}

}  // namespace

void ImportWords::add_to(CLI::App& command) {
  command
      .add_option("--import-memory", memory,
                  "memory limit for reading a mesh that is not OBJ, OFF, PLY or STL; bytes with K, "
                  "M or G (2G)")
      ->type_name("BYTES")
      ->group(kImportOptions);
  command
      .add_option("--import-seconds", seconds, "time limit for reading such a mesh, elapsed (60)")
      ->type_name("SECONDS")
      ->group(kImportOptions);
  command
      .add_option("--deflection", deflection,
                  "STEP and IGES: largest distance of facets from curved surfaces, in the file's "
                  "units (1/2500 of the diagonal of all its parts)")
      ->type_name("LENGTH")
      ->group(kImportOptions);
  command
      .add_flag("--any-format", any_format,
                "on systems that cannot confine the import library, also read formats whose "
                "readers are not known to be safe")
      ->group(kImportOptions);
}

ImportLimits ImportWords::limits() const {
  ImportLimits limits{.any_format = any_format};
  if (!memory.empty()) limits.memory = memory_of(memory);
  if (!seconds.empty()) {
    limits.seconds = positive_number("--import-seconds", seconds, seconds, "seconds, more than 0");
  }
  if (!deflection.empty()) {
    limits.deflection =
        positive_number("--deflection", deflection, deflection, "a length, more than 0");
  }
  return limits;
}

}  // namespace displayfile
