"""The real window, driven by keys and mouse on an X display of its own."""

import json
import os
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from zeroset_program import environment, main, program, read_xwd, run

PATIENCE_S = 20.0  # for anything that is awaited
REST_S = 0.4       # a picture at rest does not change for so long
POLL_S = 0.05
BALL = "x^2+y^2+z^2=1"
TORUS = "(1-sqrt(x^2+y^2))^2+z^2=0.1"
SAME = 0.002       # fraction of pixels that may differ between equal pictures


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
        with os.fdopen(read_end) as answer:  # ends without a number if the server fails
            number = answer.readline().strip()
        if not number:
            self.close()
            raise RuntimeError("Xvfb did not start")
        self.state = os.path.join(self.folder.name, "state")
        self.environment = environment(DISPLAY=f":{number}", XAUTHORITY=os.devnull,
                                       XDG_STATE_HOME=self.state)

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


class WindowTest(unittest.TestCase):
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
        """The first true value of condition()."""
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            value = condition()
            if value:
                return value
            time.sleep(POLL_S)
        return self.fail(f"waited in vain for: {what}")

    # The parts of the window: the picture at the right of the panel, and in the panel the first row
    # and what stands below it.

    PANEL = 378  # width of the panel, at scale 1

    def picture(self):
        width, height = self.SCREEN
        return self.display.screenshot((self.PANEL + 10) * self.SCALE, 20 * self.SCALE, width,
                                       height - 40 * self.SCALE)

    def bar(self):
        """Below the first row's text: how it was read, or the error."""
        return self.display.screenshot(10 * self.SCALE, 74 * self.SCALE,
                                       (self.PANEL - 10) * self.SCALE, 94 * self.SCALE)

    def rest(self, condition, what):
        """The first picture that fulfils the condition and has come to rest."""
        last, since = None, time.monotonic()

        def at_rest():
            nonlocal last, since
            image = self.picture()
            if last is None or image.rgb != last.rgb:
                last, since = image, time.monotonic()
            return time.monotonic() - since >= REST_S and condition(image)

        self.wait_for(at_rest, what)
        return last

    def changed(self, old, what):
        return self.rest(lambda image: not self.same(image, old), what)

    def same(self, a, b):
        return a.rows(4).difference(b.rows(4)) <= SAME

    def point(self, across, down):
        """Moves the pointer to a place in the window, in fractions of its size."""
        width, height = self.SCREEN
        self.display.xdotool("mousemove", int(across * width), int(down * height))

    def drag(self, button, across, down):
        """From the middle of the picture until it has changed; returns it at rest. A slow frame
        may see many moves as one, so that they go on until one is seen."""
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
        """The text of the first row."""
        return self.display.screenshot(50 * self.SCALE, 46 * self.SCALE, 300 * self.SCALE,
                                       70 * self.SCALE)

    def type_equation(self, text):
        """Into the first row, instead of what is there."""
        self.display.xdotool("key", "Escape")
        self.rest(lambda _: True, "rest")
        quiet = self.field()
        self.display.xdotool("mousemove", 150 * self.SCALE, 58 * self.SCALE, "click", 1,
                             "key", "ctrl+a")
        self.wait_for(lambda: self.field().difference(quiet) > 0.02, "the text marked")
        self.display.xdotool("type", "--delay", 5, text)
        self.point(0.72, 0.55)

    def red_pixels(self):
        """Pixels of the error's colour below the field."""
        bar = self.bar()
        return sum(r > g + 50 and r > b + 50
                   for r, g, b in zip(bar.rgb[0::3], bar.rgb[1::3], bar.rgb[2::3]))

    def title(self):
        return self.display.xdotool("getwindowname", self.window).strip()

    def quit_by_key(self):
        """With D for "Don't save" where it asks."""
        self.display.xdotool("key", "ctrl+q", "d")
        self.assertEqual(self.started.wait(5.0), 0)
        self.assertEqual(self.started.stdout.read(), b"")

    def test_type_drag_zoom_reset_and_quit(self):
        ball = self.start(BALL)
        self.assertEqual(self.red_pixels(), 0)
        self.type_equation(TORUS)
        torus = self.changed(ball, "the typed surface")

        read_as = self.bar()
        self.display.xdotool("type", "+*")
        self.wait_for(lambda: self.red_pixels() > 50, "an error below the field")
        self.assertGreater(self.bar().difference(read_as), 0.002)
        kept = self.rest(lambda _: True, "rest")
        self.assertTrue(self.same(kept, torus), "the last good surface is gone")

        self.type_equation(TORUS)
        self.wait_for(lambda: self.red_pixels() == 0, "no error any more")
        self.display.xdotool("key", "Escape")
        turned = self.drag(1, 0.15, 0.1)
        moved = self.drag(3, -0.1, 0.1)
        self.assertFalse(self.same(turned, moved))
        self.point(0.72, 0.55)
        self.display.xdotool("click", "--repeat", 3, "--delay", 20, 4)
        zoomed = self.changed(moved, "a zoom")
        self.assertGreater(self.surface(zoomed), 1.2 * self.surface(moved))

        self.display.xdotool("key", "r")
        self.rest(lambda image: self.same(image, torus), "the first view again")
        self.quit_by_key()

    def surface(self, image):
        """Fraction of pixels that are no background; that is dark and the same along a row."""
        drawn = sum(image.at(col, row) != image.at(image.width - 1, row)
                    for row in range(0, image.height, 4) for col in range(0, image.width, 4))
        return drawn * 16 / (image.width * image.height)

    def test_letters_in_the_field_are_text(self):
        """R resets the view and Escape leaves the field, but only where they should."""
        self.start(TORUS)
        turned = self.drag(1, 0.2, 0.1)
        self.type_equation("y^2=x^2")
        planes = self.changed(turned, "the typed surface")
        self.display.xdotool("key", "parenright")
        self.wait_for(lambda: self.red_pixels() > 50, "an error about the ) in the field")
        self.assertTrue(self.same(self.rest(lambda _: True, "rest"), planes))
        self.display.xdotool("key", "BackSpace", "Escape", "r")
        self.changed(planes, "the view reset")
        self.wait_for(lambda: self.red_pixels() == 0, "the equation without its )")
        self.quit_by_key()

    def marked_pixels(self, image):
        """Pixels of the colour of what is undecided and not drawn."""
        return sum(r > 190 and g < 60 and 100 < b < 170
                   for r, g, b in zip(image.rgb[0::3], image.rgb[1::3], image.rgb[2::3]))

    def test_u_marks_undecided_pixels(self):
        first = self.start(f"{TORUS}; sign(x) = y")
        self.assertEqual(self.marked_pixels(first), 0)
        self.display.xdotool("key", "Escape", "u")
        self.rest(lambda image: self.marked_pixels(image) > 2000, "the jump marked")
        self.display.xdotool("key", "u")
        self.rest(lambda image: self.marked_pixels(image) == 0, "no marks any more")
        self.quit_by_key()

    def accent_pixels(self, image):
        """Pixels of the colour of markers."""
        return sum(abs(r - 0x6F) < 4 and abs(g - 0xA8) < 4 and abs(b - 0xF5) < 4
                   for r, g, b in zip(image.rgb[0::3], image.rgb[1::3], image.rgb[2::3]))

    def test_a_click_keeps_a_marker(self):
        """Undo takes it away."""
        first = self.start("x^2 + y^2 + z^2 = 3; x + y + z = 0.5")
        before = self.accent_pixels(first)
        few = 12 * self.SCALE * self.SCALE
        self.display.xdotool("key", "Escape")
        self.display.xdotool("click", 1)
        self.rest(lambda image: self.accent_pixels(image) > before + few, "a marker")
        self.display.xdotool("key", "ctrl+z")
        self.rest(lambda image: self.accent_pixels(image) < before + few, "no marker any more")
        self.quit_by_key()

    def test_a_parameter_has_a_slider(self):
        """Below the row of the statement and the place for another."""
        self.start("x^2 + y^2 + z^2 = a")
        ball = self.rest(lambda _: True, "the ball")
        left, right, down = (place * self.SCALE for place in (185, 215, 146))
        self.display.xdotool("mousemove", left, down, "mousedown", 1)
        for across in range(left, right, 2 * self.SCALE):
            self.display.xdotool("mousemove", across, down)
            time.sleep(POLL_S)
        self.display.xdotool("mouseup", 1)
        larger = self.changed(ball, "the larger ball")
        self.assertGreater(self.surface(larger), self.surface(ball))
        self.quit_by_key()

    def test_tab_leaves_the_field_and_f1_helps(self):
        first = self.start(TORUS)
        self.type_equation(BALL)
        ball = self.changed(first, "the typed surface")
        self.display.xdotool("key", "Tab")
        self.display.xdotool("type", "++")
        self.display.xdotool("key", "F1")
        self.changed(ball, "the help")
        self.assertEqual(self.red_pixels(), 0, "typed after Tab, yet in the field")
        self.display.xdotool("key", "Escape")
        self.rest(lambda image: self.same(image, ball), "no help any more")
        self.quit_by_key()

    def test_saves_and_restores_after_a_crash(self):
        ball = self.start(BALL)
        self.type_equation(TORUS)
        torus = self.changed(ball, "the typed surface")
        path = Path(self.display.folder.name) / "a.zeroset.json"
        self.display.xdotool("key", "ctrl+s")
        self.changed(torus, "the choice of a file")
        self.display.xdotool("type", "--delay", 5, str(path))
        self.display.xdotool("key", "Return")
        self.wait_for(path.exists, "the file")
        self.assertEqual(json.loads(path.read_text())["statements"][0]["text"], TORUS)
        self.wait_for(lambda: self.title() == "a - Zeroset", "the file's name in the title")

        self.type_equation(BALL)
        self.wait_for(lambda: self.title() == "* a - Zeroset", "the mark of a change")
        kept = Path(self.display.state) / "zeroset" / "autosave"
        self.wait_for(lambda: any(BALL in file.read_text() for file in kept.glob("*.json")),
                      "the document kept")
        self.started.kill()
        self.end()
        self.start(str(path))
        self.display.xdotool("key", "Return")
        self.rest(lambda image: self.same(image, ball), "the lost document")
        self.quit_by_key()

    def after_key(self, key, image):
        """Whether the picture at rest is like this one after the key."""
        self.display.xdotool("key", key)
        return self.same(self.rest(lambda _: True, "rest"), image)

    def test_undo_brings_back_text_and_view(self):
        ball = self.start(BALL)
        self.type_equation(TORUS)
        torus = self.changed(ball, "the typed surface")
        self.display.xdotool("key", "Escape")
        self.drag(1, 0.15, 0.1)
        self.display.xdotool("key", "ctrl+z")
        self.rest(lambda image: self.same(image, torus), "the view before the drag")
        # A rest while typing makes two steps of it.
        self.wait_for(lambda: self.after_key("ctrl+z", ball), "the text before")
        self.wait_for(lambda: self.after_key("ctrl+shift+z", torus), "the text again")
        self.quit_by_key()

    def cpu_s(self):
        fields = Path(f"/proc/{self.started.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def test_sleeps_when_nothing_changes(self):
        self.start(BALL)
        self.display.xdotool("key", "Escape")
        self.rest(lambda _: True, "rest")
        before, since = self.cpu_s(), time.monotonic()
        time.sleep(1.0)
        self.assertLess(self.cpu_s() - before, 0.2 * (time.monotonic() - since))
        self.started.send_signal(signal.SIGTERM)
        self.started.wait(5.0)

    def test_starts_with_a_surface_of_the_gallery(self):
        self.start("@torus")
        self.quit_by_key()


class LargeScaleWindowTest(WindowTest):
    """The same at twice the size, for screens of high resolution."""

    SCALE = 2
    SCREEN = (1600, 1200)


class NoDisplayTest(unittest.TestCase):
    def check_one_line(self, result):
        self.assertEqual(result.code, 1, str(result))
        self.assertEqual(result.out, "")
        self.assertRegex(result.err, r"\A[^\n]*zeroset render[^\n]*\n\Z")

    def test_says_what_to_do_instead(self):
        self.check_one_line(run())
        self.check_one_line(run("@torus"))

    def test_no_such_display(self):
        self.check_one_line(run(env=environment(DISPLAY=":9999")))


if __name__ == "__main__":
    missing = [tool for tool in ("Xvfb", "xdotool") if shutil.which(tool) is None]
    if missing:
        raise SystemExit("needed and not installed: " + ", ".join(missing))
    main()
