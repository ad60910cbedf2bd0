#!/usr/bin/env python3
"""Fails where a comment leans on what is out of sight.

A comment begins with its subject: not with "Of", "What", "As", "The same", "Those", which refer to
something that the reader does not see. Two neighbouring lines of a comment are not equal. A file that
a comment or a page names by its path is there, and a source that is cited is in references.md.

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
PATH = re.compile(r"(?<![\w./-])(?:%s|resources|scripts)/[\w./-]+\.(?:[ch]pp|def|md|py)\b"
                  % "|".join(FOLDERS))
CITED = re.compile(r"[\[;]\s?([A-Z][A-Za-z]+[0-9]{2})\b(?=[],;])")


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


def unresolved(lines, is_there, sources):
    """Returns (line number, reason) of each file named, and each source cited, that is not there."""
    return [(number, f"{what} is not there")
            for number, line in enumerate(lines, 1)
            for what in [path for path in PATH.findall(line) if not is_there(path)] +
                        [tag for tag in CITED.findall(line) if f"[{tag}]" not in sources]]


def remarks(path, lines):
    """The lines of a page, or of a source what is behind //."""
    return lines if path.suffix == ".md" else [line.partition("//")[2] for line in lines]


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: check_comments.py ROOT")
    root = Path(sys.argv[1])
    sources = (root / "resources/docs/references.md").read_text(encoding="utf-8")
    found = []
    paths = [root / "README.md", root / "CONTRIBUTING.md"]
    paths += [path for folder in (*FOLDERS, "resources") for path in sorted((root / folder).rglob("*"))
              if path.suffix in SUFFIXES or path.suffix == ".md"]
    for path in paths:
        lines = path.read_text(encoding="utf-8").splitlines()
        reasons = objections(lines) if path.suffix in SUFFIXES else []
        reasons += unresolved(remarks(path, lines), lambda name: (root / name).exists(), sources)
        found += [f"{path.relative_to(root)}:{number}: {reason}" for number, reason in reasons]
    print("\n".join(found) if found else "comments begin with their subjects")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
