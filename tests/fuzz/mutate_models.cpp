// Mutants of all models in a folder, read as the command reads them: a library that crashes, hangs
// or exhausts its memory must cost one message, and nothing else. See tests/fuzz/README.md.

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "displayfile/mesh/import_library.h"
#include "displayfile/mesh/import_process.h"
#include "displayfile/mesh/import_protocol.h"
#include "displayfile/mesh/mesh.h"
#include "programs/import_program/import_program.h"
#include "programs/options/import_words.h"
#include "programs/process/exit_status.h"
#include "tests/fuzz/mutated_bytes.h"

namespace displayfile::test {
namespace {

namespace fs = std::filesystem;

// ---- Models ----------------------------------------------------------------------------

struct Model {
  fs::path path;
  std::string bytes;
};

using Format = std::vector<Model>;

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// By extension: models of at most `most_bytes`, otherwise the smallest. Without those that are
/// read without the import library, and without other files beside models.
std::map<std::string, Format> models_in(const fs::path& folder, std::uintmax_t most_bytes) {
  static const std::set<std::string> kOthers{".obj", ".off",  ".ply",  ".stl",  ".png",     ".jpg",
                                             ".tga", ".bmp",  ".txt",  ".bin",  ".mtl",     ".md",
                                             ".uc",  ".glsl", ".vert", ".frag", ".material"};
  std::map<std::string, std::vector<fs::path>> by_extension;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string extension = extension_of(entry.path());
    if (!entry.is_regular_file() || kOthers.contains(extension) || entry.file_size() == 0) continue;
    by_extension[extension].push_back(entry.path());
  }
  std::map<std::string, Format> formats;
  for (auto& [extension, paths] : by_extension) {
    std::ranges::sort(paths, {}, [](const fs::path& p) { return std::pair(fs::file_size(p), p); });
    for (const fs::path& path : paths) {
      Format& models = formats[extension];
      if (!models.empty() && fs::file_size(path) > most_bytes) break;
      models.push_back({path, content(path)});
    }
  }
  return formats;
}

/// A folder with a model's neighbours, for its mutants.
class Folders {
 public:
  Folders() : all_(fs::temp_directory_path() / fmt::format("mutate_models-{}", getpid())) {
    fs::create_directories(all_);
  }
  Folders(const Folders&) = delete;
  Folders& operator=(const Folders&) = delete;
  ~Folders() {
    std::error_code ignored;
    fs::remove_all(all_, ignored);
  }

  fs::path of(const fs::path& model) {
    constexpr std::uintmax_t kLargest = 1 << 17;
    const fs::path folder = model.parent_path();
    const auto [found, is_new] = folders_.try_emplace(folder, fmt::format("{}", folders_.size()));
    const fs::path copy = all_ / found->second;
    if (!is_new) return copy;
    fs::create_directories(copy);
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (!entry.is_regular_file() || entry.file_size() > kLargest) continue;
      fs::copy_file(entry.path(), copy / entry.path().filename(),
                    fs::copy_options::overwrite_existing);
    }
    return copy;
  }

 private:
  fs::path all_;
  std::map<fs::path, std::string> folders_;
};

// ---- Outcomes --------------------------------------------------------------------------

enum Outcome { kRead, kRefused, kCrash, kTime, kMemory, kOurs, kOutcomes };
constexpr std::array<const char*, kOutcomes> kNames{
    "read", "refused", "crash of the library", "time limit", "memory limit", "failure of ours"};

Outcome outcome_of(const std::string& path, bool with_normals, const ImportLimits& limits,
                   std::string& message) {
  try {
    read_mesh(path, with_normals, limits);
    return kRead;
  } catch (const Error& e) {
    message = e.what();
  } catch (const std::exception& e) {
    message = e.what();
    return kOurs;
  }
  const auto says = [&](const char* words) { return message.find(words) != message.npos; };
  if (!message.starts_with(path)) return kOurs;
  if (says("crashed on it") || says("ended its process")) return kCrash;
  if (says("seconds: --import-seconds")) return kTime;
  if (says("of memory: ") || says("was killed while")) return kMemory;
  if (says("invalid reply of the import program") || says("cannot be started")) return kOurs;
  return kRefused;
}

constexpr std::size_t kMostFormats = 128;

/// The data that the reading process shares with the one that watches it.
struct Shared {
  std::atomic<std::uint64_t> next;                     ///< the mutant that is read, or will be
  std::atomic<std::int64_t> begun;                     ///< seconds
  std::atomic<std::uint64_t> parent_peak, child_peak;  ///< KiB
  std::array<std::array<std::atomic<std::uint64_t>, kOutcomes>, kMostFormats> counts;
};

