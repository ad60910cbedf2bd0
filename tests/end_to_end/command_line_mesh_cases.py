"""Tests of `zeroset mesh`: its files, read by readers of their own, and what it refuses."""

import json
import math
import struct
import zipfile
from collections import Counter
from xml.etree import ElementTree

from zeroset_program import ProgramTest, run

SPHERE = "x^2 + y^2 + z^2 = 1"
PLENTY = ["--budget", "600"]  # of seconds, however busy the machine is
CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
MATERIAL = "{http://schemas.microsoft.com/3dmanufacturing/material/2015/02}"


IMPLICIT = "{http://schemas.3mf.io/3dmanufacturing/implicit/2023/12}"
VOLUMETRIC = "{http://schemas.3mf.io/3dmanufacturing/volumetric/2022/01}"
NODES = {"addition": lambda a, b: a + b, "subtraction": lambda a, b: a - b,
         "multiplication": lambda a, b: a * b, "division": lambda a, b: a / b,
         "sqrt": math.sqrt, "sin": math.sin, "exp": math.exp, "abs": abs, "min": min, "max": max,
         "floor": math.floor, "select": lambda a, b, c, d: c if a < b else d}


def value_of_function(function, point):
    """The output of an implicit function of 3MF at a point, node by node."""
    nodes = list(function)
    assert [node.tag for node in (nodes[0], nodes[-1])] == [IMPLICIT + "in", IMPLICIT + "out"]
    values = {}
    for node in nodes[1:-1]:
        kind, name = node.tag.removeprefix(IMPLICIT), node.get("identifier")
        assert name.isalnum() and name not in ("inputs", "outputs")
        outputs = [out.get("identifier") for out in node.find(IMPLICIT + "out")]
        if kind == "constant":
            results = [float(node.get("value"))]
        elif kind == "decomposevector":
            assert node.find(IMPLICIT + "in")[0].get("ref") == "inputs.pos"
            results = point
        else:
            inputs = node.find(IMPLICIT + "in")
            assert [i.get("identifier") for i in inputs] == list("ABCD"[:len(inputs)])
            results = [NODES[kind](*[values[i.get("ref")] for i in inputs])]
        assert len(outputs) == len(results)
        values |= {f"{name}.{output}": value for output, value in zip(outputs, results)}
    return values[nodes[-1][0].get("ref")]


def is_closed(triangles):
    """Whether each edge has two triangles, which run along it in opposite directions."""
    edges = Counter((t[k], t[(k + 1) % 3]) for t in triangles for k in range(3))
    return all(count == 1 and edges[b, a] == 1 for (a, b), count in edges.items())


def joined(points, triangles):
    """Points and triangles with all equal points joined, as many readers do."""
    numbers = {}
    for point in points:
        numbers.setdefault(tuple(point), len(numbers))
    return list(numbers), [[numbers[tuple(points[i])] for i in t] for t in triangles]


def volume_of(points, triangles):
    total = 0.0
    for a, b, c in ([points[i] for i in t] for t in triangles):
        total += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                  + a[2] * (b[0] * c[1] - b[1] * c[0]))
    return total / 6


def read_stl(path):
    data = path.read_bytes()
    count = struct.unpack_from("<I", data, 80)[0]
    assert len(data) == 84 + 50 * count and not data.startswith(b"solid")
    numbers, points, triangles = {}, [], []
    for i in range(count):
        row = struct.unpack_from("<12f", data, 84 + 50 * i)
        corners = [row[3:6], row[6:9], row[9:12]]
        triangles.append([numbers.setdefault(c, len(numbers)) for c in corners])
    points = list(numbers)
    return points, triangles


def read_ply(path):
    data = path.read_bytes()
    end = data.index(b"end_header\n") + 11
    header = data[:end].decode("ascii")
    vertices = int(header.split("element vertex ")[1].split()[0])
    faces = int(header.split("element face ")[1].split()[0])
    rows = [struct.unpack_from("<6f3Bf", data, end + 31 * i) for i in range(vertices)]
    start = end + 31 * vertices
    assert len(data) == start + 13 * faces
    triangles = [struct.unpack_from("<B3i", data, start + 13 * i)[1:] for i in range(faces)]
    return header, rows, triangles


def read_obj(path):
    points, normals, triangles = [], [], []
    for line in path.read_text().splitlines():
        word, *rest = line.split()
        if word == "v":
            points.append(tuple(map(float, rest)))
        elif word == "vn":
            normals.append(tuple(map(float, rest)))
        elif word == "f":
            corners = [corner.split("//") for corner in rest]
            assert all(1 <= int(n) <= len(normals) for _, n in corners)
            triangles.append([int(v) - 1 for v, _ in corners])
    return points, triangles


