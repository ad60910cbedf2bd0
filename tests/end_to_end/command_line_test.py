"""Tests of the command line's contract: what each subcommand writes, prints and refuses."""

import json
import math
from collections import Counter

from command_line_bench_cases import BenchTest, CompareTest
from command_line_budget_cases import BudgetTest, SignalTest
from command_line_depth_cases import DepthTest
from command_line_error_cases import UnwritableTest, WrongInputTest
from command_line_explain_cases import ExplainTest
from command_line_film_cases import FilmTest, FormatTest
from command_line_film_pixels_cases import FilmPixelsTest
from command_line_lost_file_cases import LostFileTest
from command_line_mesh_cases import MeshTest
from command_line_notes_cases import NotesTest
from command_line_octree_cases import OctreeTest
from command_line_start_cases import StartTest
from command_line_volume_cases import VolumeTest
from rays import Box, Camera, Sphere
from zeroset_program import SOURCE_DIR, ProgramTest, main, read_pfm, read_png, run

# The test cases that unittest runs from here, imported ones included.
__all__ = ["BenchTest", "BudgetTest", "CompareTest", "DepthTest", "ExplainTest", "FilmPixelsTest",
           "FilmTest", "FormatTest", "LostFileTest", "MeshTest", "NotesTest", "OctreeTest",
           "SignalTest", "StartTest", "UnwritableTest", "VolumeTest", "WrongInputTest"]

SPHERE = "x^2 + y^2 + z^2 = 1"
STATS_KEYS = {"width", "height", "threads", "tracer", "compile_ms", "machine_code", "precision",
              "frame_ms", "writing_ms", "certified", "certified_coarse", "coarse_width",
              "contour_step", "unproved_shadows", "undecided", "miss", "jumps",
              "undecided_not_drawn", "undecided_by_budget", "certified_width", "surfaces",
              "evaluations"}


