#include "gap/plant/registers.hpp"

#include <cmath>

#include "core/conversions.hpp"
#include "gap/plant/trace.hpp"

namespace darwinop::gap {

double readingSigma(const twin::ServoParameters& servo) {
  const double rounding = std::sqrt(1.0 / 12);  // standard deviation of rounding to steps of 1
  return 2 * kPi / servo.ticks_per_rev * std::hypot(rounding, Disturbance{}.encoder_ticks);
}

}  // namespace darwinop::gap
