#include "displayfile/mesh/import_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <string_view>
#include <utility>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "clip/base/memory.h"
#include "clip/base/module.h"
#include "clip/base/work_budget.h"
#include "displayfile/mesh/import_protocol.h"
#include "displayfile/mesh/mesh_reply.h"
#include "displayfile/text/characters.h"

namespace displayfile {

namespace {

using Clock = std::chrono::steady_clock;

// ---- Limits ----------------------------------------------------------------------------

void require_limits(const std::string& path, const ImportLimits& limits) {
  if (!(limits.deflection >= 0.0) || std::isinf(limits.deflection)) {
    throw Error(
        fmt::format("{}: deflection {}: expected a length, 0 or more", path, limits.deflection));
  }
  if (limits.memory > 0 && limits.seconds > 0.0) return;  // false for NaN too
  throw Error(fmt::format("{}: import limits of {} bytes and {} seconds: expected more than 0",
                          path, limits.memory, limits.seconds));
}

/// A reader's output, which may contain text of the file, restricted to drawable characters and
/// line ends, so that nothing else reaches a terminal.
std::string lines_drawable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    result += drawable(text.substr(0, length));
    if (length < text.size()) result += '\n';
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return result;
}

/// The number of bytes with its unit, in a form that `--import-memory` also accepts.
std::string in_words(std::size_t bytes) {
  constexpr std::array<std::pair<int, const char*>, 3> kUnits{
      {{30, "GiB"}, {20, "MiB"}, {10, "KiB"}}};
  for (const auto& [bits, name] : kUnits) {
    const std::size_t unit = std::size_t{1} << bits;
    if (bytes >= unit && bytes % unit == 0) return fmt::format("{} {}", bytes / unit, name);
  }
  return fmt::format("{} bytes", bytes);
}

/// One mesh that an import program reads.
struct Reading {
  const ImportProgram& program;
  const std::string& path;
  bool with_normals;
  const ImportLimits& limits;
};

Error too_slow(const Reading& reading) {
  return Error(
      fmt::format("{}: the import library ({}) reached the limit of {} seconds: "
                  "--import-seconds (ImportLimits::seconds) sets another",
                  reading.path, reading.program.library, reading.limits.seconds));
}

/// `lent`: the memory that the process had, less than its own limit if no more was available.
Error too_hungry(const Reading& reading, std::size_t lent) {
  return Error(
      fmt::format("{}: the import library ({}) reached the limit of {} of memory: {} sets another",
                  reading.path, reading.program.library, in_words(lent),
                  lent < reading.limits.memory ? "--limit-memory, which leaves no more,"
                                               : "--import-memory (ImportLimits::memory)"));
}

std::string name_of_signal(int number) {
  switch (number) {
    case SIGSEGV: return "SIGSEGV";
    case SIGBUS: return "SIGBUS";
    case SIGABRT: return "SIGABRT";
    case SIGFPE: return "SIGFPE";
    case SIGILL: return "SIGILL";
    case SIGSYS: return "SIGSYS";
    default: return fmt::format("signal {}", number);
  }
}

/// The exit status is unknown because something else in this process waits for all of its children.
constexpr int kUnknownStatus = -1;

/// The error for a process that did not answer.
Error without_answer(const Reading& reading, std::size_t lent, int status) {
  const auto failed = [&](const std::string& how) {
    return Error(fmt::format("{}: not a mesh that can be read: the import library ({}) {}",
                             reading.path, reading.program.library, how));
  };
  if (status == kUnknownStatus) return failed("did not answer");
  if (WIFSIGNALED(status)) {
    const int number = WTERMSIG(status);
    if (number == SIGXCPU) return too_slow(reading);
    if (number == SIGKILL) {
      return failed("was killed while reading it, probably for lack of memory");
    }
    return failed("crashed on it (" + name_of_signal(number) + ")");
  }
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  if (code == kOutOfMemoryStatus) return too_hungry(reading, lent);
  if (code == kOtherProtocolStatus) return failed("was called by a program of another build");
  return failed(fmt::format("ended its process with status {}", code));
}

// ---- Descriptors -----------------------------------------------------------------------

class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }

  int number() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(std::exchange(number_, -1));
  }

 private:
  int number_;
};

struct Pipe {
  Descriptor read_end, write_end;
};

/// Moves a descriptor above the numbers that the other process uses; it is closed on exec unless it
/// is passed on.
Descriptor moved_up(Descriptor descriptor) {
  constexpr int kFirst = 10;
  return Descriptor(fcntl(descriptor.number(), F_DUPFD_CLOEXEC, kFirst));
}

