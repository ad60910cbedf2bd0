"""Tests of check_comments.py."""

import unittest

from pathlib import Path

from check_comments import objections, remarks, unresolved


class CommentsTest(unittest.TestCase):
    def reasons(self, *lines):
        return [reason for _, reason in objections(lines)]

    def test_a_comment_that_begins_with_its_subject_passes(self):
        self.assertEqual(self.reasons("/// The least root.", "double root();  ///< in units"), [])

    def test_an_opening_that_leans_on_something_is_found(self):
        self.assertEqual(len(self.reasons("/// Of the two, the least.")), 1)
        self.assertEqual(len(self.reasons("int a;  ///< The same for b")), 1)
        self.assertEqual(len(self.reasons("    // As `take`.")), 1)

    def test_only_the_first_line_of_a_comment_is_an_opening(self):
        self.assertEqual(self.reasons("// Roots are counted once.", "// As ends of a stretch."), [])
        self.assertEqual(self.reasons("// Asked once.", "int a = b;  // Of no use"), [])

    def test_a_line_that_stands_there_twice_is_found(self):
        line = "// empty   lo > hi, as of a box"
        self.assertEqual(self.reasons(line, line), ["a line of a comment stands there twice"])

    def test_files_and_sources_that_are_not_there_are_found(self):
        def lost(name, *lines):
            return [reason for _, reason in unresolved(remarks(Path(name), lines),
                                                       {"engine/a/b.hpp"}.__contains__, "**[Knoll07]**")]
        self.assertEqual(lost("a.cpp", "// As engine/a/b.hpp says [Knoll07, sec. 4]."), [])
        self.assertEqual(lost("a.cpp", '#include "engine/c.hpp"', "// [Knoll07; Moore66, eq. 2]"),
                         ["Moore66 is not there"])
        self.assertEqual(lost("a.md", "`engine/b.hpp` tells it."), ["engine/b.hpp is not there"])


if __name__ == "__main__":
    unittest.main()
