// Portable random generator (SplitMix64, public domain).
#pragma once

#include <cstdint>

namespace darwinop::hil {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_{seed} {}

  std::uint64_t next() noexcept {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  /// 0..bound-1; bound at least 1.
  std::uint32_t below(std::size_t bound) noexcept { return static_cast<std::uint32_t>(next() % bound); }
  /// 0 <= x < 1
  double fraction() noexcept { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  double between(double low, double high) noexcept { return low + (high - low) * fraction(); }

 private:
  std::uint64_t state_;
};

}  // namespace darwinop::hil
