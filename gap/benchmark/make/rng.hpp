// Random numbers that are the same on every machine and with every standard library.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/units.hpp"

namespace darwinop::gap {

/// splitmix64 (Steele, Lea, Flood 2014): any seed will do, neighbours too.
class Rng {
 public:
  explicit Rng(std::uint64_t seed) noexcept : state_{seed} {}

  std::uint64_t next() noexcept {
    std::uint64_t x = state_ += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
  }
  /// From 0 to below 1.
  double share() noexcept { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double between(double low, double high) noexcept { return low + (high - low) * share(); }
  std::size_t below(std::size_t count) noexcept { return static_cast<std::size_t>(next() % count); }
  bool coin() noexcept { return (next() >> 63) != 0; }
  double sign() noexcept { return coin() ? 1 : -1; }
  /// Of mean 0 and standard deviation 1.
  double normal() noexcept { return std::sqrt(-2 * std::log(1 - share())) * std::cos(2 * kPi * share()); }

  template <class List>
  auto pick(const List& list) noexcept {
    return list[below(list.size())];
  }
  template <class T>
  void shuffle(std::vector<T>& list) noexcept {
    for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[below(i)]);
  }

 private:
  std::uint64_t state_;
};

}  // namespace darwinop::gap
