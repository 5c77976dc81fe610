// Motion file: 256 pages of 512 bytes, lossless conversion. Little endian, no padding.
#include "managers/motion/page_file.hpp"

#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>
#include <string_view>

namespace darwinop::motion {

namespace {

// Offsets in the header; the steps follow it, each 64 bytes like the header.
constexpr std::size_t kRepeatAt = 15, kScheduleAt = 16, kStepsAt = 20, kSpeedAt = 22, kAccelerationAt = 24,
                      kNextAt = 25, kExitAt = 26, kChecksumAt = 31, kSlopesAt = 32, kHeaderBytes = 64, kStepBytes = 64;
constexpr std::size_t kPauseAt = 62, kTimeAt = 63;  // in a step
constexpr std::array<std::size_t, Page::kReservedBytes> kRestAt{14, 17, 18, 19, 21, 23, 27, 28, 29, 30, 63};
constexpr std::uint8_t kSum = 0xFF;  // of a page's 512 bytes, modulo 256

std::uint8_t sum(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint8_t>(std::accumulate(bytes.begin(), bytes.end(), 0U) & 0xFF);
}

[[noreturn]] void refuse(std::size_t page, std::size_t at, const std::string& what) {
  throw std::runtime_error("page " + std::to_string(page) + ", byte " + std::to_string(page * kPageBytes + at) + ": " +
                           what);
}

std::string hex(std::uint8_t value) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  return {'0', 'x', kDigits[value >> 4U], kDigits[value & 15U]};
}

Step decodeStep(std::span<const std::uint8_t> bytes) {
  Step step;
  for (std::size_t id = 0; id < kServos; ++id)
    step.position[id] = static_cast<std::uint16_t>(bytes[2 * id] | (bytes[2 * id + 1] << 8));
  step.pause = bytes[kPauseAt];
  step.time = bytes[kTimeAt];
  return step;
}

Page decodeFields(std::span<const std::uint8_t> bytes) {
  Page page;
  std::transform(bytes.begin(), bytes.begin() + Page::kNameBytes, page.name.begin(),
                 [](std::uint8_t byte) { return static_cast<char>(byte); });
  page.repeat = bytes[kRepeatAt];
  page.schedule = bytes[kScheduleAt];
  page.steps = bytes[kStepsAt];
  page.speed = bytes[kSpeedAt];
  page.acceleration = bytes[kAccelerationAt];
  page.next = bytes[kNextAt];
  page.exit = bytes[kExitAt];
  std::ranges::copy(bytes.subspan(kSlopesAt, kServos), page.slopes.begin());
  for (std::size_t i = 0; i < kRestAt.size(); ++i) page.rest[i] = bytes[kRestAt[i]];
  for (std::size_t i = 0; i < kSteps; ++i)
    page.step[i] = decodeStep(bytes.subspan(kHeaderBytes + i * kStepBytes, kStepBytes));
  return page;
}

void requirePlayable(const Page& page, std::size_t number) {
  if (page.steps > kSteps)
    refuse(number, kStepsAt, "invalid number of steps " + std::to_string(page.steps) + "; must be 0 to 7");
  if (!page.canPlay()) return;
  if (page.schedule != kTimeBased && page.schedule != kSpeedBased)
    refuse(number, kScheduleAt,
           "invalid schedule " + std::to_string(page.schedule) + "; must be 0 (by speed) or 10 (by time)");
  if (page.speed == 0) refuse(number, kSpeedAt, "invalid speed 0; must be 1 to 255, default 32");
}

Page decodePage(std::span<const std::uint8_t> bytes, std::size_t number) {
  Page page = decodeFields(bytes);
  if (const std::uint8_t total = sum(bytes); total != kSum) {
    const bool blank = std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte == 0; });
    if (number != 0 || !blank)
      refuse(number, kChecksumAt,
             "wrong checksum: the 512 bytes of the page add up to " + hex(total) + " instead of 0xFF");
    page.has_checksum = false;
  }
  requirePlayable(page, number);
  return page;
}

void encodePage(const Page& page, std::span<std::uint8_t> bytes) {
  std::ranges::copy(page.name, bytes.begin());
  bytes[kRepeatAt] = page.repeat;
  bytes[kScheduleAt] = page.schedule;
  bytes[kStepsAt] = page.steps;
  bytes[kSpeedAt] = page.speed;
  bytes[kAccelerationAt] = page.acceleration;
  bytes[kNextAt] = page.next;
  bytes[kExitAt] = page.exit;
  std::ranges::copy(page.slopes, bytes.begin() + kSlopesAt);
  for (std::size_t i = 0; i < kRestAt.size(); ++i) bytes[kRestAt[i]] = page.rest[i];
  for (std::size_t i = 0; i < kSteps; ++i) {
    const auto step = bytes.subspan(kHeaderBytes + i * kStepBytes, kStepBytes);
    for (std::size_t id = 0; id < kServos; ++id) {
      step[2 * id] = static_cast<std::uint8_t>(page.step[i].position[id] & 0xFF);
      step[2 * id + 1] = static_cast<std::uint8_t>(page.step[i].position[id] >> 8);
    }
    step[kPauseAt] = page.step[i].pause;
    step[kTimeAt] = page.step[i].time;
  }
  if (page.has_checksum) bytes[kChecksumAt] = static_cast<std::uint8_t>(kSum - sum(bytes));
}

}  // namespace

PageFile decodePages(std::span<const std::uint8_t> bytes) {
  if (bytes.size() > kFileBytes) throw std::runtime_error("the file is longer than the 131072 bytes of a motion file");
  if (bytes.size() < kFileBytes)
    throw std::runtime_error("the file ends in page " + std::to_string(bytes.size() / kPageBytes) + ", at byte " +
                             std::to_string(bytes.size()) + "; a motion file has 131072 bytes");
  PageFile pages;
  pages.reserve(kPages);
  for (std::size_t i = 0; i < kPages; ++i) pages.push_back(decodePage(bytes.subspan(i * kPageBytes, kPageBytes), i));
  return pages;
}

std::vector<std::uint8_t> encodePages(const PageFile& pages) {
  if (pages.size() != kPages)
    throw std::invalid_argument("a motion file has 256 pages, not " + std::to_string(pages.size()));
  std::vector<std::uint8_t> bytes(kFileBytes);
  for (std::size_t i = 0; i < kPages; ++i) encodePage(pages[i], std::span{bytes}.subspan(i * kPageBytes, kPageBytes));
  return bytes;
}

}  // namespace darwinop::motion
