"""A class that inherits Robot, with its devices as attributes and properties in place of setters."""

import math
import sys

from controller import Keyboard, Robot


class Nodding(Robot):
    def __init__(self, seconds):
        super(Nodding, self).__init__()
        self.timeStep = int(self.getBasicTimeStep())
        self.seconds = seconds
        self.keyboard = Keyboard()
        self.name = "a name of its own"
        self.neck = self.getDevice("Neck")
        self.neck.velocity = 2.0
        self.neckSensor = self.neck.getPositionSensor()
        self.neckSensor.enable(self.timeStep)

    def run(self):
        greatest = 0
        while self.step(self.timeStep) != -1:
            now = self.getTime()
            if now > self.seconds:
                break
            self.neck.target_position = 0.4 * math.sin(2 * math.pi * now)
            greatest = max(greatest, abs(self.neckSensor.value))
        print("nodded by more than 0.2 rad:", greatest > 0.2)


controller = Nodding(float(sys.argv[1]) if len(sys.argv) > 1 else 1.5)
controller.run()
