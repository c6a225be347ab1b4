"""unstep convert, and boxes of pages."""

import json
import os

import harness
from harness import FREEMAN, pbm, pixels

SVG = b"""<svg xmlns="http://www.w3.org/2000/svg" width="20mm" height="10mm"
 viewBox="0 0 20 10"><path fill-rule="evenodd"
 d="M1 1H19V9H1ZM3.5 3V7H16.5V3Z"/></svg>
"""


class Convert(harness.CliTest):
    def setUp(self):
        super().setUp()
        self.ink = pbm(pixels(60, 40, 5))
        self.write("a.pbm", self.ink)
        self.write("part.svg", SVG)
        self.write("chains.fc", FREEMAN)

    def test_contours_in_every_vector_format_are_the_same_ink(self):
        for word in ["svg", "dxf", "hpgl", "json", "fc"]:
            self.expect(["convert", "a.pbm", f"a.{word}"],
                        out=f"a.pbm -> a.{word}: 1 page\n", err=None)
        for word in ["svg", "json", "fc"]:
            self.expect(["convert", f"a.{word}", f"{word}.pbm", "-q"])
            self.assertEqual(self.read(f"{word}.pbm"), self.ink, word)

    def expect(self, args, code=0, out=None, err="", stdin=b""):
        """As the base class; err None leaves warnings to the caller."""
        if err is not None:
            return super().expect(args, code, out, err, stdin)
        result = self.run_cli(*args, stdin=stdin)
        self.assertEqual(result.code, code, args)
        if out is not None:
            self.assertEqual(result.out, out, args)
        return result

    def test_the_same_as_through_a_file(self):
        rows = ["".join("#" if (x - 99) ** 2 + (y - 99) ** 2 < 9000
                        else "." for x in range(200)) for y in range(200)]
        self.write("a.pbm", pbm(rows))
        self.compress("a.pbm", "--tolerance", "1", "--effort", "fast")
        for word in ["svg", "json"]:
            self.expect(["decompress", "a.ustp", "--to", word, "-q"])
            self.expect(["convert", "a.pbm", f"b.{word}", "--tolerance", "1",
                         "-q"])
            self.assertEqual(self.read(f"b.{word}"), self.read(f"a.{word}"))

    def test_what_a_format_cannot_hold_is_named(self):
        result = self.expect(["convert", "a.pbm", "a.plt"], err=None)
        self.assertIn("unstep: warning: a.pbm: ", result.err)

    def test_vertices_stay_and_steps_come_by_a_grid(self):
        self.compress("part.svg")
        info = json.loads(self.run_cli("info", "--json", "part.ustp").out)[0]
        self.assertEqual(info["pages"][0]["kind"], "paths")
        self.assertEqual(info["pages"][0]["fidelity"], "exact")
        self.expect(["verify", "part.svg", "part.ustp"],
                    out="part.svg and part.ustp are the same: 1 page\n")
        self.expect(["convert", "part.svg", "part.fc", "--grid", "0.5mm"],
                    out="part.svg -> part.fc: 1 page\n",
                    err="unstep: warning: part.svg: chain text has no name, "
                    "resolution or metadata\n")
        text = self.read("part.fc").decode()
        self.assertIn("closed4 2 2:", text)
        self.assertEqual(sum(line.startswith("closed4")
                             for line in text.splitlines()), 2)

    def test_a_grid_makes_pixels_of_its_width(self):
        self.expect(["convert", "part.svg", "part.pbm", "--grid", "0.5mm",
                     "-q"])
        head, size, body = self.read("part.pbm").split(b"\n", 2)
        self.assertEqual((head, size), (b"P4", b"40 20"))
        ink = sum(byte.bit_count() for byte in body)
        self.assertEqual(ink, 36 * 16 - 26 * 8)

    def test_steps_of_vectors_become_lines_again(self):
        self.expect(["convert", "part.svg", "lines.json", "--grid", "0.1mm",
                     "--tolerance", "1", "-q"])
        shapes = json.loads(self.read("lines.json"))["pages"][0]["shapes"]
        self.assertEqual([len(shape["path"]) for shape in shapes], [4, 4])

    def test_pages_are_numbered(self):
        self.write("book.pbm", self.ink + pbm(pixels(20, 30, 6)))
        self.expect(["convert", "book.pbm", "book.svg"],
                    out="book.pbm -> book-0001.svg ... book-0002.svg: "
                    "2 pages\n")
        self.expect(["convert", "book.pbm", "two.svg", "--page", "2"],
                    out="book.pbm -> two.svg: 1 page\n")
        self.assertEqual(self.read("two.svg"), self.read("book-0002.svg"))
        self.expect(["convert", "book.pbm", "book.pdf"],
                    out="book.pbm -> book.pdf: 2 pages\n", err=None)
        self.assertEqual(self.read("book.pdf")[:5], b"%PDF-")

    def test_pipes(self):
        result = self.run_cli("convert", "-", "-", "--to", "svg",
                              stdin=self.ink)
        self.assertEqual(result.code, 0)
        self.assertEqual(result.err, "standard input -> standard output: "
                         "1 page\n")
        self.expect(["convert", "a.pbm", "a.svg", "-q"])
        self.assertEqual(result.out_bytes, self.read("a.svg"))

    def test_wrong_use(self):
        for args, reason in [
                (["a.pbm", "-"], "standard output needs --to FORMAT"),
                (["a.pbm", "a.ustp"], ".ustp files are made by compress"),
                (["a.pbm", "a.xyz"], "a.xyz: the name's ending is not png, "
                 "pbm, tif, svg, dxf, pdf, hpgl, json, fc or ngc; say --to "
                 "FORMAT")]:
            self.expect_error(["convert", *args], 2, f"unstep: {reason} "
                              "(see unstep convert --help)\n")

    def test_an_existing_output_stays(self):
        self.write("a.svg", b"mine")
        self.expect_error(["convert", "a.pbm", "a.svg"], 4,
                          "unstep: a.svg: exists; --force overwrites it\n")
        self.assertEqual(self.read("a.svg"), b"mine")
        self.expect(["convert", "a.pbm", "a.svg", "--force", "-q"])
        self.assertNotEqual(self.read("a.svg"), b"mine")

    def test_bad_input_leaves_nothing(self):
        self.write("bad.svg", SVG[:90])
        before = self.names()
        result = self.run_cli("convert", "bad.svg", "bad.dxf")
        self.assertEqual((result.code, result.out), (3, ""))
        self.assertTrue(result.err.startswith("unstep: bad.svg: "))
        self.assertEqual(self.names(), before)

    def test_a_box_of_ink_is_cut_out(self):
        self.compress("a.pbm", "--bands", "4")
        self.expect(["decompress", "a.ustp", "--box", "8,10,16,20", "-o",
                     "cut.pbm", "-q"])
        whole = self.ink.split(b"\n", 2)[2]
        rows = [whole[8 * y + 1:8 * y + 3] for y in range(10, 30)]
        self.assertEqual(self.read("cut.pbm"), b"P4\n16 20\n" + b"".join(rows))

    def test_a_box_needs_four_numbers(self):
        for word in ["1,2,3", "1,2,3,0", "1,2,3,4,5", "a,b,c,d", ""]:
            result = self.run_cli("decompress", "a.ustp", "--box", word)
            self.assertEqual((result.code, result.out), (2, ""), word)

    def test_chains_as_pixels(self):
        self.expect(["convert", "chains.fc", "chains.pbm", "-q"])
        self.assertEqual(self.read("chains.pbm")[:9], b"P4\n20 20\n")
        self.assertTrue(os.path.getsize(self.path("chains.pbm")) > 9)


if __name__ == "__main__":
    harness.main()
