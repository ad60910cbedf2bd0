#!/usr/bin/env python3
"""Plots the results of `zeroset dev compare --json FILE` as an SVG: a line for each row, grouped by surface,
over a logarithmic axis of times; a dot for this machine, a ring for what is printed.

    build/release/zeroset dev compare florez-table-4.1 --json florez.json
    scripts/plot_compare.py florez.json florez.svg
"""

import json
import math
import sys
from html import escape

WIDTH, LEFT, RIGHT, TOP = 920, 172, 800, 92
ROW, GAP, TITLE, DOT = 17, 10, 20, 4.2
INK, SOFT, GRID = "#22262e", "#686e7a", "#e2e5ea"
HERE, BEAMS, PRINTED, WRONG = "#1f65b0", "#d95f0e", "#808692", "#be1e2d"


def voxel_rows(answer):
    """Returns the rows of a table of rays in voxels as those of frames: times of a million intersections."""
    rows, first = [], {}
    for row in answer["rows"]:
        ms = 1000 / row["millions_per_s"]["avg"]
        figures = row["printed"]
        figure = figures["avg"] if "avg" in figures else sum(figures.values()) / len(figures)
        base_ms, base_figure = first.setdefault(row["scene"], (ms, figure))
        rows.append({"case": row["scene"], "tracer": row["method"], "ms": ms, "times": ms / base_ms,
                     "printed_ms": 1000 / figure, "printed_times": base_figure / figure,
                     "wrong": row["missed"] + row["added"], "of": "voxel"})
    return rows


def frame_rows(answer):
    """Returns the rows of a table of frames."""
    several = {key: len({row[key] for row in answer["rows"]}) > 1
               for key in ("wanted_d_stop", "reflections")}

    def case(row):
        mirrors = row["reflections"]
        return (row["surface"] + (f', d_stop {row["wanted_d_stop"]}' if several["wanted_d_stop"] else "")
                + ("" if not several["reflections"] else f", {mirrors} levels of reflections" if mirrors
                   else ", ray casting"))

    return [{"case": case(row), "tracer": row["tracer"], "ms": row["frame_ms"]["median"],
             "times": row["times"], "printed_ms": row["printed_ms"],
             "printed_times": row["printed_times"], "wrong": row["missed"] + row["added"], "of": "pixel"}
            for row in answer["rows"]]


def time_text(ms):
    """Returns a time in three digits and the unit that suits it."""
    return f"{ms:.3g} ms" if ms < 1000 else f"{ms / 1000:.3g} s" if ms < 1e6 else f"{ms / 1000:.0f} s"


def times_text(times):
    return "" if times is None else f" ×{times:.2g}" if times < 99.5 else f" ×{times:.0f}"


def text(x, y, words, color=INK, size=10, anchor="start"):
    """Returns a text whose digits' middle is at a height, on a white ground."""
    return (f'<text x="{x:.2f}" y="{y + 0.365 * size:.2f}" font-size="{size}" text-anchor="{anchor}" '
            f'fill="{color}">{escape(words)}</text>')


def dot(x, y, color):
    return f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{DOT}" fill="{color}"/>'


def ring(x, y, color):
    return (f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{DOT - 0.6}" fill="none" stroke="{color}" '
            'stroke-width="1.4"/>')


def line(x1, y1, x2, y2):
    return f'<line x1="{x1:.2f}" y1="{y1:.2f}" x2="{x2:.2f}" y2="{y2:.2f}" stroke="{GRID}"/>'


class Axis:
    """A logarithmic axis of times."""

    def __init__(self, times):
        self.first = math.floor(math.log10(min(times)))
        self.last = max(self.first + 1, math.ceil(math.log10(max(times))))

    def place(self, ms):
        return LEFT + (math.log10(ms) - self.first) / (self.last - self.first) * (RIGHT - LEFT)

    def drawn(self, bottom):
        svg = []
        for decade in range(self.first, self.last + 1):
            x, words = self.place(10.0 ** decade), time_text(10.0 ** decade)
            svg.append(line(x, TOP - 4, x, bottom))
            svg += [text(x, y, words, SOFT, 11, "middle") for y in (TOP - 14, bottom + 12)]
        return svg


def row_svg(row, axis, y):
    """Returns the elements of a row; words hide the line to the ring."""
    color = BEAMS if row["tracer"] == "beams" else HERE
    at = axis.place(row["ms"])
    svg = [text(LEFT - 10, y, row["tracer"], color if color == BEAMS else INK, 11, "end")]
    if row["printed_ms"]:
        to = axis.place(row["printed_ms"])
        svg += [line(min(at, to) + DOT, y, max(at, to) - DOT, y), ring(to, y, PRINTED),
                text(to + DOT + 5, y, time_text(row["printed_ms"]) + times_text(row["printed_times"]), SOFT)]
    words = time_text(row["ms"]) + times_text(row["times"])
    element = text(at + DOT + 5, y, words, color)
    if row["wrong"]:
        wrong = f'{row["wrong"]} {row["of"]}{"" if row["wrong"] == 1 else "s"} wrong'
        element = element.replace("</text>", f'<tspan dx="8" fill="{WRONG}">{wrong}</tspan></text>')
    return svg + [dot(at, y, color), element]


def heading(answer, is_voxels):
    what = ": time of a million intersections" if is_voxels else ": time of a frame"
    svg = [text(16, 20, answer["source"] + what, INK, 15)]
    here = "here"
    if not is_voxels:
        threads = f'{answer["threads"]} thread{"" if answer["threads"] == 1 else "s"}'
        here += f', {answer["width"]} x {answer["height"]} pixels, {threads}'
    machine = answer["machine" if is_voxels else "machine_printed"]
    x = 20
    for mark, color, words in ((dot, HERE, here), (dot, BEAMS, "beams"),
                               (ring, PRINTED, f"as printed ({machine})")):
        svg += [mark(x, 48, color), text(x + 10, 48, words)]
        x += 34 + 6 * len(words)
    return svg + [text(x, 48, "× times the paper's first method")]


def plot(answer):
    is_voxels = "millions_per_s" in answer["rows"][0]
    rows = voxel_rows(answer) if is_voxels else frame_rows(answer)
    axis = Axis([time for row in rows for time in (row["ms"], row["printed_ms"]) if time])
    body, y, case = [], TOP - GAP, None
    for row in rows:
        if row["case"] != case:
            case = row["case"]
            body.append(text(16, y + GAP + 7, case, INK, 12))
            y += GAP + TITLE
        body += row_svg(row, axis, y + ROW / 2)
        y += ROW
    height = y + 50
    return "\n".join(
        [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" '
         f'viewBox="0 0 {WIDTH} {height}" font-family="DejaVu Sans, Verdana, sans-serif">',
         "<style>text{paint-order:stroke;stroke:#fff;stroke-width:3px}</style>",
         f'<rect width="{WIDTH}" height="{height}" fill="#fff"/>']
        + axis.drawn(y + 6) + body + heading(answer, is_voxels) + ["</svg>"]) + "\n"


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: plot_compare.py COMPARE.json OUT.svg (COMPARE.json: of zeroset dev compare --json)")
    with open(sys.argv[1], encoding="utf-8") as file:
        answer = json.load(file)
    if not any(key in answer["rows"][0] for key in ("wanted_d_stop", "millions_per_s")):
        sys.exit(f'{sys.argv[1]}: {answer["table"]} has no times of frames or voxels to plot')
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        file.write(plot(answer))


if __name__ == "__main__":
    main()
