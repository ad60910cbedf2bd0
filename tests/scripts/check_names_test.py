#!/usr/bin/env python3
"""Tests of check_names.py."""

import unittest

from check_names import clashes


class NamesTest(unittest.TestCase):
    def names(self, *texts):
        return list(clashes({str(number): text for number, text in enumerate(texts)}))

    def test_two_types_of_one_name(self):
        self.assertEqual(self.names("namespace a {\nstruct T {\n int i; };\n}",
                                    "namespace a { enum class T : char { x }; }"), ["a::T"])
        self.assertEqual(self.names("namespace a::b { class T final : public U { }; }",
                                    "namespace a { namespace b { union T {}; } }"), ["a::b::T"])
        self.assertEqual(self.names("namespace a { template <class X> struct T {}; }",
                                    "namespace a { // {\ntemplate <int i> class T {}; }"), ["a::T"])
        self.assertEqual(self.names("namespace a { struct T { int i; }; }",
                                    "namespace a { template <class X> struct T {}; }"), ["a::T"])

    def test_types_that_are_told_apart(self):
        for other in ("namespace b { struct T {}; }",
                      "namespace a { namespace { struct T {}; } }",
                      "namespace a { struct U { struct T {}; }; }",
                      "namespace a { void f() { struct T {}; } }",
                      "namespace a { struct T; class T; }",
                      "namespace a { /* struct T {}; */ const char* t = \"struct T {\"; }"):
            with self.subTest(other):
                self.assertEqual(self.names("namespace a { struct T { int i; }; }", other), [])


if __name__ == "__main__":
    unittest.main()
