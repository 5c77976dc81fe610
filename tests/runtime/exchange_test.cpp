// The shared memory: made, found, refused, replaced, woken.
#include "runtime/exchange.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <time.h>

#include <atomic>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "child.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::runtime {
namespace {

using testing::HasSubstr;

std::string whyRefused(const std::string& path) {
  try {
    Exchange::attach(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Exchange, IsOneMemoryForAllWhoAttach) {
  const TemporaryFolder folder;
  const Exchange loop = Exchange::create(folder / "x"), controller = Exchange::attach(folder / "x");
  Commands commands;
  commands.sequence = 42;
  controller.block().commands.publish(commands);
  Commands seen;
  ASSERT_TRUE(loop.block().commands.read(seen));
  EXPECT_EQ(seen.sequence, 42u);
}

TEST(Exchange, LetsTheGroupInAndNobodyElse) {
  const TemporaryFolder folder;
  const Exchange exchange = Exchange::create(folder / "x");
  struct stat status {};
  ASSERT_EQ(stat((folder / "x").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0660u);
}

TEST(Exchange, SaysWhatToDoWhenThereIsNone) {
  const TemporaryFolder folder;
  EXPECT_THAT(whyRefused(folder / "x"), HasSubstr("start one with: darwinop runtime"));
}

TEST(Exchange, RefusesAFileOfAnotherSizeMagicOrLayout) {
  const TemporaryFolder folder;
  std::ofstream{folder / "short"} << "hello";
  EXPECT_THAT(whyRefused(folder / "short"), HasSubstr("another version"));

  const Exchange exchange = Exchange::create(folder / "x");
  exchange.block().layout += 1;
  EXPECT_THAT(whyRefused(folder / "x"), HasSubstr("another version"));
  exchange.block().layout -= 1;
  exchange.block().magic = 0;
  EXPECT_THAT(whyRefused(folder / "x"), HasSubstr("another version"));
}

TEST(Exchange, ReplacesTheFileOfADeadLoopWithoutHarmToThoseWhoStillMapIt) {
  const TemporaryFolder folder;
  Child dead{[&] {
    static const Exchange exchange = Exchange::create(folder / "x");
    exchange.block().session.store(9);
  }};
  const Exchange onlooker = Exchange::attach(folder / "x");
  dead.kill(SIGKILL);
  const Exchange next = Exchange::create(folder / "x");
  EXPECT_EQ(next.block().session.load(), 0u);
  EXPECT_EQ(onlooker.block().session.load(), 9u) << "the old memory must stay readable";
  EXPECT_EQ(Exchange::attach(folder / "x").block().session.load(), 0u);
}

TEST(Exchange, SaysWhereItCannotBeMade) {
  EXPECT_THROW(Exchange::create("/no/such/folder/x"), std::runtime_error);
}

TEST(WakeWord, WakesASleeperOfAnotherThreadAndMissesNone) {
  WakeWord word;
  constexpr std::uint32_t kTimes = 2'000;
  std::atomic<std::uint32_t> seen{0};
  std::thread sleeper{[&] {
    while (seen != kTimes) {
      const std::uint32_t value = word.value();
      seen = value;
      if (value != kTimes) word.waitWhile(value, std::chrono::hours{1});  // a lost wake-up would hang here
    }
  }};
  for (std::uint32_t i = 1; i <= kTimes; ++i) {
    word.advance();
    while (i % 3 == 0 && seen != i) std::this_thread::yield();  // now and then it is asleep for sure, soon after
  }
  sleeper.join();
  EXPECT_EQ(seen, kTimes);
}

TEST(WakeWord, ReturnsAtOnceWhenTheValueHasMovedAndInTimeWhenItDoesNot) {
  WakeWord word;
  word.advance();
  word.waitWhile(0, std::chrono::hours{1});
  word.waitWhile(1, std::chrono::milliseconds{1});
}

}  // namespace
}  // namespace darwinop::runtime
