// Histogram of microseconds: percentiles against a sorted list.
#include "runtime/histogram.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace darwinop::runtime {
namespace {

Nanos us(std::uint32_t n) {
  return Nanos{std::int64_t{n} * 1000};
}

HistogramView viewOf(const std::vector<std::uint32_t>& values) {
  const auto histogram = std::make_unique<Histogram>();
  for (const std::uint32_t v : values) histogram->add(us(v));
  HistogramView view;
  histogram->copyTo(view);
  return view;
}

/// Values of every size, as latencies are.
rc::Gen<std::vector<std::uint32_t>> latencies() {
  return rc::gen::nonEmpty(rc::gen::container<std::vector<std::uint32_t>>(
      rc::gen::apply([](std::uint32_t value, int bits) { return value >> bits; },
                     rc::gen::inRange<std::uint32_t>(0, Bins::kLimit), rc::gen::inRange(0, 20))));
}

TEST(Bins, FollowEachOtherWithoutGapAndAreNarrow) {
  for (std::size_t bin = 0; bin + 1 < Bins::kCount; ++bin) {
    const std::uint32_t low = Bins::low(bin), next = Bins::low(bin + 1);
    ASSERT_EQ(Bins::of(low), bin);
    ASSERT_EQ(Bins::of(next - 1), bin);
    ASSERT_LE(next - low, std::max(1.0, low / 256.0));
  }
  EXPECT_EQ(Bins::of(Bins::kLimit), Bins::kCount - 1);
}

TEST(Histogram, KnowsNothingBeforeTheFirstValue) {
  const HistogramView view = viewOf({});
  EXPECT_TRUE(std::isnan(view.percentile(0.5)));
  EXPECT_TRUE(std::isnan(view.max()));
}

TEST(Histogram, PercentilesAgreeWithASortedListWithinABin) {
  EXPECT_TRUE(rc::check([] {
    std::vector<std::uint32_t> values = *latencies();
    const HistogramView view = viewOf(values);
    std::ranges::sort(values);
    for (const double fraction : {0.01, 0.5, 0.9, 0.99, 1.0}) {
      const auto rank = static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(values.size())));
      const double wanted = values[std::max<std::size_t>(rank, 1) - 1];
      RC_ASSERT(std::abs(view.percentile(fraction) - wanted) <= std::max(0.0, wanted / 256.0));
    }
    RC_ASSERT(view.max() == values.back());
    RC_ASSERT(view.total() == values.size());
  }));
}

TEST(Histogram, ADifferenceIsTheHistogramOfWhatCameInBetween) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<std::uint32_t> before = *latencies(), after = *latencies();
    std::vector<std::uint32_t> all = before;
    all.insert(all.end(), after.begin(), after.end());
    const HistogramView difference = viewOf(all).since(viewOf(before)), alone = viewOf(after);
    RC_ASSERT(difference.count == alone.count);
    RC_ASSERT(difference.max() >= alone.max());
    RC_ASSERT(difference.max() <= alone.max() * (1 + 1.0 / 256));
  }));
}

TEST(Histogram, PutsWhatIsTooLongIntoTheLastBinAndNegativeTimesAtZero) {
  const auto histogram = std::make_unique<Histogram>();
  histogram->add(std::chrono::hours{5});
  histogram->add(Nanos{-5'000});
  HistogramView view;
  histogram->copyTo(view);
  EXPECT_EQ(view.count.front(), 1u);
  EXPECT_EQ(view.count.back(), 1u);
  EXPECT_EQ(view.percentile(1.0), Bins::kLimit);
  EXPECT_EQ(view.percentile(0.5), 0);
}

}  // namespace
}  // namespace darwinop::runtime
