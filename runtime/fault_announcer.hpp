// Logs begin and end of each fault for the user, one line each.
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>

#include "core/sensors.hpp"

namespace darwinop::runtime {

/// Not for the loop's thread: it formats and writes.
class FaultAnnouncer {
 public:
  /// Rate limit: an intermittent fault gets at most one begin and one end per this time (on the loop's clock), then a
  /// count of the occurrences omitted.
  static constexpr std::int64_t kQuietNs = 5'000'000'000;

  /// Follow the fault's name; after the second comes the count.
  static constexpr const char *kIsOver = " is over\n", *kCameAndWent = " came and went ";

  /// In place of the remedy of a fall, where the session states that the trunk is held.
  static constexpr const char* kExpected = "expected in this setup";

  /// `trunk_is_held`: by a stand or a person, and a tilted one has not fallen. Changes this text only, nothing of
  /// safety.
  explicit FaultAnnouncer(std::ostream& out, bool trunk_is_held = false) : out_{out}, trunk_is_held_{trunk_is_held} {}

  /// Call with successive images. Some may be skipped; a fault that is only in skipped images is not reported.
  void update(const Sensors& seen);

 private:
  struct Memory {
    bool active = false;           // in the previous image
    bool reported = false;         // begin reported, end not yet
    bool ever = false;             // `reported_ns` is valid
    std::int64_t reported_ns = 0;  // time of the last reported begin
    std::uint32_t left_out = 0;    // begins omitted since
  };
  [[nodiscard]] std::string_view remedyOf(const FaultRow& fault, const SafetyReport& safety) const;
  [[nodiscard]] std::string change(Memory& memory, std::size_t fault, const Sensors& seen) const;

  std::ostream& out_;
  bool trunk_is_held_;
  std::array<Memory, kFaults> memory_{};
};

}  // namespace darwinop::runtime
