// A whole robot for other simulators.
#include <gmock/gmock.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "core/registers.hpp"
#include "gap/export/body_rig.hpp"
#include "gap/export/texts.hpp"

namespace darwinop::gap {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

TEST(BodyForMujoco, HasTheMassesFloorAndSensorsOfTheModel) {
  const twin::Model model = robotWith(
      "[body]\nfloor_friction = 0.3\nfloor_tilt_x = 0.04 rad\nsole_size = 0.8\n[link ArmLowerR]\nmass = 0.055 kg\n"
      "[imu]\nmounting = 0.1, 0, 0 rad\n[effect com_mass LegLowerL]\nmass = 0.2\nshift = 0 m\n");
  const twin::MjModelPtr now = loadedByMujoco(exportBody(Target::kMujoco, model, {}).text);
  ASSERT_NE(now, nullptr);
  const twin::MjModelPtr was = twin::loadBody(model, false);
  const twin::BodyMap at = twin::mapBody(*was, "was"), there = twin::mapBody(*now, "now");
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double factor = static_cast<Joint>(i) == Joint::kLegLowerL ? 1.2 : 1;
    EXPECT_NEAR(now->body_mass[there.link[i]], factor * was->body_mass[at.link[i]], 1e-6) << kJointTable[i].name;
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(now->body_ipos[3 * there.link[i] + axis], was->body_ipos[3 * at.link[i] + axis], 1e-6);
  }
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(now->opt.gravity[axis], was->opt.gravity[axis], 1e-5);
  EXPECT_NEAR(now->pair_friction[0], 0.3, 1e-6);
  EXPECT_EQ(now->nu, 2 * static_cast<int>(kJoints));  // a controller and a back EMF each
  EXPECT_EQ(now->nsensor, 2);
  mjtNum turned[4], straight[4] = {1, 0, 0, 0};
  const twin::MjModelPtr shipped = twin::loadBody(robotWith(""), false);
  mju_negQuat(straight, shipped->site_quat + 4 * twin::mapBody(*shipped, "s").gyro);
  mju_mulQuat(turned, now->site_quat + 4 * there.gyro, straight);
  EXPECT_NEAR(2 * std::acos(std::abs(turned[0])), 0.1, 1e-4);
}

TEST(BodyForMujoco, HoldsItsPoseByItsOwnActuators) {
  const twin::MjModelPtr m =
      loadedByMujoco(exportBody(Target::kMujoco, twin::readModel(twin::findModel("darwin-op")), {}).text);
  ASSERT_NE(m, nullptr);
  const twin::MjDataPtr d = twin::dataFor(*m, "robot");
  for (int i = 0; i < 500; ++i) mj_step(m.get(), d.get());
  const twin::BodyMap map = twin::mapBody(*m, "robot");
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(d->qpos[map.qpos[i]], 0, 0.1) << kJointTable[i].name;
  EXPECT_NEAR(d->qpos[map.trunk_qpos + 2], 0.342, 0.01);
}

TEST(BodyForWebotsAndUrdf, HaveNumbersOfEachLinkAndJoint) {
  const twin::Model model = robotWith("[link Body]\nmass = 0.024 kg\n[body]\nfloor_tilt_y = 0.04 rad\n");
  const Export webots = exportBody(Target::kWebots, model, {}), urdf = exportBody(Target::kUrdf, model, {});
  for (const JointRow& joint : kJointTable) {
    EXPECT_THAT(webots.text, HasSubstr("name \"" + std::string{joint.name} + "\""));
    EXPECT_THAT(urdf.text, HasSubstr("\"" + std::string{joint.name} + "\" type="));
  }
  const twin::MjModelPtr body = twin::loadBody(model, false);
  EXPECT_THAT(webots.text, HasSubstr("# Solid Body, without the servo's armature\nPhysics {\n  density -1\n  mass " +
                                     shortest(body->body_mass[twin::mapBody(*body, "body").trunk]) + "\n"));
  EXPECT_THAT(webots.text, HasSubstr("Floor {\n  rotation 0 1 0 0.04\n}"));
  EXPECT_THAT(urdf.lost, Contains(HasSubstr("[body] floor_tilt_y = 0.04 rad")));
  EXPECT_THAT(webots.lost, Not(Contains(HasSubstr("floor_tilt"))));
}

