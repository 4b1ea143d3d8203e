# SPDX-License-Identifier: MIT
"""Ctrl-C, time limits, and progress on a terminal."""
import os
import pathlib
import pty
import signal
import subprocess
import time
import unittest

from program import PROGRAM, ProgramTest, ellipsoid, off

MODELS = pathlib.Path(__file__).parent.parent / "data" / "paper"


class Stop(ProgramTest):
    def setUp(self):
        super().setUp()
        self.input = self.write("in.off", off(ellipsoid(6, jitter=0)))
        # As fine as is allowed, in the slowest way: soon begun, and far longer than any of these tests waits.
        self.arguments = ["refine", self.input, "-o", self.path("out.vtu"), "--ratio", "1", "--boundary", "fixed",
                          "--insert", "circumcenter", "--schedule", "parallel", "--report", self.path("report.json"),
                          "--history", self.path("history.csv")]

    def check_result(self, stop):
        report = self.report()
        self.assertEqual(report["stop"], stop)
        self.assertGreater(report["remaining"]["untried"], 0)
        mesh = self.inspect(self.path("out.vtu"))
        self.assertTrue(mesh["delaunay"])
        self.assertEqual(mesh["hash"], report["hash"])
        self.assertEqual(self.files(), ["history.csv", "in.off", "inspect.json", "out.vtu", "report.json"])

    def run_on_terminal_until(self, word, number):
        """Sends the signal when the progress line says `word`; returns the status and what the terminal showed."""
        terminal, side = pty.openpty()
        process = subprocess.Popen([PROGRAM, *self.arguments], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=side)
        os.close(side)
        shown = b""
        sent = False
        try:
            while True:
                try:
                    some = os.read(terminal, 4096)
                except OSError:  # the other side is closed
                    break
                if not some:
                    break
                shown += some
                if not sent and word in shown:
                    process.send_signal(number)
                    sent = True
            return process.wait(timeout=60), shown
        finally:
            process.kill()
            process.wait()
            os.close(terminal)

    def test_interrupt_writes_the_mesh_so_far(self):
        status, shown = self.run_on_terminal_until(b"/s)", signal.SIGINT)
        self.assertEqual(status, 3, shown)
        self.assertIn(b"low quality", shown)
        self.assertTrue(shown.endswith(b"\r\x1b[K"), shown[-40:])
        self.check_result("cancelled")

    def test_terminate_does_the_same(self):
        status, shown = self.run_on_terminal_until(b"/s)", signal.SIGTERM)
        self.assertEqual(status, 3, shown)
        self.check_result("cancelled")

    def test_an_interrupt_before_there_is_a_mesh_leaves_nothing(self):
        self.arguments[1] = "-"
        self.arguments += ["--input-format", "off"]
        process = subprocess.Popen([PROGRAM, *self.arguments], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        process.stdin.write(b"OFF\n")
        process.stdin.flush()
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=60), -signal.SIGINT)
        process.stdin.close()
        self.assertEqual(self.files(), ["in.off"])

    def test_time_limit(self):
        start = time.monotonic()
        self.succeed(*self.arguments, "--time-limit", "1", status=3)
        self.assertLess(time.monotonic() - start, 30)
        self.check_result("budget")

    def test_no_progress_without_a_terminal(self):
        result = self.run_program(*self.arguments, "--time-limit", "1")
        self.assertEqual((result.returncode, result.stderr), (3, b""))

    def test_a_budget_that_was_not_needed_did_not_stop_anything(self):
        surface = str(MODELS / "cuboctahedron.off")  # at the end nothing of low quality is left
        for schedule in ("incremental", "block", "parallel"):
            arguments = ["refine", surface, "-o", self.path("a.vtu"), "--insert", "sink", "--schedule", schedule,
                         "--report", self.path("report.json"), "--max-vertices"]
            self.succeed(*arguments, 10**6)
            vertices = self.report()["final"]["vertices"]
            self.succeed(*arguments, vertices)
            self.succeed(*arguments, vertices - 1, status=3)


if __name__ == "__main__":
    unittest.main()
