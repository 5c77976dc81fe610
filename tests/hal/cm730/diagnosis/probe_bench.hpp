// A virtual robot for probes: counts writes, and can delay replies.
#pragma once

#include <algorithm>

#include "core/registers.hpp"
#include "hal/cm730/diagnosis/probe.hpp"
#include "hal/cm730/diagnosis/transactions.hpp"
#include "hil-mocks/memory_line.hpp"

namespace darwinop::cm730 {

/// Counts writes to servos.
class WriteWatch final : public hil::WireObserver {
 public:
  void request(const Frame& frame, Nanos) noexcept override {
    const bool sync_write = frame.code == static_cast<std::uint8_t>(Instruction::kSyncWrite);
    if (sync_write && frame.params[0] != find(kMx28, "led").address) ++ram_writes;
    if (frame.code != static_cast<std::uint8_t>(Instruction::kWrite) || frame.id == kBoardId) return;
    ++(frame.params[0] < servo::kTorqueEnable ? eeprom_writes : ram_writes);
  }
  void reply(Bytes, Nanos) noexcept override {}
  int eeprom_writes = 0, ram_writes = 0;
};

struct ProbeBench {
  explicit ProbeBench(const hil::BoardOptions& options = powered()) : robot{options}, line{robot} {
    line.observe(&writes);
  }
  static hil::BoardOptions powered() {
    hil::BoardOptions options;
    options.servo_power = true;
    return options;
  }
  ProbeReport probe(const ProbeOptions& options = ProbeOptions::quick()) { return cm730::probe(line, options); }
  const hil::VirtualServo& servo(Joint joint) { return robot.board().servo(joint); }

  hil::VirtualRobot robot;
  hil::MemoryLine line;
  WriteWatch writes;
};

/// An adapter that delays replies.
class SlowLine : public ByteLine {
 public:
  SlowLine(hil::MemoryLine& line, Nanos delay) : delay_{delay}, line_{line} {}
  [[nodiscard]] Nanos now() noexcept override { return line_.now(); }
  LineStatus write(std::span<const std::uint8_t> bytes) noexcept override {
    not_before_ = line_.now() + delay_;
    return line_.write(bytes);
  }
  LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept override {
    line_.advanceTo(std::min(not_before_, deadline));
    return line_.read(into, count, deadline);
  }
  void discardInput() noexcept override { line_.discardInput(); }
  [[nodiscard]] std::uint32_t reconnects() const noexcept override { return line_.reconnects(); }

 protected:
  Nanos delay_;

 private:
  hil::MemoryLine& line_;
  Nanos not_before_{0};
};

/// A computer that is busy until a time and serves one reply in four without delay.
class BusyLine final : public SlowLine {
 public:
  BusyLine(hil::MemoryLine& line, Nanos until) : SlowLine{line, Nanos{0}}, until_{until} {}
  LineStatus write(std::span<const std::uint8_t> bytes) noexcept override {
    delay_ = now() < until_ && ++writes_ % 4 != 0 ? Nanos{12'000'000} : Nanos{0};
    return SlowLine::write(bytes);
  }

 private:
  Nanos until_;
  int writes_ = 0;
};

}  // namespace darwinop::cm730
