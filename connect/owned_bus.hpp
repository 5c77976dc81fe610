// A bus together with the line it runs on, so that one owner holds both.
#pragma once

#include <memory>
#include <utility>

#include "hal/cm730/bus.hpp"
#include "hal/servo_bus.hpp"

namespace darwinop::connect {

template <class Line>
class OwnedBus final : public ServoBus {
 public:
  OwnedBus(std::unique_ptr<Line> line, const cm730::BusConfig& config) : line_{std::move(line)}, bus_{*line_, config} {}

  void write(const SafeCommands& commands) noexcept override { bus_.write(commands); }
  void read(BusReadings& readings) noexcept override { bus_.read(readings); }

 private:
  std::unique_ptr<Line> line_;
  cm730::Cm730Bus bus_;
};

}  // namespace darwinop::connect
