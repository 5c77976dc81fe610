// Stands up from the start pose, knees straight, holds that for a second, then cuts the torque of all joints.
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>
#include <webots/Motor.hpp>
#include <webots/Robot.hpp>

using namespace webots;

namespace {

struct Joint {
  Motor* motor;
  double from;  // rad, start pose; to: 0
};

// The start pose of the legs, rad (ids 7 to 18), and the pose with straight legs: all zero.
const char* const kLegs[] = {"PelvY", "Pelv", "LegUpper", "LegLower", "Ankle", "Foot"};
const double kRight[] = {-0.01, 0.01, -1.18, 2.25, 1.22, 0.04};
const double kLeft[] = {-0.02, -0.01, 1.15, -2.25, -1.24, -0.02};

/// Runs for so long; calls `each` with the share of the time that has gone, 0..1. Ends the program on request.
template <class F>
void during(Robot& robot, double seconds, F each) {
  const int step_ms = static_cast<int>(robot.getBasicTimeStep());
  const double start = robot.getTime();
  while (robot.getTime() - start < seconds) {
    each((robot.getTime() - start) / seconds);
    if (robot.step(step_ms) == -1) {
      std::cout << "step() = -1" << std::endl;
      std::exit(1);
    }
  }
}

}  // namespace

int main() {
  Robot robot;
  std::vector<Joint> legs;
  for (int i = 0; i < 6; ++i) {
    legs.push_back({robot.getMotor(std::string(kLegs[i]) + "R"), kRight[i]});
    legs.push_back({robot.getMotor(std::string(kLegs[i]) + "L"), kLeft[i]});
  }
  during(robot, 4, [&](double share) {
    const double left = 0.5 + 0.5 * std::cos(share * 3.14159265);  // starts and ends softly
    for (const Joint& joint : legs) joint.motor->setPosition(joint.from * left);
  });
  during(robot, 1, [](double) {});
  std::cout << "stood" << std::endl;
  for (int i = 0; i < robot.getNumberOfDevices(); ++i)
    if (auto* const motor = dynamic_cast<Motor*>(robot.getDeviceByIndex(i)); motor != nullptr)
      motor->setAvailableTorque(0);
  during(robot, 3, [](double) {});
  std::cout << "done" << std::endl;
  return 0;
}
