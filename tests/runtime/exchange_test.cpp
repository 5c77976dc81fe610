// The shared memory: made, found, refused, replaced, woken.
#include "runtime/exchange.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "child.hpp"
#include "runtime/messages.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string whyRefused(const std::string& path) {
  try {
    Exchange::attach(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Exchange, IsFilledBeforeOtherProcessesCanAttach) {
  const TemporaryFolder folder;
  const Exchange loop = Exchange::create(folder / "x", static_cast<gid_t>(-1), [&](ExchangeBlock& block) {
    EXPECT_THROW((void)Exchange::attach(folder / "x"), std::runtime_error);
    block.released = 7;
  });
  EXPECT_EQ(Exchange::attach(folder / "x").block().released, 7U);
}

TEST(Exchange, IsOneMemoryForAllWhoAttach) {
  const TemporaryFolder folder;
  const Exchange loop = Exchange::create(folder / "x"), controller = Exchange::attach(folder / "x");
  Commands commands;
  commands.sequence = 42;
  controller.commands().commands.publish(commands);
  Commands seen;
  ASSERT_TRUE(loop.commands().commands.read(seen));
  EXPECT_EQ(seen.sequence, 42u);
}

mode_t rightsOf(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 ? status.st_mode & 0777u : 0;
}

TEST(Exchange, LetsTheGroupReadAndCommandAndNobodyElse) {
  const TemporaryFolder folder;
  const Exchange exchange = Exchange::create(folder / "x");
  EXPECT_EQ(rightsOf(folder / "x"), 0640u);
  EXPECT_EQ(rightsOf(folder / "x.commands"), 0660u);
}

TEST(Exchange, OnlyTheLoopsProcessCanWriteTheLoopsMemory) {
  const TemporaryFolder folder;
  const Exchange loop = Exchange::create(folder / "x"), controller = Exchange::attach(folder / "x");
  EXPECT_THROW((void)controller.ownBlock(), std::logic_error);
  EXPECT_DEATH(const_cast<ExchangeBlock&>(controller.block()).closing.store(1), "");
  const Exchange observer = Exchange::attach(folder / "x", Exchange::Access::kRead);
  EXPECT_THROW((void)observer.commands(), std::logic_error);
}

TEST(Exchange, OfAnEmbeddedLoopTakesNoCommandsFromOthers) {
  const TemporaryFolder folder;
  { const Exchange old = Exchange::create(folder / "x"); }
  const Exchange embedded = Exchange::createObservable(folder / "x");
  EXPECT_NO_THROW(Exchange::attach(folder / "x", Exchange::Access::kRead));
  EXPECT_THAT(whyRefused(folder / "x"), HasSubstr(messages::kTakesNoCommands));
}

TEST(Exchange, IsLostWhenAnyOfItsFilesIsShortened) {
  for (const char* file : {"x", "x.commands"})
    for (const off_t length : {0, 100}) {
      const TemporaryFolder folder;
      const Exchange loop = Exchange::create(folder / "x"), controller = Exchange::attach(folder / "x");
      EXPECT_FALSE(loop.lost() || controller.lost());
      ASSERT_EQ(truncate((folder / file).c_str(), length), 0);
      Sensors seen;
      for (const Exchange* each : {&loop, &controller}) {
        Commands commands;
        for (int i = 0; i < 8; ++i) each->commands().commands.publish(commands);  // touches every slot
        (void)each->block().stats.cycles();
        (void)each->block().sensors.read(seen);
        EXPECT_TRUE(each->lost() || length != 0) << file;
      }
      EXPECT_TRUE(loop.shortened()) << file << " " << length << ": what is left of a page reads as zero";
    }
}

TEST(Exchange, IsLostWhenItsFileWasOverwritten) {
  const TemporaryFolder folder;
  const Exchange loop = Exchange::create(folder / "x");
  ASSERT_EQ(truncate((folder / "x").c_str(), 0), 0);
  ASSERT_EQ(truncate((folder / "x").c_str(), sizeof(ExchangeBlock)), 0);  // its pages are there again, and empty
  EXPECT_TRUE(loop.lost());
}

TEST(Exchange, TwoFilesOfDifferentRuntimesAreNotUsedTogether) {
  const TemporaryFolder folder;
  const Exchange one = Exchange::create(folder / "x");
  const Exchange other = Exchange::create(folder / "y");
  std::filesystem::rename(folder / "y.commands", folder / "x.commands");
  EXPECT_THAT(whyRefused(folder / "x"), HasSubstr(messages::kNotOneRuntime));
}

TEST(Exchange, SaysWhatToDoWhenThereIsNone) {
  const TemporaryFolder folder;
  EXPECT_THAT(whyRefused(folder / "x"),
              AllOf(HasSubstr(messages::kNoRuntime + (folder / "x")), HasSubstr(messages::kStartRuntime)));
}

TEST(Exchange, RefusesAFileOfAnotherSizeMagicOrLayout) {
  const TemporaryFolder folder;
  std::ofstream{folder / "short"} << "hello";
  EXPECT_THAT(whyRefused(folder / "short"), HasSubstr(messages::kOtherVersion));

  const Exchange exchange = Exchange::create(folder / "x");
  exchange.ownBlock().layout += 1;
  EXPECT_THAT(whyRefused(folder / "x"), HasSubstr(messages::kOtherVersion));
  exchange.ownBlock().layout -= 1;
  exchange.ownBlock().magic = 0;
  EXPECT_THAT(whyRefused(folder / "x"), HasSubstr(messages::kOtherVersion));
}

TEST(Exchange, ReplacesTheFileOfADeadLoopWithoutHarmToThoseWhoStillMapIt) {
  const TemporaryFolder folder;
  Child dead{[&] {
    static const Exchange exchange = Exchange::create(folder / "x");
    exchange.ownBlock().session.store(9);
  }};
  const Exchange observer = Exchange::attach(folder / "x", Exchange::Access::kRead);
  dead.kill(SIGKILL);
  const Exchange next = Exchange::create(folder / "x");
  EXPECT_EQ(next.block().session.load(), 0u);
  EXPECT_EQ(observer.block().session.load(), 9u) << "the old memory must stay readable";
  EXPECT_EQ(Exchange::attach(folder / "x").block().session.load(), 0u);
}

TEST(Exchange, SaysWhereItCannotBeMade) {
  EXPECT_THROW(Exchange::create("/no/such/folder/x"), std::runtime_error);
}

TEST(WakeWord, WakesASleeperOfAnotherThreadAndMissesNone) {
  WakeWord word;
  WaitNote note;
  constexpr std::uint32_t kTimes = 2'000;
  std::atomic<std::uint32_t> seen{0};
  std::thread sleeper{[&] {
    while (seen != kTimes) {
      const std::uint32_t value = word.value();
      seen = value;
      if (value != kTimes) word.waitWhile(value, std::chrono::hours{1}, note);  // a lost wake-up would hang here
    }
  }};
  for (std::uint32_t i = 1; i <= kTimes; ++i) {
    word.set(i, note);
    while (i % 3 == 0 && seen != i) std::this_thread::yield();  // now and then it is asleep for sure, soon after
  }
  sleeper.join();
  EXPECT_EQ(seen, kTimes);
}

TEST(WakeWord, ReturnsAtOnceWhenTheValueHasMovedAndInTimeWhenItDoesNot) {
  WakeWord word;
  WaitNote note;
  word.set(1, note);
  word.waitWhile(0, std::chrono::hours{1}, note);
  word.waitWhile(1, std::chrono::milliseconds{1}, note);
}

TEST(WakeWord, WakesASleeperWhoseMemoryIsReadOnly) {
  const TemporaryFolder folder;
  const Exchange loop = Exchange::create(folder / "x"), controller = Exchange::attach(folder / "x");
  std::thread sleeper{[&] {
    while (controller.block().finished.value() == 0)
      controller.block().finished.waitWhile(0, std::chrono::hours{1}, controller.commands().wait);
  }};
  loop.ownBlock().finished.set(1, loop.commands().wait);
  sleeper.join();
}

TEST(RequestWord, EachRequestCountsOnceAndNoStrayWriteDoes) {
  RequestWord word;
  std::uint32_t seen = 0;
  EXPECT_FALSE(word.isNew(seen)) << "empty memory";
  for (int i = 0; i < 3; ++i) {
    word.ask();
    EXPECT_TRUE(word.isNew(seen));
    EXPECT_FALSE(word.isNew(seen));
  }
  for (const int byte : {0x00, 0x01, 0x5A, 0xFF}) {
    std::memset(static_cast<void*>(&word), byte, sizeof word);
    EXPECT_FALSE(word.isNew(seen)) << byte;
    word.ask();
    EXPECT_TRUE(word.isNew(seen)) << "a person's request counts after that also";
  }
}

}  // namespace
}  // namespace darwinop::runtime
