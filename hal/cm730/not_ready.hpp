// Exception for start-up errors that may resolve without user action.
#pragma once

#include <stdexcept>

namespace darwinop::cm730 {

/// The port is missing or in use, or the board does not answer. Retrying is useful: at boot the USB port appears late.
/// All other start-up errors need user action.
class NotReady : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace darwinop::cm730
