// Walking demo: stance, walk, turn, stop, with measured distances.
#include "apps/demo/walk.hpp"

#include <DARwInOPGaitManager.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "apps/demo/shown_robot.hpp"
#include "core/units.hpp"

namespace darwinop::demo {

namespace {

constexpr int kStepMs = 16;
constexpr double kStanceS = 4.3;  // 2.7 to reach the stance, 1.6 to calibrate the gyroscope
constexpr double kForwardS = 12, kStandingS = 1.5;
constexpr double kQuarterTurn = 90 * kRadPerDegree, kMaxTurnS = 10;
constexpr double kFallen = 0.5;            // cosine of the trunk's tilt
constexpr double kKinematicSpeed = 0.133;  // m/s without slip, docs/gait.md

class WalkDemo {
 public:
  explicit WalkDemo(const twin::ShowOptions& options) : robot_{options}, gait_{&robot_, "/dev/null"} {}

  int run() {
    const auto begin = std::chrono::steady_clock::now();
    if (runSequence()) std::puts("The robot stands.");
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (fell_) std::puts("The robot fell.");
    std::printf("%.1f s simulated in %.1f s\n", robot_.getTime(), took);
    robot_.finish();
    return fell_ ? 1 : 0;
  }

 private:
  /// False if the robot fell or the user ended it.
  bool runSequence() {
    gait_.start();
    if (!steps(kStanceS)) return false;
    print(kStanceReached);

    gait_.setXAmplitude(1);
    const std::array<double, 3> from = robot_.body().trunkPosition();
    if (!steps(kForwardS)) return false;
    const std::array<double, 3> to = robot_.body().trunkPosition();
    const double forward = to[0] - from[0], left = to[1] - from[1];
    print("walked %.2f m in %.0f s (%.2f m by kinematics), %.2f m to the left; maximum tilt %.0f degrees", forward,
          kForwardS, kKinematicSpeed * kForwardS, left, std::acos(min_upright_) / kRadPerDegree);

    gait_.setXAmplitude(0);
    gait_.setAAmplitude(0.5);
    turned_ = 0;
    const double turn_end = robot_.getTime() + kMaxTurnS;
    while (turned_ < kQuarterTurn && robot_.getTime() < turn_end)
      if (!step()) return false;
    gait_.setAAmplitude(0);
    gait_.stop();  // returns after the last step, with both feet on the floor
    if (!measure()) return false;
    print("turned by %.0f degrees to the left and stopped", turned_ / kRadPerDegree);
    for (const double end = robot_.getTime() + kStandingS; robot_.getTime() < end;)
      if (robot_.step(kStepMs) == -1) return false;
    return measure();
  }

  bool steps(double seconds) {
    for (const double end = robot_.getTime() + seconds; robot_.getTime() < end;)
      if (!step()) return false;
    return true;
  }
  bool step() {
    gait_.step(kStepMs);
    return robot_.step(kStepMs) != -1 && measure();
  }
  bool measure() {
    const twin::RobotBody& body = robot_.body();
    turned_ += std::remainder(body.heading() - heading_, 2 * kPi);
    heading_ = body.heading();
    min_upright_ = std::min(min_upright_, body.upright());
    fell_ = min_upright_ < kFallen;
    return !fell_;
  }

  template <class... Numbers>
  void print(const char* what, Numbers... numbers) const {
    std::printf("%5.1f s  ", robot_.getTime());
    if constexpr (sizeof...(numbers) == 0)
      std::fputs(what, stdout);
    else
      std::printf(what, numbers...);
    std::putchar('\n');
    std::fflush(stdout);
  }

  ShownRobot robot_;
  managers::DARwInOPGaitManager gait_;
  double min_upright_ = 1, heading_ = 0, turned_ = 0;
  bool fell_ = false;
};

}  // namespace

int walk(const twin::ShowOptions& options) {
  return WalkDemo{options}.run();
}

}  // namespace darwinop::demo
