#!/usr/bin/env python3
"""Makes a large bilevel page out of real drawings, as a raw PBM.

usage: make_large.py [--side N | --size W H] [--seed N] OUT.pbm [IMAGE...]

The images (default: samples/) are stacked in columns, the columns laid side by
side in strips, each image with a gap and varied: mirrored, upside down,
doubled in size, negative within its frame, shifted. The same arguments always
give the same page. Memory stays at a strip; the page is written row by row.
"""

import argparse
import glob
import os
import random
import sys

import images

HERE = os.path.dirname(os.path.abspath(__file__))
SAMPLES = os.path.join(HERE, "..", "..", "samples")
STRIP = 3600  # rows, unless one drawing is taller


def as_integers(page):
    """Rows as integers, first pixel in the highest of `width` bits."""
    stride = (page.width + 7) // 8
    spare = stride * 8 - page.width
    return [int.from_bytes(page.rows[y * stride:(y + 1) * stride], "big")
            >> spare for y in range(page.height)]


def mirrored(row, width):
    return int(format(row, "0%db" % width)[::-1], 2)


def doubled(row, width):
    return int("".join(c + c for c in format(row, "0%db" % width)), 2)


def varied(rows, width, rng):
    """A drawing in one of its variations: rows, width."""
    if rng.random() < 0.3 and width < 1200:
        rows = [r for row in rows for r in (doubled(row, width),) * 2]
        width *= 2
    if rng.random() < 0.5:
        rows = [mirrored(row, width) for row in rows]
    if rng.random() < 0.5:
        rows = rows[::-1]
    if rng.random() < 0.15:
        full = (1 << width) - 1
        rows = [row ^ full for row in rows]
    return rows, width


class Column:
    """Drawings one below the other, `width` pixels from column `x` on."""

    def __init__(self, drawings, x, rng):
        first = varied(*rng.choice(drawings), rng)
        self.x = x
        self.width = first[1]
        self.rows = []
        narrow = [d for d in drawings if 2 * d[1] <= self.width] + [first]
        rows, width = first
        while len(self.rows) + len(rows) < STRIP or not self.rows:
            self.rows += [0] * rng.randrange(8, 120)
            indent = rng.randrange(0, self.width - width + 1)
            self.rows += [row << indent for row in rows]
            rows, width = varied(*rng.choice(narrow), rng)
            if width > self.width:
                rows, width = first

    def row(self, y):
        return self.rows[y] if y < len(self.rows) else 0


def columns_of_strip(drawings, width, rng):
    columns = []
    x = rng.randrange(0, 80)
    while x < width:
        columns.append(Column(drawings, x, rng))
        x += columns[-1].width + rng.randrange(8, 120)
    return columns


def write_page(out, drawings, width, height, rng):
    out.write(b"P4\n%d %d\n" % (width, height))
    stride = (width + 7) // 8
    done = 0
    while done < height:
        columns = columns_of_strip(drawings, width, rng)
        tall = min(max(len(c.rows) for c in columns), height - done)
        for y in range(tall):
            row = 0
            for column in columns:
                shift = width - column.x - column.width
                bits = column.row(y)
                row |= bits << shift if shift >= 0 else bits >> -shift
            out.write((row << (stride * 8 - width)).to_bytes(stride, "big"))
        done += tall


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--side", type=int, default=20000)
    parser.add_argument("--size", type=int, nargs=2, metavar=("W", "H"))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("out")
    parser.add_argument("image", nargs="*")
    args = parser.parse_args()
    width, height = args.size or (args.side, args.side)

    paths = args.image or sorted(
        p for p in glob.glob(os.path.join(SAMPLES, "*"))
        if os.path.splitext(p)[1].lower() in images.KINDS)
    drawings = [(as_integers(page), page.width)
                for path in paths for page in images.read_pages(path)]
    if not drawings:
        sys.exit("make_large.py: no images")
    with open(args.out, "wb") as out:
        write_page(out, drawings, width, height, random.Random(args.seed))


if __name__ == "__main__":
    main()
