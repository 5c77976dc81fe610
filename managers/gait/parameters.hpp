// Gait parameters: table of names, defaults, ranges and units of [Walking Config], used by parser, tests and docs.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace darwinop::gait {

/// Inverse kinematics. Users' gaits were tuned with kFlawed, see leg.hpp.
enum class Ik : std::uint8_t { kFlawed, kExact };

struct Parameters {
  double x_offset = -10, y_offset = 5, z_offset = 20;
  double roll_offset = 0, pitch_offset = 0, yaw_offset = 0, hip_pitch_offset = 13;
  double period_time = 600, dsp_ratio = 0.1, step_forward_back_ratio = 0.28;
  double foot_height = 40, swing_right_left = 20, swing_top_down = 5, pelvis_offset = 3;
  double arm_swing_gain = 1.5;
  double balance_knee_gain = 0.3, balance_ankle_pitch_gain = 0.9;
  double balance_hip_roll_gain = 0.5, balance_ankle_roll_gain = 1.0;
  double p_gain = 32, i_gain = 0, d_gain = 0;
  Ik ik = Ik::kFlawed;
};

struct ParameterRow {
  std::string_view name;
  double Parameters::*field;
  double low, high;
  std::string_view unit, meaning;
};

// Source of names and defaults: the ROBOTIS walking engine, 1.6. Ranges: kinematic limits of two legs of 219.5 mm; in
// most of each range the robot falls on a real floor.
inline constexpr auto kParameters = std::to_array<ParameterRow>({
    {"x_offset", &Parameters::x_offset, -60, 60, "mm", "both feet forwards"},
    {"y_offset", &Parameters::y_offset, -20, 100, "mm", "feet apart, half of it each"},
    {"z_offset", &Parameters::z_offset, 5, 80, "mm", "crouching"},
    {"roll_offset", &Parameters::roll_offset, -30, 30, "deg", "soles rolled inwards or outwards, half of it each"},
    {"pitch_offset", &Parameters::pitch_offset, -30, 30, "deg", "soles pitched"},
    {"yaw_offset", &Parameters::yaw_offset, -60, 60, "deg", "feet turned outwards, half of it each"},
    {"hip_pitch_offset", &Parameters::hip_pitch_offset, -30, 45, "deg", "trunk leans forwards"},
    {"period_time", &Parameters::period_time, 240, 3000, "ms", "two steps"},
    {"dsp_ratio", &Parameters::dsp_ratio, 0, 0.8, "-", "share of the period with both feet down"},
    {"step_forward_back_ratio", &Parameters::step_forward_back_ratio, -1, 1, "-",
     "swing of the body forwards, as a share of the step"},
    {"foot_height", &Parameters::foot_height, 0, 80, "mm", "lift of a foot"},
    {"swing_right_left", &Parameters::swing_right_left, 0, 60, "mm", "swing of the body to the sides"},
    {"swing_top_down", &Parameters::swing_top_down, 0, 30, "mm", "swing of the body up and down"},
    {"pelvis_offset", &Parameters::pelvis_offset, -15, 15, "deg", "extra hip roll on one foot"},
    {"arm_swing_gain", &Parameters::arm_swing_gain, -5, 5, "deg/mm", "swing of the arms a mm of step"},
    {"balance_knee_gain", &Parameters::balance_knee_gain, 0, 5, "-", "gyro to knees"},
    {"balance_ankle_pitch_gain", &Parameters::balance_ankle_pitch_gain, 0, 5, "-", "gyro to ankle pitch"},
    {"balance_hip_roll_gain", &Parameters::balance_hip_roll_gain, 0, 5, "-", "gyro to hip roll"},
    {"balance_ankle_roll_gain", &Parameters::balance_ankle_roll_gain, 0, 5, "-", "gyro to ankle roll"},
    {"p_gain", &Parameters::p_gain, 8, 254, "register", "stiffness of the legs; 8 is Kp = 1"},
    {"i_gain", &Parameters::i_gain, 0, 254, "register", "no effect on this robot"},
    {"d_gain", &Parameters::d_gain, 0, 254, "register", "no effect on this robot"},
});

}  // namespace darwinop::gait
