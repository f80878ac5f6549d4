#include "programs/import_program/system_calls.h"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "displayfile/mesh/import_protocol.h"

namespace displayfile {

#if defined(__x86_64__)
#define DISPLAYFILE_AUDIT_ARCH AUDIT_ARCH_X86_64
#elif defined(__aarch64__) && defined(__AARCH64EL__)
#define DISPLAYFILE_AUDIT_ARCH AUDIT_ARCH_AARCH64
#elif defined(__i386__)
#define DISPLAYFILE_AUDIT_ARCH AUDIT_ARCH_I386
#endif

#ifdef DISPLAYFILE_AUDIT_ARCH

namespace {

/// A call that is allowed if the bits of its argument under the mask equal these.
struct Allowed {
  long call;
  unsigned argument = 0;
  std::uint32_t mask = 0, bits = 0;
};

constexpr std::uint32_t kWriting = O_ACCMODE | O_CREAT | O_TRUNC | O_APPEND;
constexpr std::uint32_t kAll = 0xFFFFFFFFu;

std::vector<Allowed> allowed_calls() {
  std::vector<Allowed> calls{
      // files
      {SYS_openat, 2, kWriting, O_RDONLY},
#ifdef SYS_open
      {SYS_open, 1, kWriting, O_RDONLY},
#endif
      {SYS_close},
      {SYS_read},
      {SYS_readv},
      {SYS_pread64},
      {SYS_lseek},
#ifdef SYS__llseek
      {SYS__llseek},
#endif
      {SYS_fstat},
#ifdef SYS_stat
      {SYS_stat},
      {SYS_lstat},
      {SYS_readlink},
      {SYS_access},
#endif
#ifdef SYS_newfstatat
      {SYS_newfstatat},
#endif
#ifdef SYS_fstat64
      {SYS_fstat64},
      {SYS_stat64},
      {SYS_lstat64},
      {SYS_fstatat64},
#endif
      {SYS_statx},
      {SYS_readlinkat},
      {SYS_faccessat},
#ifdef SYS_faccessat2
      {SYS_faccessat2},
#endif
      {SYS_getcwd},
      {SYS_statfs},  // the longest paths
      {SYS_fcntl, 1, kAll, F_GETFL},
      {SYS_fcntl, 1, kAll, F_GETFD},
      {SYS_fcntl, 1, kAll, F_SETFD},
#ifdef SYS_fcntl64
      {SYS_fcntl64, 1, kAll, F_GETFL},
      {SYS_fcntl64, 1, kAll, F_GETFD},
      {SYS_fcntl64, 1, kAll, F_SETFD},
#endif
      // on files that are open already
      {SYS_write},
      {SYS_writev},
      // memory
      {SYS_brk},
      {SYS_munmap},
      {SYS_mremap},
      {SYS_madvise},
      {SYS_mprotect, 2, PROT_EXEC, 0},
#ifdef SYS_mmap
      {SYS_mmap, 2, PROT_EXEC, 0},
#endif
#ifdef SYS_mmap2
      {SYS_mmap2, 2, PROT_EXEC, 0},
#endif
      // time, chance, the process itself
      {SYS_clock_gettime},
      {SYS_gettimeofday},
#ifdef SYS_time
      {SYS_time},
#endif
      {SYS_getrandom},
      {SYS_getpid},
      {SYS_gettid},
      {SYS_sysinfo},
      {SYS_prlimit64, 0, kAll, 0},  // its own, which cannot be raised
      {SYS_sched_yield},
      {SYS_futex},
      {SYS_rt_sigaction},
      {SYS_rt_sigprocmask},
      {SYS_rt_sigreturn},
      {SYS_sigaltstack},
      {SYS_restart_syscall},
      {SYS_tgkill, 0, kAll, static_cast<std::uint32_t>(getpid())},  // abort
      {SYS_exit},
      {SYS_exit_group},
  };
  if (kWatchesResidentMemory) {  // a sanitizer finds out by a pipe if memory can be read
    calls.push_back({SYS_pipe2});
#ifdef SYS_pipe
    calls.push_back({SYS_pipe});
#endif
  }
  return calls;
}

sock_filter statement(unsigned code, std::uint32_t value) {
  return {static_cast<std::uint16_t>(code), 0, 0, value};
}

/// Continues if equal; otherwise skips `skipped_if_not` statements.
sock_filter if_equal(std::uint32_t value, std::uint8_t skipped_if_not) {
  return {BPF_JMP | BPF_JEQ | BPF_K, 0, skipped_if_not, value};
}

sock_filter load(std::size_t offset) {
  return statement(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
}

/// The lower half of an argument: all that its flags have.
std::size_t offset_of_argument(unsigned argument) {
  constexpr bool kBigEndian = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;
  return offsetof(seccomp_data, args) + argument * sizeof(std::uint64_t) + (kBigEndian ? 4 : 0);
}

std::vector<sock_filter> filter_of(const std::vector<Allowed>& calls) {
  const sock_filter refuse = statement(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM);
  const sock_filter allow = statement(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  // Numbers are those of this processor's calls: others' are refused.
  std::vector<sock_filter> filter{load(offsetof(seccomp_data, arch)),
                                  if_equal(DISPLAYFILE_AUDIT_ARCH, 0)};
  filter.back().jt = 1;
  filter.push_back(refuse);
  for (const Allowed& allowed : calls) {
    filter.push_back(load(offsetof(seccomp_data, nr)));
    filter.push_back(if_equal(static_cast<std::uint32_t>(allowed.call), 4));
    filter.push_back(load(offset_of_argument(allowed.argument)));
    filter.push_back(statement(BPF_ALU | BPF_AND | BPF_K, allowed.mask));
    filter.push_back(if_equal(allowed.bits, 1));
    filter.push_back(allow);
  }
  filter.push_back(refuse);
  return filter;
}

}  // namespace

bool allow_reading_calls_only() {
  std::vector<sock_filter> filter = filter_of(allowed_calls());
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

#else

bool allow_reading_calls_only() { return false; }

#endif

}  // namespace displayfile
