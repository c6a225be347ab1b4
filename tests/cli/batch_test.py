"""unstep batch."""

import json
import os

import harness
from harness import grouped, pbm, pixels


class Batch(harness.CliTest):
    def setUp(self):
        super().setUp()
        for number, name in enumerate(["a.pbm", "deep/b.pbm", "deep/er/c.pbm"]):
            self.write("in/" + name, pbm(pixels(40, 30, number)))
        self.write("in/deep/copy.pnm", self.read("in/a.pbm"))
        self.write("in/notes.txt", b"not a drawing")
        self.all = ["a.pbm.ustp", "deep/b.pbm.ustp", "deep/copy.pnm.ustp",
                    "deep/er/c.pbm.ustp"]

    def sums(self, inputs, outputs):
        total_in = sum(os.path.getsize(self.path(name)) for name in inputs)
        total_out = sum(os.path.getsize(self.path(name)) for name in outputs)
        return (f"; {grouped(total_in)} bytes -> {grouped(total_out)} bytes "
                f"({100 * total_out / total_in:.1f} %)\n")

    def report(self):
        return json.loads(self.read("log.json"))

    def statuses(self):
        return [(file["input"], file["status"])
                for file in self.report()["files"]]

    def test_keeps_the_tree(self):
        result = self.run_cli("batch", "in", "-o", "out")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertEqual(self.names("out"), self.all)
        inputs = ["in/" + name[:-5] for name in self.all]
        self.assertEqual(result.out, "4 files: 4 compressed" + self.sums(
            inputs, ["out/" + name for name in self.all]) +
            "1 file of other kinds passed over\n")

    def test_way_back(self):
        self.expect(["batch", "in", "-o", "out", "-q"], out="")
        result = self.run_cli("batch", "--decompress", "out", "-o", "back")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertEqual(self.names("back"),
                         ["a.pbm", "deep/b.pbm", "deep/copy.pnm.png",
                          "deep/er/c.pbm"])
        for name in ["a.pbm", "deep/b.pbm", "deep/er/c.pbm"]:
            self.assertEqual(self.read("back/" + name), self.read("in/" + name))
        self.assertTrue(result.out.startswith("4 files: 4 decompressed; "))

    def test_way_back_by_name(self):
        book = pbm(pixels(9, 9)) + pbm(pixels(8, 8))
        self.write("some/one.jpg", pbm(pixels(9, 9)))
        self.write("some/book.pbm", book)
        self.write("some/book.png", book)
        self.write("some/page.TIFF", pbm(pixels(9, 9)))
        self.expect(["batch", "some", "-o", "out", "-q"])
        self.expect(["compress", "some/book.pbm", "-o", "out/plain.ustp", "-q"])
        self.expect(["batch", "-d", "out", "-o", "back", "-q"])
        self.assertEqual(self.names("back"), [
            "book.pbm", "book.png.tif", "one.jpg.png", "page.TIFF",
            "plain.tif"])
        self.assertEqual(self.read("back/book.pbm"), book)
        self.expect(["batch", "-d", "out", "-o", "png", "--to", "png", "-q"])
        self.assertEqual(self.names("png"), [
            "book-0001.png", "book-0002.png", "book.pbm-0001.png",
            "book.pbm-0002.png", "one.jpg.png", "page.TIFF.png",
            "plain-0001.png", "plain-0002.png"])

    def test_same_stem_in_one_folder(self):
        self.write("two/a.tif", pbm(pixels(8, 8)))
        self.write("two/a.png", pbm(pixels(8, 8)))
        self.expect(["batch", "two", "-o", "out", "-q"])
        self.assertEqual(self.names("out"), ["a.png.ustp", "a.tif.ustp"])

    def test_files_globs_and_lists(self):
        self.expect(["batch", "in/a.pbm", "in/deep/b.pbm", "-o", "1", "-q"])
        self.assertEqual(self.names("1"), ["a.pbm.ustp", "b.pbm.ustp"])
        self.expect(["batch", "in/*/*.pbm", "-o", "2", "-q"])
        self.assertEqual(self.names("2"), ["deep/b.pbm.ustp"])
        self.expect(["batch", "in/dee?", "-o", "3", "-q"])
        self.assertEqual(self.names("3"), ["deep/b.pbm.ustp",
                                           "deep/copy.pnm.ustp",
                                           "deep/er/c.pbm.ustp"])
        self.write("list", b"in/a.pbm\r\n\n./in/deep/../deep/b.pbm\nin/deep/er")
        self.expect(["batch", "@list", "-o", "4", "-q"])
        self.expect(["batch", "--list", "list", "-o", "5", "-q"])
        self.expect(["batch", "--list", "-", "-o", "6", "-q"],
                    stdin=b"in/a.pbm\0in/deep/b.pbm\0in/deep/er\0")
        for folder in ["4", "5", "6"]:
            self.assertEqual(self.names(folder),
                             ["in/a.pbm.ustp", "in/deep/b.pbm.ustp",
                              "in/deep/er/c.pbm.ustp"])
        absolute = self.path("in/a.pbm")
        self.expect(["batch", "--list", "-", "-o", "7", "-q"],
                    stdin=absolute.encode() + b"\n../" +
                    os.path.basename(self.folder).encode() + b"/in/deep/b.pbm")
        self.assertEqual(len(self.names("7")), 2)
        self.assertIn(absolute[1:] + ".ustp", self.names("7"))

    def test_name_with_wildcards_is_taken_as_it_is(self):
        self.write("[ab]*.pbm", pbm(pixels(8, 8)))
        self.expect(["batch", "[ab]*.pbm", "-o", "out", "-q"])
        self.assertEqual(self.names("out"), ["[ab]*.pbm.ustp"])

    def test_one_file_named_twice_is_taken_once(self):
        self.expect(["batch", "in/a.pbm", "./in/a.pbm", "-o", "out", "-q"])
        self.assertEqual(self.names("out"), ["a.pbm.ustp"])

    def test_two_files_for_one_name(self):
        self.write("other/a.pbm", pbm(pixels(8, 8)))
        self.expect_error(
            ["batch", "in/a.pbm", "other/a.pbm", "-o", "out"], 2,
            "unstep: in/a.pbm and other/a.pbm would become the same file; "
            "name a folder that holds both, or a list "
            "(see unstep batch --help)\n")
        self.assertFalse(os.path.exists(self.path("out")))

    def test_nothing_to_do_is_wrong_usage(self):
        os.mkdir(self.path("empty"))
        help_line = "(see unstep batch --help)\n"
        self.expect_error(["batch", "empty", "-o", "out"], 2,
                          "unstep: there is no drawing in the inputs " +
                          help_line)
        self.expect_error(["batch", "-d", "in", "-o", "out"], 2,
                          "unstep: there is no .ustp file in the inputs " +
                          help_line)
        self.expect_error(["batch", "-o", "out"], 2,
                          "unstep: no input is given " + help_line)
        self.expect_error(["batch", "in"], 2,
                          "unstep: --output is required " + help_line)
        self.expect_error(["batch", "in", "-o", "out", "--to", "png"], 2,
                          "unstep: --to goes with --decompress " + help_line)

    def test_bad_file_in_the_middle(self):
        self.write("in/deep/bad.png", b"\x89PNG\r\n\x1a\nnot really")
        result = self.run_cli("batch", "in", "-o", "out", "none.pbm", "x*.pbm",
                              "--report", "log.json")
        self.assertEqual(result.code, 1)
        lines = result.err.split("\n")
        self.assertEqual(lines[0], "unstep: none.pbm: "
                         "No such file or directory")
        self.assertEqual(lines[1], "unstep: x*.pbm: matches no file")
        self.assertTrue(lines[2].startswith("unstep: in/deep/bad.png: "))
        self.assertEqual(lines[3:], [""])
        self.assertTrue(result.out.startswith(
            "7 files: 4 compressed, 3 failed; "))
        self.assertEqual(self.names("out"), self.all)
        self.assertEqual(self.statuses(), [
            ("none.pbm", "failed"), ("x*.pbm", "failed"),
            ("in/a.pbm", "done"), ("in/deep/b.pbm", "done"),
            ("in/deep/bad.png", "failed"), ("in/deep/copy.pnm", "done"),
            ("in/deep/er/c.pbm", "done")])
        self.assertEqual(self.report()["files"][0]["error"],
                         {"code": "io_error",
                          "message": "No such file or directory"})

    def test_report(self):
        result = self.run_cli("batch", "in", "-o", "out", "--report",
                              "log.json", "-q")
        self.assertEqual((result.code, result.out, result.err), (0, "", ""))
        report = self.report()
        self.assertEqual(report["totals"], {
            "files": 4, "done": 4, "skipped": 0, "failed": 0, "not_run": 0,
            "passed_over": 1,
            "input_bytes": sum(os.path.getsize(self.path("in/" + name[:-5]))
                               for name in self.all),
            "output_bytes": sum(os.path.getsize(self.path("out/" + name))
                                for name in self.all),
            "pixels": 4800})
        self.assertEqual(report["files"][0], {
            "input": "in/a.pbm", "outputs": ["out/a.pbm.ustp"],
            "status": "done",
            "input_bytes": os.path.getsize(self.path("in/a.pbm")),
            "output_bytes": os.path.getsize(self.path("out/a.pbm.ustp")),
            "pages": 1, "pixels": 1200, "lossless": True,
            "pixel_work": [], "notes": []})
        self.expect_error(
            ["batch", "in", "-o", "out", "--report", "log.json"], 4,
            "unstep: log.json: exists; --force overwrites it\n")

    def test_report_to_stdout_is_json_alone(self):
        result = self.expect(["batch", "in", "-o", "out", "--report", "-"])
        self.assertEqual(json.loads(result.out)["totals"]["done"], 4)

    def test_existing_output_is_refused(self):
        self.write("out/a.pbm.ustp", b"precious")
        self.expect(
            ["batch", "in/a.pbm", "-o", "out"], code=1,
            out="1 file: 0 compressed, 1 failed\n",
            err="unstep: out/a.pbm.ustp: exists; --force overwrites it, "
            "--resume skips it if it is finished\n")
        self.assertEqual(self.read("out/a.pbm.ustp"), b"precious")
        self.expect(["batch", "in/a.pbm", "-o", "out", "-q", "--force"])
        self.assertNotEqual(self.read("out/a.pbm.ustp"), b"precious")

    def test_jobs_do_not_change_the_bytes(self):
        for jobs in ["1", "2", "5"]:
            self.expect(["batch", "in", "-o", jobs, "-q", "--jobs", jobs])
        for name in self.all:
            self.assertEqual(self.read("1/" + name), self.read("2/" + name))
            self.assertEqual(self.read("1/" + name), self.read("5/" + name))

    def test_record_can_be_left_out(self):
        self.expect(["batch", "in/a.pbm", "-o", "out", "-q", "--no-record"])
        self.compress("in/a.pbm", "-o", "plain")
        self.assertEqual(self.read("out/a.pbm.ustp"), self.read("plain"))

    def test_symlink_loop_ends(self):
        os.symlink("..", self.path("in/deep/loop"))
        os.symlink(".", self.path("in/self"))
        os.symlink("nowhere", self.path("in/dangling.pbm"))
        result = self.run_cli("batch", "in", "-o", "out", "-q")
        self.assertEqual(result.err, "unstep: in/dangling.pbm: "
                         "No such file or directory\n")
        self.assertEqual(result.code, 1)
        self.assertEqual(self.names("out"), self.all)

    def test_links_to_files_and_folders_are_followed(self):
        os.symlink("a.pbm", self.path("in/link.pbm"))
        self.write("elsewhere/d.pbm", pbm(pixels(8, 8)))
        os.symlink("../elsewhere", self.path("in/folder"))
        self.expect(["batch", "in", "-o", "out", "-q"])
        self.assertIn("link.pbm.ustp", self.names("out"))
        self.assertIn("folder/d.pbm.ustp", self.names("out"))

    def test_output_folder_inside_the_input_is_not_searched(self):
        self.expect(["batch", "in", "-o", "in/packed", "-q"])
        self.expect(["batch", "-d", "in", "-o", "in/packed", "-q"], code=2,
                    err="unstep: there is no .ustp file in the inputs "
                    "(see unstep batch --help)\n")

    def test_pipes_in_folders_are_passed_over(self):
        os.mkfifo(self.path("in/pipe.pbm"))
        self.expect(["batch", "in", "-o", "out", "-q"])
        self.assertEqual(self.names("out"), self.all)

    def test_output_folder_that_is_a_file(self):
        self.write("out", b"")
        self.expect_error(["batch", "in", "-o", "out"], 4,
                          "unstep: out: is not a folder\n")

    def test_limits_fail_one_file(self):
        self.write("in/big.pbm", pbm(pixels(50, 50)))
        result = self.run_cli("batch", "in", "-o", "out", "--max-pixels",
                              "2K", "-q")
        self.assertEqual(result.code, 1)
        self.assertRegex(result.err, r"^unstep: in/big\.pbm: .+\n$")
        self.assertEqual(self.names("out"), self.all)


