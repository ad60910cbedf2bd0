"""Tests of `zeroset dev bench` and `zeroset dev compare`: suites, tables and figures."""

import json
import subprocess
import sys
from xml.etree import ElementTree

from zeroset_program import SOURCE_DIR, ProgramTest, run


class BenchTest(ProgramTest):
    def test_table_and_json_of_a_suite(self):
        suite = {"camera": {"direction": [1, -1.6, 0.9], "distance": 4, "fov": 42},
                 "surfaces": [{"name": "ball", "f": "x^2 + y^2 + z^2 - 1", "domain": 2},
                              {"name": "sheet", "f": "z - w", "domain": 1}]}
        (self.folder / "suite.json").write_text(json.dumps(suite), encoding="utf-8")
        base = ["dev", "bench", "--suite", "suite.json", "--size", 24, "--repeat", 2]
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
            answer = json.loads(self.run_ok("dev", "bench", "--suite", "suite.json", "--size", 64, "--repeat",
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
            answer = json.loads(self.run_ok("dev", "bench", "--suite", "suite.json", "--size", 64, "--repeat",
                                            1, "--json", "-", *options).out)
            self.assertEqual(answer["look"], "metal" if options else "standard")
            self.assertEqual(answer["reflections"], 2 if "--reflections" in options else 0)
            forms.append(answer["surfaces"][0]["beams"]["form_per_ray"])
        self.assertEqual(forms, sorted(set(forms)))

    def test_suites_that_cannot_be_drawn(self):
        def suite(direction, fov, domain, distance=4):
            return {"camera": {"direction": direction, "distance": distance, "fov": fov},
                    "surfaces": [{"name": "ball", "f": "x^2 + y^2 + z^2 - 1", "domain": domain}]}

        (self.folder / "folder").mkdir()
        wrong = {"folder": "cannot be read",
                 "direction": "'direction' not 0 along all axes",
                 "distance": "'distance' must be above 0",
                 "fov": "the field of view",
                 "domain": "must be from 1e-12 to 1e9"}
        for name, text in (("direction", suite([0, 0, 0], 42, 1)), ("fov", suite([1, 1, 1], 180, 1)),
                           ("domain", suite([1, 1, 1], 42, -1)),
                           ("distance", suite([1, 1, 1], 42, 1, -4))):
            (self.folder / name).write_text(json.dumps(text), encoding="utf-8")
        for name, reason in wrong.items():
            with self.subTest(name):
                result = run("dev", "bench", "--suite", name, cwd=self.folder)
                self.assertEqual(result.code, 2, str(result))
                self.assertEqual(result.err.count("\n"), 1, str(result))
                self.assertIn(reason, result.err)

    def test_a_suite_from_above(self):
        suite = {"camera": {"direction": [0, 0, 1], "distance": 4, "fov": 42},
                 "surfaces": [{"name": "ball\u001b[31m", "f": "x^2 + y^2 + z^2 - 1", "domain": 1}]}
        (self.folder / "above.json").write_text(json.dumps(suite), encoding="utf-8")
        table = self.run_ok("dev", "bench", "--suite", "above.json", "--size", 24, "--repeat", 1).out
        self.assertIn("ball", table)
        self.assertNotIn("\u001b", table)

    def test_first_pictures(self):
        suite = {"camera": {"direction": [1, -1.6, 0.9], "distance": 4, "fov": 42},
                 "surfaces": [{"name": "ball", "f": "x^2 + y^2 + z^2 - 1.5", "domain": 2},
                              {"name": "sheet", "f": "z - x*y", "domain": 1}]}
        (self.folder / "suite.json").write_text(json.dumps(suite), encoding="utf-8")
        lines = self.run_ok("dev", "bench", "--first-picture", "--suite", "suite.json", "--size", 64,
                            "--repeat", 1).out.splitlines()
        rows = [line.split() for line in lines if line.split()[0] in ("ball", "sheet")]
        self.assertEqual([row[0] for row in rows], ["ball", "sheet"])
        for row in rows:
            nodes, ready_ms, first_ms = int(row[1]), float(row[2]), float(row[3])
            self.assertGreater(nodes, 2, row)
            self.assertTrue(0 <= ready_ms <= first_ms, row)
        self.assertRegex(lines[-2], r"\Aa new text +median [0-9.]+ ms")

    def test_the_suite_of_the_gallery(self):
        answer = json.loads(self.run_ok("dev", "bench", "--size", 8, "--repeat", 1, "--threads", 1,
                                        "--dstop", 6, "--json", "-").out)
        self.assertEqual(len(answer["surfaces"]), 29)
        self.assertEqual(answer["threads"], 1)

    def test_a_broken_suite(self):
        for text in ("", "{", "{}", '{"camera": 1}', "[]"):
            (self.folder / "suite.json").write_text(text, encoding="utf-8")
            result = run("dev", "bench", "--suite", "suite.json", cwd=self.folder)
            self.assertEqual(result.code, 2, str(result))
            self.assertRegex(result.err, r"\Aerror: --suite suite.json: [^\n]+\n\Z")
            self.assertEqual(result.out, "", str(result))


class CompareTest(ProgramTest):
    def compare(self, *options):
        return json.loads(self.run_ok("dev", "compare", "--size", 40, "--repeat", 1, "--json", "-",
                                      *options).out)

    def write(self, name, answer):
        (self.folder / name).write_text(json.dumps(answer), encoding="utf-8")

    def run_script(self, name, *arguments):
        """Runs a script of the project in the test's folder; returns what it prints."""
        return subprocess.run([sys.executable, SOURCE_DIR / "scripts" / name, *arguments], check=True,
                              cwd=self.folder, stdout=subprocess.PIPE, text=True).stdout

    def test_a_papers_table_beside_its_printed_figures(self):
        answer = self.compare()
        self.assertEqual(answer["table"], "knoll-table-1")
        rows = {(row["surface"], row["d_stop"], row["tracer"]): row for row in answer["rows"]}
        self.assertEqual(len(rows), 2 * 2 * 4)
        for (_, _, tracer), row in rows.items():
            self.assertGreater(row["frame_ms"]["median"], 0)
            self.assertEqual(row["refuted"], 0)
            self.assertEqual(row["missed"], 0)
            self.assertEqual(row["certified"] + row["undecided"] + row["miss"], 40 * 40)
            self.assertEqual(row["printed_ms"] is None, tracer == "beams")
        slow = rows["trilerp", 22, "t-bisection"]
        self.assertAlmostEqual(slow["printed_ms"], 1000 / 0.31)
        self.assertAlmostEqual(slow["printed_times"], 2.8 / 0.31)
        self.assertAlmostEqual(slow["times"], slow["frame_ms"]["median"]
                               / rows["trilerp", 22, "k-bisection"]["frame_ms"]["median"])

    def test_all_tracers_on_chosen_surfaces(self):
        answer = self.compare("--surface", "sphere,planes", "--tracer", "all", "--dstop", "8")
        rows = answer["rows"]
        self.assertEqual({row["surface"] for row in rows}, {"sphere", "planes"})
        proves_nothing = ("point-sampling", "octree-unrounded", "gargantini")
        proving = [row for row in rows if row["tracer"] not in proves_nothing]
        sampled = [row for row in rows if row["tracer"] in proves_nothing]
        self.assertGreater(len(proving), 20)
        self.assertEqual(len(sampled), 2 * len(proves_nothing))
        for row in proving:
            self.assertEqual((row["missed"], row["refuted"]), (0, 0), row)
            self.assertGreater(row["certified"], row["undecided"], row)
        for row in sampled:
            self.assertEqual(row["certified"], 0)

    def test_text_and_file(self):
        table = self.run_ok("dev", "compare", "florez-table-4.1", "--surface", "sphere",
                            "--size", 24, "--repeat", 1, "--json", "compare.json").out
        for word in ("Florez 2008", "mrfro-newton", "printed", "missed", "Horned Cube"):
            self.assertIn(word, table)
        lines = [line for line in table.splitlines() if line.startswith("sphere")]
        self.assertEqual(len(lines), 6)
        self.assertEqual(len({len(line.rstrip()) for line in lines}), 1)  # aligned
        answer = json.loads((self.folder / "compare.json").read_text(encoding="utf-8"))
        self.assertEqual(len(answer["rows"]), 6)

    def test_grids_refute_nothing(self):
        answer = json.loads(self.run_ok("dev", "compare", "--size", 200, "--repeat", 1, "--json", "-",
                                        "--surface", "sphere,blobby", "--tracer",
                                        "regular-grid,florez-boxes", "--dstop", "22").out)
        for row in answer["rows"]:
            self.assertEqual((row["missed"], row["added"], row["refuted"]), (0, 0, 0), row)

    def test_boxes_of_the_image(self):
        answer = self.compare("florez-table-5.1", "--surface", "sphere", "--tracer",
                              "mrfro,florez-boxes,florez-trimming")
        rows = {row["tracer"]: row for row in answer["rows"]}
        self.assertNotIn("boxes", rows["mrfro"])
        for tracer in ("florez-boxes", "florez-trimming"):
            boxes = rows[tracer]["boxes"]
            kinds = [boxes[kind] for kind in ("rejected", "included", "undefined")]
            self.assertEqual(sum(kind["pixels"] for kind in kinds), 40 * 40)
            self.assertGreater(boxes["rejected"]["boxes"], 0)
            self.assertEqual(boxes["included"]["boxes"] > 0, tracer == "florez-boxes")
            self.assertEqual((rows[tracer]["missed"], rows[tracer]["refuted"]), (0, 0))
        self.write("boxes.json", answer)
        _, saved = self.run_script("papers_tables.py", "boxes.json").split("\n\n", 1)
        rows = [line for line in saved.splitlines() if line.startswith("| sphere")]
        self.assertEqual([row.split("`")[1] for row in rows], ["florez-boxes", "florez-trimming"])
        self.assertEqual(saved.count("| as printed | 92 (36.5 %) | - | 648 (63.5 %) | 790 |"), 2)

    def test_printed_boxes_are_of_one_picture(self):
        printed = json.loads((SOURCE_DIR / "papers/compare/printed_tables.json").read_text("utf-8"))
        table = next(table for table in printed["tables"] if table["name"] == "florez-table-5.1")
        times = {row["surface"]: row["values"] for row in table["rows"]}
        self.assertEqual(set(table["boxes"]), set(times))
        for surface, boxes in table["boxes"].items():
            classic_s, trimmed_s = times[surface]
            self.assertEqual(boxes["rejected_pixels"] + boxes["kept_pixels"], 301 * 301)
            # Classic rays are those in both kinds of boxes together.
            self.assertAlmostEqual(boxes["rejected_s"] + boxes["kept_s"], classic_s, delta=0.02)
            self.assertAlmostEqual(boxes["trimming_s"] + boxes["kept_s"], trimmed_s, delta=0.02)

    def test_mirrors_of_stoltes_table(self):
        answer = self.compare("stolte-table-1", "--surface", "spheres")
        rows = {(row["tracer"], row["reflections"]): row for row in answer["rows"]}
        self.assertEqual(set(rows), {(tracer, mirrors) for mirrors in (0, 5) for tracer in
                                     ("beams", "gargantini", "octree-unrounded", "octree")})
        self.assertEqual(rows["octree", 5]["printed_ms"], 27062)
        self.assertEqual(rows["octree", 0]["printed_ms"], 19860)
        self.assertEqual(rows["octree", 0]["d_stop"], 30)
        self.assertEqual(rows["beams", 0]["d_stop"], 22)
        for row in rows.values():
            self.assertEqual((row["missed"], row["refuted"]), (0, 0), row)

    def plot(self, answer):
        """Returns the words and circles of a plot."""
        self.write("compare.json", answer)
        self.run_script("plot_compare.py", "compare.json", "plot.svg")
        root = ElementTree.parse(self.folder / "plot.svg").getroot()
        space = "{http://www.w3.org/2000/svg}"
        return (["".join(text.itertext()) for text in root.iter(space + "text")],
                list(root.iter(space + "circle")))

    def test_plots(self):
        words, circles = self.plot(self.compare("--surface", "mitchell"))
        self.assertIn("mitchell, d_stop 10", words)
        self.assertEqual(words.count("t-bisection"), 2)
        rings = [circle for circle in circles if circle.get("fill") == "none"]
        self.assertEqual(len(rings), 2 * 3 + 1)  # and one of the legend

    def test_a_plots_axis_is_logarithmic(self):
        row = {"surface": "a", "wanted_d_stop": 22, "reflections": 0, "missed": 0, "added": 0,
               "printed_times": None}
        figures = [("mrf", 10, 1000, 1, 0), ("mrfro", 100, 10000, 10, 7), ("newton", 1000, 10, 100, 0)]
        rows = [row | {"tracer": tracer, "frame_ms": {"median": ms}, "printed_ms": printed,
                       "times": times, "missed": missed}
                for tracer, ms, printed, times, missed in figures]
        words, circles = self.plot({"source": "A paper", "machine_printed": "a machine", "width": 8,
                                    "height": 8, "threads": 1, "rows": rows})
        places = [float(circle.get("cx")) for circle in circles if float(circle.get("cy")) > 60]
        rings, dots = places[0::2], places[1::2]
        self.assertAlmostEqual(dots[2] - dots[1], dots[1] - dots[0], 1)
        self.assertGreater(dots[1] - dots[0], 50)
        self.assertEqual(rings[::2], dots[::-2])
        for text in ("10 ms ×1", "10 s", "100 ms ×107 pixels wrong"):
            self.assertIn(text, words)

    def test_rays_in_voxels(self):
        answer = json.loads(self.run_ok("dev", "compare", "marmitt-table-2", "--json", "-").out)
        rows = {row["method"]: row for row in answer["rows"]}
        self.assertEqual(list(rows), ["midpoint", "linear", "neubauer", "schwarze", "marmitt"])
        self.assertEqual(rows["marmitt"]["printed"], {"min": 0.85, "max": 4.8, "avg": 4.35})
        for row in rows.values():
            self.assertEqual(row["voxels"], 7 * 256 * 256)
            self.assertGreater(row["millions_per_s"]["avg"], 0)
        words, _ = self.plot(answer)
        self.assertIn("Marmitt et al. 2004, table 2, SIMD: time of a million intersections", words)
        self.assertIn("230 ms ×20", words)

    def test_solids_both_ways(self):
        answer = self.compare("florez-figure-6.2", "--dstop", 16)
        for row in answer["rows"]:
            self.assertEqual((row["missed"], row["refuted"]), (0, 0), row)
            self.assertIsNone(row["printed_ms"])
            self.assertIsNotNone(row["times"])
        self.assertEqual({row["tracer"] for row in answer["rows"]},
                         {"beams", "mrfro", "csg-by-roots"})

    def test_shadows_by_beams_and_by_rays(self):
        answer = json.loads(self.run_ok("dev", "compare", "florez-figure-5.13", "--size", 240, "--json",
                                        "-").out)
        self.assertEqual(len(answer["rows"]), 2 * 4)
        for beams, rays in zip(*[iter(answer["rows"])] * 2):
            self.assertEqual([row["way"] for row in (beams, rays)], ["beams", "rays"])
            self.assertEqual(beams["hits"], rays["hits"])
            self.assertGreater(rays["hits"], 500)
            self.assertLess(beams["cells_per_hit"], rays["cells_per_hit"])
            self.assertEqual(rays["refuted"], 0)

    def test_animations_by_one_grid(self):
        for figure in ("florez-figure-6.8", "florez-figure-6.10", "florez-figure-6.12"):
            answer = json.loads(self.run_ok("dev", "compare", figure, "--size", 24, "--json", "-").out)
            self.assertEqual([row["frame"] for row in answer["rows"]], [0, 5, 10, 15])
            for row in answer["rows"]:
                self.assertGreaterEqual(row["one_grid"]["cells"], row["grid_each"]["cells"])
                self.assertGreater(row["grid_each"]["cells"], 100)
                self.assertLess(row["one_grid"]["cells"], 32**3)
