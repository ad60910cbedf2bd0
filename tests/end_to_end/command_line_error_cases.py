"""Tests of wrong command lines: each gives its exit code, one clear line and no file."""

import json
import os
import unittest

from zeroset_program import ProgramTest, read_png, run

WRONG = 2
RUN_TIME = 1

# (wrong options of `render x`, words that the error line must contain)
WRONG_OPTIONS = [
    (["--nope"], ["--nope"]),
    (["--color-by", ""], ["--color-by", "expression"]),
    (["--color-map", "jet"], ["--color-map jet", "aurora"]),
    (["--color-range", "1"], ["--color-range 1", "2 numbers"]),
    (["--color-range", "2,1"], ["--color-range 2,1", "below"]),
    (["--color-range", "0,inf"], ["--color-range", "inf"]),
    (["--color-range", "0,1"], ["--color-range 0,1", "--color-by"]),
    (["--set", "a=1/2"], ["--set a=1/2: ", "number"]),
    (["--set", "a=nan"], ["--set a=nan: ", "number"]),
    (["--set", "a=1"], ["--set a: ", "none"]),
    (["--mark", "1,2"], ["--mark 1,2", "3"]),
    (["--mark", "1,2,nan"], ["--mark", "nan"]),
    (["--mark", "1,2,3; P"], ["--mark 1,2,3; P", "label TEXT"]),
    (["--axis-names", "x,y"], ["--axis-names x,y", "three names"]),
    (["--probe", "5"], ["--probe 5", "2"]),
    (["--probe", "5,1.5"], ["--probe 5,1.5", "COL,ROW"]),
    (["--probe", "1024,0"], ["--probe 1024,0", "1023,1023"]),
    (["--size", "0x0"], ["--size", "0x0"]),
    (["--size", "100000x100000"], ["--size", "100000x100000"]),
    (["--size", "65537x1"], ["--size", "65536"]),
    (["--size", "16384x16384", "--repeat", "2"], ["--repeat", "16384x16384"]),
    (["--size", "16384x16384", "--probe", "1,1"], ["--probe", "16384x16384"]),
    (["--bits", "12"], ["12", "16"]),
    (["--bits", "x"], ["--bits"]),
    (["--dpi", "0"], ["--dpi 0", "100000"]),
    (["--dpi", "nan"], ["--dpi"]),
    (["--quality", "50"], ["--quality", ".jpg"]),
    (["--size", "5x"], ["--size", "5x"]),
    (["--size", "axb"], ["--size", "axb"]),
    (["--size", "-5x5"], ["--size"]),
    (["--size", "3x4x5"], ["--size", "3x4x5"]),
    (["--size", "99999999999x2"], ["--size"]),
    (["--box", "nan"], ["--box", "nan"]),
    (["--box", "inf"], ["--box", "inf"]),
    (["--box", "0"], ["--box"]),
    (["--box", "-1"], ["--box"]),
    (["--box", "1,2,3"], ["--box", "6", "3"]),
    (["--box", "2,1,0,1,0,1"], ["--box", "2,1,0,1,0,1"]),
    (["--box", "0,1,0,1,1,1"], ["--box", "0,1,0,1,1,1"]),
    (["--box", "0,1,0,nan,0,1"], ["--box", "nan"]),
    (["--box", "1e300"], ["--box", "1e300"]),
    (["--box", "1,1.0000000000000004,0,1e-16,0,1e-16"], ["--box"]),
    (["--eye", "nan,0,0"], ["--eye", "nan"]),
    (["--eye", "1,2"], ["--eye", "3"]),
    (["--eye", "0,0,0", "--look-at", "0,0,0"], ["eye"]),
    (["--look-at", "1,inf,0"], ["--look-at", "inf"]),
    (["--up", "0,0,0"], ["up"]),
    (["--up", "1,-1.6,0.9"], ["up"]),
    (["--up", "a,b,c"], ["--up", "a"]),
    (["--fov", "0"], ["--fov"]),
    (["--fov", "180"], ["--fov"]),
    (["--fov", "nan"], ["--fov", "nan"]),
    (["--w", "nan"], ["--w", "nan"]),
    (["--w", "1e999"], ["--w", "1e999"]),
    (["--w", ""], ["--w"]),
    (["--tracer", "magic"], ["--tracer", "magic", "k-bisection"]),
    (["--dstop", "0"], ["--dstop"]),
    (["--dstop", "99"], ["--dstop", "99"]),
    (["--dstop", "ten"], ["--dstop", "ten"]),
    (["--epsilon", "0"], ["--epsilon"]),
    (["--epsilon", "-1"], ["--epsilon"]),
    (["--delta", "nan"], ["--delta", "nan"]),
    (["--dstop", "5", "--epsilon", "0.1"], ["--dstop", "--epsilon"]),
    (["--levels", "30"], ["--levels 30", "beams", "--tracer octree"]),
    (["--tracer", "octree", "--levels", "54"], ["--levels 54", "10 to 53"]),
    (["--tracer", "octree", "--levels", "9"], ["--levels 9", "10 to 53"]),
    (["--tracer", "octree", "--levels", "30", "--dstop", "9"], ["--levels", "--dstop"]),
    (["--threads", "0"], ["--threads"]),
    (["--threads", "1.5"], ["--threads", "1.5"]),
    (["--repeat", "0"], ["--repeat"]),
    (["--repeat", "999999999999"], ["--repeat"]),
    (["--look", "gold"], ["--look", "gold", "metal"]),
    (["--reflections", "6"], ["--reflections"]),
    (["--opacity", "2"], ["--opacity", "2"]),
    (["--opacity", "3:0.5"], ["--opacity", "3"]),
    (["--surface-look", "gold"], ["--surface-look", "gold", "porcelain"]),
    (["--surface-look", "3:clay"], ["--surface-look", "3"]),
    (["--color", "red"], ["--color red", "#D9763A"]),
    (["--color", "3:#FF0000"], ["--color 3", "no such surface"]),
    (["--thickness", "3px"], ["--thickness", "no curve and no point"]),
    (["--thickness", "1:0.1"], ["--thickness 1", "no curve and no point"]),
    (["--thickness", "0"], ["--thickness 0", "3px"]),
    (["--thickness", "3 cm"], ["--thickness", "3px"]),
    (["--surface-box", "1,2"], ["--surface-box 1,2", "6 numbers"]),
    (["--surface-box", "9:1"], ["--surface-box 9", "no such surface"]),
    (["--surface-box", "1:0"], ["--surface-box 0", "above 0"]),
    (["--absorption", "-1"], ["--absorption"]),
    (["--light", "1,2"], ["--light", "1,2", "X,Y,Z"]),
    (["--tone", "loud"], ["--tone", "filmic"]),
    (["--background", "white"], ["--background", "#RRGGBB"]),
    (["--contours", "height;step 0"], ["--contours", "step"]),
    (["surplus"], ["surplus"]),
    (["-o", "second.png"], ["output"]),
]

