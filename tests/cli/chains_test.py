"""Freeman chain text through every verb."""

import json

import harness
from harness import FREEMAN, pbm, pixels


class Chains(harness.CliTest):
    def setUp(self):
        super().setUp()
        self.write("chains.fc", FREEMAN)
        self.compress("chains.fc")

    def test_freeman_by_name_by_content_and_by_option(self):
        self.write("a.fc", FREEMAN)
        self.write("b.txt", FREEMAN)
        line = "1 page, 2 chains, 17 steps, "
        result = self.run_cli("compress", "a.fc")
        self.assertEqual(
            result.out,
            f"a.fc -> a.ustp: {line}{self.size('a.ustp')} bytes, verified\n")
        self.compress("b.txt")
        from_stdin = self.run_cli("compress", "-", "-o", "-", "-q",
                                  "--from", "freeman", stdin=FREEMAN)
        self.assertEqual(self.read("a.ustp"), self.read("b.ustp"))
        self.assertEqual(self.read("a.ustp"), from_stdin.out_bytes)

    def test_chains_become_freeman_text(self):
        self.expect(["decompress", "chains.ustp", "--force"],
                    out="chains.ustp -> chains.fc: 1 page\n")
        text = self.read("chains.fc")
        self.assertIn(b"closed4 3 4: 00664422", text)
        self.assertIn(b"open8 10 10: 012345670", text)
        self.compress("chains.fc", "-o", "again.ustp")
        self.assertEqual(self.read("again.ustp"), self.read("chains.ustp"))

    def test_empty_text_is_a_drawing_without_chains(self):
        self.write("empty.fc", b"")
        result = self.run_cli("compress", "empty.fc")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertIn(": 1 page, 0 chains, 0 steps, ", result.out)
        self.expect(["verify", "-q", "empty.fc", "empty.ustp"])

    def test_chains_are_drawn_in_a_raster(self):
        self.expect(["decompress", "chains.ustp", "--to", "pbm"],
                    out="chains.ustp -> chains.pbm: 1 page\n")
        rows = ["." * 20] * 20
        def ink(x, y):
            rows[y] = rows[y][:x] + "#" + rows[y][x + 1:]
        for x, y in [(3, 4), (4, 4), (5, 4), (5, 5), (5, 6), (4, 6), (3, 6),
                     (3, 5), (10, 10), (11, 10), (12, 9), (12, 8), (11, 7),
                     (10, 7), (9, 8), (9, 9)]:
            ink(x, y)
        self.assertEqual(self.read("chains.pbm"), pbm(rows))

    def test_closed_4_connected_chains_are_filled(self):
        self.write("square.fc", b"canvas 8 4 down\nclosed4 1 1: 00664422\n")
        self.expect(["convert", "square.fc", "square.pbm", "-q"])
        self.assertEqual(self.read("square.pbm"), pbm(
            ["........", ".##.....", ".##.....", "........"]))

    def test_truncated_at_every_byte(self):
        self.check_truncated(self.read("chains.ustp"))

    def test_step_limit(self):
        words = ["decompress", "chains.ustp", "-o", "out.fc", "--max-steps"]
        result = self.run_cli(*words, "16")
        self.assertEqual((result.code, result.out), (3, ""))
        self.expect([*words, "17", "-q"])

    def differ(self, a, b, reason):
        self.expect(["verify", a, b], code=1,
                    out=f"{a} and {b} differ: {reason}\n")

    def test_same(self):
        self.expect(["verify", "chains.fc", "chains.ustp"],
                    out="chains.fc and chains.ustp are the same: 1 page\n")

    def test_steps(self):
        self.write("b.fc", FREEMAN.replace(b"0 1 2 3 4 5 6 7 0",
                                           b"0 1 2 3 4 5 6 7 1"))
        self.differ("b.fc", "chains.ustp",
                    "chain 2 step 9 is 1 and 0 in the second")
        self.write("b.fc", FREEMAN.replace(b"10 10:", b"10 11:"))
        self.differ("b.fc", "chains.ustp",
                    "chain 2 starts at (10, 11) and at (10, 10) in the second")

    def test_kinds(self):
        self.write("a.pbm", pbm(pixels(8, 8)))
        self.differ("a.pbm", "chains.ustp",
                    "ink in the first and chains in the second")

    def test_info(self):
        out = self.expect(["info", "chains.ustp"]).out
        self.assertIn("  page 1: chains, 20 x 20 px, y down\n", out)
        self.assertIn("    block 1: 2 chains, 17 steps, ", out)
        self.assertIn(" bits per step\n", out)
        info = json.loads(self.expect(["info", "--json", "chains.ustp"]).out)
        self.assertEqual(info[0]["steps"], 17)
        self.assertEqual(info[0]["pages"][0]["kind"], "chains")

    def test_batch_and_back(self):
        self.write("in/deep/chains.fc", FREEMAN)
        self.expect(["batch", "in", "-o", "out", "-q"])
        self.assertEqual(self.names("out"), ["deep/chains.fc.ustp"])
        self.expect(["batch", "-d", "out", "-o", "back", "-q"])
        self.assertEqual(self.names("back"), ["deep/chains.fc"])
        self.expect(["verify", "-q", "back/deep/chains.fc",
                     "out/deep/chains.fc.ustp"])
        self.expect(["batch", "-d", "out", "-o", "back", "--resume"],
                    out="1 file: 0 decompressed, 1 finished before\n")


if __name__ == "__main__":
    harness.main()
