#!/usr/bin/env python3
"""Prints the results of `zeroset compare --json FILE` as Markdown tables for papers/papers.md:
a table for each file, a row for each tracer, a column for each surface and tolerance. With --means
one table of all files together, a row for each tracer: its times over those of beams on the same
surface at the same tolerance in the same file."""

import json
import math
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


def ratios_to_beams(answers):
    """Returns for each tracer and d_stop the rows, each with its time over that of beams."""
    found = {}
    for answer in answers:
        beams = {case(row): row["frame_ms"]["median"] for row in answer["rows"]
                 if row["tracer"] == "beams"}
        for row in answer["rows"]:
            if row["tracer"] != "beams" and case(row) in beams:
                ratio = row["frame_ms"]["median"] / beams[case(row)]
                key = row["tracer"], row["wanted_d_stop"]
                found.setdefault(key, []).append((ratio, row))
    return found


def means(answers):
    """Returns the lines of the table of means."""
    found = ratios_to_beams(answers)
    d_stops = sorted({d_stop for _, d_stop in found})
    heads = " | ".join(f"2^-{d_stop}: mean | least | most | pixels missed, added, refuted"
                       for d_stop in d_stops)
    lines = [f"| | {heads} |", "|---|" + "--:|--:|--:|--:|" * len(d_stops)]
    for tracer in dict.fromkeys(tracer for tracer, _ in found):
        cells = []
        for d_stop in d_stops:
            rows = found.get((tracer, d_stop), [])
            if not rows:
                cells.append(" |  |  | ")
                continue
            mean = math.exp(sum(math.log(ratio) for ratio, _ in rows) / len(rows))
            ends = [end(rows, key=lambda pair: pair[0]) for end in (min, max)]
            wrong = [sum(row[kind] for _, row in rows) for kind in ("missed", "added", "refuted")]
            cut = sum(row.get("cut", False) for _, row in rows)
            cells.append(f"{mean:.3g} | "
                         + " | ".join(f'{ratio:.3g} ({row["surface"]})' for ratio, row in ends)
                         + " | " + ", ".join(map(str, wrong)) + (f" ({cut} cut)" if cut else ""))
        lines.append(f"| `{tracer}` | " + " | ".join(cells) + " |")
    return lines


def main():
    names = [name for name in sys.argv[1:] if name != "--means"]
    if not names:
        sys.exit("usage: papers_tables.py [--means] COMPARE.json... (of zeroset compare --json)")
    answers = []
    for name in names:
        with open(name, encoding="utf-8") as file:
            answers.append(json.load(file))
    if "--means" in sys.argv:
        print("\n".join(means(answers)))
        return
    for answer in answers:
        print("\n".join(table(answer)) + "\n")


if __name__ == "__main__":
    main()
