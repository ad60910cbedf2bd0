"""Tests of `zeroset explain`: how a formula is read, with values and code."""

import json
import math

from zeroset_program import ProgramTest, run, to_try

SPHERE = "x^2 + y^2 + z^2 = 1"


class ExplainTest(ProgramTest):
    def explain(self, text, *options, **how):
        return json.loads(self.run_ok("explain", text, "--json", *options, **how).out)

    def test_text(self):
        text = self.run_ok("explain", "x^2+y^2 = 1", "--at", "1,2,3").out
        for part in ("x^2 + y^2 - 1 = 0", "nodes", "1, 2, 3, 0", "2, 4, 0"):
            self.assertIn(part, text)

    def test_json(self):
        answer = self.explain("x^2*y = z + 3", "--at", "2,-3,0.5")
        self.assertEqual(set(answer),
                         {"ok", "canonical", "drawn_as", "value", "gradient", "parameters", "nodes",
                          "surfaces", "readings", "notes"})
        self.assertEqual(answer["notes"], [])
        self.assertIs(answer["ok"], True)
        self.assertEqual((answer["value"], answer["gradient"]), (-15.5, [-12.0, 4.0, -1.0]))
        self.assertEqual(answer["parameters"], [])
        self.assertGreaterEqual(answer["nodes"], 5)

    def test_statements(self):
        text = "a = 2; f(u, v) = u^2 + v^2; f(x, y) = a b z, -1 < z < 1; x = c"
        answer = self.explain(text, "--at", "1,2,0.5", "--set", "b=3")
        self.assertEqual(answer["parameters"], ["b", "c"])
        self.assertEqual(answer["readings"],
                         ["a = 2", "f(u, v) = u^2 + v^2",
                          "x^2 + y^2 - 2*b*z = 0, -1 < z and z < 1", "x - c = 0"])
        self.assertEqual([surface["value"] for surface in answer["surfaces"]], [2, 0])
        self.assertEqual(answer["value"], 2)

    def test_notes(self):
        text = "r = 0.5; x^2 + y^2 = r^2, z < 1,5 & x > -1"
        answer = self.explain(text, "--at", "2,1,0")
        self.assertEqual(answer["readings"],
                         ["r = 0.5", "x^2 + y^2 - 0.5^2 = 0, z < 1.5 and -1 < x"])
        self.assertEqual(answer["value"], 4.75)
        self.assertEqual(len(answer["notes"]), 2)
        self.assertIn("built-in r", answer["notes"][0])
        self.assertIn("1,5 is read as 1.5", answer["notes"][1])
        lines = self.run_ok("explain", text).out.splitlines()
        self.assertEqual(lines[0], "with      r = 0.5")
        self.assertEqual(lines[1], "note      " + answer["notes"][0])
        self.assertIn("note      " + answer["notes"][1], lines[2:])

    def test_texts_as_others_write_them(self):
        texts = [
            # Names that could be products, and lines that start with a sign.
            ("cx=0.25\n-(x-cx)^2 + y", -0.5625 + 2),
            ("Iso(x,y,z,t)=x*y-z\nIso2(x,y,z,t)=Iso(x,y,z,t)%2\n-Iso2(z,x,y,t)", -1),
            ("sq(u)=u*u; sq(u)=sq(u)+1; sq(x)+z", 5),
            ("if((x < 0 | x > 0.5) & y > 1, 3, 4) + z", 6),
            ("z*((x > 0) + (y > 5))", 3),
            ("x < 2 ? y - z : z", -1),
            ("/* remark\n of two lines */ x + y // the rest\n% more", 3),
            ("const float a=2.f;\nfloat f(float u) { float v = u*u; return v - a; }\nf(y) + z", 5),
            ("a var-x\nb const 2\nc add a b\nd mul c c", 9),
            ("t = 3.0\nabs(y)^t - z", 5),
            ("0,5x + 1,5y", 3.5),
        ]
        for text, value in texts:
            with self.subTest(text):
                answer = self.explain("-", "--at", "1,2,3", stdin=text)
                self.assertEqual(len(answer["surfaces"]), 1)
                self.assertAlmostEqual(answer["value"], value, delta=1e-12)

    def test_what_is_not_read_is_named_in_one_line(self):
        for text, words in [("mat3 m = mat3(x, y, z);", "matrices"), ("x + noise3d(x, y, z)", "noise"),
                            ("x = cos(u); y = sin(v); z = u", "as a point in one row"),
                            ("f(u) = f(u - 1); f(x)", "defined by itself"),
                            ("for (i = 0; i < 3; i++) x", "program"),
                            ("f_waves(x, y, z)", "noise")]:
            with self.subTest(text):
                result = run("explain", text, cwd=self.folder)
                self.assertEqual(result.code, 2, str(result))
                self.assertIn(words, result.err.splitlines()[0])

    def test_long_texts(self):
        for rows, terms in to_try([(2_000, 20_000), (5_000, 50_000), (20_000, 300_000)], every=3):
            statements = "".join(f"c_{i} = c_{i - 1} + x/{i}\n" for i in range(1, rows))
            answer = self.explain("-", stdin="c_0 = 1\n" + statements + f"c_{rows - 1}")
            self.assertEqual(len(answer["readings"]), rows + 1)
            answer = self.explain("-", "--at", "1,0,0", stdin="x" + "+x*y" * terms)
            self.assertEqual(answer["value"], 1)

    def test_json_without_a_point_has_no_value(self):
        answer = self.explain("-", stdin="x + y\n")
        self.assertEqual((answer["value"], answer["gradient"]), (None, None))

    def test_functions_and_w(self):
        x, y, z, w = 0.7, -0.4, 1.3, 0.25
        formula = "sqrt(x)*sin(y) + exp(z)*w - atan2(y, x) + ln(z)*cos(x) + max(x, y) - abs(y)/2"
        expected = (math.sqrt(x) * math.sin(y) + math.exp(z) * w - math.atan2(y, x)
                    + math.log(z) * math.cos(x) + max(x, y) - abs(y) / 2)
        answer = self.explain(formula, "--at", f"{x},{y},{z},{w}")
        self.assertAlmostEqual(answer["value"], expected, delta=1e-13)
        self.assertAlmostEqual(answer["gradient"][2], math.exp(z) * w + math.cos(x) / z,
                               delta=1e-13)

    def test_canonical_form_is_a_fixed_point(self):
        for text in ("-x^2+y", "x = y", "2*x^3 - -y/(z - 1)", "@klein", "min(x, max(y, z))^2"):
            first = self.explain(text)["canonical"]
            self.assertEqual(self.explain(first)["canonical"], first)

    def test_code(self):
        self.assertIn("define", self.run_ok("explain", SPHERE, "--ir").out)
        assembly = self.run_ok("explain", SPHERE, "--asm").out
        self.assertIn("ret", assembly)
        self.assertNotIn("define", assembly)
