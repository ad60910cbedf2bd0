#!/usr/bin/env python3
"""Random input to the real window: monkey.py PROGRAM [--seconds 600] [--seed N]

Sends keys, clicks, drags, the wheel, other window sizes, typed formulas and plain noise, on an X
display of its own. Exits with 1 and prints seed and step when the program ends, writes a
sanitizer's report, takes more than --patience seconds to answer, or its memory keeps growing. With
a program built with AddressSanitizer, leaks at the end are found, too, except those of a window
that is closed at once: OpenGL drivers leave some, and cannot be named once they are unloaded.
"""

import argparse
import os
import random
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from real_window import Display, check_tools  # noqa: E402

SIZE = (900, 640)
KEYS = ["Return", "Escape", "Tab", "Up", "Down", "Left", "Right", "Home", "End", "Prior", "Next",
        "BackSpace", "Delete", "F1", "space", "r", "u", "f", "g", "t", "a", "b", "m", "shift+m", "plus",
        "minus", "ctrl+1", "ctrl+3", "ctrl+7",
        *"0123456789", "ctrl+z", "ctrl+shift+z", "ctrl+y", "ctrl+g", "ctrl+k", "ctrl+b", "ctrl+d",
        "ctrl+c", "ctrl+v", "ctrl+a", "ctrl+n", "ctrl+o", "ctrl+s", "alt+Up", "alt+Down",
        "shift+Return", "shift+Tab"]
PIECES = ["x", "y", "z", "w", "a", "b", "2", "0.5", "1e-9", "1e30", "+", "-", "*", "/", "^", "(",
          ")", "=", "<", ";", ",", "sin ", "sqrt(", "exp(", "log(", "abs(", "max(", "x^2+y^2",
          "+z^2=1", "|x|", "f(u)=", "f(", "mod(", "atan2(", "|", "²", "√", "é"]
GROWTH_KB = 400_000  # allowed growth of memory after the first third of the time


