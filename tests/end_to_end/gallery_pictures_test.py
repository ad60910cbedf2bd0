"""Compares every picture of the gallery with an independent computation of its hits."""

import json
import math
import re

from rays import Box, Camera
from zeroset_program import SOURCE_DIR, ProgramTest, main, run, to_try

SIZE = 96
D_STOP = 12
FINE_D_STOP = 16  # silhouettes of all but the wildest polynomials are clear here

# Name: half edge of the clip box, w, and how many of 96 x 96 rays from the default direction meet
# the surface. Counted once by certified isolation of each ray's roots in interval arithmetic.
HITS = {
    "torus": (2, 0, 1128),
    "sphere": (1.5, 0, 1396),
    "parabolic_cylinder": (2, 0, 3014),
    "hyperboloid": (3, 0, 2923),
    "steiner1": (1, 0, 600),
    "steiner2": (1, 0, 3211),
    "mitchell": (3, 0, 998),
    "tangle": (3, 0, 2701),
    "blobby": (2, 0, 755),
    "absolute": (2, 0, 1254),
    "inverse": (2, 0, 2901),
    "teardrop": (1, 0, 1488),
    "planes": (1, 0, 3460),
    "klein": (4, 0, 1822),
    "linked_tori": (1.1, 0, 236),
    "barth_sextic": (2, 0, 2220),
    "heart": (1.5, 0, 1312),
    "trilerp": (1, 0, 4207),
    "morph4d": (3, 0.5, 3930),
    "kusner_schmitt": (3, 0, 282),
    "crosscap": (1.3, 0, 1191),
    "chubs": (1.5, 0, 1874),
    "mcmullen_k3": (3, 0, 842),
    "orthocircle": (1.6, 0, 1421),
    "tritrumpet": (3, 0, 2180),
    "quartdef": (2, 0, 2119),
    "holesrot": (2, 0, 2786),
    "asterisk_3_4": (1.1, 0, 1141),
    "asterisk_9_18": (1.1, 0, 1825),
    "gyroid_ball": (2.05, 0, 2954),
    "barth_decic": (1.9, 0, 2330),
    "gyroid": (6.2832, 0, 5287),
    "clebsch_cubic": (1.5, 0, 3876),
    "cayley_cubic": (2, 0, 1829),
    "kummer_quartic": (1.9, 0, 2872),
    "dervish": (3.5, 0, 2369),
    "labs_septic": (4, 0, 4236),
    "endrass_octic": (3, 0, 2187),
    "chmutov_octic": (1.05, 0, 5055),
    "sarti_dodecic": (3, 0, 3906),
    "dupin_cyclide": (3.2, 0, 1768),
    "enneper": (3, 0, 4296),
    "whitney_umbrella": (1, 0, 2682),
    "kolibri": (1, 0, 2834),
    "ding_dong": (1.5, 0, 2330),
    "distel": (1.05, 0, 675),
    "hunt": (4, 0, 1772),
    "chair": (6, 0, 1613),
    "tiger": (1.7, 0.45, 2488),
    "gyroid_to_schwarz_p": (6.2832, 0.5, 5068),
    "lidinoid": (3.1416, 0, 5105),
    "machined_cube": (1.2, 0, 3736),
}
# Words of functions that are other polynomials, or no polynomials, from cell to cell.
FIELDS = ("volume", "noise", "fbm", "turbulence", "cellular", "cellular2", "blobs", "metaballs",
          "blinn")
LOST = 5    # most rays lost at edges of the clip box, where rounding decides
GAINED = 30  # most undecided rays, which pass a surface very closely
GAINED_BY = {"barth_decic": 60, "chmutov_octic": 150, "sarti_dodecic": 350}


def gallery():
    """Yields the items of the gallery's files."""
    for path in sorted((SOURCE_DIR / "resources" / "gallery").glob("*.json")):
        yield from json.loads(path.read_text(encoding="utf-8"))["items"]


