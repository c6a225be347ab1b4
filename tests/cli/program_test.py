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

    def test_verify_measures_what_is_shorter(self):
        self.given("in.ngc", circle(300))
        self.run_cli("convert", "in.ngc", "out.ngc", "--tolerance", "0.05mm")
        self.run_cli("compress", "in.ngc", "--tolerance", "0.05mm")
        for name in ("out.ngc", "in.ustp"):
            result = self.run_cli("verify", "in.ngc", name, *(
                ["--tolerance", "0.05mm"] if name == "out.ngc" else []))
            self.assertEqual((result.code, result.err), (0, ""))
            self.assertRegex(result.out, name + r": deviates by up to "
                             r"0\.0\d+ mm, of 0\.05 mm allowed, at \(.*\), "
                             r"line \d+\n.* are the same within the bound: ")
        self.run_cli("convert", "in.ngc", "lines.ngc", "--no-arcs",
                     "--tolerance", "0.05mm")
        self.given("far.ngc", self.text("lines.ngc").replace("X20", "X20.06"))
        result = self.run_cli("verify", "in.ngc", "far.ngc",
                              "--tolerance", "0.05mm")
        self.assertEqual((result.code, result.err), (1, ""))
        self.assertRegex(result.out, r"^in\.ngc and far\.ngc differ: deviates "
                         r"by up to 0\.06\d* mm, of 0\.05 mm allowed, at "
                         r"\(.*\), line [34]\n$")
        result = self.run_cli("verify", "in.ngc", "far.ngc",
                              "--tolerance", "2px")
        self.assertEqual(result.code, 2)

    def test_loops_are_carried_out_within_a_limit(self):
        self.given("in.ngc", HEAD + "o1 repeat [3]\nG91 G1 X1\n"
                   "o1 endrepeat\nM2\n")
        result = self.run_cli("convert", "in.ngc", "out.ngc")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertEqual(self.text("out.ngc").count("X1\n"), 3)
        self.given("in.ngc", "G0 X1\no1 while [1]\no1 endwhile\nM2\n")
        result = self.run_cli("convert", "in.ngc", "no.ngc",
                              "--max-lines", "1000")
        self.assertEqual(result.code, 3)
        self.assertEqual(result.err,
                         "unstep: in.ngc: line 3: more than the limit of 1000 "
                         "lines carried out: a loop may have no end\n")
        self.assertEqual(self.names(), ["in.ngc", "out.ngc"])

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

class Stored(harness.CliTest):
    def given(self, name, text):
        self.write(name, text.encode())

    def text(self, name):
        return self.read(name).decode()

    def test_a_program_is_stored_and_comes_back(self):
        self.given("in.ngc", "(top)\nG21 g90\nG00 X0 Y0\nN5 G01 X10.50 F600\n"
                             "X20 Z-1\nM2\n")
        result = self.run_cli("compress", "in.ngc")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertRegex(result.out, r"^in\.ngc -> in\.ustp: 1 page, 6 lines, "
                                     r"\d+ bytes, [\d.]+ % of 54, verified\n$")
        result = self.run_cli("decompress", "in.ustp", "-o", "out.ngc")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertEqual(self.text("out.ngc"),
                         "(top)\nG21 g90\nG0 X0 Y0\nG1 X10.5 F600\n"
                         "X20 Z-1\nM2\n")
        result = self.run_cli("verify", "in.ngc", "in.ustp")
        self.assertEqual(result.out,
                         "in.ngc and in.ustp are the same: 1 page\n")
        result = self.run_cli("info", "in.ustp")
        self.assertIn("page 1: program\n", result.out)
        self.assertIn("6 lines, 48 bytes of text", result.out)

    def test_a_program_is_shortened_on_its_way(self):
        self.given("in.ngc", circle(300))
        result = self.run_cli("compress", "in.ngc", "--tolerance", "0.005mm")
        self.assertEqual(result.code, 0, result.err)
        self.assertIn("5 lines within 0.005 mm", result.out)
        # Its own ending is the natural one, and any form can be asked for.
        self.run_cli("decompress", "in.ustp", "-o", "out.nc")
        self.assertEqual(self.text("out.nc").count("\n"), 5)
        result = self.run_cli("convert", "in.ustp", "r.nc", "--arc-words", "r")
        self.assertEqual(result.code, 0, result.err)
        self.assertIn(" R19.99", self.text("r.nc"))
        result = self.run_cli("decompress", "in.ustp", "--to", "svg")
        self.assertEqual(result.code, 0, result.err)
        result = self.run_cli("verify", "in.ngc", "in.ustp")
        self.assertEqual(result.code, 0)
        self.assertIn(", of 0.005 mm allowed", result.out)

    def test_drawings_are_no_programs(self):
        self.write("in.svg", (SVG % ' width="50mm" height="40mm"').encode())
        self.run_cli("compress", "in.svg")
        result = self.run_cli("decompress", "in.ustp", "-o", "out.ngc")
        self.assertEqual(result.code, 3)
        self.assertIn("unstep convert makes programs", result.err)
        self.assertNotIn("out.ngc", self.names())


