"""tests/system/all_joints_controller.cpp in Python: the same goals bit by bit, so change both."""

import math
import sys

from controller import Robot
from managers import RobotisOp2GaitManager, RobotisOp2MotionManager

JOINTS = ("ShoulderR ShoulderL ArmUpperR ArmUpperL ArmLowerR ArmLowerL PelvYR PelvYL PelvR PelvL LegUpperR LegUpperL "
          "LegLowerR LegLowerL AnkleR AnkleL FootR FootL Neck Head").split()
SWEEP_STEPS, REST_STEPS, WALK_STEPS = 64, 10, 60
FROM_SITTING_TO_STANCE = 1  # page


class Sweep:
    """A joint that leaves its place towards the middle of its range, by its own amplitude, and comes back."""

    def __init__(self, motor, size):
        self.motor = motor
        self.start = motor.getTargetPosition()
        self.amplitude = size if motor.getMinPosition() + motor.getMaxPosition() > 2 * self.start else -size

    def set(self, step):
        self.motor.setPosition(self.start + self.amplitude * (1 - math.cos(step * 2 * math.pi / SWEEP_STEPS)))


def step():
    if robot.step(step_ms) == -1:
        sys.exit(1)


def rest():
    for _ in range(REST_STEPS):
        step()


robot = Robot()
step_ms = int(robot.getBasicTimeStep())
motion = RobotisOp2MotionManager(robot)
gait = RobotisOp2GaitManager(robot, "config.ini")
gait.setBalanceEnable(False)
sweeps = [Sweep(robot.getMotor(joint), 0.04 + 0.004 * i) for i, joint in enumerate(JOINTS)]

for i in range(1, SWEEP_STEPS + 1):
    for sweep in sweeps:
        sweep.set(i)
    step()
rest()
motion.playPage(FROM_SITTING_TO_STANCE)
rest()
gait.setXAmplitude(0.5)
gait.start()
for _ in range(WALK_STEPS):
    gait.step(step_ms)
    step()
gait.stop()
rest()
print("done")