class RenderTest(ProgramTest):
    def stats(self, *arguments, **how):
        result = self.run_ok("render", *arguments, "--stats", "-", **how)
        return json.loads(result.out)

    def test_picture_has_the_size_asked_for(self):
        for width, height in ((33, 17), (1, 1), (64, 65), (130, 3)):
            with self.subTest(width=width, height=height):
                image = self.picture(SPHERE, "--size", f"{width}x{height}")
                self.assertEqual((image.width, image.height), (width, height))

    def test_default_size(self):
        image = self.picture(SPHERE, "--dstop", 8)
        self.assertEqual((image.width, image.height), (1024, 1024))
        self.assertGreater(len(image.colors()), 100)

    def test_hits_are_drawn_before_the_background(self):
        """The picture differs from an empty one just where the depth is finite."""
        arguments = ["--size", "48x40", "--box", "2", "--aa", "none"]
        depth = self.depth(SPHERE, *arguments)
        ball, empty = (self.picture(text, *arguments) for text in (SPHERE, "x = 1000"))
        for col, row, distance in depth.pixels():
            self.assertEqual(ball.at(col, row) != empty.at(col, row), distance != math.inf,
                             (col, row))
        self.assertGreater(depth.hits(), 50)

    def test_misses_are_infinite_and_rows_come_from_the_bottom(self):
        depth = self.depth("x^2 + y^2 + (z-1.2)^2 = 0.25", "--size", "32x32")
        rows = {row for _, row, distance in depth.pixels() if distance != math.inf}
        self.assertTrue(rows and max(rows) < 16, rows)
        file_rows = (self.folder / "depth.pfm").read_bytes()[-32 * 32 * 4:]
        self.assertEqual(file_rows[:32 * 4], b"\x00\x00\x80\x7f" * 32)
        self.assertEqual(set(self.depth("x = 1000", "--size", "9x7").values), {math.inf})

    def test_stats(self):
        stats = self.stats(SPHERE, "--size", "50x40", "--threads", 1)
        self.assertEqual(set(stats), STATS_KEYS)
        self.assertEqual((stats["width"], stats["height"], stats["threads"]), (50, 40, 1))
        self.assertEqual(stats["tracer"], "beams")
        self.assertEqual(stats["certified"] + stats["undecided"] + stats["miss"], 50 * 40)
        hits = stats["certified"] + stats["undecided"] - stats["undecided_not_drawn"]
        self.assertEqual(stats["surfaces"], [{"pixels": hits}])
        self.assertGreater(stats["certified"], 50)
        self.assertGreater(stats["compile_ms"], 0)
        self.assertEqual(set(stats["frame_ms"]), {"median", "min", "max", "repeats"})
        self.assertEqual(stats["frame_ms"]["repeats"], 1)
        self.assertEqual(set(stats["evaluations"]), {"range", "value", "form"})
        self.assertGreater(stats["evaluations"]["form"], 8)
        self.assertGreaterEqual(stats["evaluations"]["value"], stats["certified"])
        packets = self.stats(SPHERE, "--size", "50x40", "--tracer", "k-bisection")
        self.assertEqual(packets["evaluations"]["form"], 0)
        self.assertGreater(packets["evaluations"]["range"], packets["certified"])

    def test_certified_width(self):
        """The width is four cells of the finest bisection; unknown if the stop rule is no width."""
        small = (SPHERE, "--size", 8, "--box", 2)
        self.assertEqual(self.stats(*small, "--dstop", 10)["certified_width"], 4 * 4 / 1024)
        self.assertEqual(self.stats(*small, "--dstop", 12)["certified_width"], 4 * 4 / 4096)
        self.assertIsNone(self.stats(*small, "--delta", 0.1)["certified_width"])
        far = self.stats("z = 1000.5", "--size", 16, "--box", "1000,1001,1000,1001,1000,1001")
        self.assertEqual(far["precision"], "double")
        self.assertEqual(far["certified_width"], 4 / 2**22)
        self.assertGreater(far["certified"], 20)

    def test_stats_in_a_file_agree_with_the_depths(self):
        self.run_ok("render", SPHERE, "--size", "40x30", "--stats", "s.json", "--depth", "d.pfm")
        stats = json.loads((self.folder / "s.json").read_text(encoding="utf-8"))
        hits = read_pfm(self.folder / "d.pfm").hits()
        self.assertLessEqual(stats["certified"], hits)
        self.assertLessEqual(hits, stats["certified"] + stats["undecided"])
        self.assertEqual(self.files(), ["d.pfm", "s.json"])

    def test_jumps_where_they_are_asked_for(self):
        step = "if(x^2 + y^2 + z^2 < 1, -1, z + 3)"
        self.assertEqual(self.stats(step, "--size", 32)["jumps"], 0)
        drawn = self.stats(step, "--size", 32, "--jumps")
        self.assertGreater(drawn["jumps"], 40)
        self.assertEqual(drawn["certified"] + drawn["undecided"], 0)
        done = run("render", step, "--jumps", "--tracer", "k-bisection", "--stats", "-")
        self.assertEqual(done.code, 2)
        self.assertIn("only the tracer beams finds jumps", done.err)

    def test_certificates_in_colours(self):
        """The numbers of green, amber, red and black pixels agree with the statistics."""
        stats = self.stats("1/(1/x) = 0; z = sign(x)", "--size", "60x60", "--dstop", 12, "--certificate",
                           "c.png")
        image = read_png(self.folder / "c.png")
        counts = Counter(image.at(col, row) for row in range(60) for col in range(60))
        self.assertEqual(counts[(60, 168, 82)], stats["certified"])
        undecided = counts[(242, 169, 31)] + counts[(224, 59, 59)]
        self.assertEqual(undecided, stats["undecided"])
        self.assertEqual(counts[(224, 59, 59)], stats["undecided_not_drawn"])
        self.assertGreater(counts[(224, 59, 59)], 0, "the hole at x = 0 is undecided, not drawn")
        self.assertEqual(counts[(0, 0, 0)], stats["miss"])

    def test_repeat(self):
        frame = self.stats(SPHERE, "--size", "32x32", "--repeat", 4)["frame_ms"]
        self.assertEqual(frame["repeats"], 4)
        self.assertTrue(0 < frame["min"] <= frame["median"] <= frame["max"], frame)

    def test_same_depths_whatever_the_threads_and_repeats(self):
        """Depths agree to the last bit, except that the code for many frames rounds differently."""
        once, often = [], []
        for depths, options in ((once, ["--threads", 1]), (once, ["--threads", 2]), (once, []),
                                (often, ["--threads", 1, "--repeat", 1]),
                                (often, ["--threads", 2, "--repeat", 2])):
            depths.append(self.depth("@tangle", "--size", "150x130", "--dstop", 12, *options))
        for depths in (once, often):
            self.assertEqual([depths[0].values] * len(depths),
                             [depth.values for depth in depths])
        self.assertGreater(once[0].hits(), 4000)
        for one, other in zip(once[0].values, often[0].values):
            self.assertTrue(one == other or abs(one - other) < 2e-6 * one, (one, other))

    def test_looks_change_the_picture_only(self):
        pictures, depths = set(), []
        for options in (["--aa", "none"], ["--shadows", "--aa", "none"], ["--aa", "16"], [],
                        ["--shadows", "--aa", "iaa"]):
            depths.append(self.depth("@tangle", "--size", "80x60", "-o", "out.png",
                                     *options).values)
            pictures.add((self.folder / "out.png").read_bytes())
        self.assertEqual(len(pictures), 5)
        self.assertEqual([depths[0]] * 3, depths[:3])
        # Cells that hold whole pixels find the same roots, but not bit by bit.
        self.assertEqual(depths[3], depths[4])
        for one, other in zip(depths[0], depths[3]):
            self.assertTrue(one == other or abs(one - other) < 2e-6 * one, (one, other))

    def test_looks_lights_and_lines_change_the_colours_only(self):
        depths, pictures = [], set()
        for options in ([], ["--look", "matte"], ["--look", "porcelain"], ["--look", "metal"],
                        ["--look", "glass"], ["--look", "clay"], ["--look", "technical"],
                        ["--reflections", 2], ["--opacity", 0.5], ["--tone", "filmic"],
                        ["--light", "1,2,3; power 1"], ["--contours", "height"],
                        ["--contours", "x y; step 0.5"], ["--background", "#FFFFFF"]):
            depths.append(self.depth("@tangle", "--size", "80x60", "-o", "out.png",
                                     *options).values)
            pictures.add((self.folder / "out.png").read_bytes())
        self.assertEqual(len(pictures), len(depths))
        self.assertEqual([depths[0]] * len(depths), depths)

    def test_a_background_may_be_transparent(self):
        for options, colour_type in (([], 2), (["--alpha"], 6)):
            self.depth("@sphere", "--size", "80x60", "-o", "out.png", "--aa", "iaa", *options)
            self.assertEqual((self.folder / "out.png").read_bytes()[25], colour_type)

    def test_edges_are_smooth_unless_they_are_not_wanted(self):
        pictures = {}
        for options in ((), ("--aa", "iaa"), ("--aa", "none"), ("--no-antialias",)):
            self.depth("@sphere", "--size", "80x60", "-o", "out.png", *options)
            pictures[options] = (self.folder / "out.png").read_bytes()
        self.assertEqual(pictures[()], pictures["--aa", "iaa"])
        self.assertEqual(pictures["--aa", "none"], pictures["--no-antialias",])
        self.assertNotEqual(pictures[()], pictures["--aa", "none"])

    def test_a_document_keeps_its_look(self):
        file = self.folder / "look.zeroset.json"

        def picture(look, *options):
            file.write_text(json.dumps({"zeroset": 1, "look": look, "statements": [
                {"text": "x^2 + y^2 + z^2 = 1"}, {"text": "z = -1.5"}]}))
            self.depth(file, "--size", "80x60", "-o", "out.png", *options)
            return (self.folder / "out.png").read_bytes()

        plain = picture({})
        both = picture({"shadows": True, "antialias": True})
        self.assertEqual(picture({"shadows": True}, "--antialias"), both)
        self.assertEqual(picture({}, "--shadows", "--antialias"), both)
        self.assertEqual(picture({"shadows": True}, "--no-shadows"), plain)
        self.assertEqual(len({plain, both, picture({"shadows": True})}), 3)

    def look(self, *options):
        """Returns the file of a small picture of a ball with a parameter."""
        result = run("render", "x^2 + y^2 + z^2 = a", "--size", "240x180", "-o", "out.png",
                     "--no-session", *options, cwd=self.folder)
        self.assertEqual(result.code, 0, result)
        return (self.folder / "out.png").read_bytes()

    def test_the_solid_is_that_of_the_surface_itself(self):
        """A restriction that leaves nothing at the box's faces does not change the solid side."""
        ball, cut = "1 - x^2 - y^2 - z^2", ["--size", "80x60", "--section", "x=0"]
        whole = self.depth(ball, *cut).values
        self.assertEqual(self.depth(f"{ball} = 0, x^2 + y^2 + z^2 < 3", *cut).values, whole)
        self.assertEqual(self.depth(ball, *cut, "--solid", "f>0").values, whole)
        other = self.depth(ball, *cut, "--solid", "1:f<0").values
        self.assertNotEqual(other, whole)
        file = self.folder / "solid.zeroset.json"
        file.write_text(json.dumps({"zeroset": 1, "statements": [
            {"text": ball, "solid": "f<0"}]}), encoding="utf-8")
        self.assertEqual(self.depth(file, *cut).values, other)

    def test_colors_tell_numbers(self):
        modes = ["plain", "normal", "height", "depth", "mean-curvature", "gaussian-curvature",
                 "gradient", "x + a w"]
        pictures = {mode: self.look("--color-by", mode, "--w", 2, "--set", "a=1.5")
                    for mode in modes}
        self.assertEqual(pictures["plain"], self.look("--w", 2, "--set", "a=1.5"))
        # Curvature and slope of a ball are constant: one colour, but each with its own legend.
        self.assertEqual(len(set(pictures.values())), len(modes))
        self.assertNotEqual(self.look("--color-by", "height"),
                            self.look("--color-by", "height", "--color-map", "ember"))
        self.assertEqual(self.look("--color-by", "z", "--color-range", "-1,2", "--no-legend"),
                         self.look("--color-by", "height", "--color-range", "-1,2", "--no-legend"))
        self.assertNotEqual(self.look("--color-by", "height", "--no-legend"),
                            self.look("--color-by", "height"))
        self.assertEqual(self.look("--color-by", "height", "--color-range", "auto"),
                         self.look("--color-by", "height"))

    def test_marks_are_drawn(self):
        plain, one = self.look(), self.look("--mark", "0,-1,0")
        two = self.look("--mark", "0,-1,0", "--mark", "-0.1,-0.9,0.4")
        self.assertEqual(len({plain, one, two}), 3)
        self.assertEqual(self.look("--mark", "0,100,0"), plain)

    def test_labels_of_points_and_axes_are_drawn(self):
        marked, labelled = self.look("--mark", "0,-1,0"), self.look("--mark", "0,-1,0; label P")
        self.assertNotEqual(marked, labelled)
        axes, named = self.look("--axes"), self.look("--axes", "--axis-names", "u,v,t")
        self.assertNotEqual(axes, named)
        self.assertEqual(self.look("--axes", "--axis-names", "x,y,z"), axes)

    def test_a_textbooks_lines_are_axes_box_and_grid(self):
        self.assertEqual(self.look("--textbook"), self.look("--axes", "--clip-box", "--grid"))
        self.assertEqual(self.look("--textbook", "--no-grid"), self.look("--axes", "--clip-box"))
        self.assertNotEqual(self.look("--textbook"), self.look())

    def test_axes_are_dark_on_a_light_background(self):
        light, dark = ("--background", "#FFFFFF"), ("--background", "#000000")
        for options, color in ((light, (0xC4, 0x2F, 0x2F)), (dark, (0xF2, 0x66, 0x5C))):
            self.look("--axes", *options)
            pixels = read_png(self.folder / "out.png")
            near = sum(max(abs(a - b) for a, b in zip(pixels.at(col, row), color)) < 12
                       for row in range(pixels.height) for col in range(pixels.width))
            self.assertGreater(near, 10, f"pixels of the axis x on {options}")

    def test_probe_says_what_a_pixel_shows(self):
        camera = Camera.default(Box.of(2))
        result = run("render", "z = 5; x^2 + y^2 + z^2 = 1", "--size", "64x64", "--probe", "32,32",
                     "--probe", "0,63", *camera.options())
        self.assertEqual((result.code, result.err), (0, ""), result)
        hit, miss = map(json.loads, result.out.splitlines())
        distance = Sphere().roots(camera.ray(32, 32, 64, 64), 0.0, math.inf)[0]
        self.assertAlmostEqual(hit["distance"], distance, delta=1e-13)
        self.assertAlmostEqual(sum(x * x for x in hit["point"]), 1.0, delta=1e-13)
        for normal, point in zip(hit["normal"], hit["point"]):
            self.assertAlmostEqual(normal, point, delta=1e-13)
        self.assertLess(abs(hit["f"]), 1e-13)
        self.assertTrue(hit["proved"] and hit["within"] < 1e-12, hit)
        self.assertEqual((hit["col"], hit["row"], hit["certificate"], hit["surface"]),
                         (32, 32, "certified", 2))
        self.assertEqual(hit["reading"], "x^2 + y^2 + z^2 - 1 = 0")
        self.assertEqual(miss, {"col": 0, "row": 63, "hit": False})

    def test_a_document_keeps_colors_and_markers(self):
        file = self.folder / "marked.zeroset.json"
        statements = [{"text": "x^2 + y^2 + z^2 = a"}]
        file.write_text(json.dumps({
            "zeroset": 1, "statements": statements, "look": {"antialias": True},
            "color": {"by": "height", "range": [-1, 1]},
            "markers": [{"number": 1, "at": [0, -1, 0]}]}))
        result = run("render", file, "--size", "240x180", "-o", "document.png", "--no-session",
                     cwd=self.folder)
        self.assertEqual(result.code, 0, result)
        self.assertEqual((self.folder / "document.png").read_bytes(),
                         self.look("--color-by", "height", "--color-range", "-1,1", "--mark",
                                   "0,-1,0"))

    def error_of(self, *options):
        """Returns the number of hits, and the largest depth error of clear ones, of a sphere."""
        camera, worst = Camera.default(Box.of(2)), 0.0
        depth = self.depth(SPHERE, "--size", "40x40", *camera.options(), *options)
        for col, row, got in depth.pixels():
            ray = camera.ray(col, row, 40, 40)
            roots = Sphere().roots(ray, 0.0, math.inf)
            if len(roots) == 2 and roots[1] - roots[0] > 0.6:
                self.assertNotEqual(got, math.inf)
                worst = max(worst, abs(got - roots[0]))
        return depth.hits(), worst

    def test_epsilon_and_delta_refine(self):
        packets = ("--tracer", "k-bisection")
        for option, values, last in (("--epsilon", (0.5, 0.05, 0.005), 0.01),
                                     ("--delta", (0.5, 0.05, 0.005), 0.005)):
            with self.subTest(option):
                hits, errors = zip(*(self.error_of(option, value, *packets) for value in values))
                self.assertEqual(sorted(errors, reverse=True), list(errors))
                self.assertEqual(sorted(hits, reverse=True), list(hits))
                self.assertLess(errors[-1], last)
                self.assertGreater(errors[0], 5 * errors[-1])

    def test_beams_are_within_epsilon_and_delta(self):
        for option, value in (("--epsilon", 0.05), ("--delta", 0.05)):
            with self.subTest(option):
                self.assertLess(self.error_of(option, value)[1], 0.05)

    def test_tracer_by_name(self):
        self.assertEqual(self.stats(SPHERE, "--size", 8, "--tracer", "k-bisection")["tracer"],
                         "k-bisection")

    def test_w(self):
        hits = [self.depth("x^2 + y^2 + z^2 + w^2 = 1", "--size", 32, "--w", w).hits()
                for w in (0, -0.6, 0.8, 1.5)]
        self.assertGreater(hits[0], hits[1])
        self.assertGreater(hits[1], hits[2])
        self.assertEqual(hits[3], 0)

    def test_equation_from_the_gallery_and_from_standard_input(self):
        box = ("--box", "1.5", "--size", 40)  # the item's own; --box resets its view
        by_name = self.picture("@sphere", *box)
        typed = self.picture("-", *box, stdin="x^2 + y^2 +\n z^2 - 1\n")
        self.assertEqual(by_name.rgb, typed.rgb)

    def test_equation_that_starts_with_a_minus_sign(self):
        for text in ("-x^2+y", "-1*x^2+y", "- x^2 + y"):
            depth = self.depth(text, "--size", 24)
            self.assertEqual(depth.values, self.depth("y = x^2", "--size", 24).values, text)
            self.assertGreater(depth.hits(), 50)
            self.assertIn("read as", self.run_ok("explain", text).out)


