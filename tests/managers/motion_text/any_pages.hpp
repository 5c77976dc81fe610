// Any bytes that a motion file may hold, and the bytes of a file made of them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "managers/motion/page_file.hpp"

namespace darwinop::motion {

/// Random in every bit but for what the format forbids; its numbers are usual ones now and then.
inline Page anyPage(std::mt19937& dice) {
  const auto byte = [&dice] { return static_cast<std::uint8_t>(dice()); };
  const auto one = [&dice](unsigned in) { return dice() % in == 0; };
  Page page = emptyPage();
  if (one(2))
    for (char& letter : page.name) letter = static_cast<char>(byte());
  else
    for (std::size_t i = dice() % 14; i > 0; --i) page.name.at(i - 1) = static_cast<char>(' ' + dice() % 95);
  page.steps = static_cast<std::uint8_t>(dice() % 8);
  page.repeat = one(2) ? byte() : std::uint8_t{1};
  page.schedule = one(2) ? kTimeBased : kSpeedBased;
  if (!page.canPlay() && one(2)) page.schedule = byte();
  page.speed = one(2) ? kUsualSpeed : byte();
  if (page.canPlay() && page.speed == 0) page.speed = 1;
  page.acceleration = byte();
  page.next = byte();
  page.exit = byte();
  for (std::uint8_t& slopes : page.slopes)
    if (one(2)) slopes = byte();
  if (one(2))
    for (std::uint8_t& rest : page.rest) rest = byte();
  const auto others = dice() % 3;  // usual, all alike in a step, or anything
  for (Step& step : page.step) {
    if (one(3)) continue;
    step.time = byte();
    step.pause = byte();
    const auto other = static_cast<std::uint16_t>(dice());
    for (std::size_t id = 0; id < kServos; ++id) {
      const bool joint = id >= 1 && id <= kJoints;
      if (joint || others == 2) step.position.at(id) = static_cast<std::uint16_t>(one(4) ? dice() : dice() % 4096);
      if (!joint && others == 1) step.position.at(id) = other;
    }
  }
  return page;
}

/// Most pages empty, as in any real file. Page 0 is all zeros, or any page.
inline PageFile anyFile(std::mt19937& dice) {
  PageFile pages(kPages, emptyPage());
  for (int i = 0; i < 12; ++i) pages[dice() % kPages] = anyPage(dice);
  if (dice() % 2 == 0) {
    std::vector<std::uint8_t> bytes = encodePages(pages);
    std::fill_n(bytes.begin(), kPageBytes, std::uint8_t{0});
    pages = decodePages(bytes);
  }
  return pages;
}

}  // namespace darwinop::motion
