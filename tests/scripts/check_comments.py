#!/usr/bin/env python3
"""Fails where a comment leans on what is out of sight.

A comment begins with its subject: not with "Of", "What", "As", "The same", "Those", which refer to
something that the reader does not see. Two neighbouring lines of a comment are not equal.

Usage: check_comments.py ROOT. Prints file:line: reason for each, then exits 1.
"""

import re
import sys
from pathlib import Path

FOLDERS = ("engine", "jit", "document", "pipeline", "ui", "app", "papers", "tests")
SUFFIXES = {".cpp", ".hpp", ".def"}
OPENING = r"(Of|What|As|The same|Those)\b"
WHOLE_LINE = re.compile(r"^\s*//+<?\s*(.*)$")
BEGINS = re.compile(OPENING)
BEHIND_CODE = re.compile(r"\S.*///<\s*" + OPENING)


def objections(lines):
    """Returns (line number, reason) of each comment that leans on something."""
    found = []
    before = None  # the text of the comment line above
    for number, line in enumerate(lines, 1):
        match = WHOLE_LINE.match(line)
        text = match.group(1) if match else None
        opening = (BEGINS.match(text) if text is not None and before is None
                   else BEHIND_CODE.search(line) if text is None else None)
        if opening:
            found.append((number, f'a comment begins with "{opening.group(1)}"'))
        if text and len(text) > 8 and text == before:
            found.append((number, "a line of a comment stands there twice"))
        before = text
    return found


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: check_comments.py ROOT")
    root = Path(sys.argv[1])
    found = [
        f"{path.relative_to(root)}:{number}: {reason}"
        for folder in FOLDERS
        for path in sorted((root / folder).rglob("*")) if path.suffix in SUFFIXES
        for number, reason in objections(path.read_text(encoding="utf-8").splitlines())
    ]
    print("\n".join(found) if found else "comments begin with their subjects")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