class GalleryTest(ProgramTest):
    def items(self):
        for path in sorted((SOURCE_DIR / "resources" / "gallery").glob("*.json")):
            yield from json.loads(path.read_text(encoding="utf-8"))["items"]

    def test_lists_all_with_a_sentence_and_a_source(self):
        text = self.run_ok("gallery").out
        for item in self.items():
            for key in ("name", "equation", "about", "source"):
                self.assertGreater(len(item[key]), 2, item["name"])
                self.assertIn(item[key], text, item["name"])
            self.assertRegex(item["about"], r"[.!]$", item["name"])
        self.assertGreaterEqual(sum(1 for _ in self.items()), 29 + 12)

    def test_names_and_json(self):
        names = self.run_ok("gallery", "--names").out.split()
        self.assertEqual(sorted(names), sorted(item["name"] for item in self.items()))
        listed = json.loads(self.run_ok("gallery", "--json").out)
        self.assertEqual([item["name"] for item in listed], names)


class HelpTest(ProgramTest):
    def test_version_is_one_line(self):
        self.assertRegex(self.run_ok("--version").out, r"\Azeroset \d+\.\d+\.\d+\n\Z")

    def test_help_names_every_subcommand(self):
        text = self.run_ok("--help").out
        for word in ("render", "draw", "gallery", "explain", "dev", "EQUATION"):
            self.assertIn(word, text)
        for command in ("render", "draw", "gallery", "explain"):
            self.assertIn("--help", self.run_ok(command, "--help").out)

    def test_tools_stand_behind_dev(self):
        tools = ("bench", "ui-shot", "latency", "compare", "traversal")
        text = self.run_ok("dev", "--help").out
        for tool in tools:
            self.assertIn(f"\n  {tool} ", text)
            self.assertIn("--help", self.run_ok("dev", tool, "--help").out)
            self.assertNotIn(f"\n  {tool} ", self.run_ok("--help").out)
        self.assertIn("subcommand", run("dev").err)
        self.assertEqual(self.run_ok("bench", "--help").out, self.run_ok("dev", "bench", "--help").out)

    def test_the_page_of_the_command_line_is_the_one_in_the_documents(self):
        page = SOURCE_DIR / "resources" / "docs" / "command-line.md"
        self.assertEqual(self.run_ok("command-line").out, page.read_text(encoding="utf-8"),
                         f"write it anew: zeroset command-line > {page}")

    def test_help_shows_what_matters_first_in_lines_that_fit(self):
        text = self.run_ok("render", "--help").out
        groups = [line for line in text.splitlines() if line.endswith(":") and line[0] != " "]
        self.assertEqual(groups[:4], ["Positionals:", "Often used:", "Camera:", "Clip:"])
        first = text[text.index("Often used:"):text.index("Camera:")]
        for option in ("--output", "--size", "--box", "--set", "--fit", "--section", "--look",
                       "--color-by", "--shadows", "--aa"):
            self.assertIn(option, first)
        self.assertLessEqual(max(map(len, text.splitlines())), 100)


if __name__ == "__main__":
    main()