def camera_of(item):
    view = item.get("camera")
    if view is None:
        return Camera.default(Box.of(item["box"]))
    return Camera(tuple(view["eye"]), tuple(view["look_at"]), tuple(view["up"]), view["fov"])


def is_equation(text):
    """Whether an item is one equation, and no point over ranges, curve of two or condition."""
    return "<" not in text and ">" not in text and " and " not in text


def has_words(item):
    """Whether the equation has vectors, words or products without a sign, and is no plain one."""
    if re.search(r"(?<![a-z0-9])[0-9.]+ ?[a-z(]|\) ?[a-z(]|[a-z] [a-z(]", item["equation"]):
        return True
    return "\n" in item["equation"] or "((" in item["equation"] or "vec" in item["equation"] or any(
        word in item["equation"] for word in ("iterate", "rounded_box", "capsule", "octahedron"))


def plain_equation(item):
    """Returns the equation; one with words as it is read, each of them written out."""
    if not has_words(item):
        return item["equation"]
    lines = run("explain", "@" + item["name"]).out.splitlines()
    return next(line[len("read as"):].strip() for line in lines if line.startswith("read as"))


def function_of(item):
    """Returns the function f(x, y, z) of the item's equation; NaN where it is undefined."""
    left, _, right = plain_equation(item).replace("^", "**").partition(" = ")
    text = re.sub(r"\babs\b", "fabs", f"({left}) - ({right or '0'})")
    text = re.sub(r"\bif\(", "choice(", text)
    names = {name: getattr(math, name) for name in
             ("sqrt", "fabs", "sin", "cos", "acos", "atan2", "exp", "log", "pi")}
    names.update(min=min, max=max, ln=math.log, sinh=math.sinh, w=item.get("w", 0.0), __builtins__={},
                 choice=lambda condition, a, b: a if condition else b,
                 round=lambda a: math.floor(a + 0.5), sign=lambda a: (a > 0) - (a < 0))
    compiled = eval(f"lambda x, y, z: {text}", names)  # the text is from our own files

    def f(point):
        try:
            return compiled(*point)
        except (ArithmeticError, ValueError):
            return math.nan

    return f


def first_sign_change(f, ray, t_in, t_out, steps=200):
    """Returns where f first changes sign continuously between samples along the ray, or None."""
    def on_ray(i):
        return t_in + (t_out - t_in) * i / steps

    before = f(ray.at(t_in))
    for i in range(1, steps + 1):
        after = f(ray.at(on_ray(i)))
        if before * after < 0.0:
            root = bisected(f, ray, on_ray(i - 1), on_ray(i), before)
            if abs(f(ray.at(root))) < min(abs(before), abs(after)):  # neither a pole nor a jump
                return root
        before = after
    return None


def bisected(f, ray, start, end, f_start):
    for _ in range(50):
        middle = 0.5 * (start + end)
        if f(ray.at(middle)) * f_start > 0.0:
            start = middle
        else:
            end = middle
    return 0.5 * (start + end)


