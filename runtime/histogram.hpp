// Histogram of durations with a relative resolution of 1/256; one writer, any number of readers.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "hal/byte_line.hpp"

namespace darwinop::runtime {

/// The bins: 1 us below 512 us, then 256 per octave (16 us wide at 5 ms), up to 1.05 s; the last bin is the overflow.
struct Bins {
  static constexpr std::uint32_t kExact = 512, kPerOctave = 256, kOctaves = 11;
  static constexpr std::uint32_t kLimit = kExact << kOctaves;  // 1.05 s
  static constexpr std::size_t kCount = kExact + kPerOctave * kOctaves + 1;

  static constexpr std::size_t of(std::uint32_t us) {
    if (us < kExact) return us;
    if (us >= kLimit) return kCount - 1;
    const int octave = std::bit_width(us) - std::bit_width(kExact);  // 0: 512..1023
    return kExact + static_cast<std::size_t>(octave) * kPerOctave + ((us >> (octave + 1)) - kPerOctave);
  }
  /// Smallest value of a bin, us.
  static constexpr std::uint32_t low(std::size_t bin) {
    if (bin < kExact) return static_cast<std::uint32_t>(bin);
    const std::size_t octave = (bin - kExact) / kPerOctave, step = (bin - kExact) % kPerOctave;
    return static_cast<std::uint32_t>((kPerOctave + step) << (octave + 1));
  }
};

/// A copy of the counts, for reading.
struct HistogramView {
  std::array<std::uint32_t, Bins::kCount> count{};
  std::uint32_t greatest_us = 0;

  [[nodiscard]] std::uint64_t total() const;
  /// Value below which `fraction` (0..1) of the counts lie, us; NaN if there are none.
  [[nodiscard]] double percentile(double fraction) const;
  /// Maximum, us; NaN if there are no counts.
  [[nodiscard]] double max() const;
  /// Counts since the copy `before`.
  [[nodiscard]] HistogramView since(const HistogramView& before) const;
};

/// Usable in shared memory. Counting is one relaxed store.
class Histogram {
 public:
  /// Writing thread only. A negative value counts as 0.
  void add(Nanos value) noexcept {
    const auto us = value.count() <= 0 ? 0 : value.count() / 1000;
    const auto clamped = us < Bins::kLimit ? static_cast<std::uint32_t>(us) : Bins::kLimit;
    std::atomic<std::uint32_t>& bin = count_[Bins::of(clamped)];
    bin.store(bin.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    if (clamped > greatest_us_.load(std::memory_order_relaxed)) greatest_us_.store(clamped, std::memory_order_relaxed);
  }

  void copyTo(HistogramView& view) const noexcept {
    for (std::size_t i = 0; i < Bins::kCount; ++i) view.count[i] = count_[i].load(std::memory_order_relaxed);
    view.greatest_us = greatest_us_.load(std::memory_order_relaxed);
  }

 private:
  std::array<std::atomic<std::uint32_t>, Bins::kCount> count_{};
  std::atomic<std::uint32_t> greatest_us_{0};
};

}  // namespace darwinop::runtime
