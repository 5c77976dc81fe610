// Histogram of microseconds: percentiles and differences of its copies.
#include "runtime/histogram.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace darwinop::runtime {
namespace {
constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

double width(std::size_t bin) {
  return bin + 1 < Bins::kCount ? Bins::low(bin + 1) - Bins::low(bin) : 1;
}
}  // namespace

std::uint64_t HistogramView::total() const {
  return std::accumulate(count.begin(), count.end(), std::uint64_t{0});
}

double HistogramView::percentile(double fraction) const {
  const std::uint64_t all = total();
  if (all == 0) return kNotMeasured;
  // Nearest rank: the smallest value that at least `fraction` of the counts do not exceed.
  const double wanted = std::clamp(std::ceil(fraction * static_cast<double>(all)), 1.0, static_cast<double>(all));
  std::uint64_t below = 0;
  for (std::size_t bin = 0; bin < Bins::kCount; ++bin) {
    if (count[bin] == 0 || static_cast<double>(below + count[bin]) < wanted) {
      below += count[bin];
      continue;
    }
    if (width(bin) <= 1) return bin + 1 == Bins::kCount ? max() : Bins::low(bin);
    const double within = (wanted - static_cast<double>(below) - 0.5) / count[bin];
    return std::min(Bins::low(bin) + within * width(bin), max());
  }
  return kNotMeasured;
}

double HistogramView::max() const {
  for (std::size_t bin = Bins::kCount; bin-- > 0;) {
    if (count[bin] == 0) continue;
    // The maximum of a difference is known to the bin only, unless the overall maximum is in it.
    if (Bins::of(greatest_us) == bin) return greatest_us;
    return Bins::low(bin) + width(bin) - 1;
  }
  return kNotMeasured;
}

HistogramView HistogramView::since(const HistogramView& before) const {
  HistogramView difference = *this;
  for (std::size_t i = 0; i < Bins::kCount; ++i) difference.count[i] -= before.count[i];
  return difference;
}

}  // namespace darwinop::runtime
