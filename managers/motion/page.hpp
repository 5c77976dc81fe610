// A page of the motion file: up to seven poses, and how to get from one to the next. Source: docs/motions.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/joints.hpp"

namespace darwinop::motion {

inline constexpr std::size_t kPages = 256;  // playable are 1 to 255
inline constexpr std::size_t kSteps = 7;    // of a page
inline constexpr std::size_t kServos = 31;  // ids 0 to 30 have a place in the file; 1 to 20 are joints

/// A position word: ticks 0 to 4095, or one of these flags.
inline constexpr std::uint16_t kKeep = 0x4000;       // not part of the step: the joint keeps its target
inline constexpr std::uint16_t kTorqueOff = 0x2000;  // defined by the format, used by no page of the vendor

inline constexpr std::uint8_t kSpeedBased = 0;
inline constexpr std::uint8_t kTimeBased = 10;
inline constexpr std::uint8_t kUsualSpeed = 32;       // 1.0
inline constexpr std::uint8_t kUsualSlopes = 0x55;    // P gain 32
inline constexpr std::uint16_t kUnusedWord = 0x4200;  // what the vendor's editor leaves in empty pages

struct Step {
  std::array<std::uint16_t, kServos> position{};  // by servo id
  std::uint8_t pause = 0;                         // units of 8 ms, stretched by 32 / speed
  std::uint8_t time = 0;                          // units of 8 ms, scaled by speed / 32; or a speed

  bool operator==(const Step&) const = default;
};

/// Every byte of the file has its place here, so that reading and writing loses none.
struct Page {
  static constexpr std::size_t kNameBytes = 14, kReservedBytes = 11;

  std::array<char, kNameBytes> name{};  // ends with a zero
  std::uint8_t repeat = 1;              // 0: nothing to play
  std::uint8_t schedule = kTimeBased;
  std::uint8_t steps = 0;  // that are played; the file has always seven
  std::uint8_t speed = kUsualSpeed;
  std::uint8_t acceleration = 32;                   // units of 8 ms
  std::uint8_t next = 0;                            // page that follows; 0: none
  std::uint8_t exit = 0;                            // page that follows a request to stop; 0: none
  std::array<std::uint8_t, kServos> slopes{};       // by servo id; high nibble clockwise, low counter-clockwise
  std::array<std::uint8_t, kReservedBytes> rest{};  // bytes without a meaning, in the order of the file
  bool has_checksum = true;                         // false: page 0 of the vendor's file, which is all zeros
  std::array<Step, kSteps> step{};

  bool operator==(const Page&) const = default;

  [[nodiscard]] std::string_view nameText() const {
    return {name.data(), static_cast<std::size_t>(std::ranges::find(name, '\0') - name.begin())};
  }
  [[nodiscard]] bool canPlay() const { return repeat > 0 && steps > 0; }
};

/// What the vendor's file has in the pages that nobody uses.
inline Page emptyPage() {
  Page page;
  constexpr int kFilled = 26;  // ids 0 to 25; those above are zeros
  std::fill_n(page.slopes.begin(), kFilled, kUsualSlopes);
  page.rest.back() = kUsualSlopes;
  for (Step& step : page.step) std::fill_n(step.position.begin(), kFilled, kUnusedWord);
  return page;
}

/// Register 28 of the servo, 0 to 254. The servo has one gain for both directions: the clockwise slope's.
constexpr int pGainRegister(std::uint8_t slopes) {
  return std::min((256 >> (slopes >> 4)) * 4, 254);
}

}  // namespace darwinop::motion
