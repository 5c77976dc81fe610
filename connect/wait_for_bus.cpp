#include "connect/wait_for_bus.hpp"

#include <time.h>

#include <algorithm>
#include <string>

#include "hal/cm730/not_ready.hpp"

namespace darwinop::connect {
namespace {

constexpr Nanos kFirstPause{200'000'000}, kLongestPause{2'000'000'000};
constexpr Nanos kSlice{100'000'000};  // a signal just before a sleep takes effect after it

/// To compare the messages of two attempts: measured values differ, the cause does not.
std::string withoutDigits(std::string text) {
  std::erase_if(text, [](char c) { return c >= '0' && c <= '9'; });
  return text;
}

}  // namespace

void pauseFor(Nanos time) {
  const timespec duration{static_cast<time_t>(time.count() / 1'000'000'000),
                          static_cast<long>(time.count() % 1'000'000'000)};
  nanosleep(&duration, nullptr);
}

std::optional<OpenedBus> waitForBus(const std::function<OpenedBus()>& open, const std::atomic<bool>& stop,
                                    const std::function<void(const std::string&)>& log,
                                    const std::function<void(Nanos)>& pause) {
  std::string waiting_for;
  for (Nanos next = kFirstPause; !stop; next = std::min(2 * next, kLongestPause)) {
    try {
      OpenedBus opened = open();
      if (!waiting_for.empty()) log("the robot is there: " + opened.description);
      return opened;
    } catch (const cm730::NotReady& not_yet) {
      if (const std::string now = withoutDigits(not_yet.what()); now != waiting_for) {
        log(std::string{"waiting for the robot: "} + not_yet.what());
        waiting_for = now;
      }
    }
    for (Nanos slept{0}; slept < next && !stop; slept += kSlice) pause(std::min(kSlice, next - slept));
  }
  return std::nullopt;
}

}  // namespace darwinop::connect
