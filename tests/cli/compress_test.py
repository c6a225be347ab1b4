"""unstep compress."""

import json
import os
import pathlib
import stat

import harness
from harness import grouped, noise, pbm, pixels

SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"


class Compress(harness.CliTest):
    def setUp(self):
        super().setUp()
        self.image = pbm(pixels(40, 30))
        self.write("page.pbm", self.image)

    def report(self, name, verified="verified"):
        share = 100 * os.path.getsize(self.path(name)) / (5 * 30)
        return (f"1 page, 40 x 30 px, {self.size(name)} bytes, {share:.1f} % "
                f"of 150 packed, {verified}\n")

    def test_writes_beside_the_input(self):
        self.write("in/scan.one.pbm", self.image)
        result = self.run_cli("compress", "in/scan.one.pbm")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertEqual(result.out, "in/scan.one.pbm -> in/scan.one.ustp: " +
                         self.report("in/scan.one.ustp"))
        self.assertEqual(self.names("in"), ["scan.one.pbm", "scan.one.ustp"])

    def test_no_verify_says_so(self):
        result = self.run_cli("compress", "page.pbm", "--no-verify")
        self.assertEqual(result.out, "page.pbm -> page.ustp: " +
                         self.report("page.ustp", "not verified"))

    def test_quiet_says_nothing(self):
        self.expect(["compress", "page.pbm", "-q"], out="")

    def test_output_has_usual_permissions(self):
        self.compress("page.pbm")
        mask = os.umask(0)
        os.umask(mask)
        mode = stat.S_IMODE(os.stat(self.path("page.ustp")).st_mode)
        self.assertEqual(mode, 0o666 & ~mask)

    def test_existing_output_is_refused(self):
        self.write("page.ustp", b"precious")
        self.expect_error(["compress", "page.pbm"], 4,
                          "unstep: page.ustp: exists; --force overwrites it\n")
        self.assertEqual(self.read("page.ustp"), b"precious")
        self.expect(["compress", "page.pbm", "--force"])
        self.assertNotEqual(self.read("page.ustp"), b"precious")

    def test_output_that_is_the_input(self):
        self.expect_error(
            ["compress", "page.pbm", "-o", "./page.pbm", "--force"], 2,
            "unstep: ./page.pbm: is the input itself\n")
        self.assertEqual(self.read("page.pbm"), self.image)

    def test_stdin_to_stdout(self):
        self.compress("page.pbm")
        result = self.run_cli("compress", "-", "-o", "-", stdin=self.image)
        self.assertEqual(result.code, 0)
        self.assertEqual(result.out_bytes, self.read("page.ustp"))
        self.assertEqual(result.err, "standard input -> standard output: " +
                         self.report("page.ustp"))

    def test_stdin_needs_an_output(self):
        self.expect_error(["compress", "-"], 2,
                          "unstep: standard input needs -o OUT "
                          "(see unstep compress --help)\n")

    def test_bytes_do_not_depend_on_jobs(self):
        self.write("noise.pbm", noise(500, 400))
        for jobs in ["1", "2", "7"]:
            self.compress("noise.pbm", "--bands", "4", "--jobs", jobs,
                          "-o", jobs)
        self.assertEqual(self.read("1"), self.read("2"))
        self.assertEqual(self.read("1"), self.read("7"))

    def test_thin_lines_are_followed_where_that_is_smaller(self):
        coast = str(SAMPLES / "coast.png")
        self.run_cli("compress", coast, "-o", "coast.ustp", "--no-verify")
        about = self.run_cli("info", "coast.ustp").out
        self.assertIn("coder 3 revision 0 table 1", about)
        same = self.run_cli("verify", coast, "coast.ustp")
        self.assertEqual((same.code, same.err), (0, ""))
        half = self.run_cli("decompress", "coast.ustp", "--box",
                            "100,200,300,150", "-o", "part.pbm")
        self.assertEqual((half.code, half.err), (0, ""))

    def test_metadata_and_bands_are_stored(self):
        self.compress("page.pbm", "--meta", "title=Plan 7", "--meta", "a=b=c",
                      "--meta", "list=[1,2]", "--bands", "3")
        info = json.loads(self.expect(["info", "--json", "page.ustp"]).out)[0]
        self.assertEqual(info["metadata"],
                         {"title": "Plan 7", "a": "b=c", "list": "[1,2]"})
        self.assertEqual(len(info["pages"][0]["blocks"]), 3)

    def test_several_pages(self):
        self.write("book.pbm", self.image + pbm(pixels(9, 7)) + self.image)
        result = self.run_cli("compress", "book.pbm")
        share = 100 * os.path.getsize(self.path("book.ustp")) / (150 + 14 + 150)
        self.assertEqual(
            result.out,
            f"book.pbm -> book.ustp: 3 pages, {grouped(2 * 1200 + 63)} px, "
            f"{self.size('book.ustp')} bytes, {share:.1f} % of 314 packed, "
            "verified\n")

    def test_json_report(self):
        result = self.expect(["compress", "page.pbm", "--json"])
        self.assertEqual(json.loads(result.out), {
            "input": "page.pbm", "output": "page.ustp", "format": "pbm",
            "pages": 1, "pixels": 1200, "chains": 0, "steps": 0,
            "paths": 0, "lines": 0, "arcs": 0, "tolerance": None,
            "input_bytes": len(self.image), "packed_bytes": 150,
            "output_bytes": os.path.getsize(self.path("page.ustp")),
            "lossless": True, "pixel_work": [], "exact_from_there": True,
            "verified": True, "notes": []})

    def test_grey_needs_a_threshold(self):
        self.write("grey.pgm", b"P5\n4 1\n255\n" + bytes([0, 90, 180, 255]))
        result = self.run_cli("compress", "grey.pgm")
        self.assertEqual(result.code, 2)
        self.assertIn("--threshold", result.err)
        self.assertTrue(result.err.startswith("unstep: grey.pgm: "))
        self.assertEqual(self.names(), ["grey.pgm", "page.pbm"])
        result = self.run_cli("compress", "grey.pgm", "--threshold", "100")
        self.assertEqual(result.code, 0)
        self.assertIn("unstep: warning: grey.pgm: ", result.err)
        self.compress("grey.pgm", "--threshold", "otsu", "-o", "otsu.ustp")

    def test_pixel_limit(self):
        result = self.run_cli("compress", "page.pbm", "--max-pixels", "1K")
        self.assertEqual((result.code, result.out), (3, ""))
        self.assertTrue(result.err.startswith("unstep: page.pbm: "))
        self.assertEqual(self.names(), ["page.pbm"])

    def test_memory_limit(self):
        self.write("noise.pbm", noise(1000, 1000))
        result = self.run_cli("compress", "noise.pbm", "--max-memory", "100Ki")
        self.assertEqual((result.code, result.out), (3, ""))
        self.assertTrue(result.err.startswith("unstep: noise.pbm: "))


