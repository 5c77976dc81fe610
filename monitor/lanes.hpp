// Lanes of the monitor's messages.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "hal/net/web/channel.hpp"

namespace darwinop::monitor {

/// One lane for each kind of message of which only the newest is sent.
enum MonitorLane : web::Lane {
  kHelloLane,
  kGoneLane,
  kStateLane,
  kLoopLane,
  kFaultsLane,
  kCameraLane,
  kPictureLane,
  kErrorLane,
  kFoundLane
};
static_assert(kFoundLane < web::kLanes);

inline web::Bytes shared(std::string text) {
  return std::make_shared<const std::string>(std::move(text));
}

}  // namespace darwinop::monitor
