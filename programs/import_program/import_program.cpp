#include "programs/import_program/import_program.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <iostream>
#include <new>
#include <span>
#include <string>
#include <string_view>

#include "clip/base/error.h"
#include "displayfile/mesh/import_protocol.h"
#include "displayfile/mesh/mesh_reply.h"
#include "displayfile/mesh/neighbour_files.h"
#include "programs/import_program/confinement.h"

namespace displayfile {
namespace {

constexpr int kEndedAlready = 1;

/// If the waiting process has gone, the signal from the pipe ends this one.
void write_all(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(kReplyDescriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) _exit(kEndedAlready);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

std::size_t number(std::string_view word) {
  std::size_t value = 0;
  const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (failure != std::errc{} || end != word.data() + word.size()) {
    throw Error(fmt::format("'{}': expected a number", word));
  }
  return value;
}

/// Some of the library's readers catch what new throws and continue as if the file were invalid.
[[noreturn]] void end_hungry() { _exit(kOutOfMemoryStatus); }

double length(std::string_view word) {
  double value = 0.0;
  const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (failure != std::errc{} || end != word.data() + word.size()) {
    throw Error(fmt::format("'{}': expected a length", word));
  }
  return value;
}

struct Task {
  std::string path;
  bool with_normals;
  double deflection;
  std::size_t memory;
};

Mesh read_confined(const Task& task, const MeshReader& reader) {
  reader.load(task.path);
  confine(NeighbourFiles(task.path), task.path, task.memory);
  std::set_new_handler(end_hungry);
  return reader.read(task.path, task.with_normals, task.deflection);
}

void answer(const Task& task, const MeshReader& reader) {
  try {
    const Mesh mesh = read_confined(task, reader);
    std::fflush(nullptr);
    send_mesh(mesh, write_all);
  } catch (const Error& e) {
    send_refusal(e.what(), write_all);
  } catch (const std::bad_alloc&) {
    end_hungry();
  } catch (const std::exception& e) {  // an exception that a reader of the library did not catch
    send_refusal(fmt::format("{}: not a mesh that can be read: {}", task.path, e.what()),
                 write_all);
  }
}

}  // namespace

int read_for_waiting_process(int argc, char** argv, const MeshReader& reader) {
  const std::span words(argv, static_cast<std::size_t>(argc));
  if (argc != kImportArguments + 1 || words[1] != std::string_view(kImportProtocol)) {
    std::cerr << "this program is started by displayfile, of the same build\n";
    return kOtherProtocolStatus;
  }
  const auto waiting_process = static_cast<long>(number(words[2]));
  if (!begin_confinement(waiting_process, kReplyDescriptor + 1, number(words[4]))) {
    return kEndedAlready;
  }
  answer({words[7], words[5] == std::string_view("1"), length(words[6]), number(words[3])}, reader);
  _exit(0);  // freeing the library's memory would take longer than to end
}

}  // namespace displayfile
