"""Tests of `zeroset bench`: suites, tables and figures."""

import json

from zeroset_program import ProgramTest, run


class BenchTest(ProgramTest):
    def test_table_and_json_of_a_suite(self):
        suite = {"camera": {"direction": [1, -1.6, 0.9], "distance": 4, "fov": 42},
                 "surfaces": [{"name": "ball", "f": "x^2 + y^2 + z^2 - 1", "domain": 2},
                              {"name": "sheet", "f": "z - w", "domain": 1}]}
        (self.folder / "suite.json").write_text(json.dumps(suite), encoding="utf-8")
        base = ["bench", "--suite", "suite.json", "--size", 24, "--repeat", 2]
        table = self.run_ok(*base, "--json", "bench.json").out
        for word in ("ball", "sheet", "beams", "fps"):
            self.assertIn(word, table)
        in_file = json.loads((self.folder / "bench.json").read_text(encoding="utf-8"))
        printed = json.loads(self.run_ok(*base, "--json", "-").out)
        for answer in (in_file, printed):
            self.assertEqual((answer["width"], answer["height"]), (24, 24))
            self.assertEqual([row["name"] for row in answer["surfaces"]], ["ball", "sheet"])
            for row in answer["surfaces"]:
                cell = row["beams"]
                self.assertGreater(cell["frame_ms"]["median"], 0)
                self.assertGreater(cell["form_per_ray"], 0)
                self.assertGreater(cell["floor_ms"], 0)
                self.assertAlmostEqual(cell["times_floor"] * cell["floor_ms"],
                                       cell["frame_ms"]["median"])
                self.assertEqual(cell["certified"] + cell["undecided"] + cell["miss"], 24 * 24)

    def test_light(self):
        suite = {"camera": {"direction": [1, -1.6, 0.9], "distance": 4, "fov": 42},
                 "surfaces": [{"name": "ball", "f": "x^2 + y^2 + z^2 - 1", "domain": 2}]}
        (self.folder / "suite.json").write_text(json.dumps(suite), encoding="utf-8")
        forms = {}
        for options in ((), ("--shadows",), ("--antialias",), ("--shadows", "--antialias")):
            answer = json.loads(self.run_ok("bench", "--suite", "suite.json", "--size", 64, "--repeat",
                                            1, "--json", "-", *options).out)
            self.assertEqual(answer["shadows"], "--shadows" in options)
            self.assertEqual(answer["antialias"], "iaa" if "--antialias" in options else "none")
            forms[options] = answer["surfaces"][0]["beams"]["form_per_ray"]
        self.assertLess(forms[()], forms["--shadows",])
        self.assertLess(forms["--shadows",], forms["--shadows", "--antialias"])
        self.assertLess(forms["--antialias",], forms["--shadows", "--antialias"])

    def test_looks(self):
        suite = {"camera": {"direction": [1, -1.6, 0.9], "distance": 4, "fov": 42},
                 "surfaces": [{"name": "balls", "domain": 2,
                               "f": "((x - 1)^2 + y^2 + z^2 - 0.8) * ((x + 1)^2 + y^2 + z^2 - 0.8)"}]}
        (self.folder / "suite.json").write_text(json.dumps(suite), encoding="utf-8")
        forms = []
        for options in ((), ("--look", "metal"), ("--look", "metal", "--reflections", 2)):
            answer = json.loads(self.run_ok("bench", "--suite", "suite.json", "--size", 64, "--repeat",
                                            1, "--json", "-", *options).out)
            self.assertEqual(answer["look"], "metal" if options else "standard")
            self.assertEqual(answer["reflections"], 2 if "--reflections" in options else 0)
            forms.append(answer["surfaces"][0]["beams"]["form_per_ray"])
        self.assertEqual(forms, sorted(set(forms)))

    def test_first_pictures(self):
        suite = {"camera": {"direction": [1, -1.6, 0.9], "distance": 4, "fov": 42},
                 "surfaces": [{"name": "ball", "f": "x^2 + y^2 + z^2 - 1.5", "domain": 2},
                              {"name": "sheet", "f": "z - x*y", "domain": 1}]}
        (self.folder / "suite.json").write_text(json.dumps(suite), encoding="utf-8")
        lines = self.run_ok("bench", "--first-picture", "--suite", "suite.json", "--size", 64,
                            "--repeat", 1).out.splitlines()
        rows = [line.split() for line in lines if line.split()[0] in ("ball", "sheet")]
        self.assertEqual([row[0] for row in rows], ["ball", "sheet"])
        for row in rows:
            nodes, ready_ms, first_ms = int(row[1]), float(row[2]), float(row[3])
            self.assertGreater(nodes, 2, row)
            self.assertTrue(0 <= ready_ms <= first_ms, row)
        self.assertRegex(lines[-2], r"\Aa new text +median [0-9.]+ ms")

    def test_the_suite_of_the_gallery(self):
        answer = json.loads(self.run_ok("bench", "--size", 8, "--repeat", 1, "--threads", 1,
                                        "--dstop", 6, "--json", "-").out)
        self.assertEqual(len(answer["surfaces"]), 29)
        self.assertEqual(answer["threads"], 1)

    def test_a_broken_suite(self):
        for text in ("", "{", "{}", '{"camera": 1}', "[]"):
            (self.folder / "suite.json").write_text(text, encoding="utf-8")
            result = run("bench", "--suite", "suite.json", cwd=self.folder)
            self.assertEqual(result.code, 2, str(result))
            self.assertRegex(result.err, r"\Aerror: --suite suite.json: [^\n]+\n\Z")
            self.assertEqual(result.out, "", str(result))
