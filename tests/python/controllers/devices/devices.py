"""A loop with getDevice(), as in today's tutorials: every arm joint goes to its place."""

from controller import Robot, Motor, PositionSensor, Gyro, Accelerometer, LED, GPS

TIME_STEP = 32
GOALS = {"ShoulderR": -0.5, "ShoulderL": 0.5, "ArmLowerR": 0.4, "ArmLowerL": -0.4, "Neck": 0.3}

robot = Robot()
timestep = int(robot.getBasicTimeStep())

gps = robot.getDevice("gps")
print("gps:", gps)

motors = []
sensors = {}
for name, goal in GOALS.items():
    motor = robot.getDevice(name)
    motor.setVelocity(3.0)
    motors.append(motor)
    sensors[name] = robot.getDevice(name + "S")
    sensors[name].enable(timestep)
robot.getDevice("HeadLed").set(0xFF0000)
gyro = robot.getDevice("Gyro")
gyro.enable(timestep)

steps = 0
while robot.step(TIME_STEP) != -1 and steps < 40:
    for motor in motors:
        motor.setPosition(GOALS[motor.getName()])
    steps += 1

far = [name for name, goal in GOALS.items() if not abs(sensors[name].getValue() - goal) < 0.05]
print("far:", far)
print("gyro:", gyro.getValues())
