"""Strokes along the middle of the ink: --trace, --order and --overlay."""

import json

import harness
from harness import pbm


def cross(side=61, half=2):
    """Two lines, 2 * half + 1 pixels wide."""
    middle = side // 2
    return ["".join("#" if (abs(x - middle) <= half and 5 <= y < side - 5) or
                    (abs(y - middle) <= half and 5 <= x < side - 5) else "."
                    for x in range(side)) for y in range(side)]


class Strokes(harness.CliTest):
    def setUp(self):
        super().setUp()
        self.write("cross.pbm", pbm(cross()))

    def compress(self, *args):
        result = self.run_cli("compress", "cross.pbm", "--json", "--force",
                              *args)
        self.assertEqual((result.code, result.err), (0, ""))
        return json.loads(result.out)

    def test_a_cross_is_two_strokes_of_one_pen(self):
        report = self.compress("--trace", "centerline", "--tolerance", "1")
        self.assertEqual((report["paths"], report["lines"]), (2, 2))
        self.assertFalse(report["lossless"])
        info = json.loads(self.run_cli("info", "--json", "cross.ustp").out)
        self.assertEqual(info[0]["pages"][0]["pens"],
                         [{"width": 5.0, "paths": 2}])
        self.assertIn("pens: 5 px (2 paths)",
                      self.run_cli("info", "cross.ustp").out)

    def test_without_a_tolerance_every_step_is_kept(self):
        report = self.compress("--trace", "centerline")
        self.assertEqual(report["tolerance"], [0, 1])
        self.assertEqual(report["paths"], 2)

    def test_auto_takes_strokes_where_they_are_simpler(self):
        self.expect(["convert", "cross.pbm", "a.svg", "-q", "--trace", "auto",
                     "--tolerance", "1"])
        self.assertIn(b'stroke-linecap="round"', self.read("a.svg"))

    def test_auto_takes_what_is_smaller_in_a_file(self):
        sizes = [self.compress("--trace", trace, "--tolerance", "1")["output_bytes"]
                 for trace in ("auto", "contour", "centerline")]
        self.assertEqual(sizes[0], min(sizes))

    def test_verify_says_how_far_the_ink_is_off(self):
        self.compress("--trace", "centerline", "--tolerance", "1")
        result = self.run_cli("verify", "cross.pbm", "cross.ustp",
                              "--overlay", "off.svg")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertRegex(result.out, r"drawn ink is up to [0-9.]+ px off, at "
                         r"\(\d+, \d+\); \d+ pixels? differs?")
        self.assertIn(b'fill="#d00"', self.read("off.svg"))
        again = self.run_cli("verify", "cross.pbm", "cross.ustp",
                             "--overlay", "off.svg")
        self.assertEqual(again.code, 4)

    def test_strokes_become_svg_and_ink(self):
        self.compress("--trace", "centerline", "--tolerance", "1")
        self.expect(["decompress", "cross.ustp", "-o", "a.svg", "-q"])
        self.assertIn(b'stroke-linecap="round"', self.read("a.svg"))
        self.expect(["decompress", "cross.ustp", "-o", "a.png", "-q"])

    def test_order_travel_says_what_it_saves(self):
        result = self.run_cli("convert", "cross.pbm", "a.svg", "--trace",
                              "centerline", "--order", "travel")
        self.assertEqual(result.code, 0)
        self.assertRegex(result.err, "travel between lines is .* px instead")
        refused = self.run_cli("compress", "cross.pbm", "--order", "travel")
        self.assertEqual(refused.code, 3)
        self.assertIn("--order travel needs lines", refused.err)

    def test_order_travel_orders_programs_of_drawings(self):
        dots = ["".join("#" if x % 40 in (3, 4, 5) and y % 40 in (3, 4, 5)
                        else "." for x in range(160)) for y in range(160)]
        self.write("dots.pbm", pbm(dots))
        args = ["convert", "dots.pbm", "a.ngc", "--trace", "centerline",
                "--profile", "laser", "--unit-size", "0.1mm", "--force"]
        given = self.run_cli(*args)
        self.assertEqual(given.code, 0)
        self.assertNotIn("travel between", given.err)
        before = self.read("a.ngc")
        ordered = self.run_cli(*args, "--order", "travel")
        self.assertIn("travel between lines is", ordered.err)
        self.assertNotEqual(before, self.read("a.ngc"))
        kept = self.run_cli("convert", "a.ngc", "b.ngc", "--order", "travel")
        self.assertEqual(kept.code, 2)
        self.assertIn("the motions of a program keep their order", kept.err)

    def test_ink_that_strokes_do_not_draw_is_warned_of(self):
        # A frame whose pen is as thick as what it encloses, with a tail.
        blot = ["".join("#" if (x - 60) ** 2 + (y - 60) ** 2 < 2500 and
                        not (40 < x < 80 and y > 55) else "."
                        for x in range(121)) for y in range(121)]
        self.write("blot.pbm", pbm(blot))
        self.run_cli("compress", "blot.pbm", "--trace", "centerline",
                     "--tolerance", "1")
        off = self.run_cli("verify", "blot.pbm", "blot.ustp").out
        again = self.run_cli("compress", "blot.pbm", "--trace", "centerline",
                             "--tolerance", "1", "--force")
        distance = float(off.split("up to ")[1].split(" px")[0])
        self.assertEqual("strokes are not what this ink is" in again.err,
                         distance > 3.5)

    def test_the_device_has_no_centrelines(self):
        result = self.run_cli("compress", "cross.pbm", "--trace",
                              "centerline", "--reverse", "device")
        self.assertIn("no centrelines", result.err)
        self.assertNotEqual(result.code, 0)


if __name__ == "__main__":
    harness.main()
