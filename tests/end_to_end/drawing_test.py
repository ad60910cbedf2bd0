"""Drawings in lines as files, and against the depths of pictures of the same view."""

import json
import math
import re
import xml.etree.ElementTree as ET

from zeroset_program import ProgramTest, main, run

SVG = "{http://www.w3.org/2000/svg}"
KINDS = ("silhouette", "crease", "boundary", "intersection", "contour")
SIZE = 200  # points, and pixels of the pictures


def numbers(text):
    return [float(number) for number in re.findall(r"-?\d+(?:\.\d+)?", text)]


class Path:
    """A path of an SVG file: its Bezier curves by their control points."""

    def __init__(self, element, kind, hidden):
        self.kind = kind
        self.hidden = hidden
        self.surface = int(element.get("class").removeprefix("surface-"))
        data = element.get("d")
        assert re.fullmatch(r"M[-\d. ]+(C[-\d. ]+)+Z?", data), data
        self.closed = data.endswith("Z")
        values = numbers(data)
        places = list(zip(values[0::2], values[1::2]))
        self.pieces = [places[i:i + 4] for i in range(0, len(places) - 1, 3)]

    def points(self, spacing=0.5):
        """Returns points along the path, no farther apart than `spacing`."""
        result = []
        for a, b, c, d in self.pieces:
            length = math.dist(a, b) + math.dist(b, c) + math.dist(c, d)
            count = max(1, math.ceil(length / spacing))
            for i in range(count + 1):
                t = i / count
                weights = ((1 - t)**3, 3 * t * (1 - t)**2, 3 * t * t * (1 - t), t**3)
                result.append(tuple(sum(w * p[k] for w, p in zip(weights, (a, b, c, d)))
                                    for k in (0, 1)))
        return result


class DrawingTest(ProgramTest):
    def svg(self, *arguments, **how):
        """Returns the root element and the paths of `zeroset draw ARGUMENTS`."""
        self.run_ok("draw", *arguments, "-o", "drawing.svg", **how)
        root = ET.parse(self.folder / "drawing.svg").getroot()
        self.assertEqual(root.tag, SVG + "svg")
        paths = []
        ids = set()
        for group in root:
            state, kind = group.get("id").split("-")
            self.assertIn(state, ("visible", "hidden"))
            self.assertIn(kind, KINDS)
            self.assertNotIn(group.get("id"), ids)
            ids.add(group.get("id"))
            paths += [Path(path, kind, state == "hidden") for path in group]
        return root, paths