class Steps(harness.CliTest):
    def given(self, name, text):
        self.write(name, text.encode())

    def text(self, name):
        return self.read(name).decode()

    def test_a_program_becomes_steps_and_comes_back(self):
        text = ("G21 G90 G17 G94\nG0 X0 Y0\nG1 X1 Y0.5 F1000\n"
                "X1.2 Y-0.73\nG0 X0 Y0\n")
        self.given("in.ngc", text + "M2\n")
        result = self.run_cli("steps", "in.ngc", "-o", "a.steps")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertRegex(result.out, r"^in\.ngc -> a\.steps: \d+ steps, 2 axes, "
                                     r"\d+ bytes\n$")
        for name in ("a.csv", "a.vcd"):
            result = self.run_cli("steps", "a.steps", "-o", name)
            self.assertEqual((result.code, result.err), (0, ""))
            result = self.run_cli("steps", name, "-o", "back.ngc", "--force")
            self.assertEqual((result.code, result.err), (0, ""))
            self.assertEqual(self.text("back.ngc"), text + "M2\n")

    def same_steps_again(self, name, *options):
        """steps -> program -> steps: not a bit differs."""
        result = self.run_cli("steps", name, "-o", "back.ngc", "--force",
                              *options)
        self.assertEqual((result.code, result.err), (0, ""))
        result = self.run_cli("steps", "back.ngc", "-o", "again.steps",
                              "--force", *options)
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertEqual(self.read("again.steps"), self.read(name))

    def test_reversed_steps_are_made_again(self):
        lines = ["G21 G90 G17 G94", "G0 X0 Y0 Z0"]
        for i in range(1, 120):
            lines.append("G1 X%.2f Y%.2f Z%.2f F900" %
                         (i * 7919 % 4001 / 100, i * 104729 % 3001 / 100,
                          i * 31 % 7 / 100))
            if i % 4 == 0:
                lines.append("G%d I%.2f J%.2f" % (2 + i // 4 % 2, i / 10, 0.37))
            if i % 9 == 0:
                lines.append("G0 X%.2f Y%.2f" % (i / 3, i / 7))
        self.given("in.ngc", "\n".join(lines + ["M2", ""]))
        for options in ([], ["--step", "0.05mm"], ["--method", "evaluation"],
                        ["--method", "device"], ["--no-arcs"]):
            options = options + ["--axes", "2"]
            self.run_cli("steps", "in.ngc", "-o", "a.steps", "--force",
                         *options)
            self.same_steps_again("a.steps", *options)
        self.run_cli("steps", "in.ngc", "-o", "a.steps", "--force")
        self.same_steps_again("a.steps")

    def test_noise_is_made_again(self):
        state, words = 1, bytearray()
        for _ in range(3000):
            state = state * 1103515245 + 12345 & 0x7fffffff
            words.append(b"\x01\x03\x04\x0c\x05\x07\x0d\x0f"[state >> 16 & 7])
        self.write("a.raw", bytes(words))
        self.run_cli("steps", "a.raw", "-o", "a.steps")
        self.same_steps_again("a.steps")

    def test_recorded_circles_and_polygons_come_back(self):
        figures = [
            "G1 X10 Y0 F1000\nY10\nX0\nY0\n",                  # a square
            "G1 X12.34 Y0.57 F1000\nX3.21 Y9.87\nX0 Y0\n",      # a triangle
            "G1 X8 Y1 F1000\nX11.5 Y7.3\nX5 Y12\nX-2 Y8.4\nX0 Y0\n",
            "G2 I0.05 F1000\n", "G3 I3 F1000\n", "G2 I5.01 J2.5 F1000\n",
            "G3 I-80.07 J61.3 F1000\n", "G2 I0 J-200 F1000\n",
            "G1 X10 Y0 F1000\nG3 X13 Y3 J3\nG1 Y9\nG3 X10 Y12 I-3\nG1 X0\n"
            "G3 X-3 Y9 J-3\nG1 Y3\nG3 X0 Y0 I3\n",             # round corners
        ]
        state = 5
        for _ in range(12):
            corners = []
            for _ in range(14):
                state = state * 1103515245 + 12345 & 0x7fffffff
                corners.append((state >> 12) % 8000 / 100 - 40)
            figures.append("".join(
                "G1 X%.2f Y%.2f F1000\n" % (corners[k], corners[k + 1])
                for k in range(0, 14, 2)) + "G1 X0 Y0 F1000\n")
        for i, figure in enumerate(figures):
            text = "G21 G90 G17 G94\nG0 X0 Y0\n" + figure
            self.given("in.ngc", text + "M2\n")
            self.run_cli("convert", "in.ngc", "tidy.ngc", "--force")
            for ending in ("steps", "vcd", "csv") if i < 9 else ("steps",):
                name = "a%d.%s" % (i, ending)
                self.run_cli("steps", "in.ngc", "-o", name)
                result = self.run_cli("steps", name, "-o", "back.ngc",
                                      "--force")
                self.assertEqual((result.code, result.err), (0, ""))
                self.assertEqual(self.text("back.ngc"), self.text("tidy.ngc"))

    def test_steps_take_the_time_of_the_machine(self):
        self.given("in.ngc", "G0 X0 Y0\nG1 X10 F600\n")
        result = self.run_cli("steps", "in.ngc", "-o", "a.csv", "--timed",
                              "--acceleration", "100")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertIn(", 1.100 s\n", result.out)

    def test_a_drawing_becomes_steps(self):
        self.write("in.svg", (SVG % ' width="50mm" height="40mm"').encode())
        result = self.run_cli("steps", "in.svg", "-o", "a.csv", "--step",
                              "5mm", "-q")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertTrue(self.text("a.csv").startswith(
            "# unstep step 5 origin 0 0\nx,y,rapid\n0,1,1\n0,1,1\n0,1,1\n1,1,1\n"))

    def test_firmware_gets_its_payload(self):
        self.given("in.ngc", "G0 X0 Y0\nG1 X0.03 Y0.01 F600\n")
        result = self.run_cli("steps", "in.ngc", "-o", "a.dev")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertEqual(self.read("a.dev")[:4], b"\x01\x03\x01\x00")
        result = self.run_cli("steps", "a.dev", "-o", "a.raw")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertEqual(self.read("a.raw"), b"\x01\x05\x01")

    def test_bad_streams_leave_nothing_behind(self):
        self.given("a.csv", "x,y\n1,0\n2,0\n")
        result = self.run_cli("steps", "a.csv", "-o", "out.ngc")
        self.assertEqual(result.code, 3)
        self.assertEqual(result.err,
                         "unstep: a.csv: line 3: a step is -1, 0 or 1\n")
        self.assertEqual(self.names(), ["a.csv"])


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
