#!/usr/bin/env python3
"""Makes the pictures of the documents from the present program.

Usage: pictures.py PROGRAM FOLDER [NAME...], or pictures.py --check PROGRAM. Without names all are
made. With --check they are made into a folder that is thrown away: prints the pictures in
resources/docs that differ much, and exits 1 if there are any.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DOCS = ROOT / "resources" / "docs"
sys.path.insert(0, str(ROOT / "tests" / "end_to_end"))
from zeroset_program import read_png  # noqa: E402  pylint: disable=wrong-import-position

GYROID = "sin(a x) cos(a y) + sin(a y) cos(a z) + sin(a z) cos(a x)"
WAVES = "z = a sin(3x) cos(3y) / 2"
CERTIFICATE_VIEW = ["--eye=5,-6,4", "--fov", "30", "--size", "240x240", "--box", "2"]
WINDOW = ["--theme", "light", "--size", "1024x640"]
LARGE_WINDOW = ["--theme", "light", "--size", "1280x800"]
# The section of the panel that is open at first, to be closed.
SECTIONS_ASIDE = ["--do", "Section: View"]

# Name: the subcommand and its arguments; what is written follows "-o".
PICTURES = {
    "gyroid_ball.png": [
        "render", f"a = 3; max(|{GYROID}| - 0.25, x^2 + y^2 + z^2 - 6) = 0", "--box", "2.6",
        "--fov", "26", "--aa", "iaa", "--size", "1200x660"],
    "window_light.png": [
        "dev", "ui-shot", f"gyroid = {GYROID}; |gyroid| = 0.3, x^2 + y^2 + z^2 < 4; "
        "x^2 + y^2 + z^2 = 1.2", "--set", "a=1.8", "--box", "2.1", "--shadows", "--aa", "iaa",
        *WINDOW],
    "window_gallery.png": ["dev", "ui-shot", "@klein", "--do", "Gallery", *WINDOW],
    "window_export.png": ["dev", "ui-shot", "@tangle", "--do", "Save a film...", *LARGE_WINDOW],
    "tour_axes.png": ["dev", "ui-shot", WAVES, "--textbook", *WINDOW],
    "tour_class.png": ["dev", "ui-shot", WAVES, "--do", "Presentation", *WINDOW],
    "tour_curvature.png": [
        "dev", "ui-shot", "@klein", "--color-by", "mean-curvature", "--contours", "height; labels",
        "--section", "y>-2", "--clip-box", *SECTIONS_ASIDE, "--do", "Section: Clip",
        "--do", "Handles", *WINDOW],
    "tour_german.png": [
        "dev", "ui-shot", "@tangle", "--textbook", "--language", "de", *LARGE_WINDOW],
    "tour_light.png": [
        "dev", "ui-shot", "@tangle", "--look", "metal", "--reflections", "3", "--shadows", "--aa", "iaa",
        *SECTIONS_ASIDE, "--do", "Section: Light", *WINDOW],
    "tour_markers.png": [
        "dev", "ui-shot", "x^2 + y^2 = z^2 (1 - z)", "--mark", "0,0,0; label node", "--textbook",
        "--opacity", "0.7", *SECTIONS_ASIDE, "--do", "Section: Markers", *WINDOW],
    "turntable.gif": [
        "turntable", "@tangle", "--size", "300x200", "--frames", "24", "--fps", "12", "--aa",
        "iaa"],
    "pole.png": ["render", "1/(x - y^2) = z", *CERTIFICATE_VIEW],
    "floor.png": ["render", "floor(x) = y", *CERTIFICATE_VIEW],
    "sign.png": ["render", "sign(x) = y", *CERTIFICATE_VIEW],
    "draw_klein.svg": ["draw", "@klein", "--hidden", "dash", "--size", "240x240"],
    "draw_cube.svg": ["draw", "@machined_cube", "--size", "240x240"],
    "draw_tangle.svg": [
        "draw", "@tangle", "--lines", "silhouette,contour", "--contours", "height; step 0.3",
        "--size", "240x240"],
}
for look in ("matte", "porcelain", "metal", "glass", "clay", "technical"):
    PICTURES[f"looks/{look}.png"] = [
        "render", "@tangle", "--look", look, "--aa", "iaa", "--size", "260x220", "--no-session"]


def made(program, name, command, folder):
    """Makes a picture; with the certificates of a picture beside it."""
    out = folder / name
    out.parent.mkdir(parents=True, exist_ok=True)
    more = []
    if command[:1] == ["render"] and command[2:] == CERTIFICATE_VIEW:
        more = ["--certificate", str(out.with_name(out.stem + "_certificate.png"))]
    # The page of exports shows the current folder.
    subprocess.run([program, *command, "-o", str(out), *more], check=True, cwd="/tmp",
                   stdout=subprocess.DEVNULL)


def main():
    arguments = sys.argv[1:]
    check = arguments[:1] == ["--check"]
    if len(arguments) < 2:
        sys.exit(__doc__)
    program = str(Path(arguments[1 if check else 0]).resolve())
    wanted = [] if check else arguments[2:]
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch if check else arguments[1]).resolve()
        for name, command in PICTURES.items():
            if not wanted or name in wanted:
                made(program, name, command, folder)
        if check:
            sys.exit(compare(folder))


def compare(folder):
    """Prints what differs from the documents' pictures; returns the exit code."""
    old = []
    for path in sorted(folder.rglob("*")):
        if path.is_dir():
            continue
        name = path.relative_to(folder)
        kept = DOCS / name
        if not kept.exists():
            old.append(f"{name} is not there")
        elif path.suffix == ".png":
            difference = read_png(path).difference(read_png(kept))
            if difference > 0.02:
                old.append(f"{name} differs by {difference:.3f}")
    named = {name for page in DOCS.glob("*.md")
             for name in re.findall(r"\]\(([\w/]+\.(?:png|svg|gif))\)", page.read_text("utf-8"))}
    old += [f"{name} is named by a page and not there"
            for name in sorted(named) if not (DOCS / name).exists()]
    print("\n".join(old) if old else "all pictures are those of the program")
    return 1 if old else 0


if __name__ == "__main__":
    main()
