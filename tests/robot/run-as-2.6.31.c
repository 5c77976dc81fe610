// run-as-2.6.31 PROGRAM ARGUMENTS...: what 32-bit programs ask of the kernel is answered as Linux 2.6.31 would: calls
// and commands that came later do not exist, and uname says 2.6. Needs no root; programs that it starts inherit it.
//
// What it cannot show: calls that changed their meaning, drivers, and clocks that are read without a call (vDSO).
// Numbers: linux-2.6.31, arch/x86/include/asm/unistd_32.h, include/linux/{net,fcntl,prctl,time}.h.
#include <errno.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <unistd.h>

enum {
  kLastCall = 336,        // perf_counter_open
  kSocketCall = 102,      // one number for all of socket(), bind(), ...
  kLastSocketCall = 18,   // accept4
  kFcntl = 55,
  kFcntl64 = 221,
  kLastCommand = 14,      // F_SETLKW64; then a second range
  kFirstLinuxCommand = 1024,
  kLastLinuxCommand = 1026,   // F_NOTIFY
  kDuplicateOnExec = 1030,    // F_DUPFD_CLOEXEC
  kPrctl = 172,
  kLastPrctl = 32,            // PR_TASK_PERF_COUNTERS_ENABLE
  kNoNewPrivileges = 38,      // newer, but tests that watch system calls need it, and this program itself
  kTimerCreate = 259,
  kClockSettime = 264,
  kClockNanosleep = 267,
  kTimerfdCreate = 322,
  kLastClock = 4,             // CLOCK_MONOTONIC_RAW
};
#define CLOCK_OF_A_PROCESS 0x80000000U  // negative numbers are clocks of processes and threads

// The filter is a list of instructions on one accumulator; jumps count the instructions that they leave out.
#define LOAD(field) BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, field))
#define UNLESS(test, value, leave_out) BPF_JUMP(BPF_JMP | (test) | BPF_K, (value), 0, (leave_out))
#define IF(test, value, leave_out) BPF_JUMP(BPF_JMP | (test) | BPF_K, (value), (leave_out), 0)
#define FAIL(error) BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | (error))
#define ALLOW BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)

static struct sock_filter filter[] = {
    LOAD(arch), IF(BPF_JEQ, AUDIT_ARCH_I386, 1), ALLOW,  // the machine's own programs
    LOAD(nr), UNLESS(BPF_JGT, kLastCall, 1), FAIL(ENOSYS),

    UNLESS(BPF_JEQ, kSocketCall, 4),
    LOAD(args[0]), UNLESS(BPF_JGT, kLastSocketCall, 1), FAIL(EINVAL), ALLOW,

    IF(BPF_JEQ, kFcntl, 1), UNLESS(BPF_JEQ, kFcntl64, 7),
    LOAD(args[1]), IF(BPF_JEQ, kDuplicateOnExec, 4), IF(BPF_JGT, kLastLinuxCommand, 2),
    IF(BPF_JGE, kFirstLinuxCommand, 2), UNLESS(BPF_JGT, kLastCommand, 1), FAIL(EINVAL), ALLOW,

    UNLESS(BPF_JEQ, kPrctl, 5),
    LOAD(args[0]), IF(BPF_JEQ, kNoNewPrivileges, 2), UNLESS(BPF_JGT, kLastPrctl, 1), FAIL(EINVAL), ALLOW,

    IF(BPF_JEQ, kTimerCreate, 3), IF(BPF_JEQ, kTimerfdCreate, 2), UNLESS(BPF_JGE, kClockSettime, 6),
    IF(BPF_JGT, kClockNanosleep, 5),
    LOAD(args[0]), IF(BPF_JGE, CLOCK_OF_A_PROCESS, 2), UNLESS(BPF_JGT, kLastClock, 1), FAIL(EINVAL), ALLOW,

    ALLOW,
};

int main(int count, char** arguments) {
  const struct sock_fprog program = {sizeof filter / sizeof *filter, filter};
  if (count < 2) {
    fprintf(stderr, "usage: %s PROGRAM ARGUMENTS...\n", arguments[0]);
    return 2;
  }
  const int present = personality(0xFFFFFFFFUL);
  if (present == -1 || personality((unsigned long)present | UNAME26) == -1 ||
      prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) {
    fprintf(stderr, "run-as-2.6.31: this kernel filters no system calls (%s)\n", strerror(errno));
    return 1;
  }
  execvp(arguments[1], arguments + 1);
  fprintf(stderr, "run-as-2.6.31: cannot start %s: %s\n", arguments[1], strerror(errno));
  return 127;
}
