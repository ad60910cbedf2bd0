#!/usr/bin/env python3
"""Brings the catalogs in resources/languages up to date with the texts of the sources.

Usage: messages.py [--check]. Texts are what the functions in KEYWORDS are called with, the members of
the tables in TABLES and DEFINITIONS, and what the gallery says. With --check nothing is written:
prints, for each catalog, the texts that are not translated and those that no source has, and exits 1
if there are any.

A new text comes without a translation, one that has changed a little as "fuzzy", with a guess: fill
in or correct it, and take the word fuzzy away. Needs gettext.
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "resources/languages"
SOURCES = ["engine", "document", "pipeline", "ui", "app", "papers"]
# Tables whose members are texts: file, members.
TABLES = {
    "engine/render/tracers.cpp": ["about"],
    "papers/tracers/paper_tracers.cpp": ["about"],
    "ui/actions/document_actions.cpp": ["name", "about"],
    "ui/actions/other_words.cpp": ["words"],
    "ui/actions/panel_controls.cpp": ["words"],
    "ui/actions/picture_actions.cpp": ["name", "about"],
    "ui/actions/view_actions.cpp": ["name", "about"],
    "ui/actions/window_actions.cpp": ["name", "about"],
    "ui/exports/drawing_part.cpp": ["name", "about", "usual_width"],
    "ui/exports/export_page.cpp": ["name"],
    "ui/exports/mesh_part.cpp": ["name", "about"],
    "ui/pages/help_panel.cpp": ["title", "typed", "meaning"],
    "ui/pages/tour.cpp": ["title"],
    "ui/panels/side_panel.cpp": ["title"],
    "ui/picture/view_notice.cpp": ["title"],
}
WRITTEN = r'ZEROSET_WRITTEN\(\w+, \w+, "\w+", \d+, -?\d+, "[^"]*", '
# Tables of macros whose last text tells what a row means: file, a row up to that text.
DEFINITIONS = {
    "engine/expr/op.def": r'ZEROSET_OP\(\w+,\s*\w+,\s*"[^"]*",\s*\d,\s*\w+,\s*',
    "engine/language/vocabulary/functions.def":
        r'ZEROSET_FUNCTION\(\w+, "\w+", \d+, -?\d+, "[^"]*", ',
    "engine/language/vocabulary/library.def": r'ZEROSET_LIBRARY\("\w+", "[^"]*", ',
    "engine/language/vocabulary/noises.def": WRITTEN,
    "engine/language/vocabulary/specials.def": WRITTEN,
    "engine/language/vocabulary/written_out.def": WRITTEN,
    "engine/language/vocabulary/shapes.def": r'ZEROSET_WORD\(\w+, "\w+", "[^"]*", "\w+", ',
}
LITERALS = r'"(?:[^"\\]|\\.)*"(?:\s*"(?:[^"\\]|\\.)*")*'
KEYWORDS = ["tr:1", "tr_in:1c,2", "marked:1", "marked_in:1c,2", "choice:1",
            "language_choice:1"]


def source(path):
    """Returns the file's text, with the texts of its tables marked."""
    text = path.read_text()
    members = TABLES.get(str(path.relative_to(ROOT)))
    if members:
        pattern = rf"(\.(?:{'|'.join(members)}) =\s+)({LITERALS})"
        text = re.sub(pattern, r"\1marked(\2)", text, flags=re.DOTALL)
    return text


def with_words(text):
    """Whether a text of a table is more than a formula, which is the same in all languages."""
    return re.search(r"(?<!\S)[A-Za-z]{2,}(?=[\s,.:;]|$)", text)


def meanings():
    """Returns what the tables of operators and functions say of them, as literals."""
    found = []
    for name, macro in DEFINITIONS.items():
        rows = re.findall(rf"^{macro}({LITERALS})", (ROOT / name).read_text(), re.MULTILINE)
        found += [literal for literal in rows if with_words(literal[1:-1])]
    return found


