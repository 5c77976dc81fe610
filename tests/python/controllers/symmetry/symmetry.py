"""controllers/02_symmetry in Python: the left arm mirrors the right one, which is limp."""

import math
import sys

from controller import Robot

end = float(sys.argv[2]) if len(sys.argv) > 2 and sys.argv[1] == "--seconds" else math.inf
robot = Robot()
time_step = int(robot.getBasicTimeStep())

right, left = [], []
for joint in ("Shoulder", "ArmUpper", "ArmLower"):
    sensor = robot.getPositionSensor(joint + "RS")
    sensor.enable(time_step)
    right.append(sensor)
    robot.getMotor(joint + "R").setAvailableTorque(0)
    motor = robot.getMotor(joint + "L")
    motor.setVelocity(3)
    left.append(motor)

while robot.step(time_step) != -1 and robot.getTime() < end:
    for sensor, motor in zip(right, left):
        angle = sensor.getValue()
        if math.isnan(angle):
            continue
        motor.setPosition(max(motor.getMinPosition(), min(motor.getMaxPosition(), -angle)))
