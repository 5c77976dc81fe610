// Work shared among the ranks of mpirun. Each test holds for any number of them: ctest runs these alone, and with two
// of them (mpi.sh).
#include "gap/parallel/ranks.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <cstdlib>
#include <thread>

#define OMPI_SKIP_MPICXX 1  // the C++ interface that MPI 3 took out
#include <mpi.h>

namespace darwinop::gap {
namespace {

using testing::ElementsAre;

std::vector<double> squares(std::size_t count, std::atomic<int>& calls) {
  return sharedRows(count, 2, [&](std::size_t i, std::span<double> row) {
    ++calls;
    row[0] = static_cast<double>(i);
    row[1] = static_cast<double>(i * i);
  });
}

TEST(Ranks, WithoutMpirunMpiIsNotUsed) {
  if (std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr) GTEST_SKIP() << "this is a run under mpirun";
  int is_initialised = 1;
  MPI_Initialized(&is_initialised);
  EXPECT_EQ(is_initialised, 0);
  EXPECT_EQ(Ranks::count(), 1);
  EXPECT_TRUE(Ranks::isFirst());
  EXPECT_EQ(Ranks::giveUp(7), 7);
}

TEST(Ranks, UnderMpirunThereAreAsManyAsItStarted) {
  const char* const started = std::getenv("OMPI_COMM_WORLD_SIZE");
  if (started == nullptr) GTEST_SKIP() << "only under mpirun";
  EXPECT_EQ(Ranks::count(), std::atoi(started));
  EXPECT_EQ(Ranks::own(), std::atoi(std::getenv("OMPI_COMM_WORLD_RANK")));
  EXPECT_GE(Ranks::cores(), 1U);
}

TEST(Ranks, EveryRankHasAllRowsInOrder) {
  std::atomic<int> calls{0};
  EXPECT_THAT(squares(5, calls), ElementsAre(0, 0, 1, 1, 2, 4, 3, 9, 4, 16));
  const int most = (5 + Ranks::count() - 1) / Ranks::count();
  EXPECT_LE(calls, most) << "the work is shared, not repeated";
  EXPECT_GE(calls, 5 / Ranks::count());
}

TEST(Ranks, FewerRowsThanRanksDo) {
  std::atomic<int> calls{0};
  EXPECT_THAT(squares(1, calls), ElementsAre(0, 0));
  EXPECT_THAT(squares(0, calls), ElementsAre());
}

TEST(Ranks, AnotherThreadSharesNoWorkAndDoesNotWait) {
  std::atomic<int> calls{0};
  std::vector<double> rows;
  // Only the first rank comes here: if it shared, it would wait for the others for ever.
  if (Ranks::isFirst()) std::thread{[&] { rows = squares(3, calls); }}.join();
  if (!Ranks::isFirst()) return;
  EXPECT_THAT(rows, ElementsAre(0, 0, 1, 1, 2, 4));
  EXPECT_EQ(calls, 3);
}

TEST(Ranks, DifferentWorkIsAnErrorAndNotAnEndlessWait) {
  if (Ranks::count() == 1) GTEST_SKIP() << "only under mpirun";
  const auto nothing = [](std::size_t, std::span<double>) {};
  EXPECT_THROW(sharedRows(Ranks::isFirst() ? 3 : 4, 1, nothing), std::runtime_error);
}

TEST(Ranks, MessagesArriveWholeAndInOrder) {
  if (Ranks::count() == 1) GTEST_SKIP() << "only under mpirun";
  const std::string large(100'000, 'x');  // more than goes without the other's knowledge
  if (!Ranks::isFirst()) {
    sendTo(0, "first");
    sendTo(0, large);
    return;
  }
  std::vector<std::vector<std::string>> texts(static_cast<std::size_t>(Ranks::count()));
  for (int open = 2 * (Ranks::count() - 1); open > 0;)
    if (const auto message = received()) {
      texts[static_cast<std::size_t>(message->from)].push_back(message->text);
      --open;
    }
  for (std::size_t rank = 1; rank < texts.size(); ++rank) EXPECT_THAT(texts[rank], ElementsAre("first", large));
}

}  // namespace
}  // namespace darwinop::gap
