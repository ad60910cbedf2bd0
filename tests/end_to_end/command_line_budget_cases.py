"""Tests of long commands: time budget, end by a signal, and progress on a terminal."""

import json
import os
import pty
import re
import signal
import subprocess
import threading
import time

from zeroset_program import TIMEOUT_S, ProgramTest, environment, program, read_png, run

# A formula that stays undecided for minutes: it jumps nearly everywhere.
ENDLESS = ("a_0 = x\n" + "\n".join(f"a_{i} = frac(9 a_{i - 1}^2 + y)" for i in range(1, 60)) +
           "\nz = a_59")
SPHERE = "x^2 + y^2 + z^2 = 1"


class BudgetTest(ProgramTest):
    def test_what_is_left_is_undecided(self):
        result = run("render", "-", "--box", 2, "--size", "96x64", "--budget", 1, "-o", "out.png",
                     "--certificate", "c.png", "--stats", "s.json", stdin=ENDLESS,
                     cwd=self.folder)
        self.assertEqual(result.code, 0, str(result))
        stats = json.loads((self.folder / "s.json").read_text(encoding="utf-8"))
        left = stats["undecided_by_budget"]
        self.assertGreater(left, 0)
        self.assertLessEqual(left, stats["undecided"])
        self.assertEqual(stats["certified"] + stats["undecided"] + stats["miss"], 96 * 64)
        self.assertEqual(result.err, f"zeroset: the budget of 1 s is spent: {left} of 6144 pixels "
                                     "are left undecided; --budget SECONDS gives more\n")
        self.assertEqual(self.files(), ["c.png", "out.png", "s.json"])
        self.assertEqual(read_png(self.folder / "out.png").width, 96)

    def test_compiling_counts(self):
        sum_of_sines = "+".join(f"sin({i}x + {i % 7}y)^3" for i in range(1, 400))
        result = run("render", "-", "--size", "32x32", "--budget", 0.001, "-o", "out.png",
                     "--stats", "-", stdin=sum_of_sines, cwd=self.folder)
        self.assertEqual(result.code, 0, str(result))
        self.assertEqual(json.loads(result.out)["undecided_by_budget"], 32 * 32)
        self.assertIn("1024 of 1024 pixels are left undecided", result.err)
        self.assertEqual(result.err.count("\n"), 1)

    def test_nothing_is_said_in_time(self):
        self.run_ok("render", SPHERE, "--size", "64x64", "--budget", 50, "-o", "out.png")

    def test_a_timed_frame_that_is_cut_is_the_last(self):
        result = run("render", "-", "--size", "64x64", "--budget", 0.5, "--repeat", 50, "--stats",
                     "-", stdin=ENDLESS)
        self.assertEqual(result.code, 0, str(result))
        self.assertEqual(json.loads(result.out)["frame_ms"]["repeats"], 1)

    def test_bench_has_a_budget_a_frame(self):
        suite = {"camera": {"direction": [1, 1, 1], "distance": 3, "fov": 40},
                 "surfaces": [{"name": "endless", "f": ENDLESS, "domain": 2},
                              {"name": "ball", "f": SPHERE, "domain": 2}]}
        (self.folder / "suite.json").write_text(json.dumps(suite), encoding="utf-8")
        result = run("dev", "bench", "--suite", "suite.json", "--budget", 0.5, "--size", 64, "--dstop",
                     22, "--json", "-", cwd=self.folder)
        self.assertEqual(result.code, 0, str(result))
        self.assertEqual(result.err, "zeroset: endless: the budget of 0.5 s is spent; --budget "
                                     "SECONDS gives more\n")
        rows = json.loads(result.out)["surfaces"]
        self.assertEqual([row["beams"]["frame_ms"]["repeats"] for row in rows], [1, 5])


