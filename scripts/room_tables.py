#!/usr/bin/env python3
"""Generates from rooms.txt the table of rooms in resources/docs/architecture.md, and the lists of
folders in .clang-format and .clang-tidy.

Usage: room_tables.py [--check]. With --check nothing is written: prints the files that do not match
rooms.txt, and the rooms whose page does not name their tests, and exits 1 if there are any.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def folders(lines):
    """Returns (folder, purpose) of each folder at the root, from lines "## FOLDER | PURPOSE"."""
    rows = [line[3:].split("|") for line in lines if line.startswith("## ")]
    return [(name.strip(), purpose.strip()) for name, purpose in rows]


def rooms(lines):
    """Returns (room, purpose) of each room that has a purpose."""
    rows = [line.split("|") for line in lines if line.strip() and not line.startswith("#")]
    return [(row[0].strip(), row[2].strip()) for row in rows if row[2].strip()]


def links(folder, names):
    """Returns links to the pages of a folder's rooms, as seen from resources/docs."""
    inside = [name for name in names if name == folder or name.startswith(folder + "/")]
    return ", ".join(f"[{name.removeprefix(folder + '/')}](../../{name}/README.md)"
                     for name in inside if (ROOT / name / "README.md").exists())


def table(lines):
    names = [name for name, _ in rooms(lines)]
    rows = [f"| `{name}/` | {purpose} | {links(name, names)} |" for name, purpose in folders(lines)]
    return "\n".join(["| folder | | rooms |", "|---|---|---|"] + rows)


def replaced(text, pattern, replacement, name):
    """Returns `text` with the one match of `pattern` replaced; exits if there is not just one."""
    result, count = re.subn(pattern, lambda _: replacement, text, flags=re.DOTALL)
    if count != 1:
        sys.exit(f"{name}: {count} places to be written, one is needed: {pattern}")
    return result


def written(lines):
    """Returns the generated text of each file, by its name."""
    code = "|".join(name for name, _ in folders(lines) if name != "resources")
    between = r"(?<=<!-- rooms -->\n).*?(?=\n<!-- end -->)"
    changes = {
        "resources/docs/architecture.md": (between, table(lines)),
        ".clang-format": (r"(?<=\{Regex: '\^\"\()[^)]*(?=\)/', Priority: 1\})", code),
        ".clang-tidy": (r"(?<=HeaderFilterRegex: '/\()[^)]*(?=\)/')", code),
    }
    return {
        name: replaced((ROOT / name).read_text(encoding="utf-8"), *change, name)
        for name, change in changes.items()
    }


def faults_of_pages(lines):
    """Returns what is wrong with the line "Tests:" of the rooms' pages."""
    for name, _ in rooms(lines):
        page = ROOT / name / "README.md"
        tests = re.findall(r"^Tests: .*", page.read_text(encoding="utf-8") if page.exists() else "",
                           flags=re.MULTILINE)
        if not tests:
            yield f"{name}/README.md has no line that begins with Tests:"
        for path in re.findall(r"`(tests/[^`]+)`", " ".join(tests)):
            if not (ROOT / path).exists():
                yield f"{name}/README.md: {path} is not there"


def main():
    lines = (ROOT / "rooms.txt").read_text(encoding="utf-8").splitlines()
    stale = [
        name for name, text in written(lines).items()
        if (ROOT / name).read_text(encoding="utf-8") != text
    ]
    if sys.argv[1:] == ["--check"]:
        faults = [f"{name} does not follow rooms.txt: run scripts/room_tables.py" for name in stale]
        faults += faults_of_pages(lines)
        print("\n".join(faults) or "all tables follow rooms.txt")
        sys.exit(1 if faults else 0)
    for name in stale:
        (ROOT / name).write_text(written(lines)[name], encoding="utf-8")


if __name__ == "__main__":
    main()
