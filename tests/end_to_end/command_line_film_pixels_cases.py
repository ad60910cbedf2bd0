"""Tests of what films show, as FFmpeg's own program decodes them."""

import subprocess

from zeroset_program import ProgramTest, to_try

SURFACE = "(x^2 + y^2 + z^2 + 0.75)^2 = 4*(x^2 + y^2)"
SIZE = (64, 48)
FRAMES = 4
FRAME_BYTES = SIZE[0] * SIZE[1] * 4
EXACT = 0.0
# (ending, the largest mean difference of the lumas and of the channels, of 255): MP4 and WebM have
# one colour for four pixels.
OPAQUE = [("mp4", 1.5, 5.0), ("mkv", EXACT, EXACT), ("webm", 1.5, 5.5), ("apng", EXACT, EXACT),
          ("gif", 2.0, 2.0), ("mov", 1.0, 1.5)]
TRANSPARENT = [film for film in OPAQUE if film[0] != "mp4"]


def decoded(path, *before):
    """Returns the frames of a film or of numbered pictures as RGBA."""
    done = subprocess.run(["ffmpeg", "-v", "error", *before, "-i", path, "-fps_mode", "passthrough",
                           "-sws_flags", "accurate_rnd+full_chroma_int+bitexact", "-f", "rawvideo",
                           "-pix_fmt", "rgba", "-"], capture_output=True, check=True)
    return [done.stdout[at:at + FRAME_BYTES] for at in range(0, len(done.stdout), FRAME_BYTES)]


def luma(pixels, at):
    return 0.2126 * pixels[at] + 0.7152 * pixels[at + 1] + 0.0722 * pixels[at + 2]


def mean(numbers):
    return sum(numbers) / len(numbers)


def differences(film, frame, sharp):
    """Returns the mean differences of lumas and of channels where the frame is opaque, and of
    alphas: of a film with sharp ones only where the frame's are."""
    opaque = [at for at in range(0, FRAME_BYTES, 4) if frame[at + 3] == 255]
    return (mean([abs(luma(film, at) - luma(frame, at)) for at in opaque]),
            mean([abs(film[at + i] - frame[at + i]) for at in opaque for i in range(3)]),
            mean([abs(film[at] - frame[at]) for at in range(3, FRAME_BYTES, 4)
                  if not sharp or frame[at] in (0, 255)]))


class FilmPixelsTest(ProgramTest):
    def film(self, name, *arguments):
        self.run_ok("turntable", SURFACE, "--size", f"{SIZE[0]}x{SIZE[1]}", "--fps", "25",
                    "--frames", str(FRAMES), "--aa", "iaa", *arguments, "-o", name)

    def check(self, films, *arguments):
        self.film("frame#.png", *arguments)
        frames = decoded(self.folder / "frame%d.png")
        for ending, most_luma, most in films:
            with self.subTest(ending=ending):
                self.film("film." + ending, *arguments)
                # The decoder that FFmpeg takes for WebM by itself leaves out alpha.
                before = ["-c:v", "libvpx-vp9"] if ending == "webm" else []
                film = decoded(self.folder / ("film." + ending), *before)
                self.assertEqual(len(film), FRAMES)
                if most == EXACT:
                    self.assertEqual(film, frames)
                for shown, frame in zip(film, frames):
                    # GIF knows no pixels that are transparent in part.
                    sharp = ending == "gif"
                    lumas, channels, alphas = differences(shown, frame, sharp)
                    self.assertLessEqual(lumas, most_luma)
                    self.assertLessEqual(channels, most)
                    self.assertLessEqual(alphas, EXACT if sharp else most)

    def test_films_show_their_frames(self):
        self.check(to_try(OPAQUE, every=3))

    def test_transparent_films_show_their_frames(self):
        self.check(to_try(TRANSPARENT, every=3), "--alpha")

    def test_a_film_comes_back_through_the_same_frames(self):
        self.run_ok("animate", "x^2 + y^2 + z^2 = a", "--sweep", "a=0.2..2", "--end", "bounce",
                    "--ease", "smooth", "--frames", "6", "--size", "40", "-o", "f#.png")
        files = [(self.folder / f"f{i}.png").read_bytes() for i in range(6)]
        self.assertEqual(files[1], files[5])
        self.assertEqual(files[2], files[4])
        self.assertEqual(len(set(files)), 4)
