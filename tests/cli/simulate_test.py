#!/usr/bin/env python3
"""Runs `unstep simulate` as a user would. UNSTEP_PROGRAM names it."""

import json
import os
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["UNSTEP_PROGRAM"]

SQUARE = b"canvas 60 60 down\nclosed4 10 10: " + b" ".join(
    [b"0"] * 40 + [b"6"] * 40 + [b"4"] * 40 + [b"2"] * 40) + b"\n"


class Simulate(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="unstep-cli-")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.drawing = self.path("square.fc")
        with open(self.drawing, "wb") as file:
            file.write(SQUARE)

    def path(self, name):
        return os.path.join(self.folder, name)

    def run_it(self, *words):
        return subprocess.run([PROGRAM, "simulate", self.drawing, *words],
                              capture_output=True, check=False)

    def report(self, *words):
        done = self.run_it("--json", *words)
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        return json.loads(done.stdout)

    def test_zenit_reports_time_error_and_peaks(self):
        report = self.report()
        self.assertEqual(report["steps"], 160)
        self.assertAlmostEqual(report["lit_seconds"], 0.64, delta=0.3)
        self.assertEqual(report["peak_steps_per_second"], 250)
        self.assertLess(report["rms_um"], report["worst_um"])
        self.assertLess(report["worst_um"], 6)
        self.assertEqual(report["limits_broken"], [])
        self.assertEqual(report, self.report())
        self.assertNotEqual(report, self.report("--seed", "2"))
        self.assertIn(b"limits broken: none\n", self.run_it().stdout)

    def test_too_fast_breaks_limits(self):
        report = self.report("--speed", "15")
        self.assertIn("an axis is sent faster than 10 mm/s",
                      report["limits_broken"])
        self.assertIn(b"limit broken: ", self.run_it("--speed", "15").stdout)

    def test_plot_and_exposure_are_written(self):
        plot, image = self.path("plot.svg"), self.path("plate.pbm")
        report = self.report("--plot", plot, "--exposure", image)
        with open(plot, encoding="ascii") as file:
            svg = file.read()
        self.assertTrue(svg.startswith("<svg "))
        self.assertIn("M10 10L50 10L50 50L10 50L10 10", svg)
        with open(image, "rb") as file:
            self.assertTrue(file.read().startswith(b"P4\n60 60\n"))
        self.assertLess(report["ink"]["worst_units"], 3)
        self.assertEqual(report["ink"]["lost"], 0)
        again = self.run_it("--plot", plot)
        self.assertEqual(again.returncode, 4)
        self.assertEqual(self.run_it("--plot", plot, "--force").returncode, 0)

    def test_esu_scans_within_its_instability(self):
        report = self.report("--machine", "esu", "--exposure",
                             self.path("film.png"))
        self.assertAlmostEqual(report["seconds"], 0.036)
        self.assertLess(report["ink"]["worst_units"], 5)
        self.assertTrue(os.path.exists(self.path("film.png")))

    def test_esu_writes_within_its_instability(self):
        film, plot = self.path("film.pbm"), self.path("plot.svg")
        report = self.report("--machine", "esu", "--direction", "write",
                             "--exposure", film, "--plot", plot)
        self.assertEqual(report["direction"], "write")
        self.assertAlmostEqual(report["seconds"], 0.036)
        # 2.05 points of 4 um on each axis.
        self.assertLess(report["worst_um"], 11.6)
        self.assertLess(report["rms_um"], report["worst_um"])
        self.assertEqual(report["limits_broken"], [])
        self.assertGreater(report["ink"]["differing"], 0)
        self.assertLess(report["ink"]["worst_units"], 5)
        self.assertEqual(report["ink"]["lost"], 0)
        self.assertEqual(report["ink"]["differing"],
                         len(ink_of(film) ^ self.drawn()))
        with open(plot, encoding="ascii") as file:
            svg = file.read()
        self.assertIn("M10 10L50 10L50 50L10 50L10 10", svg)
        self.assertEqual(svg.count("<path"), 2)
        scan = self.report("--machine", "esu")
        self.assertEqual(scan["direction"], "scan")
        self.assertNotEqual(scan["ink"], report["ink"])

    def drawn(self):
        return {(x, y) for x in range(10, 50) for y in range(10, 50)}

    def test_esu_without_noise_writes_the_drawing(self):
        film = self.path("film.pbm")
        report = self.report("--machine", "esu", "--direction", "write",
                             "--noise", "0", "--exposure", film)
        self.assertEqual(report["worst_um"], 0)
        self.assertEqual(report["ink"]["worst_units"], 0)
        self.assertEqual(ink_of(film), self.drawn())

    def test_esu_beyond_its_instability_breaks_a_limit(self):
        for way in ("scan", "write"):
            words = ("--machine", "esu", "--direction", way, "--noise", "2")
            self.assertEqual(self.report(*words)["limits_broken"],
                             ["the raster wanders by more than 0.1 % of the "
                              "field"])
            self.assertIn(b"limit broken: the raster", self.run_it(*words).stdout)

    def test_a_program_needs_a_grid(self):
        self.drawing = self.path("part.ngc")
        with open(self.drawing, "wb") as file:
            file.write(b"G21 G90\nG0 X0 Y0\nG1 X3 F100\nG3 X3 Y2 J1\nM2\n")
        done = self.run_it()
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"--grid", done.stderr)
        done = self.run_it("--grid", "0.1mm")
        self.assertEqual(done.returncode, 0)
        self.assertIn(b"limits broken: none\n", done.stdout)

    def test_nothing_drawn_is_plotted(self):
        with open(self.drawing, "wb") as file:
            file.write(b"canvas 60 60 down\n")
        plot = self.path("plot.svg")
        for machine in ("zenit", "esu"):
            self.report("--machine", machine, "--plot", plot, "--force")
            with open(plot, encoding="ascii") as file:
                self.assertIn('viewBox="-2 -2 64 64"', file.read())

    def test_wrong_usage(self):
        for words in (["--machine", "lathe"], ["--speed", "0"],
                      ["--direction", "write"],
                      ["--machine", "esu", "--direction", "up"],
                      ["--exposure", self.path("a.svg")], ["--page", "2"]):
            done = self.run_it(*words)
            self.assertEqual(done.returncode, 2, words)
            self.assertEqual(done.stdout, b"")
        self.assertEqual(os.listdir(self.folder), ["square.fc"])


