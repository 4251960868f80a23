// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cerrno>
#include <cstddef>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "command/learn/confined_process.hpp"

namespace magicmass::command {
namespace {

#if defined(__x86_64__)
constexpr std::uint32_t own_architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t own_architecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t own_architecture = 0;
#endif

constexpr std::uint32_t first_foreign_call = 0x40000000;  // x32 has its numbers from here on
constexpr std::uint32_t write_flags = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC | O_APPEND;

constexpr std::array forbidden {
#if defined(__x86_64__)  // where newer architectures have the ...at calls alone
  SYS_fork, SYS_vfork, SYS_creat, SYS_unlink, SYS_rename, SYS_mkdir, SYS_rmdir, SYS_link,
      SYS_symlink, SYS_chmod, SYS_chown, SYS_lchown, SYS_mknod, SYS_utime, SYS_utimes,
      SYS_futimesat,
#endif
      SYS_clone, SYS_clone3, SYS_openat2, SYS_unlinkat, SYS_renameat2, SYS_renameat, SYS_mkdirat,
      SYS_linkat, SYS_symlinkat, SYS_fchmodat, SYS_fchownat, SYS_mknodat, SYS_utimensat,
      SYS_truncate, SYS_fchmod, SYS_fchown, SYS_setxattr, SYS_lsetxattr, SYS_fsetxattr,
      SYS_removexattr, SYS_lremovexattr, SYS_fremovexattr, SYS_kill, SYS_tkill, SYS_rt_sigqueueinfo,
      SYS_rt_tgsigqueueinfo, SYS_pidfd_send_signal, SYS_pidfd_getfd, SYS_setpriority, SYS_setsid,
      SYS_setpgid, SYS_ptrace, SYS_process_vm_writev, SYS_socket, SYS_socketpair,
      SYS_io_uring_setup, SYS_bpf, SYS_mount, SYS_unshare, SYS_keyctl, SYS_msgget, SYS_shmget,
      SYS_semget
};

constexpr std::uint32_t offset_of_argument(unsigned index) {  // its low half, little-endian
  return static_cast<std::uint32_t>(offsetof(seccomp_data, args)) + 8 * index;
}

sock_filter load(std::uint32_t offset) { return BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offset); }
sock_filter answer(std::uint32_t action) { return BPF_STMT(BPF_RET | BPF_K, action); }

/// Unless the loaded word passes the test, the next `count` instructions are skipped.
sock_filter unless_skip(unsigned test, std::uint32_t value, unsigned count) {
  return BPF_JUMP(static_cast<unsigned short>(BPF_JMP | test | BPF_K), value, 0,
                  static_cast<unsigned char>(count));
}

/// Kills where the call would open a file for writing.
void add_open(std::vector<sock_filter>& program, long call, unsigned flags_index) {
  program.push_back(unless_skip(BPF_JEQ, static_cast<std::uint32_t>(call), 4));
  program.push_back(load(offset_of_argument(flags_index)));
  program.push_back(unless_skip(BPF_JSET, write_flags, 1));
  program.push_back(answer(SECCOMP_RET_KILL_PROCESS));
  program.push_back(answer(SECCOMP_RET_ALLOW));
}

/// Kills where the call's first argument, a process, is another one. Returns where that process stands.
std::size_t add_own(std::vector<sock_filter>& program, long call, std::uint32_t process) {
  program.push_back(unless_skip(BPF_JEQ, static_cast<std::uint32_t>(call), 4));
  program.push_back(load(offset_of_argument(0)));
  program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, process, 1, 0));
  const std::size_t place = program.size() - 1;
  program.push_back(answer(SECCOMP_RET_KILL_PROCESS));
  program.push_back(answer(SECCOMP_RET_ALLOW));
  return place;
}

/// Instructions, of which one names the process itself.
struct Filter {
  std::vector<sock_filter> program;
  std::size_t own_process = 0;
};

Filter made_filter() {
  std::vector<sock_filter> program{load(offsetof(seccomp_data, arch)),
                                   BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, own_architecture, 1, 0),
                                   answer(SECCOMP_RET_KILL_PROCESS),
                                   load(offsetof(seccomp_data, nr)),
                                   unless_skip(BPF_JGE, first_foreign_call, 1),
                                   answer(SECCOMP_RET_KILL_PROCESS)};
  for (const long call : forbidden) {
    program.push_back(unless_skip(BPF_JEQ, static_cast<std::uint32_t>(call), 1));
    program.push_back(answer(SECCOMP_RET_KILL_PROCESS));
  }
#if defined(__x86_64__)
  add_open(program, SYS_open, 1);
#endif
  add_open(program, SYS_openat, 2);
  // abort() sends itself a signal, and getrlimit() asks for its own limits: nobody else's
  const std::size_t own_process = add_own(program, SYS_tgkill, 0);
  add_own(program, SYS_prlimit64, 0);
  program.push_back(answer(SECCOMP_RET_ALLOW));
  return {std::move(program), own_process};
}

/// Made once, before the first fork: a child has no business with memory.
Filter& filter() {
  static Filter once = made_filter();
  return once;
}

}  // namespace

// The kernel's own test: the filter at null is not looked for where there are no filters.
bool can_allow_computing_only() {
  filter();
  return own_architecture != 0 && ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, nullptr) == -1 &&
         errno == EFAULT;
}

bool allow_computing_only() {
  if (own_architecture == 0) return false;
  auto& [instructions, own_process] = filter();
  instructions[own_process].k = static_cast<std::uint32_t>(::getpid());
  const sock_fprog program{static_cast<unsigned short>(instructions.size()), instructions.data()};
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

}  // namespace magicmass::command
