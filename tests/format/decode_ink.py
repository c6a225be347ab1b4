#!/usr/bin/env python3
"""A second decoder of coders 1 to 4, written from docs/format.md alone.

    decode_ink.py [--trace] IN.ustp OUT.pbm

Reads short forms of one ink page. Plain and slow, for small drawings: it shows
that the page is enough to write a decoder from. --trace prints every decision.
The docstrings name the page's sections.
"""
import pathlib
import sys
import zlib

from centrelines import Centrelines
from deep_lines import DeepCentrelines
from deep_shapes import DeepShapes
from deep_turns import DeepStartModel, DeepTurnModel
from entropy import Damaged, Interval
from rows import Rows
from shapes import Shapes
from starts import StartModel
from table import DeepTable, Table
from turns import DX, DY, FastTurnModel, TurnModel


class Cracks:
    """Points, cracks, directions: (x, y, 0) is H, (x, y, 1) is V."""

    def __init__(self):
        self.known = set()
        self.near = set()  # the points that known cracks make near
        self.words = set()  # (word, row): a known crack is around

    def mark(self, x, y, direction):
        x, y, plane = self.leaving(x, y, direction)
        self.known.add((x, y, plane))
        self.near.update((i, j) for i in range(x - 2, x + 3)
                         for j in range(y - 1, y + 2 + plane))
        self.words.update((x // 64, j) for j in range(y - 1, y + 2 + plane))

    @staticmethod
    def leaving(x, y, direction):
        return ((x, y, 0), (x, y, 1), (x - 1, y, 0), (x, y - 1, 1))[direction]

    def test(self, x, y, direction):
        return int(self.leaving(x, y, direction) in self.known)

    def H(self, x, y):
        return int((x, y, 0) in self.known)

    def V(self, x, y):
        return int((x, y, 1) in self.known)


class Scan:
    """Scan and Walk."""

    def __init__(self, coder, width, rows, revision):
        self.width, self.rows, self.coder = width, rows, coder
        self.cracks = Cracks()
        size = width * rows
        table = Table("small" if size < 2000000 or revision == 1 else
                      "clean" if revision in (0, 4) else "large")
        words = (width + 63) // 64
        if revision == 2:
            self.turns = FastTurnModel(self.cracks)
        elif revision == 1:
            self.turns = DeepTurnModel(
                self.cracks, 13 if size < 40000 else 15, table, DeepTable())
        elif revision == 4:
            self.turns = DeepTurnModel(
                self.cracks, 14 if size < 40000 else
                16 if size < 2000000 else 18, table)
        else:
            light = revision == 3
            table_bits = (13 if size < 40000 else
                          15 if size < 2000000 or size > 24000000 else
                          17 - light)
            self.turns = TurnModel(self.cracks, table_bits, table, light=light)
        self.starts = (DeepStartModel if revision == 4 else StartModel)(
            self.cracks, table, words)
        self.spans = revision != 4  # the deep model knows none
        self.above = [0] * width

    def run(self, image):
        for y in range(self.rows):
            self.starts.begin_row(y)
            first = 0
            while first < self.width:
                if (self.spans and self.is_quiet_span(y, first) and
                        not self.starts.quiet_start(self.coder, first // 64,
                                                    self.above[first])):
                    first += 256
                    continue
                self.word(y, range(first, min(first + 64, self.width)))
                first += 64
            ink, row = 0, []
            for x in range(self.width):
                ink ^= self.cracks.V(x, y)
                row.append(ink)
            image[y] = [a | b for a, b in zip(image[y], row)]
            self.above = row

    def is_quiet_span(self, y, first):
        word = first // 64
        return (word % 4 == 0 and first + 256 <= self.width
                and self.width > 15 * 64
                and len(set(self.above[first:first + 256])) == 1
                and not any((w, y) in self.cracks.words
                            for w in range(word - 1, word + 5)))

    def candidates(self, y, points, excluded):
        """Near ones, likely ones, far ones on paper, far ones on ink."""
        H, V = self.cracks.H, self.cracks.V
        near, likely, far = [], [], ([], [])
        for x in points:
            if (x in excluded or H(x, y) or V(x, y)
                    or V(x, y - 1) != H(x - 1, y)):
                continue
            if (x, y) not in self.cracks.near:
                far[self.above[x]].append(x)
            elif V(x, y - 1) or self.above[x] and (
                    H(x, y - 1) or V(x - 1, y - 1) and V(x + 1, y)):
                likely.append(x)
            else:
                near.append(x)
        return near, likely, far

    def word(self, y, points):
        excluded = set()
        for colour in (0, 1):
            while mask := self.candidates(y, points, excluded)[2][colour]:
                if not self.starts.far_start(self.coder, mask, colour):
                    excluded.update(mask)
                    break
                self.walk(self.starts.far_index(self.coder, mask, colour), y,
                          1 - colour)
        while mask := self.candidates(y, points, excluded)[1]:
            x = mask[0]
            excluded.add(x)
            if self.starts.near_start(self.coder, x, y, self.above[x]):
                self.walk(x, y, 1 - self.above[x])
        while True:
            near, likely, _ = self.candidates(y, points, excluded)
            mask = sorted(near + likely)
            if not mask:
                break
            x = self.starts.near_first(self.coder, mask, y, self.above)
            if x is None:
                break
            excluded.update(range(points[0], x + 1))
            self.walk(x, y, 1 - self.above[x])

    def walk(self, x, y, ink):
        x0, y0, direction = x, y, 0
        self.turns.begin(x, y, ink)
        while True:
            self.cracks.mark(x, y, direction)
            x, y = x + DX[direction], y + DY[direction]
            if (x, y) == (x0, y0):
                return
            allowed = []
            for t in (0, 1, 2):
                way = (direction + (0, 3, 1)[t]) % 4
                inside = (x < self.width, y < self.rows, x > 0 and y > y0,
                          y > y0)[way]
                if inside and not self.cracks.test(x, y, way):
                    allowed.append(t)
            if not allowed:
                raise Damaged("dead end")
            t = allowed[0]
            if len(allowed) > 1:
                t = self.turns.turn(self.coder, x, y, allowed)
            self.turns.advance(t)
            direction = self.turns.direction


def varint(data, at):
    value = shift = 0
    while True:
        value |= (data[at] & 127) << shift
        at, shift = at + 1, shift + 7
        if data[at - 1] < 128:
            return value, at


def skip_details(data, at):
    """Page head, Details: where they end."""
    def skip_metadata(at):
        size, at = varint(data, at)
        if size == 0:
            return at
        packed, at = varint(data, at)
        return at + packed

    details, at = data[at], at + 1
    if details & 8:
        for _ in range(2 if details & 4 else 4):
            _, at = varint(data, at)
    if details & 16:
        length, at = varint(data, at)
        at = skip_metadata(at + length)
    if details & 32:
        at = skip_metadata(at)
    return at


def decode(data, trace=False):
    """Start of every file, Short form. Returns width, height, rows of PBM."""
    flags = data[4]
    if data[:4] != b"\xf5\x55\x0d\x0a" or flags & 0xD3:
        raise Damaged("not a short form with ink")
    width, at = varint(data, 5)
    height = width
    if not flags & 4:
        height, at = varint(data, at)
    if flags & 0x20:
        at = skip_details(data, at)
    name = 1, 1, 1
    if not flags & 8:
        packed, at = data[at], at + 1
        name = packed & 31, packed >> 5 & 3, packed >> 7
        if name[1] == 3:
            name, at = (name[0], data[at], data[at + 1]), at + 2
    if name not in ((1, 0, 1), (1, 1, 1), (1, 2, 1), (1, 3, 1), (1, 4, 1),
                    (2, 0, 1), (2, 1, 1), (3, 0, 1), (3, 1, 1), (4, 0, 0),
                    (4, 1, 0), (4, 2, 0)):
        raise Damaged("another coder than 1 to 4")
    head, stored, payload = data[4:at], data[at:at + 4], data[at + 4:]
    coder = Interval(payload, trace)
    image = [[0] * width for _ in range(height)]
    if name[0] == 3:
        (DeepCentrelines if name[1] else Centrelines)(
            coder, width, height).run(image)
    elif name[0] == 4:
        Rows(coder, width, height, name[1]).run(image)
    else:
        contours = name[1]
        if name[0] == 2:
            (DeepShapes if name[1] else Shapes)(
                coder, width, height).run(image)
            contours = 4 if name[1] else 3
        Scan(coder, width, height, contours).run(image)
    coder.check_end()
    pbm = b""
    for row in image:
        digits = "".join(map(str, row)) + "0" * (-width % 8)
        pbm += int(digits, 2).to_bytes(len(digits) // 8, "big")
    if zlib.crc32(head + pbm) != int.from_bytes(stored, "little"):
        raise Damaged("checksum")
    return width, height, pbm


def main():
    words = [a for a in sys.argv[1:] if a != "--trace"]
    if len(words) != 2:
        sys.exit("usage: decode_ink.py [--trace] IN.ustp OUT.pbm")
    try:
        width, height, pbm = decode(pathlib.Path(words[0]).read_bytes(),
                                    "--trace" in sys.argv)
    except (Damaged, IndexError) as error:
        sys.exit(f"{words[0]}: {error}")
    pathlib.Path(words[1]).write_bytes(
        b"P4\n%d %d\n" % (width, height) + pbm)


if __name__ == "__main__":
    main()