def read_3mf(path):
    with zipfile.ZipFile(path) as package:
        assert package.testzip() is None
        assert {"[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"} <= set(package.namelist())
        return ElementTree.fromstring(package.read("3D/3dmodel.model"))


def mesh_of_3mf(model):
    corners = [[float(v.get(c)) for c in "xyz"] for v in model.iter(f"{CORE}vertex")]
    return corners, [[int(t.get(f"v{k}")) for k in (1, 2, 3)] for t in model.iter(f"{CORE}triangle")]


def mesh_of_glb(about, data):
    primitive = about["meshes"][0]["primitives"][0]
    accessors = [about["accessors"][i] for i in (primitive["attributes"]["POSITION"], primitive["indices"])]
    starts = [about["bufferViews"][a["bufferView"]]["byteOffset"] for a in accessors]
    points = [struct.unpack_from("<3f", data, starts[0] + 12 * i) for i in range(accessors[0]["count"])]
    flat = struct.unpack_from(f"<{accessors[1]['count']}I", data, starts[1])
    return points, [flat[i:i + 3] for i in range(0, len(flat), 3)]


def read_glb(path):
    data = path.read_bytes()
    magic, version, length, json_length, kind = struct.unpack_from("<4sIII4s", data)
    assert (magic, version, length, kind) == (b"glTF", 2, len(data), b"JSON")
    about = json.loads(data[20:20 + json_length])
    data_length, kind = struct.unpack_from("<I4s", data, 20 + json_length)
    assert kind == b"BIN\0" and about["buffers"][0]["byteLength"] == data_length
    return about, data[28 + json_length:]


