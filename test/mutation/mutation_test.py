#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plants small faults one at a time and tells which of them the fast tests do not notice.

    python3 -B test/mutation/mutation_test.py [--scale 1] [--seed 1] [--jobs 2] [--only REGEX] [--list] [--work DIR]

Works on copies of the tracked files, each with a build of its own: the source tree is not touched. Files take turns, so
that whatever part of a run there was has looked everywhere; Ctrl-C ends it with the summary. A fault counts as noticed
if a test fails, crashes, or takes far more processor time than without it. A fault that does not compile, or compiles
to the same code, is not counted. What nothing notices must stand in equivalent.py, with the argument why it changes no
result. Exit status 1 if something else survives, or if less than 95 % of all are noticed.
"""
import argparse
import collections
import json
import os
import pathlib
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import threading
import time

import equivalent
import faults

ROOT = pathlib.Path(__file__).resolve().parents[2]
REQUIRED = 0.95
LAYERS = ["predicates", "core", "refine"]
FLAGS = ["-DCMAKE_BUILD_TYPE=None", "-DCMAKE_CXX_FLAGS=-O1", "-DSINKMESH_CHECKED=ON",
         "-DCMAKE_GTEST_DISCOVER_TESTS_DISCOVERY_MODE=PRE_TEST"]
MEMORY = 6 << 30  # of one test, in bytes
WAITING = 20  # times the processor time that a command may take: a busy machine is no fault

# The files of tests that are for a source whose name theirs does not hold.
NEAR = {
    "staged": "oracle", "polynomials": "error_bounds|oracle", "predicates": "oracle", "cascade": "oracle",
    "symbolic": "oracle", "stages": "error_bounds|stages", "expansion": "arithmetic", "fixed_int": "arithmetic",
    "scaled_integers": "arithmetic", "grid": "arithmetic", "rounding": "circumcenter|constructions",
    "quotient": "circumcenter|constructions",
    "conflict": "insertion|location", "star_linker": "insertion", "first_simplex": "insertion", "star": "insertion",
    "flip_inserter": "flips", "vertex_remover": "removal",
    "sink_walk": "watershed|flow", "boundary_features": "boundary_features|boundary_refiner|conformer",
    "facet_index": "domain", "cells": "domain_regions", "point_guide": "steiner_inserter|separation",
}

# How many faults in which file. Left out: what decides nothing but speed (orders of points, pages, hashes), and what only
# describes (reports, options).
FILES = {
    "predicates/polynomials.h": 12, "predicates/staged.cpp": 4, "predicates/staged.h": 3,
    "predicates/predicates.cpp": 4, "predicates/circumcenter.cpp": 6, "predicates/constructions.cpp": 3,
    "predicates/input_gate.cpp": 5, "predicates/detail/symbolic.h": 8, "predicates/detail/stages.h": 8,
    "predicates/detail/cascade.cpp": 4, "predicates/detail/expansion.cpp": 5, "predicates/detail/fixed_int.h": 4,
    "predicates/detail/rounding.h": 3, "predicates/lanes.h": 3, "predicates/detail/scaled_integers.h": 4,
    "predicates/detail/grid.h": 2, "predicates/detail/quotient.h": 3, "core/conflict.h": 4, "core/cavity.h": 5,
    "core/complex.h": 4, "core/complex.cpp": 3, "core/star_linker.cpp": 6, "core/flip_inserter.cpp": 6,
    "core/location.h": 3, "core/triangulation.cpp": 6, "core/validation.cpp": 5, "core/star.cpp": 3,
    "core/star_walk.h": 2, "core/first_simplex.cpp": 3, "core/vertex_remover.cpp": 6, "refine/flow.cpp": 4,
    "refine/flow.h": 2, "refine/sink_walk.h": 3, "refine/domain.cpp": 7, "refine/boundary.cpp": 8,
    "refine/boundary_features.cpp": 5, "refine/steiner_inserter.cpp": 12, "refine/steiner_inserter.h": 4,
    "refine/off_sink.cpp": 4, "refine/sub_facets.cpp": 5, "refine/patch_triangulation.cpp": 6,
    "refine/patches.cpp": 4, "refine/independence.cpp": 2, "refine/sphere_set.cpp": 3, "refine/facet_index.h": 2,
    "refine/cells.cpp": 3, "refine/watershed.cpp": 3, "refine/conformer.cpp": 6, "refine/point_guide.h": 5,
    "refine/self_intersections.cpp": 5, "refine/quality.cpp": 4, "refine/angles.cpp": 3,
    "refine/interior_editor.cpp": 4,
}


def run(command, seconds, **options):
    """The exit status (None: it took too long) and the output. The seconds are those of the processor."""
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CPU, (int(seconds) + 1, int(seconds) + 2))
        os.setsid()

    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                          preexec_fn=limit, **options) as process:
        try:
            output, _ = process.communicate(timeout=WAITING * seconds)
            return (None if process.returncode == -signal.SIGXCPU else process.returncode), output
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
            return None, ""


class Slot:
    """A copy of the sources, its build, and a copy of the build from which to restore it."""

    def __init__(self, folder):
        self.folder = folder
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

    def make(self, *targets):
        return run(["ninja", "-j1", "-C", self.build, *targets], 1200, env=self.environment)[0] == 0

    def make_part(self, layer, wanted):
        """An executable of those files of the tests of a layer that match, and of no library of a later layer. None if
        something does not compile, or needs one of these."""
        target = f"{LAYERS[layer]}_test"
        commands = subprocess.run(["ninja", "-C", self.build, "-t", "commands", target], check=True, text=True,
                                  stdout=subprocess.PIPE).stdout.splitlines()
        link = next(shlex.split(part) for part in commands[-1].split(" && ") if f" -o test/{target} " in part)
        own = [word for word in link if word.endswith("_test.cpp.o")]
        chosen = [word for word in own if re.search(wanted, pathlib.Path(word).name)]
        libraries = [word for word in link if re.match(r"(?:predicates|core|refine|tools)/.*\.a$", word)]
        earlier = [word for word in libraries if word.split("/")[0] in LAYERS[:layer + 1]]
        part = self.build / f"part_of_{target}"
        words = [word for word in link if word not in own + libraries or word in chosen + earlier]
        words[words.index(f"test/{target}")] = str(part)
        return part if self.make(*chosen, *earlier) and run(words, 1200, cwd=self.build)[0] == 0 else None

    def gtest(self, executable, seconds, *options):
        return run([executable, *options], seconds, env=self.environment, cwd=self.build)


class Tests:
    """The tests of the three executables, with the time and the file of each, as measured without a fault."""

    def __init__(self, slot):
        self.cases = []
        for name, executable in zip(LAYERS, slot.executables):
            report = slot.folder / f"{name}.json"
            if not report.exists() or report.stat().st_mtime < executable.stat().st_mtime:
                status, output = slot.gtest(executable, 1800, f"--gtest_output=json:{report}", "--gtest_brief=1")
                if status != 0:
                    report.unlink(missing_ok=True)
                    sys.exit(f"the tests fail without any fault:\n{output[-3000:]}")
            suites = json.loads(report.read_text(encoding="utf-8"))["testsuites"]
            self.cases.append([(f"{suite['name']}.{case['name']}", float(case["time"].rstrip("s")),
                                pathlib.Path(case["file"]).stem) for suite in suites for case in suite["testsuite"]])

    def near(self, layer, wanted):
        return [case for case in self.cases[layer] if re.search(wanted, case[2])]

    def rounds(self, layer, near):
        """Those of `near` first, then quick ones, then slow ones."""
        rest = [case for case in self.cases[layer] if case not in near]
        return [chosen for chosen in (near, [case for case in rest if case[1] < 0.15],
                                      [case for case in rest if case[1] >= 0.15]) if chosen]


def noticed_by(slot, executable, cases):
    """The test that notices the planted fault, and how; "" if none does."""
    names = ":".join(case[0] for case in cases)
    status, output = slot.gtest(executable, 30 + 5 * sum(case[1] for case in cases), f"--gtest_filter={names}",
                                "--gtest_fail_fast")
    if status == 0:
        return ""
    # After a failure the rest is started, but skipped.
    named = (re.findall(r"^\[  FAILED  \] ([^\s,]+)", output, re.MULTILINE)[:1] or
             re.findall(r"^\[ RUN      \] (\S+)", output, re.MULTILINE)[-1:])
    how = {None: "too slow", 1: "failed"}.get(status, "crashed")
    return f"{named[0] if named else executable.name} {how}"


def noticed_by_program(slot):
    if not slot.make("sinkmesh"):
        return "the program, which does not compile"
    status, output = run(["ctest", "--test-dir", slot.build, "-R", "^program", "--stop-on-failure"], 100,
                         env=slot.environment)
    failed = re.search(r"(program\.\w+) \.*\**(\w+)", output.split("tests failed")[0]) if status else None
    return "" if status == 0 else f"{failed.group(1) if failed else 'program'} failed"


def verdict(slot, tests, fault):
    """What noticed the planted fault; "" if nothing did; None if it is no fault. What stands in equivalent.py is only
    shown to the tests that are for its file."""
    is_other = False
    layer_of_fault, name = fault.file.split("/", 1)
    stem = pathlib.Path(name).stem
    for layer in range(LAYERS.index(layer_of_fault), len(LAYERS)):
        near = tests.near(layer, NEAR.get(stem, stem))
        if name.endswith(".h") and near:
            # Before all tests that include it are compiled.
            part = slot.make_part(layer, NEAR.get(stem, stem))
            if part and slot.has_other_code():
                found = noticed_by(slot, part, near)
                if found or equivalent.argument(fault):
                    return found
        if not slot.make(f"{LAYERS[layer]}_test"):
            return None
        if not slot.has_other_code():
            continue
        is_other = True
        for cases in tests.rounds(layer, near):
            found = noticed_by(slot, slot.executables[layer], cases)
            if found:
                return found
            if equivalent.argument(fault):
                return ""
    return noticed_by_program(slot) if is_other else None


class Turns:
    """The faults to be planted: files take turns, and each has its share."""

    def __init__(self, shares):
        self.lock = threading.Lock()
        self.waiting = collections.deque((iter(found), wanted) for found, wanted in shares if wanted > 0)

    def next(self):
        """A file's faults, and how many of them are wanted; None if there are no more."""
        with self.lock:
            return self.waiting.popleft() if self.waiting else None

    def again(self, candidates, wanted):
        with self.lock:
            if wanted > 0:
                self.waiting.append((candidates, wanted))


