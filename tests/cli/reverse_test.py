#!/usr/bin/env python3
"""Runs `unstep reverse` as a user would. UNSTEP_PROGRAM names it."""

import os
import pty
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["UNSTEP_PROGRAM"]

FIG_5 = """\
0 1 0 0
2 1 1 -1
0 2 1 0
0 3 1 1
2 3 2 -2
0 4 2 0
0 5 2 2
2 5 3 -3
0 6 3 0
0 7 3 3
0 8 3 6
segment 8 3
"""


def run(text, *words):
    return subprocess.run([PROGRAM, "reverse", *words], input=text,
                          capture_output=True, check=False)


class Stream:
    """The program behind pipes; steps go in one at a time."""

    def __init__(self, *words, stdin=subprocess.PIPE):
        self.process = subprocess.Popen([PROGRAM, "reverse", *words],
                                        stdin=stdin, stdout=subprocess.PIPE)

    def send(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def line(self):
        return self.process.stdout.readline().decode()

    def close(self):
        self.process.stdin.close()
        rest = self.process.stdout.read().decode()
        self.process.stdout.close()
        return rest, self.process.wait()


class Reverse(unittest.TestCase):
    def output(self, text, *words):
        done = run(text, *words)
        self.assertEqual(done.stderr, b"")
        self.assertEqual(done.returncode, 0)
        return done.stdout.decode()

    def refused(self, code, message, text, *words, printed=b""):
        done = run(text, *words)
        self.assertEqual(done.stdout, printed)
        self.assertEqual(done.returncode, code)
        self.assertIn(message, done.stderr.decode())

    def test_table_is_that_of_fig_5(self):
        self.assertEqual(self.output(b"02002002000\n", "--table"), FIG_5)
        self.assertEqual(self.output(b"02002002000"), "8 3\n")

    def test_gate_level_gives_the_output_columns_of_fig_5(self):
        rows = self.output(b"02002002000", "--method", "gate-level",
                           "--table").splitlines()
        self.assertEqual(rows[0], "0 1 0 0 1 0 0 0")
        self.assertEqual(rows[1], "2 1 1 -1 0 1 0 0")
        self.assertEqual(rows[10], "0 8 3 6 0 0 1 1")
        self.assertEqual(rows[11], "segment 8 3")

    def test_bytes_are_steps(self):
        self.assertEqual(self.output(bytes([4, 4, 6]), "--input", "bytes"),
                         "-2 -1\n")

    def test_a_change_of_sign_closes_before_the_step(self):
        self.assertEqual(self.output(b"00 44\n"), "2 0\n-2 0\n")
        self.assertEqual(self.output(b"0 4", "--table"),
                         "0 1 0 0\nsegment 1 0\n4 1 0 0\nsegment -1 0\n")

    def test_every_segment_is_seen_before_the_next_step_is_sent(self):
        stream = Stream()
        for _ in range(50):
            for step in b"02002002000":
                stream.send(bytes([step]))
            self.assertEqual(stream.line(), "8 3\n")
        self.assertEqual(stream.close(), ("", 0))

    def test_a_sign_change_is_seen_when_the_new_sign_arrives(self):
        stream = Stream("--input", "bytes")
        for step in (0, 0, 0):
            stream.send(bytes([step]))
        for step, seen in ((4, "3 0\n"), (0, "-1 0\n"), (4, "1 0\n")):
            stream.send(bytes([step]))
            self.assertEqual(stream.line(), seen)
        self.assertEqual(stream.close(), ("-1 0\n", 0))

    def test_table_rows_come_step_by_step(self):
        stream = Stream("--table")
        for step, row in zip(b"02002002000", FIG_5.splitlines()):
            stream.send(bytes([step]))
            self.assertEqual(stream.line(), row + "\n")
        self.assertEqual(stream.line(), "segment 8 3\n")
        self.assertEqual(stream.close(), ("", 0))

    def test_a_terminal_gets_segments_at_once(self):
        master, slave = pty.openpty()
        stream = Stream(stdin=slave)
        os.close(slave)
        os.write(master, b"02002002000\n")
        self.assertEqual(stream.line(), "8 3\n")
        os.write(master, b"22\n\x04")
        self.assertEqual(stream.line(), "0 2\n")
        self.assertEqual(stream.process.wait(), 0)
        stream.process.stdout.close()
        os.close(master)

    def test_forward_output_is_reverse_input(self):
        steps = subprocess.run([PROGRAM, "interpolate", "-70", "30"],
                               capture_output=True, check=True).stdout
        segments = self.output(steps).splitlines()
        self.assertEqual((sum(int(s.split()[0]) for s in segments),
                          sum(int(s.split()[1]) for s in segments)),
                         (-70, 30))

    def test_exact_segments_are_the_longest_that_a_line_draws(self):
        self.assertEqual(self.output(b"0100 1001000 2", "--method", "exact"),
                         "0 1 11 3 10 6\n2 2 1 0 1 0\n")
        self.assertEqual(self.output(b"0202 2", "--method", "exact",
                                     "--connectivity", "4"), "0 2 5 3 5 0\n")
        self.assertEqual(self.output(bytes([0, 2]), "--method", "exact",
                                     "--input", "bytes"),
                         "0 0 1 0 1 0\n2 2 1 0 1 0\n")

    def test_exact_table_is_the_open_segment_after_every_step(self):
        self.assertEqual(self.output(b"001 4", "--method", "exact", "--table"),
                         "0 0 0 1 0 1 0\n"
                         "0 0 0 2 0 1 0\n"
                         "1 0 1 3 1 3 0\n"
                         "segment 0 1 3 1 3 0\n"
                         "4 4 4 1 0 1 0\n"
                         "segment 4 4 1 0 1 0\n")

    def test_exact_segments_are_seen_when_the_next_one_begins(self):
        stream = Stream("--method", "exact")
        for _ in range(3):
            stream.send(b"7")
        stream.send(b"3")
        self.assertEqual(stream.line(), "7 7 3 0 1 0\n")
        self.assertEqual(stream.close(), ("3 3 1 0 1 0\n", 0))

    def test_tolerance_gives_lines_within_it(self):
        within = ("--method", "tolerance", "--tolerance")
        self.assertEqual(self.output(b"001000100022222222", *within, "1"),
                         "10 3\n0 7\n")
        self.assertEqual(self.output(b"00000002", *within, "0.5"),
                         "7 0\n0 1\n")
        # Codes are as seen: 2 is up. Steps may be bytes.
        self.assertEqual(self.output(bytes([2, 2, 2, 4]), *within, "1",
                                     "--input", "bytes", "--table"),
                         "0 0 -1 3\n")

    def test_tolerance_keeps_the_ends_of_the_chain(self):
        steps = subprocess.run([PROGRAM, "interpolate", "--arc", "0", "-90",
                                "90", "-90"],
                               capture_output=True, check=True).stdout
        for words in ([], ["--no-arcs"], ["--effort", "max"]):
            rows = [row.split() for row in self.output(
                steps, "--method", "tolerance", "--tolerance", "2",
                *words).splitlines()]
            self.assertEqual(sum(float(row[0]) for row in rows), 90)
            self.assertEqual(sum(float(row[1]) for row in rows), -90)
            arcs = [row for row in rows if len(row) == 5]
            self.assertEqual(len(arcs) == 0, words == ["--no-arcs"])
            for row in arcs:
                self.assertEqual(row[4], "cw")

    def test_tolerance_closes_closed_chains(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "box.fc")
            with open(path, "w", encoding="ascii") as file:
                file.write("closed4 5 5: " + "0" * 9 + "2" * 9 + "4" * 9
                           + "6" * 9 + "\n")
            rows = [tuple(map(int, row.split())) for row in self.output(
                b"", path, "--method", "tolerance", "--tolerance", "1",
                "--no-arcs", "--table").splitlines()]
        self.assertEqual(len(rows), 4)
        ends = [(x + dx, y + dy) for x, y, dx, dy in rows]
        self.assertEqual(ends[-1:] + ends[:-1], [row[:2] for row in rows])

    def test_tolerance_is_refused_where_it_says_nothing(self):
        within = ("--method", "tolerance")
        self.refused(2, "--method tolerance needs --tolerance E", b"0",
                     *within)
        self.refused(2, "--tolerance is for --method tolerance", b"0",
                     "--tolerance", "1")
        self.refused(2, "--effort is for --method tolerance", b"0",
                     "--effort", "max")
        self.refused(2, "a length in mm or in needs a resolution", b"0",
                     *within, "--tolerance", "1mm")
        self.refused(2, "is not within 1/256 and 2^20 grid units", b"0",
                     *within, "--tolerance", "0.001")
        self.refused(3, "holds no steps", b"", *within, "--tolerance", "1")
        self.refused(3, "'x' is no Freeman code", b"01x", *within,
                     "--tolerance", "1")
        self.refused(3, "more than 2 steps, above --max-steps", b"000",
                     *within, "--tolerance", "1", "--max-steps", "2")

    def test_bad_input_is_named_with_its_place(self):
        self.refused(3, "unstep: standard input: holds no steps\n", b"")
        self.refused(3, "holds no steps", b" \n\n")
        self.refused(3, "line 2, column 3: 'x' is no Freeman code",
                     b"00\n00x0\n")
        self.refused(3, "line 1, column 3: '1' is a diagonal step", b"001")
        self.refused(3, "byte 2: byte 0x30 is no Freeman code", b"\x000",
                     "--input", "bytes")
        self.refused(3, "byte 1: byte 0x07 is a diagonal step", b"\x07",
                     "--input", "bytes")
        self.refused(2, "unknown method 'dss2'", b"0", "--method", "dss2")
        self.refused(2, "unknown input 'hex'", b"0", "--input", "hex")
        exact = ("--method", "exact")
        self.refused(3, "line 1, column 2: '8' is no Freeman code", b"18",
                     *exact)
        self.refused(3, "line 1, column 2: '3' is a diagonal step; 4-connected",
                     b"23", *exact, "--connectivity", "4")
        self.refused(3, "holds no steps", b"", *exact)
        self.refused(2, "--connectivity 6: 4 or 8", b"0", *exact,
                     "--connectivity", "6")
        self.refused(2, "--connectivity is for --method exact", b"0",
                     "--connectivity", "8")

    def test_a_bad_file_prints_no_segments_at_all(self):
        with tempfile.TemporaryFile() as file:
            file.write(b"0044220066x")
            file.seek(0)
            done = subprocess.run([PROGRAM, "reverse"], stdin=file,
                                  capture_output=True, check=False)
        self.assertEqual(done.stdout, b"")
        self.assertEqual(done.returncode, 3)
        # A stream cannot be known to turn bad: what was complete is out.
        self.refused(3, "'x' is no Freeman code", b"0044x", printed=b"2 0\n")

    def test_a_good_file_is_read_once(self):
        with tempfile.TemporaryFile() as file:
            file.write(b"0044")
            file.seek(0)
            done = subprocess.run([PROGRAM, "reverse"], stdin=file,
                                  capture_output=True, check=False)
        self.assertEqual(done.stdout, b"2 0\n-2 0\n")


if __name__ == "__main__":
    unittest.main()
