// Newest-value mailbox: never torn, newest wins, survives a writer that dies half-way.
#include "runtime/latest.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <random>
#include <thread>
#include <vector>

namespace darwinop::runtime {

/// Leaves the mailbox as a writer does that is killed after `words` words of its value.
struct LatestForTests {
  template <class T, std::uint32_t kSlots>
  static void dieWhilePublishing(Latest<T, kSlots>& latest, std::uint32_t rubbish, std::size_t words) {
    auto& slot = latest.slots_[(latest.newest_.load() + 1) % kSlots];
    slot.filled_for.store(0);
    for (std::size_t i = 0; i < words; ++i) slot.words[i].store(rubbish);
  }
  template <class T>
  static constexpr std::size_t kWords = Latest<T>::kWords;
  template <class T>
  static void setCount(Latest<T>& latest, std::uint32_t count) {
    latest.newest_.store(count);
  }
};

namespace {

/// A value that betrays every mixture of two.
struct Payload {
  std::array<std::uint64_t, 50> word{};
  std::uint64_t number = 0;
  std::uint8_t tail = 0;  // makes the size no multiple of a word

  static Payload of(std::uint64_t n) {
    Payload p;
    for (std::size_t i = 0; i < p.word.size(); ++i) p.word[i] = n * 0x9E3779B97F4A7C15u + i;
    p.number = n;
    p.tail = static_cast<std::uint8_t>(n);
    return p;
  }
  [[nodiscard]] bool whole() const {
    const Payload wanted = of(number);
    return word == wanted.word && tail == wanted.tail;
  }
};

TEST(Latest, GivesNothingBeforeTheFirstPublish) {
  const Latest<Payload> latest;
  Payload seen = Payload::of(7);
  EXPECT_FALSE(latest.read(seen));
  EXPECT_EQ(seen.number, 7u) << "what the reader had must stay";
  EXPECT_EQ(latest.count(), 0u);
}

TEST(Latest, GivesTheNewestValueAgainAndAgain) {
  Latest<Payload> latest;
  for (std::uint64_t n = 1; n <= 10; ++n) latest.publish(Payload::of(n));
  Payload seen;
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(latest.read(seen));
    EXPECT_EQ(seen.number, 10u);
    EXPECT_TRUE(seen.whole());
  }
}

TEST(Latest, KeepsSizesThatAreNotAMultipleOfAWord) {
  struct Odd {
    std::array<char, 7> text;
  };
  Latest<Odd> latest;
  latest.publish({{'d', 'a', 'r', 'w', 'i', 'n', '!'}});
  Odd seen{};
  ASSERT_TRUE(latest.read(seen));
  EXPECT_EQ(std::string(seen.text.data(), 7), "darwin!");
}

/// One writer, two readers, each as fast as it can.
template <std::uint32_t kSlots>
void raceForTornValues() {
  const auto latest = std::make_unique<Latest<Payload, kSlots>>();
  std::atomic<bool> done{false};
  std::atomic<std::uint64_t> reads{0};
  const auto reader = [&] {
    std::uint64_t newest = 0;
    Payload seen;
    do {
      if (!latest->read(seen)) continue;
      ASSERT_TRUE(seen.whole()) << "after " << reads << " reads";
      ASSERT_GE(seen.number, newest);
      newest = seen.number;
      ++reads;
    } while (!done);
  };
  std::vector<std::thread> readers;
  for (int i = 0; i < 2; ++i) readers.emplace_back(reader);
  for (std::uint64_t n = 1; n <= 50'000 || (reads < 1000 && n < 100'000'000); ++n) latest->publish(Payload::of(n));
  done = true;
  for (std::thread& thread : readers) thread.join();
  EXPECT_GE(reads, 1000u);
}

TEST(Latest, NeverGivesATornOrOlderValueToReadersInOtherThreads) {
  raceForTornValues<4>();
}

TEST(Latest, NeverGivesATornValueEvenWhenEveryPublishHitsTheSlotThatIsRead) {
  raceForTornValues<1>();
}

TEST(Latest, KeepsTheOldValueWhenTheWriterDiesHalfWayAndLetsTheNextWriterCarryOn) {
  constexpr std::size_t kAll = LatestForTests::kWords<Payload>;
  for (const std::size_t words : {std::size_t{0}, std::size_t{1}, kAll / 2, kAll - 1}) {
    Latest<Payload> latest;
    Payload seen;
    LatestForTests::dieWhilePublishing(latest, 0xDEADBEEF, words);
    EXPECT_FALSE(latest.read(seen));
    for (std::uint64_t n = 1; n <= 9; ++n) {
      latest.publish(Payload::of(n));
      LatestForTests::dieWhilePublishing(latest, 0xDEADBEEF, words);
      ASSERT_TRUE(latest.read(seen));
      EXPECT_EQ(seen.number, n);
      EXPECT_TRUE(seen.whole());
    }
  }
}

TEST(Latest, GoesOnWhenItsCounterWraps) {
  Latest<Payload> latest;
  latest.publish(Payload::of(1));
  LatestForTests::setCount(latest, 0xFFFFFFFD);
  for (std::uint64_t n = 2; n <= 12; ++n) {
    latest.publish(Payload::of(n));
    Payload seen;
    ASSERT_TRUE(latest.read(seen));
    EXPECT_EQ(seen.number, n);
  }
}

TEST(Latest, ReadReturnsWhateverAnotherProcessHasWrittenThere) {
  std::mt19937 random{7};
  Latest<Payload> latest;
  Payload seen;
  for (int run = 0; run < 2000; ++run) {
    auto* const bytes = reinterpret_cast<unsigned char*>(&latest);
    for (std::size_t i = 0; i < sizeof latest; ++i) bytes[i] = static_cast<unsigned char>(random());
    (void)latest.read(seen);
    latest.publish(Payload::of(static_cast<std::uint64_t>(run)));
    ASSERT_TRUE(latest.read(seen));
    EXPECT_EQ(seen.number, static_cast<std::uint64_t>(run)) << "the next publication is read as ever";
  }
}

}  // namespace
}  // namespace darwinop::runtime
