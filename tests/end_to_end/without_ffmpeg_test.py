"""The command line of a program that was built without FFmpeg."""

from zeroset_program import ProgramTest, main, read_png, run

SPHERE = "x^2 + y^2 + z^2 = 1"
REASON = "this Zeroset was built without FFmpeg"
SMALL = ("--size", "48x32")


class WithoutFfmpegTest(ProgramTest):
    def refused(self, *arguments):
        """Runs a command that must be refused in one line and leave nothing; returns the line."""
        result = run(*arguments, cwd=self.folder)
        self.assertEqual((result.code, result.out), (2, ""), str(result))
        self.assertEqual(result.err.count("\n"), 1, str(result))
        self.assertEqual(self.files(), [])
        return result.err

    def test_pictures_that_need_no_ffmpeg_are_written(self):
        self.run_ok("render", SPHERE, *SMALL, "-o", "a.png", "--bits", "16", "--dpi", "300")
        self.run_ok("render", SPHERE, *SMALL, "-o", "a.exr")
        self.assertEqual((self.folder / "a.exr").read_bytes()[:4], b"\x76\x2f\x31\x01")
        for name, start in (("a.jpg", b"\xff\xd8\xff"), ("a.bmp", b"BM"),
                            ("a.tga", b"\0\0\x0a"), ("a.hdr", b"#?RADIANCE")):
            self.run_ok("render", SPHERE, *SMALL, "-o", name)
            self.assertEqual((self.folder / name).read_bytes()[:len(start)], start)
        self.run_ok("render", "a.png", *SMALL, "-o", "b.png")
        image = read_png(self.folder / "b.png")
        self.assertEqual((image.width, image.height), (48, 32))
        self.assertGreater(len(image.colors()), 30)

    def test_other_pictures_say_what_is_missing_and_which_ending_works(self):
        for name in ("a.webp", "a.tif", "a.tiff"):
            for more in ((), ("--quality", "50"), ("--dpi", "300")):
                with self.subTest(name=name, more=more):
                    line = self.refused("render", SPHERE, *SMALL, "-o", name, *more)
                    self.assertIn(REASON, line)
                    self.assertIn(".png", line)

    def test_films_say_what_is_missing_and_which_name_works(self):
        for ending in ("mp4", "webm", "mov", "mkv", "gif", "apng", "avi"):
            for more in ((), ("--alpha",), ("--quality", "50")):
                with self.subTest(ending=ending, more=more):
                    line = self.refused("turntable", SPHERE, *SMALL, "--frames", "2",
                                        "-o", "a." + ending, *more)
                    self.assertIn(REASON, line)
                    self.assertIn("frame####.png", line)

    def test_numbered_pictures_make_a_film(self):
        self.run_ok("turntable", SPHERE, *SMALL, "--frames", "3", "-o", "f##.png")
        self.run_ok("animate", SPHERE, *SMALL, "--frames", "2", "--turn", "90", "-o", "g#.exr")
        self.assertEqual(self.files(), ["f00.png", "f01.png", "f02.png", "g0.exr", "g1.exr"])
        for name in self.files():
            (self.folder / name).unlink()
        self.assertIn(REASON, self.refused("turntable", SPHERE, "-o", "f##.webp"))

    def test_the_help_offers_only_what_can_be_written(self):
        for command, works in (("render", ".png, .jpg, .exr, .bmp, .tga or .hdr"), ("turntable", "frames/f####.png")):
            text = " ".join(self.run_ok(command, "--help").out.split())
            self.assertIn(works, text)
            self.assertIn(REASON, text)
            offered = text.replace("no .webp or .tif: ", "").replace(
                "no .mp4, .webm, .mov, .mkv, .gif or .apng: ", "")
            for ending in (".webp", ".tif", ".mp4", ".webm", ".gif"):
                self.assertNotIn(ending, offered)
        self.assertNotIn(REASON, self.run_ok("mesh", "--help").out)


if __name__ == "__main__":
    main()
