"""Tests of volumes on the command line: `zeroset sample`, and files as functions in formulas."""

import json
import math
import struct

from zeroset_program import ProgramTest, run

SPHERE = "x^2 + y^2 + z^2 = 1"
VIEW = ["--size", "64x48", "--box", "1.25"]


def read_nrrd(path):
    """Returns the fields of the header and the samples of float32."""
    data = path.read_bytes()
    end = data.index(b"\n\n") + 2
    lines = data[:end].decode("ascii").splitlines()
    fields = dict(line.split(": ", 1) for line in lines if ": " in line and line[0] != "#")
    return fields, struct.unpack(f"<{(len(data) - end) // 4}f", data[end:])


class VolumeTest(ProgramTest):
    def test_a_sampled_formula_is_written_as_nrrd(self):
        self.run_ok("sample", "x + 10 y + 100 z - a", "-o", "a.nrrd", "--size", "5x3x2",
                    "--box=-1,1,0,4,2,3", "--set", "a=7")
        fields, samples = read_nrrd(self.folder / "a.nrrd")
        self.assertEqual(fields["sizes"], "5 3 2")
        self.assertEqual(fields["space origin"], "(-1,0,2)")
        self.assertEqual(fields["space directions"], "(0.5,0,0) (0,2,0) (0,0,1)")
        expected = [x / 2 - 1 + 10 * 2 * y + 100 * (2 + z) - 7
                    for z in range(2) for y in range(3) for x in range(5)]
        self.assertEqual(list(samples), expected)

    def test_a_single_size_keeps_the_spacing(self):
        self.run_ok("sample", "x", "-o", "a.nrrd", "--size", "9", "--box", "0,4,0,2,0,1")
        self.assertEqual(read_nrrd(self.folder / "a.nrrd")[0]["sizes"], "9 5 3")

    def test_what_is_undefined_is_no_number(self):
        self.run_ok("sample", "sqrt(x)", "-o", "a.nrrd", "--size", "3x2x2", "--box", "1")
        samples = read_nrrd(self.folder / "a.nrrd")[1]
        self.assertTrue(math.isnan(samples[0]))
        self.assertEqual(samples[1:3], (0, 1))

    def test_a_sampled_sphere_is_drawn_where_the_sphere_is(self):
        self.run_ok("sample", SPHERE, "-o", "s.nrrd", "--size", "61", "--box", "1.25")
        truth = self.depth(SPHERE, *VIEW)
        found = self.depth('scan = volume("s.nrrd"); scan(x, y, z) = 0', *VIEW)
        near = [abs(a[2] - b[2]) for a, b in zip(truth.pixels(), found.pixels())
                if math.isfinite(a[2]) and math.isfinite(b[2])]
        self.assertGreater(len(near), 0.95 * truth.hits())
        near.sort()
        self.assertLess(near[int(0.9 * len(near))], 2e-3)

    def test_slices_in_files_of_their_own_are_one_volume(self):
        for k in range(3):
            (self.folder / f"s{k + 1:02}.raw").write_bytes(struct.pack("<4h", k, k, k, k))
        header = "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 3\nendian: little\nencoding: raw\n"
        (self.folder / "a.nhdr").write_text(header + "data file: s%02d.raw 1 3 1\n", "ascii")
        self.run_ok("sample", 'scan = volume("a.nhdr"); scan(x, y, z)', "-o", "b.nrrd",
                    "--size", "2x2x5", "--box", "0,1,0,1,0,2")
        samples = read_nrrd(self.folder / "b.nrrd")[1]
        self.assertEqual(samples[::4], (0, 0.5, 1, 1.5, 2))
        (self.folder / "s02.raw").unlink()
        result = run("render", "a.nhdr", "-o", "a.png", cwd=self.folder)
        self.assertEqual(result.code, 2, str(result))
        self.assertIn("its file 's02.raw': it cannot be read", result.err)

    def test_a_file_of_no_known_kind_gets_its_line(self):
        (self.folder / "head.raw").write_bytes(b"12345678")
        result = run("render", "head.raw", "-o", "a.png", cwd=self.folder)
        self.assertEqual(result.code, 2, str(result))
        self.assertRegex(result.err, r"\Aerror: 'head.raw' is no kind of file[^\n]+\n\Z")
        self.assertIn('volume("head.raw", size ', result.err)
        self.run_ok("render", 'f = volume("head.raw", size 2 2 2, uint8); f(x, y, z) = 52.5',
                    "-o", "a.png", "--size", "16")

    def test_distances_are_those_of_a_sphere(self):
        result = self.run_ok("sample", SPHERE, "-o", "d.nrrd", "--distance", "--size", "12",
                             "--box", "1.5", "--tolerance", "0.01")
        self.assertEqual(result.err, "")
        fields, samples = read_nrrd(self.folder / "d.nrrd")
        self.assertIn("signed distance, to 0.01, of", fields["content"])
        step = 3 / 11
        for n, found in enumerate(samples):
            point = [step * (n // 12 ** axis % 12) - 1.5 for axis in range(3)]
            self.assertAlmostEqual(found, math.hypot(*point) - 1, delta=0.0101)

    def test_distances_that_are_not_proved_are_told(self):
        result = run("sample", "(x + y)^2", "-o", "d.nrrd", "--distance", "--size", "4", "--box",
                     "1", "--tolerance", "0.1", cwd=self.folder)
        self.assertEqual(result.code, 0, str(result))
        self.assertIn("of 64 of 64 samples the distance is not proved to 0.1", result.err)

    def test_a_spline_is_drawn_where_the_sphere_is(self):
        self.run_ok("sample", SPHERE, "-o", "s.nrrd", "--size", "33", "--box", "2")
        # Far from the border, where it is mirrored, a cubic spline is this function.
        truth = self.depth(SPHERE, *VIEW)
        found = self.depth('scan = volume("s.nrrd", cubic); scan(x, y, z) = 0', *VIEW)
        near = [abs(a[2] - b[2]) for a, b in zip(truth.pixels(), found.pixels())
                if math.isfinite(a[2]) and math.isfinite(b[2])]
        self.assertGreater(len(near), 0.95 * truth.hits())
        near.sort()
        self.assertLess(near[int(0.9 * len(near))], 3e-4)

    def test_all_is_certified(self):
        stats = self.run_ok("render", "@marschner_lobb", "-o", "a.png", "--size", "96x96",
                            "--stats", "-")
        stats = json.loads(stats.out)
        self.assertGreater(stats["certified"], 1500)
        self.assertLess(stats["undecided"], 20)

    def test_a_file_alone_is_drawn_in_its_own_box(self):
        self.run_ok("sample", "x^2 + y^2 + z^2", "-o", "s.nrrd", "--size", "21", "--box",
                    "10,20,10,20,10,20")
        self.assertGreater(self.depth("s.nrrd", "--size", "32x32", "--set", "a=700").hits(), 20)

    def test_a_document_names_files_beside_it(self):
        for name in ("beside", "elsewhere"):
            folder = self.folder / name
            folder.mkdir()
        self.run_ok("sample", SPHERE, "-o", "elsewhere/s.nrrd", "--size", "9")
        self.run_ok("sample", SPHERE, "-o", "beside/s.nrrd", "--size", "9")

        def document(file):
            text = {"zeroset": 1, "statements":
                    [{"text": f'volume("{file}")(x, y, z) = 0'}]}
            (self.folder / "beside/d.zeroset.json").write_text(json.dumps(text))
            return run("render", "beside/d.zeroset.json", "-o", "d.png", "--size", "8x8",
                       cwd=self.folder)

        self.assertEqual(document("s.nrrd").code, 0)
        refused = document("../elsewhere/s.nrrd")
        self.assertEqual(refused.code, 2)
        self.assertIn("'../elsewhere/s.nrrd' lies outside the document's folder", refused.err)

    def test_wrong_volumes_get_one_line_and_a_caret(self):
        (self.folder / "short.nrrd").write_bytes(
            b"NRRD0004\ntype: float\ndimension: 3\nsizes: 9000 9000 9000\nencoding: raw\n"
            b"endian: little\n\n1234")
        for text, words, column in (
                ('volume("none.nrrd")(x,y,z) = 1', "'none.nrrd': there is no such file", 8),
                ('volume("short.nrrd")(x,y,z) = 1',
                 "it is too short: 2916000000000 bytes of samples are announced", 8),
                ('volume("short.nrrd", sharp)(x,y,z) = 1', "'sharp' says nothing of a volume", 21),
                ('volume("short.nrrd") = 1', "a volume is a function of a point", 0),
                ('volume("short.nrrd', "the file's name is not closed", 7)):
            with self.subTest(text=text):
                result = run("render", text, "-o", "a.png", cwd=self.folder)
                self.assertEqual(result.code, 2, result)
                lines = result.err.splitlines()
                self.assertEqual(len(lines), 3, result)
                self.assertIn(words, lines[0])
                self.assertEqual(lines[2].index("^"), 2 + column, result)

    def test_wrong_options_of_sample(self):
        for options, words in (
                (["-o", "a.txt"], "-o a.txt: type a name that ends in .nrrd"),
                (["-o", "a.nrrd", "--size", "1"], "--size 1"),
                (["-o", "a.nrrd", "--size", "5x5"], "--size 5x5"),
                (["-o", "a.nrrd", "--size", "4097"], "--size 4097"),
                (["-o", "a.nrrd", "--size", "4000x4000x4000"], "2^30"),
                (["-o", "a.nrrd", "--size", "-3"], "--size"),
                (["-o", "a.nrrd", "--surface", "2"], "--surface 2"),
                (["-o", "a.nrrd", "--tolerance", "1"], "type --distance"),
                (["-o", "a.nrrd", "--distance", "--tolerance", "0"], "--tolerance 0"),
                (["-o", "a.nrrd", "--distance", "--box", "5,6,5,6,5,6"],
                 "the surface surely has no point in the box"),
                (["-o", "a.nrrd", "--box", "0"], "--box 0"),
                (["-o", "a.nrrd", "--set", "q=1"], "q")):
            with self.subTest(options=options):
                result = run("sample", "x", *options, cwd=self.folder)
                self.assertEqual(result.code, 2, result)
                self.assertIn(words, result.err)
                self.assertEqual(self.files(), [])
        several = run("sample", "x = 1; y = 1", "-o", "a.nrrd", cwd=self.folder)
        self.assertEqual(several.code, 2)
        self.assertIn("type --surface N", several.err)
