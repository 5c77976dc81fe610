"""Every public method of the C++ headers is a method in Python."""

import pathlib
import re
import unittest

import controller
import managers

SOURCE = pathlib.Path(__file__).parents[2]

# Pointers to bytes; texts have wwiSendText().
NOT_IN_PYTHON = {"Robot.wwiSend", "Robot.wwiReceive"}


def public_methods(header):
    """(class, method) of a header: names before a parenthesis, outside of comments, bodies and private parts."""
    text = re.sub(r"//.*", "", header.read_text(encoding="utf-8"))
    for kind, body in re.findall(r"^class (\w+)[^;{]*\{\n(.*?)^\};", text, re.MULTILINE | re.DOTALL):
        is_public = False
        for line in body.splitlines():
            if access := re.match(r"\s*(public|protected|private):", line):
                is_public = access[1] == "public"
            method = re.match(r"  (?! )[\w:<>&* ]*?\b(\w+)\(", line)
            if is_public and method and method[1] not in (kind, "operator") and "~" not in line:
                yield kind, method[1]


class Complete(unittest.TestCase):
    def check(self, headers, package):
        checked = 0
        for header in headers:
            for kind, method in public_methods(header):
                if hasattr(package, kind) and f"{kind}.{method}" not in NOT_IN_PYTHON:
                    checked += 1
                    self.assertTrue(hasattr(getattr(package, kind), method), f"python/ does not bind {kind}::{method}()")
        return checked

    def test_api(self):
        headers = list((SOURCE / "webots/include/webots").rglob("*.hpp"))
        self.assertGreater(self.check(headers, controller), 150)

    def test_managers(self):
        self.assertGreater(self.check((SOURCE / "managers/include").glob("DARwInOP*.hpp"), managers), 20)


if __name__ == "__main__":
    unittest.main()
