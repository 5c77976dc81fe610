// Cycles of a runtime on this computer.
#pragma once

#include <cstdint>
#include <memory>

#include "monitor/runtime_observer.hpp"
#include "runtime/command_observer.hpp"
#include "window/live/cycle_source.hpp"

namespace darwinop::window {

/// Maps the runtime's memory read-only, so it cannot disturb the loop.
class RuntimeSource final : public CycleSource {
 public:
  explicit RuntimeSource(const runtime::RuntimeFiles& files) : exchange_{files.exchange}, runtime_{files} {}

  void poll(Nanos now, const Take& take) override;
  [[nodiscard]] const std::string& reason() const override { return runtime_.reason(); }

 private:
  std::string exchange_;
  monitor::RuntimeObserver runtime_;
  std::unique_ptr<runtime::CommandObserver> commands_;
  gap::live::LiveCycle cycle_;
};

}  // namespace darwinop::window
