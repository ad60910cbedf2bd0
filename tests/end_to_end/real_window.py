"""Common parts of the tests that drive the real window on an X display of its own."""

import os
import shutil
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from zeroset_program import environment, program, read_xwd

PATIENCE_S = 20.0  # longest wait for any condition
POLL_S = 0.03
REST_S = 0.15      # a window that sleeps so long is at rest; refining starts after 0.12 s
SAME = 0.002       # fraction of pixels that may differ between equal pictures


def check_tools():
    """Ends the script if a tool that drives the window is not installed."""
    missing = [tool for tool in ("Xvfb", "xdotool", "xclip") if shutil.which(tool) is None]
    if missing:
        raise SystemExit("needed and not installed: " + ", ".join(missing))


def switches_of(*processes):
    """Returns how often all threads of the processes went to sleep; None while one is awake."""
    total = 0
    for process in processes:
        for thread in Path(f"/proc/{process}/task").iterdir():
            try:
                status = (thread / "status").read_text()
            except OSError:  # the thread has just ended
                return None
            fields = dict(line.split(":\t", 1) for line in status.splitlines() if ":\t" in line)
            if not fields["State"].startswith("S"):
                return None
            total += int(fields["voluntary_ctxt_switches"])
    return total


class Display:
    """An Xvfb on a free display number whose screen is a file that can be read."""

    def __init__(self, width, height):
        self.folder = tempfile.TemporaryDirectory(prefix="zeroset_display_")
        read_end, write_end = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", f"{width}x{height}x24",
             "-fbdir", self.folder.name, "-nolisten", "tcp", "-noreset"],
            pass_fds=[write_end], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as answer:  # empty if the server fails
            number = answer.readline().strip()
        if not number:
            self.close()
            raise RuntimeError("Xvfb did not start")
        self.state = os.path.join(self.folder.name, "state")
        self.config = os.path.join(self.folder.name, "config")
        # Only surfaces in the pictures, unless a test asks for what new documents begin with.
        settings = Path(self.config) / "zeroset" / "window.json"
        settings.parent.mkdir(parents=True)
        settings.write_text('{"axes": false, "clip_box": false, "grid": false}')
        self.environment = environment(DISPLAY=f":{number}", XAUTHORITY=os.devnull,
                                       XDG_STATE_HOME=self.state,
                                       XDG_CONFIG_HOME=self.config,
                                       XDG_CACHE_HOME=os.path.join(self.folder.name, "cache"),
                                       DBUS_SESSION_BUS_ADDRESS="unix:path=" + os.devnull)

    def screenshot(self, *crop):
        return read_xwd((Path(self.folder.name) / "Xvfb_screen0").read_bytes(), crop)

    def xdotool(self, *words):
        done = subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=True,
                              capture_output=True, timeout=PATIENCE_S)
        return done.stdout.decode()

    def close(self):
        self.server.terminate()
        self.server.wait(PATIENCE_S)
        self.folder.cleanup()


