// Servos whose numbers need not be declared, by the name of the motor that BAM's logs have.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gap/case/declarations.hpp"

namespace darwinop::gap {

/// "mx106" of "MX-106", "Dynamixel MX_106R" and the like; with "(2.0)" of firmware that the name calls so. Other names
/// stay as they are.
std::string motorName(std::string_view written);

/// Of the data sheet, at 12 V, or derived from it.
struct SheetNumber {
  std::string key;  // as it is declared: "stall_Nm_at_12V"
  double value = 0;
  double relative_sigma = 0;             // 0: that of every bench, benchPriors()
  std::vector<std::string_view> unless;  // a declared key that begins so stands in its place
  std::string source;
};

/// Numbers of a motor that `mx28`, a model of the MX-28, does not have; empty: it has all. `greatest_kp`: of the logs.
/// Nothing: the motor is not known.
std::optional<std::vector<SheetNumber>> numbersOf(const std::string& motor, double greatest_kp,
                                                  const twin::ServoParameters& mx28);

/// Declares those that are not declared. A note of what was taken from where.
std::vector<std::string> declareSheet(const std::string& motor, const std::vector<SheetNumber>& numbers,
                                      Declarations& declared);

}  // namespace darwinop::gap
