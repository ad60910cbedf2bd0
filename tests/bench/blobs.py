#!/usr/bin/env python3
"""Times soft balls at random, or a list of them, from eyes on an orbit.

    blobs.py build/release/zeroset [--balls 10000] [--file LIST.txt] [--views 8] [--size 1280x800]
        [--dstop 14] [--repeat 5] [--near]

Prints for each word (blobs, metaballs, blinn) the medians of each view's frames: the least, the
median and the largest of them, in milliseconds; the share of pixels that show something; and how
many are undecided. --near looks from so near that the balls fill the picture.
"""

import argparse
import json
import math
import random
import statistics
import subprocess
import tempfile
from pathlib import Path


def write_balls(path, count):
    """Writes balls in the cube [-1, 1]^3 that overlap as those of a liquid: some fill a twelfth."""
    numbers = random.Random(1)
    usual = 0.03 * (10000 / count) ** (1 / 3)
    with open(path, "w", encoding="ascii") as out:
        for _ in range(count):
            place = " ".join(f"{numbers.uniform(-1, 1):.6f}" for _ in range(3))
            out.write(f"{place} {usual * numbers.uniform(2 / 3, 4 / 3):.6f}\n")


def bounds(path):
    rows = [line.split() for line in path.read_text(encoding="utf-8").splitlines()]
    points = [[float(x) for x in row[:3]] for row in rows if row and row[0][0] not in "#/"]
    lo = [min(point[i] for point in points) for i in range(3)]
    hi = [max(point[i] for point in points) for i in range(3)]
    return [(a + b) / 2 for a, b in zip(lo, hi)], max(b - a for a, b in zip(lo, hi)) / 2


def joined(numbers):
    return ",".join(f"{x:.9g}" for x in numbers)


def stats_of(options, equation, folder, middle, half, angle):
    away = (2.0 if options.near else 4.0) * half
    eye = [middle[0] + away * math.cos(angle), middle[1] + away * math.sin(angle),
           middle[2] + 0.45 * away]
    box = [bound for x in middle for bound in (x - 1.2 * half, x + 1.2 * half)]
    run = subprocess.run(
        [options.program, "render", equation, "--box=" + joined(box), "--eye=" + joined(eye),
         "--look-at=" + joined(middle), "--size", options.size, "--dstop", options.dstop,
         "--repeat", str(options.repeat), "--stats", "-", "-o", str(folder / "picture.png")],
        capture_output=True, check=True)
    return json.loads(run.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("--balls", type=int, default=10000)
    parser.add_argument("--file", type=Path)
    parser.add_argument("--views", type=int, default=8)
    parser.add_argument("--size", default="1280x800")
    parser.add_argument("--dstop", default="14")
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--near", action="store_true")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        path = options.file
        if path is None:
            path = folder / "balls.txt"
            write_balls(path, options.balls)
        middle, half = bounds(path)
        print(f"{'':10}  least ms  median ms  largest ms  shown  undecided")
        for word in ("blobs", "metaballs", "blinn"):
            equation = f'{word}("{path.resolve()}") = 1'
            found = [stats_of(options, equation, folder, middle, half, 2 * math.pi * i / options.views)
                     for i in range(options.views)]
            times = [stats["frame_ms"]["median"] for stats in found]
            pixels = sum(stats["certified"] + stats["undecided"] for stats in found)
            whole = sum(stats["width"] * stats["height"] for stats in found)
            undecided = sum(stats["undecided"] for stats in found)
            print(f"{word:10}  {min(times):8.1f}  {statistics.median(times):9.1f}  "
                  f"{max(times):10.1f}  {100 * pixels / whole:3.0f} %  {undecided:9}", flush=True)


if __name__ == "__main__":
    main()