class Resume(harness.CliTest):
    def setUp(self):
        super().setUp()
        for number in range(3):
            self.write(f"in/{number}.pbm", pbm(pixels(40, 30, number)))
        self.expect(["batch", "in", "-o", "out", "-q"])

    def resume(self, *args, code=0):
        result = self.run_cli("batch", *args, "--resume", "--report",
                              "log.json")
        self.assertEqual(result.code, code, result.err)
        return [file["status"]
                for file in json.loads(self.read("log.json"))["files"]]

    def times(self, folder):
        return [os.stat(self.path(f"{folder}/{name}")).st_mtime_ns
                for name in self.names(folder)]

    def test_finished_files_are_skipped(self):
        before = self.times("out")
        self.assertEqual(self.resume("in", "-o", "out"), ["skipped"] * 3)
        self.assertEqual(self.times("out"), before)
        self.expect(["batch", "in", "-o", "out", "--resume"],
                    out="3 files: 0 compressed, 3 finished before\n")

    def test_missing_file_is_made(self):
        os.remove(self.path("out/1.pbm.ustp"))
        self.assertEqual(self.resume("in", "-o", "out"),
                         ["skipped", "done", "skipped"])

    def test_changed_source_is_renewed(self):
        self.write("in/1.pbm", pbm(pixels(40, 30, 99)))
        self.assertEqual(self.resume("in", "-o", "out"),
                         ["skipped", "done", "skipped"])
        self.expect(["verify", "in/1.pbm", "out/1.pbm.ustp", "-q"])

    def test_damaged_output_is_renewed(self):
        whole = self.read("out/1.pbm.ustp")
        for damaged in [whole[:-1], whole[:20],
                        whole[:-9] + bytes([whole[-9] ^ 1]) + whole[-8:]]:
            self.write("out/1.pbm.ustp", damaged)
            self.assertEqual(self.resume("in", "-o", "out"),
                             ["skipped", "done", "skipped"])
            self.assertEqual(self.read("out/1.pbm.ustp"), whole)

    def test_foreign_output_is_kept(self):
        self.write("out/1.pbm.ustp", b"precious notes")
        self.assertEqual(self.resume("in", "-o", "out", code=1),
                         ["skipped", "failed", "skipped"])
        self.assertEqual(self.read("out/1.pbm.ustp"), b"precious notes")

    def test_way_back(self):
        self.expect(["batch", "-d", "out", "-o", "back", "-q"])
        os.remove(self.path("back/0.pbm"))
        whole = self.read("back/1.pbm")
        self.write("back/1.pbm", whole[:-1])
        self.write("back/2.pbm", pbm(pixels(8, 8)))
        self.assertEqual(self.resume("-d", "out", "-o", "back", code=1),
                         ["done", "done", "failed"])
        self.assertEqual(self.read("back/1.pbm"), whole)
        self.write("back/2.pbm", self.read("in/2.pbm"))
        self.assertEqual(self.resume("-d", "out", "-o", "back"),
                         ["skipped"] * 3)


if __name__ == "__main__":
    harness.main()
