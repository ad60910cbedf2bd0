#!/usr/bin/env python3
"""Plots the results of `zeroset dev bench --json FILE` as an SVG: time per frame and evaluations per
ray of each surface, for each tracer.

    build/release/zeroset dev bench --tracer beams,k-bisection --json bench.json
    scripts/plot_bench.py bench.json resources/docs/bench.svg
"""

import json
import math
import sys
from html import escape

COLORS = ("#2b7bba", "#d9822b", "#5a9e4b", "#a05bb5")
ROW, BAR, LEFT, PANEL, GAP, TOP = 20, 7, 150, 360, 60, 70


def log_axis(values):
    """Returns the decades that contain the positive values: (lowest exponent, highest exponent)."""
    positive = [value for value in values if value > 0]
    return math.floor(math.log10(min(positive))), math.ceil(math.log10(max(positive)))


def panel(rows, tracers, measure, left, title):
    """Returns the SVG elements of one panel: bars of one measure on a logarithmic scale."""
    values = {(row["name"], tracer): measure(row[tracer]) for row in rows for tracer in tracers}
    low, high = log_axis(values.values())

    def place(value):
        share = (math.log10(max(value, 10.0 ** low)) - low) / (high - low)
        return left + PANEL * share

    bottom = TOP + ROW * len(rows)
    svg = [f'<text x="{left}" y="{TOP - 26}" class="title">{escape(title)}</text>']
    for exponent in range(low, high + 1):
        x = place(10.0 ** exponent)
        svg.append(f'<line x1="{x:.1f}" y1="{TOP - 4}" x2="{x:.1f}" y2="{bottom}" class="grid"/>')
        svg.append(f'<text x="{x:.1f}" y="{TOP - 8}" class="tick">{10.0 ** exponent:g}</text>')
    for number, row in enumerate(rows):
        for k, tracer in enumerate(tracers):
            value = values[row["name"], tracer]
            y = TOP + ROW * number + 3 + BAR * k
            svg.append(f'<rect x="{left}" y="{y}" width="{place(value) - left:.1f}" '
                       f'height="{BAR - 1}" fill="{COLORS[k % len(COLORS)]}">'
                       f'<title>{escape(row["name"])}, {escape(tracer)}: {value:.3g}</title></rect>')
    return svg


def plot(bench):
    rows = bench["surfaces"]
    tracers = list(bench["geometric_mean_ms"])
    width = LEFT + 2 * PANEL + GAP + 30
    height = TOP + ROW * len(rows) + 20
    size = f'{bench["width"]}x{bench["height"]}, {bench["threads"]} thread(s)'
    svg = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
           f'viewBox="0 0 {width} {height}">',
           '<style>text{font:12px sans-serif;fill:#222}.title{font-weight:bold}'
           '.tick{text-anchor:middle;font-size:10px;fill:#666}.name{text-anchor:end}'
           '.grid{stroke:#ddd}</style>',
           f'<rect width="{width}" height="{height}" fill="#fff"/>']
    for k, tracer in enumerate(tracers):
        x = LEFT + 260 * k
        mean = bench["geometric_mean_ms"][tracer]
        svg.append(f'<rect x="{x}" y="12" width="10" height="10" fill="{COLORS[k % len(COLORS)]}"/>')
        svg.append(f'<text x="{x + 16}" y="21">{escape(tracer)}, geometric mean {mean:.2f} ms</text>')
    svg += panel(rows, tracers, lambda cell: cell["frame_ms"]["median"], LEFT, f"ms a frame, {size}")
    svg += panel(rows, tracers,
                 lambda cell: (cell["range_per_ray"] + cell["form_per_ray"]
                               + cell["value_per_ray"]),
                 LEFT + PANEL + GAP, "evaluations of f a ray")
    for number, row in enumerate(rows):
        y = TOP + ROW * number + 14
        svg.append(f'<text x="{LEFT - 8}" y="{y}" class="name">{escape(row["name"])}</text>')
    return "\n".join(svg + ["</svg>"]) + "\n"


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: plot_bench.py BENCH.json OUT.svg (BENCH.json: of zeroset dev bench --json)")
    with open(sys.argv[1], encoding="utf-8") as file:
        text = plot(json.load(file))
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main()