class GalleryPicturesTest(ProgramTest):
    def test_every_item_is_drawn_in_many_colors(self):
        for item in to_try(gallery(), every=3):
            with self.subTest(item["name"]):
                image = self.picture("@" + item["name"], "--size", SIZE, "--dstop", D_STOP,
                                     "--aa", "none")
                self.assertEqual((image.width, image.height), (SIZE, SIZE))
                self.assertGreater(len(image.colors()), 60)
                background = [image.at(0, row) for row in range(SIZE)]
                drawn = sum(image.at(col, row) != background[row]
                            for row in range(SIZE) for col in range(SIZE))
                self.assertGreater(drawn, 0.05 * SIZE * SIZE)

    def test_silhouettes(self):
        equations = {item["name"] for item in gallery()}
        for name, (half, w, hits) in HITS.items():
            with self.subTest(name):
                self.assertIn(name, equations)
                camera = Camera.default(Box.of(half))
                depth = self.depth("@" + name, "--box", half, "--w", w, *camera.options(),
                                   "--size", SIZE, "--dstop", FINE_D_STOP)
                self.assertGreaterEqual(depth.hits(), hits - LOST)
                self.assertLessEqual(depth.hits(), hits + GAINED_BY.get(name, GAINED))

    def test_depths_against_sign_changes(self):
        for item in to_try(gallery(), every=4):
            if any(word + "(" in item["equation"] for word in FIELDS):
                continue  # the oracles solve each cell's polynomial (tests/oracle)
            if "iterate(" in item["equation"]:
                continue  # too long when written out; its values are tested as plain arithmetic
            if not is_equation(item["equation"]):
                continue  # points and conditions are tested with their kind of row
            with self.subTest(item["name"]):
                self.check_depths(item)

    def check_depths(self, item):
        """Expects, at some pixels, that no sign change is missed and most hits are at one."""
        box, camera, f = Box.of(item["box"]), camera_of(item), function_of(item)
        depth = self.depth("@" + item["name"], *camera.options(), "--size", SIZE,
                           "--dstop", FINE_D_STOP)
        near = 8.0 * box.edge() * 2.0 ** -FINE_D_STOP
        early = near * (100.0 if item["name"] in GAINED_BY else 10.0)
        drawn = agreed = 0
        for row in range(6, SIZE, 12):
            for col in range(6, SIZE, 12):
                ray = camera.ray(col, row, SIZE, SIZE)
                piece, got = box.clip(ray), depth.at(col, row)
                where = f"pixel {col},{row} at {got}"
                if piece is None:
                    self.assertEqual(got, math.inf, where)
                    continue
                root = first_sign_change(f, ray, *piece)
                if root is not None and piece[0] + near < root < piece[1] - near:
                    self.assertLess(got, root + near, where)
                if got != math.inf:
                    self.assertTrue(piece[0] - near < got < piece[1] + near, where)
                    drawn += 1
                    agreed += root is not None and abs(got - root) < early
        self.assertGreaterEqual(drawn, 3)
        self.assertGreaterEqual(agreed, 0.7 * drawn)


class TrapTest(ProgramTest):
    """Tests of surfaces that a careless program draws where they are not."""

    def points(self, item):
        """Returns the points in space that the hits of the item's picture show."""
        camera = camera_of(item)
        depth = self.depth("@" + item["name"], *camera.options(), "--size", SIZE,
                           "--dstop", FINE_D_STOP)
        points = [camera.ray(col, row, SIZE, SIZE).at(t)
                  for col, row, t in depth.pixels() if t != math.inf]
        self.assertGreater(len(points), 500)
        return points

    def item(self, name):
        return next(item for item in gallery() if item["name"] == name)

    def test_inverse_has_no_wall_at_its_pole(self):
        """z = 1 / (x - y^2): in the box, |x - y^2| is at least 1 / |z|."""
        item = self.item("inverse")
        self.assertEqual(item["equation"].replace(" ", ""), "1/(x-y^2)-z")
        for x, y, z in self.points(item):
            self.assertGreater(abs(x - y * y), 1.0 / item["box"] - 0.01, (x, y, z))

    def test_asterisks_have_no_sheet_where_the_angle_jumps(self):
        """r = sin(n angle) sin(m acos(z / r)) is small near the half plane y = 0, x < 0."""
        for name, n, m in (("asterisk_3_4", 3, 4), ("asterisk_9_18", 9, 18)):
            for x, y, z in self.points(self.item(name)):
                self.assertFalse(x < -0.35 and abs(y) < 0.01, (name, x, y, z))
                r = math.sqrt(x * x + y * y + z * z)
                if r > 0.3:
                    expected = math.sin(n * math.atan2(y, x)) * math.sin(m * math.acos(z / r))
                    self.assertAlmostEqual(r, expected, delta=0.03, msg=f"{name} {x} {y} {z}")


if __name__ == "__main__":
    main()
