"""unstep info."""

import json
import os
import subprocess

import harness
from harness import PROGRAM, pbm, pixels


class Info(harness.CliTest):
    def setUp(self):
        super().setUp()
        self.write("a.pbm", pbm(pixels(40, 30)))
        self.compress("a.pbm")
        self.write("b.pbm", pbm(pixels(9, 9)))
        self.compress("b.pbm")

    def info(self, *names):
        return json.loads(self.expect(["info", "--json", *names]).out)

    def test_text(self):
        size = os.path.getsize(self.path("a.ustp"))
        page = self.info("a.ustp")[0]["pages"][0]
        block = page["blocks"][0]
        self.expect(
            ["info", "a.ustp"],
            out="a.ustp\n"
            "  format: 0, pre-release, short form\n"
            f"  size: {size} bytes, {8 * size / 1200:.4f} bits per pixel\n"
            "  pages: 1\n"
            "  page 1: ink, 40 x 30 px\n"
            f"    checksum: {page['checksum']}\n"
            f"    block 1: rows 0 to 29, {block['bytes']} bytes, "
            f"{block['coder_name']} revision {block['revision']} "
            f"table {block['table']}\n")

    def test_json(self):
        info = self.info("a.ustp")[0]
        self.assertEqual(info["file"], "a.ustp")
        self.assertEqual((info["version"], info["prerelease"]), (0, True))
        self.assertEqual(info["form"], "short")
        self.assertEqual(info["bytes"], os.path.getsize(self.path("a.ustp")))
        self.assertEqual(info["pixels"], 1200)
        page = info["pages"][0]
        self.assertEqual((page["kind"], page["width"], page["height"]),
                         ("ink", 40, 30))
        self.assertIsNone(page["resolution"])
        self.assertRegex(page["checksum"], "^[0-9a-f]{8}$")

    def test_metadata(self):
        self.compress("a.pbm", "--meta", "title=\u00e9\n2", "-f")
        out = self.expect(["info", "a.ustp"]).out
        self.assertIn("  metadata: title = \u00e9\\x0a2\n", out)
        self.assertEqual(self.info("a.ustp")[0]["metadata"],
                         {"title": "\u00e9\n2"})

    def test_checksum_is_of_the_pixels(self):
        first = self.info("a.ustp")[0]["pages"][0]["checksum"]
        self.compress("a.pbm", "--bands", "3", "-f")
        self.assertEqual(self.info("a.ustp")[0]["pages"][0]["checksum"], first)
        self.write("a.pbm", pbm(pixels(40, 30, 2)))
        self.compress("a.pbm", "-f")
        self.assertNotEqual(self.info("a.ustp")[0]["pages"][0]["checksum"],
                            first)

    def test_several_files_and_a_bad_one(self):
        self.write("bad.ustp", b"nothing")
        result = self.run_cli("info", "--json", "a.ustp", "bad.ustp",
                              "b.ustp")
        self.assertEqual(result.code, 1)
        self.assertEqual([file["file"] for file in json.loads(result.out)],
                         ["a.ustp", "b.ustp"])
        self.assertRegex(result.err, r"^unstep: bad\.ustp: .+\n$")
        self.assertEqual(self.run_cli("info", "bad.ustp").code, 3)

    def test_standard_input(self):
        out = self.expect(["info", "-"], stdin=self.read("a.ustp")).out
        self.assertTrue(out.startswith("standard input\n  format: 0"))

    def test_full_disk_is_not_success(self):
        with open("/dev/full", "wb") as full:
            process = subprocess.run([PROGRAM, "info", "a.ustp"],
                                     cwd=self.folder, stdout=full,
                                     stderr=subprocess.PIPE, check=False)
        self.assertEqual(process.returncode, 4)
        self.assertEqual(process.stderr, b"unstep: standard output: cannot "
                         b"write: No space left on device\n")

    def test_missing_file(self):
        self.expect_error(
            ["info", "none.ustp"], 4,
            "unstep: none.ustp: cannot open: No such file or directory\n")


if __name__ == "__main__":
    harness.main()
