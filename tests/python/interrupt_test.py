"""Ctrl-C, and other ends of a Python controller: the robot is brought to rest by the same steps as after one in C++.
Signals have the effect of the table in docs/threads.md."""

import itertools
import os
import pathlib
import re
import select
import signal
import subprocess
import sys
import time
import unittest

from programs import BIN, Programs, rows_of

HEAD = "import sys, time\nfrom controller import Robot\nrobot = Robot()\nhead = robot.getDevice('Head')\n"


class Ends(Programs):
    def start(self, program, robot="virtual", by=(sys.executable,)):
        """A controller that has printed one line."""
        (self.folder / "c.py").write_text(HEAD + program)
        running = subprocess.Popen([*by, self.folder / "c.py"], text=True, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE,
                                   env=dict(self.environment, DARWINOP_ROBOT=robot,
                                            DARWINOP_RECORD=str(self.folder / "r.csv")))
        for clean in (running.stderr.close, running.stdout.close, running.wait, running.kill):  # the last one first
            self.addCleanup(clean)
        self.assertEqual(running.stdout.readline(), "ready\n")  # through a pipe: each line at once
        return running

    def check_rest(self):
        """The recording: goals were sent to every joint, and to none in the last cycle. Returns them by cycle."""
        names, rows = rows_of(self.folder / "r.csv")
        columns = [i for i, name in enumerate(names) if ".commanded" in name]
        self.assertEqual(len(columns), 20)
        goals = [[row[i] for i in columns] for row in rows]
        self.assertTrue(all(goals[len(goals) // 2]))
        self.assertFalse(any(goals[-1]))
        return goals

    def test_ctrl_c_ends_a_loop_that_looks_at_step_without_an_exception(self):
        running = self.start("print('ready')\nwhile robot.step(16) != -1:\n    pass\nprint('after the loop')\n")
        running.send_signal(signal.SIGINT)
        output, errors = running.communicate(timeout=30)
        self.assertEqual((running.returncode, output), (0, "after the loop\n"), errors)
        self.check_rest()

    def test_ctrl_c_ends_a_loop_that_does_not_look_at_step(self):
        # One reference too many, as of a library: the robot outlives the interpreter.
        running = self.start("import ctypes\nctypes.pythonapi.Py_IncRef(ctypes.py_object(robot))\n"
                             "print('ready')\nwhile True:\n    robot.step(16)\n")
        running.send_signal(signal.SIGINT)
        output, errors = running.communicate(timeout=30)
        self.assertEqual(running.returncode, -signal.SIGINT)
        self.assertIn("KeyboardInterrupt", errors)
        self.check_rest()

    def test_a_second_ctrl_c_interrupts_what_does_not_step(self):
        running = self.start("print('ready')\nwhile robot.step(16) != -1:\n    pass\nprint('sleeps')\n"
                             "try:\n    time.sleep(100)\nexcept KeyboardInterrupt:\n    print('woken')\n")
        running.send_signal(signal.SIGINT)
        self.assertEqual(running.stdout.readline(), "sleeps\n")
        while running.poll() is None:  # the first 0.3 s count as the same request
            running.send_signal(signal.SIGINT)
            try:
                running.wait(0.35)
            except subprocess.TimeoutExpired:
                continue
        self.assertEqual(running.stdout.read(), "woken\n")

    def test_a_second_request_that_arrives_twice_brings_the_robot_to_rest(self):
        running = self.start("print('ready')\nfor _ in range(60):\n    robot.step(16)\nprint('sleeps')\n"
                             "try:\n    while True:\n        time.sleep(0.1)\n"
                             "finally:\n    time.sleep(0.2)\n")  # still there when the signal arrives again
        self.assertEqual(running.stdout.readline(), "sleeps\n")
        for _ in range(2):
            for _ in range(2):  # to the group, and handed on by `darwinop run`
                running.send_signal(signal.SIGINT)
                time.sleep(0.02)
            time.sleep(0.5)
        _, errors = running.communicate(timeout=30)
        self.assertIn("KeyboardInterrupt", errors)
        self.check_rest()

    def test_an_exception_and_exit_bring_the_robot_to_rest(self):
        for program, status in (("raise ValueError", 1), ("sys.exit(3)", 3)):
            running = self.start(f"print('ready')\nhead.setPosition(0.1)\nrobot.step(160)\n{program}\n")
            running.communicate(timeout=30)
            self.assertEqual(running.returncode, status)
            self.check_rest()

    def test_a_walk_is_finished_before_the_robot_comes_to_rest(self):
        running = self.start(
            "from managers import RobotisOp2GaitManager\ngait = RobotisOp2GaitManager(robot, 'config.ini')\n"
            "gait.setXAmplitude(1)\ngait.start()\nwalked = 0\n"
            "while robot.step(16) != -1:\n    gait.step(16)\n    walked += 1\n    if walked == 400:\n        print('ready')\n")
        running.send_signal(signal.SIGINT)
        _, errors = running.communicate(timeout=30)
        self.assertEqual(running.returncode, 0, errors)
        held = [len(list(run)) for goals, run in itertools.groupby(self.check_rest()[400:]) if all(goals)]
        self.assertGreaterEqual(sum(cycles >= 20 for cycles in held), 2, f"stands, then rests: {held}")

    def signals(self, pattern):
        """From docs/threads.md, which another test compares with hal/signals.hpp."""
        page = (pathlib.Path(__file__).parents[2] / "docs/threads.md").read_text(encoding="utf-8")
        return [getattr(signal, name) for text in re.findall(pattern, page) for name in re.findall(r"SIG\w+", text)]

    def test_each_ending_signal_ends_it_as_in_cpp(self):
        ending = self.signals(r"\n\| SIG\w+ \| ends normally \|")
        self.assertIn(signal.SIGPWR, ending)
        for number in ending:
            with self.subTest(number.name):
                running = self.start("print('ready')\nwhile robot.step(16) != -1:\n    pass\n")
                running.send_signal(number)
                _, errors = running.communicate(timeout=30)
                self.assertEqual(running.returncode, 0, errors)
                self.check_rest()

    def test_signals_without_effect_leave_it_driving_by_itself_and_under_run(self):
        harmless = self.signals(r"\nNo effect:[^.]*") + [signal.SIGRTMIN, signal.SIGRTMAX]
        self.assertIn(signal.SIGTSTP, harmless)
        program = (f"import os\nos.chdir({str(self.folder)!r})\nprint('ready')\nprint(os.getpid())\nwhile robot.step(16) != -1:\n"
                   "    if os.path.exists('asked'):\n        os.rename('asked', 'answered')\n        print('drives')\n")
        for by in ((sys.executable,), (BIN / "darwinop", "run", "--robot", "virtual")):
            with self.subTest(by[0].name if by[1:] else "python"):
                running = self.start(program, by=by)
                for process in {running.pid, int(running.stdout.readline())}:
                    for number in harmless:
                        os.kill(process, number)
                (self.folder / "asked").touch()
                self.assertTrue(select.select([running.stdout], [], [], 30)[0], "it is stopped")
                self.assertEqual(running.stdout.readline(), "drives\n")
                running.terminate()
                _, errors = running.communicate(timeout=30)
                self.assertEqual(running.returncode, 0, errors)
                self.check_rest()

    def test_a_robot_that_is_not_there_ends_the_program_with_its_open_files_written(self):
        (self.folder / "c.py").write_text("f = open('log', 'w')\nf.write('kept')\n" + HEAD)
        ended = subprocess.run([sys.executable, "c.py"], cwd=self.folder, text=True, capture_output=True,
                               env=dict(self.environment, DARWINOP_ROBOT="/dev/does-not-exist"))
        self.assertEqual(ended.returncode, 1)
        self.assertIn("/dev/does-not-exist", ended.stderr)
        self.assertNotIn("Traceback", ended.stderr)
        self.assertEqual((self.folder / "log").read_text(), "kept")


if __name__ == "__main__":
    unittest.main()
