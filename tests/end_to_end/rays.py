"""The camera's rays and their intersections with surfaces of known form, in double precision.

Written from the contract of the command line alone: vertical field of view, rays through pixel
centres, row 0 at the top, the part of the ray in the clip box and in front of the eye counts.
"""

import math

DEFAULT_DIRECTION = (1.0, -1.6, 0.9)
DEFAULT_FOV = 42.0


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def scale(k, a):
    return tuple(k * x for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return scale(1.0 / math.sqrt(dot(a, a)), a)


class Box:
    def __init__(self, x0, x1, y0, y1, z0, z1):
        self.lo, self.hi = (x0, y0, z0), (x1, y1, z1)

    @classmethod
    def of(cls, value):
        """Returns the box of a half edge, or of (x0, x1, y0, y1, z0, z1)."""
        if isinstance(value, (int, float)):
            return cls(-value, value, -value, value, -value, value)
        return cls(*value)

    def centre(self):
        return scale(0.5, add(self.lo, self.hi))

    def edge(self):
        """Returns the longest edge, which d_stop bisections divide."""
        return max(sub(self.hi, self.lo))

    def option(self):
        """Returns the text for the option --box."""
        ends = (f"{lo!r},{hi!r}" for lo, hi in zip(self.lo, self.hi))
        return ",".join(ends)

    def clip(self, ray):
        """Returns (t_in, t_out) of the ray's part in the box and in front of the eye, or None."""
        t_in, t_out = 0.0, math.inf
        for start, step, lo, hi in zip(ray.eye, ray.direction, self.lo, self.hi):
            if step == 0.0:
                if not lo <= start <= hi:
                    return None
                continue
            near, far = sorted(((lo - start) / step, (hi - start) / step))
            t_in, t_out = max(t_in, near), min(t_out, far)
        return (t_in, t_out) if t_in <= t_out else None


class Ray:
    def __init__(self, eye, direction):
        self.eye, self.direction = eye, unit(direction)

    def at(self, t):
        return add(self.eye, scale(t, self.direction))


class Camera:
    def __init__(self, eye, look_at=(0.0, 0.0, 0.0), up=(0.0, 0.0, 1.0), fov=DEFAULT_FOV):
        self.eye, self.look_at, self.up, self.fov = eye, look_at, up, fov

    @classmethod
    def default(cls, box, aspect=1.0):
        """Returns a camera in the default direction, at a distance that suits most boxes."""
        half = 0.5 * math.sqrt(sum(e * e for e in sub(box.hi, box.lo))) / math.sqrt(3.0)
        distance = 4.0 * half / min(1.0, aspect)
        return cls(add(box.centre(), scale(distance, unit(DEFAULT_DIRECTION))), box.centre())

    def options(self):
        def text(vector):
            return ",".join(repr(float(x)) for x in vector)
        return ["--eye", text(self.eye), "--look-at", text(self.look_at), "--up", text(self.up),
                "--fov", repr(float(self.fov))]

    def ray(self, col, row, width, height):
        """Returns the ray through the centre of a pixel."""
        forward = unit(sub(self.look_at, self.eye))
        right = unit(cross(forward, self.up))
        up = cross(right, forward)
        pixel = 2.0 * math.tan(math.radians(self.fov) / 2.0) / height
        u, v = (col + 0.5 - width / 2.0) * pixel, (height / 2.0 - row - 0.5) * pixel
        return Ray(self.eye, add(forward, add(scale(u, right), scale(v, up))))


class Surface:
    """A surface with `distance(p)`, the signed distance; `normal(p)`, for p on the surface; and
    `roots(ray, t_in, t_out)`, the roots in that range in order, at least the first."""

    cells_early = 1.5  # how far before its root a clear hit may be drawn, in cells of d_stop


def _quadratic(a, b, c):
    """Returns the real roots of a t^2 + 2 b t + c in order; none if a = 0."""
    discriminant = b * b - a * c
    if a == 0.0 or discriminant < 0.0:
        return []
    far = -b - math.copysign(math.sqrt(discriminant), b)
    return sorted((far / a, c / far)) if far != 0.0 else [0.0]


class Sphere(Surface):
    def __init__(self, centre=(0.0, 0.0, 0.0), radius=1.0):
        self.centre, self.radius = centre, radius
        x, y, z = centre
        self.equation = f"(x-({x}))^2 + (y-({y}))^2 + (z-({z}))^2 = {radius}^2"

    def distance(self, p):
        return math.sqrt(dot(sub(p, self.centre), sub(p, self.centre))) - self.radius

    def normal(self, p):
        return unit(sub(p, self.centre))

    def roots(self, ray, t_in, t_out):
        to_eye = sub(ray.eye, self.centre)
        ends = _quadratic(1.0, dot(to_eye, ray.direction),
                          dot(to_eye, to_eye) - self.radius ** 2)
        return [t for t in ends if t_in <= t <= t_out]


class Cylinder(Surface):
    """A cylinder about the z axis."""

    def __init__(self, radius=1.0):
        self.radius = radius
        self.equation = f"x^2 + y^2 - {radius}^2"

    def distance(self, p):
        return math.hypot(p[0], p[1]) - self.radius

    def normal(self, p):
        return unit((p[0], p[1], 0.0))

    def roots(self, ray, t_in, t_out):
        (x, y, _), (dx, dy, _) = ray.eye, ray.direction
        ends = _quadratic(dx * dx + dy * dy, x * dx + y * dy, x * x + y * y - self.radius ** 2)
        return [t for t in ends if t_in <= t <= t_out]


class Plane(Surface):
    def __init__(self, normal, offset):
        self.direction, self.offset = normal, offset
        a, b, c = normal
        self.equation = f"({a})*x + ({b})*y + ({c})*z = {offset}"

    def distance(self, p):
        size = math.sqrt(dot(self.direction, self.direction))
        return (dot(self.direction, p) - self.offset) / size

    def normal(self, _):
        return unit(self.direction)

    def roots(self, ray, t_in, t_out):
        slope = dot(self.direction, ray.direction)
        if slope == 0.0:
            return []
        t = (self.offset - dot(self.direction, ray.eye)) / slope
        return [t] if t_in <= t <= t_out else []


class Torus(Surface):
    """A torus about the z axis."""

    def __init__(self, ring=1.0, tube=0.5):
        self.ring, self.tube = ring, tube
        self.equation = f"({ring} - sqrt(x^2 + y^2))^2 + z^2 = {tube}^2"

    def distance(self, p):
        return math.hypot(math.hypot(p[0], p[1]) - self.ring, p[2]) - self.tube

    def normal(self, p):
        ring_point = scale(self.ring, unit((p[0], p[1], 0.0)))
        return unit(sub(p, ring_point))

    def roots(self, ray, t_in, t_out):
        """Returns the first root. A step of the distance to the torus skips no root."""
        t = t_in
        while t <= t_out:
            step = abs(self.distance(ray.at(t)))
            t += step
            if step < 1e-13:
                return [t]
        return []


class QuarticTorus(Torus):
    """The torus (x^2 + y^2 + z^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + y^2). The squares occur twice, so
    that intervals of it are wide and K-bisection stops some cells early."""

    cells_early = 12.0

    def __init__(self, ring=1.0, tube=0.5):
        super().__init__(ring, tube)
        self.equation = f"(x^2 + y^2 + z^2 + {ring}^2 - {tube}^2)^2 = 4*{ring}^2*(x^2 + y^2)"
