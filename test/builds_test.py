# SPDX-License-Identifier: MIT
"""One result on every compiler and with every flag: builds the program in many ways and compares its meshes.

    python3 -B test/builds_test.py [--only REGEX] [--jobs N] [--work DIR]

Compares the hash in the report and every byte of the mesh, and disassembles those for this processor. Takes about a quarter of an hour on four cores.
"""
import argparse
import hashlib
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

import contraction_test

ROOT = pathlib.Path(__file__).resolve().parent.parent
MODELS = ROOT / "test" / "data" / "paper"
COMPILERS = {"gcc": "g++", "clang": "clang++"}  # or the newest of clang++-14 and the like
SANITIZERS = "-fsanitize=address,undefined -fno-sanitize-recover=all"
FLAGS = {
    "O0": "-O0", "O2": "-O2", "O3": "-O3", "native": "-O3 -march=native",
    "unfused": "-O3 -march=native -U__FMA__",  # contraction_test.py tells why
    "sanitized": f"-O1 {SANITIZERS}",
    "hardened": "-O1 -D_GLIBCXX_ASSERTIONS -D_GLIBCXX_DEBUG -DSINKMESH_CHECKED",
}
TETRAHEDRA = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def write_points(path, points):
    path.write_text("".join(" ".join(map(repr, map(float, p))) + "\n" for p in points), encoding="utf-8")


def write_inputs(folder):
    """Point sets where all is a tie, where nothing is, and where filters fail; a wedge that needs boundary points."""
    rng = random.Random(1)
    write_points(folder / "grid.xyz", [(x, y, z) for x in range(12) for y in range(11) for z in range(10)])
    write_points(folder / "tenths.xyz", [(x / 10, y / 10, z / 10) for x in range(9) for y in range(9) for z in range(9)])
    write_points(folder / "random.xyz", [[rng.random() for _ in range(3)] for _ in range(4000)])
    write_points(folder / "far.xyz", [[1e6 + rng.random() * 1e-6 for _ in range(3)] for _ in range(1500)])
    write_points(folder / "plane.xyz", [[rng.randrange(99), rng.randrange(99), rng.randrange(2)] for _ in range(1500)])
    corners = [(0, 0, 0), (3, 0, 0), (0.2, 2, 0), (0.3, 0.4, 0.7)]
    text = "OFF\n4 4 0\n" + "".join(f"{x} {y} {z}\n" for x, y, z in corners)
    (folder / "wedge.off").write_text(text + "".join(f"3 {a} {b} {c}\n" for a, b, c in TETRAHEDRA), encoding="utf-8")


def cases(folder):
    """Command lines without outputs."""
    for name in ("grid", "tenths", "random", "far", "plane"):
        for engine in ("star", "flips"):
            yield ["delaunay", folder / f"{name}.xyz", "--engine", engine, "--flow"]
    for name in ("cuboctahedron.off", "star.off", "usa.poly"):
        yield ["delaunay", MODELS / name]
    yield ["refine", MODELS / "usa.poly"]
    yield ["refine", MODELS / "usa.poly", "--boundary", "refine"]
    yield ["refine", folder / "wedge.off"]
    yield ["refine", MODELS / "cuboctahedron.off"]
    for schedule in ("incremental", "block", "parallel"):
        yield ["refine", MODELS / "paraboloid.off", "--insert", "sink", "--schedule", schedule]
    yield ["refine", MODELS / "paraboloid.off", "--insert", "circumcenter", "--boundary", "refine", "--max-vertices", "9000"]


def results(program, folder):
    """For each case the hash of the report and that of the file. A sanitizer that finds something ends the run."""
    environment = dict(os.environ, ASAN_OPTIONS="detect_leaks=1", UBSAN_OPTIONS="print_stacktrace=1")
    found = {}
    for case in cases(folder):
        mesh, report = folder / "out.vtu", folder / "out.json"
        done = subprocess.run([program, *case, "-q", "-o", mesh, "--report", report], env=environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        name = " ".join(word.name if isinstance(word, pathlib.Path) else word for word in case)
        if done.returncode not in (0, 3):  # 3: a limit
            found[name] = f"exit status {done.returncode}: {done.stdout[-2000:]}"
            continue
        hash_of_complex = json.loads(report.read_text(encoding="utf-8"))["hash"]
        found[name] = f"{hash_of_complex} {hashlib.sha256(mesh.read_bytes()).hexdigest()[:16]}"
    return found


def find_compiler(command):
    """Its path; that of the newest version where only names with one are installed."""
    if shutil.which(command):
        return shutil.which(command)
    name = re.compile(re.escape(command) + r"-(\d+)")
    found = [(int(match.group(1)), path) for folder in os.get_exec_path() for path in pathlib.Path(folder).glob(f"{command}-*")
             if (match := name.fullmatch(path.name)) and os.access(path, os.X_OK)]
    if not found:
        sys.exit(f"{command} is not installed (.ci/bootstrap builds)")
    return max(found)[1]


def build(folder, compiler, flags, jobs):
    """The program."""
    for command in (["cmake", "-G", "Ninja", "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=None",
                     "-DSINKMESH_BUILD_TESTS=OFF", f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_CXX_FLAGS={flags}"],
                    ["cmake", "--build", folder, "--target", "sinkmesh", "--parallel", str(jobs)]):
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"{compiler} {flags}: {done.stdout[-4000:]}")
    return folder / "tools" / "sinkmesh"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", help="builds whose name, such as gcc-O2, matches")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="of each build")
    parser.add_argument("--work", type=pathlib.Path, help="folder for the builds, which stay there")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        work = options.work or pathlib.Path(temporary)
        inputs = pathlib.Path(temporary) / "inputs"
        inputs.mkdir()
        write_inputs(inputs)
        expected, first, differences, compared = None, "", 0, 0
        for kind, flags in FLAGS.items():
            for compiler, command in COMPILERS.items():
                name = f"{compiler}-{kind}"
                if not re.search(options.only, name):
                    continue
                found = results(build(work / name, find_compiler(command), flags, options.jobs), inputs)
                expected, first = (found, name) if expected is None else (expected, first)
                wrong = [case for case, result in found.items() if result != expected[case] or "exit" in result]
                for case in wrong:
                    print(f"{name}: {case}: {found[case]}, but {first} {expected[case]}")
                print(f"{name}: {len(found) - len(wrong)} of {len(found)} meshes as by {first}", flush=True)
                differences += len(wrong)
                if kind == "unfused":
                    fused = [line for library in sorted((work / name).rglob("libsinkmesh_*.a"))
                             for line in contraction_test.fused_instructions(library)[1]]
                    print("\n".join([*fused, f"{name}: {len(fused)} fused instructions"]), flush=True)
                    differences += len(fused)
                compared += 1
    print(f"{compared} builds, {differences} differences")
    return 0 if compared > 1 and differences == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
