"""Compares `zeroset render --depth` with closed forms, for several surfaces, cameras and boxes."""

import math

from rays import Box, Camera, Cylinder, Plane, QuarticTorus, Sphere, Torus, dot
from zeroset_program import ProgramTest

GRAZING = 0.2  # cosine to the normal below which a small error of f is a large one of depth

CUBE = Box.of(2)
OFF_CENTRE = Box(0.5, 3.0, -2.0, 1.5, -0.25, 2.25)
ABOVE = Camera((0.5, 0.3, 5), up=(0, 1, 0))
# (name, surface, box, camera, width, height)
SCENES = [
    ("sphere, default camera", Sphere(), CUBE, None, 33, 17),
    ("sphere cut by the box", Sphere(radius=1.5), Box(-1, 1, -2, 2, -1.2, 2), None, 31, 31),
    ("sphere, wide angle, off centre", Sphere((0.3, -0.2, 0.1), 0.9), CUBE,
     Camera((2.5, 1.5, 1.0), (0.5, 0.2, -0.3), fov=90), 33, 17),
    ("sphere around the eye", Sphere(radius=1.75), CUBE,
     Camera((0.3, -0.4, 0.2), (1.0, 2.0, 0.5), fov=90), 17, 33),
    ("sphere, box off centre", Sphere((1.7, -0.4, 1.1), 1.0), OFF_CENTRE, None, 33, 33),
    ("sphere, roll", Sphere(), CUBE, Camera((0, 5, 0.5), (0, 0, 0), (1, 0.3, 0.2), 30), 20, 33),
    ("sphere far away", Sphere((100, 50, 20), 3.0), Box(96, 104, 46, 54, 16, 24), None, 25, 25),
    ("small sphere", Sphere(radius=0.005), Box.of(0.0078125), None, 33, 17),
    ("torus, default camera", Torus(), CUBE, None, 33, 17),
    ("torus from above", Torus(1.2, 0.4), CUBE, ABOVE, 33, 33),
    ("torus, eye in the box", Torus(1.3, 0.3), CUBE,
     Camera((0, 0.1, 0.2), (2, 1, 0), fov=90), 33, 17),
    ("torus, eye in the tube", Torus(1.0, 0.5), CUBE,
     Camera((1.1, 0, 0.1), (1, 1, 0), fov=90), 33, 17),
    ("quartic torus", QuarticTorus(), CUBE, None, 33, 17),
    ("quartic torus from above", QuarticTorus(1.2, 0.4), CUBE, ABOVE, 33, 33),
    ("cylinder, default camera", Cylinder(), CUBE, None, 33, 17),
    ("cylinder, eye inside", Cylinder(0.8), CUBE,
     Camera((0.1, 0, 0), (1, 1, 0.5), fov=90), 33, 17),
    ("cylinder along x axis view", Cylinder(0.5), Box(-1, 3, -1, 1, -2, 2),
     Camera((6, 0.1, 0)), 17, 33),
    ("plane, default camera", Plane((0.3, -0.5, 1.0), 0.2), CUBE, None, 33, 17),
    ("plane, eye in the box", Plane((1, 2, -0.5), 0.9), CUBE,
     Camera((-0.5, -0.5, 1), (1, 1, 0)), 17, 17),
    ("plane, box off centre", Plane((1, 0.25, 2), 3.5), OFF_CENTRE, None, 41, 23),
    ("plane behind the eye", Plane((1, 0, 0), -1.0), CUBE,
     Camera((0, 0, 0), (1, 0.2, 0.1)), 16, 16),
]


class Expected:
    """The hit or miss of a surface that a ray must show."""

    def __init__(self, surface, box, ray, cell):
        self.surface, self.ray = surface, ray
        self.stretch = cell / max(map(abs, ray.direction))  # length of a cell on the ray
        self.margin = 4.0 * self.stretch
        self.first, self.inside, self.clear = math.inf, False, False
        self.piece = box.clip(ray)
        if self.piece is None:
            return
        t_in, t_out = self.piece
        roots = surface.roots(ray, max(t_in - self.margin, 0.0), t_out + self.margin)
        if not roots:
            return
        self.first = roots[0]
        self.inside = t_in + self.margin < self.first < t_out - self.margin
        cosine = abs(dot(surface.normal(ray.at(self.first)), ray.direction))
        self.clear = self.inside and cosine > GRAZING

    def is_near(self, t):
        """Returns True if the ray's point at t is so close to the surface that it may be drawn."""
        reach = 4.0 * self.surface.cells_early * self.margin
        return abs(self.surface.distance(self.ray.at(t))) < reach


class DepthTest(ProgramTest):
    def check(self, scene, d_stop):
        name, surface, box, camera, width, height = scene
        shown = camera or Camera.default(box, width / height)
        depth = self.depth(surface.equation, "--box", box.option(), *shown.options(),
                           "--size", f"{width}x{height}", "--dstop", d_stop)
        self.assertEqual((depth.width, depth.height), (width, height))
        largest = max(map(abs, box.lo + box.hi))
        float_cell = 2.0 ** (math.frexp(largest)[1] - 22)  # slices are at least two ulp thick
        cell = max(box.edge() * 2.0 ** -d_stop, float_cell)
        rounding = 2.0 ** -20 * (largest + math.sqrt(dot(shown.eye, shown.eye)))
        clear = 0
        for col, row, got in depth.pixels():
            expected = Expected(surface, box, shown.ray(col, row, width, height), cell)
            clear += expected.clear
            self.check_pixel(expected, got, rounding, f"{name}, d_stop {d_stop}, {col},{row}")
        if "behind" not in name:
            self.assertGreater(clear, width * height // 30, name)

    def check_pixel(self, expected, got, rounding, where):
        self.assertFalse(math.isnan(got) or got < 0.0, where)
        if expected.inside:  # no root may be missed, whatever else is drawn
            self.assertLess(got, expected.first + expected.margin + rounding, where)
        if expected.clear:
            early = expected.surface.cells_early * expected.stretch + rounding
            self.assertGreater(got, expected.first - early, where)
            if expected.surface.cells_early < 2.0:
                self.assertLess(got, expected.first + early, where)
        if got != math.inf:
            self.assertIsNotNone(expected.piece, where)
            self.assertGreater(got, expected.piece[0] - expected.stretch - rounding, where)
            self.assertLess(got, expected.piece[1] + expected.stretch + rounding, where)
            self.assertTrue(expected.is_near(got), where)

    def test_depths_at_d_stop_10(self):
        for scene in SCENES:
            with self.subTest(scene[0]):
                self.check(scene, 10)

    def test_depths_at_the_finest_d_stop(self):
        for scene in SCENES:
            with self.subTest(scene[0]):
                self.check(scene, 22)
