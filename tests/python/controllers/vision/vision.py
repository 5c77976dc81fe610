"""Looks for the ball, in the style of the simulator's visual tracking example."""

from controller import Camera, Robot
from managers import RobotisOp2VisionManager


class VisualTracking(Robot):
    def __init__(self):
        super().__init__()
        self.timestep = int(self.getBasicTimeStep())
        self.camera = self.getDevice("Camera")
        self.camera.enable(2 * self.timestep)
        self.neck = self.getDevice("Neck")
        self.head = self.getDevice("Head")
        self.width, self.height = self.camera.getWidth(), self.camera.getHeight()
        # From red to orange.
        self.vision = RobotisOp2VisionManager(self.width, self.height, 10, 35, 50, 45, 0, 30)

    def run(self):
        while self.step(self.timestep) != -1 and self.getTime() < 1.0:
            found, x, y = self.vision.getBallCenter(self.camera.getImage())
            if found:
                self.neck.setPosition(0.5 * (0.5 - x / self.width))
                self.head.setPosition(0.5 * (0.5 - y / self.height))
        image, array = self.camera.getImage(), self.camera.getImageArray()
        x, y = int(x), int(y)
        print("found:", found)
        print("red:", array[x][y][0] == Camera.imageGetRed(image, self.width, x, y) > 100)
        print("bytes:", len(image) == 4 * self.width * self.height)


VisualTracking().run()