def examine_all(slot, tests, turns, tell, stop):
    while not stop.is_set():
        turn = turns.next()
        if turn is None:
            return
        candidates, wanted = turn
        for fault in candidates:
            started = time.monotonic()
            slot.plant(fault)
            try:
                found = verdict(slot, tests, fault)
            finally:
                slot.restore()
            if stop.is_set():
                return  # what was asked to stop may have failed for it
            if found is not None:
                tell(fault, found, time.monotonic() - started)
                turns.again(candidates, wanted - 1)
                break


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scale", type=float, help="times the usual number of faults, which is about 240; with --only all")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--only", default="", help="faults whose description (see --list) matches")
    parser.add_argument("--list", action="store_true", help="list the faults, and plant none")
    parser.add_argument("--work", type=pathlib.Path, default=pathlib.Path("/tmp/sinkmesh-mutation"))
    options = parser.parse_args()

    shares = []
    # Sources first: after a fault in a header much is compiled again.
    for name, count in sorted(FILES.items(), key=lambda item: item[0].endswith(".h")):
        found = faults.in_random_order(faults.all_faults(name, (ROOT / name).read_text(encoding="utf-8")), options.seed)
        found = [fault for fault in found if re.search(options.only, str(fault))]
        is_all = options.only and options.scale is None
        shares.append((found, len(found) if is_all else round(count * (options.scale or 1))))
    if options.list:
        print("\n".join(str(fault) for found, _ in shares for fault in found))
        return 0

    slots = [Slot(options.work / str(i)) for i in range(options.jobs)]
    results = []

    def tell(fault, noticed_by, seconds):
        why = equivalent.argument(fault) if noticed_by == "" else None
        results.append((fault, noticed_by, why))
        said = f"noticed by {noticed_by}" if noticed_by else f"equivalent: {why}" if why else "SURVIVED"
        print(f"{len(results):4} {seconds:4.0f} s  {fault}\n             {said}", flush=True)

    for slot in slots:
        slot.prepare()
    tests = Tests(slots[0])
    turns = Turns(shares)
    stop = threading.Event()
    workers = [threading.Thread(target=examine_all, args=(slot, tests, turns, tell, stop)) for slot in slots]
    for worker in workers:
        worker.start()
    try:
        for worker in workers:
            worker.join()
    except KeyboardInterrupt:
        stop.set()
        for worker in workers:
            worker.join()

    noticed = sum(1 for result in results if result[1])
    survivors = [fault for fault, noticed_by, why in results if not noticed_by and not why]
    same = len(results) - noticed - len(survivors)
    print(f"{len(results)} faults planted, {noticed} noticed, {same} change no result, {len(survivors)} survived:")
    print("\n".join(f"  {fault}" for fault in survivors))
    return 0 if not survivors and noticed >= REQUIRED * (len(results) - same) and results else 1


if __name__ == "__main__":
    sys.exit(main())