def heed_signals():
    """Restores the default signal actions: background jobs of a shell ignore SIGINT, and so would
    the processes that they start."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


class SignalTest(ProgramTest):
    def start(self, *arguments, stdin, **how):
        how.setdefault("stderr", subprocess.PIPE)
        how.setdefault("preexec_fn", heed_signals)
        how.setdefault("env", environment())
        process = subprocess.Popen([program(), *map(str, arguments)], stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, cwd=self.folder, **how)
        self.addCleanup(process.kill)
        process.stdin.write(stdin.encode())
        process.stdin.close()
        process.stdin = None
        return process

    def test_signals_end_at_once(self):
        sines = "*".join(f"sin({i}x + {i % 7}y + {i % 5}z)" for i in range(1, 800))
        for text in (ENDLESS, sines):  # while it traces, and while LLVM compiles
            for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
                with self.subTest(text=text[:9], signal=number):
                    process = self.start("render", "-", "-o", "out.png", "--depth", "d.pfm",
                                         stdin=text)
                    time.sleep(0.7)
                    process.send_signal(number)
                    out, err = process.communicate(timeout=TIMEOUT_S / 3)
                    self.assertEqual((process.returncode, out, err), (1, b"", b""))
                    self.assertEqual(self.files(), [])

    def test_a_file_stays_as_it_was(self):
        (self.folder / "out.png").write_bytes(b"before")
        process = self.start("render", "-", "-o", "out.png", stdin=ENDLESS)
        time.sleep(0.5)
        process.terminate()
        process.communicate(timeout=TIMEOUT_S / 3)
        self.assertEqual((self.folder / "out.png").read_bytes(), b"before")

    def test_a_signal_that_is_ignored_stays_so(self):
        """SIGHUP is ignored under nohup, and the program must leave it so."""
        process = self.start("render", "-", "--size", "64x64", "--budget", 1.5, "-o", "out.png",
                             stdin=ENDLESS,
                             preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        time.sleep(0.5)
        process.send_signal(signal.SIGHUP)
        process.communicate(timeout=TIMEOUT_S)
        self.assertEqual(process.returncode, 0)

    def on_terminal(self, *arguments, stdin, **variables):
        """Returns what the program writes to standard error if that is a terminal."""
        ours, theirs = pty.openpty()
        written = []

        def read():
            try:
                while data := os.read(ours, 4096):
                    written.append(data)
            except OSError:  # the other side is closed
                pass

        reader = threading.Thread(target=read)
        process = self.start(*arguments, stdin=stdin, stderr=theirs,
                             env=environment(**variables))
        os.close(theirs)
        reader.start()
        process.communicate(timeout=TIMEOUT_S)
        reader.join()
        os.close(ours)
        self.assertEqual(process.returncode, 0)
        return b"".join(written).decode()

    def test_progress_on_a_terminal(self):
        text = self.on_terminal("render", "-", "--box", 2, "--size", "64x64", "--budget", 3, "-o", "out.png",
                                stdin=ENDLESS)
        lines = text.split("\r\x1b[J")
        drawing = [line for line in lines[1:-1] if not re.fullmatch(r"compiling, \d+ s", line)]
        self.assertTrue(drawing, text)
        for line in drawing:
            self.assertRegex(line, r"^drawing  \[[# ]{30}\] +\d+ %$")
        self.assertEqual(lines[0], "")
        self.assertTrue(lines[-1].startswith("zeroset: the budget of 3 s is spent"), text)
        self.assertEqual(self.on_terminal("render", "-", "--size", "8x8", "-o", "out.png",
                                          stdin=SPHERE), "")

    def test_pictures_on_a_terminal_with_colors(self):
        text = self.on_terminal("turntable", "-", "--size", "64x36", "--frames", 2, "--budget", 2,
                                "-o", "f###.png", stdin=ENDLESS, COLORTERM="truecolor")
        # After the first frame, which takes all of its time, it is shown while the second is drawn:
        # 48x27 pixels in 14 lines.
        self.assertRegex(text, r"\u2580.*\x1b\[0m\r\nframe 1 of 2  \[[# ]{30}\]")
        self.assertRegex(text, r"\r\x1b\[14A\x1b\[Jzeroset: \d+ pixels of the film are left undecided")
