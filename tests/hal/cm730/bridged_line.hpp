// An FTDI bridge between a program and the virtual robot, in simulated time.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

#include "hil-mocks/latency_timer.hpp"
#include "hil-mocks/memory_line.hpp"

namespace darwinop::cm730 {

using namespace std::chrono_literals;

/// The bridge: a request leaves with the next USB frame, replies wait for a full packet or the latency timer, and
/// reach the PC with the next USB frame.
class BridgedLine : public ByteLine {
 public:
  BridgedLine(hil::MemoryLine& line, Nanos latency, Nanos usb_frame)
      : line_{line}, timer_{latency}, usb_frame_{usb_frame} {}

  [[nodiscard]] Nanos now() noexcept override { return now_; }
  void advanceTo(Nanos when) { now_ = std::max(now_, when); }

  LineStatus write(std::span<const std::uint8_t> bytes) noexcept override {
    sendPending(now_);
    const std::size_t before = pending_.size();
    pending_.insert(pending_.end(), bytes.begin(), bytes.end());
    spoil(std::span{pending_}.subspan(before));
    leaves_ = nextFrame(now_);
    return LineStatus::kOk;
  }

  LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept override {
    count = 0;
    while (true) {
      if (!ready_.empty() && arrives_ <= std::max(now_, deadline)) {
        now_ = std::max(now_, arrives_);
        count = std::min(into.size(), ready_.size());
        std::copy_n(ready_.begin(), count, into.begin());
        ready_.erase(ready_.begin(), ready_.begin() + static_cast<std::ptrdiff_t>(count));
        return LineStatus::kOk;
      }
      if (!pump(deadline)) {
        now_ = std::max(now_, deadline);
        return lost_ ? LineStatus::kLost : LineStatus::kTimeout;
      }
    }
  }

  void discardInput() noexcept override {
    std::size_t count = 0;
    std::array<std::uint8_t, 512> rubbish{};
    while (read(rubbish, count, now_) == LineStatus::kOk) {
    }
  }
  [[nodiscard]] std::uint32_t reconnects() const noexcept override { return 0; }

 protected:
  // For derived lines with faults. Time of the next call of happen(); what it does; damage to bytes in either
  // direction; whether a reply reaches this program; additional delay of a reply.
  [[nodiscard]] virtual Nanos nextEvent() const { return Nanos::max(); }
  virtual void happen(hil::MemoryLine&) {}
  virtual void spoil(std::span<std::uint8_t>) {}
  virtual bool arrives() { return true; }
  virtual Nanos delay() { return Nanos{0}; }

 private:
  [[nodiscard]] Nanos nextFrame(Nanos when) const {
    return usb_frame_ == 0ns ? when : ((when + usb_frame_ - 1ns) / usb_frame_) * usb_frame_;
  }
  void sendPending(Nanos until) {
    if (pending_.empty() || leaves_ > until) return;
    line_.advanceTo(leaves_);
    line_.write(pending_);
    pending_.clear();
  }
  /// Lets the next thing happen that happens until then; false: nothing does.
  bool pump(Nanos deadline) {
    sendPending(deadline);
    std::array<std::uint8_t, 512> bytes{};
    std::size_t count = 0;
    const Nanos event = nextEvent(), until = std::min({deadline, timer_.due(), event});
    const auto deliver = [&](Bytes packet) {
      if (!arrives()) return;
      const std::size_t before = ready_.size();
      ready_.insert(ready_.end(), packet.begin(), packet.end());
      spoil(std::span{ready_}.subspan(before));
      arrives_ = std::max(arrives_, nextFrame(line_.now()) + delay());
    };
    const LineStatus status = line_.now() <= until ? line_.read(bytes, count, until) : LineStatus::kTimeout;
    lost_ = status == LineStatus::kLost;
    if (status == LineStatus::kOk) {
      timer_.take(Bytes{bytes}.first(count), line_.now(), deliver);
      return true;
    }
    if (lost_) return false;
    if (event <= std::min(deadline, timer_.due())) {
      line_.advanceTo(event);
      happen(line_);
      return true;
    }
    if (timer_.due() > deadline) return false;
    line_.advanceTo(timer_.due());
    timer_.expire(line_.now(), deliver);
    return true;
  }

  hil::MemoryLine& line_;
  hil::LatencyTimer timer_;
  Nanos usb_frame_, now_{0}, leaves_{0}, arrives_{0};
  std::vector<std::uint8_t> pending_, ready_;
  bool lost_ = false;
};

}  // namespace darwinop::cm730
