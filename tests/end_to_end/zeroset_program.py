"""Common parts of the end-to-end tests: running the program, reading files that it and X write."""

import array
import os
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

TIMEOUT_S = 60
SOURCE_DIR = Path(__file__).resolve().parents[2]


def to_try(cases, every):
    """Returns the cases that a test tries: in the usual run one of `every`; all of them in a long
    run, where ZEROSET_LONG is set, as by the nightly script."""
    return list(cases)[:: 1 if "ZEROSET_LONG" in os.environ else every]


def program():
    """Returns the path of the program under test, the script's first argument."""
    return os.environ["ZEROSET_PROGRAM"]


def main(at_once=1):
    """Runs unittest.main for scripts called as SCRIPT PATH_OF_PROGRAM [unittest's arguments].
    Without arguments, `at_once` tests run at a time, each in a process of its own; meant for tests
    that mostly wait."""
    if len(sys.argv) < 2 or not os.access(sys.argv[1], os.X_OK):
        sys.exit(f"usage: {sys.argv[0]} PATH_OF_PROGRAM [TEST...]")
    os.environ["ZEROSET_PROGRAM"] = os.path.abspath(sys.argv.pop(1))
    if at_once > 1 and len(sys.argv) == 1:
        sys.exit(run_apart(at_once))
    unittest.main()


def test_names(suite):
    for test in suite:
        if isinstance(test, unittest.TestSuite):
            yield from test_names(test)
        else:
            yield test.id().removeprefix("__main__.")


def run_apart(at_once):
    """Runs each test of the script in its own process; returns 0 if there are any and all pass."""
    names = list(test_names(unittest.defaultTestLoader.loadTestsFromModule(
        sys.modules["__main__"])))

    def run_one(name):
        return subprocess.run([sys.executable, sys.argv[0], os.environ["ZEROSET_PROGRAM"], name],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)

    failed = 0
    with ThreadPoolExecutor(at_once) as pool:
        for name, done in zip(names, pool.map(run_one, names)):
            if done.returncode != 0:
                failed += 1
                print(f"{name}\n{done.stdout.decode(errors='replace')}")
    print(f"{len(names)} tests, {failed} failed")
    return 1 if failed or not names else 0


def environment(**changes):
    """Returns this process's environment without a display; a change to None removes a variable."""
    result = dict(os.environ, LC_ALL="C.UTF-8")
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "ZEROSET_SCALE", "ZEROSET_EGL", "XDG_STATE_HOME",
                 "XDG_CONFIG_HOME", "XDG_CACHE_HOME"):
        result.pop(name, None)
    for name, value in changes.items():
        result.pop(name, None)
        if value is not None:
            result[name] = value
    return result


class Result:
    """Exit code and output of a finished run."""

    def __init__(self, arguments, done):
        self.arguments = arguments
        self.code = done.returncode
        self.out = done.stdout.decode("utf-8")
        self.err = done.stderr.decode("utf-8")

    def __str__(self):
        return f"{self.arguments}: exit code {self.code}\n{self.out}{self.err}"


def run(*arguments, stdin="", cwd=None, timeout=TIMEOUT_S, env=None, of=None):
    """Runs the program, or the one in the file `of`, without a display and returns its Result."""
    words = [str(argument) for argument in arguments]
    done = subprocess.run([of or program(), *words], input=stdin.encode("utf-8"), cwd=cwd,
                          capture_output=True, timeout=timeout, check=False,
                          env=env or environment())
    return Result(words, done)


class ProgramTest(unittest.TestCase):
    """Base of tests with an empty folder of their own, `self.folder`."""

    longMessage = True

    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="zeroset_test_")
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)

    def run_ok(self, *arguments, **how):
        """Runs the program in the test's folder; it must succeed with nothing on stderr."""
        result = run(*arguments, cwd=self.folder, **how)
        self.assertEqual(result.code, 0, str(result))
        self.assertEqual(result.err, "", str(result))
        return result

    def depth(self, *arguments, **how):
        """Returns the depth picture of `zeroset render ARGUMENTS`."""
        self.run_ok("render", *arguments, "--depth", "depth.pfm", **how)
        return read_pfm(self.folder / "depth.pfm")

    def picture(self, *arguments, **how):
        """Returns the colour picture of `zeroset render ARGUMENTS`."""
        self.run_ok("render", *arguments, "-o", "picture.png", **how)
        return read_png(self.folder / "picture.png")

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())


class Depth:
    """A picture of distances from the eye; row 0 is the top."""

    def __init__(self, width, height, values):
        self.width, self.height, self.values = width, height, values

    def at(self, col, row):
        return self.values[row * self.width + col]

    def pixels(self):
        """Yields (col, row, depth) of every pixel."""
        for index, value in enumerate(self.values):
            yield index % self.width, index // self.width, value

    def hits(self):
        return sum(value != float("inf") for value in self.values)


