// What a forked child has of a descriptor that it must not share.
#include "hal/fork_guard.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "hal/descriptor.hpp"

namespace darwinop {
namespace {

bool isNothing(int fd) {
  struct stat here {
  }, nothing{};
  return fstat(fd, &here) == 0 && stat("/dev/null", &nothing) == 0 && here.st_rdev == nothing.st_rdev;
}

bool isNothingInAChild(int fd) {
  const pid_t child = fork();
  if (child == 0) _exit(isNothing(fd) ? 1 : 0);
  int status = 0;
  waitpid(child, &status, 0);
  return WEXITSTATUS(status) == 1;
}

TEST(ForkGuard, AChildHasTheNullDeviceInstead) {
  const Descriptor file{open("/", O_RDONLY | O_CLOEXEC)};
  guardFromForks(file.fd());
  EXPECT_TRUE(isNothingInAChild(file.fd()));
  EXPECT_TRUE(isNothingInAChild(file.fd())) << "the next one too";
  EXPECT_FALSE(isNothing(file.fd())) << "the parent keeps it";
  unguardFromForks(file.fd());
  EXPECT_FALSE(isNothingInAChild(file.fd()));
}

TEST(ForkGuard, NoDescriptorAndALargeOneAreIgnored) {
  for (const int fd : {-1, 1 << 20}) {
    guardFromForks(fd);
    unguardFromForks(fd);
  }
}

}  // namespace
}  // namespace darwinop
