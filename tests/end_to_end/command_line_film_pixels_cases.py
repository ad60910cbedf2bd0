"""Tests of what films show, as FFmpeg's own program decodes them."""

import subprocess

from zeroset_program import ProgramTest

SURFACE = "(x^2 + y^2 + z^2 + 3)^2 = 16*(x^2 + y^2)"
SIZE = (64, 48)
FRAMES = 4
FRAME_BYTES = SIZE[0] * SIZE[1] * 4
EXACT = 0.0
# (ending, the largest mean difference of a channel from the frames, of 255)
OPAQUE = [("mkv", EXACT), ("apng", EXACT), ("mov", 1.0), ("mp4", 2.5), ("webm", 2.5), ("gif", 5.0)]
TRANSPARENT = [("mkv", EXACT), ("apng", EXACT), ("mov", 1.0), ("webm", 2.5), ("gif", 5.0)]


def decoded(path, *before):
    """Returns the frames of a film or of numbered pictures as RGBA."""
    done = subprocess.run(["ffmpeg", "-v", "error", *before, "-i", path, "-fps_mode", "passthrough",
                           "-sws_flags", "accurate_rnd+full_chroma_int+bitexact", "-f", "rawvideo",
                           "-pix_fmt", "rgba", "-"], capture_output=True, check=True)
    return [done.stdout[at:at + FRAME_BYTES] for at in range(0, len(done.stdout), FRAME_BYTES)]


def difference(film, frame):
    """Returns the mean difference of the colours where the frame is opaque, and of the alphas."""
    colors = []
    alphas = []
    for at in range(0, FRAME_BYTES, 4):
        alphas.append(abs(film[at + 3] - frame[at + 3]))
        if frame[at + 3] == 255:
            colors += [abs(film[at + i] - frame[at + i]) for i in range(3)]
    return sum(colors) / len(colors), sum(alphas) / len(alphas)


class FilmPixelsTest(ProgramTest):
    def film(self, name, *arguments):
        self.run_ok("turntable", SURFACE, "--size", f"{SIZE[0]}x{SIZE[1]}", "--fps", "25",
                    "--frames", str(FRAMES), "--aa", "iaa", *arguments, "-o", name)

    def check(self, endings, *arguments):
        self.film("frame#.png", *arguments)
        frames = decoded(self.folder / "frame%d.png")
        for ending, most in endings:
            with self.subTest(ending=ending):
                self.film("film." + ending, *arguments)
                # The decoder that FFmpeg takes for WebM by itself leaves out alpha.
                before = ["-c:v", "libvpx-vp9"] if ending == "webm" else []
                film = decoded(self.folder / ("film." + ending), *before)
                self.assertEqual(len(film), FRAMES)
                if most == EXACT:
                    self.assertEqual(film, frames)
                for shown, frame in zip(film, frames):
                    colors, alphas = difference(shown, frame)
                    self.assertLessEqual(colors, most)
                    # GIF knows no pixels that are transparent in part.
                    self.assertLessEqual(alphas, most)

    def test_films_show_their_frames(self):
        self.check(OPAQUE)

    def test_transparent_films_show_their_frames(self):
        self.check(TRANSPARENT, "--alpha")

    def test_a_film_comes_back_through_the_same_frames(self):
        self.run_ok("animate", "x^2 + y^2 + z^2 = a", "--sweep", "a=0.2..2", "--end", "bounce",
                    "--ease", "smooth", "--frames", "6", "--size", "40", "-o", "f#.png")
        files = [(self.folder / f"f{i}.png").read_bytes() for i in range(6)]
        self.assertEqual(files[1], files[5])
        self.assertEqual(files[2], files[4])
        self.assertEqual(len(set(files)), 4)
