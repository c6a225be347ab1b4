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

    def test_units_are_converted(self):
        self.given("in.ngc", "G21\nG0 X25.4 Y0\nG1 X50.8 F254\nM2\n")
        result = self.run_cli("convert", "in.ngc", "out.ngc", "--units", "inch")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertEqual(self.text("out.ngc"),
                         "G21\nG20 G0 X1 Y0\nG1 X2 F10\nG21\nM2\n")


SVG = ('<svg xmlns="http://www.w3.org/2000/svg"%s viewBox="0 0 50 40">'
       '<path fill="none" stroke="black" '
       'd="M5 5h20a5 5 0 0 1 5 5v10z"/></svg>')

PENS = "unstep: warning: in.svg: widths of pens are not kept\n"


class Drawings(harness.CliTest):
    def setUp(self):
        super().setUp()
        self.write("in.svg", (SVG % ' width="50mm" height="40mm"').encode())

    def text(self, name):
        return self.read(name).decode()

    def test_a_laser_draws_lines_and_arcs(self):
        result = self.run_cli("convert", "in.svg", "out.nc", "--profile",
                              "laser", "--feed", "1500mm", "--power", "300")
        self.assertEqual((result.code, result.err), (0, PENS))
        self.assertEqual(result.out,
                         "in.svg -> out.nc: 5 motions, 85 bytes\n")
        self.assertEqual(
            self.text("out.nc"),
            "G21 G90 G17 G94\nM5\nG0 X5 Y35\nM3 S300\nG1 X25 F1500\n"
            "G2 X30 Y30 J-5\nG1 Y20\nX5 Y35\nM5\nM2\n")

    def test_a_tool_goes_down_and_up(self):
        result = self.run_cli("convert", "in.svg", "out.ngc", "--cut-z", "-2",
                              "--travel-z", "3mm", "--spindle", "8000")
        self.assertEqual((result.code, result.err), (0, PENS))
        self.assertEqual(
            self.text("out.ngc"),
            "G21 G90 G17 G94\nG0 Z3\nM3 S8000\nX5 Y35\nG1 Z-2 F300\n"
            "X25 F1000\nG2 X30 Y30 J-5\nG1 Y20\nX5 Y35\nG0 Z3\nM5\nM2\n")

    def test_lines_of_ones_own_switch_the_tool(self):
        result = self.run_cli("convert", "in.svg", "out.nc", "--profile",
                              "plotter", "--tool-on", r"M3 S90\nG4 P0.2",
                              "--tool-off", "M3 S0", "--header", "(pen)")
        self.assertEqual((result.code, result.err), (0, PENS))
        self.assertEqual(
            self.text("out.nc"),
            "(pen)\nG21 G90 G17 G94\nM3 S0\nG0 X5 Y35\nM3 S90\nG4 P0.2\n"
            "G1 X25 F1000\nG2 X30 Y30 J-5\nG1 Y20\nX5 Y35\nM3 S0\nM2\n")

    def test_the_size_must_be_known(self):
        self.write("in.svg", (SVG % "").encode())
        result = self.run_cli("convert", "in.svg", "out.nc")
        self.assertEqual(result.code, 2)
        self.assertIn("--unit-size", result.err)
        self.assertEqual(self.names(), ["in.svg"])
        result = self.run_cli("convert", "in.svg", "out.nc", "--unit-size",
                              "2mm")
        self.assertEqual(result.code, 0)
        self.assertIn("G0 Z5\nX10 Y70\n", self.text("out.nc"))

    def test_a_program_becomes_its_drawing(self):
        self.run_cli("convert", "in.svg", "a.ngc", "--profile", "plotter")
        result = self.run_cli("convert", "a.ngc", "out.svg")
        self.assertEqual(result.code, 0)
        self.assertEqual(
            result.err,
            "unstep: warning: a.ngc: Z is not in a drawing\n"
            "unstep: warning: a.ngc: feed and spindle are not in a drawing\n"
            "unstep: warning: a.ngc: 3 rapids are not drawn\n")
        self.assertIn("h20a5 5 0 0 1 5 5v10z", self.text("out.svg"))
        self.run_cli("convert", "out.svg", "b.ngc", "--profile", "plotter")
        self.assertIn("G2 X25 Y10 J-5", self.text("b.ngc"))


if __name__ == "__main__":
    unittest.main()
