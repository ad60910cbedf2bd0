"""Tests of pictures in other formats, of films and of shared sessions, with readers of others."""

import json
import subprocess

from zeroset_program import ProgramTest, read_png, run

TORUS = "(x^2 + y^2 + z^2 + 0.75)^2 = 4*(x^2 + y^2)"
SWEPT = "x^2 + y^2 + z^2 = a"
# (ending, codec, pixel format, frames)
FILMS = [("mp4", "h264", "yuv420p"), ("webm", "vp9", "yuv420p"), ("mov", "prores", "yuv444p12le"),
         ("mkv", "ffv1", "bgr0"), ("gif", "gif", "bgra"), ("apng", "apng", "rgb24")]


def probed(path, *entries):
    """What ffprobe says of the first stream, by the names of its entries."""
    done = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0",
                           "-show_entries", "stream=" + ",".join(entries), "-of", "json", path],
                          capture_output=True, check=True)
    return json.loads(done.stdout)["streams"][0]


class FilmTest(ProgramTest):
    def film(self, *arguments):
        return self.run_ok("turntable", TORUS, "--size", "64x48", "--frames", "10", *arguments)

    def test_films_are_what_ffprobe_expects(self):
        for ending, codec, pixels in FILMS:
            with self.subTest(ending=ending):
                name = "film." + ending
                self.film("-o", name, "--fps", "25")
                facts = probed(self.folder / name, "codec_name", "width", "height", "pix_fmt",
                               "nb_read_frames", "color_range", "color_space")
                self.assertEqual((facts["codec_name"], facts["width"], facts["height"]),
                                 (codec, 64, 48))
                self.assertEqual(facts["pix_fmt"], pixels)
                self.assertEqual(facts["nb_read_frames"], "10")
                if pixels.startswith("yuv"):
                    self.assertEqual((facts["color_range"], facts["color_space"]), ("tv", "bt709"))
        self.assertEqual(len(self.files()), len(FILMS), self.files())

    def test_a_film_plays_as_long_as_asked_for(self):
        self.run_ok("animate", SWEPT, "--sweep", "a=0.2..2", "--size", "32x32", "--seconds", "1.5",
                    "--fps", "20", "-o", "film.mp4")
        facts = probed(self.folder / "film.mp4", "duration", "r_frame_rate")
        self.assertAlmostEqual(float(facts["duration"]), 1.5, places=3)
        self.assertEqual(facts["r_frame_rate"], "20/1")

    def test_transparent_films(self):
        self.film("-o", "film.webm", "--alpha")
        facts = subprocess.run(["ffprobe", "-v", "error", "-show_entries", "stream_tags=alpha_mode",
                                "-of", "csv=p=0", self.folder / "film.webm"], capture_output=True,
                               check=True)
        self.assertEqual(facts.stdout.strip(), b"1")
        self.film("-o", "film.mov", "--alpha")
        self.assertIn("yuva444p", probed(self.folder / "film.mov", "pix_fmt")["pix_fmt"])

    def test_numbered_frames_can_be_shared_out_and_resumed(self):
        (self.folder / "f").mkdir()
        arguments = ["-o", "f/p###.png", "--resume", "--stats", "-"]
        first = json.loads(self.film(*arguments).out)
        self.assertEqual(first["drawn"], 10)
        names = sorted(path.name for path in (self.folder / "f").iterdir())
        self.assertEqual(names, [f"p{i:03}.png" for i in range(10)])
        whole = [(self.folder / "f" / name).read_bytes() for name in names]
        (self.folder / "f" / names[3]).unlink()
        (self.folder / "f" / names[5]).write_bytes(whole[6])
        (self.folder / "f" / names[7]).write_bytes(whole[7][:100])
        self.assertEqual(json.loads(self.film(*arguments).out)["drawn"], 3)
        self.assertEqual([(self.folder / "f" / name).read_bytes() for name in names], whole)
        part = self.run_ok("turntable", TORUS, "--size", "64x48", "--seconds", "1", "--fps", "10",
                           "--frames", "2..4", "-o", "g##.png")
        self.assertEqual(part.err, "")
        self.assertEqual([name for name in self.files() if name.startswith("g")],
                         ["g02.png", "g03.png", "g04.png"])
        self.assertEqual((self.folder / "g03.png").read_bytes(), whole[3])

    def test_blur_mixes_moments(self):
        arguments = ["animate", "x = a", "--sweep", "a=-1..1", "--end", "stop", "--frames", "3",
                     "--size", "64x64", "--box", "2"]
        self.run_ok(*arguments, "-o", "sharp#.png")
        self.run_ok(*arguments, "-o", "mixed#.png", "--blur", "8", "--shutter", "1")
        sharp, mixed = (read_png(self.folder / name) for name in ("sharp1.png", "mixed1.png"))
        self.assertGreater(len(mixed.colors()), len(sharp.colors()))

    def test_frame_ranges_change_no_picture(self):
        arguments = ["animate", "min((x-a)^2 + y^2 + z^2, x^2 + (y+a)^2 + z^4) = 0.3", "--turn",
                     "40", "--sweep", "a=0..0.8", "--frames", "14", "--size", "80x80", "--box",
                     "1.5", "--shadows", "--stats", "-"]
        pictures, told = {}, {}
        for choice in ("off", "auto", "1", "5"):
            done = self.run_ok(*arguments, "-o", choice + "##.png", "--frame-range", choice)
            told[choice] = json.loads(done.out)["frame_ranges"]
            pictures[choice] = [(self.folder / f"{choice}{i:02}.png").read_bytes()
                                for i in range(14)]
            self.assertEqual(pictures[choice], pictures["off"], choice)
        self.assertEqual((told["off"]["frames"], told["off"]["searches"]), (0, 0))
        self.assertEqual((told["1"]["frames"], told["1"]["searches"]), (14, 14))
        self.assertEqual((told["5"]["frames"], told["5"]["searches"]), (14, 3))
        self.assertGreater(told["auto"]["searches"], 0, "lengths are tried")
        turn = self.film("-o", "turn.mkv", "--frame-range", "2", "--stats", "-")
        self.assertEqual(json.loads(turn.out)["frame_ranges"]["searches"], 1,
                         "where only the camera moves one search is enough")
        other = self.film("-o", "other.mkv", "--frame-range", "2", "--tracer", "k-bisection",
                          "--stats", "-")
        self.assertEqual(json.loads(other.out)["frame_ranges"]["frames"], 0)

    def session_with_views(self):
        """Writes a session with two opposite views and one from aside; returns its name."""
        def view(name, eye, **more):
            return {"name": name, "eye": eye, "look_at": [0, 0, 0], "up": [0, 0, 1],
                    "fov_rad": 0.7, **more}
        session = {"zeroset": 1, "statements": [{"text": TORUS}],
                   "views": [view("front", [0, -9, 3]), view("the back", [0, 9, 3]),
                             view("aside", [9, 0, 1], projection="orthographic")]}
        (self.folder / "session.zeroset.json").write_text(json.dumps(session))
        return "session.zeroset.json"

    def test_a_saved_view_is_looked_from(self):
        session = self.session_with_views()
        shown = self.picture(session, "--view", "aside", "--size", "80x60")
        self.run_ok("render", TORUS, "--size", "80x60", "--camera",
                    "eye 9,0,1; look-at 0,0,0; fov 40.10704565915762", "--projection",
                    "orthographic", "--aa", "none", "-o", "same.png")
        self.assertEqual(shown.difference(read_png(self.folder / "same.png")), 0.0)
        self.assertGreater(shown.difference(self.picture(session, "--view", "front", "--size",
                                                         "80x60")), 0.05)
        self.assertIn("eye", self.run_ok("render", "--help").out)
        for arguments, words in (
                (["--view", "Front"], ["--view Front", "there are: front, the back, aside"]),
                (["--view", ""], ["--view"]),
                (["--camera", "front"], ["--camera front", "eye X,Y,Z"]),
                (["--camera", "eye 0,0,0"], ["--camera", "point looked at"]),
                (["--camera", "eye 1,2,3", "--view", "front"], ["--view", "--camera"])):
            with self.subTest(arguments=arguments):
                done = run("render", session, "-o", "wrong.png", *arguments, cwd=self.folder)
                self.assertEqual(done.code, 2, str(done))
                for word in words:
                    self.assertIn(word, done.err)
                self.assertNotIn("wrong.png", self.files())
        none = run("render", TORUS, "-o", "wrong.png", "--view", "front", cwd=self.folder)
        self.assertEqual((none.code, none.err.count("\n")), (2, 1), str(none))
        self.assertIn("no saved ones", none.err)

    def test_a_film_goes_through_saved_views(self):
        session = self.session_with_views()
        size = ["--size", "48x48"]
        film = ["animate", session, *size, "--frames", "5", "--end", "stop"]
        self.run_ok(*film, "--through", "front", "--through", " the back ", "-o", "a#.png")
        self.run_ok(*film, "--through", "eye 0,-9,3; look-at 0,0,0; fov 40.10704565915762",
                    "--through", "the back", "-o", "b#.png")
        self.run_ok(*film, "--through-views", "-o", "c#.png")
        frames = {name: [read_png(self.folder / f"{name}{i}.png") for i in range(5)]
                  for name in "abc"}
        for number, view in ((0, "front"), (4, "the back")):
            still = self.picture(session, *size, "--view", view)
            self.assertLess(frames["a"][number].difference(still, 2), 0.01, view)
        self.assertLess(frames["a"][2].difference(frames["b"][2], 2), 0.01)
        # It goes around the torus, not through it: half of the way shows it from aside.
        aside = self.picture(session, *size, "--camera", "eye 9,0,3; look-at 0,0,0; fov 40.107")
        other = self.picture(session, *size, "--camera", "eye -9,0,3; look-at 0,0,0; fov 40.107")
        self.assertLess(min(frames["a"][2].difference(aside, 40),
                            frames["a"][2].difference(other, 40)), 0.05)
        self.assertLess(frames["c"][4].difference(
            self.picture(session, *size, "--view", "aside"), 2), 0.01)
        for arguments, words in (
                (["--through", "front", "--through", "rear"],
                 ["--through rear", "there are: front, the back, aside"]),
                (["--through", "front"], ["two ends"]),
                (["--through", "front", "--through", "eye 1,2"], ["3 numbers"]),
                (["--through", "front", "--through-views"], ["--through-views"])):
            with self.subTest(arguments=arguments):
                done = run(*film, *arguments, "-o", "d#.png", cwd=self.folder)
                self.assertEqual((done.code, done.err.count("\n")), (2, 1), str(done))
                for word in words:
                    self.assertIn(word, done.err)
        few = run("animate", TORUS, "--through-views", "-o", "d#.png", cwd=self.folder)
        self.assertIn("0 saved views", few.err)

    def test_wrong_films(self):
        for arguments, words in (
                (["-o", "film.avi"], ["film.avi", ".mp4", "####"]),
                (["-o", "film.mp4", "--size", "65x48"], ["66x48"]),
                (["-o", "film.mp4", "--alpha"], ["transparent", ".webm"]),
                (["-o", "film.gif", "--fps", "60"], ["50"]),
                (["-o", "film.mp4", "--fps", "0"], ["--fps"]),
                (["-o", "film.mp4", "--resume"], ["--resume", "####"]),
                (["-o", "film.gif", "--quality", "50"], ["--quality"]),
                (["-o", "film.mp4", "--frames", "3..99", "--seconds", "1"], ["--frames"]),
                (["-o", "film.mp4", "--frames", "3", "--seconds", "1"], ["--seconds"]),
                (["-o", "film.mp4", "--seconds", "0"], ["--seconds"]),
                (["-o", "film.mp4", "--sweep", "b=0..1"], ["--sweep", "no parameter b"]),
                (["-o", "film.mp4", "--sweep", "a=0"], ["--sweep", "FROM..TO"]),
                (["-o", "film.mp4", "--axis", "0,0,0"], ["--axis"]),
                (["-o", "film.mp4", "--through", "eye 1,2,3"], ["--through"]),
                (["-o", "film.mp4", "--end", "never"], ["--end", "bounce"]),
                (["-o", "film.mp4", "--ease", "odd"], ["--ease", "smooth"]),
                (["-o", "film.mp4", "--blur", "0"], ["--blur"]),
                (["-o", "film.mp4", "--shutter", "2"], ["--shutter"]),
                (["-o", "film.mp4", "--frame-range", "0"], ["--frame-range", "1"]),
                (["-o", "film.mp4", "--frame-range", "2.5"], ["--frame-range", "auto", "off"]),
                (["-o", "film.mp4", "--frame-range", "on"], ["--frame-range", "auto", "off"])):
            with self.subTest(arguments=arguments):
                done = run("turntable", SWEPT, *arguments, cwd=self.folder)
                self.assertEqual(done.code, 2, str(done))
                self.assertEqual(done.err.count("\n"), 1, done.err)
                for word in words:
                    self.assertIn(word, done.err)
                self.assertEqual(self.files(), [])
        still = run("animate", SWEPT, "-o", "film.mp4", cwd=self.folder)
        self.assertIn("nothing changes", still.err)
        nowhere = run("turntable", SWEPT, "-o", "none/film.mp4", cwd=self.folder)
        self.assertEqual(nowhere.code, 1, str(nowhere))
        self.assertIn("none", nowhere.err)