Pipe make_pipe(const std::string& path) {
  std::array<int, 2> ends{-1, -1};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw Error(fmt::format("{}: no pipe to the import program: {}", path, std::strerror(errno)));
  }
  Pipe pipe{moved_up(Descriptor(ends[0])), moved_up(Descriptor(ends[1]))};
  const int flags = fcntl(pipe.read_end.number(), F_GETFL);
  if (flags < 0 || fcntl(pipe.read_end.number(), F_SETFL, flags | O_NONBLOCK) != 0 ||
      pipe.write_end.number() < 0) {
    throw Error(fmt::format("{}: no pipe to the import program: {}", path, std::strerror(errno)));
  }
  return pipe;
}

// ---- The program -----------------------------------------------------------------------

std::string path_of(const ImportProgram& program, const std::string& mesh) {
  std::string looked_at;
  int why = ENOENT;
  const char* const named = std::getenv(program.variable);
  for (const auto& place : places_of_companion(program.name, named)) {
    if (access(place.c_str(), X_OK) == 0) return place.string();
    if (errno != ENOENT && errno != ENOTDIR) why = errno;
    looked_at += (looked_at.empty() ? "" : ", ") + place.string();
  }
  throw Error(fmt::format(
      "{}: the import program cannot be started: {}: {}: Debian's package {} has it; set the "
      "environment variable {} if it is elsewhere",
      mesh, looked_at, std::strerror(why), program.package, program.variable));
}

/// The environment that the program inherits: three descriptors, no blocked signals, and default
/// handling of the signals for crashes, limits and broken pipes. Other signals that are ignored,
/// such as those sent to end both processes, stay ignored.
class Inheritance {
 public:
  Inheritance(int reply, int messages) {
    posix_spawn_file_actions_init(&files_);
    posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files_, messages, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files_, messages, STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&files_, reply, kReplyDescriptor);
    sigset_t none, its_own;
    sigemptyset(&none);
    sigemptyset(&its_own);
    for (const int number :
         {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGPIPE, SIGSEGV, SIGSYS, SIGXCPU, SIGXFSZ}) {
      sigaddset(&its_own, number);
    }
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &its_own);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  Inheritance(const Inheritance&) = delete;
  Inheritance& operator=(const Inheritance&) = delete;
  ~Inheritance() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }

  const posix_spawn_file_actions_t* files() const { return &files_; }
  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t files_{};
  posix_spawnattr_t attributes_{};
};

int spawn(std::vector<std::string>& words, int reply, int messages) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const Inheritance inheritance(reply, messages);
  pid_t child = 0;
  const int failure = posix_spawn(&child, words[0].c_str(), inheritance.files(),
                                  inheritance.attributes(), arguments.data(), environ);
  return failure == 0 ? child : -failure;
}

// ---- The process -----------------------------------------------------------------------

/// Thrown if the process ended, or closed its end of the pipe, before its answer was complete.
struct NoAnswer {};

class ImportProcess {
 public:
  explicit ImportProcess(const Reading& reading)
      : reading_(reading), memory_(reading.limits.memory) {
    constexpr double kMostSeconds = 1e9;
    deadline_ = Clock::now() +
                std::chrono::duration_cast<Clock::duration>(
                    std::chrono::duration<double>(std::min(reading.limits.seconds, kMostSeconds)));
    Pipe reply = make_pipe(reading.path), messages = make_pipe(reading.path);
    constexpr int kPipeBytes = 1 << 20;  // fewer reads; the system may limit it
    fcntl(reply.write_end.number(), F_SETPIPE_SZ, kPipeBytes);
    start(reply.write_end, messages.write_end);
    reply_ = std::move(reply.read_end);
    messages_ = std::move(messages.read_end);
  }
  ImportProcess(const ImportProcess&) = delete;
  ImportProcess& operator=(const ImportProcess&) = delete;
  ~ImportProcess() { end(); }

  /// Waits until `bytes` is filled from the answer, as long as the budget in force allows it.
  /// Throws Error at a limit, and NoAnswer if the bytes do not arrive.
  void fill(std::span<std::byte> bytes) {
    while (!bytes.empty()) {
      ask_budget();
      if (Clock::now() >= deadline_) throw too_slow(reading_);
      const ssize_t count = ::read(reply_.number(), bytes.data(), bytes.size());
      if (count > 0) {
        bytes = bytes.subspan(static_cast<std::size_t>(count));
      } else if (count < 0 && errno == EAGAIN) {
        wait_for_more();
      } else if (count == 0 || errno != EINTR) {
        throw NoAnswer{};
      }
    }
  }

