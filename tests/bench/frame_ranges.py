#!/usr/bin/env python3
"""Times films with and without frame ranges: Florez' three experiments of chapter 6, and a turn.

    frame_ranges.py build/release/zeroset [--frames 100] [--size 512x512] [--repeat 3]
"""

import argparse
import json
import statistics
import subprocess
import tempfile

ORTHOCIRCLE = ("((x^2+y^2-1)^2+z^2)*((y^2+z^2-1)^2+x^2)*((z^2+x^2-1)^2+y^2)"
               " = a^2*(1+b*(x^2+y^2+z^2))")
MORPH = ("(1-a)*(x^4+y^4+z^4-x^2-y^2-z^2+0.5)"
         " + a*((1+x^2)*(1+y^2)*(1+z^2) + 8*x*y*z - 2) = 0")
CORNERS = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
SPHERES = "min(%s) = 0.09" % ", ".join(
    "(x%+da)^2 + (y%+da)^2 + (z%+da)^2" % corner for corner in CORNERS)

# (name, arguments, what Florez reports)
FILMS = [
    ("orthocircle, a and b change", ["animate", ORTHOCIRCLE, "--sweep", "a=0.04..0.12", "--sweep",
                                     "b=1..4", "--turn", "60", "--box", "1.6"], "40 to 54 %"),
    ("spheres fly apart", ["animate", SPHERES, "--sweep", "a=0..1.2", "--box", "1.6"],
     "32 to 66 %"),
    ("chubs into mcmullen_k3", ["animate", MORPH, "--sweep", "a=0..1", "--turn", "180", "--axis",
                                "1,1,0", "--box", "3"], "10 %"),
    ("orthocircle on a turntable", ["turntable", ORTHOCIRCLE, "--set", "a=0.075", "--set", "b=3",
                                    "--box", "1.6"], ""),
]
LOOKS = [("plain", []), ("shadows", ["--shadows"]), ("smooth edges", ["--shadows", "--aa", "iaa"])]


def drawn(program, arguments, options, folder, frame_range):
    """The statistics of a film."""
    command = [program, *arguments, "--frames", str(options.frames), "--size", options.size,
               "--end", "stop", "--frame-range", frame_range, "--stats", "-",
               "-o", folder + "/film.mkv"]
    done = subprocess.run(command, capture_output=True, check=True, text=True)
    return json.loads(done.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--frames", type=int, default=100)
    parser.add_argument("--size", default="512x512")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--ranges", default="4,16,auto", help="values of --frame-range")
    options = parser.parse_args()
    print(f"{options.frames} frames of {options.size}; ms a frame, medians of {options.repeat}; "
          "in brackets the time that is saved, and the evaluations of f")
    with tempfile.TemporaryDirectory() as folder:
        for name, arguments, reported in FILMS:
            for look, extra in LOOKS:
                times, evaluations = {}, {}
                for _ in range(options.repeat):
                    for frame_range in ["off", *options.ranges.split(",")]:
                        stats = drawn(options.program, arguments + extra, options, folder,
                                      frame_range)
                        times.setdefault(frame_range, []).append(stats["drawing_ms"])
                        evaluations[frame_range] = stats["evaluations"]
                row = []
                for frame_range, each in times.items():
                    ms = statistics.median(each)
                    saved = 1 - ms / statistics.median(times["off"])
                    fewer = 1 - evaluations[frame_range] / evaluations["off"]
                    row.append(f"{frame_range} {ms / options.frames:.2f} ({saved:+.0%}, "
                               f"{fewer:+.0%})")
                print(f"{name}, {look}: {'; '.join(row)}"
                      + (f"; Florez: {reported}" if reported else ""), flush=True)


if __name__ == "__main__":
    main()
