#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plants small faults one at a time and tells which of them the fast tests do not notice.

    python3 -B test/mutation/mutation_test.py [--scale 1] [--seed 1] [--jobs 2] [--only REGEX] [--list] [--work DIR]

Works on copies of the tracked files, each with a build of its own: the source tree is not touched. A fault counts as
noticed if a test fails, crashes, or takes far longer than without it. A fault that does not compile, or compiles to
the same code, is not counted. What nothing notices must stand in equivalent.py, with the argument why it changes no
result. Exit status 1 if something else survives, or if less than 95 % of all are noticed.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import time

import equivalent
import faults

ROOT = pathlib.Path(__file__).resolve().parents[2]
REQUIRED = 0.95
LAYERS = ["predicates", "core", "refine"]
FLAGS = ["-DCMAKE_BUILD_TYPE=None", "-DCMAKE_CXX_FLAGS=-O1", "-DSINKMESH_CHECKED=ON",
         "-DCMAKE_GTEST_DISCOVER_TESTS_DISCOVERY_MODE=PRE_TEST"]
MEMORY = 6 << 30  # of one test, in bytes

# How many faults in which file. Left out: what decides nothing but speed (orders of points, pages, hashes), and what only
# describes (reports, options).
FILES = {
    "predicates/polynomials.h": 12, "predicates/staged.cpp": 4, "predicates/staged.h": 3, "predicates/predicates.cpp": 4,
    "predicates/circumcenter.cpp": 6, "predicates/constructions.cpp": 3, "predicates/input_gate.cpp": 5,
    "predicates/detail/symbolic.h": 8, "predicates/detail/stages.h": 8, "predicates/detail/cascade.cpp": 4,
    "predicates/detail/expansion.cpp": 5, "predicates/detail/fixed_int.h": 4, "predicates/detail/rounding.h": 3,
    "predicates/detail/scaled_integers.h": 4, "predicates/detail/grid.h": 2, "predicates/detail/quotient.h": 3,
    "core/conflict.h": 4, "core/cavity.h": 5, "core/complex.h": 4, "core/complex.cpp": 3, "core/star_linker.cpp": 6,
    "core/flip_inserter.cpp": 6, "core/location.h": 3, "core/triangulation.cpp": 6, "core/validation.cpp": 5,
    "core/star.cpp": 3, "core/star_walk.h": 2, "core/first_simplex.cpp": 3, "core/vertex_remover.cpp": 6,
    "refine/flow.cpp": 4, "refine/flow.h": 2, "refine/sink_walk.h": 3, "refine/domain.cpp": 7, "refine/boundary.cpp": 8,
    "refine/boundary_features.cpp": 5, "refine/steiner_inserter.cpp": 12, "refine/steiner_inserter.h": 4,
    "refine/off_sink.cpp": 4, "refine/sub_facets.cpp": 5, "refine/patch_triangulation.cpp": 6, "refine/patches.cpp": 4,
    "refine/independence.cpp": 2, "refine/sphere_set.cpp": 3, "refine/facet_index.h": 2, "refine/cells.cpp": 3,
    "refine/watershed.cpp": 3, "refine/conformer.cpp": 6,
}


def run(command, timeout, **options):
    """The exit status (None: it took too long) and the output."""
    def limit_memory():
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        os.setsid()

    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                          preexec_fn=limit_memory, **options) as process:
        try:
            output, _ = process.communicate(timeout=timeout)
            return process.returncode, output
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, 9)
            process.communicate()
            return None, ""


class Slot:
    """A copy of the sources, its build, and a copy of the build from which to restore it."""

    def __init__(self, folder):
        self.source, self.build, self.pristine = folder / "source", folder / "build", folder / "pristine"
        self.executables = [self.build / "test" / f"{layer}_test" for layer in LAYERS]
        self.environment = dict(os.environ, CCACHE_DISABLE="1",
                                SINKMESH_TEST_DATA=os.environ.get("SINKMESH_TEST_DATA", str(ROOT.parent / "shared/data")))

    def prepare(self):
        listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-co", "--exclude-standard"], check=True,
                                stdout=subprocess.PIPE, text=True).stdout.split("\n")
        for name in filter(None, listed):
            to = self.source / name
            to.parent.mkdir(parents=True, exist_ok=True)
            if not to.exists() or to.read_bytes() != (ROOT / name).read_bytes():
                shutil.copyfile(ROOT / name, to)
        for command in (["cmake", "-G", "Ninja", "-S", self.source, "-B", self.build, *FLAGS],
                        ["ninja", "-j1", "-C", self.build, *[f"{layer}_test" for layer in LAYERS], "sinkmesh"]):
            done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
            if done.returncode != 0:
                sys.exit(done.stdout[-4000:])
        shutil.rmtree(self.pristine, ignore_errors=True)
        shutil.copytree(self.build, self.pristine)

    def changed(self):
        """What the build now has that differs from the pristine one, by time and size."""
        for path in self.build.rglob("*"):
            if path.is_file():
                now, then = path.stat(), self.pristine / path.relative_to(self.build)
                if not then.exists() or (then.stat().st_mtime_ns, then.stat().st_size) != (now.st_mtime_ns, now.st_size):
                    yield path, then

    def plant(self, fault):
        path = self.source / fault.file
        self.saved = path, path.read_bytes(), path.stat()
        path.write_text(fault.text, encoding="utf-8")

    def restore(self):
        path, text, stat = self.saved
        path.write_bytes(text)
        os.utime(path, ns=(stat.st_atime_ns, stat.st_mtime_ns))
        for now, then in list(self.changed()):
            now.unlink()
            if then.exists():
                shutil.copy2(then, now)

    def has_other_code(self):
        return any(path.suffix == ".o" and path.read_bytes() != then.read_bytes() for path, then in self.changed())

    def make(self, target):
        return run(["ninja", "-j1", "-C", self.build, target], 1200, env=self.environment)[0] == 0

    def gtest(self, layer, timeout, *options):
        return run([self.executables[layer], *options], timeout, env=self.environment, cwd=self.build)


