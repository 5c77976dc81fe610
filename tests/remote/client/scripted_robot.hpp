// The robot behind a scripted server.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "hal/byte_line.hpp"
#include "remote/protocol/units.hpp"
#include "scripted_server.hpp"

namespace darwinop::remote {

/// A robot that has run the requested cycle, in simulated time, so that the machine's speed does not matter.
struct ScriptedRobot {
  bool real_time = false;
  std::atomic<bool> silent{false};
  std::atomic<Nanos> delay{Nanos{0}};  // of the next reply
  bool takes_over = false;             // and no joint is driven yet
  bool delay_is_held = false;          // its loop stands still during the delay
  std::uint64_t first_cycle = 1000;
  std::string must_end, end_request;
  std::function<void(Sensors& seen)> distort;
  std::vector<std::uint8_t> jpeg;

  Answer operator()(const Request& request, int connection) {
    Answer answer;
    if (silent) return answer;
    if (const Nanos pause = delay.exchange(Nanos{0}); pause > Nanos{0}) {
      std::this_thread::sleep_for(pause);
      if (delay_is_held) return answered(request, first_cycle, pause);
    }
    return answered(request,
                    std::max<std::uint64_t>(request.extension.until_cycle,
                                            first_cycle + 100 * static_cast<std::uint64_t>(connection)),
                    Nanos{0});
  }

 private:
  [[nodiscard]] Answer answered(const Request& request, std::uint64_t cycle, Nanos held) const {
    Answer answer;
    Sensors seen;
    seen.cycle = cycle;
    seen.time_ns = static_cast<std::int64_t>(seen.cycle) * 16'000'000;
    seen.period_ns = 16'000'000;
    seen.safety.state = takes_over ? State::kTakingOver : State::kDriven;
    seen.board.motion.received();
    seen.board.buttons = 2;
    seen.board.voltage = Volt{11.5};
    for (std::size_t i = 0; i < kJoints; ++i) {
      seen.joint[i].motion.received();
      seen.joint[i].position = Rad{0.25};
      seen.joint[i].driven = !takes_over;
    }
    if (distort) distort(seen);
    Reply reply;
    for (std::size_t i = 0; i < request.positions.size(); ++i) (void)reply.positions.add(2500);
    for (std::size_t i = 0; i < request.torques.size(); ++i) (void)reply.torques.add(-12500);
    reply.accelerometer = reply.gyro = {512, 512, 640};
    if (request.camera) reply.jpeg = jpeg;
    reply.extension = ReplyExtension{.real_time = real_time,
                                     .held_us = static_cast<std::uint32_t>(held / std::chrono::microseconds{1}),
                                     .picture = 5,
                                     .seen = must_end.empty() ? &seen : nullptr,
                                     .why_ended = must_end.empty() ? end_request : must_end};
    writeReply(request, reply, answer.bytes);
    return answer;
  }
};

}  // namespace darwinop::remote
