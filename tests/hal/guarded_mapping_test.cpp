// Truncation of a mapped file by another process.
#include "hal/guarded_mapping.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <csignal>
#include <thread>
#include <vector>

#include "support/temporary_folder.hpp"

namespace darwinop {
namespace {

constexpr std::size_t kSize = 5 * 4096;

/// A file of kSize bytes, all 7.
class ShortenedFile : public testing::Test {
 protected:
  void SetUp() override {
    fd_ = open((folder_ / "x").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    const std::vector<char> sevens(kSize, 7);
    ASSERT_EQ(write(fd_, sevens.data(), kSize), static_cast<ssize_t>(kSize));
  }
  void TearDown() override { close(fd_); }

  TemporaryFolder folder_;
  int fd_ = -1;
};

volatile char* bytesOf(const GuardedMapping& mapping) {
  return static_cast<volatile char*>(mapping.data());
}

TEST_F(ShortenedFile, ReadsAsZeroAndIsReportedAsLost) {
  for (const off_t length : {off_t{0}, off_t{100}, off_t{2 * 4096}}) {
    SetUp();
    const GuardedMapping mapping{fd_, kSize, PROT_READ};
    EXPECT_EQ(bytesOf(mapping)[kSize - 1], 7);
    EXPECT_FALSE(mapping.lost());
    ASSERT_EQ(ftruncate(fd_, length), 0);
    EXPECT_EQ(bytesOf(mapping)[kSize - 1], 0) << length;
    EXPECT_TRUE(mapping.lost());
    EXPECT_EQ(bytesOf(mapping)[0], 0) << "one memory, old or empty, never a mixture";
  }
}

TEST_F(ShortenedFile, CanStillBeWrittenByItsOwnProcess) {
  const GuardedMapping mapping{fd_, kSize, PROT_READ | PROT_WRITE};
  ASSERT_EQ(ftruncate(fd_, 0), 0);
  bytesOf(mapping)[4096] = 5;
  EXPECT_EQ(bytesOf(mapping)[4096], 5);
  EXPECT_TRUE(mapping.lost());
}

TEST_F(ShortenedFile, IsSurvivedByEveryThreadThatUsesIt) {
  const GuardedMapping mapping{fd_, kSize, PROT_READ | PROT_WRITE};
  std::atomic<bool> done{false};
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      while (!done)
        for (std::size_t at = 0; at < kSize; at += 512) bytesOf(mapping)[at] = 1;
    });
  ASSERT_EQ(ftruncate(fd_, 0), 0);
  while (!mapping.lost()) std::this_thread::yield();
  done = true;
  for (std::thread& thread : threads) thread.join();
}

TEST_F(ShortenedFile, DoesNotAffectOtherMappings) {
  const GuardedMapping shortened{fd_, kSize, PROT_READ};
  GuardedMapping moved{GuardedMapping{fd_, kSize, PROT_READ}};
  ASSERT_EQ(ftruncate(fd_, 0), 0);
  EXPECT_EQ(bytesOf(moved)[0], 0);
  EXPECT_TRUE(moved.lost());
  EXPECT_FALSE(shortened.lost());
}

void touchUnguarded(int fd) {
  const GuardedMapping guarded{fd, kSize, PROT_READ};
  const auto* const other = static_cast<volatile char*>(mmap(nullptr, kSize, PROT_READ, MAP_SHARED, fd, 0));
  if (ftruncate(fd, 0) != 0) _exit(1);
  (void)other[0];
  _exit(0);
}

void raiseBesideGuarded(int fd) {
  const GuardedMapping guarded{fd, kSize, PROT_READ};
  raise(SIGBUS);
  _exit(0);
}

TEST_F(ShortenedFile, WithoutAGuardEndsTheProcess) {
  // By the signal, or by the sanitizer that intercepted it.
  EXPECT_DEATH(touchUnguarded(fd_), "");
  EXPECT_DEATH(raiseBesideGuarded(fd_), "");
}

TEST_F(ShortenedFile, LeavesRoomForOthersWhenItIsUnmapped) {
  for (std::size_t i = 0; i < 3 * GuardedMapping::kMost; ++i) const GuardedMapping mapping{fd_, kSize, PROT_READ};
  EXPECT_THROW((GuardedMapping{-1, kSize, PROT_READ}), std::exception);
}

}  // namespace
}  // namespace darwinop