class FormatTest(ProgramTest):
    def test_pictures_that_others_read(self):
        for ending, codec, pixels in (("jpg", "mjpeg", "yuvj444p"), ("webp", "webp", "yuv420p"),
                                      ("tif", "tiff", "rgb24"), ("png", "png", "rgb24"),
                                      ("bmp", "bmp", "bgr24"), ("tga", "targa", "bgr24"),
                                      ("exr", "exr", "gbrapf32le")):
            name = "picture." + ending
            self.run_ok("render", TORUS, "--size", "90x60", "-o", name)
            facts = probed(self.folder / name, "codec_name", "width", "height", "pix_fmt")
            self.assertEqual((facts["codec_name"], facts["width"], facts["height"]),
                             (codec, 90, 60))
            self.assertIn(facts["pix_fmt"], (pixels, "argb", "bgra", "yuva420p", "rgb24"))
        self.run_ok("render", TORUS, "--size", "90x60", "-o", "deep.png", "--bits", "16", "--alpha")
        self.assertEqual(probed(self.folder / "deep.png", "pix_fmt")["pix_fmt"], "rgba64be")

    def test_exr_has_its_layers(self):
        self.run_ok("render", TORUS, "--size", "90x60", "-o", "picture.exr")
        header = subprocess.run(["exrheader", self.folder / "picture.exr"], capture_output=True,
                                check=True).stdout.decode()
        for layer in ("A", "R", "depth.Z", "position.X", "normal.Z", "certificate.id", "surface.id",
                      "opacity.A"):
            self.assertIn(f"\n    {layer}, 32-bit", header)
        self.assertIn("(0 0) - (89 59)", header)

    def test_a_large_picture_has_the_pixels_of_its_bands(self):
        """A picture drawn in bands shows what a small one does."""
        self.run_ok("render", TORUS, "--size", "5000x4000", "-o", "large.png", "--stats", "s.json",
                    "--axes")
        facts = probed(self.folder / "large.png", "width", "height", "pix_fmt")
        self.assertEqual((facts["width"], facts["height"]), (5000, 4000))
        stats = json.loads((self.folder / "s.json").read_text(encoding="utf-8"))
        self.assertEqual(stats["certified"] + stats["undecided"] + stats["miss"], 20_000_000)
        small = json.loads(self.run_ok("render", TORUS, "--size", "500x400", "--axes", "--stats",
                                        "-").out)
        self.assertAlmostEqual(stats["certified"] / 100, small["certified"],
                               delta=0.01 * small["certified"])

    def test_a_session_in_a_picture_and_in_a_line(self):
        options = ["--set", "a=1.5", "--eye", "3,2,1", "--look", "clay"]
        self.run_ok("render", SWEPT, *options, "--size", "80", "-o", "first.png")
        self.run_ok("render", "first.png", "--size", "80", "-o", "second.png")
        line = self.run_ok("share", SWEPT, *options).out
        self.assertEqual(line.count("\n"), 1)
        self.assertTrue(line.startswith("zeroset:"))
        self.run_ok("render", line, "--size", "80", "-o", "third.png")
        files = [(self.folder / name).read_bytes()
                 for name in ("first.png", "second.png", "third.png")]
        self.assertEqual(files[1], files[0])
        self.assertEqual(files[2], files[0])
        for wrong, word in ((line[:-20], "damaged"), ("zeroset:%", "damaged")):
            done = run("render", wrong, "-o", "x.png", cwd=self.folder)
            self.assertEqual(done.code, 2)
            self.assertIn(word, done.err)
        self.run_ok("render", SWEPT, "--size", "8", "-o", "bare.png", "--no-session")
        done = run("render", "bare.png", "-o", "x.png", cwd=self.folder)
        self.assertEqual(done.code, 2)
        self.assertIn("holds no session", done.err)
