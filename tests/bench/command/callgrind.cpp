#include "tests/bench/command/callgrind.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <utility>

#include "clip/base/error.h"
#include "tests/bench/command/process.h"
#include "tests/bench/command/temporary_folder.h"

namespace displayfile::bench {

namespace {

/// The functions that the dynamic linker runs at first lookups would be counted with the work that
/// happens to come first. Other variables of the environment would move the stack: they are left
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

std::string_view last_line(std::string_view text) {
  while (text.ends_with('\n')) text.remove_suffix(1);
  return text.substr(text.rfind('\n') + 1);
}

/// Throws Error unless the program ends well.
void run_alone(const std::vector<std::string>& command) {
  const Finished finished = run(Process{.command = command,
                                        .messages = Process::Messages::with_output,
                                        .variables = environment_of_work(),
                                        .variables_alone = true});
  if (!finished.started) throw Error(command.front() + " is not installed");
  if (!finished.succeeded) {
    throw Error(fmt::format("{} failed: {}", command.front(), last_line(finished.output)));
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
/// each followed by a line with the cost of the called function.
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

namespace {

/// The beginning of a command line: names are written out, as `read` expects.
std::vector<std::string> by_callgrind(const std::filesystem::path& file) {
  return {"valgrind",          "--quiet",
          "--tool=callgrind",  "--compress-strings=no",
          "--compress-pos=no", "--callgrind-out-file=" + file.string()};
}

}  // namespace

std::vector<WorkCount> counted_calls(const std::vector<std::string>& arguments,
                                     const std::string& function, std::size_t calls) {
  const TemporaryFolder folder;
  const std::filesystem::path parts = folder.path() / "part";
  std::vector<std::string> command = by_callgrind(parts);
  command.insert(command.end(), {"--toggle-collect=" + function, "--dump-after=" + function,
                                 std::filesystem::read_symlink("/proc/self/exe").string()});
  command.insert(command.end(), arguments.begin(), arguments.end());
  run_alone(command);
  std::vector<WorkCount> counts;
  for (std::size_t k = 1; k <= calls; ++k) {
    counts.push_back(read(parts.string() + fmt::format(".{}", k)));
    if (counts.back().functions.empty()) {
      throw Error(fmt::format("callgrind counted {} of {} calls", k - 1, calls));
    }
  }
  return counts;
}

WorkCount counted_run(const std::vector<std::string>& command) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "run";
  std::vector<std::string> line = by_callgrind(file);
  line.insert(line.end(), command.begin(), command.end());
  run_alone(line);
  WorkCount counted = read(file);
  if (counted.functions.empty()) throw Error("callgrind counted nothing");
  return counted;
}

}  // namespace displayfile::bench