# (other wrong command lines, words that the error line must contain)
WRONG_COMMANDS = [
    (["dev", "bench", "--levels", "30"], ["--levels 30", "beams"]),
    (["dev", "bench", "--first-picture", "--levels", "30"], ["--first-picture", "--levels"]),
    (["dev", "traversal"], ["EQUATION"]),
    (["dev", "traversal", "x", "--levels", "54"], ["--levels 54", "10 to 53"]),
    (["dev", "traversal", "x", "--size", "0"], ["--size"]),
    (["x", "--tracer", "octree", "--levels", "30"], ["--levels 30", "window", "render"]),
    (["render", "x"], ["-o"]),
    (["render", "no_such.json", "-o", "a.png"], ["no_such.json", "no such file"]),
    (["render", "/none/scan-1.dcm", "-o", "a.png"], ["/none/scan-1.dcm", "no such file"]),
    (["render", "x", "-o"], ["output"]),
    (["render", "x", "-o", "picture.pcx"], ["picture.pcx", ".png", ".exr"]),
    (["render", "./", "-o", "picture.png"], ["folder", "zeroset ./"]),
    (["render", "x", "-o", ""], [".png"]),
    (["render", "x", "--stats", "-", "--alpha"], ["--alpha", "-o"]),
    (["render", "x", "-o", "a.jpg", "--alpha"], ["JPEG", ".webp"]),
    (["render", "x", "-o", "a.jpg", "--bits", "16"], ["JPEG", ".png or .tif"]),
    (["render", "x", "-o", "a.jpg", "--quality", "0"], ["--quality"]),
    (["render", "x", "-o", "a.jpg", "--dpi", "300"], ["--dpi", ".png"]),
    (["render", "x", "-o", "a.webp", "--size", "20000x10"], ["WebP", "16383", ".png"]),
    (["render", "x", "-o", "a.tif", "--size", "30000x30000"], ["TIFF", "memory", ".png"]),
    (["render", "-o", "picture.png"], ["EQUATION"]),
    (["render", "@spher", "-o", "picture.png"], ["spher", "@sphere"]),
    (["render", "@barth_sextik", "-o", "picture.png"], ["barth_sextik", "@barth_sextic"]),
    (["render", "@", "-o", "picture.png"], ["@"]),
    (["explain", "@tors"], ["tors", "@torus"]),
    (["explain", "x", "--at", "1,2"], ["--at", "3"]),
    (["explain", "x", "--at", "1,2,nan"], ["--at", "nan"]),
    (["gallery", "surplus"], ["surplus"]),
    (["dev", "bench", "--suite", "no_such.json"], ["no_such.json"]),
    (["dev", "bench", "--tracer", "magic"], ["magic", "k-bisection"]),
    (["dev", "bench", "--size", "0"], ["--size"]),
    (["dev", "bench", "--threads", "-1"], ["--threads"]),
    (["dev", "bench", "--dstop", "23"], ["--dstop"]),
    (["dev", "bench", "--first-picture", "--json", "-"], ["--first-picture", "--json"]),
    (["dev", "bench", "--first-picture", "--budget", "3"], ["--first-picture", "--budget"]),
    (["dev", "bench", "--first-picture", "--shadows"], ["--first-picture", "--shadows"]),
    (["dev", "bench", "--first-picture", "--look", "metal"], ["--first-picture", "--look"]),
    (["dev", "bench", "--first-picture", "--reflections", "1"], ["--first-picture", "--reflections"]),
    (["dev", "bench", "--look", "wood"], ["--look wood", "metal"]),
    (["dev", "bench", "--reflections", "6"], ["--reflections 6", "5"]),
    (["dev", "bench", "--first-picture", "--antialias"], ["--first-picture", "--antialias"]),
    (["dev", "bench", "--first-picture", "--tracer", "beams,k-bisection"], ["--tracer", "beams"]),
    (["dev", "compare", "florez-figure-6.8", "--tracer", "beams"], ["--tracer", "animation"]),
    (["dev", "compare", "florez-figure-5.13", "--budget", "1"], ["--budget", "shadows"]),
    (["dev", "compare", "florez-figure-5.13", "--threads", "2"], ["--threads", "leave"]),
    (["dev", "compare", "florez-figure-6.8", "--size", "20x10"], ["--size 20x10", "type N"]),
    (["dev", "compare", "knoll"], ["knoll: there is no such table", "knoll-table-1", "florez-table-4.1"]),
    (["dev", "compare", "--tracer", "beams,magic"], ["--tracer magic", "sphere-tracing"]),
    (["dev", "compare", "--surface", "sphere,cube"], ["--surface cube", "tangle"]),
    (["dev", "compare", "--dstop", "10,99"], ["--dstop", "99"]),
    (["dev", "compare", "--threads", "0"], ["--threads"]),
    (["dev", "compare", "--repeat", "0"], ["--repeat"]),
    (["dev", "compare", "--size", "0"], ["--size"]),
    (["dev", "compare", "--budget", "-1"], ["--budget"]),
    (["--nope"], ["--nope"]),
    (["--present"], ["--present", "FILE.zeroset.json"]),
    (["--present", "no_such.zeroset.json"], ["no_such.zeroset.json"]),
    (["--present", "explain", "x"], ["--present", "explain"]),
]