std::int64_t now() {
  return std::chrono::duration_cast<std::chrono::seconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

std::uint64_t peak_of(decltype(RUSAGE_SELF) who) {
  rusage used{};
  getrusage(who, &used);
  return static_cast<std::uint64_t>(used.ru_maxrss);
}

// ---- Mutants ---------------------------------------------------------------------------

struct Options {
  std::string folder = "/usr/share/assimp/models", keep;
  ImportWords import;
  std::uint64_t mutants = 1000, seed = 1, from = 0;
  std::uintmax_t most_bytes = 24 << 10;
  bool verbose = false, exec = false;
};

class Mutants {
 public:
  explicit Mutants(const Options& options) : options_(options), limits_(options.import.limits()) {
    for (auto& [extension, models] : models_in(options.folder, options.most_bytes)) {
      names_.push_back(extension.empty() ? "(none)" : extension);
      if (models.front().bytes.size() <= kLarge) small_.push_back(formats_.size());
      formats_.push_back(std::move(models));
    }
    if (small_.empty() || formats_.size() > kMostFormats) {
      throw Error(fmt::format("{}: {} formats: expected 1 to {}", options.folder, formats_.size(),
                              kMostFormats));
    }
  }

  const std::vector<std::string>& names() const { return names_; }
  /// In turn; most turns of those that have large models alone go to others.
  std::size_t format_of(std::uint64_t mutant) const {
    constexpr std::uint64_t kTurns = 16;
    const auto format = static_cast<std::size_t>(mutant % formats_.size());
    const std::uint64_t turn = mutant / formats_.size();
    const bool is_small = formats_[format].front().bytes.size() <= kLarge;
    return is_small || turn % kTurns == 0 ? format : small_[turn % small_.size()];
  }
  const ImportLimits& limits() const { return limits_; }
  bool starts_programs() const { return options_.exec; }

  /// Mutant n is the same in every run of a seed.
  void read(std::uint64_t n, Folders& folders, Shared& shared) const {
    std::mt19937_64 random(options_.seed * 0x9E3779B97F4A7C15u + n);
    const Format& models = formats_[format_of(n)];
    const auto any = [&] { return static_cast<std::size_t>(random() % models.size()); };
    const Model& model = models[static_cast<std::size_t>(n / formats_.size() % models.size())];
    const std::string bytes = mutated(model.bytes, models[any()].bytes, random);
    constexpr unsigned kNameless = 16;  // one in this many has no extension
    const std::string extension = random() % kNameless == 0 ? "" : model.path.extension().string();
    const fs::path path = folders.of(model.path) / ("mutant" + extension);
    std::ofstream(path, std::ios::binary) << bytes;
    std::string message;
    const Outcome outcome = outcome_of(path.string(), n % 2 == 1, limits_, message);
    ++shared.counts[format_of(n)][outcome];
    if (options_.verbose || outcome == kOurs) {
      fmt::print("{} {} {}: {}\n", n, model.path.string(), kNames[outcome], message);
      std::fflush(stdout);
    }
    keep(n, path, outcome);
    fs::remove(path);
  }

 private:
  void keep(std::uint64_t n, const fs::path& path, Outcome outcome) const {
    if (options_.keep.empty() || outcome == kRead || outcome == kRefused) return;
    fs::create_directories(options_.keep);
    fs::copy_file(path,
                  fs::path(options_.keep) /
                      fmt::format("{}-{}{}", n, int{outcome}, path.extension().string()),
                  fs::copy_options::overwrite_existing);
  }

  static constexpr std::size_t kLarge = std::size_t{1} << 17;

  const Options& options_;
  ImportLimits limits_;
  std::vector<std::string> names_;
  std::vector<std::size_t> small_;  // formats that have a small model
  std::vector<Format> formats_;
};

/// Instead of starting the program anew: a fork of this process, which has loaded the library
/// already and has one thread, does the program's work, with limits of its own.
int start_by_fork(std::vector<std::string>& words, int reply, int messages) {
  const pid_t child = fork();
  if (child < 0) return -errno;
  if (child > 0) return child;
  dup2(messages, STDOUT_FILENO);
  dup2(messages, STDERR_FILENO);
  dup2(reply, kReplyDescriptor);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  _exit(read_for_waiting_process(static_cast<int>(arguments.size()), arguments.data()));
}

/// The process that reads.
int read_all(const Mutants& mutants, std::uint64_t end, Shared& shared) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  std::cerr.rdbuf(nullptr);  // messages of readers about mutants
  if (!mutants.starts_programs()) {
    load_import_library("mutants");
    import_starter() = start_by_fork;
  }
  Folders folders;
  while (shared.next < end) {
    shared.begun = now();
    mutants.read(shared.next, folders, shared);
    shared.parent_peak = std::max<std::uint64_t>(shared.parent_peak, peak_of(RUSAGE_SELF));
    shared.child_peak = std::max<std::uint64_t>(shared.child_peak, peak_of(RUSAGE_CHILDREN));
    ++shared.next;
  }
  return 0;
}

