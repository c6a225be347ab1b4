#!/usr/bin/env python3
"""Runs `unstep interpolate` as a user would. UNSTEP_PROGRAM names it."""

import csv
import io
import json
import os
import subprocess
import unittest

PROGRAM = os.environ["UNSTEP_PROGRAM"]

MOVES = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)]

FIG_4 = """\
0 6 3 -1
0 5 3 2
2 5 2 -3
0 4 2 -1
0 3 2 1
2 3 1 -2
0 2 1 -1
0 1 1 0
2 1 0 -1
0 0 0 -1
"""


def run(*words):
    return subprocess.run([PROGRAM, "interpolate", *words],
                          capture_output=True, text=True, check=False)


def end_of(steps):
    return (sum(MOVES[int(s)][0] for s in steps),
            sum(MOVES[int(s)][1] for s in steps))


class Interpolate(unittest.TestCase):
    def output(self, *words):
        done = run(*words)
        self.assertEqual(done.stderr, "")
        self.assertEqual(done.returncode, 0)
        return done.stdout

    def refused(self, code, message, *words):
        done = run(*words)
        self.assertEqual(done.stdout, "", words)
        self.assertEqual(done.returncode, code, words)
        self.assertIn(message, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)

    def test_steps_and_table_are_those_of_fig_4(self):
        self.assertEqual(self.output("--method", "device", "7", "3"),
                         "0020020020\n")
        self.assertEqual(
            self.output("--method", "device", "--table", "7", "3"), FIG_4)

    def test_gate_level_table_adds_the_output_columns_of_fig_4(self):
        rows = self.output("--method", "gate-level", "--table", "7", "3")
        self.assertEqual([r[:len(f)] for r, f in zip(rows.splitlines(),
                                                     FIG_4.splitlines())],
                         FIG_4.splitlines())
        self.assertEqual(rows.splitlines()[0], "0 6 3 -1 1 0 1 0")
        self.assertEqual(rows.splitlines()[-1], "0 0 0 -1 1 0 1 1")

    def test_every_line_method_ends_where_asked_in_every_quadrant(self):
        for method in ("device", "gate-level", "rate-multiplier", "evaluation",
                       "evaluation8", "cordic", "meggitt", "rom"):
            for dx, dy in ((9, 4), (-9, 4), (9, -4), (-9, -4), (0, -3), (5, 0)):
                out = self.output("--method", method, str(dx), str(dy))
                self.assertEqual(end_of(out.strip()), (dx, dy), method)

    def test_every_arc_method_ends_where_asked(self):
        for method in ("circular", "cordic", "meggitt", "rom"):
            for end in ((5, -5), (0, 0), (-5, -5), (0, -10)):
                for sense in ([], ["--ccw"]):
                    out = self.output("--method", method, "--arc", "0", "-5",
                                      *map(str, end), *sense)
                    self.assertEqual(end_of(out.strip()), end, method)

    def test_methods_per_period_print_increments(self):
        for method in ("increments", "general"):
            out = self.output("--method", method, "--feed", "100", "--period",
                              "0.1", "300", "-400")
            rows = [tuple(map(int, r.split())) for r in out.splitlines()]
            self.assertEqual((sum(r[0] for r in rows), sum(r[1] for r in rows)),
                             (300, -400))
            self.assertEqual(len(rows), 50, method)
            out = self.output("--method", method, "--arc", "100", "0", "0", "0")
            rows = [tuple(map(int, r.split())) for r in out.splitlines()]
            self.assertEqual((sum(r[0] for r in rows), sum(r[1] for r in rows)),
                             (0, 0))

    def test_rate_multiplier_shows_a_frame_of_16_pulses(self):
        rows = self.output("--method", "rate-multiplier", "--bits", "4",
                           "--table", "5", "8").splitlines()
        # 8 is stage 0, the odd pulses; 5 is stages 1 and 3.
        self.assertEqual("".join(r.split()[0] for r in rows),
                         "202.20202" "02.202.")
        self.assertEqual(len(rows), 16)
        self.assertEqual(rows[0], "2 5 8 1 1")
        self.assertEqual(rows[-1], ". 5 8 16 0")

    def test_csv_and_json_hold_the_same_ticks(self):
        rows = list(csv.DictReader(io.StringIO(
            self.output("--csv", "--method", "evaluation", "4", "-2"))))
        whole = json.loads(
            self.output("--json", "--method", "evaluation", "4", "-2"))
        self.assertEqual(whole["method"], "evaluation")
        self.assertEqual(whole["tag"], "C")
        self.assertEqual(len(rows), 6)
        for row, tick in zip(rows, whole["ticks"]):
            self.assertEqual(int(row["step"]), tick["step"])
            self.assertEqual(int(row["dx"]), tick["dx"])
            self.assertEqual(int(row["F"]), tick["registers"]["F"])
        empty = json.loads(self.output("--json", "0", "0"))
        self.assertEqual(empty["ticks"], [])

    def test_list_has_a_line_with_its_tag_for_every_method(self):
        words = [r.split()[:2] for r in self.output("--list").splitlines()]
        self.assertEqual(words, [
            ["device", "A1"], ["gate-level", "A3"], ["rate-multiplier", "B"],
            ["evaluation", "C"], ["evaluation8", "C"], ["circular", "D1"],
            ["increments", "D2"], ["cordic", "D3"], ["meggitt", "D3"],
            ["rom", "D4"], ["general", "D5"]])

    def test_lengths_are_grid_units_with_or_without_px(self):
        self.assertEqual(self.output("7px", "-3 px"), self.output("7", "-3"))
        self.assertEqual(self.output("--arc", "0", "-50px", "+50px", "-50"),
                         self.output("--arc", "0", "-50", "50", "-50"))
        general = ["--method", "general", "--csv", "--feed"]
        self.assertEqual(
            self.output(*general, "200px", "--period", "10ms", "20", "5"),
            self.output(*general, "200", "--period", "0.01s", "20", "5"))

    def test_lengths_that_need_a_scale_are_refused(self):
        reason = "a length in mm or in needs a resolution, and none is known"
        for words in (["DX '5mm': ", "5mm", "1"], ["DY '-5in': ", "1", "-5in"],
                      ["CX '2 mm': ", "--arc", "2 mm", "0", "0", "0"],
                      ["--feed: ", "--feed", "3in", "1", "1"]):
            self.refused(2, words[0] + reason, *words[1:])

    def test_bad_requests_print_no_result(self):
        self.refused(2, "unknown method 'bresenham'", "--method", "bresenham",
                     "1", "1")
        self.refused(2, "DX DY or --arc", "1")
        self.refused(2, "DX DY or --arc")
        self.refused(2, "DX 'abc' is not a length", "abc", "1")
        self.refused(2, "DY '2.5' is not a whole number", "1", "2.5")
        self.refused(2, "DY '-1e3' is not a length", "1", "-1e3")
        self.refused(3, "DX '2147483648' is outside", "2147483648", "1")
        self.refused(2, "circular draws no lines", "--method", "circular", "1",
                     "1")
        self.refused(2, "device draws no arcs", "--method", "device", "--arc",
                     "5", "0", "0", "0")
        self.refused(2, "is not on the circle", "--arc", "10", "0", "30", "0")
        self.refused(3, "arc radius is 0", "--arc", "0", "0", "5", "5")
        self.refused(3, "arc centre (1073741824, 0)", "--arc", "1073741824",
                     "0", "0", "0")
        self.refused(3, "needs registers of 5 bits", "--method",
                     "rate-multiplier", "--bits", "4", "16", "0")
        self.refused(2, "--feed: '-1' is not a length", "--method",
                     "increments", "--feed", "-1", "5", "5")
        self.refused(3, "feed", "--method", "increments", "--feed", "0", "5",
                     "5")
        self.refused(2, "--period: '1px' is not a time", "--period", "1px",
                     "5", "5")
        self.refused(2, "--bits: '33' is not within 1 to 32", "--bits", "33",
                     "5", "5")
        self.refused(2, "--source: 'sine' is not cordic, meggitt or rom",
                     "--source", "sine", "5", "5")
        self.refused(2, "not both", "--arc", "5", "0", "0", "0", "--", "1",
                     "1")
        self.refused(2, "exclude each other", "--csv", "--json", "1", "1")


if __name__ == "__main__":
    unittest.main()