  std::size_t memory() const { return memory_.bytes(); }  ///< available to the process

  /// Ends the process, if it has not ended, and prints its messages. Returns its status.
  int end() {
    if (child_ <= 0) return status_;
    kill(child_, SIGKILL);  // a process that has ended keeps its status
    while (waitpid(child_, &status_, 0) < 0) {
      if (errno == EINTR) continue;
      status_ = kUnknownStatus;
      break;
    }
    child_ = 0;
    take_messages();
    if (!message_.empty()) std::cerr << lines_drawable(message_) << std::flush;
    return status_;
  }

 private:
  void start(const Descriptor& reply, const Descriptor& messages) {
    const double seconds = std::min(std::ceil(reading_.limits.seconds), 1e9);
    std::vector<std::string> words{path_of(reading_.program, reading_.path),
                                   kImportProtocol,
                                   std::to_string(getpid()),
                                   std::to_string(memory_.bytes()),
                                   fmt::format("{:.0f}", seconds),
                                   reading_.with_normals ? "1" : "0",
                                   fmt::format("{}", reading_.limits.deflection),
                                   reading_.path};
    child_ = import_starter()(words, reply.number(), messages.number());
    if (child_ > 0) return;
    throw Error(fmt::format("{}: the import program cannot be started: {}: {}", reading_.path,
                            words[0], std::strerror(-child_)));
  }

  void wait_for_more() {
    std::array<pollfd, 2> ends{{{reply_.number(), POLLIN, 0}, {messages_.number(), POLLIN, 0}}};
    using std::chrono::milliseconds;
    const auto left = std::chrono::ceil<milliseconds>(deadline_ - Clock::now());
    constexpr milliseconds kWatch(20), kLong(60'000);
    const bool watches = kWatchesResidentMemory || work_in_force().budget != nullptr;
    const auto wait = std::clamp(left, milliseconds(0), watches ? kWatch : kLong);
    if (poll(ends.data(), ends.size(), static_cast<int>(wait.count())) < 0 && errno != EINTR) {
      throw NoAnswer{};
    }
    if (ends[1].revents != 0) take_messages();
    if (kWatchesResidentMemory && resident_bytes() > memory_.bytes()) {
      throw too_hungry(reading_, memory_.bytes());
    }
  }

  /// Reads the messages written so far; only the first kMostOfMessage bytes are kept.
  void take_messages() {
    std::array<char, 4096> part;
    for (std::size_t taken = 0; messages_.number() >= 0 && taken < kMostOfMessage;) {
      const ssize_t count = ::read(messages_.number(), part.data(), part.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0 && errno == EAGAIN) return;
      if (count <= 0) return messages_.close();
      const auto bytes = static_cast<std::size_t>(count);
      message_.append(part.data(), std::min(bytes, kMostOfMessage - message_.size()));
      taken += bytes;
    }
  }

  std::size_t resident_bytes() const {
    std::ifstream pages(fmt::format("/proc/{}/statm", child_));
    std::size_t all = 0, resident = 0;
    pages >> all >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  }

  Reading reading_;
  LentMemory memory_;
  Clock::time_point deadline_;
  pid_t child_ = 0;
  int status_ = 0;
  Descriptor reply_, messages_;
  std::string message_;
};

}  // namespace

ImportStarter& import_starter() {
  static ImportStarter starter = spawn;
  return starter;
}

Mesh read_by_program(const ImportProgram& program, const std::string& path, bool with_normals,
                     const ImportLimits& limits) {
  require_limits(path, limits);
  const Reading reading{program, path, with_normals, limits};
  ImportProcess process(reading);
  try {
    auto reply =
        receive_reply([&](std::span<std::byte> bytes) { process.fill(bytes); }, limits.memory);
    process.end();
    if (auto* const mesh = std::get_if<Mesh>(&reply)) return std::move(*mesh);
    std::string_view message = std::get<std::string>(reply);
    const bool names_file = message.starts_with(path);
    if (names_file) message.remove_prefix(path.size());
    throw NotRead(path + (names_file ? "" : ": ") + drawable(message));
  } catch (const NoAnswer&) {
    throw without_answer(reading, process.memory(), process.end());
  } catch (const BadReply& e) {
    throw Error(
        fmt::format("{}: not a mesh that can be read: invalid reply of the import program: {}",
                    path, e.what()));
  }
}

}  // namespace displayfile
