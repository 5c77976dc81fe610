// Tells a robot that may still come from a setting that is wrong.
#pragma once

#include <stdexcept>

namespace darwinop::cm730 {

/// The port is not there or in use, or the board behind it does not answer: it may be otherwise in a while. At boot
/// the USB port comes late. Any other error stays until somebody does something about it.
class NotReady : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace darwinop::cm730
