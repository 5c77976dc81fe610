// The twenty joints of a DARwIn-OP: ids, names, limits, start pose, wiring. The only copy of these values.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace darwinop {

inline constexpr std::size_t kJoints = 20;

/// Index of a joint in every per-joint array: servo id minus one. Odd ids are the robot's right side.
enum class Joint : std::uint8_t {
  kShoulderR,
  kShoulderL,
  kArmUpperR,
  kArmUpperL,
  kArmLowerR,
  kArmLowerL,
  kPelvYR,
  kPelvYL,
  kPelvR,
  kPelvL,
  kLegUpperR,
  kLegUpperL,
  kLegLowerR,
  kLegLowerL,
  kAnkleR,
  kAnkleL,
  kFootR,
  kFootL,
  kNeck,
  kHead,
};

/// Daisy chain of a servo. A broken lead disconnects this servo and all behind it.
enum class Chain : std::uint8_t { kRightArm, kLeftArm, kHead, kRightLeg, kLeftLeg };
inline constexpr std::array<std::string_view, 5> kChainNames{"right_arm", "left_arm", "head", "right_leg", "left_leg"};

struct JointRow {
  std::uint8_t id;              // Dynamixel id, 1..20
  std::string_view name;        // Webots device name; its position sensor is name + "S"
  std::string_view anatomical;  // for display
  Chain chain;
  std::uint16_t low, high;  // goal limits, ticks 0..4095 (2048 is 0 rad)
  std::uint16_t start;      // start pose (sitting), ticks
};

// Source: limits of the 2013 thesis, appendix A, in ticks; start pose of the same work.
// Sign: no joint is inverted; a rising tick turns the horn counter-clockwise and is a positive angle.
// Left and right partners are mounted mirrored: mirrored tick = 4096 - tick, mirrored angle = -angle.
//
// Where the sources disagree:
//  - ShoulderL high: the thesis says 3905, the code shipped since 2013 says 3095. 3905 is the mirror of
//    ShoulderR's low limit (4096 - 191) and is what the simulator allows (2.85 rad); 3095 looks like two
//    digits swapped. 3905 is used.
//  - AnkleR low: the thesis prints +1.24099 rad; 1239 ticks are -1.24099 rad. The tick is right.
//  - ShoulderR high: the thesis prints 4096, which a 12-bit encoder cannot hold; 4095 is used.
inline constexpr std::array<JointRow, kJoints> kJointTable{{
    {1, "ShoulderR", "right shoulder pitch", Chain::kRightArm, 191, 4095, 1500},
    {2, "ShoulderL", "left shoulder pitch", Chain::kLeftArm, 0, 3905, 2517},
    {3, "ArmUpperR", "right shoulder roll", Chain::kRightArm, 1605, 3548, 1834},
    {4, "ArmUpperL", "left shoulder roll", Chain::kLeftArm, 583, 2549, 2283},
    {5, "ArmLowerR", "right elbow", Chain::kRightArm, 970, 2804, 2380},
    {6, "ArmLowerL", "left elbow", Chain::kLeftArm, 1278, 3109, 1710},
    {7, "PelvYR", "right hip yaw", Chain::kRightLeg, 470, 2480, 2043},
    {8, "PelvYL", "left hip yaw", Chain::kLeftLeg, 1600, 3680, 2033},
    {9, "PelvR", "right hip roll", Chain::kRightLeg, 1390, 2708, 2057},
    {10, "PelvL", "left hip roll", Chain::kLeftLeg, 1400, 2650, 2043},
    {11, "LegUpperR", "right hip pitch", Chain::kRightLeg, 889, 2340, 1277},
    {12, "LegUpperL", "left hip pitch", Chain::kLeftLeg, 1724, 3145, 2797},
    {13, "LegLowerR", "right knee", Chain::kRightLeg, 2038, 3513, 3513},
    {14, "LegLowerL", "left knee", Chain::kLeftLeg, 571, 2067, 571},
    {15, "AnkleR", "right ankle pitch", Chain::kRightLeg, 1239, 2947, 2843},
    {16, "AnkleL", "left ankle pitch", Chain::kLeftLeg, 1142, 2845, 1240},
    {17, "FootR", "right ankle roll", Chain::kRightLeg, 1603, 2728, 2077},
    {18, "FootL", "left ankle roll", Chain::kLeftLeg, 1385, 2435, 2037},
    {19, "Neck", "head pan", Chain::kHead, 790, 3150, 2050},
    {20, "Head", "head tilt", Chain::kHead, 1815, 2660, 2173},
}};

constexpr const JointRow& row(Joint joint) {
  return kJointTable[static_cast<std::size_t>(joint)];
}
/// Dynamixel id of the joint with this index; jointTableIsSound() compares it with the table.
constexpr std::uint8_t servoId(std::size_t joint) {
  return static_cast<std::uint8_t>(joint + 1);
}
constexpr std::size_t index(Joint joint) {
  return static_cast<std::size_t>(joint);
}

/// All joints for which is(index) is true.
template <class Is>
constexpr std::bitset<kJoints> jointsThat(Is&& is) {
  const auto bit = [&](std::size_t i) { return static_cast<unsigned long>(static_cast<bool>(is(i))); };
  unsigned long bits = 0;
  static_assert(kJoints % 4 == 0);  // unrolled four times: loop overhead costs as much as setting one bit
  for (std::size_t i = 0; i < kJoints; i += 4)
    bits |= (bit(i) | bit(i + 1) << 1 | bit(i + 2) << 2 | bit(i + 3) << 3) << i;
  return bits;
}

/// Calls f(index) for each joint of `joints`, in order.
template <class F>
constexpr void forEachJoint(const std::bitset<kJoints>& joints, F&& f) {
  for (unsigned long rest = joints.to_ulong(); rest != 0; rest &= rest - 1)
    f(static_cast<std::size_t>(std::countr_zero(rest)));
}

/// The joints of `some` for which is(index) is true.
template <class Is>
constexpr std::bitset<kJoints> jointsThat(const std::bitset<kJoints>& some, Is&& is) {
  std::bitset<kJoints> joints;
  forEachJoint(some, [&](std::size_t i) { joints[i] = is(i); });
  return joints;
}

/// The joint with this Webots device name ("Neck"), or nothing.
constexpr std::optional<Joint> findJoint(std::string_view name) {
  for (std::size_t i = 0; i < kJoints; ++i)
    if (kJointTable[i].name == name) return static_cast<Joint>(i);
  return std::nullopt;
}

/// The table's spelling of `key`, compared without regard to (ASCII) case; `key` itself if it is not a joint's name.
constexpr std::string_view jointName(std::string_view key) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  const auto is_same = [&](char a, char b) { return lower(a) == lower(b); };
  for (const JointRow& joint : kJointTable)
    if (std::equal(joint.name.begin(), joint.name.end(), key.begin(), key.end(), is_same)) return joint.name;
  return key;
}

/// True for the joints of the two legs, ids 7..18.
constexpr bool isLeg(Joint joint) {
  return row(joint).id >= 7 && row(joint).id <= 18;
}

constexpr bool jointTableIsSound() {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointRow& r = kJointTable[i];
    if (r.id != servoId(i) || r.low >= r.high || r.high > 4095 || r.start < r.low || r.start > r.high) return false;
  }
  return true;
}
static_assert(jointTableIsSound());

}  // namespace darwinop
