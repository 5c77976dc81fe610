// A page of the motion file: up to seven steps (poses with times). Format: docs/motions.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/joints.hpp"

namespace darwinop::motion {

inline constexpr std::size_t kPages = 256;  // 1 to 255 are playable
inline constexpr std::size_t kSteps = 7;    // per page
inline constexpr std::size_t kServos = 31;  // the file has ids 0 to 30; 1 to 20 are joints

/// Position word: ticks 0 to 4095, or one of these flags.
inline constexpr std::uint16_t kKeep = 0x4000;       // the joint keeps its target
inline constexpr std::uint16_t kTorqueOff = 0x2000;  // defined by the format, not used in the vendor's pages

inline constexpr std::uint8_t kSpeedBased = 0;
inline constexpr std::uint8_t kTimeBased = 10;
inline constexpr std::uint8_t kDefaultSpeed = 32;     // 1.0
inline constexpr std::uint8_t kDefaultSlopes = 0x55;  // P gain 32
inline constexpr std::uint16_t kUnusedWord = 0x4200;  // written by the vendor's editor in empty pages

struct Step {
  std::array<std::uint16_t, kServos> position{};  // by servo id
  std::uint8_t pause = 0;                         // units of 8 ms, stretched by 32 / speed
  std::uint8_t time = 0;                          // units of 8 ms, scaled by speed / 32; or a speed

  bool operator==(const Step&) const = default;
};

/// Contains every byte of the file, so that reading and writing is lossless.
struct Page {
  static constexpr std::size_t kNameBytes = 14, kReservedBytes = 11;

  std::array<char, kNameBytes> name{};  // zero-terminated
  std::uint8_t repeat = 1;              // 0: not playable
  std::uint8_t schedule = kTimeBased;
  std::uint8_t steps = 0;  // number of steps played; the file always has seven
  std::uint8_t speed = kDefaultSpeed;
  std::uint8_t acceleration = 32;                   // units of 8 ms
  std::uint8_t next = 0;                            // next page; 0: none
  std::uint8_t exit = 0;                            // page played after a stop request; 0: none
  std::array<std::uint8_t, kServos> slopes{};       // by servo id; high nibble clockwise, low counter-clockwise
  std::array<std::uint8_t, kReservedBytes> rest{};  // reserved bytes, in file order
  bool has_checksum = true;                         // false: page 0 of the vendor's file, all zeros
  std::array<Step, kSteps> step{};

  bool operator==(const Page&) const = default;

  [[nodiscard]] std::string_view nameText() const {
    return {name.data(), static_cast<std::size_t>(std::ranges::find(name, '\0') - name.begin())};
  }
  [[nodiscard]] bool canPlay() const { return repeat > 0 && steps > 0; }
};

/// An unused page as in the vendor's file.
inline Page emptyPage() {
  Page page;
  constexpr int kFilled = 26;  // ids 0 to 25; higher ids are zero
  std::fill_n(page.slopes.begin(), kFilled, kDefaultSlopes);
  page.rest.back() = kDefaultSlopes;
  for (Step& step : page.step) std::fill_n(step.position.begin(), kFilled, kUnusedWord);
  return page;
}

/// Register 28 of the servo, 0 to 254. The servo has one gain for both directions; the clockwise slope is used.
constexpr int pGainRegister(std::uint8_t slopes) {
  return std::min((256 >> (slopes >> 4)) * 4, 254);
}

}  // namespace darwinop::motion
