// Request of the remote-control protocol as a plain struct, in wire units; units.hpp converts them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/joints.hpp"
#include "remote/protocol/few.hpp"

namespace darwinop::remote {

inline constexpr std::uint16_t kUsualPort = 5023;
inline constexpr std::uint8_t kFirstByte = 'W';
inline constexpr std::size_t kRequestHead = 3;          // 'W' and the length, 16 bits, little-endian
inline constexpr std::size_t kLongestOldRequest = 912;  // every section of the 2013 protocol as often as allowed
inline constexpr std::size_t kExtensionContent = 17;
inline constexpr std::size_t kLongestRequest = kLongestOldRequest + 3 + kExtensionContent;
inline constexpr std::size_t kMostStated = 1024;  // receive buffer of the 2013 server; a longer request is invalid

inline constexpr std::size_t kLeds = 5;
/// Index on the wire: the order of the enumerators.
enum class Led : std::uint8_t { kEye, kHead, kBackRed, kBackGreen, kBackBlue };

struct LedSetting {
  Led led{};
  std::uint32_t colour = 0;  // 0xRRGGBB; a back LED is on for exactly 1
  constexpr bool operator==(const LedSetting&) const = default;
};

/// Settings of one motor. A field is valid only if its bit is set.
struct MotorSetting {
  /// In wire order.
  enum Bit : std::uint8_t {
    kPosition = 1,
    kVelocity = 2,
    kAcceleration = 4,
    kAvailableTorque = 8,
    kPid = 16,
    kTorque = 32
  };
  Joint joint{};
  std::uint8_t set = 0;
  std::int32_t position = 0, velocity = 0, acceleration = 0, available_torque = 0, torque = 0;
  std::array<std::int32_t, 3> pid{};

  [[nodiscard]] constexpr bool has(Bit bit) const { return (set & bit) != 0; }
  constexpr bool operator==(const MotorSetting&) const = default;
};

/// Extension of the 2013 protocol. A server without support replies without it.
struct Extension {
  std::uint64_t until_cycle = 0;   // hold the reply until this cycle of the robot's loop, for a bounded time; 0: do not
  std::uint32_t fault_resets = 0;  // as in Commands
  std::uint32_t picture = 0;       // newest picture of the client, not sent again; 0: none
  bool start_where_it_is = false;  // as in Commands
  bool only_if_up = false;      // the client has had the robot under torque: do not start one whose torque is off since
  bool end_of_session = false;  // last request of a controller that ends normally
  bool unattended = false;      // as in Commands
  constexpr bool operator==(const Extension&) const = default;
};

inline constexpr std::uint8_t kExtensionTag = 'X', kExtensionVersion = 2;

struct Request {
  bool accelerometer = false, gyro = false, camera = false;
  Few<LedSetting, kLeds> leds;
  Few<MotorSetting, kJoints> motors;
  Few<std::uint8_t, kJoints> positions, torques;  // as requested; an index out of range gets a value as well
  bool extended = false;                          // `extension` is valid, and the reply has an extension as well
  Extension extension{};
  constexpr bool operator==(const Request&) const = default;
};

/// Problems of a request that is answered nevertheless.
struct RequestIssues {
  std::size_t unknown_at = 0;     // offset of a byte that does not start a section; 0: none. The rest is ignored.
  std::uint8_t unknown_byte = 0;  // value of that byte
  bool cut_off = false;           // a section is longer than the request; it and the rest are ignored
  std::uint8_t invalid_leds = 0, invalid_motors = 0, invalid_sensors = 0;  // indexes out of range
  [[nodiscard]] constexpr bool any() const { return *this != RequestIssues{}; }
  constexpr bool operator==(const RequestIssues&) const = default;
};

}  // namespace darwinop::remote
