// Interface between steering session and drive thread: requests and status.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string>

#include "core/joints.hpp"
#include "core/units.hpp"
#include "managers/gait/stride.hpp"
#include "window/drive/drive_states.hpp"

namespace darwinop::window {

inline constexpr std::size_t kLimbs = kChainNames.size();  // a limb is a daisy chain: both arms, head, both legs

/// `walk` holds until it is changed; all other requests are executed once.
struct DriveRequests {
  std::array<std::optional<Rad>, kJoints> goals{};
  std::optional<gait::WalkCommand> walk{};           // nullopt: stand
  int page = 0;                                      // motion page to start; 0: none
  std::array<std::optional<bool>, kLimbs> torque{};  // by Chain; false: limp

  /// Merges newer requests, which take precedence.
  void merge(const DriveRequests& newer);
  /// Clears what is executed once.
  void clearOneTime() { *this = {.walk = walk}; }
};

/// What the robot does.
struct DriveStatus {
  bool walks = false;
  int page = 0;                // motion page being played; 0: none
  std::bitset<kLimbs> limp{};  // by Chain, as requested
  std::string refused{};       // why the last request was rejected; empty: it was not
  bool operator==(const DriveStatus&) const = default;
};

/// Called by one thread; no call blocks.
class DriveInterface {
 public:
  struct Report {
    DriveState state = DriveState::kFree;
    std::string why{};  // why the session ends, or the last one ended or did not start; empty: on request
    DriveStatus status{};
  };

  virtual ~DriveInterface() = default;
  /// Starts a session; only in state kFree.
  virtual void start() = 0;
  /// Heartbeat and new requests of the session.
  virtual void request(const DriveRequests& requests) = 0;
  /// Holds at once, at any position.
  virtual void stop() = 0;
  /// Holds after the present steps are completed.
  virtual void finish() = 0;
  [[nodiscard]] virtual Report report() = 0;
};

}  // namespace darwinop::window
