// Keys pressed by a person: all calls, no keys yet.
#include "webots/Keyboard.hpp"

#include "webots/notices.hpp"

namespace webots {

void Keyboard::enable(int sampling_period) {
  darwinop::facade::warnOnce("Keyboard: this version reads no keys yet; none is ever pressed");
  period_ = sampling_period;
}

void Keyboard::disable() {
  period_ = 0;
}
int Keyboard::getKey() const {
  return -1;
}

}  // namespace webots
