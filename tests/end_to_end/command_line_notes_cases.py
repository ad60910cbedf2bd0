"""Tests of what the command line tells of a text that it read in an unusual way."""

from zeroset_program import ProgramTest, read_png, run


class NotesTest(ProgramTest):
    def test_unusual_readings_are_told(self):
        note = "zeroset: note: a % b is mod(a, b)"
        for command in (("render", "-o", "n.png", "--size", 8), ("sample", "-o", "n.nrrd", "--size", 4),
                        ("draw", "-o", "n.svg")):
            loud = run(command[0], "z = 5 % x", *command[1:], cwd=self.folder)
            self.assertTrue(loud.err.startswith(note), str(loud))
            quiet = run(command[0], "z = 5 % x", "--quiet", *command[1:], cwd=self.folder)
            self.assertNotIn("note", quiet.err)

    def test_commands_of_other_programs_bring_their_box(self):
        text = "ContourPlot3D[x^2 + y^2 == z, {x, -1, 1}, {y, -1, 1}, {z, 0, 1}, Mesh -> None]"
        told = run("render", text, "-o", "n.png", "--size", 40, cwd=self.folder)
        self.assertEqual(told.err, "zeroset: note: this is read as Mathematica's ContourPlot3D, "
                                   "without Mesh\n")
        boxed = run("render", "x^2 + y^2 = z", "--box", "-1,1,-1,1,0,1", "-o", "b.png", "--size", 40,
                    cwd=self.folder)
        self.assertEqual(boxed.err, "")
        self.assertEqual(read_png(self.folder / "n.png").rgb, read_png(self.folder / "b.png").rgb)

    def test_a_bounded_surface_is_shown_whole(self):
        large = ("render", "x^2 + y^2 + z^2 = 25", "--size", "40x40", "--depth", "out.pfm")
        for options in (("--quiet",), ("--box", "2"), ("--eye", "9,9,9")):
            self.run_ok(*large, *options)
        self.run_ok("render", "x^2 + y^2 + z^2 = 2", *large[2:])
        for command, note in ((large, "clip box"), (("render", "z = exp(x)", *large[2:]), "z from")):
            noted = run(*command, cwd=self.folder)
            self.assertEqual(noted.code, 0)
            self.assertIn(note, noted.err)
            self.assertIn("--box 2 keeps", noted.err)
