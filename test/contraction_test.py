#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""No multiplication is fused with an addition: disassembles objects, libraries or programs.

    python3 -B test/contraction_test.py FILE...

Signs are exact only if each operation rounds by itself. Where a processor can fuse them, build with -U__FMA__: it takes
away the one std::fma that is meant (predicates/detail/rounding.h), and leaves what the compiler fuses by itself.
"""
import re
import shutil
import subprocess
import sys

FUSED = re.compile(r"^v?fn?m(?:add|sub|addsub|subadd|la|ls)[\w.]*$")  # x86 (fused, FMA4), ARM, POWER, RISC-V


def instructions(path):
    """Member of the library, function and mnemonic of every instruction."""
    listed = subprocess.run(["objdump", "-d", "--no-show-raw-insn", "-C", path], check=True, stdout=subprocess.PIPE,
                            text=True, errors="replace").stdout
    member, function = "", ""
    for line in listed.splitlines():
        if match := re.match(r"(\S+):\s+file format", line):
            member = match.group(1)
        elif match := re.match(r"[0-9a-f]+ <(.*)>:$", line):
            function = match.group(1)
        elif match := re.match(r"\s*[0-9a-f]+:\s+(?:\w+ )*?(\S+)(?:\s|$)", line):
            yield member, function, match.group(1)


def fused_instructions(path):
    """How many instructions there are, and a line for each one that is fused."""
    count, found = 0, []
    for member, function, mnemonic in instructions(path):
        count += 1
        if FUSED.match(mnemonic):
            found.append(f"{member or path}: {mnemonic} in {function}")
    return count, found


def main():
    if shutil.which("objdump") is None:
        print("objdump is not installed (Debian: binutils)")
        return 77
    total = 0
    failures = []
    for path in sys.argv[1:]:
        count, found = fused_instructions(path)
        if count == 0:
            failures.append(f"{path}: holds no instructions")
        total += count
        failures += found
    print("\n".join([*failures, f"{total} instructions, {len(failures)} findings"]))
    return 0 if total > 0 and not failures else 1


if __name__ == "__main__":
    sys.exit(main())
