// Random numbers that are identical on every machine and with every standard library.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/units.hpp"

namespace darwinop {

// SplitMix64 (Steele, Lea, Flood 2014; public domain): any seed works, also consecutive ones.
inline constexpr std::uint64_t kSplitMixStep = 0x9e3779b97f4a7c15U;
/// Output for a state. With a counter as state, draws are stateless and independent of the order of calls.
constexpr std::uint64_t splitMix(std::uint64_t state) noexcept {
  state = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9U;
  state = (state ^ (state >> 27)) * 0x94d049bb133111ebU;
  return state ^ (state >> 31);
}
/// `bits` as a number from 0 to below 1.
constexpr double uniformFrom(std::uint64_t bits) noexcept {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

class Rng {
 public:
  constexpr explicit Rng(std::uint64_t seed) noexcept : state_{seed} {}

  constexpr std::uint64_t next() noexcept { return splitMix(state_ += kSplitMixStep); }
  /// From 0 to below 1.
  constexpr double uniform() noexcept { return uniformFrom(next()); }
  constexpr double between(double low, double high) noexcept { return low + (high - low) * uniform(); }
  /// 0 to `count` - 1; `count` at least 1.
  constexpr std::size_t below(std::size_t count) noexcept { return static_cast<std::size_t>(next() % count); }
  constexpr bool coin() noexcept { return (next() >> 63) != 0; }
  constexpr double sign() noexcept { return coin() ? 1 : -1; }
  /// Mean 0, standard deviation 1.
  double normal() noexcept { return std::sqrt(-2 * std::log(1 - uniform())) * std::cos(2 * kPi * uniform()); }

  template <class List>
  constexpr auto pick(const List& list) noexcept {
    return list[below(list.size())];
  }
  template <class List>
  constexpr void shuffle(List& list) noexcept {
    for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[below(i)]);
  }

 private:
  std::uint64_t state_;
};

}  // namespace darwinop
