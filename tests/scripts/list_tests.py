#!/usr/bin/env python3
"""Writes for ctest what a program of GoogleTest holds: one entry for each of its source files.

tests/engine/trace/caps_test.cpp is the entry engine/trace/caps, which runs the cases of that file in
one process: starting one for each case takes as long as most cases do.

Usage: list_tests.py PROGRAM OUTPUT [LONG...]. LONG are entries that begin before others, the first
one first. Called after PROGRAM was linked.
"""

import json
import subprocess
import sys
import tempfile
from collections import defaultdict
from pathlib import Path


def listed_suites(program):
    """Returns {suite: {case: source file}}."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "tests.json"
        subprocess.run([program, "--gtest_list_tests", f"--gtest_output=json:{report}"],
                       check=True, stdout=subprocess.DEVNULL, timeout=60)
        suites = json.loads(report.read_text(encoding="utf-8"))["testsuites"]
    return {suite["name"]: {case["name"]: case["file"] for case in suite["testsuite"]}
            for suite in suites}


def entry_of(source):
    """Returns the entry of a source file, whose path may be relative to any folder."""
    return source.rpartition("tests/")[2].removesuffix(".cpp").removesuffix("_test")


def filters(suites):
    """Returns {entry: filters of its cases}; a suite of one file is one filter."""
    found = defaultdict(list)
    for suite, cases in suites.items():
        entries = {entry_of(source) for source in cases.values()}
        if len(entries) == 1:
            found[entries.pop()].append(f"{suite}.*")
        else:
            for case, source in cases.items():
                found[entry_of(source)].append(f"{suite}.{case}")
    return found


def ctest_commands(program, entries, long_entries):
    """Returns lines for ctest to read."""
    lines = []
    for entry, wanted in sorted(entries.items()):
        lines.append(f"add_test([[{entry}]] [[{program}]] [[--gtest_filter={':'.join(wanted)}]])")
        if entry in long_entries:
            cost = 2000 - long_entries.index(entry)
            lines.append(f"set_tests_properties([[{entry}]] PROPERTIES COST {cost})")
    return lines


def main():
    program, output, *long_entries = sys.argv[1:]
    lines = ctest_commands(program, filters(listed_suites(program)), long_entries)
    Path(output).write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
