# SPDX-License-Identifier: MIT
"""Faults that no test can notice, each with the argument why it changes no result."""

# (file, line, the line with the fault) -> argument
ARGUMENTS = {
}


def argument(fault):
    return ARGUMENTS.get((fault.file, fault.before, fault.after))
