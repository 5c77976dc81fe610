// Reports the begin and the end of faults to a person, one line each.
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>

#include "core/sensors.hpp"

namespace darwinop::runtime {

/// Never in the loop's thread: it formats and writes.
class FaultAnnouncer {
 public:
  /// A fault that comes and goes all the time gets one begin and one end in this time (on the loop's clock), then a
  /// count of what was left out.
  static constexpr std::int64_t kQuietNs = 5'000'000'000;

  /// After the fault's name; the second is followed by how often.
  static constexpr const char *kIsOver = " is over\n", *kCameAndWent = " came and went ";

  explicit FaultAnnouncer(std::ostream& out) : out_{out} {}

  /// For successive images; it does not matter when some are left out, as long as the faults in them last.
  void update(const Sensors& seen);

 private:
  struct Memory {
    bool active = false;    // in the image before
    bool reported = false;  // its begin was reported, its end not yet
    bool ever = false;      // its begin was reported at `reported_ns`
    std::int64_t reported_ns = 0;
    std::uint32_t left_out = 0;  // begins that were not reported
  };
  [[nodiscard]] static std::string change(Memory& memory, std::size_t fault, const Sensors& seen);

  std::ostream& out_;
  std::array<Memory, kFaults> memory_{};
};

}  // namespace darwinop::runtime