# (wrong formula, column from 1 that the caret marks)
WRONG_FORMULAS = [
    ("x +", 4),
    ("x + * y", 5),
    ("x^2 + y^2 )", 11),
    ("(x + y", 1),
    ("2 3 x", 3),
    ("x = 1/0", 7),
    ("sni(x)", 1),
    ("x == 1 and y < 1", 1),
    ("x = 1, y = 2", 10),
    ("x = y = z", 7),
    ("foo(x)", 1),
    ("x + quux", 5),
    ("sqrt(x, y)", 1),
    ("atan2(x)", 1),
    ("x + é", 5),
    ("x² + y³ = )", 11),
    ("x @ y", 3),
]


class WrongInputTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.old = self.folder / "picture.png"
        self.old.write_bytes(b"an older file")

    def check_refused(self, result, code, words=()):
        """Expects one error line, nothing on stdout and no file; returns the lines of stderr."""
        self.assertEqual(result.code, code, str(result))
        self.assertEqual(result.out, "", str(result))
        self.assertTrue(result.err.endswith("\n"), str(result))
        lines = result.err.splitlines()
        self.assertTrue(lines[0].startswith("error: "), str(result))
        for word in words:
            self.assertIn(word, lines[0], str(result))
        self.assertEqual(self.files(), ["picture.png"], str(result))
        self.assertEqual(self.old.read_bytes(), b"an older file", str(result))
        return lines

    def check_one_line(self, arguments, code, words):
        lines = self.check_refused(run(*arguments, cwd=self.folder), code, words)
        self.assertEqual(len(lines), 1, lines)

    def test_options(self):
        for options, words in WRONG_OPTIONS:
            with self.subTest(options):
                command = ["render", "x", "-o", "picture.png", *options]
                self.check_one_line(command, WRONG, words)

    def test_a_constant_is_no_parameter(self):
        self.check_refused(run("render", "a = 2; x = a", "--set", "a=3", "-o", "picture.png",
                               cwd=self.folder), WRONG, ["--set a: ", "constant"])

    def test_colors_have_a_caret_under_the_place(self):
        for expression, column, words in [("x +", 3, ["mean-curvature"]),
                                          ("b x", 0, ["no parameter 'b'", "none"]),
                                          ("x = 1", 0, ["no equation"]),
                                          ("taste", 0, ["gradient"])]:
            with self.subTest(expression):
                command = ["render", "x", "-o", "picture.png", "--color-by", expression]
                lines = self.check_refused(run(*command, cwd=self.folder), WRONG,
                                           ["--color-by: ", *words])
                self.assertEqual(lines[1].strip(), expression)
                self.assertEqual(lines[2].index("^") - lines[1].index(expression), column)

    def test_an_expression_of_contours_has_its_own_errors(self):
        command = ["render", "x", "-o", "picture.png", "--contours", "x +"]
        lines = self.check_refused(run(*command, cwd=self.folder), WRONG,
                                   ["--contours: ", "height or xyz"])
        self.assertEqual(lines[2].index("^") - lines[1].index("x +"), 3)

    def test_commands(self):
        for command, words in WRONG_COMMANDS:
            with self.subTest(command):
                self.check_one_line(command, WRONG, words)

    def test_formulas_have_a_caret_under_the_place(self):
        for formula, column in WRONG_FORMULAS:
            for command in (["render", formula, "-o", "picture.png"], ["explain", formula]):
                with self.subTest(command):
                    lines = self.check_refused(run(*command, cwd=self.folder), WRONG)
                    self.assertEqual(len(lines), 3, lines)
                    self.assertEqual(lines[1].strip(), formula)
                    start = lines[1].index(formula)
                    self.assertEqual(lines[2], " " * (start + column - 1) + "^")

    def test_no_surface(self):
        for formula in ("", "1", "w^2 - 1", "2 = 3"):
            with self.subTest(formula):
                result = run("render", formula, "-o", "picture.png", cwd=self.folder)
                lines = self.check_refused(result, WRONG)
                self.assertLessEqual(len(lines), 3, lines)

    def test_wrong_place_in_a_later_line_of_standard_input(self):
        result = run("render", "-", "-o", "picture.png", stdin="x^2 +\n  y^2 + )\n",
                     cwd=self.folder)
        lines = self.check_refused(result, WRONG)
        self.assertEqual(len(lines), 3, lines)
        self.assertEqual(lines[1].strip(), "y^2 + )")
        self.assertEqual(lines[2].index("^"), lines[1].index(")"))

    def test_too_long_and_too_deep(self):
        for formula in ("+".join(["x"] * 1_100_000), "(" * 50_000 + "x" + ")" * 50_000,
                        "-" * 100_000 + "x", "(" * 20_000 + "x" + ")" * 20_000,
                        "sqrt(" * 15_000 + "x"):
            with self.subTest(formula[:10]):
                result = run("render", "-", "-o", "picture.png", stdin=formula, cwd=self.folder)
                lines = self.check_refused(result, WRONG)
                self.assertLess(max(map(len, lines)), 200)

    def test_json_errors(self):
        for formula, column in WRONG_FORMULAS:
            with self.subTest(formula):
                result = run("explain", formula, "--json", cwd=self.folder)
                self.assertEqual((result.code, result.err), (WRONG, ""), str(result))
                answer = json.loads(result.out)
                self.assertIs(answer["ok"], False)
                self.assertEqual(answer["column"], column)
                self.assertGreater(len(answer["error"]), 5)
                self.assertNotIn("\n", answer["error"])


