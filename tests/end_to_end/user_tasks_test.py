"""What a teacher, a mathematician and an artist come for, in the real window from its first start,
and how many actions it takes them: a key, a click, a drag or a typed text is one."""

import json
import subprocess
import time
from pathlib import Path

from real_window import POLL_S, RealWindowTest, check_tools
from zeroset_program import main, read_png, run

FILM_S = 300.0  # longest wait for a film


class UserTasks(RealWindowTest):
    def setUp(self):
        super().setUp()
        self.actions = 0
        self.folder = Path(self.display.folder.name)

    def open(self, text):
        """Starts the program as a new user does, who has chosen nothing yet."""
        (Path(self.display.config) / "zeroset" / "window.json").unlink()
        return self.start(text)

    def press(self, key):
        self.display.xdotool("key", key)
        self.actions += 1

    def say(self, text):
        self.display.xdotool("type", "--delay", 5, text)
        self.actions += 1

    def click(self, across, down):
        self.point(across, down)
        self.display.xdotool("click", 1)
        self.actions += 1

    def clipboard(self):
        command = ["xclip", "-selection", "clipboard", "-o"]
        return subprocess.run(command, env=self.display.environment, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, timeout=20, check=False).stdout.decode()

    def document(self):
        """Returns the document, as Ctrl+C copies it outside the rows."""
        self.display.xdotool("key", "Escape", "ctrl+c")
        return json.loads(self.wait_for(lambda: "statements" in self.clipboard() and
                                        self.clipboard(), "the document copied"))

    def test_a_teacher_shows_a_paraboloid(self):
        """A slider changes it, the axes are there, the class sees it on the whole screen."""
        narrow = self.open("z = a*(x^2 + y^2)/2")
        self.display.xdotool("mousemove", 185, 146, "mousedown", 1)
        for across in range(185, 215, 2):
            self.display.xdotool("mousemove", across, 146)
            time.sleep(POLL_S)
        self.display.xdotool("mouseup", 1)
        self.actions += 1
        steep = self.changed(narrow, "the steeper paraboloid")
        document = self.document()
        self.assertTrue(document["look"]["axes"])
        self.assertNotEqual(document["parameters"]["a"]["value"], 1)
        self.assertEqual(self.actions, 1)
        self.press("F5")
        self.changed(steep, "the presentation")
        self.press("Escape")
        self.rest(lambda image: self.same(image, steep), "the panel again")
        self.quit_by_key()

    def test_a_teacher_takes_the_picture(self):
        """Two actions: the page, and Enter; the next picture has a name of its own."""
        first = self.open("x^2 + y^2 - z^2 = 1")
        self.display.xdotool("key", "Escape")
        self.press("ctrl+e")
        self.changed(first, "the page of what is saved")
        self.press("Return")
        picture = self.folder / "picture.png"
        self.wait_for(picture.exists, "the picture")
        self.assertEqual(self.actions, 2)
        self.assertGreater(len(read_png(picture).colors()), 100)
        self.assertIn("x^2 + y^2 - z^2", run("explain", str(picture)).out)

        def second():
            self.display.xdotool("key", "Return")
            return (self.folder / "picture-2.png").exists()

        self.wait_for(second, "a second picture beside the first")

    def test_a_mathematician_asks_for_a_point(self):
        """One click gives its coordinates, N the node beside it."""
        first = self.open("x^2 + y^2 = z^2*(1 - z)")
        self.display.xdotool("key", "Escape")
        self.rest(lambda image: self.same(image, first), "rest")
        self.click(0.735, 0.52)
        x, y, z = self.document_marker()
        self.assertEqual(self.actions, 1)
        self.assertLess(abs(x * x + y * y - z * z * (1 - z)), 1e-5)
        self.press("n")
        self.wait_for(lambda: sum(abs(part) for part in self.document_marker()) < 1e-8,
                      "the marker at the node")
        self.quit_by_key()

    def document_marker(self):
        """Returns the coordinates of the marker, which Ctrl+C copies once it is there; a click
        waits for a second one before it keeps a marker."""
        def copied():
            self.display.xdotool("key", "ctrl+c")
            text = self.clipboard()
            return text if text.startswith("(") else None

        text = self.wait_for(copied, "the coordinates copied")
        return [float(part) for part in text[1:-1].split(",")]

    def test_an_artist_takes_a_turntable(self):
        """Three actions, and Enter: a film of its own name in the folder."""
        first = self.open("@torus")
        self.display.xdotool("key", "Escape")
        self.press("ctrl+k")
        self.changed(first, "the commands")
        self.say("film")
        self.press("Return")
        self.changed(first, "the page of films")
        self.assertEqual(self.actions, 3)
        self.press("Return")
        film = self.folder / "film.mp4"
        end = time.monotonic() + FILM_S
        while not film.exists() and time.monotonic() < end:
            time.sleep(0.2)
        read = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries",
                               "stream=nb_read_frames", "-of", "csv=p=0", str(film)],
                              capture_output=True, text=True, check=True, timeout=60)
        self.assertEqual(int(read.stdout), 180)


if __name__ == "__main__":
    check_tools()
    main(at_once=2)