class Monkey:
    def __init__(self, options, display):
        self.options = options
        self.display = display
        self.random = random.Random(options.seed)
        self.step = 0
        self.restarts = 0
        self.peak_kb = 0
        self.log = Path(display.folder.name) / "report"
        self.drivers_leak = None
        self.open()
        self.close()
        self.drivers_leak = self.leak()
        self.check_end()
        self.open()

    def open(self):
        with open(self.log, "wb") as log:
            self.process = subprocess.Popen(
                [os.path.abspath(self.options.program), "@torus"], stdout=log,
                stderr=subprocess.STDOUT, cwd=self.display.folder.name,
                env=dict(self.display.environment, ZEROSET_SCALE="1",
                         ASAN_OPTIONS="detect_leaks=1"))
        end = time.monotonic() + self.options.patience
        while time.monotonic() < end and not self.find_window():
            time.sleep(0.1)
        self.display.xdotool("windowfocus", self.window)

    def find_window(self):
        done = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Zeroset"],
                              env=self.display.environment, capture_output=True, check=False)
        self.window = done.stdout.decode().split()[-1] if done.stdout else None
        return self.window

    def fail(self, what):
        report = self.log.read_text(errors="replace")[-4000:]
        sys.exit(f"{what}; seed {self.options.seed}, step {self.step}\n{report}")

    def leak(self):
        """Returns LeakSanitizer's summary line, which counts bytes and allocations, or None."""
        report = self.log.read_text(errors="replace")
        if "ERROR: LeakSanitizer" not in report:
            return None
        return next(line for line in report.splitlines() if line.startswith("SUMMARY:"))

    def check_end(self):
        if self.process.returncode == 0 and not self.log.read_text(errors="replace").strip():
            return
        if self.leak() is None or self.leak() != self.drivers_leak:
            self.fail(f"ended with exit code {self.process.returncode}")

    def place(self):
        return self.random.randrange(SIZE[0]), self.random.randrange(SIZE[1])

    def keys(self):
        return ["key", "--delay", 10,
                *(self.random.choice(KEYS) for _ in range(self.random.randint(1, 4)))]

    def formula(self):
        text = "".join(self.random.choice(PIECES) for _ in range(self.random.randint(1, 8)))
        return ["type", "--delay", 5, text]

    def click(self):
        return ["mousemove", *self.place(), "click", "--repeat", self.random.randint(1, 2),
                self.random.choice([1, 1, 1, 2, 3])]

    def click_in_panel(self):
        return ["mousemove", self.random.randrange(378), self.random.randrange(SIZE[1]),
                "click", self.random.choice([1, 1, 3])]

    def drag(self):
        button = self.random.choice([1, 1, 3])
        words = ["mousemove", *self.place(), "mousedown", button]
        for _ in range(self.random.randint(1, 8)):
            words += ["mousemove", *self.place(), "sleep", 0.01]
        return words + ["mouseup", button]

    def wheel(self):
        return ["mousemove", *self.place(), "click", "--repeat", self.random.randint(1, 12),
                "--delay", 5, self.random.choice([4, 5])]

    def resize(self):
        return ["windowsize", self.window, self.random.randint(300, SIZE[0]),
                self.random.randint(200, SIZE[1])]

    def palette(self):
        return ["key", "Escape", "ctrl+k", "type", "--delay", 5,
                self.random.choice(["gal", "und", "theme", "tor", "sarti", "sec", "help", "gyr"]),
                "key", "Return"]

    def act(self):
        act = self.random.choice([self.keys, self.keys, self.formula, self.formula, self.click,
                                  self.click_in_panel, self.drag, self.wheel, self.resize,
                                  self.palette])
        try:
            for words in split(act()):
                self.display.xdotool(*words)
        except subprocess.CalledProcessError:
            time.sleep(0.5)  # the window may have closed during the search
        self.step += 1

    def check_alive(self):
        """Starts the program again if it was closed regularly."""
        if self.process.poll() is None:
            return
        self.check_end()
        self.restarts += 1
        self.open()

    def check_answer(self):
        """Expects that opening and closing the help changes the window's pixels."""
        self.display.xdotool("key", "Escape", "key", "Escape", "key", "Escape")
        end = time.monotonic() + self.options.patience
        before = self.display.screenshot().rgb
        self.display.xdotool("key", "F1")
        while self.display.screenshot().rgb == before:
            if self.process.poll() is not None:
                return
            if time.monotonic() > end:
                self.fail("no answer")
            time.sleep(0.05)
        self.display.xdotool("key", "F1")

    def memory_kb(self):
        try:
            status = Path(f"/proc/{self.process.pid}/status").read_text()
            return next(int(line.split()[1]) for line in status.splitlines()
                        if line.startswith("VmRSS"))
        except (OSError, StopIteration):
            return 0

    def run(self):
        begin = time.monotonic()
        settled_kb = 0
        while time.monotonic() - begin < self.options.seconds:
            self.act()
            self.check_alive()
            if self.step % 20 == 0:
                self.check_answer()
            kb = self.memory_kb()
            self.peak_kb = max(self.peak_kb, kb)
            if time.monotonic() - begin < self.options.seconds / 3:
                settled_kb = max(settled_kb, kb)
            elif kb > settled_kb + GROWTH_KB:
                self.fail(f"memory has grown from {settled_kb} to {kb} kB")
        self.close()
        self.check_end()
        print(f"seed {self.options.seed}: {self.step} steps, {self.restarts} restarts, memory "
              f"{settled_kb // 1000} MB after a third, at most {self.peak_kb // 1000} MB")

    def close(self):
        """Closes the window by its keys; D answers the question about unsaved work."""
        end = time.monotonic() + self.options.patience
        while self.process.poll() is None:
            self.display.xdotool("key", "--delay", 50, "Escape", "Escape", "ctrl+q", "d")
            time.sleep(0.5)
            if time.monotonic() > end:
                self.fail("cannot be closed")


def split(words):
    """Splits xdotool's arguments into single commands: none may follow a text to type."""
    if words[0] == "key" and "type" in words:
        at = words.index("type")
        return [words[:at], words[at:-2], words[-2:]]
    return [words]


def run():
    parser = argparse.ArgumentParser(description="random input, see the script's head")
    parser.add_argument("program")
    parser.add_argument("--seconds", type=float, default=600.0)
    parser.add_argument("--seed", type=int, default=random.randrange(10**6))
    parser.add_argument("--patience", type=float, default=30.0)
    options = parser.parse_args()
    check_tools()
    print(f"seed {options.seed}", flush=True)
    display = Display(*SIZE)
    try:
        monkey = Monkey(options, display)
        try:
            monkey.run()
        finally:
            monkey.process.kill()
    finally:
        display.close()


if __name__ == "__main__":
    run()
