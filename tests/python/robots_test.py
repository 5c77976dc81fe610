"""Python controllers in the styles of public code, on each kind of robot."""

import os
import unittest

from programs import Programs


class OnEachRobot(Programs):
    def check_devices(self, robot):
        output, warnings = self.run_controller("devices", robot=robot)
        self.assertIn("gps: None\n", output)
        self.assertIn("far: []\n", output)
        self.assertEqual(warnings.count('getDevice("gps")'), 1)

    def check_all(self, robot, arm_answers=True):
        self.check_devices(robot)
        output, _ = self.run_controller("inherits", "1.5", robot=robot)
        self.assertIn("nodded by more than 0.2 rad: True\n", output)

        output, warnings = self.run_controller("getters_of_2013", robot=robot)
        for line in ("image: None", "head: True", "up: True", "led: True", "button: 0.0", "distance: None"):
            self.assertIn(line + "\n", output)
        self.assertEqual("arm: nan\n" in output, not arm_answers)
        self.assertEqual(warnings.count('getDevice("ds0")'), 1)

    def test_virtual(self):
        self.check_all("virtual")
        output, _ = self.run_controller("finds_managers", robot="virtual")
        self.assertIn("walks: True\n", output)

    @unittest.skipUnless("DARWINOP_WITH_TWIN" in os.environ, "no twin in this build")
    def test_twin(self):
        self.check_all("twin")
        output, _ = self.run_controller("vision", robot="twin")
        for line in ("found: True", "red: True", "bytes: True"):
            self.assertIn(line + "\n", output)

    def test_a_port_in_the_process_of_the_controller(self):
        port = str(self.folder / "port")
        with self.started("darwinop-virtual-robot", "--link", port, ready="^link: "):
            self.check_devices(port)

    def test_daemon_on_a_pty(self):
        port = str(self.folder / "port")
        with self.started("darwinop-virtual-robot", "--link", port, "--servo", "ArmUpperL=missing",
                          ready="^link: "):
            # On a busy machine the first check may find a cycle too long.
            with self.started("darwinop-runtime", "--wait", "--robot", port, ready="^ready: "):
                self.check_all("runtime", arm_answers=False)

    def test_tcp(self):
        with self.started("darwinop-remote", "--robot", "virtual", "--port", "0", ready=r"^ready: (\S+)") as ready:
            self.check_all("tcp://" + ready[1])


class Folder(Programs):
    def test_config_ini_and_relative_files_are_those_beside_the_script(self):
        (self.folder / "config.ini").write_text("[Robot Config]\ntime_step = 24\n")
        (self.folder / "here").mkdir()
        (self.folder / "c.py").write_text(
            "import os, sys\nfrom controller import Robot\nrobot = Robot()\n"
            "print(robot.basic_time_step, os.path.isdir('here'), robot.project_path, sys.argv[1:])\n")
        output, _ = self.run_controller(str(self.folder / "c.py"), "--", "--seconds", "2")
        self.assertIn(f"24.0 True {self.folder} ['--seconds', '2']\n", output)


if __name__ == "__main__":
    unittest.main()
