"""Grey scans, scanned PDF files and recordings of encoders."""

import json
import os
import shutil
import unittest

import harness

MARK = "; pixels: "


def grey(width=160, height=120, dark=60, light=220):
    """A P5 file: bars on paper that gets darker to the right."""
    rows = bytearray()
    for y in range(height):
        for x in range(width):
            ink = 20 <= x < 140 and y % 16 < 4
            level = (dark if ink else light) * (1 - 0.4 * x / width)
            rows.append(int(level) + (x * 7 + y * 13) % 5)
    return b"P5\n%d %d\n255\n" % (width, height) + bytes(rows)


class Scans(harness.CliTest):
    def test_the_report_tells_what_was_done(self):
        self.write("page.pgm", grey())
        result = self.run_cli("compress", "page.pgm", "--threshold", "auto",
                              "--despeckle", "3")
        self.assertEqual(result.code, 0)
        self.assertIn(", verified" + MARK + "auto: local threshold, paper is ",
                      result.out)
        self.assertTrue(result.out.endswith(
            "; 0 specks of at most 3 px removed (0 px); lossless from there "
            "on\n"), result.out)
        self.assertIn("grey or colour pixels thresholded, not lossless: auto",
                      result.err)
        info = json.loads(self.run_cli("info", "--json", "page.ustp").out)
        text = json.dumps(info)
        self.assertIn("unstep:pixels", text)
        # The same again is the same drawing.
        result = self.run_cli("verify", "page.pgm", "page.ustp", "--threshold",
                              "auto", "--despeckle", "3")
        self.assertEqual(result.code, 0, result.out)

    def test_json_tells_it_too(self):
        self.write("page.pgm", grey())
        result = self.run_cli("compress", "page.pgm", "--threshold", "otsu",
                              "--invert", "yes", "--json", "-q")
        report = json.loads(result.out)
        self.assertEqual(len(report["pixel_work"]), 1)
        self.assertTrue(report["pixel_work"][0].endswith("(otsu); inverted"))
        self.assertFalse(report["lossless"])
        self.assertTrue(report["exact_from_there"])
        self.assertTrue(report["verified"])

    def test_lines_are_not_exact_from_there(self):
        self.write("page.pgm", grey())
        result = self.run_cli("compress", "page.pgm", "--threshold", "otsu",
                              "--tolerance", "1", "-q", "--json")
        self.assertFalse(json.loads(result.out)["exact_from_there"])

    def test_batch_reports_every_file(self):
        self.write("in/a.pgm", grey())
        self.write("in/b.pbm", harness.pbm(harness.pixels(40, 30)))
        self.write("in/deep/c.pgm", grey(light=200))
        result = self.run_cli("batch", "in", "-o", "out", "--threshold",
                              "auto", "--report", "log.json")
        self.assertEqual(result.code, 0, result.err)
        files = json.loads(self.read("log.json"))["files"]
        self.assertEqual([file["input"] for file in files],
                         ["in/a.pgm", "in/b.pbm", "in/deep/c.pgm"])
        self.assertEqual([file["lossless"] for file in files],
                         [False, True, False])
        self.assertEqual(files[1]["pixel_work"], [])
        for file in (files[0], files[2]):
            self.assertTrue(file["pixel_work"][0].startswith(
                "auto: local threshold, paper is "), file)
        result = self.run_cli("batch", "in", "-o", "out", "--threshold",
                              "auto", "--resume")
        self.assertIn("3 finished before", result.out)

    @unittest.skipUnless(shutil.which("pdfimages"), "needs poppler-utils")
    def test_a_pdf_of_lines_is_refused(self):
        self.write("page.pbm", harness.pbm(harness.pixels(40, 30)))
        result = self.run_cli("convert", "page.pbm", "page.pdf")
        self.assertEqual(result.code, 0, result.err)
        result = self.run_cli("compress", "page.pdf")
        self.assertEqual(result.code, 3)
        self.assertIn("no page of this PDF is an image", result.err)

    def test_pulses_become_steps(self):
        rows = ["time,XA,XB,YA,YB"]
        x = [(0, 0), (1, 0), (1, 1), (0, 1)]
        for i in range(9):
            rows.append("%d,%d,%d,%d,%d" % ((i,) + x[i % 4] + x[i // 2 % 4]))
        self.write("move.csv", "\n".join(rows).encode())
        result = self.run_cli("compress", "move.csv")
        self.assertEqual((result.code, result.err), (
            0, "unstep: warning: move.csv: times between the counts not "
            "kept\n"))
        self.assertIn("1 chain, 8 steps", result.out)
        result = self.run_cli("convert", "move.csv", "move.fc", "-q")
        self.assertIn("01010101", self.read("move.fc").decode())
        result = self.run_cli("convert", "move.csv", "half.fc", "--counts",
                              "x2", "-q")
        self.assertEqual(result.code, 0)

    def test_reverse_takes_recordings(self):
        self.write("move.vcd", b"$timescale 1 us $end $var wire 1 ! p $end\n"
                   b"$var wire 1 # q $end $enddefinitions $end\n"
                   b"#0 0! 0#\n#1 1!\n#2 1#\n#3 0!\n")
        result = self.run_cli("reverse", "move.vcd")
        self.assertEqual((result.code, result.out), (0, "3 0\n"))
        result = self.run_cli("reverse", "move.vcd", "--channels", "q,p",
                              "--method", "exact")
        self.assertEqual(result.code, 0)
        self.assertTrue(result.out.startswith("4 "), result.out)
        result = self.run_cli("reverse", "move.vcd", "--channels", "q,r")
        self.assertEqual(result.code, 2)
        self.assertIn("no signal of one bit is named 'r'", result.err)
        self.write("raw.bin", b"\x2d")
        self.assertEqual(
            self.run_cli("convert", "raw.bin", "-", "--to", "fc", "--from",
                         "raw2", "-q").code, 0)


if __name__ == "__main__":
    unittest.main()
