// old_kernel_probe old|today: asks the kernel for what came after 2.6.31 and for what was there, and ends with 0 when
// each is answered as expected.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/utsname.h>
#include <time.h>
#include <unistd.h>

static int failures = 0;

/// `result` is a system call's; `error` is what it shall fail with, 0 for success.
static void expect(const char* what, long result, int error) {
  const int got = result == -1 ? errno : 0;
  if (got == error) return;
  ++failures;
  printf("%s: %s, expected: %s\n", what, strerror(got), strerror(error));
}

int main(int count, char** arguments) {
  const int old = count == 2 && strcmp(arguments[1], "old") == 0;
  struct rlimit limit;
  unsigned long limits64[4];
  struct timespec time;
  struct flock64 lock = {.l_type = F_RDLCK, .l_whence = SEEK_SET};  // keep-word
  char name[16];
  int child_subreaper;
  struct utsname system;

  // Newer than 2.6.31: 2.6.33, 2.6.36, 3.2, 5.1 as calls of their own; 3.15, 3.4, 2.6.39 as commands of old calls.
  const int gone = old ? ENOSYS : 0, unknown = old ? EINVAL : 0;
  expect("recvmmsg, by number", syscall(SYS_recvmmsg, -1, 0, 0, 0, 0), old ? ENOSYS : EBADF);
  expect("prlimit64", syscall(SYS_prlimit64, 0, RLIMIT_NOFILE, 0, limits64), gone);
  expect("process_vm_readv", syscall(SYS_process_vm_readv, getpid(), 0, 0, 0, 0, 0), gone);
  expect("clock_gettime64", syscall(SYS_clock_gettime64, CLOCK_MONOTONIC, limits64), gone);
  const unsigned long message[5] = {(unsigned long)-1, 0, 0, 0, 0};
  expect("recvmmsg, through socketcall", syscall(SYS_socketcall, 19, message), old ? EINVAL : EBADF);
  const int file = open("/proc/self/exe", O_RDONLY);
  expect("fcntl F_OFD_GETLK", syscall(SYS_fcntl64, file, F_OFD_GETLK, &lock), unknown);
  expect("fcntl F_GETPIPE_SZ", syscall(SYS_fcntl64, file, F_GETPIPE_SZ), old ? EINVAL : EBADF);
  expect("prctl PR_GET_CHILD_SUBREAPER", prctl(PR_GET_CHILD_SUBREAPER, &child_subreaper, 0, 0, 0), unknown);
  expect("clock_gettime CLOCK_BOOTTIME", syscall(SYS_clock_gettime, CLOCK_BOOTTIME, &time), unknown);

  // There since long.
  expect("getrlimit", getrlimit(RLIMIT_NOFILE, &limit), 0);
  expect("socketcall socket", close(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)), 0);
  expect("fcntl F_GETFD", fcntl(file, F_GETFD), 0);
  lock.l_type = F_RDLCK;  // the answer before was written into it
  expect("fcntl F_GETLK64", syscall(SYS_fcntl64, file, F_GETLK64, &lock), 0);
  expect("fcntl F_DUPFD_CLOEXEC", close(fcntl(file, F_DUPFD_CLOEXEC, 10)), 0);
  expect("fcntl F_GETLEASE", fcntl(file, F_GETLEASE) == F_UNLCK ? 0 : -1, 0);
  expect("prctl PR_GET_NAME", prctl(PR_GET_NAME, name, 0, 0, 0), 0);
  expect("clock_gettime", syscall(SYS_clock_gettime, CLOCK_MONOTONIC, &time), 0);
  expect("clock of this thread", syscall(SYS_clock_gettime, CLOCK_THREAD_CPUTIME_ID, &time), 0);
  expect("clock of this process, by its number", syscall(SYS_clock_gettime, (clockid_t)(~getpid() << 3 | 2), &time), 0);
  expect("uname", uname(&system), 0);
  const int says_old = strncmp(system.release, "2.6.", 4) == 0;
  if (says_old != old) printf("uname says %s\n", system.release);
  return failures == 0 && says_old == old ? 0 : 1;
}
