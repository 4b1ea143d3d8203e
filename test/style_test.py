# SPDX-License-Identifier: MIT
"""What the sources must look like: layers, licence, layout, size, folders. Reads files; builds nothing."""
import pathlib
import re
import shutil
import subprocess
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
TOP_LEVEL = {
    "core", "predicates", "refine", "tools", "test", "bench", "CMakeLists.txt", "README.md", "CMakePresets.json",
    ".clang-format", ".clang-tidy", ".gitignore", ".ci", "LICENSE", "CHANGELOG.md"
}
LAYERS = ["predicates", "core", "refine", "tools"]  # each may include those before it
MAX_LINES = 800
MAX_COLUMNS = 112

# What the library must not do. The assertion of checked builds is the one exception.
FORBIDDEN_HEADERS = {"iostream", "fstream", "chrono", "ctime", "time.h", "print", "thread", "random"}
FORBIDDEN_CALLS = re.compile(
    r"\b(?:std::)?(?:printf|fprintf|puts|fputs|putchar|perror|exit|_exit|quick_exit|abort|getenv|setenv|system|rand|"
    r"srand|time|clock|setlocale)\s*\(|\bstd::c(?:out|err|log)\b")
EXEMPT = "predicates/error.h"


def tracked_files():
    """Paths of git, or, without it, everything that is no build folder."""
    try:
        listed = subprocess.run(["git", "-C", str(ROOT), "ls-files", "-co", "--exclude-standard"], check=True,
                                stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout.splitlines()
    except (OSError, subprocess.CalledProcessError):
        listed = [path.relative_to(ROOT).as_posix() for path in ROOT.rglob("*") if path.is_file()]
        listed = [name for name in listed if not name.startswith((".git/", "build", ".cache/", "out/"))]
    return sorted(name for name in listed if (ROOT / name).is_file())


FILES = tracked_files()
CODE = [name for name in FILES if name.endswith((".h", ".cpp"))]
SCRIPTS = [name for name in FILES
           if name.endswith((".py", ".cmake", ".in")) or pathlib.Path(name).name == "CMakeLists.txt" or
           name.startswith(".ci/") or name == ".clang-tidy"]


def text_of(name):
    return (ROOT / name).read_text(encoding="utf-8")


def without_comments_and_strings(text):
    """The same lines, blank where a comment or a string was."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)
    return pattern.sub(lambda found: "\n" * found.group().count("\n"), text)


class Style(unittest.TestCase):
    def check(self, names, complaint):
        """Calls complaint(name), which yields messages, and lists them all."""
        self.assertGreater(len(names), 0, "no files: a test of nothing")
        found = [f"{name}{message}" for name in names for message in complaint(name)]
        self.assertEqual(found, [], "\n" + "\n".join(found))

    def test_layers_include_downwards_only(self):
        def complaint(name):
            layer = name.split("/")[0]
            for number, line in enumerate(text_of(name).splitlines(), 1):
                include = re.match(r'\s*#\s*include\s*["<]([^">]+)[">]', line)
                if include is None:
                    continue
                target = include.group(1).split("/")[0]
                if target in ("test", "bench") and layer not in ("test", "bench"):
                    yield f":{number}: a layer includes {include.group(1)}"
                elif target in LAYERS and layer in LAYERS and LAYERS.index(target) > LAYERS.index(layer):
                    yield f":{number}: {layer} includes {include.group(1)}, which is above it"
                elif target.startswith(".") or (line.lstrip().startswith("#include \"") and "/" not in include.group(1)):
                    yield f":{number}: not included from the root: {include.group(1)}"

        self.check(CODE, complaint)

    def test_layers_link_downwards_only(self):
        def complaint(name):
            for target in re.findall(r"sinkmesh::(\w+)", text_of(name)):
                if target in LAYERS and LAYERS.index(target) > LAYERS.index(name.split("/")[0]):
                    yield f": links {target}, which is above it"

        self.check([f"{layer}/CMakeLists.txt" for layer in LAYERS], complaint)

    def test_the_library_is_silent(self):
        def complaint(name):
            for header in re.findall(r"#\s*include\s*<([^>]+)>", text_of(name)):
                if header in FORBIDDEN_HEADERS:
                    yield f": includes <{header}>"
            if name == EXEMPT:
                return
            for number, line in enumerate(without_comments_and_strings(text_of(name)).splitlines(), 1):
                if FORBIDDEN_CALLS.search(line):
                    yield f":{number}: {line.strip()}"

        self.check([name for name in CODE if name.split("/")[0] in LAYERS[:3]], complaint)

    def test_every_source_names_its_licence(self):
        def complaint(name):
            first = "\n".join(text_of(name).splitlines()[:2])
            if not re.search(r"^(//|#) SPDX-License-Identifier: MIT$", first, re.MULTILINE):
                yield ": no line SPDX-License-Identifier: MIT at its start"

        self.check(CODE + SCRIPTS, complaint)

    def test_files_are_of_readable_size(self):
        def complaint(name):
            lines = text_of(name).splitlines()
            if len(lines) > MAX_LINES:
                yield f": {len(lines)} lines: look for its second subject"
            for number, line in enumerate(lines, 1):
                if len(line) > MAX_COLUMNS and name in CODE and "://" not in line:
                    yield f":{number}: {len(line)} columns"
                if line != line.rstrip():
                    yield f":{number}: blanks at the end of the line"

        self.check(CODE + SCRIPTS, complaint)

    def test_headers_guard_themselves_and_name_no_namespace(self):
        def complaint(name):
            text = text_of(name)
            if "\n#pragma once\n" not in text:
                yield ": no #pragma once"
            if re.search(r"^using namespace ", text, re.MULTILINE):
                yield ": using namespace in a header"

        self.check([name for name in CODE if name.endswith(".h")], complaint)

    def test_top_level_entries(self):
        found = {name.split("/")[0] for name in FILES}
        self.assertEqual(found - TOP_LEVEL, set())
        self.assertLessEqual({"core", "predicates", "refine", "tools", "test", "README.md", "LICENSE"}, found)

    def test_layout(self):
        if shutil.which("clang-format") is None:
            self.skipTest("clang-format is not installed (.ci/bootstrap test does)")
        result = subprocess.run(["clang-format", "--dry-run", "-Werror", *CODE], cwd=ROOT, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True, check=False)
        self.assertEqual(result.returncode, 0, result.stdout[-4000:])


if __name__ == "__main__":
    unittest.main(verbosity=2)
