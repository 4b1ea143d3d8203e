# SPDX-License-Identifier: MIT
"""Faults that no test can notice, each with the argument why it changes no result."""

# (file, line, the line with the fault) -> argument
ARGUMENTS = {
    ("predicates/polynomials.h", "static constexpr double kErrorBound = (10 + 96 * kUnit) * kUnit;  // [S97]",
     "static constexpr double kErrorBound = (10 + 96) * kUnit;  // [S97]"):
        "a bound ten times as large: fewer signs are certified here, and the next stage gives the same ones",
    ("predicates/detail/expansion.cpp", "if (terms_.size() < 2) return;", "if (terms_.size() <= 2) return;"):
        "sum() leaves strongly nonoverlapping terms, which is all that is promised; compressing only shortens them",
    ("predicates/staged.h", "double error = 0;  ///< of the rounded value", "double error = (0 + 1);  ///< of the rounded value"):
        "every constructor of Predicates calls update(), which sets it before it is read",
}


def argument(fault):
    return ARGUMENTS.get((fault.file, fault.before, fault.after))