def read_pfm(path):
    """Reads a grayscale little-endian PFM, which stores its rows from bottom to top."""
    data = Path(path).read_bytes()
    magic, size, scale, body = data.split(b"\n", 3)
    width, height = (int(number) for number in size.split())
    if magic != b"Pf" or float(scale) != -1.0 or len(body) != 4 * width * height:
        raise ValueError(f"{path} is no grayscale little-endian PFM of {width} x {height}")
    rows = [body[4 * width * row:4 * width * (row + 1)] for row in range(height)]
    values = array.array("f", b"".join(reversed(rows)))
    if sys.byteorder == "big":
        values.byteswap()
    return Depth(width, height, values)


class Image:
    """A picture of three bytes per pixel, red first; row 0 is the top."""

    def __init__(self, width, height, rgb):
        self.width, self.height, self.rgb = width, height, rgb

    def at(self, col, row):
        start = 3 * (row * self.width + col)
        return tuple(self.rgb[start:start + 3])

    def rows(self, step=1):
        """Returns every step-th row as a picture."""
        lines = [self.rgb[3 * row * self.width:3 * (row + 1) * self.width]
                 for row in range(0, self.height, step)]
        return Image(self.width, len(lines), b"".join(lines))

    def colors(self):
        """Returns the set of colours in the picture."""
        return {self.rgb[i:i + 3] for i in range(0, len(self.rgb), 3)}

    def difference(self, other, tolerance=0):
        """Returns the fraction of pixels in which a channel differs by more than `tolerance`."""
        if (self.width, self.height) != (other.width, other.height):
            return 1.0
        if self.rgb == other.rgb:
            return 0.0
        far = [abs(a - b) > tolerance for a, b in zip(self.rgb, other.rgb)]
        pixels = zip(far[0::3], far[1::3], far[2::3])
        return sum(map(any, pixels)) / (self.width * self.height)


def _unfilter(kind, line, above, bpp):
    """Undoes a PNG row filter, in place."""
    for i in range(len(line) if kind else 0):
        left = line[i - bpp] if i >= bpp else 0
        corner = above[i - bpp] if i >= bpp else 0
        if kind == 1:
            guess = left
        elif kind == 2:
            guess = above[i]
        elif kind == 3:
            guess = (left + above[i]) // 2
        elif kind == 4:
            start = left + above[i] - corner
            guess = min((abs(start - near), order, near)
                        for order, near in enumerate((left, above[i], corner)))[2]
        else:
            raise ValueError(f"PNG filter {kind}")
        line[i] = (line[i] + guess) & 0xFF


def read_png(path):
    """Reads an 8-bit RGB PNG without interlacing; checks the checksums."""
    data = Path(path).read_bytes()
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError(f"{path} is no PNG")
    at, packed, header, ended = 8, b"", None, False
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        body = data[at + 8:at + 8 + length]
        if zlib.crc32(kind + body) != struct.unpack_from(">I", data, at + 8 + length)[0]:
            raise ValueError(f"{path}: bad checksum of {kind!r}")
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        packed += body if kind == b"IDAT" else b""
        ended = kind == b"IEND"
        at += 12 + length
    if not ended or header is None or header[2:] != (8, 2, 0, 0, 0):
        raise ValueError(f"{path}: not a whole 8-bit RGB PNG, {header}")
    width, height = header[:2]
    raw, stride = zlib.decompress(packed), 3 * width
    rows, above = [], bytes(stride)
    for row in range(height):
        start = row * (stride + 1)
        line = bytearray(raw[start + 1:start + 1 + stride])
        _unfilter(raw[start], line, above, 3)
        rows.append(bytes(line))
        above = line
    return Image(width, height, b"".join(rows))


def read_xwd(data, crop=None):
    """Reads a screenshot as Xvfb -fbdir stores it: 32 bits per pixel, ZPixmap. `crop` is the part
    to read: left, top, right, bottom."""
    fields = struct.unpack_from(">25I", data)
    header_size, version, _, _, width, height, _, byte_order = fields[:8]
    bits, stride, entries = fields[11], fields[12], fields[19]
    if version != 7 or bits != 32:
        raise ValueError(f"XWD version {version} with {bits} bits a pixel")
    left, top, right, bottom = crop or (0, 0, width, height)
    start = header_size + 12 * entries
    rows = []
    for row in range(top, bottom):
        line = data[start + row * stride + 4 * left:start + row * stride + 4 * right]
        rgb = bytearray(3 * (right - left))
        for channel in range(3):  # blue is the low byte
            rgb[channel::3] = line[2 - channel::4] if byte_order == 0 else line[1 + channel::4]
        rows.append(bytes(rgb))
    return Image(right - left, bottom - top, b"".join(rows))
