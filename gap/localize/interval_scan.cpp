// Scan of energy over windows of all lengths, Benjamini and Hochberg 1995 over all of them.
#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "gap/localize/intervals.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

constexpr std::array kLengths{0.1, 0.2, 0.4, 0.8, 1.6, 2.0};  // s

struct Window {
  std::size_t row, first, last;
  double chi2, chance, score;
};

std::vector<Window> windowsOf(const Eigen::VectorXd& z, const std::vector<double>& time_s, std::size_t row) {
  std::vector<double> sum{0};
  for (const double value : z) sum.push_back(sum.back() + value * value);
  std::vector<Window> out;
  for (const double length_s : kLengths) {
    double next_s = time_s.empty() ? 0 : time_s.front();
    for (std::size_t first = 0, last = 0; first < time_s.size(); ++first) {
      if (time_s[first] < next_s) continue;
      next_s = time_s[first] + length_s / 4;
      while (last < time_s.size() && time_s[last] < time_s[first] + length_s) ++last;
      if (last >= time_s.size()) break;
      const double n = static_cast<double>(last - first), chi2 = sum[last] - sum[first];
      if (n < 3) continue;
      const boost::math::chi_squared noise{std::max(1.0, thresholds::kIndependentShare * n)};
      const double chance = boost::math::cdf(boost::math::complement(noise, thresholds::kIndependentShare * chi2));
      out.push_back({row, first, last - 1, chi2, chance, (chi2 - n) / std::sqrt(2 * n)});
    }
  }
  return out;
}

}  // namespace

std::vector<std::vector<EnergyInterval>> scanEnergy(const std::vector<Eigen::VectorXd>& z,
                                                    const std::vector<std::vector<double>>& time_s) {
  std::vector<Window> all;
  for (std::size_t row = 0; row < z.size(); ++row) {
    const auto windows = windowsOf(z[row], time_s[row], row);
    all.insert(all.end(), windows.begin(), windows.end());
  }
  std::ranges::sort(all, {}, &Window::chance);
  std::size_t discoveries = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].chance <= thresholds::kFalseDiscoveries * static_cast<double>(i + 1) / static_cast<double>(all.size()))
      discoveries = i + 1;
  all.resize(discoveries);
  std::ranges::sort(all, std::greater{}, &Window::score);
  std::vector<std::vector<EnergyInterval>> out(z.size());
  for (const Window& window : all) {
    auto& row = out[window.row];
    const bool taken = std::ranges::any_of(
        row, [&](const EnergyInterval& other) { return window.first <= other.last && other.first <= window.last; });
    if (!taken) row.push_back({window.first, window.last, window.chi2});
  }
  return out;
}

}  // namespace darwinop::gap
