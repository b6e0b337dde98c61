#include "render/reader/confine.h"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <malloc.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <vector>

namespace crest {
namespace {

#if defined(__x86_64__)
constexpr unsigned architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned architecture = AUDIT_ARCH_AARCH64;
#else
constexpr unsigned architecture = 0;
#endif

/// System calls that fail with EPERM.
constexpr unsigned refused[] = {
    // the network
    SYS_socket,
    SYS_socketpair,
    SYS_connect,
    SYS_bind,
    SYS_listen,
    // other programs
    SYS_execve,
    SYS_execveat,
    SYS_kill,
    SYS_ptrace,
    SYS_process_vm_readv,
    SYS_process_vm_writev,
    SYS_pidfd_open,
    SYS_pidfd_send_signal,
    SYS_tkill,
    SYS_rt_sigqueueinfo,
    SYS_rt_tgsigqueueinfo,
    SYS_ioprio_set,
    SYS_shmget,
    SYS_shmat,
    SYS_mq_open,
    // files that others see
    SYS_unlinkat,
    SYS_renameat2,
    SYS_mkdirat,
    SYS_linkat,
    SYS_symlinkat,
    SYS_mknodat,
    SYS_truncate,
    SYS_ftruncate,
    SYS_fchmod,
    SYS_fchmodat,
    SYS_fchown,
    SYS_fchownat,
    SYS_utimensat,
    SYS_setxattr,
    SYS_fsetxattr,
    SYS_lsetxattr,
    SYS_removexattr,
    SYS_fremovexattr,
    SYS_lremovexattr,
    452,  // fchmodat2, setxattrat and removexattrat, newer than some systems' headers
    463,
    466,
    SYS_mount,
    SYS_umount2,
    SYS_open_by_handle_at,
    // the kernel's wider doors
    SYS_bpf,
    SYS_perf_event_open,
    SYS_userfaultfd,
    SYS_keyctl,
    SYS_add_key,
    SYS_request_key,
    SYS_io_uring_setup,
#ifdef __x86_64__
    SYS_fork,
    SYS_vfork,
    SYS_creat,
    SYS_unlink,
    SYS_rename,
    SYS_renameat,
    SYS_mkdir,
    SYS_rmdir,
    SYS_link,
    SYS_symlink,
    SYS_mknod,
    SYS_chmod,
    SYS_chown,
    SYS_lchown,
    SYS_utime,
    SYS_utimes,
#endif
};

/// A classic BPF program (seccomp(2)) in the order of its checks.
class Filter {
 public:
  Filter() {
    load(offsetof(seccomp_data, arch));
    jump(BPF_JEQ, architecture, 1, 0);
    answer(SECCOMP_RET_ALLOW);  // not what it was made for: the limits have to do
    load_call();
    constexpr unsigned x32 = 0x40000000;  // another numbering of the same calls
    jump(BPF_JGE, x32, 0, 1);
    answer(SECCOMP_RET_ERRNO | ENOSYS);
    for (const unsigned call : refused) refuse(call, EPERM);
    // Whose arguments lie in memory, where a filter cannot look; libraries then use the older ones.
    refuse(SYS_clone3, ENOSYS);
    refuse(SYS_openat2, ENOSYS);
    constexpr unsigned writes = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC;
    refuse_with(SYS_openat, 2, BPF_JSET, writes, true);
#ifdef __x86_64__
    refuse_with(SYS_open, 1, BPF_JSET, writes, true);
#endif
    refuse_with(SYS_clone, 0, BPF_JSET, CLONE_THREAD, false);  // threads may be
    // Typing into a terminal.
    refuse_with(SYS_ioctl, 1, BPF_JEQ, TIOCSTI, true);
    refuse_with(SYS_ioctl, 1, BPF_JEQ, TIOCLINUX, true);
    // Others' limits, places and ranks; itself it may end, by abort().
    for (const unsigned call : {SYS_prlimit64, SYS_sched_setaffinity, SYS_sched_setscheduler,
                                SYS_sched_setparam, SYS_sched_setattr})
      refuse_with(call, 0, BPF_JEQ, 0, false);
    refuse_with(SYS_setpriority, 0, BPF_JEQ, PRIO_USER, true);
    refuse_with(SYS_setpriority, 1, BPF_JEQ, 0, false);
    refuse_with(SYS_tgkill, 0, BPF_JEQ, unsigned(::getpid()), false);
    answer(SECCOMP_RET_ALLOW);
  }

  void install() {
    const sock_fprog program{static_cast<unsigned short>(code_.size()), code_.data()};
    ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
  }

 private:
  void load_call() { load(offsetof(seccomp_data, nr)); }
  void load(std::size_t offset) { code_.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, unsigned(offset))); }
  void answer(unsigned what) { code_.push_back(BPF_STMT(BPF_RET | BPF_K, what)); }
  /// Leaps over so many.
  void jump(int test, unsigned value, int if_true, int if_false) {
    code_.push_back(BPF_JUMP(static_cast<unsigned short>(BPF_JMP | test | BPF_K), value,
                             static_cast<unsigned char>(if_true), static_cast<unsigned char>(if_false)));
  }
  void refuse(unsigned call, unsigned fault) {
    jump(BPF_JEQ, call, 0, 1);
    answer(SECCOMP_RET_ERRNO | fault);
  }
  /// Where the test of an argument's lower half comes out as `is`.
  void refuse_with(unsigned call, std::size_t argument, int test, unsigned value, bool is) {
    jump(BPF_JEQ, call, 0, 4);
    load(offsetof(seccomp_data, args) + argument * sizeof(__u64));  // both are little-endian
    jump(test, value, is ? 0 : 1, is ? 1 : 0);
    answer(SECCOMP_RET_ERRNO | EPERM);
    load_call();  // for the next check
  }

  std::vector<sock_filter> code_;
};

void limit(__rlimit_resource resource, rlim_t most) {
  const rlimit limits{most, most};
  ::setrlimit(resource, &limits);
}

}  // namespace

void confine() {
  ::setsid();  // away from the terminal
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::mallopt(M_ARENA_MAX, 2);  // each thread's own would take 64 MB of the address space
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_NOFILE, 256);
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0) Filter().install();
}

}  // namespace crest
