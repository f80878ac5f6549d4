#include "tests/bench/command/environment.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>

#include <ctime>
#include <fstream>
#include <functional>
#include <thread>

#include "clip/base/error.h"
#include "clip/base/shared_library.h"
#include "displayfile/mesh/import_library.h"
#include "interp/opengl/osmesa.h"
#include "tests/bench/command/build_information.h"
#include "tests/bench/command/embree_rays.h"
#include "tests/bench/command/gl2ps_sort.h"

namespace displayfile::bench {

namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  utsname system{};
  uname(&system);
  return system.machine;
}

std::string operating_system() {
  utsname system{};
  uname(&system);
  return fmt::format("{} {} {}", system.sysname, system.release, system.machine);
}

/// A library that is linked or loaded at run time, if this build has it.
std::pair<std::string, std::string> library(std::string name, std::string_view configured,
                                            const std::function<std::string()>& now) {
  if (configured.empty()) return {std::move(name), "not in this build"};
  return {std::move(name), fmt::format("{} when configured, {} now", configured, now())};
}

// The versions that libraries report, called without their headers, which may be missing.
using Version = const char*();
using VersionOfPng = const char*(const void*);
const SharedLibrary& linked() {
  static const SharedLibrary library(nullptr);
  return library;
}
std::string tbb_version() { return linked().function<Version*>("TBB_runtime_version")(); }
std::string gmp_version() { return *linked().function<const char* const*>("__gmp_version"); }
std::string png_version() {
  return linked().function<VersionOfPng*>("png_get_libpng_ver")(nullptr);
}
std::string cairo_version() {
  return SharedLibrary("libcairo.so.2").function<Version*>("cairo_version_string")();
}

}  // namespace

std::vector<std::pair<std::string, std::string>> environment() {
  return {
      {"date", fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)))},
      {"displayfile", build::kVersion},
      {"compiler", build::kCompiler},
      {"build type", build::kBuildType},
      {"flags", build::kFlags},
      {"processor", processor()},
      {"processors", fmt::format("{}", std::thread::hardware_concurrency())},
      {"system", operating_system()},
      {"OSMesa", osmesa_description()},
      {"Embree", EmbreeRays::version().value_or("not in this build")},
      {"gl2ps", Gl2psSort::version().value_or("not in this build")},
      library("oneTBB", build::kTbb, tbb_version),
      library("GMP", build::kGmp, gmp_version),
      library("libpng", build::kPng, png_version),
      library("Cairo", build::kCairo, cairo_version),
      library("Assimp", build::kAssimp, [] { return import_library_version().value_or("none"); }),
      {"{fmt}", build::kFmt},
      {"GLM", build::kGlm},
      {"CLI11", build::kCli11},
      {"JSON for Modern C++", build::kJson},
  };
}

std::string file_hash(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(path + ": cannot be read");
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (char c = 0; file.get(c);) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
  return fmt::format("{:016x}", hash);
}

std::string build_identity() { return file_hash("/proc/self/exe") + ", " + processor(); }

}  // namespace displayfile::bench
