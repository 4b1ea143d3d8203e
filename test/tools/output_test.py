# SPDX-License-Identifier: MIT
"""Output is complete or absent: a disk that fills up half-way, folders and files that must not be written."""
import os
import resource
import signal
import stat
import subprocess
import unittest

from program import PROGRAM, ProgramTest, ellipsoid, off

FORMATS = [("out.vtu", None), ("out.vtk", None), ("out.mesh", None), ("out.msh", None), ("out.msh", "msh2"),
           ("out.node", None)]
LIMIT = 2000  # bytes; less than any of the meshes


def limit_files():
    """Writes beyond the limit fail, as on a full disk."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (LIMIT, LIMIT))


def limit_files_and_signal():
    """The same where the signal is not ignored, which ends a program that does not expect it."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (LIMIT, LIMIT))


class Output(ProgramTest):
    def setUp(self):
        super().setUp()
        self.input = self.write("in.off", off(ellipsoid(2)))

    def commands(self):
        for command in ("refine", "delaunay"):
            for name, file_format in FORMATS:
                yield [command, self.input, "-o", self.path(name)] + (["--format", file_format] if file_format else [])

    def refuse(self, arguments, **options):
        """Runs the program, which must fail with status 1 and one line that names the output."""
        result = subprocess.run([PROGRAM, *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, timeout=300, check=False, **options)
        message = result.stderr.decode()
        self.assertEqual(result.returncode, 1, message)
        self.assertEqual(result.stdout, b"")
        self.assertRegex(message, r"\A[^\n]*/out\.[a-z]+: cannot [^\n]+\n\Z")
        return message

    def test_a_write_that_fails_half_way_leaves_nothing(self):
        for arguments in self.commands():
            with self.subTest(arguments=arguments):
                self.refuse(arguments, preexec_fn=limit_files)
                self.assertEqual(self.files(), ["in.off"])

    def test_the_signal_of_the_limit_ends_nothing(self):
        for arguments in self.commands():
            with self.subTest(arguments=arguments):
                self.refuse(arguments, preexec_fn=limit_files_and_signal)
                self.assertEqual(self.files(), ["in.off"])

    def test_a_write_that_fails_half_way_leaves_the_old_file(self):
        for arguments in self.commands():
            with self.subTest(arguments=arguments):
                old = self.folder / os.path.basename(arguments[3])
                old.write_text("before")
                self.refuse(arguments, preexec_fn=limit_files)
                self.assertEqual(self.files(), ["in.off", old.name])
                self.assertEqual(old.read_text(), "before")
                old.unlink()

    def test_a_report_that_cannot_be_written_leaves_no_half(self):
        for option in ("--report", "--history"):
            message = self.fail_with_one_line(1, "refine", self.input, "-o", self.path("a.vtu"), option, "/dev/full")
            self.assertTrue(message.startswith("/dev/full: "), message)
            # The mesh itself may be there, but whole.
            self.assertIn(self.files(), (["in.off"], ["a.vtu", "in.off"]))
            if "a.vtu" in self.files():
                self.inspect(self.path("a.vtu"))
                os.remove(self.path("a.vtu"))
                os.remove(self.path("inspect.json"))

    def test_folders_without_permission(self):
        # The superuser may write everywhere: then as somebody else, if that one can run the program at all.
        options = {}
        if os.geteuid() == 0:
            options = {"user": 65534, "group": 65534, "extra_groups": []}
            os.chmod(self.folder, 0o755)
            try:
                subprocess.run([PROGRAM, "--version"], stdout=subprocess.DEVNULL, check=True, **options)
            except (OSError, subprocess.CalledProcessError) as error:
                self.skipTest(f"another user cannot run the program: {error}")
        locked = self.folder / "locked"
        locked.mkdir()
        locked.chmod(stat.S_IRUSR | stat.S_IXUSR | stat.S_IROTH | stat.S_IXOTH)
        try:
            for command in ("refine", "delaunay"):
                message = self.refuse([command, self.input, "-o", str(locked / "out.vtu")], **options)
                self.assertIn("check the permissions", message)
            self.assertEqual(os.listdir(locked), [])
        finally:
            locked.chmod(stat.S_IRWXU)

    def test_nothing_is_computed_for_an_output_that_cannot_be_written(self):
        # The input is no surface; but that the folder does not exist is told first.
        broken = self.write("broken.off", "OFF\n")
        self.assertIn("out.vtu", self.refuse(["refine", broken, "-o", self.path("no/out.vtu")]))


if __name__ == "__main__":
    unittest.main()
