// Registers of a simulated recording: sensors with their noise, and the steps of all registers.
#pragma once

#include "gap/case/body/body_case.hpp"
#include "gap/plant/body/moving_imu.hpp"
#include "gap/plant/trace.hpp"

namespace darwinop::gap {

/// Fills gyroscope and accelerometer and rounds all columns. `noise` null: without noise and rounding.
void readSensors(BodyCase& plan, std::size_t index, const FloorTrace& trace, const ImuDeviation& deviation,
                 const Disturbance* noise);

}  // namespace darwinop::gap
