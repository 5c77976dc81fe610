// Merging of drive requests.
#include "window/drive/drive_interface.hpp"

namespace darwinop::window {

void DriveRequests::merge(const DriveRequests& newer) {
  for (std::size_t i = 0; i < kJoints; ++i)
    if (newer.goals[i]) goals[i] = newer.goals[i];
  for (std::size_t i = 0; i < kLimbs; ++i)
    if (newer.torque[i]) torque[i] = newer.torque[i];
  if (newer.page != 0) page = newer.page;
  walk = newer.walk;
}

}  // namespace darwinop::window
