# SPDX-License-Identifier: MIT
"""Small faults, found by rules over C++ sources: what a slip of the pen would leave. Reads text; changes nothing."""
import dataclasses
import random
import re

# An operand without an operator of its own: a name, a number, a call, an element, a member.
NAME = r"[A-Za-z_]\w*(?:(?:\.|->|::)\w+|\[[^\[\]]*\]|\([^()]*\))*"
NUMBER = r"(?:0x[\da-f.]+p[+-]?\d+|\d+(?:\.\d+)?)"
OPERAND = rf"(?:{NAME}|{NUMBER})"
SYMMETRIC = r"(?<!dot\()(?<!max\()(?<!min\()(?<!edge\()(?<!distance2\()(?<!distance\()(?<!key_of\()"
PRODUCT = rf"{OPERAND}(?: \* {OPERAND})*"

# Each rule: kind, pattern, replacement. An operator stands between blanks: the layout is that of clang-format, and
# brackets of templates and references have none.
RULES = [
    ("compare", r" < ", " <= "), ("compare", r" <= ", " < "), ("compare", r" > ", " >= "), ("compare", r" >= ", " > "),
    ("compare", r" == ", " != "), ("compare", r" != ", " == "),
    ("sign", r"(?<=[\w)\]]) \+ (?=[\w(])", " - "), ("sign", r"(?<=[\w)\]]) - (?=[\w(])", " + "),
    ("sign", r"(?<=return )-(?=[\w(])", ""), ("sign", r"(?<=[(,=?:] )-(?=[\w(])|(?<=\()-(?=[\w(])", ""),
    ("sign", r" \+= ", " -= "), ("sign", r" -= ", " += "),
    ("logic", r" && ", " || "), ("logic", r" \|\| ", " && "), ("logic", r"!(?=[\w(])", ""),
    ("logic", r"\btrue\b", "false"), ("logic", r"\bfalse\b", "true"), ("logic", r" \|= ", " &= "),
    ("constant", r"\b(?:0x[\da-f.]+p[+-]?\d+|\d+\.\d+)\b", r"(\g<0> / 8)"),
    ("off by one", r"(?<=[\w)\]]) [+-] 1(?=[\s;,)\]])", ""), ("off by one", r"(?<=\[)0(?=\])", "1"),
    ("off by one", r"(?<=\[)[1-9](?=\])", "0"), ("off by one", r"(?<== )0(?=;)", "1"),
    ("off by one", r"(?<=[<>=] )(\d+)(?=[;)\s])", r"(\g<1> + 1)"),
    ("term", rf"(?<=[\w)\]]) [+-] {PRODUCT}(?=[;,)]| [+-] )", ""), ("term", rf"(?<=[\w)\]]) \* {OPERAND}(?=[;,)\s])", ""),
    ("term", rf"(?<=[\w)\]]) (?:&&|\|\|) [!]?{OPERAND}(?=[;,)]| (?:&&|\|\|) )", ""),
    ("swap", rf"\b(?P<a>{OPERAND}) - (?P<b>{OPERAND})(?=[;,)])", r"\g<b> - \g<a>"),
    ("swap", SYMMETRIC + r"(?<=\w\()(?P<a>\*?[A-Za-z_]\w*(?:\[\w+\])?), (?P<b>\*?[A-Za-z_]\w*(?:\[\w+\])?)(?=[,)])", r"\g<b>, \g<a>"),
    # A whole statement on one line: a stage, a test, a step.
    ("dropped", r"^ +if \(.*\) (?:return\b.*|continue|break);$", ""), ("dropped", rf"^ +{NAME}\(.*\);$", ""),
    ("dropped", rf"^ +{NAME} [|&+-]?= [^;]*;$", ""), ("dropped", r"^ +(?:\+\+|--)[\w.\[\]]+;$", ""),
]

# What no fault is planted in: declarations, checks and messages, and what only reserves or fetches ahead.
SKIPPED_LINES = re.compile(r"^\s*(?:#|template\b|using\b|namespace\b|friend\b|static_assert\b|extern\b|class\b|struct\b|@)|"
                           r"\breserve\(|__builtin_prefetch|\boperator<<|^\s*(?:const |constexpr )?\w+&? \w+\(.*\) const;$|= default;|///<")
SKIPPED_STATEMENTS = re.compile(r"\b(?:throw|SINKMESH_ASSERT|static_assert|report\b|add_defect)\b[^;]*;")


@dataclasses.dataclass(frozen=True)
class Fault:
    file: str
    line: int  # from 1
    kind: str
    above: str  # the line above, without its indentation
    before: str  # the line, without its indentation
    after: str
    text: str  # of the whole file with the fault

    def __str__(self):
        return f"{self.file}:{self.line} [{self.kind}]  {self.before}  -->  {self.after or '(nothing)'}"


def blank(found):
    return re.sub(r"[^\n]", " ", found.group())


def code_only(text):
    """The same text with blanks for comments, strings, assertions and errors, so that positions stay."""
    text = re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', blank, text, flags=re.DOTALL)
    return SKIPPED_STATEMENTS.sub(blank, text)


def all_faults(name, text):
    """Every fault that the rules find in a source, in the order of lines."""
    lines = text.split("\n")
    found = []
    seen = set()
    for number, code in enumerate(code_only(text).split("\n")):
        code = code.rstrip()
        if not code.strip() or SKIPPED_LINES.search(code):
            continue
        for kind, pattern, replacement in RULES:
            for match in re.finditer(pattern, code):
                line = lines[number][:match.start()] + match.expand(replacement) + lines[number][match.end():]
                if line == lines[number] or (number, line) in seen:
                    continue
                seen.add((number, line))
                changed = "\n".join([*lines[:number], line, *lines[number + 1:]])
                found.append(Fault(name, number + 1, kind, lines[number - 1].strip(), lines[number].strip(), line.strip(), changed))
    return found


def in_random_order(faults, seed):
    """Kinds by turns, each in an order that depends on the seed and on the file only."""
    shuffled = list(faults)
    random.Random(f"{seed}:{faults[0].file if faults else ''}").shuffle(shuffled)
    turn = {}
    keys = []
    for fault in shuffled:
        turn[fault.kind] = turn.get(fault.kind, -1) + 1
        keys.append(turn[fault.kind])
    return [fault for _, fault in sorted(zip(keys, shuffled), key=lambda pair: pair[0])]