/// What Webots returns for a measured value: rows of value, count, noise; between them a line, beyond them the ends.
double countOf(double value, const std::string& text, const std::string& node) {
  const std::string table = "lookupTable [ ";
  double low = 0, least = 0, noise = 0, high = 0, most = 0;
  char comma = 0;
  std::istringstream rows{text.substr(text.find(table, text.find("\n" + node + " {")) + table.size())};
  rows >> low >> least >> noise >> comma >> high >> most;
  return std::lerp(least, most, std::clamp((value - low) / (high - low), 0.0, 1.0));
}

// As getLookupTable() of the runtime, and the simulator's own robot.
TEST(BodyForWebots, SensorsReturnTheCountsThatControllersExpect) {
  const std::string shipped = exportBody(Target::kWebots, robotWith(""), {}).text;
  const double per_count = find(kCm730, "gyro_x").scale;
  EXPECT_NEAR(countOf(0, shipped, "Gyro"), 512, 1e-9);
  EXPECT_NEAR(countOf(100 * per_count, shipped, "Gyro"), 612, 1e-9);
  EXPECT_NEAR(countOf(1000 * per_count, shipped, "Gyro"), 1024, 1e-9);
  EXPECT_NEAR(countOf(0, shipped, "Accelerometer"), 512, 1e-9);
  EXPECT_NEAR(countOf(kGravity, shipped, "Accelerometer"), 640, 1e-9);

  const std::string less = exportBody(Target::kWebots, robotWith("[imu]\naccel_range = 19.6133 m/s2\n"), {}).text;
  EXPECT_NEAR(countOf(kGravity, less, "Accelerometer"), 640, 1e-9);
  EXPECT_NEAR(countOf(-3 * kGravity, less, "Accelerometer"), 512 - 256, 1e-9) << "saturates at 2 g";
}

/// Angle between two orientations of the neck in the trunk, where its encoder reads `one_rad` and `other_rad`.
double differenceOfNecks(const mjModel& one, double one_rad, const mjModel& other, double other_rad) {
  const auto neckAt = [](const mjModel& m, double angle_rad) {
    const twin::MjDataPtr d = twin::dataFor(m, "robot");
    d->qpos[m.jnt_qposadr[mj_name2id(&m, mjOBJ_JOINT, "Neck")]] = angle_rad;
    mj_kinematics(&m, d.get());
    const int trunk = std::max(0, mj_name2id(&m, mjOBJ_BODY, "Body"));  // of a URDF it is the world
    std::array<mjtNum, 4> back{}, out{};
    mju_negQuat(back.data(), d->xquat + 4 * trunk);
    mju_mulQuat(out.data(), back.data(), d->xquat + 4 * mj_name2id(&m, mjOBJ_BODY, "Neck"));
    return out;
  };
  const auto a = neckAt(one, one_rad), b = neckAt(other, other_rad);
  return 2 * std::acos(std::min(1.0, std::abs(mju_dot(a.data(), b.data(), 4))));
}

TEST(BodyForMujocoAndUrdf, AnEncoderOffsetTurnsTheLinkAndLeavesItsStops) {
  const twin::MjModelPtr straight = twin::loadBody(robotWith(""), false);
  const twin::Model model = robotWith("[effect encoder_offset Neck]\noffset = 0.1 rad\n");
  for (const auto& [target, suffix] : {std::pair{Target::kMujoco, ".xml"}, std::pair{Target::kUrdf, ".urdf"}}) {
    const twin::MjModelPtr off = loadedByMujoco(exportBody(target, model, {}).text, suffix);
    ASSERT_NE(off, nullptr);
    EXPECT_LT(differenceOfNecks(*straight, 0, *off, 0.1), 1e-3) << suffix;
    EXPECT_LT(differenceOfNecks(*straight, 0.3, *off, 0.4), 1e-3) << suffix;
    const int was = mj_name2id(straight.get(), mjOBJ_JOINT, "Neck"), is = mj_name2id(off.get(), mjOBJ_JOINT, "Neck");
    for (int end = 0; end < 2; ++end)
      EXPECT_NEAR(off->jnt_range[2 * is + end], straight->jnt_range[2 * was + end] + 0.1, 1e-5) << suffix;
  }
}

}  // namespace
}  // namespace darwinop::gap
