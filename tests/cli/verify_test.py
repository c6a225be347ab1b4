"""unstep verify."""

import harness
from harness import pbm, pixels


class Integrity(harness.CliTest):
    def setUp(self):
        super().setUp()
        self.write("a.pbm", pbm(pixels(40, 30)))
        self.write("b.pbm", pbm(pixels(9, 9)) * 2)
        self.compress("a.pbm")
        self.compress("b.pbm")

    def damage(self, name):
        data = bytearray(self.read(name))
        data[len(data) // 2] ^= 0x10
        self.write(name, bytes(data))

    def test_good_files(self):
        self.expect(["verify", "a.ustp"], out="a.ustp: good, 1 page\n")
        self.expect(["verify", "a.ustp", "b.ustp"],
                    out="a.ustp: good, 1 page\nb.ustp: good, 2 pages\n")
        self.expect(["verify", "-q", "a.ustp", "b.ustp"], out="")

    def test_standard_input(self):
        self.expect(["verify", "-"], stdin=self.read("a.ustp"),
                    out="standard input: good, 1 page\n")

    def test_one_damaged_file(self):
        self.damage("a.ustp")
        result = self.run_cli("verify", "a.ustp")
        self.assertEqual((result.code, result.out), (3, ""))
        self.assertRegex(result.err, r"^unstep: a\.ustp: .+\n$")

    def test_goes_on_after_a_damaged_file(self):
        self.damage("a.ustp")
        result = self.run_cli("verify", "a.ustp", "none.ustp", "b.ustp")
        self.assertEqual(result.code, 1)
        self.assertEqual(result.out, "b.ustp: good, 2 pages\n")
        self.assertEqual(result.err.count("\n"), 2)
        self.assertIn("unstep: none.ustp: cannot open: No such file or "
                      "directory\n", result.err)

    def test_every_flipped_byte_is_found(self):
        whole = self.read("b.ustp")
        for at in range(len(whole)):
            data = bytearray(whole)
            data[at] ^= 0x20
            self.write("bad.ustp", bytes(data))
            result = self.run_cli("verify", "bad.ustp")
            self.assertEqual((result.code, result.out), (3, ""), at)
            self.assertEqual(result.err.count("\n"), 1)

    def test_not_a_ustp_file(self):
        result = self.run_cli("verify", "a.pbm")
        self.assertEqual((result.code, result.out), (3, ""))


class Compare(harness.CliTest):
    def setUp(self):
        super().setUp()
        self.rows = pixels(40, 30)
        self.write("a.pbm", pbm(self.rows))
        self.compress("a.pbm")

    def changed(self, x, y):
        rows = [list(row) for row in self.rows]
        rows[y][x] = "." if rows[y][x] == "#" else "#"
        return ["".join(row) for row in rows]

    def differ(self, a, b, reason):
        self.expect(["verify", a, b], code=1,
                    out=f"{a} and {b} differ: {reason}\n")

    def test_same(self):
        self.expect(["verify", "a.pbm", "a.ustp"],
                    out="a.pbm and a.ustp are the same: 1 page\n")
        self.expect(["verify", "-q", "a.pbm", "a.ustp"], out="")

    def test_what_decompress_wrote_is_the_same(self):
        for name in ["a.png", "a.tif"]:
            self.expect(["decompress", "a.ustp", "-o", name, "-q"])
            self.expect(["verify", name, "a.ustp"],
                        out=f"{name} and a.ustp are the same: 1 page\n")

    def test_first_pixel_is_named(self):
        self.write("b.pbm", pbm(self.changed(37, 17)))
        ink = self.rows[17][37] == "#"
        one, two = ("paper", "ink") if ink else ("ink", "paper")
        self.differ("b.pbm", "a.ustp",
                    f"pixel (37, 17) is {one} in the first and {two} in the "
                    "second; 1 pixel differs")

    def test_sizes(self):
        self.write("b.pbm", pbm(self.rows[:29]))
        self.differ("b.pbm", "a.ustp", "40 x 29 px in the first and 40 x 30 "
                    "px in the second")

    def test_pages(self):
        self.write("b.pbm", pbm(self.rows) * 2)
        self.differ("b.pbm", "a.ustp",
                    "2 pages in the first and 1 in the second")

    def test_page_is_named(self):
        self.write("b.pbm", pbm(self.rows) * 2)
        self.compress("b.pbm")
        self.write("b.pbm", pbm(self.rows) + pbm(self.rows[1:]))
        self.differ("b.pbm", "b.ustp", "page 2: 40 x 29 px in the first and "
                    "40 x 30 px in the second")

    def test_standard_input(self):
        self.expect(["verify", "-", "a.ustp"], stdin=self.read("a.pbm"),
                    out="standard input and a.ustp are the same: 1 page\n")

    def test_two_ustp_files(self):
        self.write("b.pbm", pbm(self.changed(0, 0)))
        self.compress("b.pbm")
        self.expect(["verify", "a.ustp", "b.ustp"],
                    out="a.ustp: good, 1 page\nb.ustp: good, 1 page\n")
        self.expect(["verify", "--compare", "a.ustp", "a.ustp"],
                    out="a.ustp and a.ustp are the same: 1 page\n")
        self.assertEqual(
            self.run_cli("verify", "--compare", "a.ustp", "b.ustp").code, 1)
        self.expect_error(["verify", "--compare", "a.ustp"], 2,
                          "unstep: --compare takes two drawings "
                          "(see unstep verify --help)\n")

    def test_missing_file(self):
        self.expect_error(
            ["verify", "none.pbm", "a.ustp"], 4,
            "unstep: none.pbm: cannot open: No such file or directory\n")
        self.expect_error(
            ["verify", "a.pbm", "none.ustp"], 4,
            "unstep: none.ustp: cannot open: No such file or directory\n")

    def test_damaged_second_file(self):
        data = bytearray(self.read("a.ustp"))
        data[-1] ^= 1
        self.write("a.ustp", bytes(data))
        result = self.run_cli("verify", "a.pbm", "a.ustp")
        self.assertEqual((result.code, result.out), (3, ""))
        self.assertRegex(result.err, r"^unstep: a\.ustp: .+\n$")


if __name__ == "__main__":
    harness.main()
