"""Classes, names and values of the module, on a virtual robot in this process."""

import math
import os
import subprocess
import sys
import tempfile
import threading
import unittest

import _darwinop
import controller
import managers
from controller import Keyboard, LED, Motion, Motor, Node, PositionSensor, Robot

os.environ["DARWINOP_ROBOT"] = "virtual"
os.environ["DARWINOP_KEYS"] = "none"
robot = Robot()


class Api(unittest.TestCase):
    def test_a_device_has_the_class_that_its_name_means(self):
        for name, kind in {"Neck": Motor, "NeckS": PositionSensor, "EyeLed": LED, "Gyro": controller.Gyro,
                           "Accelerometer": controller.Accelerometer, "Camera": controller.Camera,
                           "Speaker": controller.Speaker, "ButtonMode": controller.TouchSensor}.items():
            self.assertIsInstance(robot.getDevice(name), kind)
            self.assertEqual(robot.getDevice(name).name, name)
        self.assertEqual(robot.getDevice("Neck").getNodeType(), Node.ROTATIONAL_MOTOR)

    def test_a_device_made_by_its_name_is_the_robots(self):
        for name, kind in {"Neck": Motor, "Head": controller.Servo, "NeckS": PositionSensor, "EyeLed": LED, "Gyro": controller.Gyro,
                           "Accelerometer": controller.Accelerometer, "Camera": controller.Camera,
                           "Speaker": controller.Speaker, "ButtonMode": controller.TouchSensor}.items():
            self.assertEqual(kind(name).getTag(), robot.getDevice(name).getTag())
        Motor("Neck").setPosition(0.125)
        self.assertEqual(robot.getDevice("Neck").target_position, 0.125)

        class Lamp(LED):
            def blink(self):
                self.set(0 if self.get() else 0xFF0000)

        lamp = Lamp("HeadLed")
        lamp.set(0)
        lamp.blink()
        self.assertEqual(robot.getDevice("HeadLed").get(), 0xFF0000)
        for kind, name in ((Motor, "Nose"), (Motor, "EyeLed"), (LED, "")):
            with self.assertRaises(ValueError):
                kind(name)

    def test_the_controllers_name_and_arguments_are_those_of_the_script(self):
        self.assertEqual(robot.getControllerName(), "api_test")
        self.assertEqual(robot.controller_arguments, " ".join(sys.argv[1:]))

    def test_each_device_of_the_robot_is_found_by_index(self):
        names = [robot.getDeviceByIndex(i).getName() for i in range(robot.number_of_devices)]
        self.assertEqual([robot.getDevice(name).getTag() for name in names], list(range(1, len(names) + 1)))
        self.assertIsNone(robot.getDeviceByIndex(len(names)))

    def test_a_button_has_one_value(self):
        button = robot.getDevice("ButtonMode")
        self.assertIsNone(button.getValues())
        self.assertEqual((button.lookup_table, button.lookup_table_size), ([], 0))

    def test_a_device_that_is_missing_is_none(self):
        self.assertIsNone(robot.getDevice("gps"))
        self.assertIsNone(robot.getMotor("NeckS"))
        self.assertIsNone(robot.getCamera("camera"))

    def test_getters_of_devices_that_the_robot_lacks_return_none(self):
        for name in ("GPS", "Compass", "Display", "DistanceSensor", "Receiver", "InertialUnit"):
            self.assertIsNone(getattr(robot, "get" + name)("Neck"))

    def test_a_joystick_and_a_mouse_of_the_controllers_own_are_not_connected(self):
        for joystick in (controller.Joystick(), robot.getJoystick()):
            joystick.enable(16)
            self.assertEqual((joystick.sampling_period, joystick.isConnected(), joystick.number_of_axes), (16, False, 0))
            self.assertEqual(joystick.getPressedButton(), -1)
        for mouse in (controller.Mouse(), robot.getMouse()):
            mouse.enable(32)
            state = mouse.getState()
            self.assertEqual((mouse.sampling_period, state.left), (32, False))
            self.assertTrue(math.isnan(state.u) and math.isnan(state.z))

    def test_recognition_of_objects_finds_none(self):
        camera = robot.getDevice("Camera")
        camera.recognitionEnable(16)
        self.assertEqual((camera.getRecognitionObjects(), camera.recognition_number_of_objects), ([], 0))
        self.assertIsNone(camera.getRecognitionSegmentationImage())
        self.assertEqual(controller.Camera.rangeImageGetDepth([0.5, 1, 1.5, 2], 2, 1, 0), 1)

    def test_properties_have_both_spellings_and_set_what_the_setter_sets(self):
        neck = robot.getDevice("Neck")
        neck.target_position = 0.1
        self.assertEqual(neck.getTargetPosition(), 0.1)
        neck.targetPosition = 0.2
        self.assertEqual(neck.target_position, 0.2)
        neck.velocity = 2
        self.assertEqual(neck.getVelocity(), 2.0)
        self.assertEqual((neck.min_position, neck.maxPosition), (neck.getMinPosition(), neck.getMaxPosition()))
        self.assertLess(neck.min_position, neck.max_position)
        self.assertEqual((robot.basic_time_step, robot.basicTimeStep), (16.0, 16.0))

    def test_an_attribute_of_ones_own_hides_a_property_that_can_only_be_read(self):
        neck = robot.getDevice("Neck")
        neck.tag = "mine"
        neck.new_attribute = 1
        self.assertEqual((neck.tag, neck.new_attribute), ("mine", 1))
        self.assertIs(robot.getDevice("Neck"), neck)
        del neck.tag
        self.assertEqual(neck.tag, neck.getTag())

    def test_a_step_moves_the_robot_and_the_time(self):
        head, sensor, before = robot.getDevice("Head"), robot.getDevice("HeadS"), robot.getTime()
        head.setPosition(0.3)
        for _ in range(50):
            self.assertEqual(robot.step(16), 0)
        self.assertAlmostEqual(robot.time - before, 0.8)
        self.assertAlmostEqual(sensor.value, 0.3, delta=0.02)
        self.assertEqual(sensor.getMotor(), head)

    def test_a_step_without_or_with_a_fractional_duration_is_one_of_whole_milliseconds(self):
        before = robot.time
        for _ in range(4):
            robot.step()
        robot.step(32.0)
        self.assertAlmostEqual(robot.time - before, 0.096)

    def test_values_of_three_axes_are_lists(self):
        robot.step(16)
        self.assertEqual(robot.getDevice("Accelerometer").getValues(), [512, 512, 640])
        self.assertEqual(len(robot.getDevice("Gyro").lookup_table), 6)

    def test_infinity_selects_velocity_control_and_nan_is_refused(self):
        head, sensor = robot.getDevice("Head"), robot.getDevice("HeadS")
        head.setPosition(float("-inf"))
        head.setVelocity(-1)
        before = sensor.value
        for _ in range(20):
            robot.step(16)
        self.assertLess(sensor.value, before - 0.1)
        head.setPosition(0.25)
        head.setVelocity(3)
        for _ in range(100):
            robot.step(16)
            head.setPosition(float("nan"))
        self.assertAlmostEqual(sensor.value, 0.25, delta=0.02)

    def test_a_disabled_camera_has_no_image_and_one_without_pictures_a_black_one(self):
        camera = robot.getDevice("Camera")
        self.assertIsNone(camera.getImage())
        camera.enable(16)
        robot.step(16)
        self.assertEqual(len(camera.image), 4 * camera.width * camera.height)
        array = camera.getImageArray()
        self.assertEqual((len(array), len(array[0]), array[-1][-1]), (camera.width, camera.height, [0, 0, 0]))
        camera.disable()
        self.assertIsNone(camera.getImageArray())

    def test_colours_are_read_from_bgra_and_not_beyond_the_image(self):
        image = bytes([1, 2, 3, 255] * 3 + [10, 20, 30, 255])
        self.assertEqual([get(image, 2, 1, 1) for get in (controller.Camera.imageGetRed, controller.Camera.imageGetGreen,
                                                          controller.Camera.imageGetBlue)], [30, 20, 10])
        self.assertEqual(controller.Camera.imageGetGray(image, 2, 1, 1), 19)
        for x, y in ((2, 0), (0, 2), (-1, 0), (0, -1)):
            with self.assertRaises(IndexError):
                controller.Camera.imageGetRed(image, 2, x, y)

    def test_the_keyboard_is_one_whichever_way_it_is_got(self):
        Keyboard().enable(16)
        self.assertEqual(robot.getKeyboard().sampling_period, 16)
        self.assertEqual(robot.keyboard.getKey(), -1)
        self.assertEqual((Keyboard.LEFT, Keyboard.SHIFT), (314, 0x10000))

    def test_a_light_shows_what_was_set(self):
        robot.getLED("EyeLed").value = 0xFF00
        self.assertEqual(robot.getLED("EyeLed").get(), 0xFF00)

    def test_a_missing_motion_file_is_not_valid(self):
        self.assertFalse(Motion("missing.motion").valid)

    def test_a_motion_file_is_played_by_the_steps(self):
        with tempfile.NamedTemporaryFile("w", suffix=".motion") as file:
            file.write("#WEBOTS_MOTION,V1.0,Neck\n00:00:000,A,0\n00:00:160,B,0.2\n")
            file.flush()
            motion = Motion(file.name)
        self.assertTrue(motion.isValid())
        self.assertEqual((motion.duration, motion.over), (160, False))
        motion.play()
        steps = 0
        while not motion.isOver():
            self.assertEqual(robot.step(16), 0)
            steps += 1
            self.assertLess(steps, 200)
        self.assertAlmostEqual(robot.getDevice("Neck").target_position, 0.2)
        motion.time = 32
        self.assertEqual(motion.getTime(), 32)

    def test_the_ball_is_where_the_orange_pixels_are(self):
        width, height = 32, 24
        image = bytearray(4 * width * height)
        for y in range(10, 15):
            for x in range(20, 25):
                image[4 * (y * width + x):4 * (y * width + x) + 4] = bytes([0, 128, 255, 255])
        finder = managers.RobotisOp2VisionManager(width, height, 28, 20, 50, 45, 0, 30)
        self.assertEqual(finder.getBallCenter(image), (True, 22, 12))
        self.assertEqual(finder.getBallCenter(bytes(image)), (True, 22, 12))
        self.assertTrue(finder.isDetected(22, 12))
        self.assertEqual(finder.getBallCenter(None), (False, 0, 0))
        with self.assertRaises(ValueError):
            finder.getBallCenter(bytes(image[:-1]))

    def test_managers_have_the_names_of_both_robots(self):
        for kind in ("Gait", "Motion", "Vision", "Directory", "MotionTimer"):
            for maker in ("RobotisOp2", "DARwInOP"):
                self.assertTrue(hasattr(managers, f"{maker}{kind}Manager"))
        self.assertFalse(managers.RobotisOp2GaitManager(None, "config.ini").isCorrectlyInitialized())

    def test_a_supervisor_is_a_robot_whose_calls_warn_once(self):
        script = """
from controller import Robot, Supervisor
supervisor = Supervisor()
assert isinstance(supervisor, Robot) and Supervisor.getSupervisorInstance() is supervisor
assert not supervisor.getSupervisor() and supervisor.step(16) == 0
for _ in range(2):
    assert supervisor.getFromDef("BALL") is None and supervisor.root is None
    assert supervisor.worldSave() is False and supervisor.movieIsReady() is True
    assert supervisor.simulationGetMode() == Supervisor.SIMULATION_MODE_REAL_TIME
"""
        process = subprocess.run([sys.executable, "-c", script], stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(process.returncode, 0, process.stderr)
        for call in ("getFromDef", "getRoot", "worldSave", "movieIsReady", "simulationGetMode"):
            self.assertEqual(process.stderr.count(f"Supervisor::{call}()"), 1, process.stderr)

    def test_the_walk_has_parameters_that_are_checked(self):
        gait = managers.RobotisOp2GaitManager(robot, "missing.ini")
        parameters = gait.getParameters()
        x_offset = parameters.x_offset
        parameters.foot_height = 30
        self.assertEqual(parameters.x_offset, x_offset)
        self.assertTrue(gait.setParameters(parameters))
        parameters.foot_height = 1000
        self.assertFalse(gait.setParameters(parameters))
        self.assertEqual(gait.getParameters().foot_height, 30)

    def test_a_second_robot_is_refused(self):
        self.assertIs(Robot.created, robot)
        with self.assertRaises(RuntimeError):
            Robot()

    def test_threads_take_turns(self):
        head = robot.getDevice("Head")
        end = threading.Event()

        def move():
            while not end.is_set():
                head.setPosition(head.getTargetPosition())

        mover = threading.Thread(target=move)
        mover.start()
        for _ in range(200):
            self.assertEqual(robot.step(16), 0)
        end.set()
        mover.join()

    def test_each_getter_without_arguments_is_a_property(self):
        for name, kind in vars(_darwinop).items():
            for getter in [method for method in vars(kind) if method.startswith("get")] if isinstance(kind, type) else []:
                takes_more = ", " in (getattr(kind, getter).__doc__ or "").partition("\n")[0]
                if not takes_more and getter not in ("get", "getData", "getDataDirectory"):
                    self.assertTrue(hasattr(kind, getter[3].lower() + getter[4:]), f"{name}.{getter}")


class ZEnd(unittest.TestCase):
    """Last: there is no robot afterwards."""

    def test_after_the_end_of_the_session_a_device_raises(self):
        head = robot.getDevice("Head")
        with robot:
            head.setPosition(0)
        for call in (head.getTargetPosition, robot.getTime, lambda: robot.step(16), lambda: robot.getDevice("Head"),
                     Keyboard):
            with self.assertRaises(RuntimeError):
                call()


if __name__ == "__main__":
    unittest.main()
