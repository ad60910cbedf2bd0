"""The octrees' tracers on the command line."""

import json
import math

from zeroset_program import ProgramTest

SPHERE = "x^2 + y^2 + z^2 = 1"


class OctreeTest(ProgramTest):
    """The tracers by octrees, their levels, and the check of their traversals."""

    def traversals(self, *arguments):
        answer = json.loads(self.run_ok("dev", "traversal", SPHERE, "--box", "2", *arguments).out)
        return answer, {row["traversal"]: row for row in answer["traversals"]}

    def test_levels_go_on_where_float_and_d_stop_end(self):
        small = (SPHERE, "--size", "24x20", "--box", "2")
        octree = (*small, "--tracer", "octree", "--levels", 40)
        stats = json.loads(self.run_ok("render", *octree, "--stats", "-").out)
        self.assertEqual((stats["tracer"], stats["precision"]), ("octree", "double"))
        self.assertEqual(stats["certified_width"], 4 * 4 / 2**40)
        self.assertEqual(stats["certified"],
                         json.loads(self.run_ok("render", *small, "--stats", "-").out)["certified"])
        self.assertGreater(stats["certified"], 20)
        self.assertEqual(stats["undecided"], 0)
        pairs = zip(self.depth(*small).pixels(), self.depth(*octree).pixels())
        for (_, _, expected), (col, row, found) in pairs:
            self.assertEqual(math.isinf(expected), math.isinf(found), (col, row))
            if not math.isinf(found):
                self.assertAlmostEqual(expected, found, delta=1e-5)

    def test_what_proves_nothing_decides_nothing(self):
        arguments = ("render", SPHERE, "--size", "24x20", "--box", "2", "--stats", "-")
        sure = json.loads(self.run_ok(*arguments, "--tracer", "octree").out)
        for tracer in ("octree-unrounded", "gargantini"):
            stats = json.loads(self.run_ok(*arguments, "--tracer", tracer).out)
            self.assertEqual(stats["certified"], 0)
            self.assertEqual(stats["surfaces"], sure["surfaces"])
            self.assertGreater(stats["undecided_not_drawn"], 0)

    def test_traversals_are_the_same_but_near_the_limit(self):
        answer, rows = self.traversals("--levels", 20, "--size", 24)
        self.assertEqual(answer["levels"], 20)
        self.assertGreater(answer["voxels"], 100)
        self.assertGreater(answer["octree_bytes"], answer["voxels"])
        for row in rows.values():
            self.assertGreater(row["octants"], 1000)
            self.assertEqual(row["differing"], 0)
        _, rows = self.traversals("--levels", 53, "--size", 24)
        self.assertEqual(rows["octree"]["differing"], 0)
        for name in ("octree-unrounded", "gargantini"):
            self.assertGreater(rows[name]["missed"], 0)