/// Watches it, and starts another one behind a mutant that ended it or at which it hangs.
void watch(const Mutants& mutants, std::uint64_t end, Shared& shared) {
  constexpr std::int64_t kPatience = 20;
  while (shared.next < end) {
    shared.begun = now();
    const pid_t reader = fork();
    if (reader < 0) throw Error("no process to read in");
    if (reader == 0) _exit(read_all(mutants, end, shared));
    int status = 0;
    for (;;) {
      const pid_t ended = waitpid(reader, &status, WNOHANG);
      if (ended == reader) break;
      const auto most = static_cast<std::int64_t>(mutants.limits().seconds) + kPatience;
      if (now() - shared.begun > most) kill(reader, SIGKILL);
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    if (shared.next >= end && WIFEXITED(status) && WEXITSTATUS(status) == 0) break;
    fmt::print("mutant {}: the reading process {}\n", shared.next.load(),
               WIFSIGNALED(status) ? fmt::format("was ended by signal {}", WTERMSIG(status))
                                   : fmt::format("ended with status {}", WEXITSTATUS(status)));
    ++shared.counts[mutants.format_of(shared.next)][kOurs];
    ++shared.next;
  }
}

void print_counts(const Mutants& mutants, const Shared& shared) {
  std::array<std::uint64_t, kOutcomes> all{};
  fmt::print("{:<12}", "");
  for (const char* name : kNames) fmt::print("{:>22}", name);
  fmt::print("\n");
  const auto row = [](const std::string& name, const auto& counts) {
    fmt::print("{:<12}", name);
    for (const auto& count : counts) fmt::print("{:>22}", std::uint64_t{count});
    fmt::print("\n");
  };
  for (std::size_t f = 0; f < mutants.names().size(); ++f) {
    row(mutants.names()[f], shared.counts[f]);
    for (std::size_t k = 0; k < all.size(); ++k) all[k] += shared.counts[f][k];
  }
  row("all", all);
}

/// To ctest.
constexpr int kSkipped = 77;

int run(int argc, char** argv) {
  CLI::App app("Reads mutants of models, and counts what became of them.", "mutate_models");
  Options options;
  app.add_option("FOLDER", options.folder, "of models")->capture_default_str();
  app.add_option("--mutants", options.mutants)->capture_default_str();
  app.add_option("--from", options.from, "the first one")->capture_default_str();
  app.add_option("--seed", options.seed)->capture_default_str();
  app.add_option("--most-bytes", options.most_bytes, "of a model, if its format has a smaller one")
      ->capture_default_str();
  app.add_option("--keep", options.keep, "a folder for those that reached a limit or crashed");
  app.add_flag("--exec", options.exec,
               "start the program anew for each, as the command does, in place of a fork of one "
               "that has loaded the library");
  app.add_flag("--verbose", options.verbose, "tell of each");
  options.import.memory = "256M";
  options.import.seconds = "1";
  options.import.add_to(app);
  CLI11_PARSE(app, argc, argv);

  if (!fs::is_directory(options.folder)) {
    fmt::print("skipped: no folder {} (package assimp-testmodels)\n", options.folder);
    return kSkipped;
  }
  const Mutants mutants(options);
  void* const memory =
      mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw Error("no memory to count in");
  Shared& shared = *new (memory) Shared{};
  shared.next = options.from;
  watch(mutants, options.from + options.mutants, shared);
  print_counts(mutants, shared);
  std::uint64_t read = 0, failures = 0;
  for (const auto& counts : shared.counts) {
    read += counts[kRead];
    failures += counts[kOurs];
  }
  constexpr std::uint64_t kOwn = 256;  // MiB that a process has before it reads a mesh
  const std::uint64_t most = (mutants.limits().memory >> 20) + kOwn;
  fmt::print("most memory: {} MiB in the reading process, {} MiB in the library's, of {} MiB\n",
             shared.parent_peak >> 10, shared.child_peak >> 10, most);
  const bool is_within = shared.parent_peak >> 10 <= most && shared.child_peak >> 10 <= most;
  fmt::print("{} mutants of seed {}, {} read, {} failures of ours, memory {} the limit\n",
             options.mutants, options.seed, read, failures, is_within ? "within" : "beyond");
  return failures == 0 && is_within && read > 0 ? 0 : 1;
}

}  // namespace
}  // namespace displayfile::test

int main(int argc, char** argv) {
  return displayfile::exit_status(displayfile::test::run, argc, argv);
}
