// Locks between processes: one holder, named, freed by its death.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "child.hpp"
#include "other_user.hpp"
#include "runtime/file_lock.hpp"
#include "runtime/messages.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"

namespace darwinop::runtime {
namespace {

TEST(FileLock, HasOneHolderAndNamesIt) {
  const TemporaryFolder folder;
  EXPECT_EQ(FileLock::holder(folder / "lock"), 0);
  const Child other{[&] { static const auto lock = FileLock::tryTake(folder / "lock"); }};
  EXPECT_FALSE(FileLock::tryTake(folder / "lock").has_value());
  EXPECT_EQ(FileLock::holder(folder / "lock"), other.pid());
}

TEST(FileLock, IsFreeAgainWhenItsHolderIsKilled) {
  const TemporaryFolder folder;
  Child other{[&] { static const auto lock = FileLock::tryTake(folder / "lock"); }};
  other.kill(SIGKILL);
  EXPECT_EQ(FileLock::holder(folder / "lock"), 0) << "the name in the file counts for nothing without the lock";
  EXPECT_TRUE(FileLock::tryTake(folder / "lock").has_value());
}

/// Forks a process that sleeps; its id is written to the file.
void forkSleeper(const std::string& file) {
  static const Child sleeper{[] {}};
  std::ofstream{file} << sleeper.pid();
}

TEST(FileLock, IsFreeAgainWhenItsHolderIsKilledAfterItHasForked) {
  const TemporaryFolder folder;
  Child other{[&] {
    static const auto lock = FileLock::tryTake(folder / "lock");
    forkSleeper(folder / "sleeper");
  }};
  EXPECT_EQ(FileLock::holder(folder / "lock"), other.pid()) << "the sleeper's end of the file changes nothing";
  other.kill(SIGKILL);
  EXPECT_TRUE(FileLock::tryTake(folder / "lock").has_value());
  ::kill(std::stoi(textOf(folder / "sleeper")), SIGKILL);
}

TEST(FileLock, AHolderThatHasEndedIsNotNamed) {
  const TemporaryFolder folder;
  Child other{[&] {
    const int fd = open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0660);
    if (flock(fd, LOCK_EX) != 0) _exit(1);  // as in a process that shares the file in spite of all
    forkSleeper(folder / "sleeper");
  }};
  EXPECT_EQ(FileLock::provenHolder(folder / "lock"), other.pid());
  other.kill(SIGKILL);
  EXPECT_EQ(FileLock::holder(folder / "lock"), -1);
  EXPECT_THROW((void)FileLock::provenHolder(folder / "lock"), std::runtime_error);
  ::kill(std::stoi(textOf(folder / "sleeper")), SIGKILL);
}

TEST(FileLock, IsGivenBackWithItsObject) {
  const TemporaryFolder folder;
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(FileLock::tryTake(folder / "lock").has_value());
}

TEST(FileLock, AskingWhoHoldsItNeverStopsAnybodyFromTakingIt) {
  const TemporaryFolder folder;
  { const auto made = FileLock::tryTake(folder / "lock"); }
  std::atomic<bool> done{false};
  std::thread curious{[&] {
    while (!done) FileLock::holder(folder / "lock");
  }};
  for (int i = 0; i < 3000; ++i) EXPECT_TRUE(FileLock::tryTake(folder / "lock").has_value());
  done = true;
  curious.join();
}

TEST(FileLock, SaysWhatToDoWhenTheFileCannotBeMade) {
  EXPECT_THROW(FileLock::tryTake("/no/such/folder/lock"), std::runtime_error);
}

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string whyNotTaken(const std::string& path) {
  try {
    return FileLock::tryTake(path) ? "taken" : "held";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(FileLock, AFifoInItsPlaceIsRefusedAndNobodyWaits) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "lock").c_str(), 0666), 0);
  EXPECT_THAT(whyNotTaken(folder / "lock"),
              AllOf(HasSubstr(messages::kNotARegularFile), HasSubstr(" rm " + (folder / "lock"))));
  EXPECT_EQ(FileLock::holder(folder / "lock"), 0);
  EXPECT_THROW((void)FileLock::provenHolder(folder / "lock"), std::runtime_error);
}

TEST(FileLock, ALinkInItsPlaceIsRefusedAndWhatItLeadsToStaysAsItIs) {
  const TemporaryFolder folder;
  std::ofstream{folder / "precious"} << "precious";
  std::filesystem::create_symlink(folder / "precious", folder / "lock");
  EXPECT_THAT(whyNotTaken(folder / "lock"), HasSubstr(messages::kNotARegularFile));
  std::filesystem::remove(folder / "lock");
  std::filesystem::create_hard_link(folder / "precious", folder / "lock");
  EXPECT_THAT(whyNotTaken(folder / "lock"), HasSubstr(messages::kSeveralNames));
  EXPECT_EQ(textOf(folder / "precious"), "precious");
}

TEST(FileLock, AFileThatEverybodyMayWriteIsRefused) {
  const TemporaryFolder folder;
  std::ofstream{folder / "lock"} << "1\n";
  ASSERT_EQ(chmod((folder / "lock").c_str(), 0666), 0);
  EXPECT_THAT(whyNotTaken(folder / "lock"), AllOf(HasSubstr(messages::kEveryUserMayWrite), HasSubstr("uid ")));
}

TEST(FileLock, TheKernelSaysWhoHoldsItWhateverIsWrittenThere) {
  const TemporaryFolder folder;
  const Child other{[&] { static const auto lock = FileLock::tryTake(folder / "lock"); }};
  std::ofstream{folder / "lock"} << "1\n";
  EXPECT_EQ(FileLock::holder(folder / "lock"), other.pid());
  EXPECT_EQ(FileLock::provenHolder(folder / "lock"), other.pid());
}

TEST(FileLock, OfAnotherUserIsRefusedWithThatUsersNameAndNoAdviceToKill) {
  const TemporaryFolder folder;
  ASSERT_EQ(chmod((folder / "").c_str(), 01777), 0);
  const std::string path = folder / "lock";
  // Another user takes the name beforehand, locks it and writes the pid of a process of root.
  const Child thief{[&] {
    if (geteuid() != 0 || setgroups(0, nullptr) != 0 || setgid(65534) != 0 || setuid(65534) != 0) return;
    const int file = open(path.c_str(), O_RDWR | O_CREAT, 0644);
    if (file < 0 || flock(file, LOCK_EX) != 0 || write(file, "1\n", 2) != 2) _exit(1);
  }};
  if (geteuid() != 0) GTEST_SKIP() << "only root can become another user";
  EXPECT_THAT(whyNotTaken(path), AllOf(HasSubstr("uid 65534"), HasSubstr(" rm " + path), Not(HasSubstr("kill"))));
  EXPECT_THROW((void)FileLock::provenHolder(path), std::runtime_error);
  EXPECT_EQ(FileLock::holder(path), thief.pid()) << "for a message: as the kernel has it";
}

TEST(FileLock, AForgottenFileOfAnotherUserIsRefusedByRootToo) {
  const TemporaryFolder folder;
  ASSERT_EQ(chmod((folder / "").c_str(), 01777), 0);
  const std::string path = folder / "lock";
  if (!asNobody([&] { std::ofstream{path} << "1\n"; })) GTEST_SKIP() << "only root can become another user";
  EXPECT_THAT(whyNotTaken(path), HasSubstr(messages::kOwnerNotTrusted));
}

}  // namespace
}  // namespace darwinop::runtime
