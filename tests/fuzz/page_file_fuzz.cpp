// Binary motion file: an error with page and byte, or written as read.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "managers/motion/first_step.hpp"
#include "managers/motion/player.hpp"
#include "tests/managers/motion/naive.hpp"

namespace {

using namespace darwinop::motion;

void require(bool holds) {
  if (!holds) std::abort();
}

/// The input fills pages from number 0 on, the rest are empty. With `sealed` their checksums are made right, or hardly
/// any input would get past them.
std::vector<std::uint8_t> fileOf(const std::uint8_t* data, std::size_t size, bool sealed) {
  static const std::vector<std::uint8_t> kEmpty = encodePages(PageFile(kPages, emptyPage()));
  std::vector<std::uint8_t> bytes = kEmpty;
  for (std::size_t page = 0; page < kPages && page * kPageBytes < size; ++page) {
    const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(page * kPageBytes);
    const std::size_t count = std::min(kPageBytes, size - page * kPageBytes);
    std::copy_n(data + page * kPageBytes, count, at);
    if (!sealed) continue;
    at[31] = 0;
    unsigned sum = 0;
    for (std::size_t i = 0; i < kPageBytes; ++i) sum += at[static_cast<std::ptrdiff_t>(i)];
    at[31] = static_cast<std::uint8_t>(0xFF - sum);
  }
  return bytes;
}

/// The plain rules take position words as they are, so that the comparison is for files that keep to them.
bool keepsToTheRange(const PageFile& pages) {
  return std::ranges::all_of(pages, [](const Page& page) {
    return std::ranges::all_of(page.step, [](const Step& step) {
      return std::ranges::all_of(step.position, [](std::uint16_t word) { return word < 4096 || (word & kKeep) != 0; });
    });
  });
}

constexpr std::size_t kTicks = 400;  // so that a second has many inputs

void playAll(const PageFile& pages, int stop_at) {
  const bool compare = keepsToTheRange(pages);
  Player player{pages};
  Pose present;
  present.fill(2048);
  for (int page = 0; page < 4; ++page) {
    if (!player.start(page, present)) continue;
    const double speed = firstStepSpeed(pages[static_cast<std::size_t>(page)], present);
    require(speed >= 0 && speed < 400);  // half a turn in 8 ms is 393 rad/s
    const auto expected = compare ? naive::play(pages, page, present, kTicks, stop_at) : std::vector<naive::Row>{};
    for (int tick = 0; tick < static_cast<int>(kTicks); ++tick) {
      if (tick == stop_at) player.requestStop();
      if (!player.tick()) {
        require(!compare || static_cast<std::size_t>(tick) == expected.size());
        break;
      }
      for (const int ticks : player.pose()) require(ticks >= 0 && ticks <= 4095);
      require(player.pGainRegister(darwinop::Joint::kNeck) >= 0 && player.pGainRegister(darwinop::Joint::kNeck) <= 254);
      require(!compare || player.pose() == expected[static_cast<std::size_t>(tick)].pose);
    }
    player.brake();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const std::vector<std::uint8_t> bytes = fileOf(data + 2, size - 2, data[0] % 8 != 0);
  try {
    const PageFile pages = decodePages(bytes);
    require(encodePages(pages) == bytes);
    playAll(pages, data[1]);
  } catch (const std::runtime_error& refused) {
    require(std::string_view{refused.what()}.starts_with("page "));
  }
  return 0;
}
