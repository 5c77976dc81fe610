// One request of the remote-control protocol as a plain struct. Numbers are those of the wire; units.hpp converts them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/joints.hpp"
#include "remote/protocol/few.hpp"

namespace darwinop::remote {

inline constexpr std::uint16_t kUsualPort = 5023;
inline constexpr std::uint8_t kFirstByte = 'W';
inline constexpr std::size_t kRequestHead = 3;  // 'W' and the length, 16 bits, little-endian
inline constexpr std::size_t kShortestRequest = 4;
inline constexpr std::size_t kLongestOldRequest = 912;  // every section of 2013 as often as it may come
inline constexpr std::size_t kExtensionContent = 17;
inline constexpr std::size_t kLongestRequest = kLongestOldRequest + 3 + kExtensionContent;
inline constexpr std::size_t kMostStated = 1024;  // receive buffer of the old server; a longer one is no request

inline constexpr std::size_t kLeds = 5;
/// Index on the wire: the order of the enumerators.
enum class Led : std::uint8_t { kEye, kHead, kBackRed, kBackGreen, kBackBlue };

struct LedSetting {
  Led led{};
  std::uint32_t colour = 0;  // 0xRRGGBB; a back LED is on for exactly 1
  constexpr bool operator==(const LedSetting&) const = default;
};

/// What is said of one motor. A field counts only when its bit is set.
struct MotorSetting {
  /// In the order in which they must come.
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

/// What our own clients say beyond the words of 2013. A server that does not know it answers without its part.
struct Extension {
  std::uint64_t until_cycle = 0;   // the reply is to wait for this cycle of the robot's loop, a moment at most; 0: not
  std::uint32_t fault_resets = 0;  // as in Commands
  std::uint32_t picture = 0;       // the one the client has: not sent again; 0: none
  bool start_where_it_is = false;  // as in Commands
  bool only_if_up = false;         // it has had the robot under torque: one that has let go since is left alone
  bool farewell = false;           // the last request of a controller that ends tidily
  bool unattended = false;         // as in Commands
  constexpr bool operator==(const Extension&) const = default;
};

inline constexpr std::uint8_t kExtensionTag = 'X', kExtensionVersion = 1;

struct Request {
  bool accelerometer = false, gyro = false, camera = false;
  Few<LedSetting, kLeds> leds;
  Few<MotorSetting, kJoints> motors;
  Few<std::uint8_t, kJoints> positions, torques;  // indexes as asked; one that is no joint is answered, too
  bool extended = false;                          // `extension` counts, and the reply is to have its part, too
  Extension extension{};
  constexpr bool operator==(const Request&) const = default;
};

/// What was not as it should be in a request that is answered all the same.
struct Oddities {
  std::size_t unknown_at = 0;     // offset of a byte that no section begins with there; 0: none. The rest is not read.
  std::uint8_t unknown_byte = 0;  // it
  bool cut_off = false;           // a section is longer than the request; it and the rest are not read
  std::uint8_t refused_leds = 0, refused_motors = 0, refused_sensors = 0;  // indexes out of range
  [[nodiscard]] constexpr bool any() const { return *this != Oddities{}; }
  constexpr bool operator==(const Oddities&) const = default;
};

}  // namespace darwinop::remote
