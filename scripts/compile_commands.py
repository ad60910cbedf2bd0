#!/usr/bin/env python3
"""Prints the compile commands of the last build with one for each source.

The build compiles some tests in groups (tests/scripts/group_tests.py). Here each of a group has the
group's command, with its own file.

Usage: compile_commands.py, from the root after a build. Prints JSON, a key on a line.
"""

import json
import re
from pathlib import Path

COMMANDS = Path("build/release/compile_commands.json")
GROUP = re.compile(r"/groups/\w+_group\.cpp$")
INCLUDED = re.compile(r'^#include "(/[^"]+\.cpp)"', re.M)


def single(entries):
    """Returns the entries with those of groups replaced by one for each source."""
    found = []
    for entry in entries:
        if not GROUP.search(entry["file"]):
            found.append(entry)
            continue
        for source in INCLUDED.findall(Path(entry["file"]).read_text(encoding="utf-8")):
            found.append(entry | {"command": entry["command"].replace(entry["file"], source),
                                  "file": source})
    return found


def compile_commands():
    return single(json.loads(COMMANDS.read_text(encoding="utf-8")))


if __name__ == "__main__":
    print(json.dumps(compile_commands(), indent=0))
