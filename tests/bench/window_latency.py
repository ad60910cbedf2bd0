#!/usr/bin/env python3
"""How long the real window takes from input to changed pixels: window_latency.py PROGRAM [NAME...]

Drives surfaces of the gallery (without names: those from the papers), or equations with an =, on an X
display of its own, at 1280x800: drags the picture round, then types into the first row. Prints a table:
  move       median and 95th percentile of the latency while dragging, ms
  fps        pictures a second while dragging
  width      of these, in pixels (median); at rest it is 902
  key        median and largest latency of a key that changes the formula, compilation included, ms
  idle       processor time at rest, percent of one core over 10 s (or --idle SECONDS; 0: none)
What a latency is says app/desktop/latency_log.hpp: OpenGL's time is left out, as it is software's here.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "end_to_end"))
from real_window import Display, check_tools  # noqa: E402

SIZE = (1280, 800)
PANEL = 378
MOVES = 120
MOVE_S = 0.016
TYPED = "+0.1*x^3"
KEY_S = 0.5
GIVE_UP_S = 60.0


def suite(program):
    listed = subprocess.run([program, "gallery", "--json"], capture_output=True, check=True)
    return [item["name"] for item in json.loads(listed.stdout)
            if item["group"] == "From the papers"]


class Run:
    """A window with one surface, and its log."""

    def __init__(self, display, program, name):
        self.display = display
        is_equation = "=" in name
        stem = "equation" if is_equation else name
        self.path = Path(display.folder.name) / f"{stem}.jsonl"
        self.process = subprocess.Popen(
            [program, "dev", "latency", name if is_equation else "@" + name, "-o", str(self.path)],
            env=dict(display.environment, ZEROSET_SCALE="1",
                     XDG_STATE_HOME=os.path.join(display.folder.name, stem)))
        self.rest()

    def lines(self):
        text = self.path.read_text() if self.path.exists() else ""
        return [json.loads(line) for line in text.splitlines() if line.endswith("}")]

    def rest(self):
        """Until the log has a complete picture and no line more for half a second."""
        end = time.monotonic() + GIVE_UP_S
        seen, since = None, time.monotonic()
        while time.monotonic() < end:
            lines = self.lines()
            if len(lines) != seen:
                seen, since = len(lines), time.monotonic()
            if lines and lines[-1]["complete"] and time.monotonic() - since > 0.5:
                return
            time.sleep(0.05)
        raise SystemExit(f"{self.path.stem}: no picture at rest")

    def drag(self):
        """The lines of one turn of the picture."""
        before = len(self.lines())
        left, middle = PANEL + 250, SIZE[1] // 2
        self.display.xdotool("mousemove", left, middle, "mousedown", 1)
        words = []
        for i in range(MOVES):
            words += ["mousemove", left + 4 * i, middle + i % 7, "sleep", MOVE_S]
        self.display.xdotool(*words)
        moving = self.lines()[before:]
        self.display.xdotool("mouseup", 1)
        self.rest()
        return moving

    def type(self):
        """The lines of some keys, one after the other."""
        self.display.xdotool("mousemove", 150, 58, "click", 1, "key", "End")
        self.rest()
        before = len(self.lines())
        for key in TYPED:
            self.display.xdotool("type", key)
            time.sleep(KEY_S)
            self.rest()
        return self.lines()[before:]

    def idle_percent(self, seconds):
        self.display.xdotool("key", "Escape")
        self.rest()
        before = self.cpu_s()
        time.sleep(seconds)
        return 100.0 * (self.cpu_s() - before) / seconds

    def cpu_s(self):
        fields = Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def close(self):
        self.process.kill()
        self.process.wait()


def latencies(lines, event):
    return sorted(line["latency_ms"] for line in lines if line.get("event") == event)


def frames_per_second(lines):
    if len(lines) < 2:
        return float("nan")
    return (len(lines) - 1) / (lines[-1]["t_s"] - lines[0]["t_s"])


def measure(display, program, name, idle_s):
    run = Run(display, program, name)
    try:
        moving = run.drag()
        move = latencies(moving, "move") or [float("nan")]
        key = latencies(run.type(), "key") or [float("nan")]
        idle = f"{run.idle_percent(idle_s):6.2f}" if idle_s else "     -"
    finally:
        run.close()
    late = move[min(int(0.95 * len(move)), len(move) - 1)]
    width = statistics.median(line["width"] for line in moving) if moving else 0
    print(f"{name:20} {statistics.median(move):7.1f} {late:7.1f} {frames_per_second(moving):6.1f} {width:5.0f} "
          f"{statistics.median(key):7.1f} {key[-1]:7.1f} {idle}", flush=True)
    return statistics.median(move), statistics.median(key)


def run():
    parser = argparse.ArgumentParser(description="latency of the window, see the script's head")
    parser.add_argument("program")
    parser.add_argument("names", nargs="*")
    parser.add_argument("--idle", type=float, default=10.0)
    options = parser.parse_args()
    check_tools()
    program = os.path.abspath(options.program)
    print("surface              move 50%    95%    fps width key 50%     max   idle")
    display = Display(*SIZE)
    try:
        found = [measure(display, program, name, options.idle)
                 for name in options.names or suite(program)]
    finally:
        display.close()
    print(f"median: move {statistics.median(move for move, _ in found):.1f} ms, "
          f"key {statistics.median(key for _, key in found):.1f} ms")


if __name__ == "__main__":
    run()
