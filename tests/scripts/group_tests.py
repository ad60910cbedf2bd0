#!/usr/bin/env python3
"""Groups sources of tests that can be compiled together, as one source that includes them.

What many of them include and instantiate is then read and compiled once. Only files of one folder go
together, and only where none declares a name that another one uses: an unnamed namespace is the same
in all sources of a group. The headers of all come first, so that none is read after such names.

Usage: group_tests.py OUTPUT_FOLDER SOURCE.... Writes a file for each group of several, and prints, a
line each, what is to be compiled: these files and the other sources.
"""

import re
import sys
from collections import defaultdict
from pathlib import Path

MOST = 8  # sources of a group: a change of one compiles all of them
# What clang-format leaves at the beginning of a line is declared by a namespace. A name there may
# stand before the arguments of a function, a value, an end; or be that of a type.
TYPE = re.compile(r"^(?:enum class|enum|struct|class|union|using)\s+(\w+)", re.M)
VALUE = re.compile(r"^(?![\s#/}]|(?:enum|struct|class|union|namespace)\b)[^\n(={;]*?"
                   r"(\w+)\s*(?:\[[^\n]*?\]\s*)*[(={;]", re.M)
INCLUDE = re.compile(r"^#include [<\"][^\n]*\n", re.M)
DIRECTIVE = re.compile(r"^\s*#(?!include)", re.M)
# These begin a test, not a thing with a name.
TESTS = re.compile(r"^(?:TYPED_)?(?:TEST|TEST_F|TEST_P|TEST_SUITE\w*|INSTANTIATE\w*|REGISTER\w*)$")


def code_of(text):
    """Returns the text without remarks and strings."""
    text = re.sub(r'R"(\w*)\(.*?\)\1"', '""', text, flags=re.S)
    text = re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)
    return re.sub(r'"(\\.|[^"\\\n])*"', '""', text)


def declared_names(text):
    """Returns the names that a source may declare, rather too many than too few."""
    code = code_of(text)
    names = {name for pattern in (TYPE, VALUE) for name in pattern.findall(code)}
    return {name for name in names if not TESTS.match(name)} - {"static_assert"}


def words_of(text):
    return set(re.findall(r"[A-Za-z_]\w*", code_of(text)))


class Group:
    def __init__(self):
        self.sources, self.declared, self.words = [], set(), set()

    def takes(self, declared, words):
        """Returns whether a source of these names can be added: no name of one means another here."""
        return (len(self.sources) < MOST and not declared & self.words
                and not self.declared & words)

    def add(self, source, declared, words):
        self.sources.append(source)
        self.declared |= declared
        self.words |= words


def groups_of(texts):
    """Of {source: text}, returns lists of sources in the order of their names."""
    folders = defaultdict(list)
    # What a directive does may depend on its place.
    alone = [source for source in sorted(texts) if DIRECTIVE.search(texts[source])]
    for source in sorted(set(texts) - set(alone)):
        names = declared_names(texts[source]), words_of(texts[source])
        groups = folders[str(Path(source).parent)]
        group = next((group for group in groups if group.takes(*names)), None)
        if group is None:
            group = Group()
            groups.append(group)
        group.add(source, *names)
    return [group.sources for groups in folders.values() for group in groups] + [
        [source] for source in alone]


def group_text(group, texts):
    """Returns a source of the headers of a group, each once, and then its sources."""
    headers = dict.fromkeys(line for source in group for line in INCLUDE.findall(texts[source]))
    return "".join([*headers, *(f'#include "{source}"\n' for source in group)])


def write_if_changed(path, text):
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def main():
    output, sources = Path(sys.argv[1]), sys.argv[2:]
    output.mkdir(parents=True, exist_ok=True)
    texts = {source: Path(source).read_text(encoding="utf-8") for source in sources}
    for group in groups_of(texts):
        if len(group) == 1:
            print(group[0])
            continue
        path = output / re.sub(r"\W", "_", group[0].rpartition("/tests/")[2])
        path = path.with_name(path.name + "_group.cpp")
        write_if_changed(path, group_text(group, texts))
        print(path)


if __name__ == "__main__":
    main()
