#!/usr/bin/env python3
"""convert with programs of machines."""

import math
import unittest

import harness

HEAD = "G21 G90\nG0 X0 Y0 Z0\nG1 X20 Y0 F600\n"


def circle(count):
    lines = []
    for i in range(1, count + 1):
        angle = 3 * i / count
        lines.append("G1 X%.4f Y%.4f F600" %
                     (20 * math.cos(angle), 20 * math.sin(angle)))
    return HEAD + "\n".join(lines) + "\nM2\n"


class Programs(harness.CliTest):
    def given(self, name, text):
        self.write(name, text.encode())

    def text(self, name):
        return self.read(name).decode()

    def test_tiny_segments_become_an_arc(self):
        self.given("in.ngc", circle(300))
        result = self.run_cli("convert", "in.ngc", "out.ngc",
                                  "--tolerance", "0.005mm")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertRegex(result.out, r"^in\.ngc -> out\.ngc: 301 motions -> 2, "
                                     r"1 arc, [\d,]+ bytes -> \d+\n$")
        self.assertEqual(self.text("out.ngc").count("\n"), 5)

    def test_without_tolerance_every_motion_stays(self):
        self.given("in.nc", HEAD + "G02 X30 R5\nM2\n")
        result = self.run_cli("convert", "in.nc", "out.tap",
                                  "--arc-words", "ij")
        self.assertEqual(result.code, 0, result.err)
        self.assertEqual(self.text("out.tap"),
                         "G21 G90\nG0 X0 Y0 Z0\nG1 X20 F600\nG2 X30 I5\nM2\n")

    def test_what_is_not_understood_is_kept_or_refused(self):
        self.given("in.ngc", HEAD + "M123 P1\nM2\n")
        result = self.run_cli("convert", "in.ngc", "out.ngc")
        self.assertEqual(result.code, 0)
        self.assertEqual(result.err, "unstep: warning: in.ngc: line 4: M123: "
                                     "kept as it stands\n")
        self.assertIn("M123 P1\n", self.text("out.ngc"))
        result = self.run_cli("convert", "in.ngc", "no.ngc", "--strict")
        self.assertEqual(result.code, 3)
        self.assertEqual(result.err,
                         "unstep: in.ngc: line 4: M123 is not understood\n")
        self.assertEqual(self.names(), ["in.ngc", "out.ngc"])

    def test_bad_programs_leave_nothing_behind(self):
        self.given("in.ngc", HEAD + "G2 X30 I4\nM2\n")
        result = self.run_cli("convert", "in.ngc", "out.ngc")
        self.assertEqual(result.code, 3)
        self.assertEqual(
            result.err,
            "unstep: in.ngc: line 4: arc: its radius is 4.0000 mm at the "
            "start and 6.0000 mm at the end, 2.0000 mm apart\n")
        self.assertEqual(self.names(), ["in.ngc"])

    def test_a_program_has_no_pixels(self):
        self.given("in.ngc", HEAD)
        result = self.run_cli("convert", "in.ngc", "out.ngc",
                                  "--tolerance", "1")
        self.assertEqual(result.code, 2)
        self.assertIn("give --tolerance in mm or in", result.err)


if __name__ == "__main__":
    unittest.main()
