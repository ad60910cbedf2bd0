#!/usr/bin/env python3
"""Prints the results of `zeroset dev compare --json FILE` as Markdown tables for papers/papers.md:
a table for each file, a row for each tracer, a column for each surface and tolerance; and what boxes
of the image save, beside what Florez printed of them, where tracers with boxes are in it. With --means
one table of all files together, a row for each tracer: its times over those of beams on the same
surface at the same tolerance in the same file."""

import json
import math
import sys
from pathlib import Path

PRINTED = Path(__file__).parent.parent / "papers" / "compare" / "printed_tables.json"


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


def printed_boxes(answer):
    """Returns what is printed of the boxes on each surface of the answer's table."""
    with open(PRINTED, encoding="utf-8") as file:
        tables = json.load(file)["tables"]
    return next((table.get("boxes", {}) for table in tables if table["name"] == answer["table"]), {})


def cells_of_boxes(row, classic, pixels):
    """Returns the cells of a row with boxes. Single rays are those of `classic`; at edges, in undefined
    boxes, they are taken to be nine a pixel."""
    boxes = row["boxes"]
    kinds = [boxes[kind] for kind in ("rejected", "included", "undefined")]
    rejected, included, undefined = kinds
    kept_ms = included["ms"] + undefined["ms"]
    kept = included["pixels"] + undefined["pixels"]
    rays = included["pixels"] + 9 * undefined["pixels"]
    rays_ms = boxes["ms"] + included["ms"] + 9 * undefined["ms"]
    single_ms = classic["frame_ms"]["median"]
    return ([f'{kind["boxes"]} ({100 * kind["pixels"] / pixels:.1f} %)' for kind in kinds]
            + [f'{boxes["ms"]:.2f}',
               f'{1000 * max(single_ms - kept_ms, 0) / max(rejected["pixels"], 1):.3f}',
               f"{1000 * kept_ms / max(kept, 1):.3f}", f"{rays}", f"{rays_ms:.1f}",
               f"{100 * (9 * single_ms / rays_ms - 1):.0f} %"])


def cells_as_printed(boxes, row, classic):
    """Returns the same cells as they are printed, as far as they are."""
    cells = ["-"] * 9
    if "kept" in boxes:
        pixels = boxes["rejected_pixels"] + boxes["kept_pixels"]
        for at, kind in ((0, "rejected"), (2, "kept")):
            cells[at] = f'{boxes[kind]} ({100 * boxes[kind + "_pixels"] / pixels:.1f} %)'
        cells[3] = f'{1000 * boxes["trimming_s"]:.0f}'
        for at, kind in ((4, "rejected"), (5, "kept")):
            cells[at] = f'{1e6 * boxes[kind + "_s"] / boxes[kind + "_pixels"]:.0f}'
    if "rays" in boxes and row["printed_ms"] and classic["printed_ms"]:
        cells[6:] = [f'{boxes["rays"]}', f'{row["printed_ms"]:.0f}',
                     f'{100 * (classic["printed_ms"] / row["printed_ms"] - 1):.0f} %']
    return cells


def boxes_table(answer):
    """Returns the lines of a table of boxes: their numbers, with the pixels in them; ms to find them; us a
    pixel of single rays in rejected boxes and in others; with nine rays a pixel in undefined boxes and
    one in included ones, rays, ms, and how much longer nine rays everywhere take."""
    classic = {case(row): row for row in answer["rows"] if row["tracer"] == "mrfro"}
    printed = printed_boxes(answer)
    lines = []
    for row in answer["rows"]:
        if "boxes" not in row or case(row) not in classic:
            continue
        single = classic[case(row)]
        cells = cells_of_boxes(row, single, answer["width"] * answer["height"])
        lines.append(f'| {row["surface"]}, `{row["tracer"]}` | ' + " | ".join(cells) + " |")
        if row["surface"] in printed:
            cells = cells_as_printed(printed[row["surface"]], row, single)
            lines.append("| as printed | " + " | ".join(cells) + " |")
    if not lines:
        return []
    heads = ("rejected", "included", "undefined", "ms", "us a pixel there", "elsewhere", "rays", "ms",
             "nine everywhere")
    return ["| | " + " | ".join(heads) + " |", "|---|" + "--:|" * len(heads)] + lines


def main():
    names = [name for name in sys.argv[1:] if name != "--means"]
    if not names:
        sys.exit("usage: papers_tables.py [--means] COMPARE.json... (of zeroset dev compare --json)")
    answers = []
    for name in names:
        with open(name, encoding="utf-8") as file:
            answers.append(json.load(file))
    if "--means" in sys.argv:
        print("\n".join(means(answers)))
        return
    for answer in answers:
        for lines in (table(answer), boxes_table(answer)):
            if lines:
                print("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
