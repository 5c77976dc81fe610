// Files that a user may name by mistake where settings are expected.
#include "hal/text_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <type_traits>

#include "hal/descriptor.hpp"
#include "hal/write_text_file.hpp"
#include "support/temporary_folder.hpp"
#include "support/unprivileged.hpp"

namespace darwinop::settings {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class TextFile : public testing::Test {
 protected:
  /// The sentence; empty: it was read.
  static std::string refusal(const std::string& path) {
    try {
      (void)readTextFile(path);
      return {};
    } catch (const std::runtime_error& refused) {
      return refused.what();
    }
  }
  [[nodiscard]] std::string written(std::size_t bytes) const {
    const std::string path = folder_ / "settings.ini";
    std::ofstream{path} << std::string(bytes, '#');
    return path;
  }

  TemporaryFolder folder_;
};

TEST_F(TextFile, IsReadWholeUpToItsLimit) {
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, std::size_t{4096}, kLongestTextFile}) {
    const auto text = readTextFile(written(bytes));
    ASSERT_TRUE(text.has_value());
    EXPECT_EQ(text->size(), bytes);
  }
}

TEST_F(TextFile, OneByteTooLongIsRefused) {
  EXPECT_THAT(refusal(written(kLongestTextFile + 1)), HasSubstr("1048576"));
}

TEST_F(TextFile, ThatIsAbsentIsNotAnError) {
  EXPECT_FALSE(readTextFile(folder_ / "nothing").has_value());
}

TEST_F(TextFile, ThatHasNoEndIsRefusedBeforeItIsRead) {
  for (const char* const device : {"/dev/zero", "/dev/urandom"})
    EXPECT_THAT(refusal(device), AllOf(HasSubstr(std::string{device} + ": "), HasSubstr("device")));
}

TEST_F(TextFile, APipeWithoutAWriterIsRefusedAtOnce) {
  const std::string path = folder_ / "fifo";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  EXPECT_THAT(refusal(path), AllOf(HasSubstr(path + ": "), HasSubstr("pipe")));
}

TEST_F(TextFile, AFolderIsRefused) {
  EXPECT_THAT(refusal(folder_ / "."), HasSubstr("folder"));
}

static_assert(!std::is_copy_constructible_v<Descriptor>, "a copy would close it a second time");

TEST_F(TextFile, OfNothingIsEmpty) {
  EXPECT_EQ(readTextFile("/dev/null"), "");
}

TEST(WriteTextFile, ReplacesTheContentAndNamesPathAndReasonWhereItCannot) {
  const TemporaryFolder folder;
  writeTextFile(folder / "a.txt", "a longer text\n");
  writeTextFile(folder / "a.txt", "short\n");
  EXPECT_EQ(readTextFile(folder / "a.txt"), "short\n");
  EXPECT_THAT([&] { writeTextFile(folder / "a.txt/b", ""); },
              testing::ThrowsMessage<std::runtime_error>(
                  testing::HasSubstr((folder / "a.txt/b") + ": " + std::strerror(ENOTDIR))));
  EXPECT_THAT([] { writeTextFile("/dev/full", "no room"); },
              testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr(std::strerror(ENOSPC))));
}

TEST(WriteTextFile, WhereThereIsNoRoomTheOldFileStays) {
  const TemporaryFolder folder;
  writeTextFile(folder / "a.txt", "old");
  ASSERT_EQ(symlink("a.txt", (folder / "link").c_str()), 0);
  ASSERT_EQ(chmod((folder / "a.txt").c_str(), 0640), 0);
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    // setrlimit() of the C library asks with prlimit64, which Linux 2.6.31 does not have.
    const std::array<unsigned long, 2> most{10, 10};  // bytes
    if (syscall(SYS_setrlimit, RLIMIT_FSIZE, most.data()) != 0) _exit(8);
    try {
      writeTextFile(folder / "link", std::string(100, 'x'));
    } catch (const std::runtime_error&) {
      _exit(7);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_EQ(readTextFile(folder / "a.txt"), "old");
  writeTextFile(folder / "link", "new");
  EXPECT_EQ(readTextFile(folder / "a.txt"), "new") << "a link stays one";
  struct stat now {};
  ASSERT_EQ(stat((folder / "a.txt").c_str(), &now), 0);
  EXPECT_EQ(now.st_mode & 0777, 0640U);
}

struct WriteUnprivileged : testing::Test {
  void SetUp() override {
    if (geteuid() != 0) return;
    ASSERT_EQ(chown((folder / ".").c_str(), Unprivileged::kUser, Unprivileged::kUser), 0);
  }
  static mode_t modeOf(const std::string& path) {
    struct stat about {};
    return stat(path.c_str(), &about) == 0 ? about.st_mode & 0777 : 0;
  }
  TemporaryFolder folder;
};

TEST_F(WriteUnprivileged, AProtectedFileIsRefused) {
  const Unprivileged user;
  writeTextFile(folder / "a.txt", "old");
  ASSERT_EQ(chmod((folder / "a.txt").c_str(), 0444), 0);
  EXPECT_THAT([&] { writeTextFile(folder / "a.txt", "new"); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr(std::strerror(EACCES))));
  EXPECT_EQ(readTextFile(folder / "a.txt"), "old");
}

TEST_F(WriteUnprivileged, ANewFileHasTheRightsThatTheUmaskLeaves) {
  const Unprivileged user;
  for (const mode_t mask : {077U, 022U, 002U}) {
    const mode_t before = umask(mask);
    writeTextFile(folder / "new.txt", "text");
    EXPECT_EQ(umask(before), mask);
    EXPECT_EQ(modeOf(folder / "new.txt"), 0666 & ~mask);
    unlink((folder / "new.txt").c_str());
  }
}

TEST(WriteTextFile, WhatIsAlreadyOpenIsWrittenInto) {
  const TemporaryFolder folder;
  std::FILE* log = std::fopen((folder / "log").c_str(), "ae");
  ASSERT_NE(log, nullptr);
  for (const std::string place : {"/dev/fd/", "/proc/self/fd/"}) {
    writeTextFile(place + std::to_string(fileno(log)), "text\n");
    std::fputs("later\n", log);
    std::fflush(log);
    EXPECT_EQ(readTextFile(folder / "log"), "text\nlater\n");
  }
  std::fclose(log);
}

/// As in a container that was given a single file.
TEST(WriteTextFile, AFileThatIsAMountPointIsWrittenInto) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.txt";
  writeTextFile(path, "old");
  const pid_t child = fork();
  if (child == 0) {
    if (unshare(CLONE_NEWNS) != 0 || mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        mount(path.c_str(), path.c_str(), nullptr, MS_BIND, nullptr) != 0)
      _exit(77);
    try {
      writeTextFile(path, "new");
    } catch (const std::runtime_error&) {
      _exit(1);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WEXITSTATUS(status) == 77) GTEST_SKIP() << "this user may not mount";
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(readTextFile(path), "new");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator{folder / "."}, {}), 1) << "nothing is left beside it";
}

}  // namespace
}  // namespace darwinop::settings
