"""The older style: typed getters, keyboardEnable(), and a star import."""

from controller import *


class MyController(Robot):
    timeStep = 16

    def __init__(self):
        Robot.__init__(self)
        self.camera = self.getCamera("Camera")
        self.accelerometer = self.getAccelerometer("Accelerometer")
        self.accelerometer.enable(self.timeStep)
        self.led = self.getLED("EyeLed")
        self.keyboardEnable(self.timeStep)
        self.head = self.getMotor("Head")
        self.servo = self.getServo("Neck")
        self.headSensor = self.getPositionSensor("HeadS")
        self.headSensor.enable(self.timeStep)
        self.button = self.getTouchSensor("ButtonStart")
        self.distance = self.getDevice("ds0")

    def run(self):
        for i in range(60):
            if self.step(self.timeStep) == -1:
                break
            self.head.setPosition(0.2)
            self.servo.setPosition(-0.2)
            self.led.set(0x00FF00)
            if self.keyboardGetKey() == Robot.KEYBOARD_UP:
                break
        print("image:", self.camera.getImage())
        print("head:", abs(self.headSensor.getValue() - 0.2) < 0.05)
        print("up:", self.accelerometer.getValues()[2] > 600)
        print("led:", self.led.get() == 0x00FF00)
        print("arm:", self.getPositionSensor("ArmUpperLS").getValue())
        print("button:", self.button.getValue())
        print("distance:", self.distance)


controller = MyController()
controller.run()
