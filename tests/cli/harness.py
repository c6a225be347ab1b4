"""Runs the program as a user would. The inputs are made here, so that no other
program is needed."""

import os
import random
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.environ["UNSTEP_PROGRAM"]
VERSION = os.environ["UNSTEP_VERSION"]


class Result:
    def __init__(self, process):
        self.code = process.returncode
        self.out_bytes = process.stdout
        self.err = process.stderr.decode()

    @property
    def out(self):
        return self.out_bytes.decode()


def grouped(number):
    return f"{number:,}"


def pbm(rows):
    """A P4 file from strings of '#' and '.'."""
    width = len(rows[0])
    data = bytearray()
    for row in rows:
        bits = row.replace("#", "1").replace(".", "0")
        bits += "0" * (-width % 8)
        data += int(bits, 2).to_bytes(len(bits) // 8, "big")
    return b"P4\n%d %d\n" % (width, len(rows)) + bytes(data)


def pixels(width, height, seed=1):
    """Random rectangles: some structure, always the same."""
    chance = random.Random(seed)
    grid = [["."] * width for _ in range(height)]
    for _ in range(6):
        x0, y0 = chance.randrange(width), chance.randrange(height)
        x1 = min(width, x0 + 1 + chance.randrange(width))
        y1 = min(height, y0 + 1 + chance.randrange(height))
        mark = chance.choice("#.#")
        for y in range(y0, y1):
            for x in range(x0, x1):
                grid[y][x] = mark
    return ["".join(row) for row in grid]


def noise(width, height, seed=7):
    """A P4 file of noise: the dearest thing there is to encode."""
    data = random.Random(seed).randbytes((width + 7) // 8 * height)
    return b"P4\n%d %d\n" % (width, height) + data


FREEMAN = b"""# a closed square and an open stroke
canvas 20 20 down
closed4 3 4: 0 0 6 6 4 4 2 2
open8 10 10: 0 1 2 3 4 5 6 7 0
"""


class CliTest(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="unstep-cli-")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, data):
        path = self.path(name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb") as file:
            file.write(data)
        return path

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def size(self, name):
        return grouped(os.path.getsize(self.path(name)))

    def names(self, folder="."):
        """Every file below the folder, sorted."""
        found = []
        top = self.path(folder)
        for where, _, files in os.walk(top):
            found += [os.path.relpath(os.path.join(where, f), top)
                      for f in files]
        return sorted(found)

    def run_cli(self, *args, stdin=b""):
        process = subprocess.run([PROGRAM, *args], cwd=self.folder,
                                 input=stdin, capture_output=True,
                                 timeout=120, check=False)
        return Result(process)

    def expect(self, args, code=0, out=None, err="", stdin=b""):
        """Runs and compares the exit code, stdout and stderr exactly; out None
        leaves stdout to the caller."""
        result = self.run_cli(*args, stdin=stdin)
        self.assertEqual(result.err, err, args)
        self.assertEqual(result.code, code, args)
        if out is not None:
            self.assertEqual(result.out, out, args)
        return result

    def expect_error(self, args, code, err, stdin=b""):
        """An error is one line on stderr and nothing on stdout."""
        result = self.expect(args, code=code, out="", err=err, stdin=stdin)
        self.assertEqual(result.err.count("\n"), 1)
        return result

    def compress(self, name, *args):
        result = self.run_cli("compress", name, "-q", *args)
        self.assertEqual((result.code, result.err), (0, ""))

    def check_truncated(self, whole):
        """Every beginning of a .ustp file is a clear error."""
        for length in range(len(whole)):
            self.write("cut.ustp", whole[:length])
            before = self.names()
            result = self.run_cli("decompress", "cut.ustp")
            self.assertEqual((result.code, result.out), (3, ""), length)
            self.assertTrue(result.err.startswith("unstep: cut.ustp: "))
            self.assertEqual(result.err.count("\n"), 1)
            self.assertEqual(self.names(), before)


def main():
    unittest.main(argv=[sys.argv[0], "-v"] + sys.argv[1:])
