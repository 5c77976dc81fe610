// Gait parameters of the public header, converted and checked.
#include "managers/gait_parameters.hpp"

namespace managers {

namespace {

using Public = DARwInOPGaitManager::GaitParameters;
using Inside = darwinop::gait::Parameters;

struct Field {
  double Public::*outside;
  double Inside::*inside;
};

// Without i_gain and d_gain, which have no effect on this robot.
constexpr Field kFields[] = {
    {&Public::x_offset, &Inside::x_offset},
    {&Public::y_offset, &Inside::y_offset},
    {&Public::z_offset, &Inside::z_offset},
    {&Public::roll_offset, &Inside::roll_offset},
    {&Public::pitch_offset, &Inside::pitch_offset},
    {&Public::yaw_offset, &Inside::yaw_offset},
    {&Public::hip_pitch_offset, &Inside::hip_pitch_offset},
    {&Public::period_time, &Inside::period_time},
    {&Public::dsp_ratio, &Inside::dsp_ratio},
    {&Public::step_forward_back_ratio, &Inside::step_forward_back_ratio},
    {&Public::foot_height, &Inside::foot_height},
    {&Public::swing_right_left, &Inside::swing_right_left},
    {&Public::swing_top_down, &Inside::swing_top_down},
    {&Public::pelvis_offset, &Inside::pelvis_offset},
    {&Public::arm_swing_gain, &Inside::arm_swing_gain},
    {&Public::balance_knee_gain, &Inside::balance_knee_gain},
    {&Public::balance_ankle_pitch_gain, &Inside::balance_ankle_pitch_gain},
    {&Public::balance_hip_roll_gain, &Inside::balance_hip_roll_gain},
    {&Public::balance_ankle_roll_gain, &Inside::balance_ankle_roll_gain},
    {&Public::p_gain, &Inside::p_gain},
};

}  // namespace

DARwInOPGaitManager::GaitParameters::GaitParameters() {
  const Inside defaults;
  for (const Field& field : kFields) this->*field.outside = defaults.*field.inside;
}

Public publicParameters(const Inside& inside) {
  Public parameters;
  for (const Field& field : kFields) parameters.*field.outside = inside.*field.inside;
  return parameters;
}

void assign(Inside& inside, const Public& parameters) {
  for (const Field& field : kFields) inside.*field.inside = parameters.*field.outside;
}

}  // namespace managers