class Tests:
    """The tests of the three executables, with the time and the file of each, as measured without a fault."""

    def __init__(self, slot):
        self.cases = []
        for layer, name in enumerate(LAYERS):
            report = slot.build / f"{name}.json"
            status, output = slot.gtest(layer, 1800, f"--gtest_output=json:{report}", "--gtest_brief=1")
            if status != 0:
                sys.exit(f"the tests fail without any fault:\n{output[-3000:]}")
            suites = json.loads(report.read_text(encoding="utf-8"))["testsuites"]
            self.cases.append([(f"{suite['name']}.{case['name']}", float(case["time"].rstrip("s")),
                                pathlib.Path(case["file"]).stem) for suite in suites for case in suite["testsuite"]])

    def rounds(self, layer, stem):
        """The tests that say in their name that they are for it; quick ones; slow ones. Each with its time."""
        stem = re.sub(r"^(?:staged|polynomials)$", "oracle", stem)
        near = [case for case in self.cases[layer] if stem in case[2]]
        rest = [case for case in self.cases[layer] if stem not in case[2]]
        for chosen in (near, [case for case in rest if case[1] < 0.15], [case for case in rest if case[1] >= 0.15]):
            if chosen:
                yield ":".join(case[0] for case in chosen), sum(case[1] for case in chosen)


def verdict(slot, tests, fault):
    """What noticed the planted fault; "" if nothing did; None if it is no fault."""
    is_other = False
    for layer in range(LAYERS.index(fault.file.split("/")[0]), len(LAYERS)):
        if not slot.make(f"{LAYERS[layer]}_test"):
            return None
        if not slot.has_other_code():
            continue
        is_other = True
        for names, seconds in tests.rounds(layer, pathlib.Path(fault.file).stem):
            status, output = slot.gtest(layer, 30 + 5 * seconds, f"--gtest_filter={names}", "--gtest_fail_fast")
            if status != 0:
                # After a failure the rest is started, but skipped.
                named = (re.findall(r"^\[  FAILED  \] ([^\s,]+)", output, re.MULTILINE)[:1] or
                         re.findall(r"^\[ RUN      \] (\S+)", output, re.MULTILINE)[-1:])
                how = {None: "too slow", 1: "failed"}.get(status, "crashed")
                return f"{named[0] if named else LAYERS[layer] + '_test'} {how}"
    if not is_other:
        return None
    if not slot.make("sinkmesh"):
        return None
    status, output = run(["ctest", "--test-dir", slot.build, "-R", "^program", "--stop-on-failure"], 300,
                         env=slot.environment)
    failed = re.search(r"(program\.\w+) \.*\**(\w+)", output.split("tests failed")[0]) if status else None
    return "" if status == 0 else f"{failed.group(1) if failed else 'program'} failed"


def examine(slot, tests, candidates, wanted, tell):
    """Plants candidates until `wanted` of them were faults, and tells about each."""
    for fault in candidates:
        if wanted == 0:
            return
        started = time.monotonic()
        slot.plant(fault)
        try:
            noticed_by = verdict(slot, tests, fault)
        finally:
            slot.restore()
        if noticed_by is not None:
            wanted -= 1
            tell(fault, noticed_by, time.monotonic() - started)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scale", type=float, default=1, help="times the usual number of faults, which is about 200")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--only", default="", help="faults whose description (see --list) matches")
    parser.add_argument("--list", action="store_true", help="list the faults, and plant none")
    parser.add_argument("--work", type=pathlib.Path, default=pathlib.Path("/tmp/sinkmesh-mutation"))
    options = parser.parse_args()

    jobs = []
    # Sources first: after a fault in a header most of the tests are compiled again.
    for name, count in sorted(FILES.items(), key=lambda item: item[0].endswith(".h")):
        found = faults.in_random_order(faults.all_faults(name, (ROOT / name).read_text(encoding="utf-8")), options.seed)
        found = [fault for fault in found if re.search(options.only, str(fault))]
        jobs.append((found, round(count * options.scale) if not options.only else len(found)))
    if options.list:
        print("\n".join(str(fault) for found, _ in jobs for fault in found))
        return 0

    slots = [Slot(options.work / str(i)) for i in range(options.jobs)]
    results = []

    def tell(fault, noticed_by, seconds):
        why = equivalent.argument(fault) if noticed_by == "" else None
        results.append((fault, noticed_by, why))
        said = f"noticed by {noticed_by}" if noticed_by else f"equivalent: {why}" if why else "SURVIVED"
        print(f"{len(results):4} {seconds:4.0f} s  {fault}\n             {said}", flush=True)

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        list(pool.map(Slot.prepare, slots))
        tests = Tests(slots[0])
        free = list(slots)

        def work(job):
            slot = free.pop()
            try:
                examine(slot, tests, *job, tell)
            finally:
                free.append(slot)

        list(pool.map(work, jobs))

    noticed = sum(1 for result in results if result[1])
    survivors = [fault for fault, noticed_by, why in results if not noticed_by and not why]
    same = len(results) - noticed - len(survivors)
    print(f"{len(results)} faults planted, {noticed} noticed, {same} change no result, {len(survivors)} survived:")
    print("\n".join(f"  {fault}" for fault in survivors))
    return 0 if not survivors and noticed >= REQUIRED * (len(results) - same) and results else 1


if __name__ == "__main__":
    sys.exit(main())
