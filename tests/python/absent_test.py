"""Objects that controllers make of classes that this robot has no device of: the same values as in C++."""

import math
import os
import re
import subprocess
import sys
import unittest

import controller
from complete_test import HEADERS, SOURCE
from controller import Robot

os.environ["DARWINOP_ROBOT"] = "virtual"
os.environ["DARWINOP_KEYS"] = "none"
robot = Robot()

TABLE = (SOURCE / "webots/include/webots/absent_devices.hpp").read_text(encoding="utf-8")
CLASSES = re.findall(r"  ROW\((\w+)\)", TABLE)


def header(name):
    file, = (file for file in HEADERS if file.stem == name)
    return file.read_text(encoding="utf-8")


def values_in_cpp(name):
    """(method, number of arguments, what its comment says) of the header's methods that are absent here."""
    for value, declared in re.findall(r"/// Absent here: ([^.;]+)[.;].*?\n  (\w[^{]*)\{", header(name), re.DOTALL):
        method, arguments = re.search(r"(\w+)\(([^)]*)\)", declared).groups()
        yield method, arguments.count(",") + 1 if arguments else 0, value


class Absent(unittest.TestCase):
    def check(self, kind, method, value, result):
        numbers = result if isinstance(result, list) and result else [result]
        if value == "NaN":
            self.assertTrue(all(math.isnan(number) for number in numbers), f"{kind}.{method}() is {result}")
            self.assertEqual(isinstance(result, list), method in (
                "getValues", "getSpeedVector", "getRollPitchYaw", "getQuaternion", "getEmitterDirection",
                "getBoneOrientation", "getBonePosition"), method)
        elif value == "NULL":
            self.assertIn(result, (None, []), f"{kind}.{method}()")
        else:
            expected = {"no effect": None, "false": False, "empty": "", "0": 0, "-1": -1, "LOCAL": 0, "GENERIC": 0,
                        "ROTATIONAL": 0, "writes no file and returns -1": -1}
            if not value.startswith(("stores", "sets")):
                self.assertEqual((result, type(result)), (expected[value], type(expected[value])), f"{kind}.{method}()")

    def test_each_call_returns_what_it_returns_in_cpp(self):
        checked = 0
        for name in CLASSES:
            device = getattr(controller, name)("own")
            for method, arguments, value in values_in_cpp(name):
                checked += 1
                self.check(name, method, value, getattr(device, method)(*[0] * arguments))
        self.assertGreater(checked, 100)

    def test_getters_are_properties(self):
        gps = controller.GPS("gps")
        self.assertEqual(str(gps.speed_vector), "[nan, nan, nan]")
        self.assertTrue(math.isnan(gps.speed))
        self.assertIs(controller.Lidar("lidar").pointCloudEnabled, False)
        self.assertFalse(hasattr(controller.Skin("skin"), "bone_name"), "getBoneName() has an argument")

    def test_sampling_periods_are_those_that_were_set(self):
        sampled = [(name, "") for name in CLASSES if " : public AbsentSensor {" in header(name)]
        self.assertIn(("GPS", ""), sampled)
        for kind, what in [*sampled, ("Connector", "Presence"), ("VacuumGripper", "Presence")]:
            device, other = getattr(controller, kind)("one"), getattr(controller, kind)("other")
            getattr(device, "enable" + what)(32)
            periods = [getattr(each, f"get{what}SamplingPeriod")() for each in (device, other)]
            self.assertEqual(periods, [32, 0])
            getattr(device, "disable" + what)()
            self.assertEqual(getattr(device, f"get{what}SamplingPeriod")(), 0)

    def test_a_class_of_ones_own_is_derived(self):
        class OwnGps(controller.GPS):
            def __init__(self, name):
                super().__init__(name)
                self.enable(16)
                self.steps = 0

            def isKnown(self):
                self.steps += 1
                return not math.isnan(self.getValues()[0])

        gps = OwnGps("gps")
        self.assertFalse(gps.isKnown())
        self.assertEqual((gps.name, gps.tag, gps.steps, gps.sampling_period), ("gps", 0, 1, 16))
        self.assertIsInstance(gps, controller.Device)

    def test_depths_are_those_of_an_image(self):
        self.assertEqual(controller.RangeFinder.rangeImageGetDepth([1, 2, 3, 4], 2, 1, 1), 4)
        finder = controller.RangeFinder("finder")
        self.assertTrue(math.isnan(finder.rangeImageGetDepth(finder.getRangeImage(), finder.width, 0, 0)))

    def test_each_name_is_reported_once(self):
        script = """
import controller
robot = controller.Robot()
for kind, name in (("GPS", "gps"), ("GPS", "gps"), ("GPS", "other"), ("Pen", "pen")):
    device = getattr(controller, kind)(name)
del device
assert robot.step(16) == 0
"""
        process = subprocess.run([sys.executable, "-c", script], stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(process.returncode, 0, process.stderr)
        for call in ('GPS("gps")', 'GPS("other")', 'Pen("pen")'):
            self.assertEqual(process.stderr.count(call), 1, process.stderr)

    def test_without_a_robot_there_is_an_error(self):
        script = "import controller; controller.GPS('gps')"
        process = subprocess.run([sys.executable, "-c", script], stderr=subprocess.PIPE, text=True, check=False)
        self.assertIn("RuntimeError", process.stderr)


if __name__ == "__main__":
    unittest.main()