class RealWindowTest(unittest.TestCase):
    """Base of tests with a display, `self.display`, on which start() opens the window."""

    SCALE = 1
    SCREEN = (800, 600)

    def setUp(self):
        self.display = Display(*self.SCREEN)
        self.addCleanup(self.display.close)
        self.started = None

    def start(self, *arguments):
        """Starts the program and waits for its window and its first picture."""
        variables = dict(self.display.environment, ZEROSET_SCALE=str(self.SCALE))
        self.started = subprocess.Popen([program(), *arguments], env=variables,
                                        cwd=self.display.folder.name,
                                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.addCleanup(self.end)
        self.window = self.wait_for(self.find_window, "window")
        self.display.xdotool("windowfocus", "--sync", self.window)
        self.point(0.72, 0.55)
        return self.rest(lambda image: len(image.rows(8).colors()) > 100, "first picture")

    def end(self):
        if self.started.poll() is None:
            self.started.kill()
        self.started.wait(PATIENCE_S)
        self.started.stdout.close()

    def find_window(self):
        self.assertIsNone(self.started.poll(), "the program has ended")
        try:
            return self.display.xdotool("search", "--onlyvisible", "--name", "Zeroset").split()[-1]
        except (subprocess.CalledProcessError, IndexError):
            return None

    def wait_for(self, condition, what):
        """Waits for the first true value of condition() and returns it."""
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            value = condition()
            if value:
                return value
            time.sleep(POLL_S)
        return self.fail(f"waited in vain for: {what}")

    # Screenshots of parts of the window: the picture at the right of the panel, and in the panel
    # the first row and the line below it.

    PANEL = 378  # width of the panel, at scale 1

    def picture(self):
        width, height = self.SCREEN
        return self.display.screenshot((self.PANEL + 10) * self.SCALE, 20 * self.SCALE, width,
                                       height - 40 * self.SCALE)

    def bar(self):
        """Returns a screenshot of the line below the first row: its reading or its error."""
        return self.display.screenshot(10 * self.SCALE, 74 * self.SCALE,
                                       (self.PANEL - 10) * self.SCALE, 94 * self.SCALE)

    def sleeps_on(self):
        """Returns True if no thread of the window and of its display runs or waits for a processor
        during REST_S: then nothing is left to be drawn, however slow the machine is."""
        processes = self.started.pid, self.display.server.pid
        before, end = switches_of(*processes), time.monotonic() + REST_S
        while before is not None and switches_of(*processes) == before:
            if time.monotonic() >= end:
                return True
            time.sleep(REST_S / 4)
        return False

    def rest(self, condition, what):
        """Waits for the first picture at rest that fulfils the condition and returns it."""
        image = None

        def at_rest():
            nonlocal image
            if not self.sleeps_on():
                return False
            image = self.picture()
            return condition(image)

        self.wait_for(at_rest, what)
        return image

    def changed(self, old, what):
        return self.rest(lambda image: not self.same(image, old), what)

    def same(self, a, b):
        return a.rows(4).difference(b.rows(4)) <= SAME

    def surface(self, image):
        """Returns the fraction of pixels unlike the background, which is constant along a row."""
        drawn = sum(image.at(col, row) != image.at(image.width - 1, row)
                    for row in range(0, image.height, 4) for col in range(0, image.width, 4))
        return drawn * 16 / (image.width * image.height)

    def point(self, across, down):
        """Moves the pointer to a place in the window, in fractions of its size."""
        width, height = self.SCREEN
        self.display.xdotool("mousemove", int(across * width), int(down * height))

    def drag(self, button, across, down):
        """Drags from the middle of the picture until it changes; returns the picture at rest. A
        slow frame may see many moves as one, so the moves continue until a change is seen."""
        self.point(0.72, 0.55)
        before = self.rest(lambda _: True, "rest")
        self.display.xdotool("mousedown", button)
        part = 0.0

        def move_and_look():
            nonlocal part
            part = min(part + 0.05, 1.0)
            self.point(0.72 + part * across, 0.55 + part * down)
            return not self.same(self.picture(), before)

        self.wait_for(move_and_look, f"a drag with button {button}")
        self.rest(lambda _: True, "rest")
        self.display.xdotool("mouseup", button)
        return self.changed(before, f"a drag with button {button}")

    def field(self):
        """Returns a screenshot of the first row's text."""
        return self.display.screenshot(50 * self.SCALE, 46 * self.SCALE, 300 * self.SCALE,
                                       70 * self.SCALE)

    def type_equation(self, text):
        """Types a text into the first row in place of its text."""
        self.display.xdotool("key", "Escape")
        self.display.xdotool("mousemove", 150 * self.SCALE, 58 * self.SCALE, "click", 1)
        # The click must be over: in the same frame it would undo the selection.
        self.rest(lambda _: True, "rest")
        unmarked = self.field()
        self.display.xdotool("key", "ctrl+a")
        self.wait_for(lambda: self.field().difference(unmarked) > 0.02, "the text marked")
        self.display.xdotool("type", "--delay", 5, text)
        self.point(0.72, 0.55)

    def red_pixels(self):
        """Returns the number of pixels in the error's colour below the field."""
        bar = self.bar()
        return sum(r > g + 50 and r > b + 50
                   for r, g, b in zip(bar.rgb[0::3], bar.rgb[1::3], bar.rgb[2::3]))

    def title(self):
        return self.display.xdotool("getwindowname", self.window).strip()

    def quit_by_key(self):
        """Quits by Ctrl+Q; D answers "Don't save" if there is a question."""
        self.display.xdotool("key", "ctrl+q", "d")
        self.assertEqual(self.started.wait(5.0), 0)
        with self.started.stdout as output:
            self.assertEqual(output.read(), b"")