def gallery_texts():
    """Returns the titles, groups and descriptions of the gallery, as literals."""
    texts = []
    for path in sorted((ROOT / "resources/gallery").glob("*.json")):
        gallery = json.loads(path.read_text())
        for holder in [gallery, *gallery["items"]]:
            texts += [holder[key] for key in ("group", "title", "about") if key in holder]
    return [json.dumps(text, ensure_ascii=False) for text in texts]


def template(folder):
    """Writes all texts to a .pot file in `folder`; returns its path."""
    names = []
    for top in SOURCES:
        for path in sorted((ROOT / top).rglob("*.[ch]pp")):
            name = path.relative_to(ROOT)
            copy = folder / name
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_text(source(path))
            names.append(str(name))
    for name, literals in (("meanings.hpp", meanings()), ("gallery.hpp", gallery_texts())):
        (folder / name).write_text("".join(f"marked({literal});\n" for literal in literals))
        names.append(name)
    pot = folder / "zeroset.pot"
    command = ["xgettext", "--language=C++", "--from-code=UTF-8", "--no-wrap", "--no-location",
               "--sort-output", "--add-comments=Translators:", "--package-name=zeroset",
               "--keyword", *(f"--keyword={keyword}" for keyword in KEYWORDS),
               "-o", str(pot)]
    subprocess.run(command + names, cwd=folder, check=True)
    # No text is a pattern of printf, even with a % in it.
    pot.write_text(re.sub(r"(?m)^#, c-format\n", "", pot.read_text()))
    return pot


def entries(po, *options):
    """Returns the messages of a catalog that msgattrib chooses, as its blocks of lines."""
    found = subprocess.run(["msgattrib", "--no-wrap", *options, str(po)], check=True,
                           capture_output=True, text=True).stdout
    return [block for block in found.strip().split("\n\n") if block and 'msgid ""\nmsgstr' not in block]


def update(pot):
    for po in sorted(FOLDER.glob("*.po")):
        subprocess.run(["msgmerge", "--quiet", "--update", "--backup=none", "--no-wrap",
                        "--no-location", "--sort-output", str(po), str(pot)], check=True)
        subprocess.run(["msgattrib", "--no-obsolete", "--no-wrap", "--sort-output", "-o", str(po),
                        str(po)], check=True)
        open_ones = entries(po, "--untranslated") + entries(po, "--only-fuzzy")
        print(f"{po.name}: {len(open_ones)} texts to translate")


def places(text):
    """Returns the places for values in a text, such as {0}."""
    return sorted(set(re.findall(r"\{\d\}", text)))


def wrong_places(po):
    """Returns the messages of a catalog whose translation has other places than the text."""
    wrong = []
    for block in entries(po, "--translated"):
        text, _, translation = block.partition("\nmsgstr")
        text = text[text.index("\nmsgid" if "\nmsgid" in text else "msgid"):]
        if places(text) != places(translation):
            wrong.append(block)
    return wrong


def check(pot, folder):
    bad = 0
    for po in sorted(FOLDER.glob("*.po")):
        merged = folder / po.name
        subprocess.run(["msgmerge", "--quiet", "--no-fuzzy-matching", "--no-wrap", "-o", str(merged),
                        str(po), str(pot)], check=True)
        for block in entries(merged, "--untranslated") + entries(merged, "--only-fuzzy"):
            print(f"{po.name}: to translate:\n{block}")
            bad += 1
        for block in wrong_places(merged):
            print(f"{po.name}: other places for values:\n{block}")
            bad += 1
        for block in entries(merged, "--only-obsolete"):
            print(f"{po.name}: in no source:\n{block}")
            bad += 1
    return bad


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        pot = template(folder)
        if sys.argv[1:] == ["--check"]:
            sys.exit(1 if check(pot, folder) else 0)
        if sys.argv[1:]:
            sys.exit(__doc__)
        update(pot)


main()