class FileTest(DrawingTest):
    def test_svg_has_the_size_asked_for(self):
        for size, width, height, unit in (("300x200", 300, 200, 1), ("120x90mm", 120, 90, 72 / 25.4),
                                          ("4x3in", 4, 3, 72), ("10.5x7cm", 10.5, 7, 72 / 2.54)):
            root, paths = self.svg("x^2 + y^2 + z^2 = 1", "--size", size)
            self.assertEqual(len(paths), 1, size)
            self.assertRegex(root.get("width"), r"^[\d.]+pt$")
            self.assertAlmostEqual(float(root.get("width")[:-2]), width * unit, delta=1e-3)
            self.assertAlmostEqual(float(root.get("height")[:-2]), height * unit, delta=1e-3)
            self.assertEqual(numbers(root.get("viewBox"))[2:],
                             [float(root.get("width")[:-2]), float(root.get("height")[:-2])])

    def test_pdf_has_a_page_and_a_table_of_its_objects(self):
        self.run_ok("draw", "@torus", "-o", "torus.pdf", "--size", "300x200", "--hidden", "dash")
        data = (self.folder / "torus.pdf").read_bytes()
        self.assertTrue(data.startswith(b"%PDF-1."))
        self.assertIn(b"/MediaBox [ 0 0 300 200 ]", data)
        start = int(re.search(rb"startxref\s+(\d+)\s+%%EOF", data).group(1))
        self.assertTrue(data[start:].startswith(b"xref"))
        entries = re.findall(rb"(\d{10}) \d{5} n", data[start:])
        self.assertGreater(len(entries), 3)
        for number, offset in enumerate(entries, 1):
            self.assertTrue(data[int(offset):].startswith(b"%d 0 obj" % number))

    def test_tikz_is_one_picture(self):
        self.run_ok("draw", "@torus", "-o", "torus.tex", "--hidden", "dash")
        text = (self.folder / "torus.tex").read_text(encoding="utf-8")
        self.assertEqual(text.count("\\begin{tikzpicture}"), 1)
        self.assertTrue(text.endswith("\\end{tikzpicture}\n"))
        self.assertEqual(text.count("\\begin{scope}"), text.count("\\end{scope}"))
        self.assertGreater(text.count("\\draw"), 2)

    def test_axes_are_lines_and_letters(self):
        drawing = ("z = sin(x) cos(y)", "--box", "3.3", "--textbook", "--axis-names", "length,y,a&b",
                   "--mark", "0,0,0; label 50 %")
        for ending in ("svg", "tex", "pdf"):
            self.run_ok("draw", *drawing, "-o", "axes." + ending)
            self.run_ok("draw", *drawing, "--no-textbook", "-o", "plain." + ending)
        root = ET.parse(self.folder / "axes.svg").getroot()
        groups = {group.get("id"): group for group in root}
        words = {text.text for text in groups["labels"]}
        self.assertLessEqual({"length", "y", "a&b", "50 %", "0", "\u2212\u03c0"}, words)
        self.assertGreater(len(groups["axes"]), 30)
        colors = {line.get("stroke") for line in groups["axes"]}
        self.assertEqual(len(colors), 6, "three axes, box, grid and the marker")
        for text in groups["labels"]:
            self.assertTrue(0 < float(text.get("x")) < 400 and 0 < float(text.get("y")) < 400)
        plain = ET.parse(self.folder / "plain.svg").getroot()
        self.assertEqual({text.text for group in plain if group.get("id") == "labels"
                          for text in group}, {"50 %"})
        tex = (self.folder / "axes.tex").read_text(encoding="utf-8")
        for word in ("{length}", "{$y$}", "{a\\&b}", "{50 \\%}", "{$0$}", "{$-\\pi $}"):
            self.assertIn(word, tex)
        self.assertTrue(tex.isascii())
        self.assertIn(b"/FontFile2", (self.folder / "axes.pdf").read_bytes())

    def test_hidden_lines(self):
        spheres = "(x-1)^2 + (y+1.6)^2 + z^2 = 0.5; x^2 + y^2 + z^2 = 1"
        dashed = self.svg(spheres, "--box", 2, "--hidden", "dash")
        removed = self.svg(spheres, "--box", 2)
        shown = self.svg(spheres, "--box", 2, "--hidden", "show")
        self.assertTrue(any(path.hidden for path in dashed[1]))
        self.assertFalse(any(path.hidden for path in removed[1]))
        self.assertTrue(all(("stroke-dasharray" in group.attrib) ==
                            group.get("id").startswith("hidden") for group in dashed[0]))
        self.assertFalse(any("stroke-dasharray" in group.attrib for group in shown[0]))
        visible = [path.pieces for path in dashed[1] if not path.hidden]
        self.assertEqual(visible, [path.pieces for path in removed[1]])

    def test_lines_that_are_asked_for(self):
        text = "max(x^2 + y^2 + z^2 - 1, z - 0.5) = 0; x^2 + y^2 = 0.25"
        options = ("--contours", "height; step 0.2", "--box", "1.5")
        all_kinds = {path.kind for path in self.svg(text, *options)[1]}
        self.assertEqual(all_kinds, set(KINDS))
        for kind in KINDS:
            found = {path.kind for path in self.svg(text, *options, "--lines", kind)[1]}
            self.assertEqual(found, {kind})
        some = {path.kind for path in
                self.svg(text, *options, "--lines", "silhouettes, boundary")[1]}
        self.assertEqual(some, {"silhouette", "boundary"})

    def test_widths(self):
        root, _ = self.svg("@torus", "--width", "2.5")
        self.assertEqual([group.get("stroke-width") for group in root], ["2.5"])

    def test_widths_of_kinds_of_lines(self):
        def widths(*options):
            root, _ = self.svg("x^2 + y^2 = 1", "--box", "1.5", *options)
            return {group.get("id").split("-")[1]: float(group.get("stroke-width"))
                    for group in root}
        contours = ("--contours", "height; step 0.5")
        self.assertEqual(widths(*contours), {"silhouette": 1, "boundary": 0.8, "contour": 0.4})
        self.assertEqual(widths("--contours", "height; step 0.5; width 0.7")["contour"], 0.7)
        self.assertEqual(widths("--contours", "height; step 0.5; width 0.7", "--width",
                                "2; contours 0.3; boundary 0.5"),
                         {"silhouette": 2, "boundary": 0.5, "contour": 0.3})

    def test_jumps_end_surfaces(self):
        # Places are x and z of lines along y, that the view from a little aside tells apart.
        tilt = math.atan2(0.4, 9)
        view = ("--box", "-1.5,1.5,-1,1,-1,1", "--projection", "orthographic", "--eye", "0.4,0,9",
                "--up", "0,1,0", "--lines", "boundary", "--hidden", "show")
        for text, places in (
                ("z = if(x < 0.5, 0.2, -0.2)", ((-1.5, 0.2), (0.5, 0.2), (0.5, -0.2), (1.5, -0.2))),
                ("z = 0.2 sign(x)", ((-1.5, -0.2), (0, -0.2), (0, 0.2), (1.5, 0.2))),
                ("z = 0.3 floor(x + 0.4)", ((-1.5, -0.6), (-1.4, -0.6), (-1.4, -0.3), (-0.4, -0.3),
                                            (-0.4, 0), (0.6, 0), (0.6, 0.3), (1.5, 0.3)))):
            with self.subTest(text):
                _, paths = self.svg(text, *view)
                spans = [[x for piece in path.pieces for x, _ in piece] for path in paths]
                found = sorted({round(x[0], 1) for x in spans if max(x) - min(x) < 0.01})
                wanted = sorted(x * math.cos(tilt) - z * math.sin(tilt) for x, z in places)
                self.assertEqual(len(found), len(wanted), found)
                scale = (found[-1] - found[0]) / (wanted[-1] - wanted[0])
                for at, place in zip(found, wanted):
                    self.assertAlmostEqual(at, found[0] + scale * (place - wanted[0]), delta=0.15)

    def test_what_is_known_is_written_when_the_time_is_over(self):
        for budget in ("0.001", "0.3"):
            result = run("draw", "@barth_sextic", "-o", "a.svg", "--budget", budget,
                         cwd=self.folder)
            self.assertEqual(result.code, 0, str(result))
            self.assertRegex(result.err, rf"^zeroset: the budget of {budget} s is spent on .*: some "
                                         r"silhouettes.* may be missing; --budget SECONDS gives "
                                         r"more\n$")
            self.assertTrue(ET.parse(self.folder / "a.svg").getroot().tag.endswith("svg"))
            self.assertEqual([path.name for path in self.folder.iterdir()], ["a.svg"])

    def test_stats(self):
        stats = json.loads(self.run_ok("draw", "x^2 + y^2 + z^2 = 1", "--stats", "-").out)
        self.assertEqual(stats["lines"]["silhouette"]["paths"], 1)
        self.assertEqual(stats["lines"]["silhouette"]["closed"], 1)
        self.assertEqual(stats["cells_open"], 0)
        self.assertTrue(stats["in_time"])

    def test_same_drawing_each_time(self):
        first = self.svg("@tangle", "--hidden", "dash")[1]
        again = self.svg("@tangle", "--hidden", "dash")[1]
        self.assertEqual([path.pieces for path in first], [path.pieces for path in again])

    def test_lines_that_may_be_missing_are_told(self):
        result = run("draw", "x*y = 0", "-o", "a.svg", "--projection", "orthographic", "--eye",
                     "0,0,5", "--up", "0,1,0", cwd=self.folder)
        self.assertEqual(result.code, 0, str(result))
        self.assertRegex(result.err, r"^zeroset: lines may be missing in \d+ places of up to "
                                     r"[\d.]+ pt.*\n$")

    def test_empty_drawings_are_told(self):
        self.run_ok("sample", "x^2 + y^2 + z^2 = 1", "--size", "12", "-o", "ball.nrrd")
        for equation, told in (('volume("ball.nrrd")(x, y, z) = 0', r"type cubic behind its file"),
                               ('volume("ball.nrrd", cubic)(x, y, z) = 0', None),
                               ("x^2 + y^2 + z^2 = -1", r"none of the lines .* is in the view")):
            result = run("draw", equation, "-o", "a.svg", cwd=self.folder)
            self.assertEqual(result.code, 0, str(result))
            wanted = "^$" if told is None else rf"^zeroset: nothing is drawn: .*{told}.*\n$"
            self.assertRegex(result.err, wanted)


