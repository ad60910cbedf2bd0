#!/usr/bin/env python3
"""Reads headers and sources alone, without the precompiled headers that the build gives them.

Finds what does not include all that it uses. Headers are read with the options of a source of the
same folder; NAME-inl.hpp, which several sources include on purpose after others, are left out.

Usage: includes.py FILE... from the root, after a build. Prints the compiler's errors; exits 1 if
there are any.
"""

import os
import re
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from compile_commands import compile_commands


def options_of(entry):
    """Returns the options of a compile command without files and precompiled headers."""
    words = shlex.split(entry["command"])
    skipped = {"-o": 2, "-c": 2, "-include": 2, "-Winvalid-pch": 1}
    kept = []
    while words:
        count = skipped.get(words[0], 0)
        if not count:
            kept.append(words[0])
        words = words[max(count, 1):]
    return kept


def read_alone(file, options):
    """Returns what the compiler says of a file, nothing if all is well."""
    command = [*options, "-fsyntax-only", "-w", "-x", "c++", file]
    result = subprocess.run(command, cwd=Path.cwd(), capture_output=True, text=True, check=False)
    if result.returncode == 0:
        return ""
    return result.stderr or f"{file}: the compiler ends with {result.returncode}\n"


def main():
    entries = compile_commands()
    by_file = {os.path.relpath(entry["file"]): entry for entry in entries}
    by_folder = {os.path.dirname(file): entry for file, entry in by_file.items()}
    work = []
    for file in sys.argv[1:]:
        entry = by_file.get(file) or by_folder.get(os.path.dirname(file))
        if entry and not re.search(r"-inl\.hpp$", file):
            work.append((file, options_of(entry)))
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        findings = list(pool.map(lambda task: read_alone(*task), work))
    sys.stdout.write("".join(findings))
    sys.exit(any(findings))


if __name__ == "__main__":
    main()
