"""Every class of the C++ headers is one in Python, with its public methods and constants."""

import pathlib
import re
import unittest

import controller
import managers

SOURCE = pathlib.Path(__file__).parents[2]
HEADERS = sorted((SOURCE / "webots/include/webots").rglob("*.hpp"))

# Pointers to bytes: texts have wwiSendText().
NOT_IN_PYTHON = re.compile(r"Robot\.(wwiSend|wwiReceive)")


def classes(headers):
    """(name, body without comments) of each class that controllers use."""
    for header in headers:
        text = re.sub(r"//.*", "", header.read_text(encoding="utf-8"))
        for name, body in re.findall(r"^class (\w+)[^;{]*\{\n(.*?)^\};", text, re.MULTILINE | re.DOTALL):
            if name != "AbsentSensor":
                yield name, re.split(r"^ (?:protected|private):", body, flags=re.MULTILINE)[0]


def has_objects(body):
    """No object of an abstract class exists: neither language can call its methods."""
    return " = 0;" not in body


def methods(name, body):
    """Names before a parenthesis, outside of bodies; a macro in capitals is none."""
    for line in body.splitlines():
        method = re.match(r"  (?! )[\w:<>&* ]*?\b(\w+)\(", line)
        if method and "~" not in line and not re.fullmatch(rf"{name}|operator|[A-Z_]+", method[1]):
            yield method[1]


def constants(body):
    for values in re.findall(r"enum \w* ?\{(.*?)\}", body, re.DOTALL):
        yield from re.findall(r"([A-Z]\w+)(?: = -?\w+)?(?:,|\s*$)", values)


class Complete(unittest.TestCase):
    def check(self, headers, package):
        checked = 0
        for name, body in classes(headers):
            self.assertTrue(hasattr(package, name), f"apps/python has no class {name}")
            for member in methods(name, body) if has_objects(body) else ():
                if not NOT_IN_PYTHON.fullmatch(f"{name}.{member}"):
                    checked += 1
                    self.assertTrue(hasattr(getattr(package, name), member), f"apps/python lacks {name}::{member}()")
        return checked

    def test_api(self):
        self.assertGreater(self.check(HEADERS, controller), 340)

    def test_managers(self):
        self.assertGreater(self.check((SOURCE / "managers/include").glob("DARwInOP*.hpp"), managers), 20)

    def test_constants(self):
        names = [f"{name}.{value}" for name, body in classes(HEADERS) for value in constants(body)]
        self.assertTrue({"Node.WORLD_INFO", "Field.MF_NODE", "Supervisor.SIMULATION_MODE_PAUSE"} <= set(names))
        for name in names:
            kind, value = name.split(".")
            if not NOT_IN_PYTHON.fullmatch(name):
                self.assertTrue(hasattr(getattr(controller, kind), value), f"apps/python lacks {name}")

    def test_getters_of_devices_that_the_robot_lacks(self):
        table = (SOURCE / "webots/include/webots/absent_devices.hpp").read_text(encoding="utf-8")
        names = re.findall(r"  ROW\((\w+)\)", table)
        self.assertIn("GPS", names)
        for name in names:
            self.assertTrue(issubclass(getattr(controller, name), controller.Device), name)
            self.assertTrue(hasattr(controller.Robot, "get" + name), name)


if __name__ == "__main__":
    unittest.main()
