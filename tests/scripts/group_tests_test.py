#!/usr/bin/env python3
"""Tests of group_tests.py: what goes together, and what never does."""

import unittest

from group_tests import MOST, declared_names, group_text, groups_of

HEAD = """#include "a.hpp"
// int remark = 1;
namespace zeroset::test {
namespace {

"""
BODY = """TEST(Sum, IsRight) {
    const int inner = 2;
}

}  // namespace
}  // namespace zeroset::test
"""


class DeclaredNamesTest(unittest.TestCase):
    def test_what_a_namespace_declares(self):
        for line, name in (("constexpr int side = 4;", "side"),
                           ("constexpr std::array<int, 2> pair{1, 2};", "pair"),
                           ("const char* const names[] = {", "names"),
                           ("std::string text_of(const Expr& expr) {", "text_of"),
                           ("template <class Real>\nReal third() {", "third"),
                           ("template <class Real> Real half() {", "half"),
                           ("struct Place {", "Place"),
                           ("class Fixture : public ::testing::Test {", "Fixture"),
                           ("enum class Way : std::uint8_t { Up };", "Way"),
                           ("using Words = std::vector<std::string>;", "Words"),
                           ("int counter;", "counter"),
                           ("int last_one = 1;", "last_one")):
            with self.subTest(line=line):
                self.assertEqual(declared_names(HEAD + line + "\n" + BODY) - {"Real"},
                                 {name})

    def test_nothing_else(self):
        self.assertEqual(declared_names(HEAD + BODY), set())


class GroupsTest(unittest.TestCase):
    def test_files_of_a_folder_go_together_up_to_a_number(self):
        texts = {f"/tests/a/{i}_test.cpp": BODY for i in range(MOST + 1)} | {"/tests/b/c.cpp": BODY}
        self.assertEqual([len(group) for group in groups_of(texts)], [MOST, 1, 1])

    def test_files_with_a_name_in_common_do_not(self):
        texts = {"/a/1.cpp": "constexpr int side = 4;\n", "/a/2.cpp": "int f(int side) {\n",
                 "/a/3.cpp": "int g() {\n    // side\n    return inner;\n", "/a/4.cpp": "int inner() {\n"}
        self.assertEqual(groups_of(texts),
                         [["/a/1.cpp", "/a/3.cpp"], ["/a/2.cpp", "/a/4.cpp"]])

    def test_files_with_directives_stay_alone(self):
        texts = {"/a/1.cpp": BODY, "/a/2.cpp": "#define A\n" + BODY, "/a/3.cpp": BODY}
        self.assertEqual(groups_of(texts), [["/a/1.cpp", "/a/3.cpp"], ["/a/2.cpp"]])

    def test_headers_come_before_all_sources(self):
        texts = {"/a/1.cpp": HEAD + BODY, "/a/2.cpp": '#include "b.hpp"\n' + HEAD + BODY}
        self.assertEqual(group_text(list(texts), texts),
                         '#include "a.hpp"\n#include "b.hpp"\n'
                         '#include "/a/1.cpp"\n#include "/a/2.cpp"\n')


if __name__ == "__main__":
    unittest.main()
