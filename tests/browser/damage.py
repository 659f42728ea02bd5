"""Copies the example repository twice: with a few faults, and with names that try to get out of every format."""

import json
import pathlib
import shutil
import sys

NAME = "</script><img src=x onerror=alert(1)>]]>\"'&amp;\x1b[31m\u202egnp.\n::error::owned\n##[error]x `|**b** [l](x) {0}"
FILE = "]]>\"'&<b>%0A,line=1\u202e\x1b[2J\n::warning::x`y.target"


def edit(root, file, find, replace):
    path = root / file
    text = path.read_text()
    assert find in text, f"`{find}` is not in {file}"
    path.write_text(text.replace(find, replace, 1))


def copy(source, to):
    shutil.rmtree(to, ignore_errors=True)
    shutil.copytree(source, to)
    edit(to, "data/target/figure/macro.json", '"steps": [0.0, 0.25, 0.5, 1.0]', '"steps": [0.0, 0.25, 0.5, 0.75, 1.0]')
    edit(to, "data/target/figure/head/head-oval.target", "339 0 .001 .001", "339 0 0,001 .001")


source, damaged, hostile = map(pathlib.Path, sys.argv[1:])
copy(source, damaged)
for number in range(14):
    (damaged / f"data/target/figure/head/broken{number}.target").write_text("1 2 x 4\n")
copy(source, hostile)
edit(hostile, "data/rigs/figure/default.mhskel", '"parent": "root"', f'"parent": {json.dumps(NAME)}')
edit(hostile, "data/target/figure/macro.json", '"age": {', f"{json.dumps(NAME)}: {{")
(hostile / "data/target/figure/head" / FILE).write_text("1 2 </script>::error::x]]> 4\n")
