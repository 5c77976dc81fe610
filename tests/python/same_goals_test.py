"""A controller in Python asks for the same goals as in C++, on every kind of robot."""

import math
import os
import unittest

from programs import CONTROLLERS, Programs, goals, movements

CPP_CONTROLLERS = os.environ["DARWINOP_CONTROLLERS"]
CPP_ALL_JOINTS = os.environ["DARWINOP_ALL_JOINTS"]
# Over TCP goals travel in whole servo ticks, and a page or a walk starts at such a goal. No other goal differs. rad
TCP_TOLERANCE = 2 * math.pi / 4096
# In real time the newest image wins: of two that a delayed controller offers within a cycle, the first is never sent,
# and where that makes a joint leap, safety limits its speed. That is allowed for one row in ten.
DELAYED = 0.1


def in_order(rows, reference, tolerance):
    """How many rows the reference does not have, or has earlier; and how many of its rows were found."""
    def is_near(index, row):
        return all(abs(a - b) <= tolerance for a, b in zip(reference[index], row))

    at = counted = unknown = sent = 0
    for row in rows:
        found = next((i for i in range(at, len(reference)) if is_near(i, row)), None)
        if found is None:
            unknown += 1
            continue
        at = found
        counted = max(counted, at)
        while counted < len(reference) and is_near(counted, row):
            counted += 1
            sent += 1
    return unknown, sent


class SameGoals(Programs):
    def recorded(self, controller, robot):
        """Goals of the only session; by column, then by cycle, rad."""
        recording = self.folder / "recording.csv"
        recording.unlink(missing_ok=True)  # --record replaces no file
        self.run_controller(controller, robot=robot, record=recording)
        session, = goals(recording)
        return session

    def through_a_daemon(self):
        """Goals of a session in the daemon, and of one over TCP."""
        port, recording = str(self.folder / "port"), self.folder / "daemon.csv"
        with self.started("darwinop-virtual-robot", "--link", port, ready="^link: "):
            # On a busy machine the first check may find a cycle too long.
            with self.started("darwinop-runtime", "--wait", "--robot", port, "--record", recording, ready="^ready: "):
                self.run_controller("all_joints", robot="runtime")
                with self.started("darwinop-remote", "--robot", "runtime", "--port", "0",
                                  ready=r"^ready: (\S+)") as ready:
                    self.run_controller("all_joints", robot="tcp://" + ready[1])
        return goals(recording)

    def check_equal(self, session, reference):
        for column, rows in reference.items():
            self.assertEqual(len(session[column]), len(rows), column)
            for row, expected in zip(session[column], rows):
                self.assertEqual(row, expected, column)

    def check_in_order(self, session, reference, tolerance):
        for column, most_unknown in (("asked", 0), ("commanded", DELAYED)):
            rows, expected = session[column], reference[column]
            unknown, sent = in_order(rows, expected, tolerance)
            self.assertLessEqual(unknown, most_unknown * len(rows), column)
            self.assertGreaterEqual(sent, (1 - DELAYED) * len(expected), column)

    def test_of_all_joints_on_virtual_twin_daemon_and_over_tcp(self):
        reference = self.recorded(CPP_ALL_JOINTS, "virtual")
        self.assertEqual({len(row) for rows in reference.values() for row in rows}, {20})
        self.assertGreater(min(map(len, reference.values())), 300)
        in_simulated_time = ["virtual"] + (["twin"] if "DARWINOP_WITH_TWIN" in os.environ else [])
        for robot in in_simulated_time:
            with self.subTest(robot=robot):
                self.check_equal(self.recorded("all_joints", robot), reference)
        local, remote = self.through_a_daemon()
        for robot, session, tolerance in (("runtime", local, 0), ("tcp", remote, TCP_TOLERANCE)):
            with self.subTest(robot=robot):
                self.check_in_order(session, reference, tolerance)


class AgainstCpp(Programs):
    """Controllers that follow their sensors, in simulated time: the same goals, and the robot moves alike."""

    def check_same(self, python, cpp, *arguments, robot="virtual"):
        recordings = [self.folder / "python.csv", self.folder / "cpp.csv"]
        for name, recording in zip((CONTROLLERS / python, f"{CPP_CONTROLLERS}/{cpp}"), recordings):
            recording.unlink(missing_ok=True)
            self.run_controller(str(name), *arguments, robot=robot, record=recording)
        python_rows, cpp_rows = map(movements, recordings)
        self.assertGreater(len(cpp_rows), 50)
        self.assertEqual(len(python_rows), len(cpp_rows))
        for python_row, cpp_row in zip(python_rows, cpp_rows):
            self.assertEqual(python_row, cpp_row)

    def test_symmetry(self):
        self.check_same("symmetry", "02_symmetry", "--seconds", "2")

    @unittest.skipUnless("DARWINOP_WITH_TWIN" in os.environ, "no twin in this build")
    def test_walk_on_the_twin(self):
        self.check_same("walk", "05_walk", "--seconds", "2", robot="twin")


if __name__ == "__main__":
    unittest.main()
