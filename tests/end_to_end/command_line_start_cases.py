"""Tests of what the program loads when it starts, and of libraries that are missing later."""

import shutil

from zeroset_program import SOURCE_DIR, ProgramTest, environment, program, read_png, run

SPHERE = "x^2 + y^2 + z^2 = 1"
SMALL = ("--size", "48x32")
PACKED_SLICES = SOURCE_DIR / "tests/engine/volume/files/packed"


class StartTest(ProgramTest):
    def test_libraries_of_codecs_are_not_loaded_at_start(self):
        """They and what they need take longer to load than all the rest."""
        names = self.run_ok("--version", env=environment(LD_TRACE_LOADED_OBJECTS="1")).out
        self.assertIn("libstdc++", names)
        for library in ("libavcodec", "libavformat", "libavutil", "libgdcm"):
            self.assertNotIn(library, names)

    def without_ffmpeg(self):
        """Returns an environment in which FFmpeg's libraries are no libraries."""
        libraries = self.folder / "libraries"
        libraries.mkdir()
        for version in range(50, 80):
            (libraries / f"libavformat.so.{version}").touch()
        return environment(LD_LIBRARY_PATH=str(libraries))

    def test_without_ffmpegs_libraries_the_rest_is_written(self):
        env = self.without_ffmpeg()
        self.run_ok("render", SPHERE, *SMALL, "-o", "a.png", env=env)
        self.assertGreater(len(read_png(self.folder / "a.png").colors()), 30)
        for command in (("render", "-o", "a.webp"), ("turntable", "--frames", "2", "-o", "a.mp4")):
            result = run(*command, SPHERE, *SMALL, cwd=self.folder, env=env)
            self.assertEqual((result.code, result.out, result.err.count("\n")), (2, "", 1),
                             str(result))
            # Or the program was built without FFmpeg.
            self.assertRegex(result.err, "libavformat.* type |without FFmpeg.* type ")
        self.assertEqual(self.files(), ["a.png", "libraries"])

    def test_without_its_module_packed_slices_get_their_line(self):
        alone = self.folder / "alone"
        alone.mkdir()
        shutil.copy(program(), alone / "zeroset")
        result = run("render", PACKED_SLICES, "-o", "a.png", cwd=self.folder,
                     of=alone / "zeroset")
        self.assertEqual((result.code, result.out), (2, ""), str(result))
        self.assertRegex(result.err, "zeroset_gdcm.so: cannot open|without GDCM")
        self.assertEqual(self.files(), ["alone"])
