"""Tests of the real window with a fake desktop portal: theme and file dialogs."""

import json
import os
import shutil
import signal
import subprocess
import sys
import unittest
from pathlib import Path

from real_window import PATIENCE_S, RealWindowTest, check_tools
from zeroset_program import main

BALL = "x^2+y^2+z^2=1"


def has_dbus(python):
    """Returns True if this interpreter has the fake portal's modules; maybe only /usr/bin's has."""
    done = subprocess.run([python, "-c", "import dbus, gi"], capture_output=True, check=False)
    return done.returncode == 0


PYTHONS = [python for python in (sys.executable, "/usr/bin/python3")
           if os.access(python, os.X_OK) and has_dbus(python)]
MISSING = [] if PYTHONS else ["python3-dbus, python3-gi"]
MISSING += [] if shutil.which("dbus-daemon") else ["dbus-daemon"]
NO_PREFERENCE, DARK, LIGHT = 0, 1, 2


@unittest.skipIf(MISSING, f"not installed: {', '.join(MISSING)}")
class PortalTest(RealWindowTest):
    def setUp(self):
        super().setUp()
        self.folder = Path(self.display.folder.name)
        self.bus = subprocess.Popen(["dbus-daemon", "--session", "--nofork", "--print-address"],
                                    stdout=subprocess.PIPE, env=self.display.environment)
        self.addCleanup(self.finish, self.bus)
        self.display.environment["DBUS_SESSION_BUS_ADDRESS"] = \
            self.bus.stdout.readline().decode().strip()

    def finish(self, process):
        process.terminate()
        process.wait(PATIENCE_S)
        process.stdout.close()

    def start_portal(self, scheme, answer="cancel"):
        (self.folder / "scheme").write_text(str(scheme))
        (self.folder / "answer").write_text(answer)
        script = Path(__file__).with_name("fake_portal.py")
        self.portal = subprocess.Popen([PYTHONS[0], script, self.folder],
                                       stdout=subprocess.PIPE, env=self.display.environment)
        self.addCleanup(self.finish, self.portal)
        self.assertIn(b"portal", self.portal.stdout.readline())

    def change_scheme(self, scheme):
        (self.folder / "scheme").write_text(str(scheme))
        self.portal.send_signal(signal.SIGUSR1)

    def is_light(self):
        """Returns True if the colour in the middle of the panel is near white."""
        return min(self.display.screenshot(100, 300, 104, 304).at(1, 1)) > 200

    def asked(self):
        path = self.folder / "asked"
        return [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []

    def test_theme_follows_the_desktop_until_one_is_chosen(self):
        self.start_portal(LIGHT)
        self.start(BALL)
        self.wait_for(self.is_light, "the light theme")
        self.change_scheme(DARK)
        self.wait_for(lambda: not self.is_light(), "the dark theme")
        self.change_scheme(LIGHT)
        self.wait_for(self.is_light, "the light theme again")
        self.change_scheme(NO_PREFERENCE)
        self.wait_for(lambda: not self.is_light(), "the usual theme")
        self.display.xdotool("key", "Escape", "ctrl+k")
        self.display.xdotool("type", "--delay", 5, "light theme")
        self.display.xdotool("key", "Return")
        self.wait_for(self.is_light, "the theme that was chosen")
        self.quit_by_key()
        kept = json.loads((self.folder / "config" / "zeroset" / "window.json").read_text())
        self.assertEqual(kept["theme"], "light")
        self.end()
        self.change_scheme(DARK)
        self.start(BALL)
        self.assertTrue(self.is_light(), "the choice is remembered")
        self.quit_by_key()

    def test_files_are_chosen_in_the_desktops_dialog(self):
        path = self.folder / "a b\u00e9.zeroset.json"
        self.start_portal(DARK, (self.folder / "a%20b%C3%A9").as_uri().replace("%25", "%"))
        self.start(BALL)
        self.display.xdotool("key", "Escape", "ctrl+s")
        self.wait_for(path.exists, "the file, with its ending")
        self.wait_for(lambda: self.title() == "a b\u00e9 - Zeroset", "the file's name")
        asked = self.asked()[0]
        self.assertEqual(asked["method"], "SaveFile")
        self.assertEqual(asked["parent"], f"x11:{int(self.window):x}")
        self.assertEqual(asked["filter"], "*.zeroset.json")
        self.assertEqual(asked["name"], "untitled.zeroset.json")
        self.assertTrue(Path(asked["folder"]).is_dir())

        other = self.folder / "other.zeroset.json"
        shutil.copy(path, other)
        (self.folder / "answer").write_text("cancel")
        self.display.xdotool("key", "ctrl+o")
        self.wait_for(lambda: len(self.asked()) == 2, "the dialog that is cancelled")
        (self.folder / "answer").write_text(other.as_uri())
        self.wait_for(lambda: self.opens_once_more(2), "the dialog again")
        self.wait_for(lambda: self.title() == "other - Zeroset", "the other file")
        self.rest(lambda _: True, "rest")
        self.assertEqual(self.asked()[-1]["method"], "OpenFile")
        self.assertEqual(self.asked()[-1]["parent"], asked["parent"])
        self.assertEqual(self.asked()[-1]["folder"], str(self.folder))
        self.quit_by_key()

    def opens_once_more(self, before):
        """Returns True if there were more than `before` dialogs; asks for one if not."""
        if len(self.asked()) == before:
            self.display.xdotool("key", "ctrl+o")
        return len(self.asked()) > before

    def test_a_portal_without_dialogs_leaves_them_to_the_window(self):
        self.start_portal(DARK, "fail")
        ball = self.start(BALL)
        path = self.folder / "own.zeroset.json"
        self.display.xdotool("key", "Escape", "ctrl+s")
        self.changed(ball, "the window's own choice")
        self.display.xdotool("type", "--delay", 5, str(path))
        self.display.xdotool("key", "Return")
        self.wait_for(path.exists, "the file")
        self.quit_by_key()


if __name__ == "__main__":
    check_tools()
    main()
