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
constexpr double kStanceS = 4.3;  // 2.7 to the stance, 1.6 for the gyroscope
constexpr double kForwardS = 12, kStandingS = 1.5;
constexpr double kQuarterTurn = 90 * kRadPerDegree, kLongestTurnS = 10;
constexpr double kFallen = 0.5;            // cosine of the trunk's lean
constexpr double kKinematicSpeed = 0.133;  // m/s of feet that do not slip, docs/gait.md

class WalkDemo {
 public:
  explicit WalkDemo(const twin::ShowOptions& options) : robot_{options}, gait_{&robot_, "/dev/null"} {}

  int run() {
    const auto begin = std::chrono::steady_clock::now();
    if (story()) std::puts("It stands.");
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (fell_) std::puts("It fell.");
    std::printf("%.1f s of the robot in %.1f s\n", robot_.getTime(), took);
    robot_.finish();
    return fell_ ? 1 : 0;
  }

 private:
  /// False: it did not come to the end.
  bool story() {
    gait_.start();
    if (!steps(kStanceS)) return false;
    tell("got up to its stance");

    gait_.setXAmplitude(1);
    const std::array<double, 3> from = robot_.body().trunkPosition();
    if (!steps(kForwardS)) return false;
    const std::array<double, 3> to = robot_.body().trunkPosition();
    const double forward = to[0] - from[0], left = to[1] - from[1];
    tell("walked %.2f m in %.0f s (its legs promise %.2f), %.2f m to the left; leant by %.0f degrees at most", forward,
         kForwardS, kKinematicSpeed * kForwardS, left, std::acos(lowest_) / kRadPerDegree);

    gait_.setXAmplitude(0);
    gait_.setAAmplitude(0.5);
    turned_ = 0;
    const double turn_end = robot_.getTime() + kLongestTurnS;
    while (turned_ < kQuarterTurn && robot_.getTime() < turn_end)
      if (!step()) return false;
    gait_.setAAmplitude(0);
    gait_.stop();  // steps to the end, with both feet down
    if (!look()) return false;
    tell("turned by %.0f degrees to the left, and stopped", turned_ / kRadPerDegree);
    for (const double end = robot_.getTime() + kStandingS; robot_.getTime() < end;)
      if (robot_.step(kStepMs) == -1) return false;
    return look();
  }

  bool steps(double seconds) {
    for (const double end = robot_.getTime() + seconds; robot_.getTime() < end;)
      if (!step()) return false;
    return true;
  }
  bool step() {
    gait_.step(kStepMs);
    return robot_.step(kStepMs) != -1 && look();
  }
  bool look() {
    const twin::RobotBody& body = robot_.body();
    turned_ += std::remainder(body.heading() - heading_, 2 * kPi);
    heading_ = body.heading();
    lowest_ = std::min(lowest_, body.upright());
    fell_ = lowest_ < kFallen;
    return !fell_;
  }

  template <class... Numbers>
  void tell(const char* what, Numbers... numbers) const {
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
  double lowest_ = 1, heading_ = 0, turned_ = 0;
  bool fell_ = false;
};

}  // namespace

int walk(const twin::ShowOptions& options) {
  return WalkDemo{options}.run();
}

}  // namespace darwinop::demo