class ErrorTest(DrawingTest):
    def error_of(self, *options, code=2):
        result = run("draw", "x^2 + y^2 + z^2 = 1", *options, cwd=self.folder)
        self.assertEqual(result.code, code, str(result))
        self.assertTrue(result.err.startswith("error: "), str(result))
        self.assertEqual(list(self.folder.iterdir()), [], "nothing is written")
        return result.err

    def test_wrong_options(self):
        output = ("-o", "a.svg")
        for options, words in (
                ((), "-o OUT.svg"),
                (("-o", "a.png"), ".svg, .pdf or .tex; .png is written by `zeroset render`"),
                (("-o", "svg"), "ends in .svg, .pdf or .tex"),
                ((*output, "--size", "300"), "WIDTHxHEIGHT"),
                ((*output, "--size", "5x5"), "from 10 to 10000 points"),
                ((*output, "--size", "300x200yd"), "WIDTHxHEIGHT"),
                ((*output, "--lines", "shadow"), "silhouette,crease"),
                ((*output, "--hidden", "dotted"), "remove, dash or show"),
                ((*output, "--width", "0"), "from 0.01 to 100"),
                ((*output, "--width", "1; contour 0"), "from 0.01 to 100"),
                ((*output, "--width", "1; shadow 1"), "1; contour 0.3; crease 0.5"),
                ((*output, "--width", "1; contour"), "1; contour 0.3; crease 0.5"),
                ((*output, "--tolerance", "nan"), "finite"),
                ((*output, "--tolerance", "100"), "from 0.0001 to 10"),
                ((*output, "--budget", "0"), "from 0.001"),
                ((*output, "--contours", "x +"), "--contours")):
            self.assertIn(words, self.error_of(*options), options)

    def test_files_that_cannot_be_written(self):
        self.assertIn("does not exist", self.error_of("-o", "no/a.svg", code=1))
        result = run("draw", "@sphere", "--stats", "/dev/full", cwd=self.folder)
        self.assertEqual(result.code, 1, str(result))
        self.assertIn("No space left", result.err)


