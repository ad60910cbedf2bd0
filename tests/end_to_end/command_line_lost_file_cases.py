"""Tests that every exporter says when it cannot write, and leaves what was there."""

import os
import resource
import signal
import subprocess
import unittest

from zeroset_program import ProgramTest, Result, environment, program, to_try

SURFACE = "x^2 + y^2 + z^2 = 1"
PICTURE = ["render", SURFACE, "--size", "90x60"]
FILM = ["turntable", SURFACE, "--size", "64x48", "--frames", "6"]
MESH = ["mesh", SURFACE, "--tolerance", "0.05"]
DRAWING = ["draw", "z = x^2 + y^2", "--box", "2"]
EXPORTS = [(command, ending) for command, endings in (
    (PICTURE, ("png", "jpg", "webp", "tif", "exr", "bmp", "tga", "hdr")),
    (FILM, ("mp4", "webm", "mov", "mkv", "gif", "apng", "#.png")),
    (MESH, ("stl", "3mf", "ply", "obj", "glb")),
    (DRAWING, ("svg", "pdf", "tex"))) for ending in endings]
LARGEST_FILE = 200  # bytes; smaller than what any of them writes
BEFORE = b"what was there before"


def limit_files():
    """Makes writes fail beyond a size, as on a disk that is full."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (LARGEST_FILE, LARGEST_FILE))


class LostFileTest(ProgramTest):
    def run_limited(self, *arguments, limit=limit_files):
        done = subprocess.run([program(), *arguments], cwd=self.folder, capture_output=True,
                              check=False, env=environment(), preexec_fn=limit)
        return Result(arguments, done)

    def check_failed(self, result, name):
        self.assertEqual(result.code, 1, str(result))
        self.assertRegex(result.err, r"\Aerror: [^\n]+\n\Z")
        self.assertIn(name, result.err)
        self.assertNotIn("no reason", result.err)

    def test_a_full_disk_leaves_what_was_there(self):
        for command, ending in to_try(EXPORTS, every=3):
            with self.subTest(ending=ending):
                written = f"file{ending}" if "#" in ending else f"file.{ending}"
                name = written.replace("#", "0")
                (self.folder / name).write_bytes(BEFORE)
                self.check_failed(self.run_limited(*command, "-o", written), name)
                self.assertEqual((self.folder / name).read_bytes(), BEFORE)
                (self.folder / name).unlink()
                self.assertEqual(self.files(), [])

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no /dev/full")
    def test_a_full_device(self):
        for command, ending in to_try(EXPORTS, every=3):
            if "#" in ending:
                continue
            with self.subTest(ending=ending):
                name = f"full.{ending}"
                os.symlink("/dev/full", self.folder / name)
                self.check_failed(self.run_limited(*command, "-o", name, limit=None), name)
                (self.folder / name).unlink()
                self.assertEqual(self.files(), [])

    def test_a_folder_that_takes_no_files(self):
        for command in (PICTURE, FILM, MESH, DRAWING):
            ending = next(ending for other, ending in EXPORTS if other is command)
            with self.subTest(ending=ending):
                for folder in ("none", "/proc"):  # /proc stops root, too
                    name = f"{folder}/file.{ending}"
                    self.check_failed(self.run_limited(*command, "-o", name, limit=None), name)
                    self.assertEqual(self.files(), [])