class MeshTest(ProgramTest):
    def mesh(self, name, *arguments, equation=SPHERE):
        path = self.folder / name
        self.run_ok("mesh", equation, "-o", path, "--tolerance", "0.02", *PLENTY, *arguments)
        return path

    def check(self, points, triangles, size, wanted_volume):
        self.assertTrue(is_closed(triangles))
        for axis in range(3):
            values = [p[axis] for p in points]
            self.assertAlmostEqual(max(values) - min(values), size, delta=0.03 * size)
        self.assertAlmostEqual(volume_of(points, triangles) / wanted_volume, 1, delta=0.04)

    def test_stl(self):
        points, triangles = read_stl(self.mesh("a.stl"))
        self.check(points, triangles, 100, 523_599)

    def test_ply_has_normals_colors_and_errors(self):
        path = self.mesh("a.ply", "--size", "20", "--color-by", "normal")
        header, rows, triangles = read_ply(path)
        self.assertIn("comment", header)
        points = [row[:3] for row in rows]
        self.check(points, triangles, 20, 4188.8)
        self.assertGreater(len({row[6:9] for row in rows}), len(rows) // 2)
        for row in rows:
            self.assertAlmostEqual(sum(n * n for n in row[3:6]), 1, delta=1e-5)
            self.assertGreater(sum(p * n for p, n in zip(row[:3], row[3:6])), 9.5)
            self.assertTrue(0 <= row[9] <= 0.02 * 10.5)

    def test_obj(self):
        self.check(*read_obj(self.mesh("a.obj")), 100, 523_599)

    def test_3mf_has_an_object_and_colors_for_each_surface(self):
        two = SPHERE + "; (x - 1)^2 + y^2 + z^2 = 0.25"
        model = read_3mf(self.mesh("a.3mf", "--color-by", "height", equation=two))
        self.assertEqual(model.get("unit"), "millimeter")
        objects = model.findall(f"{CORE}resources/{CORE}object")
        self.assertEqual(len(objects), 2)
        self.assertEqual(len(model.findall(f"{CORE}build/{CORE}item")), 2)
        groups = {group.get("id"): len(group)
                  for group in model.findall(f"{CORE}resources/{MATERIAL}colorgroup")}
        for item in objects:
            triangles = item.findall(f"{CORE}mesh/{CORE}triangles/{CORE}triangle")
            corners = [[int(t.get(f"v{k}")) for k in (1, 2, 3)] for t in triangles]
            self.assertTrue(is_closed(corners))
            colors = groups[item.get("pid")]
            self.assertGreater(colors, 10)
            self.assertTrue(all(int(t.get("p3")) < colors for t in triangles))

    def test_3mf_holds_the_formulas_themselves(self):
        path = self.folder / "a.3mf"
        two = "x^2 + y^2 + z^2 = a, z < x\n(x - 1)^2 + sin(3y) + exp(z) = sqrt(2)"
        self.run_ok("mesh", two, "-o", path, "--implicit", "--set", "a=1.5", "--box", "2", "--size", "80")
        model = read_3mf(path)
        self.assertEqual(model.get("requiredextensions"), "v i")
        functions = model.findall(f"{CORE}resources/{IMPLICIT}implicitfunction")
        self.assertEqual(len(functions), 2)
        for x, y, z in ((0.3, -0.2, 0.1), (1.5, 1, -1), (-0.5, 1.9, 1.2)):
            ball = x * x + y * y + z * z - 1.5
            self.assertAlmostEqual(value_of_function(functions[0], (x, y, z)), max(ball, z - x), 12)
            wave = (x - 1) ** 2 + math.sin(3 * y) + math.exp(z) - math.sqrt(2)
            self.assertAlmostEqual(abs(value_of_function(functions[1], (x, y, z))), abs(wave), 12)
        sets = model.findall(f"{CORE}resources/{CORE}object/{VOLUMETRIC}levelset")
        self.assertEqual([s.get("functionid") for s in sets], [f.get("id") for f in functions])
        self.assertEqual(sets[0].get("transform").split()[::4], ["0.05"] * 3)
        box = model.find(f"{CORE}resources/{CORE}object/{CORE}mesh")
        corners = [[float(v.get(c)) for c in "xyz"] for v in box.iter(f"{CORE}vertex")]
        triangles = [[int(t.get(f"v{k}")) for k in (1, 2, 3)] for t in box.iter(f"{CORE}triangle")]
        self.assertTrue(is_closed(triangles))
        self.assertAlmostEqual(volume_of(corners, triangles), 80.0 ** 3, 6)
        # What was written opens again, as the same surface.
        again = self.run_ok("explain", path, "--at", "6,-4,2", "--json")
        ball = (0.3 ** 2 + 0.2 ** 2 + 0.1 ** 2) - 1.5
        self.assertAlmostEqual(json.loads(again.out)["surfaces"][0]["value"], max(ball, 0.1 - 0.3), 12)

    def test_what_formulas_in_3mf_do_not_go_with_is_refused(self):
        path = self.folder / "a.3mf"
        for text, options, words in ((SPHERE, ["--wall", "2"], "--wall is about triangles"),
                                     ("noise(x, y, z) = 0", [], "no node for volumes, noise"),
                                     ("(u, v, u v), 0 < u < 1, 0 < v < 1", [], "parametric")):
            result = run("mesh", text, "-o", path, "--implicit", *options, cwd=self.folder)
            self.assertEqual(result.code, 2, str(result))
            self.assertIn(words, result.err)
        result = run("mesh", SPHERE, "-o", self.folder / "a.stl", "--implicit", cwd=self.folder)
        self.assertEqual(result.code, 2, str(result))
        self.assertIn("-o NAME.3mf", result.err)

    def test_glb_is_in_metres_with_y_up(self):
        about, data = read_glb(self.mesh("a.glb", equation="x^2 + y^2 + z^2/4 = 1"))
        self.assertEqual(about["asset"]["version"], "2.0")
        primitive = about["meshes"][0]["primitives"][0]
        position = about["accessors"][primitive["attributes"]["POSITION"]]
        size = [hi - lo for lo, hi in zip(position["min"], position["max"])]
        self.assertAlmostEqual(size[1], 0.1, delta=0.003)
        self.assertAlmostEqual(size[0], 0.05, delta=0.003)
        view = about["bufferViews"][position["bufferView"]]
        points = [struct.unpack_from("<3f", data, view["byteOffset"] + 12 * i)
                  for i in range(position["count"])]
        indices = about["accessors"][primitive["indices"]]
        start = about["bufferViews"][indices["bufferView"]]["byteOffset"]
        flat = struct.unpack_from(f"<{indices['count']}I", data, start)
        triangles = [flat[i:i + 3] for i in range(0, len(flat), 3)]
        self.check([(p[0], p[1] / 2, p[2]) for p in points], triangles, 0.05, 0.000_065_45)

    def test_boxes_are_closed_once_equal_points_are_joined(self):
        def rows_of_ply(path):
            _, rows, triangles = read_ply(path)
            return [row[:3] for row in rows], triangles

        readers = {"stl": read_stl, "ply": rows_of_ply, "obj": read_obj,
                   "3mf": lambda path: mesh_of_3mf(read_3mf(path)), "glb": lambda path: mesh_of_glb(*read_glb(path))}
        for half in ((1.4, 0.9, 0.45), (1.7, 0.6, 0.35)):
            box = f"max(|x| - {half[0]}, |y| - {half[1]}, |z| - {half[2]}) = 0"
            for ending, read in readers.items():
                with self.subTest(half=half, ending=ending):
                    path = self.folder / f"a.{ending}"
                    # Some of their edges are not proved, which is told.
                    self.assertEqual(run("mesh", box, "-o", path, "--box", "2", *PLENTY).code, 0)
                    points, triangles = joined(*read(path))
                    self.assertTrue(all(len(set(t)) == 3 for t in triangles))
                    self.assertTrue(is_closed(triangles))
                    edge = 0.1 if ending == "glb" else 100
                    volume = edge ** 3 * half[1] * half[2] / half[0] ** 2
                    self.assertAlmostEqual(volume_of(points, triangles) / volume, 1, delta=1e-6)

    def test_stats(self):
        path = self.folder / "a.stl"
        result = self.run_ok("mesh", "@tangle", "-o", path, "--tolerance", "0.05", "--stats", "-", *PLENTY)
        stats = json.loads(result.out)
        surface = stats["surfaces"][0]
        self.assertEqual((surface["euler"], surface["genus"], surface["components"]), (-8, 5, 1))
        self.assertTrue(surface["isotopic"])
        self.assertLessEqual(surface["deviation"], 0.05)
        self.assertEqual(len(read_stl(path)[1]), surface["triangles"])

    def test_smallest_wall_of_a_shell_is_told(self):
        shell = "(x^2 + y^2 + z^2 - 1)*(x^2 + y^2 + z^2 - 0.64) = 0"
        out = self.folder / "a.stl"
        stats = self.folder / "stats.json"
        result = self.run_ok("mesh", shell, "-o", out, "--tolerance", "0.002", "--stats", stats,
                             *PLENTY)
        self.assertRegex(result.out, r"smallest wall 9\.\d+ mm near ")
        surface = json.loads(stats.read_text(encoding="utf-8"))["surfaces"][0]
        self.assertAlmostEqual(surface["smallest_wall"]["mm"], 10, delta=0.2)
        self.assertAlmostEqual(surface["smallest_wall"]["thickness"], 0.2, delta=0.004)
        distance = sum(c * c for c in surface["smallest_wall"]["at"]) ** 0.5
        self.assertAlmostEqual(distance, 0.9, delta=0.01)
        result = self.run_ok("mesh", "z = x*y", "-o", out, "--open", "--tolerance", "0.05", *PLENTY)
        self.assertNotIn("smallest wall", result.out)

    def test_a_budget_that_is_too_small_leaves_a_closed_mesh(self):
        out = self.folder / "a.ply"
        result = run("mesh", "@labs_septic", "-o", out, "--budget", "0.2")
        self.assertEqual(result.code, 3)  # written, but not within the tolerance
        self.assertIn("more than the tolerance", result.err)
        self.assertIn("--budget 0.4", result.err)
        self.assertIn("topology not proved in", result.err)
        self.assertTrue(is_closed(read_ply(out)[2]))

    def test_what_is_not_proved_is_said(self):
        path = self.folder / "a.stl"
        result = run("mesh", "x^2 + y^2 = z^2", "-o", path, "--tolerance", "0.05")
        self.assertEqual(result.code, 0)
        self.assertIn("topology not proved in", result.err)
        self.assertIn("near", result.err)

    def test_refusals_have_one_line_and_write_nothing(self):
        out = self.folder / "a.stl"
        wrong = [(["-o", self.folder / "a.dxf"], ".stl"), (["-o", out, "--tolerance", "0"], "above 0"),
                 (["-o", out, "--size", "-3"], "above 0"), (["-o", out, "--surface", "2"], "1 to 1"),
                 (["-o", out, "--depth", "99"], "3 to 18"), (["-o", out, "--triangles", "x"], "4 to")]
        for arguments, text in wrong:
            with self.subTest(arguments=arguments):
                result = run("mesh", SPHERE, *arguments)
                self.assertEqual(result.code, 2)
                self.assertIn(text, result.err)
                self.assertEqual(len(result.err.splitlines()), 1)
        failing = [[SPHERE, "-o", "/no_such_folder/a.stl"], ["x = 1000", "-o", out]]
        for arguments in failing:
            with self.subTest(arguments=arguments):
                result = run("mesh", *arguments)
                self.assertEqual((result.code, len(result.err.splitlines())), (1, 1))
        self.assertEqual(list(self.folder.iterdir()), [])