def is_jump(values, step):
    """Tells of four depths in a row whether the surface is not one between the inner two."""
    before, here, there, behind = values
    if math.isinf(here) or math.isinf(there):
        return math.isinf(here) != math.isinf(there)
    slopes = [abs(a - b) for a, b in ((before, here), (there, behind))
              if not (math.isinf(a) or math.isinf(b))]
    return abs(here - there) > step + 3 * max(slopes, default=math.inf)


def jumps(depth, step):
    """Returns places between neighbouring pixels, one a hit and one not, or at least `step`
    farther and so steeply as the surface is not beside."""
    places = []
    for row in range(1, depth.height - 2):
        for col in range(1, depth.width - 2):
            for dx, dy in ((1, 0), (0, 1)):
                values = [depth.at(col + i * dx, row + i * dy) for i in (-1, 0, 1, 2)]
                if is_jump(values, step):
                    places.append((col + 0.5 + 0.5 * dx, row + 0.5 + 0.5 * dy))
    return places


class DepthTest(DrawingTest):
    """A drawing lies over the picture of the same view."""

    def check(self, *view, step):
        depth = self.depth(*view, "--size", SIZE)
        _, paths = self.svg(*view, "--size", f"{SIZE}x{SIZE}")
        near = {}
        for path in paths:
            for x, y in path.points():
                near.setdefault((math.floor(x / 2), math.floor(y / 2)), []).append((x, y))
        found = jumps(depth, step)
        self.assertGreater(len(found), 100)
        for x, y in found:
            col, row = math.floor(x / 2), math.floor(y / 2)
            around = [point for i in (-1, 0, 1) for k in (-1, 0, 1)
                      for point in near.get((col + i, row + k), ())]
            self.assertTrue(any(math.dist(point, (x, y)) < 1.5 for point in around),
                            f"{view}: no line at {x}, {y}")
        self.check_silhouettes(paths, depth, view)

    def check_silhouettes(self, paths, depth, view):
        """Beside a visible silhouette one sees past the surface."""
        seen = missed = 0
        for path in paths:
            if path.kind != "silhouette" or path.hidden:
                continue
            for x, y in path.points(2.0):
                col, row = math.floor(x), math.floor(y)
                if not (3 <= col < SIZE - 3 and 3 <= row < SIZE - 3):
                    continue
                window = [depth.at(col + i, row + k) for i in range(-2, 3) for k in range(-2, 3)]
                hits = [value for value in window if not math.isinf(value)]
                spread = max(hits) - min(hits) if hits else 0.0
                seen += 1
                missed += not hits or (len(hits) == len(window) and spread < 0.02)
        self.assertGreater(seen, 20)
        self.assertLessEqual(missed, 0.03 * seen, view)

    def test_every_jump_of_the_depth_has_a_line(self):
        for name, step in (("torus", 0.1), ("tangle", 0.1), ("double_torus", 0.1),
                           ("cayley_cubic", 0.1), ("clebsch_cubic", 0.1), ("gyroid_ball", 0.15),
                           ("machined_cube", 0.1)):
            with self.subTest(name):
                self.check("@" + name, step=step)

    def test_views_of_many_kinds(self):
        tangle = "x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8 = 0"
        for view in (("--projection", "orthographic"), ("--eye", "2,-9,1"),
                     ("--sphere", "2.4"), ("--section", "x<0.3"),
                     ("--section", "1,1,0,0.5", "--hollow"),
                     ("--eye", "4,-5,3", "--fov", "20", "--look-at", "0.5,0,0.2")):
            with self.subTest(view):
                self.check(tangle, "--box", "3", *view, step=0.1)


if __name__ == "__main__":
    main()
