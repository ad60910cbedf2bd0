"""Tests of the real window, driven by keys and mouse on an X display of its own."""

import json
import os
import re
import signal
import subprocess
import time
import unittest
from pathlib import Path

from real_window import POLL_S, RealWindowTest, check_tools
from zeroset_program import environment, main, read_png, run

BALL = "x^2+y^2+z^2=1"
TORUS = "(1-sqrt(x^2+y^2))^2+z^2=0.1"


class WindowTest(RealWindowTest):
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

    def test_letters_in_the_field_are_text(self):
        """R resets the view only outside the field; Escape leaves the field."""
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
        """Returns the number of pixels in the colour of undecided pixels without a surface."""
        return sum(r > 190 and g < 60 and 100 < b < 170
                   for r, g, b in zip(image.rgb[0::3], image.rgb[1::3], image.rgb[2::3]))

    def test_u_marks_undecided_pixels(self):
        first = self.start(f"{TORUS}; 1/(1/x) = 0")
        self.assertEqual(self.marked_pixels(first), 0)
        self.display.xdotool("key", "Escape", "u")
        self.rest(lambda image: self.marked_pixels(image) > 2000, "the hole marked")
        self.display.xdotool("key", "u")
        self.rest(lambda image: self.marked_pixels(image) == 0, "no marks any more")
        self.quit_by_key()

    def accent_pixels(self, image):
        """Returns the number of pixels in the colour of markers."""
        return sum(abs(r - 0x6F) < 4 and abs(g - 0xA8) < 4 and abs(b - 0xF5) < 4
                   for r, g, b in zip(image.rgb[0::3], image.rgb[1::3], image.rgb[2::3]))

    def test_a_click_keeps_a_marker(self):
        """Undo removes the marker."""
        first = self.start("x^2 + y^2 + z^2 = 3; x + y + z = 0.5")
        before = self.accent_pixels(first)
        few = 12 * self.SCALE * self.SCALE
        self.display.xdotool("key", "Escape")
        self.display.xdotool("click", 1)
        self.rest(lambda image: self.accent_pixels(image) > before + few, "a marker")
        self.display.xdotool("key", "ctrl+z")
        self.rest(lambda image: self.accent_pixels(image) < before + few, "no marker any more")
        self.quit_by_key()

    def test_a_marker_snaps_to_a_singular_point(self):
        """A marker that a click keeps near the tip of a cone goes to the tip."""
        self.start("x^2 + y^2 = z^2")
        self.display.xdotool("key", "Escape")
        self.point(0.75, 0.44)
        self.display.xdotool("click", 1)

        def copied():
            """Returns the coordinates of the selected marker; none before there is one."""
            self.display.xdotool("key", "ctrl+c")
            text = self.clipboard().decode()
            return [float(part) for part in text[1:-1].split(",")] if text[:1] == "(" else None

        clicked = self.wait_for(copied, "the marker's coordinates")
        self.assertGreater(sum(abs(part) for part in clicked), 0.01)
        self.display.xdotool("key", "n")
        self.wait_for(lambda: sum(abs(part) for part in copied()) < 1e-8, "the marker at the tip")
        self.quit_by_key()

    def test_a_parameter_has_a_slider(self):
        """The slider is below the statement's row and the button that adds a row."""
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
        self.display.xdotool("type", ",,")
        self.display.xdotool("key", "F1")
        self.changed(ball, "the help")
        self.assertEqual(self.red_pixels(), 0, "typed after Tab, yet in the field")
        self.display.xdotool("key", "Escape")
        self.rest(lambda image: self.same(image, ball), "no help any more")
        self.quit_by_key()

    def test_saves_and_restores_after_a_crash(self):
        """The theme is restored, too, although the window was never closed."""
        dark = self.start(BALL)
        self.display.xdotool("key", "Escape", "ctrl+k")
        self.display.xdotool("type", "--delay", 5, "light theme")
        self.display.xdotool("key", "Return")
        ball = self.changed(dark, "the light theme")
        settings = Path(self.display.config) / "zeroset" / "window.json"
        self.wait_for(lambda: settings.exists() and
                      json.loads(settings.read_text()).get("theme") == "light", "the theme kept")
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
        """Presses the key and returns True if the picture at rest is then equal to `image`."""
        self.display.xdotool("key", key)
        return self.same(self.rest(lambda _: True, "rest"), image)

    def test_saves_a_picture_that_opens_again(self):
        ball = self.start(BALL)
        path = Path(self.display.folder.name) / "ball"
        self.display.xdotool("key", "Escape", "ctrl+e")
        page = self.changed(ball, "the page of what is saved")
        self.display.xdotool("key", "shift+Return")
        self.changed(page, "the choice of a file")
        self.display.xdotool("type", "--delay", 5, str(path))
        self.display.xdotool("key", "Return")
        picture = path.with_suffix(".png")
        self.wait_for(picture.exists, "the picture")
        image = read_png(picture)
        self.assertEqual((image.width, image.height), (1920, 1080))
        self.assertGreater(len(image.colors()), 100)
        read = run("explain", str(picture))
        self.assertEqual(read.code, 0, str(read))
        self.assertIn("x^2 + y^2 + z^2", read.out)

    def clipboard(self, *options):
        """Returns what xclip reads from the clipboard."""
        command = ["xclip", "-selection", "clipboard", "-o", *options]
        return subprocess.run(command, env=self.display.environment, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, timeout=20, check=False).stdout

    def test_copies_the_picture(self):
        self.start(BALL)
        self.display.xdotool("key", "Escape", "ctrl+shift+c")
        self.wait_for(lambda: b"image/png" in self.clipboard("-t", "TARGETS"), "a picture copied")
        path = Path(self.display.folder.name) / "copied.png"
        path.write_bytes(self.clipboard("-t", "image/png"))
        image = read_png(path)
        self.assertGreater(image.width, 300)
        self.assertGreater(len(image.colors()), 100)
        # A text that is copied takes its place.
        self.display.xdotool("key", "ctrl+c")
        self.wait_for(lambda: b"statements" in self.clipboard(), "the document copied")
        self.quit_by_key()

    def test_saves_views_and_goes_back_to_them(self):
        torus = self.start(TORUS)
        self.display.xdotool("key", "Escape", "v")
        turned = self.drag(1, 0.2, 0.1)
        self.display.xdotool("key", "v")
        self.rest(lambda image: self.same(image, turned), "the second view kept")
        self.display.xdotool("key", "ctrl+k")
        self.display.xdotool("type", "go to view 1")
        self.display.xdotool("key", "Return")
        self.rest(lambda image: self.same(image, torus), "the first view again")
        # The session holds both, and a film goes through them.
        self.display.xdotool("key", "ctrl+c")
        self.wait_for(lambda: b"statements" in self.clipboard(), "the document copied")
        views = json.loads(self.clipboard())["views"]
        self.assertEqual([view["name"] for view in views], ["View 1", "View 2"])
        # A camera goes from one window to another, and to the command line, as a line of text.
        self.display.xdotool("key", "ctrl+k")
        self.display.xdotool("type", "copy the camera")
        self.display.xdotool("key", "Return")
        self.wait_for(lambda: self.clipboard().startswith(b"eye "), "the camera copied")
        camera = self.clipboard().decode()
        done = run("render", TORUS, "--size", "40x30", "--camera", camera, "--stats", "-")
        self.assertEqual(done.code, 0, str(done))
        self.drag(1, -0.2, 0.0)
        self.display.xdotool("key", "ctrl+v")
        self.rest(lambda image: self.same(image, torus), "the camera pasted")
        self.quit_by_key()

    def test_undo_brings_back_text_and_view(self):
        ball = self.start(BALL)
        self.type_equation(TORUS)
        torus = self.changed(ball, "the typed surface")
        self.display.xdotool("key", "Escape")
        self.drag(1, 0.15, 0.1)
        self.display.xdotool("key", "ctrl+z")
        self.rest(lambda image: self.same(image, torus), "the view before the drag")
        # A pause while typing divides it into two undo steps.
        self.wait_for(lambda: self.after_key("ctrl+z", ball), "the text before")
        self.wait_for(lambda: self.after_key("ctrl+shift+z", torus), "the text again")
        self.quit_by_key()

    def whole(self):
        """Returns a screenshot of all of the screen."""
        return self.display.screenshot(0, 0, *self.SCREEN)

    def bar_colors(self):
        """Returns the number of colours in the place of the panel's header and of its rows."""
        return len(self.display.screenshot(0, 0, 300 * self.SCALE, 100 * self.SCALE).colors())

    def test_a_presentation_shows_the_picture_alone(self):
        """F5 begins it, Escape ends it; F11 and the size of letters are kept apart from it."""
        ball = self.start("x^2 + y^2 + z^2 = 1")
        panel = self.bar_colors()
        self.display.xdotool("key", "Escape", "F5")
        self.wait_for(lambda: self.bar_colors() < panel / 4, "no panel")
        self.rest(lambda _: True, "the presentation")
        shown = self.whole()
        left = self.display.screenshot(0, 100 * self.SCALE, self.SCREEN[0],
                                       self.SCREEN[1] - 100 * self.SCALE)
        self.assertGreater(self.surface(left), 0.02)
        self.display.xdotool("key", "Escape")
        self.rest(lambda image: self.same(image, ball), "the window as it was")
        self.assertGreater(self.whole().difference(shown), 0.05)
        self.quit_by_key()

    def test_a_session_for_a_class_changes_nothing(self):
        path = Path(self.display.folder.name) / "class.zeroset.json"
        slider = {"value": 1, "range": [0.5, 3], "step": 0, "speed": 1, "repeat": "loop"}
        text = json.dumps({
            "zeroset": 1, "statements": [{"text": "x^2 + y^2 + z^2 = a + b"}],
            "parameters": {"a": slider, "b": dict(slider, presented=False)}})
        path.write_text(text)
        self.start("--present", str(path))
        first = self.rest(lambda _: True, "the picture")
        # The only slider, a's, lies along the lower edge.
        width, height = self.SCREEN
        down = height - 53 * self.SCALE
        self.display.xdotool("mousemove", width // 2, down, "mousedown", 1)
        time.sleep(2 * POLL_S)
        self.display.xdotool("mousemove", width // 2 + 60 * self.SCALE, down, "mouseup", 1)
        self.point(0.72, 0.4)
        larger = self.changed(first, "the larger ball")
        for key in ("Escape", "F5", "ctrl+k", "ctrl+n", "ctrl+g", "ctrl+s", "ctrl+b"):
            self.display.xdotool("key", key)
        self.assertTrue(self.same(self.rest(lambda _: True, "rest"), larger), "nothing opens")
        self.display.xdotool("key", "ctrl+q")
        self.assertEqual(self.started.wait(5.0), 0, "no question")
        self.assertEqual(path.read_text(), text)

    def test_letters_grow_and_are_remembered(self):
        ball = self.start(BALL)
        self.display.xdotool("key", "Escape", "ctrl+plus", "ctrl+plus")
        settings = Path(self.display.config) / "zeroset" / "window.json"
        self.wait_for(lambda: json.loads(settings.read_text()).get("letters", 1) > 1.2,
                      "the size kept")
        large = self.changed(ball, "the picture beside a wider panel")
        self.display.xdotool("key", "ctrl+minus", "ctrl+minus")
        self.rest(lambda image: self.same(image, ball), "letters as they were")
        self.display.xdotool("key", "ctrl+plus", "ctrl+plus")
        self.rest(lambda image: self.same(image, large), "large letters again")
        self.display.xdotool("key", "ctrl+0")
        self.rest(lambda image: self.same(image, ball), "letters as usual")
        self.quit_by_key()

    def test_full_screen_and_back(self):
        """The window is smaller than the screen at first."""
        width, height = self.SCREEN
        self.start(BALL)
        self.display.xdotool("windowsize", self.window, width - 150, height - 100)
        self.rest(lambda _: True, "the smaller window")
        size = lambda: self.display.xdotool("getwindowgeometry", "--shell", self.window)
        self.wait_for(lambda: f"WIDTH={width - 150}" in size(), "the smaller window")
        self.display.xdotool("key", "Escape", "F11")
        self.wait_for(lambda: f"WIDTH={width}\n" in size(), "the full screen")
        self.display.xdotool("key", "F11")
        self.wait_for(lambda: f"WIDTH={width - 150}\n" in size(), "the window again")
        # Without a window manager nobody gives the keyboard back.
        self.display.xdotool("windowfocus", "--sync", self.window)
        self.rest(lambda _: True, "rest")
        self.quit_by_key()

    def test_a_new_document_has_axes_until_they_are_switched_off(self):
        settings = Path(self.display.config) / "zeroset" / "window.json"
        settings.unlink()
        axes = self.start(BALL)
        self.display.xdotool("key", "Escape", "shift+a")
        ball = self.changed(axes, "no axes")
        self.wait_for(lambda: settings.exists() and
                      json.loads(settings.read_text())["axes"] is False, "the choice kept")
        self.quit_by_key()
        again = self.start(BALL)
        self.assertTrue(self.same(again, ball), "no axes at the next start")
        self.quit_by_key()

    def wakes(self):
        """How often the thread that draws has begun to work again."""
        status = Path(f"/proc/{self.started.pid}/status").read_text()
        return int(re.search(r"^voluntary_ctxt_switches:\s*(\d+)", status, re.M).group(1))

    def test_sleeps_when_nothing_changes(self):
        self.start(BALL)
        self.display.xdotool("key", "Escape")
        self.rest(lambda _: True, "rest")

        def sleeps():
            before = self.wakes()
            time.sleep(1.0)
            # A frame alone is more than one: the driver has threads of its own to wait for.
            return self.wakes() - before < 10

        # What is done once, soon after the start, may wake it a few times more.
        self.assertTrue(any(sleeps() for _ in range(10)), "draws on and on")
        self.started.send_signal(signal.SIGTERM)
        self.started.wait(5.0)

    def test_starts_with_a_surface_of_the_gallery(self):
        self.start("@torus")
        self.quit_by_key()


class LargeScaleWindowTest(WindowTest):
    """Runs the tests of WindowTest at scale 2, for high-resolution screens: those where the pointer
    must meet what is drawn; in a long run (ZEROSET_LONG is set) all of them."""

    SCALE = 2
    SCREEN = (1600, 1200)
    OF_THE_POINTER = ("test_type_drag_zoom_reset_and_quit", "test_a_click_keeps_a_marker",
                      "test_a_parameter_has_a_slider", "test_saves_a_picture_that_opens_again")

    def setUp(self):
        if "ZEROSET_LONG" not in os.environ and self._testMethodName not in self.OF_THE_POINTER:
            self.skipTest("only in a long run")
        super().setUp()


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
    check_tools()
    main(at_once=2)
