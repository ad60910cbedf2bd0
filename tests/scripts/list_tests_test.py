#!/usr/bin/env python3
"""Tests that list_tests.py puts each case of a program into exactly one entry."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

LISTER = Path(__file__).with_name("list_tests.py")

# Suites as GoogleTest lists them: one of one file, one of two files, one of a type.
SUITES = {
    "Caps": {"AreFilled": "/root/tests/engine/trace/caps_test.cpp",
             "AreHatched": "/root/tests/engine/trace/caps_test.cpp"},
    "Read": {"Numbers": "../../tests/app/read_test.cpp",
             "Boxes": "../../tests/app/boxes_test.cpp"},
    "Sums/1": {"Hold": "../../tests/app/boxes_test.cpp"},
}

PROGRAM = """#!{python}
import sys
if "--gtest_list_tests" not in sys.argv: sys.exit("asked to run")
report = next(a for a in sys.argv if a.startswith("--gtest_output=json:")).partition(":")[2]
open(report, "w").write({report!r})
"""


class ListTests(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program = Path(folder.name) / "program"
        self.output = Path(folder.name) / "entries.cmake"
        suites = [{"name": name, "testsuite": [{"name": case, "file": file}
                                               for case, file in cases.items()]}
                  for name, cases in SUITES.items()]
        self.write_program(PROGRAM.format(python=sys.executable,
                                          report=json.dumps({"testsuites": suites})))

    def write_program(self, text):
        self.program.write_text(text, encoding="utf-8")
        self.program.chmod(0o755)

    def list(self, *long_entries):
        return subprocess.run([sys.executable, LISTER, self.program, self.output, *long_entries],
                              capture_output=True, text=True, check=False)

    def test_each_case_is_in_one_entry(self):
        self.assertEqual(self.list().returncode, 0)
        run = f"[[{self.program}]] [[--gtest_filter="
        self.assertEqual(self.output.read_text(encoding="utf-8").splitlines(), [
            f"add_test([[app/boxes]] {run}Read.Boxes:Sums/1.*]])",
            f"add_test([[app/read]] {run}Read.Numbers]])",
            f"add_test([[engine/trace/caps]] {run}Caps.*]])"])

    def test_long_ones_begin_first(self):
        self.list("engine/trace/caps", "app/read", "elsewhere")
        lines = self.output.read_text(encoding="utf-8").splitlines()
        self.assertIn("set_tests_properties([[engine/trace/caps]] PROPERTIES COST 2000)", lines)
        self.assertIn("set_tests_properties([[app/read]] PROPERTIES COST 1999)", lines)
        self.assertEqual(len(lines), 5)

    def test_a_program_that_lists_nothing_is_an_error(self):
        self.write_program("#!/bin/sh\nexit 1\n")
        self.assertNotEqual(self.list().returncode, 0)
        self.assertFalse(self.output.exists())


if __name__ == "__main__":
    unittest.main()
