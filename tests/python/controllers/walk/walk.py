"""controllers/05_walk --seconds in Python, without getting up: gait and motion managers."""

import sys

from controller import Robot
from managers import DARwInOPGaitManager, DARwInOPMotionManager, RobotisOp2GaitManager, RobotisOp2MotionManager

seconds = float(sys.argv[2]) if len(sys.argv) > 2 else 1
robot = Robot()
time_step = int(robot.getBasicTimeStep())
accelerometer = robot.getAccelerometer("Accelerometer")
accelerometer.enable(time_step)
motion = RobotisOp2MotionManager(robot)
gait = RobotisOp2GaitManager(robot, "config.ini")
if not gait.isCorrectlyInitialized():
    sys.exit(1)
assert isinstance(gait, DARwInOPGaitManager) and isinstance(motion, DARwInOPMotionManager)

gait.setXAmplitude(1)
gait.setYAmplitude(0)
gait.setAAmplitude(0)
gait.start()
end = robot.getTime() + 4.3 + seconds
while robot.getTime() < end:
    gait.step(time_step)
    if robot.step(time_step) == -1:
        sys.exit(1)
gait.stop()
print("stands:", accelerometer.getValues()[2] > 550)
