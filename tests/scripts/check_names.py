#!/usr/bin/env python3
"""Fails where two files give one name, in one namespace, to two types.

The linker keeps one of the functions that templates such as std::vector<Name> are made into, for
both types; a template and a plain type of one name are ill-formed. What is in unnamed namespaces the
linker never sees.

Usage: check_names.py ROOT. Prints each name and its files, then exits 1.
"""

import collections
import re
import sys
from pathlib import Path

ROOMS = ("engine", "jit", "document", "pipeline", "ui", "app", "papers")
NAMESPACE = re.compile(r"\bnamespace\b\s*([\w:]*)$")
TYPE = re.compile(
    r"\b(?:enum\s+class|enum|struct|class|union)\s+(?:alignas\([^)]*\)\s*)?(\w+)"
    r"\s*(?:final\s*)?(?::[^:].*)?$", re.S)


def code_of(text):
    """The text without strings, remarks and directives."""
    text = re.sub(r'R"(\w*)\(.*?\)\1"', '""', text, flags=re.S)
    text = re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)
    text = re.sub(r'"(\\.|[^"\\\n])*"', '""', text)
    text = re.sub(r"(?<=[0-9a-fA-F])'(?=[0-9a-fA-F])", "", text)
    text = re.sub(r"'(\\.|[^'\\\n])+'", "0", text)
    return re.sub(r"^[ \t]*#([^\n]*\\\n)*[^\n]*", "", text, flags=re.M)


def types_of(text):
    """The types that a file defines in named namespaces, by their full names."""
    code = code_of(text)
    blocks, start = [], 0  # of each open bracket: the namespace's name, or None
    for sign in re.finditer(r"[{};]", code):
        head = code[start:sign.start()].strip()
        start = sign.end()
        if sign.group() == "}" and blocks:
            blocks.pop()
        if sign.group() != "{":
            continue
        space = NAMESPACE.search(head)
        kind = TYPE.search(head)
        if kind and all(blocks) and "=" not in head[:kind.start()]:
            yield "::".join([*blocks, kind.group(1)])
        blocks.append(space.group(1) if space else None)


def clashes(files):
    """Of {file: text}, the names that several files give to types, with the files."""
    places = collections.defaultdict(list)
    for file, text in files.items():
        for found in sorted(set(types_of(text))):
            places[found].append(file)
    return {name: where for name, where in sorted(places.items()) if len(where) > 1}


def main(root):
    paths = [path for room in ROOMS for path in sorted((root / room).rglob("*.[hc]pp"))]
    texts = {str(path.relative_to(root)): path.read_text(encoding="utf-8") for path in paths}
    found = clashes(texts)
    for name, where in found.items():
        print(f"{name} is a type of its own in each of {', '.join(where)}")
    return 1 if found or not paths else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
