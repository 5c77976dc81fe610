// Output of the doctor: lines while it works, or one JSON document at its end.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "hal/cm730/diagnosis/fault_naming.hpp"
#include "hal/cm730/diagnosis/finding.hpp"

namespace darwinop::app {

class DoctorReport {
 public:
  explicit DoctorReport(bool json) : json_{json} {}

  static constexpr const char* kRobotPart = "robot";

  /// A part of the check: "computer", "port", kRobotPart, "pose".
  void begin(std::string part);
  void add(const cm730::Findings& findings);
  [[nodiscard]] const cm730::Findings& findings() const { return findings_; }
  /// Prints the faults and the result. Returns the exit code: 0 if the robot can be driven.
  int finish(const std::string& port, const std::vector<cm730::NamedFault>& faults);

 private:
  [[nodiscard]] std::string document(const std::string& port, const std::vector<cm730::NamedFault>& faults) const;
  /// "40 ok, 1 warnings, 0 errors: the robot can be driven"
  [[nodiscard]] std::string summary() const;
  [[nodiscard]] bool drivable() const { return count(cm730::Level::kError) == 0; }
  [[nodiscard]] int count(cm730::Level level) const { return count_[static_cast<std::size_t>(level)]; }

  bool json_;
  std::string part_;
  bool examined_ = false;  // the port could be opened, so board and servos were examined
  cm730::Findings findings_;
  std::vector<std::string> parts_;  // of each finding
  std::array<int, 3> count_{};
};

}  // namespace darwinop::app
