"""Lines instead of steps: --tolerance and --reverse device, through every
verb."""

import json
import math
import os

import harness
from harness import pbm, pixels


def disc(radius, margin=3):
    """A filled circle."""
    side = 2 * (radius + margin) + 1
    centre = radius + margin
    return ["".join("#" if math.hypot(x - centre, y - centre) <= radius
                    else "." for x in range(side)) for y in range(side)]


class Lines(harness.CliTest):
    def setUp(self):
        super().setUp()
        self.write("disc.pbm", pbm(disc(40)))
        self.write("boxes.pbm", pbm(pixels(90, 70, 3)))

    def report(self, *args):
        result = self.run_cli("compress", *args, "--json", "--force")
        self.assertEqual((result.code, result.err), (0, ""))
        return json.loads(result.out)

    def info(self, name):
        return json.loads(self.run_cli("info", "--json", name).out)[0]

    def rows(self, name):
        """The pixel rows of a P4 file."""
        data = self.read(name)
        width, height = map(int, data.split(b"\n", 2)[1].split())
        body = data[-((width + 7) // 8 * height):]
        return [body[i:i + (width + 7) // 8]
                for i in range(0, len(body), (width + 7) // 8)]

    def test_a_disc_becomes_few_arcs_within_the_tolerance(self):
        report = self.report("disc.pbm", "--tolerance", "1")
        self.assertEqual(report["tolerance"], [1, 1])
        self.assertFalse(report["lossless"])
        self.assertEqual(report["paths"], 1)
        self.assertLessEqual(report["lines"] + report["arcs"], 3)
        exact = self.report("disc.pbm", "-o", "exact.ustp")
        self.assertLess(report["output_bytes"], exact["output_bytes"])
        self.assertTrue(exact["lossless"])

    def test_the_report_names_lines_and_bound(self):
        result = self.run_cli("compress", "disc.pbm", "--tolerance", "1.5",
                              "--no-arcs", "--effort", "fast")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertRegex(result.out, r"^disc.pbm -> disc.ustp: 1 page, "
                         r"87 x 87 px, 1 path, \d+ lines within 1.5 px, "
                         r"\d+ bytes, .* verified\n$")

    def test_a_page_that_is_smaller_than_its_lines_stays_exact(self):
        for effort in ["fast", "standard"]:
            report = self.report("boxes.pbm", "--tolerance", "1",
                                 "--effort", effort)
            self.assertTrue(report["lossless"])
            exact = self.report("boxes.pbm", "-o", "exact.ustp",
                                "--effort", effort)
            self.assertEqual(report["output_bytes"], exact["output_bytes"])

    def test_many_lines_are_no_larger_than_the_page_either(self):
        self.write("noise.pbm", pbm(pixels(700, 700, 5)))
        report = self.report("noise.pbm", "--tolerance", "1", "--no-arcs",
                             "--effort", "fast")
        exact = self.report("noise.pbm", "-o", "exact.ustp",
                            "--effort", "fast")
        self.assertLessEqual(report["output_bytes"], exact["output_bytes"])

    def test_ink_comes_back_near_its_edges(self):
        self.compress("disc.pbm", "--tolerance", "1")
        self.expect(["decompress", "disc.ustp", "-o", "again.pbm"],
                    out="disc.ustp -> again.pbm: 1 page\n")
        before, after = self.rows("disc.pbm"), self.rows("again.pbm")
        self.assertEqual(len(before), len(after))
        # Nothing is left of the inner disc's paper or the outer ring's ink.
        self.write("inner.pbm", pbm(disc(38, 5)))
        self.write("outer.pbm", pbm(disc(42, 1)))
        for row, inner, outer in zip(after, self.rows("inner.pbm"),
                                     self.rows("outer.pbm")):
            for got, least, most in zip(row, inner, outer):
                self.assertEqual(got & least, least)
                self.assertEqual(got & ~most & 255, 0)

    def test_verify_measures_the_deviation(self):
        self.compress("disc.pbm", "--tolerance", "1")
        result = self.run_cli("verify", "disc.pbm", "disc.ustp")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertRegex(
            result.out,
            r"^disc.ustp: deviates by up to [01](\.\d+)? px, of 1 px allowed, "
            r"at \([\d.]+, [\d.]+\), contour 1, step \d+\n"
            r"disc.pbm and disc.ustp are the same within the bound: 1 page\n$")

    def test_verify_finds_what_is_beyond_the_bound(self):
        self.compress("disc.pbm", "--tolerance", "1", "--effort", "fast")
        rows = disc(40)
        rows[42] = "".join("#" * 60 + rows[42][60:])
        self.write("other.pbm", pbm(rows))
        result = self.run_cli("verify", "other.pbm", "disc.ustp")
        self.assertEqual((result.code, result.err), (1, ""))
        self.assertRegex(result.out,
                         r"^other.pbm and disc.ustp differ: deviates by up to "
                         r"\d+(\.\d+)? px, of 1 px allowed, ")

    def test_device_lines_come_back_as_the_device_draws_them(self):
        report = self.report("boxes.pbm", "--reverse", "device")
        self.assertEqual((report["tolerance"], report["arcs"]), ([1, 1], 0))
        self.expect(["decompress", "boxes.ustp", "-o", "again.pbm", "-q"])
        # A breaking step may join an edge and the first step around its
        # corner, so pixels at corners differ, and few of them.
        before, after = self.rows("boxes.pbm"), self.rows("again.pbm")
        differing = sum((a ^ b).bit_count() for row, other in
                        zip(before, after) for a, b in zip(row, other))
        self.assertLess(differing, 90 * 70 // 20)
        result = self.run_cli("verify", "boxes.pbm", "boxes.ustp")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertIn("px on an axis, of 1 px allowed", result.out)

    def test_device_refuses_diagonal_steps(self):
        self.write("d.fc", b"open8 0 0: 0101\n")
        result = self.run_cli("compress", "d.fc", "--reverse", "device")
        self.assertEqual((result.code, result.out), (2, ""))
        self.assertRegex(result.err, r"^unstep: d.fc: chain 1: step 1 has code 1: ")

    def test_info_names_the_lines(self):
        self.compress("disc.pbm", "--tolerance", "0.75")
        page = self.info("disc.ustp")["pages"][0]
        self.assertEqual((page["kind"], page["fidelity"], page["tolerance"]),
                         ("paths", "tolerance", [3, 4]))
        self.assertEqual(page["paths"], 1)
        self.assertGreater(page["arcs"] + page["lines"], 0)
        self.assertGreater(page["steps"], 250)
        text = self.run_cli("info", "disc.ustp").out
        self.assertIn("page 1: paths, 87 x 87 px, filled, within 0.75 px", text)
        self.assertIn("bits per step", text)

    def test_a_length_needs_a_resolution(self):
        self.expect_error(
            ["compress", "disc.pbm", "--tolerance", "0.1mm"], 2,
            "unstep: disc.pbm: a length in mm or in needs a resolution, and "
            "none is known\n")

    def test_bad_tolerances(self):
        for word in ["0", "x", "-1", "1kg"]:
            result = self.run_cli("compress", "disc.pbm", "--tolerance", word)
            self.assertEqual((result.code, result.out), (2, ""), word)
            self.assertEqual(result.err.count("\n"), 1)

    def test_lines_and_device_exclude_each_other(self):
        result = self.run_cli("compress", "disc.pbm", "--tolerance", "1",
                              "--reverse", "device")
        self.assertEqual((result.code, result.out), (2, ""))

    def test_the_lines_themselves(self):
        self.compress("disc.pbm", "--tolerance", "1")
        self.expect(["decompress", "disc.ustp", "--to", "svg"],
                    out="disc.ustp -> disc.svg: 1 page\n")
        self.assertIn(b"<path", self.read("disc.svg"))
        self.expect_error(
            ["decompress", "disc.ustp", "--to", "fc"], 3,
            "unstep: disc.ustp: page 1 is lines, and Freeman text holds unit "
            "steps; choose another --to, or convert it with --grid\n")

    def test_truncated_at_every_byte(self):
        self.compress("disc.pbm", "--tolerance", "1")
        self.check_truncated(self.read("disc.ustp"))

    def test_batch_takes_a_tolerance(self):
        os.mkdir(self.path("in"))
        os.rename(self.path("disc.pbm"), self.path("in/disc.pbm"))
        result = self.run_cli("batch", "in", "-o", "out", "--tolerance", "1",
                              "-q")
        self.assertEqual((result.code, result.err), (0, ""))
        page = self.info("out/disc.pbm.ustp")["pages"][0]
        self.assertEqual(page["kind"], "paths")
        result = self.run_cli("batch", "--decompress", "out", "-o", "back",
                              "-q")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertEqual(self.names("back"), ["disc.pbm"])


if __name__ == "__main__":
    harness.main()
