// Locks between processes: one holder, named, freed by its death.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "child.hpp"
#include "runtime/file_lock.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::runtime {
namespace {

TEST(FileLock, HasOneHolderAndTellsWhoItIs) {
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

}  // namespace
}  // namespace darwinop::runtime
