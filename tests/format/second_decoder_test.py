"""docs/format.md is enough to write decoders of ink, of strokes and of programs
from: those here agree with the program, and the example of the page is what both
do."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from decode_ink import varint  # pylint: disable=wrong-import-position

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM_DECODER = pathlib.Path(__file__).parent / "decode_program.py"
STROKE_DECODER = pathlib.Path(__file__).parent / "decode_strokes.py"
DECODER = pathlib.Path(__file__).parent / "decode_ink.py"
PROGRAM = os.environ["UNSTEP_PROGRAM"]


def pbm(rows):
    width = len(rows[0])
    data = b""
    for row in rows:
        digits = row.replace("#", "1").replace(".", "0") + "0" * (-width % 8)
        data += int(digits, 2).to_bytes(len(digits) // 8, "big")
    return b"P4\n%d %d\n" % (width, len(rows)) + data


def scattered(width, height):
    """Blots by a rule: saddles, holes, dots at all edges and word ends."""
    def ink(x, y):
        mixed = (x // 3 * 2654435761 ^ y // 4 * 40503 ^ (x // 7) * y) >> 5
        return mixed % 11 < 2 or (x * y) % 59 == 1
    return pbm(["".join("#" if ink(x, y) else "." for x in range(width))
                for y in range(height)])


LETTERS = (
    ("..####..", ".##..##.", "##....##", "##....##", "##....##", "##....##",
     ".##..##.", "..####.."),
    ("######..", "##...##.", "##...##.", "######..", "##...##.", "##....##",
     "##...##.", "######.."),
    ("##......", "##......", "##......", "##......", "##......", "##......",
     "########", "########"),
    ("..#..", ".#.#.", "#...#", ".#.#.", "..#.."),
    ("######", "..##..", "..##..", "..##..", "..##..", "..##..", "..##..",
     "..##..", "..##..", "######"))


def text(width, height, rough):
    """Lines of letters, of different heights and with holes; every `rough`th
    one has another pixel. A ring around some, and a line below, are no
    shapes."""
    page = [[0] * width for _ in range(height)]
    count = 0
    for bottom in range(14, height - 5, 15):
        x = 3 + bottom % 7
        while x < width - 12:
            letter = LETTERS[(count * 7 + bottom) * 2654435761 % 2**32 % 5]
            top = bottom - len(letter) + count % 13 // 12
            for j, row in enumerate(letter):
                for i, pixel in enumerate(row):
                    page[top + j][x + i] = int(pixel == "#")
            if count % rough == 0:
                page[top + count % 5][x + count % 6 - 1] ^= 1
            x += len(letter[0]) + 2 + 7 * (count % 6 == 5)
            count += 1
    for x in range(width):
        page[height - 3][x] = 1
    for y in range(height):
        page[y][0] = page[y][width - 1] = 1
    return pbm(["".join(".#"[p] for p in row) for row in page])


def thin_map(width, height, pieces):
    """Polygons of lines one pixel thin, on a grid; they cross and touch. Dots
    beside some, three in eight pixels of a row."""
    page, state = [["."] * width for _ in range(height)], 7

    def below(n):
        nonlocal state
        state = (state * 1103515245 + 12345) % 2**31
        return (state >> 12) % n

    def line(a, b):
        steps = max(abs(b[0] - a[0]), abs(b[1] - a[1]), 1)
        for i in range(steps + 1):
            page[a[1] + (b[1] - a[1]) * i // steps][
                a[0] + (b[0] - a[0]) * i // steps] = "#"

    for _ in range(pieces):
        corners = [(below(width // 15) * 15, below(height // 15) * 15)]
        for _ in range(3):
            x, y = corners[-1]
            corners.append((min(max(x + below(5) * 15 - 30, 0), width - 1),
                            min(max(y + below(5) * 15 - 30, 0), height - 1)))
        for a, b in zip(corners, corners[1:] + corners[:1]):
            line(a, b)
        x, y = corners[0]
        for dot in range(x + 2, min(x + 9, width), 3):
            page[(y + 7) % height][dot] = "#"
    return pbm(["".join(row) for row in page])


class SecondDecoder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def compress(self, source, *options):
        subprocess.run([PROGRAM, "compress", "-qf", source, "-o",
                        self.path("a.ustp"), *options], check=True)
        return pathlib.Path(self.path("a.ustp")).read_bytes()

    def decode(self, *options):
        return subprocess.run(
            [sys.executable, "-B", str(DECODER), *options,
             self.path("a.ustp"), self.path("second.pbm")],
            capture_output=True, text=True, check=False)

    def check_agrees(self, source, *options):
        self.compress(source, *options)
        subprocess.run([PROGRAM, "decompress", "-qf", self.path("a.ustp"),
                        "-o", self.path("first.pbm")], check=True)
        second = self.decode()
        self.assertEqual(second.stderr, "")
        self.assertEqual(pathlib.Path(self.path("second.pbm")).read_bytes(),
                         pathlib.Path(self.path("first.pbm")).read_bytes())

    def check_agrees_on_pixels(self, data, *options, coder=1):
        pathlib.Path(self.path("a.pbm")).write_bytes(data)
        self.check_agrees(self.path("a.pbm"), *options)
        file = pathlib.Path(self.path("a.ustp")).read_bytes()
        _, at = varint(file, 5)
        if not file[4] & 4:
            _, at = varint(file, at)
        self.assertEqual(1 if file[4] & 8 else file[at] & 31, coder)

    def test_pen_stroke(self):
        self.check_agrees(str(ROOT / "samples/glyph.pbm"))

    def test_page_with_texts(self):
        self.check_agrees(str(ROOT / "samples/glyph.pbm"),
                          "--meta", "title=a glyph")

    def test_icon(self):
        self.check_agrees(str(ROOT / "samples/crown.png"))

    def test_blots_across_word_ends(self):
        self.check_agrees_on_pixels(scattered(130, 37))

    def test_text_with_few_and_with_many_other_pixels(self):
        self.check_agrees_on_pixels(text(256, 110, 9), coder=2)
        self.check_agrees_on_pixels(text(240, 110, 2), coder=2)

    def test_quiet_spans(self):
        self.check_agrees(str(ROOT / "tests/golden/valid/contours_wide.pbm"))

    def test_efforts(self):
        self.check_agrees_on_pixels(scattered(70, 30), "--effort", "fast")
        # The smallest of all ways: blots as pixels.
        self.check_agrees_on_pixels(scattered(70, 30), "--effort", "max",
                                    coder=4)

    def test_models_that_small_drawings_seldom_have(self):
        for name in ("contours_blots_standard", "contours_blots_light",
                     "contours_wide", "contours_rings_deep",
                     "shapes_text_deep"):
            golden = ROOT / f"tests/golden/valid/{name}"
            file = golden.with_suffix(".ustp").read_bytes()
            pathlib.Path(self.path("a.ustp")).write_bytes(file)
            self.assertEqual(self.decode().stderr, "")
            self.assertEqual(
                pathlib.Path(self.path("second.pbm")).read_bytes(),
                golden.with_suffix(".pbm").read_bytes())

    def test_thin_lines(self):
        self.check_agrees_on_pixels(thin_map(300, 300, 20), coder=3)
        self.check_agrees_on_pixels(thin_map(300, 300, 20), "--effort", "max",
                                    coder=3)

    def test_dither(self):
        """Ordered, of a slope in two directions."""
        rank = (0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5)
        page = pbm(["".join(".#"[(x * 7 + y * y // 9) % 256
                                 > 16 * rank[x % 4 + y % 4 * 4] + 8]
                            for x in range(203)) for y in range(202)])
        self.check_agrees_on_pixels(page, coder=4)

    def test_large_page_in_haste(self):
        blots = [list("." * 1061) for _ in range(1000)]
        for y, x in ((0, 0), (100, 500), (930, 1000)):
            for i in range(0, 3000, 7):
                v, u = i * i // 40 % 61, i * 31 // 11 % 59
                for k in range(1 + i % 9):
                    blots[y + v][x + min(u + k, 60)] = "#"
        self.check_agrees_on_pixels(pbm(["".join(row) for row in blots]),
                                    "--effort", "fast", coder=4)

    def test_large_page(self):
        """That starts with the other half of the table."""
        rows = ["." * 2000] * 1001
        rows[7] = "." * 900 + "##.####.####...###" * 5 + "." * 1010
        rows[8] = rows[7].replace("##.#", "####")
        self.check_agrees_on_pixels(pbm(rows))

    def test_large_page_of_thin_lines(self):
        """That has the largest tables."""
        small = thin_map(300, 300, 20)
        rows = [format(int.from_bytes(small[-38 * (300 - y):][:38], "big"),
                       "0304b")[:300] for y in range(300)]
        self.check_agrees_on_pixels(
            pbm([row + "0" * 1700 for row in rows] + ["0" * 2000] * 701),
            coder=3)

    def test_smallest_sides(self):
        self.check_agrees_on_pixels(pbm(["#"]))
        self.check_agrees_on_pixels(pbm(["." * 60 + "#####" + "." * 90]))

    def test_the_example_of_the_page_is_what_happens(self):
        text = (ROOT / "docs/format.md").read_text("utf-8")
        example = text.split("<!-- contour example begins -->")[1].split(
            "<!-- contour example ends -->")[0]
        stored = bytes.fromhex("".join(
            re.findall(r"^ +\d+  ((?:[0-9a-f]{2} )+) ", example, re.M)))
        rows = ["." * 8] * 3 + ["...#...."] + ["." * 8] * 4
        pathlib.Path(self.path("a.pbm")).write_bytes(pbm(rows))
        self.assertEqual(self.compress(self.path("a.pbm")), stored)
        second = self.decode("--trace")
        self.assertEqual(second.stderr, "")
        self.assertEqual(pathlib.Path(self.path("second.pbm")).read_bytes(),
                         pbm(rows))
        decision = r"^ *([a-z, ]+?) +(\d+) +([01]) +([0-9a-f]{8}) ([0-9a-f]{8})"
        told = re.findall(decision, example, re.M)
        self.assertGreater(len(told), 20)
        self.assertEqual(told, re.findall(decision, second.stdout, re.M))

    def test_a_payload_has_one_spelling(self):
        file = self.compress(str(ROOT / "samples/glyph.pbm"))
        for damaged in (file[:-1], file + b"\0", file + b"\1",
                        file[:-1] + bytes([file[-1] ^ 1]),
                        file[:-1] + bytes([file[-1] ^ 0x80])):
            pathlib.Path(self.path("a.ustp")).write_bytes(damaged)
            self.assertNotEqual(self.decode().returncode, 0)
            verified = subprocess.run(
                [PROGRAM, "verify", self.path("a.ustp")],
                capture_output=True, check=False)
            self.assertNotEqual(verified.returncode, 0)


class SecondDecoderOfPrograms(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def decode(self):
        return subprocess.run(
            [sys.executable, "-B", str(PROGRAM_DECODER),
             self.folder / "a.ustp", self.folder / "second.ngc"],
            capture_output=True, text=True, check=False)

    def check_agrees(self, source, *options):
        subprocess.run([PROGRAM, "compress", "-qf", source, "-o",
                        self.folder / "a.ustp", *options], check=True,
                       stderr=subprocess.DEVNULL)
        subprocess.run([PROGRAM, "decompress", "-qf", self.folder / "a.ustp",
                        "-o", self.folder / "first.ngc"], check=True)
        second = self.decode()
        self.assertEqual(second.stderr, "")
        self.assertEqual((self.folder / "second.ngc").read_bytes(),
                         (self.folder / "first.ngc").read_bytes())

    def test_programs(self):
        for path in sorted((ROOT / "tests/programs").iterdir()):
            if path.name != "tiny.ngc":  # long
                self.check_agrees(path)
        self.check_agrees(ROOT / "tests/programs/tiny.ngc", "--tolerance",
                          "0.01mm")

    def test_extrusion(self):
        lines = ["M83", "G28", "G1 X1 Y1 Z0.2 E0.5 F1500"]
        lines += ["G1 X%.2f Y%.2f E%.5f" % (i * 7 % 50, i * 3 % 40, i % 9 / 30)
                  for i in range(60)]
        lines.insert(30, "M82 ; absolute")
        (self.folder / "a.gcode").write_text("\n".join(lines) + "\n")
        self.check_agrees(self.folder / "a.gcode")

    def test_a_payload_has_one_spelling(self):
        self.check_agrees(ROOT / "tests/programs/arcs.ngc")
        file = (self.folder / "a.ustp").read_bytes()
        for damaged in (file[:-1], file + b"\1",
                        file[:-1] + bytes([file[-1] ^ 1])):
            (self.folder / "a.ustp").write_bytes(damaged)
            self.assertNotEqual(self.decode().returncode, 0)


class SecondDecoderOfStrokes(unittest.TestCase):
    def test_golden_file_and_traced_ink(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            files = [ROOT / "tests/golden/valid/strokes_words.ustp"]
            for sample, tolerance in (("glyph.pbm", "1"),
                                      ("molecule-8bit.png", "0.5")):
                files.append(folder / (sample + ".ustp"))
                subprocess.run(
                    [PROGRAM, "compress", "-qf", ROOT / "samples" / sample,
                     "--threshold", "auto", "--trace", "centerline",
                     "--tolerance", tolerance, "-o", files[-1]], check=True,
                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            damaged = folder / "damaged.ustp"
            data = files[1].read_bytes()
            damaged.write_bytes(data[:-1] + bytes([data[-1] ^ 1]))
            second = subprocess.run(
                [sys.executable, "-B", str(STROKE_DECODER), *files, damaged],
                capture_output=True, text=True, check=False)
            self.assertEqual(second.stdout.count(" paths"), len(files))
            self.assertIn("damaged.ustp", second.stderr)
            self.assertEqual(second.stderr.count("\n"), 1)


if __name__ == "__main__":
    unittest.main()
