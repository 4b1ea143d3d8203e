# SPDX-License-Identifier: MIT
"""The library as others use it: installed and found by CMake or pkg-config, or as a subfolder of their sources."""
import concurrent.futures
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
sys.path.insert(0, str(HERE.parent / "tools"))

from program import ellipsoid, off  # noqa: E402

CMAKE = os.environ["SINKMESH_CMAKE"]
BUILD = os.environ["SINKMESH_BUILD"]
COMPILER = os.environ["SINKMESH_COMPILER"]
FLAGS = shlex.split(os.environ.get("SINKMESH_CXX_FLAGS", ""))  # of the build: a sanitizer must be in both or none
PROGRAM = os.environ["SINKMESH_PROGRAM"]
WARNINGS = "-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror".split()


def run(*command, **options):
    return subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          check=False, **options)


class Consumer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.prefix = cls.folder / "prefix"
        result = run(CMAKE, "--install", BUILD, "--prefix", cls.prefix)
        assert result.returncode == 0, result.stdout
        cls.include = cls.prefix / "include" / "sinkmesh"
        cls.surface = cls.folder / "in.off"
        cls.surface.write_text(off(ellipsoid(2)))

    def succeed(self, *command, **options):
        result = run(*command, **options)
        self.assertEqual(result.returncode, 0, result.stdout)
        return result.stdout

    def configure(self, name, *options):
        build = self.folder / name
        return build, run(CMAKE, "-S", HERE, "-B", build, "-G", os.environ["SINKMESH_GENERATOR"],
                          f"-DCMAKE_CXX_COMPILER={COMPILER}", f"-DCMAKE_CXX_FLAGS={shlex.join(FLAGS)}",
                          "-DCMAKE_BUILD_TYPE=Debug", *options)

    def check_mesher(self, mesher):
        """It writes the mesh that the program writes."""
        ours, theirs = self.folder / "ours.mesh", self.folder / "theirs.mesh"
        self.succeed(mesher, self.surface, theirs)
        self.succeed(PROGRAM, "refine", self.surface, "-o", ours, "--quiet")
        self.assertEqual(ours.read_bytes(), theirs.read_bytes())

    def test_readme_has_the_three_lines(self):
        readme = (SOURCE / "README.md").read_text()
        block = re.search(r"```cpp\n(.*?)```", readme, re.DOTALL).group(1)
        ours = (HERE / "mesher.cpp").read_text()
        for line in filter(None, block.splitlines()):
            self.assertIn(re.sub(r'"[^"]*"', "FILE", line), re.sub(r"argv\[\d\]", "FILE", ours))

    def test_find_package(self):
        build, result = self.configure("found", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        self.assertEqual(result.returncode, 0, result.stdout)
        self.succeed(CMAKE, "--build", build)
        self.check_mesher(build / "mesher")

    @unittest.skipUnless(shutil.which("pkg-config"), "there is no pkg-config")
    def test_pkg_config(self):
        files = sorted(self.prefix.rglob("sinkmesh.pc"))
        self.assertEqual(len(files), 1)
        environment = {**os.environ, "PKG_CONFIG_PATH": str(files[0].parent)}
        flags = shlex.split(self.succeed("pkg-config", "--cflags", "--libs", "sinkmesh", env=environment))
        self.assertIn("-ffp-contract=off", flags)
        mesher = self.folder / "mesher"
        self.succeed(COMPILER, *FLAGS, *WARNINGS, HERE / "mesher.cpp", *flags, "-o", mesher)
        self.check_mesher(mesher)

    def test_add_subdirectory(self):
        build, result = self.configure("inside", f"-DSINKMESH_SOURCE={SOURCE}")
        self.assertEqual(result.returncode, 0, result.stdout)
        # One layer; the others would only take longer.
        self.succeed(CMAKE, "--build", build, "--target", "signs")
        self.succeed(build / "signs")

    def test_fast_math_is_refused_when_the_sources_are_configured(self):
        _, result = self.configure("fast", f"-DSINKMESH_SOURCE={SOURCE}", "-DCMAKE_CXX_FLAGS=-ffast-math")
        self.assertNotEqual(result.returncode, 0)
        self.assertRegex(result.stdout, r"remove\s+-ffast-math")

    def test_fast_math_is_refused_when_a_header_is_included(self):
        for flags in ("-ffast-math", "-Ofast", "-ffinite-math-only", "-funsafe-math-optimizations"):
            result = run(COMPILER, "-std=c++20", *flags.split(), "-fsyntax-only", f"-I{self.include}",
                         f"-I{self.include.parent}", HERE / "mesher.cpp")
            self.assertNotEqual(result.returncode, 0, flags)
            self.assertRegex(result.stdout, rf'#error "sinkmesh: .*remove .*{flags}', flags)

    def test_every_installed_header_compiles_on_its_own(self):
        headers = sorted(path.relative_to(self.include) for path in self.include.rglob("*.h"))
        self.assertGreater(len(headers), 30)
        self.assertEqual({path.parent.as_posix() for path in headers if "detail" in path.parts}, {"core/detail"})

        def compile_alone(header):
            return run(COMPILER, "-std=c++20", "-ffp-contract=off", *WARNINGS, "-fsyntax-only", "-x", "c++",
                       f"-I{self.include}", "-", input=f'#include "{header}"\n')

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for header, result in zip(headers, pool.map(compile_alone, headers)):
                self.assertEqual(result.returncode, 0, f"{header}\n{result.stdout}")


if __name__ == "__main__":
    unittest.main()
