"""unstep decompress."""

import os

import harness
from harness import pbm, pixels


class Decompress(harness.CliTest):
    def setUp(self):
        super().setUp()
        self.pages = [pbm(pixels(40, 30, seed)) for seed in range(3)]
        self.write("page.pbm", self.pages[0])
        self.write("book.pbm", b"".join(self.pages))
        for name in ["page.pbm", "book.pbm"]:
            self.compress(name)
            os.remove(self.path(name))

    def to_pbm(self, name):
        """The pixels of a raster file, through the program itself."""
        packed = self.run_cli("compress", name, "-o", "-", "-q").out_bytes
        return self.run_cli("decompress", "-", "-o", "-", "--to", "pbm", "-q",
                            stdin=packed).out_bytes

    def test_one_page_becomes_png(self):
        self.expect(["decompress", "page.ustp"],
                    out="page.ustp -> page.png: 1 page\n")
        self.assertEqual(self.read("page.png")[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(self.to_pbm("page.png"), self.pages[0])

    def test_several_pages_become_tiff(self):
        self.expect(["decompress", "book.ustp"],
                    out="book.ustp -> book.tif: 3 pages\n")
        self.assertIn(self.read("book.tif")[:4], (b"II*\0", b"MM\0*"))
        self.assertEqual(self.to_pbm("book.tif"), b"".join(self.pages))

    def test_format_by_output_name(self):
        for name in ["a.pbm", "a.png", "a.PNG", "a.tif", "a.tiff"]:
            self.expect(["decompress", "page.ustp", "-o", name, "-q"], out="")
            self.assertEqual(self.to_pbm(name), self.pages[0])
        self.assertEqual(self.read("a.pbm"), self.pages[0])
        self.assertEqual(self.read("a.png"), self.read("a.PNG"))

    def test_to_overrules_the_name(self):
        self.expect(["decompress", "page.ustp", "-o", "a.png", "--to", "pbm"],
                    out="page.ustp -> a.png: 1 page\n")
        self.assertEqual(self.read("a.png"), self.pages[0])

    def test_name_without_format(self):
        self.expect_error(
            ["decompress", "page.ustp", "-o", "a.jpg"], 2,
            "unstep: a.jpg: the name's ending is not png, pbm, tif, svg, dxf, "
            "pdf, hpgl, json, fc or ngc; say --to FORMAT (see unstep decompress "
            "--help)\n")

    def test_pages_to_png_are_numbered(self):
        for word in ["png", "pbm"]:
            self.expect(["decompress", "book.ustp", "--to", word],
                        out=f"book.ustp -> book-0001.{word} ... "
                        f"book-0003.{word}: 3 pages\n")
            for number in range(3):
                self.assertEqual(self.to_pbm(f"book-000{number + 1}.{word}"),
                                 self.pages[number])

    def test_numbers_come_before_the_ending(self):
        self.expect(["decompress", "book.ustp", "-o", "x.y/p.q.png"], code=4,
                    out="", err="unstep: x.y/p.q-0001.png: cannot create: "
                    "No such file or directory\n")
        os.mkdir(self.path("x.y"))
        self.expect(["decompress", "book.ustp", "-o", "x.y/p.q.png", "-q"])
        self.assertEqual(self.names("x.y"), ["p.q-0001.png", "p.q-0002.png",
                                             "p.q-0003.png"])

    def test_one_page_of_several(self):
        self.expect(["decompress", "book.ustp", "--page", "2"],
                    out="book.ustp -> book-0002.png: 1 page\n")
        self.assertEqual(self.to_pbm("book-0002.png"), self.pages[1])
        self.expect(["decompress", "book.ustp", "--page", "3", "-o", "c.pbm"],
                    out="book.ustp -> c.pbm: 1 page\n")
        self.assertEqual(self.read("c.pbm"), self.pages[2])

    def test_no_such_page(self):
        self.expect_error(["decompress", "book.ustp", "--page", "4"], 2,
                          "unstep: book.ustp: has 3 pages, no page 4\n")

    def test_stdout_needs_a_format(self):
        self.expect_error(["decompress", "page.ustp", "-o", "-"], 2,
                          "unstep: standard output needs --to FORMAT "
                          "(see unstep decompress --help)\n")

    def test_stdin_needs_an_output(self):
        self.expect_error(["decompress", "-"], 2,
                          "unstep: standard input needs -o OUT "
                          "(see unstep decompress --help)\n")

    def test_pipe(self):
        result = self.run_cli("decompress", "-", "-o", "-", "--to", "pbm",
                              stdin=self.read("page.ustp"))
        self.assertEqual(result.code, 0)
        self.assertEqual(result.out_bytes, self.pages[0])
        self.assertEqual(result.err,
                         "standard input -> standard output: 1 page\n")

    def test_pages_to_stdout(self):
        result = self.run_cli("decompress", "book.ustp", "-o", "-", "--to",
                              "pbm", "-q")
        self.assertEqual(result.out_bytes, b"".join(self.pages))
        self.expect_error(
            ["decompress", "book.ustp", "-o", "-", "--to", "png"], 2,
            "unstep: book.ustp: has 3 pages, and standard output takes one "
            "png file; choose --page N, or --to tif\n")

    def test_ink_becomes_its_contours_in_chain_text(self):
        self.expect(["decompress", "page.ustp", "--to", "fc"],
                    out="page.ustp -> page.fc: 1 page\n")
        self.expect(["convert", "page.fc", "again.pbm", "-q"])
        self.assertEqual(self.read("again.pbm"), self.pages[0])

    def test_existing_output_is_refused_before_anything_is_written(self):
        self.write("book-0002.png", b"precious")
        self.expect_error(
            ["decompress", "book.ustp", "--to", "png"], 4,
            "unstep: book-0002.png: exists; --force overwrites it\n")
        self.assertNotIn("book-0001.png", self.names())
        self.assertEqual(self.read("book-0002.png"), b"precious")
        self.expect(["decompress", "book.ustp", "--to", "png", "-f", "-q"])
        self.assertEqual(self.to_pbm("book-0002.png"), self.pages[1])

    def test_missing_file(self):
        self.expect_error(
            ["decompress", "none.ustp"], 4,
            "unstep: none.ustp: cannot open: No such file or directory\n")

    def test_not_a_ustp_file(self):
        self.write("a.ustp", self.pages[0])
        result = self.run_cli("decompress", "a.ustp")
        self.assertEqual((result.code, result.out), (3, ""))
        self.assertRegex(result.err, r"^unstep: a\.ustp: .*not a \.ustp file\n$")

    def test_truncated_at_every_byte(self):
        self.check_truncated(self.read("page.ustp"))

    def test_damaged_page_does_not_cost_the_others(self):
        self.write("book.pbm", self.pages[0] + pbm(pixels(50, 50)) +
                   self.pages[2])
        self.compress("book.pbm", "-f")
        result = self.run_cli("decompress", "book.ustp", "--to", "pbm",
                              "--max-pixels", "2K")
        self.assertEqual((result.code, result.out), (3, ""))
        self.assertRegex(result.err, r"^unstep: book\.ustp: page 2: .+\n$")
        self.assertEqual(self.read("book-0001.pbm"), self.pages[0])
        self.assertEqual(self.read("book-0003.pbm"), self.pages[2])
        self.assertNotIn("book-0002.pbm", self.names())

    def test_limits(self):
        for option in [["--max-pixels", "1K"], ["--max-memory", "16"]]:
            result = self.run_cli("decompress", "page.ustp", *option)
            self.assertEqual((result.code, result.out), (3, ""), option)
            self.assertTrue(result.err.startswith("unstep: page.ustp: "))


if __name__ == "__main__":
    harness.main()
