"""Tests of the real window: animation, other sizes, opened files."""

import json
from pathlib import Path

from real_window import RealWindowTest, check_tools
from zeroset_program import main

SLIDER_DOWN = 146  # y of the first slider, below one statement and the button that adds one
PLAY_ACROSS = 21   # x of the slider's play button
NEXT = 687, 174    # the button of the tour's first card


class WindowStateTest(RealWindowTest):
    def test_w_is_scrubbed(self):
        """Dragging the slider of w from 0 towards its end makes the ball grow."""
        self.start("x^2 + y^2 + z^2 = w + 1")
        ball = self.rest(lambda _: True, "the ball")
        self.display.xdotool("mousemove", 185, SLIDER_DOWN, "mousedown", 1)
        sizes = []
        for across in (195, 205, 215):
            self.display.xdotool("mousemove", across, SLIDER_DOWN)
            sizes.append(self.surface(self.rest(lambda _: True, "rest")))
        self.display.xdotool("mouseup", 1)
        self.assertEqual(sizes, sorted(sizes))
        self.assertGreater(sizes[0], self.surface(ball))
        self.assertGreater(sizes[2], sizes[0])
        self.display.xdotool("key", "Escape", "ctrl+z")
        self.rest(lambda image: self.same(image, ball), "the ball before")
        self.quit_by_key()

    def test_w_plays_until_it_is_stopped(self):
        self.start("x^2 + y^2 + z^2 = w + 3")
        self.rest(lambda _: True, "the ball")
        self.display.xdotool("mousemove", PLAY_ACROSS, SLIDER_DOWN, "click", 1)
        self.point(0.72, 0.55)
        seen = set()
        self.wait_for(lambda: seen.add(self.picture().rgb) or len(seen) > 5, "pictures that move")
        self.display.xdotool("mousemove", PLAY_ACROSS, SLIDER_DOWN, "click", 1)
        self.point(0.72, 0.55)
        stopped = self.rest(lambda _: True, "rest")
        self.assertTrue(self.same(self.rest(lambda _: True, "rest"), stopped))
        self.quit_by_key()

    def test_the_picture_follows_the_windows_size(self):
        """The window becomes narrower and then wide again."""
        self.start("x^2 + y^2 + z^2 = 1")
        whole = self.rest(lambda _: True, "the ball")
        width, height = self.SCREEN
        self.display.xdotool("windowsize", self.window, width - 200, height)

        def is_narrow(image):
            """Returns True if the uncovered right edge is black."""
            return all(image.at(image.width - 1, row) == (0, 0, 0)
                       for row in range(0, image.height, 16))

        narrow = self.rest(lambda image: is_narrow(image), "the narrow window")
        middle = narrow.height // 2
        left = (width - 200 - self.PANEL) // 2 - 10
        self.assertNotEqual(narrow.at(left, middle), narrow.at(2, middle), "a ball in the middle")
        self.display.xdotool("windowsize", self.window, width, height)
        self.rest(lambda image: self.same(image, whole), "the first picture")
        self.quit_by_key()

    def test_opens_a_file_from_its_dialog(self):
        ball = self.start("x^2 + y^2 + z^2 = 1")
        path = Path(self.display.folder.name) / "cylinder.zeroset.json"
        path.write_text(json.dumps({"zeroset": 1, "statements": [{"text": "x^2 + z^2 = 0.25"}]}))
        self.display.xdotool("key", "Escape", "ctrl+o")
        self.changed(ball, "the choice of a file")
        self.display.xdotool("type", "--delay", 5, str(path))
        self.display.xdotool("key", "Return")
        self.wait_for(lambda: self.title() == "cylinder - Zeroset", "the file's name in the title")
        self.changed(ball, "the cylinder")
        self.quit_by_key()

    def test_the_tour_is_shown_at_the_first_start(self):
        (Path(self.display.config) / "zeroset" / "window.json").unlink()
        first = self.start()
        self.display.xdotool("mousemove", *NEXT, "click", 1)
        self.point(0.72, 0.55)
        second = self.changed(first, "the second card")
        self.display.xdotool("key", "Escape")
        plain = self.changed(second, "the end of the tour")
        self.assertFalse(self.same(plain, first))
        self.quit_by_key()
        self.assertTrue(self.same(self.start(), plain), "no tour again")
        self.quit_by_key()


if __name__ == "__main__":
    check_tools()
    main()
