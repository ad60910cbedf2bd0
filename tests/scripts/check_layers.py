#!/usr/bin/env python3
"""Fails on an #include that rooms.txt, the table of arrows between rooms, does not allow.

A room may include itself and the rooms that its row lists; a folder that is not a room stands for
all rooms inside it. The arrows must not form a cycle.

LLVM is for jit/ alone, window libraries (ImGui, GLFW, OpenGL, EGL) for ui/ alone and there not for
ui/model; tests may use both. Other rooms may include only the public header of jit/, which must not
lead to LLVM.

Usage: check_layers.py ROOT. Prints file:line: reason for each violation, then exits 1.
"""

import re
import sys
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

PUBLIC_JIT_HEADER = "jit/compile.hpp"
LIBRARIES = {
    # name: (headers, rooms that may include them)
    "LLVM": (re.compile(r"(llvm|llvm-c|clang|clang-c)/"), {"jit", "tests"}),
    "window": (
        re.compile(r"(imgui\w*\.h$|imgui/|backends/imgui|implot|GLFW/|GL/|GLES\d?/|EGL/|KHR/|X11/)"),
        {"ui", "tests"},
    ),
}
# Rooms of plain values, which must not use the libraries that the folder around them may use.
WITHOUT_LIBRARIES = {"ui/model"}
SUFFIXES = {".c", ".cc", ".cpp", ".def", ".h", ".hpp", ".inc", ".inl", ".ipp"}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')


def rooms_of(root):
    """Returns {room: rooms and folders that its row of ROOT/rooms.txt lists}."""
    lines = (root / "rooms.txt").read_text(encoding="utf-8").splitlines()
    rows = [line.split("|") for line in lines if line.strip() and not line.startswith("#")]
    return {row[0].strip(): row[1].split() for row in rows}


def room_of(rooms, path):
    """Returns the innermost room that contains a path, or None."""
    folder = path.rpartition("/")[0]
    while folder and folder not in rooms:
        folder = folder.rpartition("/")[0]
    return folder or None


def seen_from(rooms, room):
    """Returns the rooms that a room may include; an arrow to a folder means all rooms in it."""
    return [
        other for arrow in rooms[room] for other in rooms
        if other == arrow or (arrow not in rooms and other.startswith(arrow + "/"))
    ]


def circle(rooms):
    """Returns a cycle of arrows as a text, or None."""
    try:
        TopologicalSorter({room: seen_from(rooms, room) for room in rooms}).prepare()
    except CycleError as error:
        return " -> ".join(reversed(error.args[1]))
    return None


def includes_of(path):
    """Returns (line number, header) of each include directive in a file."""
    lines = path.read_text(encoding="utf-8").splitlines()
    matches = ((number, INCLUDE.match(line)) for number, line in enumerate(lines, 1))
    return [(number, match.group(1)) for number, match in matches if match]


def resolved(root, source, header):
    """Returns the header's path from the root; as written if it is not a file of the project."""
    for base in (source.parent, root):
        candidate = (base / header).resolve()
        if candidate.is_file() and candidate.is_relative_to(root):
            return candidate.relative_to(root).as_posix()
    return header


def library_of(header):
    return next((name for name, (pattern, _) in LIBRARIES.items() if pattern.match(header)), None)


def leads_to_llvm(graph, header, seen=None):
    """Returns True if a header is one of LLVM's or includes one through headers of the project."""
    seen = set() if seen is None else seen
    if header in seen:
        return False
    seen.add(header)
    return library_of(header) == "LLVM" or any(
        leads_to_llvm(graph, target, seen) for _, target in graph.get(header, [])
    )


def objection(rooms, graph, source, header):
    """Returns the reason why `source` may not include `header`, or None."""
    room, target = room_of(rooms, source), room_of(rooms, header)
    if room is None:
        return "this file lies in no room of rooms.txt"
    part = room.split("/")[0]
    library = library_of(header)
    if library and (part not in LIBRARIES[library][1] or room in WITHOUT_LIBRARIES):
        return f"{room}/ may not include {library} headers"
    if source == PUBLIC_JIT_HEADER and leads_to_llvm(graph, header):
        return "the public header of jit/ must not lead to LLVM"
    if target and target != room and target not in seen_from(rooms, room):
        return f"{room}/ may not include {target}/"
    if target == "jit" and part not in {"jit", "tests"} and header != PUBLIC_JIT_HEADER:
        return f"{room}/ may include of jit/ only {PUBLIC_JIT_HEADER}"
    return None


def include_graph(root, rooms):
    """Returns {source file of the rooms: its includes with their line numbers}."""
    files = [
        path for part in dict.fromkeys(room.split("/")[0] for room in rooms)
        for path in sorted((root / part).rglob("*"))
        if path.suffix in SUFFIXES and path.is_file()
    ]
    return {
        path.relative_to(root).as_posix(): [
            (number, resolved(root, path, header)) for number, header in includes_of(path)
        ]
        for path in files
    }


def violations(root):
    rooms = rooms_of(root)
    graph = include_graph(root, rooms)
    if not graph:
        return [f"{root}: no source files here"]
    found = circle(rooms)
    return ([f"rooms.txt: a circle: {found}"] if found else []) + [
        f"{source}:{number}: {reason}: {header}"
        for source, includes in graph.items()
        for number, header in includes
        if (reason := objection(rooms, graph, source, header))
    ]


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: check_layers.py ROOT")
    found = violations(Path(sys.argv[1]).resolve())
    print("\n".join(found) if found else "the arrows hold")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
