"""Tests of keyboard, mouse and number fields in the real window, on an X display of its own."""

import json
import subprocess

from real_window import RealWindowTest, check_tools
from zeroset_program import main

BALL = "x^2+y^2+z^2=1"


class InputTest(RealWindowTest):
    def clipboard(self):
        """Returns the text that xclip reads from the clipboard."""
        done = subprocess.run(["xclip", "-selection", "clipboard", "-o"],
                              env=self.display.environment, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, timeout=20, check=False)
        return done.stdout.decode()

    def set_clipboard(self, text):
        subprocess.run(["xclip", "-selection", "clipboard", "-i"], input=text.encode(),
                       env=self.display.environment, timeout=20, check=True)

    def document(self):
        """Returns the document, as Ctrl+C copies it outside the rows."""
        self.set_clipboard("nothing")
        self.display.xdotool("key", "Escape", "ctrl+c")
        return json.loads(self.wait_for(lambda: "statements" in self.clipboard() and
                                        self.clipboard(), "the document copied"))

    def texts(self):
        return [row["text"] for row in self.document()["statements"]]

    def test_alt_leaves_the_keyboard_where_it_is(self):
        """Alt alone would go to a menu bar; Alt+Up moves a row, again and again."""
        self.start("a=1; b=2; x^2+y^2+z^2=1")
        self.display.xdotool("key", "End", "Alt_L")
        self.rest(lambda _: True, "rest")
        self.display.xdotool("type", "1")
        self.rest(lambda _: True, "rest")
        self.assertEqual(self.texts()[0], "a=11")

    def test_alt_and_arrows_move_a_row_on_and_on(self):
        self.start("a=1; b=2; x^2+y^2+z^2=1")
        self.display.xdotool("key", "End", "alt+Down")
        self.rest(lambda _: True, "rest")
        self.display.xdotool("key", "alt+Down")
        self.rest(lambda _: True, "rest")
        self.display.xdotool("type", "1")
        self.rest(lambda _: True, "rest")
        self.assertEqual(self.texts(), ["b=2", BALL, "a=11"])

    def test_a_drag_within_a_frame_turns_the_view(self):
        """Press, way and release reach the program at once."""
        first = self.start(BALL.replace("x^2", "4*x^2"))
        self.display.xdotool("key", "Escape")
        width, height = self.SCREEN
        at = [int(0.72 * width), int(0.55 * height)]
        to = [int(0.82 * width), int(0.65 * height)]
        self.display.xdotool("mousemove", *at, "mousedown", 1, "mousemove", *to, "mouseup", 1)
        self.changed(first, "the turned view")

    def test_a_click_within_a_frame_keeps_one_marker(self):
        self.start(BALL)
        self.display.xdotool("key", "Escape", "mousedown", 1, "mouseup", 1)

        # Not at once: a second click would make it a double click.
        def copied():
            self.display.xdotool("key", "ctrl+c")
            return self.clipboard().startswith("(")

        self.wait_for(copied, "the marker's place copied")
        self.rest(lambda _: True, "rest")
        self.display.xdotool("key", "ctrl+z")
        self.rest(lambda _: True, "rest")
        self.assertNotIn("markers", self.document())

    def test_a_surface_out_of_view_is_told_and_found(self):
        """F finds it; the notice over the picture is gone then."""
        ball = self.start(BALL)
        self.type_equation("(x-9)^2+y^2+z^2=1")
        notice = self.changed(ball, "the notice")
        self.display.xdotool("key", "Escape", "f")
        found = self.rest(lambda image: not self.same(image, notice) and
                          self.surface(image) > 0.1, "the surface found")
        box = self.document()["box"]
        self.assertTrue(7 < box[0] < 8 < 10 < box[1] < 11, box)
        # What is typed near the origin now lies outside the box; the usual one is a click away.
        self.type_equation(BALL)
        self.changed(found, "the notice again")
        width, height = self.SCREEN
        middle = 0.5 * (self.PANEL + width)
        self.display.xdotool("key", "Escape")
        self.display.xdotool("mousemove", int(middle + 80), int(0.5 * (height - 27) + 16),
                             "click", 1)
        self.rest(lambda image: self.surface(image) > 0.02, "the ball in the usual box")
        self.assertEqual(self.document()["box"], [-2, 2] * 3)

    def test_a_pasted_command_brings_its_box(self):
        self.start(BALL)
        plain = self.document()["box"]
        self.display.xdotool("key", "Tab")
        self.rest(lambda _: True, "rest")
        self.set_clipboard("ContourPlot3D[x^2 + y^2 == z, {x, -1, 1}, {y, -1, 1}, {z, 0, 1}]")
        self.display.xdotool("key", "ctrl+a", "ctrl+v")
        self.rest(lambda _: True, "rest")
        self.assertEqual(self.document()["box"], [-1, 1, -1, 1, 0, 1])
        self.display.xdotool("key", "ctrl+z")
        self.rest(lambda _: True, "rest")
        self.assertEqual(self.document()["box"], plain)

    def test_a_decimal_comma_is_read(self):
        """In the value of a slider, which is typed after a double click."""
        self.start("x^2+y^2+z^2=a")
        self.display.xdotool("key", "Escape", "mousemove", 200, 146,
                             "click", "--repeat", 2, "--delay", 60, 1)
        self.rest(lambda _: True, "rest")
        self.display.xdotool("key", "ctrl+a", "type", "2,5")
        self.display.xdotool("key", "Return")
        self.rest(lambda _: True, "rest")
        self.assertEqual(self.document()["parameters"]["a"]["value"], 2.5)


if __name__ == "__main__":
    check_tools()
    main(at_once=2)
