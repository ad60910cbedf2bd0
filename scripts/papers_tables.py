#!/usr/bin/env python3
"""Prints the results of `zeroset compare --json FILE` as Markdown tables for resources/docs/papers.md:
a table for each file, a row for each tracer, a column for each surface and tolerance."""

import json
import sys


def cell(row):
    """Returns the time, and in brackets the time over the paper's first tracer, here / printed."""
    text = f'{row["frame_ms"]["median"]:.3g}'
    if row["times"] is None or row["tracer"] == "beams":
        return text
    printed = "" if row["printed_times"] is None else f' / {row["printed_times"]:.2g}'
    return f'{text} ({row["times"]:.2g}{printed})'


def case(row):
    """Returns what a column of the table is of."""
    return row["surface"], row["wanted_d_stop"], row["reflections"]


def table(answer):
    """Returns the lines of a table."""
    rows = answer["rows"]
    columns = list(dict.fromkeys(case(row) for row in rows))
    tracers = list(dict.fromkeys(row["tracer"] for row in rows))
    several = len({d_stop for _, d_stop, _ in columns}) > 1
    heads = [name + (f" 2^-{d_stop}" if several else "") + (", mirrors" if mirrors else "")
             for name, d_stop, mirrors in columns]
    by_key = {(row["tracer"], *case(row)): row for row in rows}
    lines = ["| | " + " | ".join(heads) + " |", "|---|" + "--:|" * len(heads)]
    for tracer in tracers:
        cells = [cell(by_key[(tracer, *column)]) for column in columns]
        lines.append(f"| `{tracer}` | " + " | ".join(cells) + " |")
    return lines


def main():
    if len(sys.argv) < 2:
        sys.exit("usage: papers_tables.py COMPARE.json... (of zeroset compare --json)")
    for name in sys.argv[1:]:
        with open(name, encoding="utf-8") as file:
            print("\n".join(table(json.load(file))) + "\n")


if __name__ == "__main__":
    main()
