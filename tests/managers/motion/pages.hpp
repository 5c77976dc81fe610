// Synthetic motion files, and the vendor's file if available.
#pragma once

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

#include "managers/motion/page_file.hpp"
#include "managers/motion/player.hpp"
#include "support/shared_data.hpp"

namespace darwinop::motion {

/// The vendor's motion file; it is not part of this project and may be absent.
inline std::filesystem::path vendorsFile() {
  return sharedData("reference/data/motion_4096.bin");
}

inline PageFile vendorsPages() {
  std::ifstream file{vendorsFile(), std::ios::binary};
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>{file}, {}};
  return decodePages(bytes);
}

inline PageFile emptyFile() {
  return PageFile(kPages, emptyPage());
}

inline Pose everywhere(int ticks) {
  Pose pose;
  pose.fill(ticks);
  return pose;
}

/// A step of every joint to one position.
inline Step stepTo(std::uint16_t ticks, std::uint8_t time, std::uint8_t pause = 0) {
  Step step;
  step.position.fill(ticks);
  step.time = time;
  step.pause = pause;
  return step;
}

inline Page pageOf(std::initializer_list<Step> steps, std::uint8_t acceleration = 2) {
  Page page = emptyPage();
  page.acceleration = acceleration;
  for (const Step& step : steps) page.step[page.steps++] = step;
  return page;
}

/// Random valid pages with random links.
inline PageFile randomFile(std::mt19937& rng) {
  const auto up_to = [&rng](int most) { return static_cast<int>(rng() % static_cast<unsigned>(most + 1)); };
  const auto byte = [&up_to](int most) { return static_cast<std::uint8_t>(up_to(most)); };
  PageFile pages = emptyFile();
  for (std::size_t i = 1; i < 12; ++i) {
    Page& page = pages[i];
    page.steps = byte(7);
    page.repeat = byte(3);
    page.schedule = up_to(3) == 0 ? kSpeedBased : kTimeBased;
    page.speed = static_cast<std::uint8_t>(1 + up_to(up_to(1) == 0 ? 63 : 254));
    page.acceleration = byte(up_to(1) == 0 ? 8 : 255);
    page.next = byte(14);
    page.exit = byte(14);
    for (std::uint8_t& slopes : page.slopes) slopes = byte(255);
    for (std::uint8_t& rest : page.rest) rest = byte(255);
    for (Step& step : page.step) {
      step.time = byte(up_to(1) == 0 ? 12 : 255);
      step.pause = up_to(2) == 0 ? byte(20) : std::uint8_t{0};
      for (std::uint16_t& word : step.position)
        word = up_to(5) == 0 ? std::uint16_t{0x4200} : static_cast<std::uint16_t>(up_to(kTickMax));
    }
  }
  return pages;
}

}  // namespace darwinop::motion
