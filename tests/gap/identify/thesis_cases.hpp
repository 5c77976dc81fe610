// The findings of the 2013 thesis (chapters 3 and 5) that one servo can show, as cases made from its printed numbers.
// docs/gap/thesis.md compares what was found then with the results here.
#pragma once

#include "gap/case/case.hpp"

namespace darwinop::gap::thesis {

/// T1, 5.3.1: head sweeps of 90 degrees to both sides at six speeds; the simulator's motor has no limit of
/// acceleration, the robot's has 55 rad/s2.
Case speedTest();
/// T2, 5.3.2: the arm is released at 90 degrees; the simulator has no friction, the robot 0.002 N m s/rad and 0.025 N
/// m.
Case freeSwing();
/// T3, 5.3.3: the arm is raised with several P gains; P sets a speed in the simulator and the torque in the robot.
Case lowGainStep();
/// T4, 5.3.4: the arm goes up and down slowly; the load is logged with the wrong sign.
Case mirroredLoad();
/// T7, 5.3.5 and 5.3.6: the arm only ever rises, and needs a little more torque than the simulated one.
Case risingArm();
/// T8, 3.1.7: kicks to the right and to the left that are not each other's mirror image. The model is right.
Case kicks();

}  // namespace darwinop::gap::thesis
