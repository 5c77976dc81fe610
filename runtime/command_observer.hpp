// What the driver of a runtime asks for, for observers.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "core/joints.hpp"
#include "runtime/exchange.hpp"

namespace darwinop::runtime {

/// Maps the runtime's input read-only. Another process writes it: values are not checked by safety yet.
class CommandObserver {
 public:
  /// Empty if `exchange` is not of this runtime, or this process may not read its commands.
  static std::unique_ptr<CommandObserver> attach(const std::string& exchange, const ExchangeBlock& block);

  /// Kp of each joint; the servo's own where the driver sets none. NaN where nothing usable is written.
  [[nodiscard]] std::array<double, kJoints> pGains() const;

 private:
  explicit CommandObserver(GuardedMapping file) : file_{std::move(file)} {}
  [[nodiscard]] const CommandBlock& block() const { return *static_cast<const CommandBlock*>(file_.data()); }

  GuardedMapping file_;
};

}  // namespace darwinop::runtime
