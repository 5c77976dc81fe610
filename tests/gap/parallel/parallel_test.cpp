#include "gap/parallel/parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace darwinop::gap {
namespace {

/// Four threads, whatever the machine has.
class Parallel : public testing::Test {
 protected:
  void SetUp() override { setThreads(4); }
  void TearDown() override { setThreads(0); }
};

TEST_F(Parallel, EveryIndexIsWorkedOnOnceAndIsDoneWhenItReturns) {
  std::vector<int> calls(1000);  // each element is written by one thread, and read afterwards without a lock
  forEach(calls.size(), [&](std::size_t i) { ++calls[i]; });
  EXPECT_EQ(std::count(calls.begin(), calls.end(), 1), 1000);
}

TEST_F(Parallel, NothingIsCalledWithoutWork) {
  forEach(0, [](std::size_t) { FAIL(); });
}

TEST_F(Parallel, TheFirstExceptionIsPassedOnAndWorkStops) {
  std::atomic<int> calls{0};
  EXPECT_THROW(forEach(100'000,
                       [&](std::size_t) {
                         ++calls;
                         throw std::runtime_error{"no"};
                       }),
               std::runtime_error);
  EXPECT_LE(calls, 4);  // one a thread
}

TEST_F(Parallel, InsideItselfItWorksInTheCallingThread) {
  std::vector<int> sums(8);
  forEach(sums.size(), [&](std::size_t i) { forEach(100, [&](std::size_t k) { sums[i] += static_cast<int>(k); }); });
  EXPECT_EQ(std::accumulate(sums.begin(), sums.end(), 0), 8 * 4950);
}

}  // namespace
}  // namespace darwinop::gap
