#include "programs/import_program/confinement.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "clip/base/error.h"
#include "displayfile/mesh/import_protocol.h"
#include "programs/import_program/system_calls.h"

#if __has_include(<linux/landlock.h>) && defined(SYS_landlock_create_ruleset)
#include <linux/landlock.h>
#define DISPLAYFILE_LANDLOCK
#endif
#include <csignal>

namespace displayfile {

namespace {

/// Lowers the maximum of a limit to `most` if it is above that.
void lower_limit(int resource, rlim_t most) {
  rlimit limit{};
  if (getrlimit(static_cast<decltype(RLIMIT_AS)>(resource), &limit) != 0) return;
  limit.rlim_max = std::min(limit.rlim_max, most);
  limit.rlim_cur = std::min(limit.rlim_cur, limit.rlim_max);
  setrlimit(static_cast<decltype(RLIMIT_AS)>(resource), &limit);
}

/// Raises a limit to its maximum: the inherited one is the waiting process's own (LentMemory).
void raise_limit(int resource) {
  rlimit limit{};
  if (getrlimit(static_cast<decltype(RLIMIT_AS)>(resource), &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(static_cast<decltype(RLIMIT_AS)>(resource), &limit);
}

void close_from(int first) {
#ifdef SYS_close_range
  if (syscall(SYS_close_range, first, ~0u, 0u) == 0) return;
#endif
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  constexpr rlim_t kMost = 1 << 20;
  const auto end = static_cast<int>(std::min(limit.rlim_cur, kMost));
  for (int descriptor = first; descriptor < end; ++descriptor) close(descriptor);
}

/// The size of the address space, in bytes.
std::size_t size_now() {
  std::ifstream pages("/proc/self/statm");
  std::size_t size = 0;
  pages >> size;
  return size * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

bool limit_memory(std::size_t bytes) {
  if (kWatchesResidentMemory) return false;
  const std::size_t now = size_now();
  const std::size_t most = std::numeric_limits<std::size_t>::max() - bytes < now
                               ? std::numeric_limits<std::size_t>::max()
                               : now + bytes;
  lower_limit(RLIMIT_AS, most);
  rlimit limit{};
  return getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur <= most;
}

#ifdef DISPLAYFILE_LANDLOCK

/// All that this version of Landlock can forbid, in the order of its versions.
std::uint64_t file_rights(long version) {
  std::uint64_t rights = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;
#ifdef LANDLOCK_ACCESS_FS_REFER
  if (version >= 2) rights |= LANDLOCK_ACCESS_FS_REFER;
#endif
#ifdef LANDLOCK_ACCESS_FS_TRUNCATE
  if (version >= 3) rights |= LANDLOCK_ACCESS_FS_TRUNCATE;
#endif
  return rights;
}

bool allow_beneath(long rules, const std::filesystem::path& path, std::uint64_t rights) {
  const int opened = open(path.c_str(), O_PATH | O_CLOEXEC);
  if (opened < 0) return false;
  const landlock_path_beneath_attr beneath{rights, opened};
  const bool added =
      syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &beneath, 0u) == 0;
  close(opened);
  return added;
}

bool allow_neighbours_only(const NeighbourFiles& neighbours, const std::string& mesh) {
  const long version =
      syscall(SYS_landlock_create_ruleset, nullptr, 0u, LANDLOCK_CREATE_RULESET_VERSION);
  if (version < 1) return false;
  landlock_ruleset_attr attributes{};
  attributes.handled_access_fs = file_rights(version);
  const long rules =
      syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes.handled_access_fs, 0u);
  if (rules < 0) return false;
  const bool enforced = allow_beneath(rules, neighbours.folder(),
                                      LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR) &&
                        allow_beneath(rules, mesh, LANDLOCK_ACCESS_FS_READ_FILE) &&
                        prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
                        syscall(SYS_landlock_restrict_self, rules, 0u) == 0;
  const int failure = errno;
  close(static_cast<int>(rules));
  if (!enforced) {
    throw Error(fmt::format("{}: the import program cannot be confined to its neighbours: {}", mesh,
                            std::strerror(failure)));
  }
  return true;
}

#else

bool allow_neighbours_only(const NeighbourFiles&, const std::string&) { return false; }

#endif

}  // namespace

bool begin_confinement(long waiting_process, int descriptors, std::size_t seconds) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != waiting_process) return false;  // it ended before that
  prctl(PR_SET_DUMPABLE, 0);
  close_from(descriptors);
  raise_limit(RLIMIT_DATA);
  constexpr rlim_t kOpenFiles = 64;
  lower_limit(RLIMIT_CORE, 0);
  lower_limit(RLIMIT_FSIZE, 0);
  lower_limit(RLIMIT_NOFILE, kOpenFiles);
  lower_limit(RLIMIT_CPU, static_cast<rlim_t>(seconds) + 1);
  return true;
}

Enforced confine(const NeighbourFiles& neighbours, const std::string& mesh, std::size_t bytes) {
  Enforced enforced;
  enforced.memory = limit_memory(bytes);
  enforced.files = allow_neighbours_only(neighbours, mesh);
  enforced.calls = allow_reading_calls_only();
  return enforced;
}

}  // namespace displayfile
