// MuJoCo reads the exported files and moves as this library predicts.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "gap/export/export_rig.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::gap {
namespace {

/// A joint in MuJoCo, from a text.
class RealMujoco {
 public:
  explicit RealMujoco(const std::string& xml, const char* suffix = ".xml") {
    const TemporaryFolder folder;
    const std::string path = folder / ("joint" + std::string{suffix});
    std::ofstream{path} << xml;
    char why[500] = "";
    model_ = mj_loadXML(path.c_str(), nullptr, why, sizeof why);
    if (model_ == nullptr) throw std::runtime_error(why);
    data_ = mj_makeData(model_);
  }
  ~RealMujoco() {
    mj_deleteData(data_);
    mj_deleteModel(model_);
  }
  RealMujoco(const RealMujoco&) = delete;
  RealMujoco& operator=(const RealMujoco&) = delete;

  void reset(double position_rad) {
    mj_resetData(model_, data_);
    data_->qpos[0] = position_rad;
  }
  void step(bool torque_on, double goal_rad) {
    if (torque_on != on_) std::swap(kept_, powerless());
    on_ = torque_on;
    data_->ctrl[0] = goal_rad;
    mj_step(model_, data_);
  }
  /// Of the link.
  [[nodiscard]] double link() const { return data_->qpos[0] + (model_->nq > 1 ? data_->qpos[1] : 0); }
  [[nodiscard]] double gear() const { return data_->qpos[0]; }
  [[nodiscard]] double sensed() const { return data_->sensordata[0]; }
  [[nodiscard]] const mjModel& model() const { return *model_; }

 private:
  // As the comment in the file says: gains to 0.
  std::vector<mjtNum>& powerless() {
    const auto gains = static_cast<std::size_t>(model_->nu) * mjNGAIN;
    static thread_local std::vector<mjtNum> now;
    now.assign(model_->actuator_gainprm, model_->actuator_gainprm + gains);
    now.insert(now.end(), model_->actuator_biasprm, model_->actuator_biasprm + gains);
    const std::vector<mjtNum> next = kept_.empty() ? std::vector<mjtNum>(2 * gains, 0) : kept_;
    std::copy_n(next.begin(), gains, model_->actuator_gainprm);
    std::copy_n(next.begin() + static_cast<std::ptrdiff_t>(gains), gains, model_->actuator_biasprm);
    return now;
  }

  mjModel* model_ = nullptr;
  mjData* data_ = nullptr;
  std::vector<mjtNum> kept_;
  bool on_ = true;
};

/// Steps, a sine, then limp.
double goalAt(double t) {
  if (t < 1) return 0.4;
  if (t < 2) return -0.7;
  return t < 3.5 ? 0.8 * std::sin(9 * (t - 2)) : 1.2;
}

/// Greatest difference between MuJoCo and our joint over 6 s, rad.
double difference(const Believed& model, double payload_kg) {
  const ExportSettings settings = forArm(payload_kg);
  RealMujoco real{exportTo(Target::kMujoco, model.get(), settings).text};
  const auto ours = jointFor(Target::kMujoco, model.get(), settings);
  const double h = settings.stepOf(Target::kMujoco);
  real.reset(0.2);
  ours->reset(0.2);
  const bool behind_play = model.get().find("backlash") != nullptr;
  double worst = 0;
  for (int i = 0; i * h < 6; ++i) {
    const bool on = i * h < 4;
    real.step(on, goalAt(i * h));
    ours->step(on, goalAt(i * h));
    worst = std::max(worst, std::abs((behind_play ? real.link() : real.gear()) - ours->position_rad()));
  }
  return worst;
}

// One constraint has a closed solution; MuJoCo's solver stops at 1e-8 of it.
constexpr double kSame = 1e-6;  // rad
// A stop that is hit a step earlier or later is another bounce.
constexpr double kSameAtStops = 1e-4;

TEST(ExportMujoco, ARigidJointMovesAsInMujoco) {
  EXPECT_LT(difference(Believed{}, 0.3), kSame);
}

TEST(ExportMujoco, FrictionHoldsAndBrakesAsInMujoco) {
  EXPECT_LT(difference(Believed{}.friction(), 0.3), kSame);
  EXPECT_LT(difference(Believed{}.friction(), 0.0), kSame);
}

TEST(ExportMujoco, LoadAndControllerEffectsMoveAsInMujoco) {
  Believed model;
  model.friction().with("com_mass", "mass", 0.2).with("encoder_offset", "offset", 0.1).with("gear_scale", "scale", 0.9);
  model.with("torque_limit", "duty", 0.4).with("derivative", "gain", 0.02).with("inertia", "change", 0.001);
  EXPECT_LT(difference(model, 0.2), kSame);
}

TEST(ExportMujoco, ABendingJointMovesAsInMujoco) {
  Believed model;
  model.friction().with("joint_flex", "stiffness", 30).with("joint_flex", "damping", 0.02);
  EXPECT_LT(difference(model, 0.3), kSame);
}

TEST(ExportMujoco, PlayMovesAsInMujoco) {
  Believed model;
  model.friction().with("backlash", "play", 0.02);
  EXPECT_LT(difference(model, 0.3), kSameAtStops);
}

TEST(ExportMujoco, AMotorOfSpeedMovesAsInMujoco) {
  Believed model;
  model.bySpeed().friction();
  EXPECT_LT(difference(model, 0.3), kSame);
}

TEST(ExportMujoco, TheEncoderReadsWithNoise) {
  RealMujoco real{exportTo(Target::kMujoco, Believed{}.get(), forArm()).text};
  real.reset(0.2);
  double square = 0;
  constexpr int kSteps = 100;
  for (int i = 0; i < kSteps; ++i) {
    const double before = real.link();  // sensors are read before a step moves the joint
    real.step(true, 0.2);
    square += std::pow(real.sensed() - before, 2) / kSteps;
  }
  EXPECT_NEAR(std::sqrt(square), 2 * std::numbers::pi / 4096 / std::sqrt(12.0), 1e-4);
}

// MuJoCo reads URDF too.
TEST(ExportMujoco, TheUrdfIsReadAsItWasMeant) {
  Believed model;
  model.friction().with("encoder_offset", "offset", 0.1);
  const ExportSettings settings = forArm();
  const RealMujoco real{exportTo(Target::kUrdf, model.get(), settings).text, ".urdf"};
  const mjModel& m = real.model();
  ASSERT_EQ(m.nv, 1);
  EXPECT_DOUBLE_EQ(m.dof_damping[0], 0.01);
  EXPECT_DOUBLE_EQ(m.dof_frictionloss[0], 0.06);
  EXPECT_DOUBLE_EQ(m.body_mass[m.nbody - 1], 0.34);
  const ArmNumbers arm = armOf(model.get(), settings.payload_kg);
  EXPECT_NEAR(m.body_inertia[3 * (m.nbody - 1)] + arm.mass_kg * arm.com_m * arm.com_m, arm.inertia_kgm2 + 0.003, 1e-12);
}

}  // namespace
}  // namespace darwinop::gap