class CompressErrors(harness.CliTest):
    def test_missing_file(self):
        self.expect_error(
            ["compress", "none.pbm"], 4,
            "unstep: none.pbm: cannot open: No such file or directory\n")

    def test_folder(self):
        os.mkdir(self.path("folder"))
        self.expect_error(
            ["compress", "folder"], 4,
            "unstep: folder: cannot read: Is a directory\n")

    def test_output_in_no_folder(self):
        self.write("page.pbm", pbm(pixels(8, 8)))
        self.expect_error(
            ["compress", "page.pbm", "-o", "no/page.ustp"], 4,
            "unstep: no/page.ustp: cannot create: "
            "No such file or directory\n")
        self.expect_error(
            ["compress", "page.pbm", "-o", "page.pbm/page.ustp"], 4,
            "unstep: page.pbm/page.ustp: cannot create: Not a directory\n")

    def test_output_that_is_a_folder(self):
        self.write("page.pbm", pbm(pixels(8, 8)))
        os.mkdir(self.path("folder"))
        self.expect_error(
            ["compress", "page.pbm", "-o", "folder", "--force"], 4,
            "unstep: folder: is a folder\n")

    def test_output_in_a_closed_folder(self):
        if os.geteuid() == 0:
            self.skipTest("root may write anywhere")
        self.write("page.pbm", pbm(pixels(8, 8)))
        os.mkdir(self.path("closed"), 0o500)
        self.expect_error(
            ["compress", "page.pbm", "-o", "closed/page.ustp"], 4,
            "unstep: closed/page.ustp: cannot create: Permission denied\n")

    def test_device_is_not_replaced(self):
        self.write("page.pbm", pbm(pixels(8, 8)))
        self.expect(["compress", "page.pbm", "-o", "/dev/null", "-q"])
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))

    def test_full_disk(self):
        self.write("page.pbm", pbm(pixels(8, 8)))
        self.expect_error(
            ["compress", "page.pbm", "-o", "/dev/full"], 4,
            "unstep: /dev/full: cannot write: No space left on device\n")

    def test_empty_file(self):
        self.write("empty.pbm", b"")
        self.expect_error(["compress", "empty.pbm"], 3,
                          "unstep: empty.pbm: the file is empty\n")

    def test_garbage(self):
        self.write("garbage.png", bytes(range(256)) * 4)
        result = self.run_cli("compress", "garbage.png")
        self.assertEqual((result.code, result.out), (3, ""))
        self.assertTrue(result.err.startswith("unstep: garbage.png: "))
        self.assertEqual(result.err.count("\n"), 1)
        self.assertEqual(self.names(), ["garbage.png"])

    def test_text_that_is_no_chain(self):
        self.write("notes.txt", b"canvas 3 4\nDear diary\n")
        self.expect_error(
            ["compress", "notes.txt"], 3,
            "unstep: notes.txt: neither a drawing nor Freeman text: "
            "line 2, column 1: unknown keyword\n")
        self.write("bad.fc", b"open4 0 0: 0 2 1\n")
        self.expect_error(
            ["compress", "bad.fc"], 3,
            "unstep: bad.fc: line 1, column 16: odd step in a 4-connected "
            "chain\n")

    def test_ustp_is_not_compressed_again(self):
        self.write("page.pbm", pbm(pixels(8, 8)))
        self.compress("page.pbm")
        self.expect_error(
            ["compress", "page.ustp", "-o", "again.ustp"], 3,
            "unstep: page.ustp: is a .ustp file already\n")

    def test_truncated_images_leave_nothing(self):
        whole = pbm(pixels(40, 30))
        for length in [1, 2, 5, 8, 9, 60, len(whole) - 1]:
            self.write("cut.pbm", whole[:length])
            result = self.run_cli("compress", "cut.pbm")
            self.assertEqual((result.code, result.out), (3, ""), length)
            self.assertEqual(result.err.count("\n"), 1)
            self.assertEqual(self.names(), ["cut.pbm"])

    def test_name_cannot_break_the_line(self):
        self.expect_error(
            ["compress", "a\n\x1b[2Jb"], 4,
            "unstep: a\\x0a\\x1b[2Jb: cannot open: "
            "No such file or directory\n")

    def test_names_like_options_and_verbs(self):
        for name in ["info", "[a,b]", "[ab]", "a b", "\u00e9.pbm"]:
            self.write(name, pbm(pixels(8, 8)))
            self.compress(name, "-o", "out", "--force")
        self.write("-x", pbm(pixels(8, 8)))
        self.expect(["compress", "-q", "--force", "-o", "out", "--", "-x"])


if __name__ == "__main__":
    harness.main()
