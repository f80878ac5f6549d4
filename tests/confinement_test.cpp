// The confinement of the import program before it reads a mesh, tried in processes of their own.

#include "programs/import_program/confinement.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <functional>
#include <string>
#include <thread>

#include "clip/base/error.h"
#include "displayfile/mesh/import_protocol.h"
#include "displayfile/mesh/neighbour_files.h"
#include "tests/temporary_folder.h"

namespace displayfile {
namespace {

constexpr int kNotEnforced = 99;  // by this kernel

class Confinement : public test::TemporaryFolder {
 protected:
  /// The status of a confined process that does this.
  int tried(const std::function<int(const Enforced&)>& act) const {
    const std::string mesh = file("m.x", "mesh").string();
    const pid_t waiting = getpid(), child = fork();
    if (child == 0) {
      if (!begin_confinement(waiting, kReplyDescriptor + 1, 10)) _exit(90);
      try {
        _exit(act(confine(NeighbourFiles(mesh), mesh, std::size_t{64} << 20)));
      } catch (const Error&) {
        _exit(91);
      }
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  }

  /// 0 if the call is refused.
  static int refused(long result) { return result < 0 && errno == EPERM ? 0 : 1; }
};

TEST_F(Confinement, HasNoNetworkNoProcessesNoProgramsAndNoSignalsToOthers) {
  const auto calls = [&](auto&& call) {
    const int status = tried(
        [&](const Enforced& enforced) { return enforced.calls ? refused(call()) : kNotEnforced; });
    EXPECT_TRUE(status == 0 || status == kNotEnforced) << status;
    return status;
  };
  const pid_t test = getpid();
  const auto socket_of = [](int family) { return socket(family, SOCK_STREAM, 0); };
  if (calls([&] { return socket_of(AF_INET); }) == kNotEnforced) {
    GTEST_SKIP() << "this kernel or processor has no filter of system calls";
  }
  calls([&] { return socket_of(AF_INET6); });
  calls([&] { return socket_of(AF_UNIX); });
  calls([] { return syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0); });
  calls([] {
    char name[] = "/bin/true";
    char* const words[] = {name, nullptr};
    return static_cast<long>(execv(name, words));
  });
  calls([&] { return static_cast<long>(kill(test, SIGTERM)); });
  calls([&] { return syscall(SYS_tgkill, test, test, SIGTERM); });
  calls([] { return syscall(SYS_ptrace, 0, 0, 0, 0); });
  calls([&] { return syscall(SYS_prlimit64, test, RLIMIT_CPU, nullptr, nullptr); });
  calls([] { return syscall(SYS_fcntl, 0, F_SETOWN, 1); });
  calls([] {
    void* const memory =
        mmap(nullptr, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return memory == MAP_FAILED ? -1L : 0L;
  });
  calls([&] { return static_cast<long>(unlink((folder_ / "m.x").c_str())); });
  calls([&] { return static_cast<long>(open((folder_ / "m.x").c_str(), O_WRONLY)); });
  calls([&] { return static_cast<long>(open((folder_ / "n").c_str(), O_CREAT | O_RDONLY, 0600)); });
  EXPECT_EQ(test::content(folder_ / "m.x"), "mesh");
}

TEST_F(Confinement, OpensNeighboursAlone) {
  const auto can_open = [](const std::filesystem::path& path) {
    return open(path.c_str(), O_RDONLY) >= 0;
  };
  file("beside", "x");
  const int status = tried([&](const Enforced& enforced) {
    if (!can_open(folder_ / "m.x") || !can_open(folder_ / "beside")) return 1;
    if (!enforced.files) return kNotEnforced;
    return can_open("/etc/passwd") || can_open(folder_.parent_path()) ? 2 : 0;
  });
  if (status == kNotEnforced) GTEST_SKIP() << "this kernel has no Landlock";
  EXPECT_EQ(status, 0);
}

TEST_F(Confinement, HasNoMoreMemoryThanItIsGiven) {
  const auto can_have = [](std::size_t bytes) {
    return mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) !=
           MAP_FAILED;
  };
  const int status = tried([&](const Enforced& enforced) {
    if (!enforced.memory) return kNotEnforced;
    if (!can_have(std::size_t{32} << 20)) return 1;
    return can_have(std::size_t{64} << 20) ? 2 : 0;
  });
  EXPECT_EQ(status, kWatchesResidentMemory ? kNotEnforced : 0);
}

TEST_F(Confinement, LeavesNoCoreAndNoOtherDescriptors) {
  const int before = open("/dev/null", O_RDONLY);
  const int moved = fcntl(before, F_DUPFD, 40);  // not closed by programs
  const int status = tried([&](const Enforced&) {
    rlimit core{}, size{};
    getrlimit(RLIMIT_CORE, &core);
    getrlimit(RLIMIT_FSIZE, &size);
    if (core.rlim_max != 0 || size.rlim_max != 0) return 1;
    return fcntl(moved, F_GETFD) < 0 && errno == EBADF ? 0 : 2;
  });
  EXPECT_EQ(status, 0);
  close(before);
  close(moved);
}

/// A process ends if no other waits for it: its parent has ended already, or ends later.
TEST_F(Confinement, EndsWithTheProcessThatWaits) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t waiting = fork();
  if (waiting == 0) {
    const pid_t own = getpid();
    if (fork() == 0) {
      if (begin_confinement(own, ends[1] + 1, 10)) {
        const char ready = 'r';
        if (write(ends[1], &ready, 1) == 1) sleep(60);
      }
      _exit(0);
    }
    for (;;) pause();
  }
  close(ends[1]);
  char ready = 0;
  EXPECT_EQ(read(ends[0], &ready, 1), 1);
  kill(waiting, SIGKILL);
  waitpid(waiting, nullptr, 0);
  EXPECT_EQ(read(ends[0], &ready, 1), 0) << "its end of the pipe is closed";
  close(ends[0]);
  const pid_t orphan = fork();
  if (orphan == 0) _exit(begin_confinement(1, kReplyDescriptor + 1, 10) ? 1 : 0);
  int status = 0;
  waitpid(orphan, &status, 0);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace displayfile
