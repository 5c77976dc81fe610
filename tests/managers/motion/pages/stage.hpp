// The twin as a stage for pages: plays one, tick for tick as the motion manager does, and watches what the body and its
// servos go through. Limbs push each other here, as they do on the robot.
#pragma once

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "managers/motion/pages/promised_poses.hpp"
#include "twin/body/mujoco_model.hpp"
#include "twin/body/robot_body.hpp"

namespace darwinop::motion {

/// What a page did. Torques are shares of the stall torque, of the worst joint.
struct Watched {
  double seconds = 0;              // of the page
  double peak = 0;                 // greatest torque
  double mean = 0;                 // root mean square over the page
  double full_s = 0;               // longest time at full voltage without a break
  std::string full_joint;          // whose
  bool overload = false;           // a servo's protection tripped
  double lowest = 1;               // upright at worst
  std::set<std::string> touching;  // pairs of shapes of the robot that met, deeper than kTouch
};

/// A robot that lies: where everything is, and what its servos were told.
struct Lying {
  std::vector<double> places;
  Pose goals{};
};

struct StageOptions {
  const char* model = "darwin-op";
  double floor_friction = 1;
  double supply_v = 12;
  bool ball = false;
};

class Stage {
 public:
  static constexpr Nanos kTick{8'000'000};
  static constexpr double kTouch = 0.0005;  // m; less is how boxes rest on each other
  static constexpr double kFull = 0.97;     // of the voltage

  explicit Stage(const StageOptions& options = {}) : options_{options} {
    twin::Model model = twin::readModel(twin::findModel(options.model));
    model.body.floor_friction = options.floor_friction;
    model.body.self_collision = true;
    // Law voltage_p: the load is the share of the voltage, and a turning motor gives some of it back.
    if (model.servo.law == twin::Law::kVoltageP) back_emf_share_ = model.servo.back_emf_vs_rad / options.supply_v;
    body_ = std::make_unique<twin::RobotBody>(
        model, twin::RobotBodyOptions{.ball = options.ball ? twin::Ball::kRests : twin::Ball::kNone});
    map_ = twin::mapBody(*body_->mujocoModel(), model.body.xml);
  }

  /// In the start pose, its servos on.
  void sit() {
    hold(sitting());
    run(0.3);
  }
  /// In the stance, its trunk leaning as the gait wants it; arms may be elsewhere.
  void stand(const Pose& goals = stance()) {
    std::array<double, kJoints> angles{};
    for (std::size_t i = 0; i < kJoints; ++i) angles[i] = radFromTicks(goals[i]).value;
    body_->place(angles, gait::Parameters{}.hip_pitch_offset * kRadPerDegree);
    hold(goals);
    run(0.5);
  }
  /// Pushed over from where it stands, forwards or backwards, and come to rest there.
  Lying pushOver(bool forwards, double aside_n = 0) {
    constexpr double kForce = 20, kTipped = 0.7;  // N; upright
    for (int i = 0; i < 250 && body_->upright() > kTipped; ++i) {
      body_->push({forwards ? kForce : -kForce, aside_n, 0}, kTick);
      run(0.008);
    }
    run(2);
    const mjtNum* const places = body_->mujocoData()->qpos;
    return {{places, places + body_->mujocoModel()->nq}, goals_};
  }
  /// Lies there as that robot did; then its joints move to other goals.
  void lie(const Lying& lying, const Pose& goals) {
    std::array<double, kJoints> angles{};
    for (std::size_t i = 0; i < kJoints; ++i) angles[i] = lying.places[static_cast<std::size_t>(map_.qpos[i])];
    body_->place(angles);
    std::ranges::copy(lying.places, body_->mujocoData()->qpos);
    mj_forward(body_->mujocoModel(), body_->mujocoData());
    hold(lying.goals);
    for (int i = 0; i < 60; ++i) {  // in half a second
      for (std::size_t j = 0; j < kJoints; ++j) goals_[j] = lying.goals[j] + (goals[j] - lying.goals[j]) * (i + 1) / 60;
      hold(goals_);
      run(0.008);
    }
    run(0.3);
  }

  /// The page, from where the robot is, and `after` more seconds.
  Watched play(const PageFile& pages, int page, double after_s = 0.8);

  /// Stands in the stance: upright, and as high as one does there.
  void expectStanding(const std::string& what) {
    EXPECT_TRUE(stands()) << what << ": upright " << body_->upright() << ", " << body_->trunkPosition()[2] << " m high";
    expectGoals(stance(), what);
  }
  void expectSitting(const std::string& what) {
    EXPECT_GT(body_->upright(), 0.97) << what;
    EXPECT_NEAR(body_->trunkPosition()[2], 0.234, 0.006) << what;
    expectGoals(sitting(), what);
  }

  [[nodiscard]] bool stands() { return body_->upright() > 0.95 && std::abs(body_->trunkPosition()[2] - 0.317) < 0.006; }
  /// The chest looks down.
  [[nodiscard]] bool liesOnFront() {
    const mjtNum* const turned = body_->mujocoData()->xmat + 9L * map_.trunk;
    return turned[8] < 0;  // world's up of the trunk's z, forward
  }
  [[nodiscard]] twin::RobotBody& body() { return *body_; }
  /// Middle of a shape, m, world.
  [[nodiscard]] std::array<double, 2> placeOf(const char* shape) {
    const mjData& d = *body_->mujocoData();
    const int geom = mj_name2id(body_->mujocoModel(), mjOBJ_GEOM, shape);
    return {d.geom_xpos[3 * geom], d.geom_xpos[3 * geom + 1]};
  }

 private:
  void hold(const Pose& goals) {
    goals_ = goals;
    for (std::size_t i = 0; i < kJoints; ++i)
      drives_[i] = {.torque_on = true,
                    .goal_rad = radFromTicks(goals[i]).value,
                    .speed_limit_rad_s = std::numeric_limits<double>::infinity(),
                    .torque_limit = 1,
                    .p_gain = 4,
                    .supply_v = options_.supply_v};
  }
  void run(double seconds) {
    for (int i = 0; i < std::lround(seconds / 0.008); ++i) body_->step(kTick, drives_);
  }
  void expectGoals(const Pose& promised, const std::string& what) {
    for (std::size_t i = 0; i < kJoints; ++i)
      EXPECT_NEAR(goals_[i], promised[i], 2) << what << ' ' << kJointTable[i].name;
  }
  void watchJoints(Watched& seen);
  void watchContacts(Watched& seen);

  StageOptions options_;
  std::unique_ptr<twin::RobotBody> body_;
  twin::BodyMap map_;
  Drives drives_{};
  Pose goals_{};
  double back_emf_share_ = 0;  // of the stall torque, lost a rad/s
  std::array<double, kJoints> squares_{}, full_for_{};
};

}  // namespace darwinop::motion
