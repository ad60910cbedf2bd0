#!/usr/bin/env python3
"""Tests that check_layers.py finds one violation of each kind and passes a clean tree."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECKER = Path(__file__).with_name("check_layers.py")

ROOMS = """# room | arrows | what for
engine/expr | | graphs
engine/trace | engine/expr | pictures
engine/trace/beam | engine/trace | a tracer
engine/trace/k | engine/trace | another one
jit | engine | code
ui/model | engine | values
ui | engine ui/model | panels
app | engine jit ui | the program
tests | engine jit ui app |
"""

CLEAN = {
    "rooms.txt": ROOMS,
    "engine/expr/op.def": "",
    "engine/expr/expr.hpp": '#include <vector>\n#include "op.def"\n',
    "engine/trace/beam/leaf.hpp": '#include "engine/trace/scene.hpp"\n',
    "engine/trace/k/packet.hpp": '#include "engine/trace/scene.hpp"\n',
    "engine/trace/scene.hpp": '#include "engine/expr/expr.hpp"\n// #include "ui/window/window.hpp"\n',
    "jit/compile.hpp": '#include "engine/expr/expr.hpp"\n#include "jit/lanes.hpp"\n',
    "jit/lanes.hpp": '#include "jit/compile.hpp"\n',  # a cycle must not trap the checker
    "jit/lower.hpp": '#include "llvm/IR/IRBuilder.h"\n',
    "jit/lower.cpp": '#include "jit/lower.hpp"\n#include <llvm/IR/Module.h>\n',
    "ui/window/window.hpp": "#pragma once\n",
    "ui/window/window_glfw.cpp": '#include <GLFW/glfw3.h>\n#include <imgui.h>\n#include "ui/window/window.hpp"\n',
    "app/cli/main.cpp": '#include "jit/compile.hpp"\n#include "ui/window/window.hpp"\n',
    "tests/ui/window_test.cpp": '#include <EGL/egl.h>\n#include "jit/lower.hpp"\n',
}

# (source file, its forbidden include, part of the reason)
VIOLATIONS = [
    ("engine/expr/a.cpp", '"jit/compile.hpp"', "engine/expr/ may not include jit/"),
    ("engine/expr/a.cpp", '"ui/window/window.hpp"', "engine/expr/ may not include ui/"),
    ("engine/expr/a.cpp", '"../../ui/window/window.hpp"', "engine/expr/ may not include ui/"),
    ("engine/expr/a.cpp", '"app/desktop/session.hpp"', "engine/expr/ may not include app/"),
    ("engine/expr/a.cpp", '"tests/support/a.hpp"', "engine/expr/ may not include tests/"),
    ("engine/expr/a.hpp", '"llvm/IR/Value.h"', "engine/expr/ may not include LLVM headers"),
    ("engine/expr/a.cpp", "<imgui.h>", "engine/expr/ may not include window headers"),
    ("engine/expr/a.cpp", "<GLFW/glfw3.h>", "engine/expr/ may not include window headers"),
    ("engine/expr/a.cpp", "<GL/gl.h>", "engine/expr/ may not include window headers"),
    ("engine/expr/a.cpp", "<EGL/egl.h>", "engine/expr/ may not include window headers"),
    ("engine/expr/a.cpp", '"engine/trace/scene.hpp"', "expr/ may not include engine/trace/"),
    ("engine/trace/a.cpp", '"beam/leaf.hpp"', "trace/ may not include engine/trace/beam/"),
    ("engine/trace/beam/a.cpp", '"engine/expr/op.def"', "beam/ may not include engine/expr/"),
    ("engine/trace/beam/a.cpp", '"engine/trace/k/packet.hpp"', "may not include engine/trace/k/"),
    ("engine/a.cpp", "<vector>", "in no room"),
    ("jit/a.cpp", '"ui/window/window.hpp"', "jit/ may not include ui/"),
    ("jit/a.cpp", '"app/desktop/session.hpp"', "jit/ may not include app/"),
    ("jit/a.cpp", "<GL/osmesa.h>", "jit/ may not include window headers"),
    ("jit/compile.hpp", "<llvm/IR/Value.h>", "must not lead to LLVM"),
    ("jit/compile.hpp", '"jit/lower.hpp"', "must not lead to LLVM"),
    ("ui/a.cpp", '"jit/compile.hpp"', "ui/ may not include jit/"),
    ("ui/a.cpp", '"app/desktop/session.hpp"', "ui/ may not include app/"),
    ("ui/model/a.cpp", "<imgui.h>", "ui/model/ may not include window headers"),
    ("ui/a.cpp", "<llvm-c/Core.h>", "ui/ may not include LLVM headers"),
    ("app/a.cpp", '"imgui.h"', "app/ may not include window headers"),
    ("app/a.cpp", "<imgui_internal.h>", "app/ may not include window headers"),
    ("app/a.cpp", "<GLFW/glfw3.h>", "app/ may not include window headers"),
    ("app/a.cpp", '"llvm/IR/Value.h"', "app/ may not include LLVM headers"),
    ("app/a.cpp", '"jit/lower.hpp"', "only jit/compile.hpp"),
    ("app/a.cpp", '"tests/support/a.hpp"', "app/ may not include tests/"),
]


def check(tree):
    with tempfile.TemporaryDirectory() as root:
        for name, text in tree.items():
            path = Path(root, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return subprocess.run(
            [sys.executable, CHECKER, root], capture_output=True, text=True, check=False
        )


class CheckLayers(unittest.TestCase):
    def test_clean_tree_passes(self):
        result = check(CLEAN)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_each_violation_is_found_at_its_line(self):
        for source, header, reason in VIOLATIONS:
            with self.subTest(source=source, header=header):
                result = check(CLEAN | {source: f"#pragma once\n\n#  include {header}\n"})
                self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
                self.assertEqual(len(result.stdout.splitlines()), 1, result.stdout)
                self.assertIn(f"{source}:3: ", result.stdout)
                self.assertIn(reason, result.stdout)

    def test_all_violations_are_listed(self):
        result = check({
            "rooms.txt": ROOMS,
            "engine/expr/a.cpp": "#include <imgui.h>\n",
            "ui/a.cpp": '#include "jit/x.hpp"\n',
        })
        self.assertEqual(len(result.stdout.splitlines()), 2, result.stdout)

    def test_a_circle_is_found(self):
        rooms = ROOMS.replace("engine/expr | |", "engine/expr | engine/trace/beam |")
        result = check(CLEAN | {"rooms.txt": rooms})
        self.assertEqual(result.returncode, 1)
        self.assertIn("a circle: engine/expr -> engine/trace/beam -> engine/trace", result.stdout)
        through_a_folder = ROOMS.replace("engine/expr | |", "engine/expr | jit |")
        result = check(CLEAN | {"rooms.txt": through_a_folder})
        self.assertIn("a circle: engine/expr -> jit -> engine/trace/beam", result.stdout)

    def test_tree_without_sources_fails(self):
        self.assertEqual(check({"rooms.txt": ROOMS}).returncode, 1)


if __name__ == "__main__":
    unittest.main()
