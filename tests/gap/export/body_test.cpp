// A whole robot for other simulators.
#include <gmock/gmock.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/registers.hpp"
#include "gap/export/body/body_export.hpp"
#include "gap/export/body/body_holds.hpp"
#include "gap/export/texts.hpp"
#include "support/temporary_folder.hpp"
#include "twin/body/mujoco_model.hpp"
#include "twin/model/keys.hpp"

namespace darwinop::gap {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// The shipped robot with these lines.
twin::Model robotWith(const std::string& lines) {
  return twin::parseModel("[model]\nname = robot\n" + lines, "robot.ini");
}

twin::MjModelPtr loadedByMujoco(const std::string& xml) {
  const TemporaryFolder folder;
  const std::string path = folder / "robot.xml";
  std::ofstream{path} << xml;
  char why[500] = "";
  twin::MjModelPtr model{mj_loadXML(path.c_str(), nullptr, why, sizeof why)};
  EXPECT_NE(model, nullptr) << why;
  return model;
}

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
  EXPECT_THAT(webots.text, HasSubstr("Turn the floor by 0 rad about the world's x (forward), then by 0.04 rad"));
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

TEST(BodyLosses, NameWhatIsNotHeldAndTheJointsOfAnEffect) {
  const Export made =
      exportBody(Target::kMujoco,
                 robotWith("[imu]\ndelay = 0.02 s\n[effect stribeck Neck]\nfriction = 0.05 N m\n"
                           "speed = 0.2 rad/s\nexponent = 1\n[effect backlash AnkleR]\nplay = 0.01 rad\n"),
                 {});
  EXPECT_THAT(made.lost, Contains(HasSubstr("MuJoCo loses [imu] delay = 0.02 s")));
  EXPECT_THAT(made.lost, Contains(HasSubstr("stribeck (Neck)")));
  EXPECT_THAT(made.lost, Contains(HasSubstr("backlash (AnkleR)")));
}

// A new key of a model file needs a row.
TEST(KeyHoldings, HaveARowForEachKeyOfLinksBodyAndSensors) {
  for (const twin::KeyRow& key : twin::keyTable()) {
    const std::string_view kind = key.section.substr(0, key.section.find(' '));
    if (kind == "model" || kind == "servo" || key.key == "xml") continue;
    const auto all = keyHoldings();
    EXPECT_TRUE(
        std::ranges::any_of(all, [&](const KeyHolding& row) { return row.section == kind && row.row.what == key.key; }))
        << kind << ' ' << key.key;
  }
}

}  // namespace
}  // namespace darwinop::gap
