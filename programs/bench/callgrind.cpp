#include "programs/bench/callgrind.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <utility>

#include "clip/error.h"

namespace displayfile::bench {

namespace {

/// Removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string path = (std::filesystem::temp_directory_path() / "displayfile-XXXXXX").string();
    if (mkdtemp(path.data()) == nullptr) throw Error(path + ": cannot be made");
    path_ = path;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The functions that the library's lookups run through the first time would be counted with the
/// work that happens to come first. What else is in the environment moves the stack: it is left
/// out.
constexpr const char* kPath = "PATH";
std::vector<std::string> environment_of_work() {
  std::vector<std::string> variables{"LD_BIND_NOW=1"};
  for (const char* name : {kPath, "LD_LIBRARY_PATH"}) {
    if (const char* value = std::getenv(name))
      variables.push_back(fmt::format("{}={}", name, value));
  }
  return variables;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> all;
  all.reserve(texts.size() + 1);
  for (std::string& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

std::string last_line(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string last;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

/// Throws Error unless the program ends well.
void run(std::vector<std::string> command, const std::filesystem::path& log) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  std::vector<std::string> variables = environment_of_work();
  pid_t process = 0;
  const int failed = posix_spawnp(&process, command.front().c_str(), &actions, nullptr,
                                  pointers(command).data(), pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw Error(command.front() + " is not installed");
  int status = 0;
  waitpid(process, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw Error(fmt::format("{} failed: {}", command.front(), last_line(log)));
  }
}

/// The rest of a line that begins so.
bool take(std::string_view& line, std::string_view begin) {
  if (!line.starts_with(begin)) return false;
  line.remove_prefix(begin.size());
  return true;
}

std::uint64_t number_after_space(std::string_view line) {
  const std::size_t space = line.find(' ');
  return space == line.npos ? 0 : std::strtoull(line.substr(space).data(), nullptr, 10);
}

/// Callgrind's format, names written out: a function, its costs at lines of source, and its calls,
/// each followed by a line with the cost of what was called.
WorkCount read(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::map<std::pair<std::string, std::string>, FunctionCount> functions;
  std::string object, callee;
  FunctionCount* function = nullptr;
  for (std::string text; std::getline(in, text);) {
    std::string_view line = text;
    if (take(line, "ob=")) {
      object = line;
    } else if (take(line, "fn=")) {
      function = &functions[{object, std::string(line)}];
      function->name = line;
      function->object = object;
    } else if (take(line, "cfn=")) {
      callee = line;
    } else if (take(line, "calls=")) {
      const std::uint64_t calls = std::strtoull(line.data(), nullptr, 10);
      if (callee.starts_with("operator new")) function->allocations += calls;
      std::getline(in, text);
    } else if (function != nullptr && !line.empty() && (std::isdigit(line.front()) != 0)) {
      function->instructions += number_after_space(line);
    }
  }
  WorkCount work;
  for (auto& [key, count] : functions) work.functions.push_back(std::move(count));
  return work;
}

/// A name up to its parameters.
std::string_view without_parameters(std::string_view name) {
  constexpr std::string_view kUnnamed = "(anonymous namespace)", kCall = "operator()";
  std::size_t at = 0;
  while ((at = name.find('(', at)) != name.npos) {
    if (name.substr(at).starts_with(kUnnamed)) {
      at += kUnnamed.size();
    } else if (at + 2 >= kCall.size() && name.substr(0, at + 2).ends_with(kCall)) {
      at += 2;
    } else {
      break;
    }
  }
  return name.substr(0, at);
}

}  // namespace

bool FunctionCount::is_of(std::span<const std::string_view> parts) const {
  const std::string_view own = without_parameters(name);
  const std::size_t folder = object.rfind('/');
  const std::string_view file = folder == object.npos ? std::string_view(object)
                                                      : std::string_view(object).substr(folder + 1);
  return std::ranges::any_of(parts, [&](std::string_view part) {
    return own.find(part) != own.npos || file.find(part) != file.npos;
  });
}

std::uint64_t WorkCount::instructions() const {
  std::uint64_t sum = 0;
  for (const FunctionCount& f : functions) sum += f.instructions;
  return sum;
}

std::uint64_t WorkCount::instructions_of(std::span<const std::string_view> parts) const {
  std::uint64_t sum = 0;
  for (const FunctionCount& f : functions) sum += f.is_of(parts) ? f.instructions : 0;
  return sum;
}

std::uint64_t WorkCount::allocations_of(std::span<const std::string_view> parts) const {
  std::uint64_t sum = 0;
  for (const FunctionCount& f : functions) sum += f.is_of(parts) ? f.allocations : 0;
  return sum;
}

std::vector<WorkCount> counted_calls(const std::vector<std::string>& arguments,
                                     const std::string& function, std::size_t calls) {
  const TemporaryFolder folder;
  const std::filesystem::path parts = folder.path() / "part";
  std::vector<std::string> command{"valgrind",
                                   "--quiet",
                                   "--tool=callgrind",
                                   "--compress-strings=no",
                                   "--compress-pos=no",
                                   "--toggle-collect=" + function,
                                   "--dump-after=" + function,
                                   "--callgrind-out-file=" + parts.string(),
                                   std::filesystem::read_symlink("/proc/self/exe").string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  run(command, folder.path() / "log");
  std::vector<WorkCount> counts;
  for (std::size_t k = 1; k <= calls; ++k) {
    counts.push_back(read(parts.string() + fmt::format(".{}", k)));
    if (counts.back().functions.empty()) {
      throw Error(fmt::format("callgrind counted {} of {} calls", k - 1, calls));
    }
  }
  return counts;
}

}  // namespace displayfile::bench
