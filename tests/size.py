#!/usr/bin/env python3
"""How much code there is: lines and tokens of each folder, without tests, comments and blank lines.

    python3 tests/size.py [FOLDER]      # of this repository, or of another checkout

A token is a word, a number, a string, a character, a lifetime, or a sign such as `::`. Unit tests
(`#[cfg(test)] mod …`) and the folder `tests/` are left out.
"""

import bisect
import pathlib
import re
import sys

TOKEN = re.compile(
    r"""
    (?P<comment>//[^\n]*|/\*.*?\*/)
    | (?P<raw>b?r(?P<hashes>\#*)".*?"(?P=hashes))
    | (?P<string>b?"(?:[^"\\]|\\.)*")
    | (?P<char>b?'(?:[^'\\]|\\.|\\u\{[^}]*\})')
    | (?P<word>'?[A-Za-z_]\w*|\d[\w.]*)
    | (?P<sign>::|->|=>|\.\.=?|&&|\|\||[<>=!+\-*/%^&|]=|<<|>>|[^\s\w])
    """,
    re.VERBOSE | re.DOTALL,
)


def without_tests(text):
    return text.split("\n#[cfg(test)]\nmod ")[0]


def count(text):
    tokens, lines = 0, set()
    ends = [end.start() for end in re.finditer("\n", text)]
    for found in TOKEN.finditer(without_tests(text)):
        if found.lastgroup != "comment":
            tokens += 1
            lines.add(bisect.bisect(ends, found.start()))
    return tokens, len(lines)


def folder(root, path):
    parts = path.relative_to(root).parts
    return "/".join(parts[:2]) if parts[0] == "crates" else parts[0]


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent)
    sums = {}
    for top in ("src", "crates", "schemas"):
        for path in sorted((root / top).rglob("*.rs")):
            if path.name == "tests.rs":
                continue
            tokens, lines = count(path.read_text(encoding="utf-8"))
            name = folder(root, path)
            known = sums.get(name, (0, 0, 0))
            sums[name] = (known[0] + 1, known[1] + lines, known[2] + tokens)
    rows = sorted(sums.items(), key=lambda row: -row[1][2])
    rows.append(("all", tuple(map(sum, zip(*sums.values())))))
    print(f"{'folder':18}{'files':>7}{'lines':>9}{'tokens':>10}{'a line':>8}")
    for name, (files, lines, tokens) in rows:
        print(f"{name:18}{files:>7}{lines:>9}{tokens:>10}{tokens / max(lines, 1):>8.1f}")


main()