FIELD = b"""<svg xmlns="http://www.w3.org/2000/svg" width="4096" height="4096"
 fill="none" stroke="black" stroke-width="1">
<circle cx="2048" cy="2048" r="1900"/><path d="M300 300H3796V3796H300Z"/>
<path d="M300 300L3796 3796M1000 2048A700 400 20 0 1 2500 1500L2600 2900
1200 2700ZM40 40H4050M60 4040L70 60"/></svg>
"""
# Of 4096 points 0.1 % is 4.1; the spot is one point wide.
WITHIN = 5


def ink_of(path):
    """The ink pixels of a PBM file, as a set of (x, y)."""
    with open(path, "rb") as file:
        magic, size, bits = file.read().split(b"\n", 2)
    width, height = map(int, size.split())
    assert magic == b"P4"
    row_bytes = (width + 7) // 8
    pixels = set()
    for i, byte in enumerate(bits[:row_bytes * height]):
        if byte:
            y, x = divmod(i, row_bytes)
            pixels.update((8 * x + k, y) for k in range(8)
                          if byte >> (7 - k) & 1)
    return pixels


def farthest(ink, other):
    """The square of the largest way from ink to the nearest of the other."""
    reach = range(-WITHIN - 2, WITHIN + 3)
    ways = sorted((dx * dx + dy * dy, dx, dy) for dx in reach for dy in reach)
    worst = 0
    for x, y in ink:
        worst = max(worst, next((square for square, dx, dy in ways
                                 if (x + dx, y + dy) in other), 10 ** 6))
    return worst


class RoundTrip(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="unstep-cli-")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def run_one(self, *words):
        done = subprocess.run([PROGRAM, *words], capture_output=True,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_drawing_comes_back_through_both_machines(self):
        path = self.path
        with open(path("first.svg"), "wb") as file:
            file.write(FIELD)
        # Stored, drawn step by step under the laser, exposed, scanned, stored.
        self.run_one("compress", path("first.svg"), "-o", path("first.ustp"))
        self.run_one("simulate", path("first.ustp"), "--machine", "zenit",
                     "--exposure", path("plate.pbm"))
        self.run_one("simulate", path("plate.pbm"), "--machine", "esu",
                     "--exposure", path("film.pbm"))
        self.run_one("compress", path("film.pbm"), "-o", path("last.ustp"))
        self.run_one("decompress", path("last.ustp"), "-o", path("last.pbm"))
        self.run_one("convert", path("first.svg"), path("first.pbm"))
        first, last = ink_of(path("first.pbm")), ink_of(path("last.pbm"))
        self.assertGreater(len(first), 40000)
        self.assertNotEqual(first, last)
        self.assertLessEqual(farthest(first, last), WITHIN ** 2)
        self.assertLessEqual(farthest(last, first), WITHIN ** 2)


if __name__ == "__main__":
    unittest.main()