class UnwritableTest(ProgramTest):
    """Tests of errors at run time."""

    def check_failed(self, result, words):
        self.assertEqual(result.code, RUN_TIME, str(result))
        self.assertEqual(result.out, "", str(result))
        self.assertRegex(result.err, r"\Aerror: [^\n]+\n\Z")
        for word in words:
            self.assertIn(word, result.err)

    def test_no_such_folder(self):
        for option, name in (("-o", "no/out.png"), ("--depth", "no/out.pfm"),
                             ("--stats", "no/out.json")):
            with self.subTest(option):
                result = run("render", "x", "--size", "8", option, name, cwd=self.folder)
                self.check_failed(result, [name])
                self.assertEqual(self.files(), [])

    def test_no_such_folder_for_figures(self):
        for table in ("knoll-table-1", "florez-figure-5.13", "florez-figure-6.8", "marmitt-table-3"):
            with self.subTest(table):
                result = run("dev", "compare", table, "--size", "8", "--json", "no/out.json",
                             cwd=self.folder)
                self.check_failed(result, ["no/out.json"])

    def test_one_unwritable_file_leaves_the_others_unwritten(self):
        result = run("render", "x", "--size", "8", "-o", "out.png", "--depth", "no/out.pfm",
                     cwd=self.folder)
        self.check_failed(result, ["no/out.pfm"])
        self.assertEqual(self.files(), [])

    def test_a_folder_is_no_file(self):
        (self.folder / "folder.png").mkdir()
        result = run("render", "x", "--size", "8", "-o", "folder.png", cwd=self.folder)
        self.check_failed(result, ["folder.png"])
        self.assertEqual(self.files(), ["folder.png"])
        self.assertEqual(list((self.folder / "folder.png").iterdir()), [])

    @unittest.skipIf(os.geteuid() == 0, "permissions do not stop root")
    def test_no_permission(self):
        shut = self.folder / "shut"
        shut.mkdir(mode=0o500)
        result = run("render", "x", "--size", "8", "-o", "shut/out.png", cwd=self.folder)
        self.check_failed(result, ["shut/out.png"])
        self.assertEqual(list(shut.iterdir()), [])

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no /dev/full")
    def test_no_space(self):
        result = run("render", "x", "--size", "8", "--depth", "/dev/full", cwd=self.folder)
        self.check_failed(result, ["/dev/full"])

    def test_overwrites_a_file_whole(self):
        (self.folder / "out.png").write_bytes(b"x" * 1_000_000)
        self.run_ok("render", "x", "--size", "8x9", "-o", "out.png")
        image = read_png(self.folder / "out.png")
        self.assertEqual((image.width, image.height), (8, 9))
        self.assertEqual(self.files(), ["out.png"])
