"""What the client tests share: programs, rasters, drawings of known shape.

Needs nothing but Python's own library.
"""

import json
import math
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

SKIPPED = 77
PROGRAM = os.environ["UNSTEP_PROGRAM"]
SAMPLES = os.environ["UNSTEP_SAMPLES"]

# Bilevel samples that are no larger than a test should be.
RASTERS = ["crown.png", "glyph.pbm", "text-page.tif"]


def need(program):
    """Skips the test aloud if there is no such program."""
    if shutil.which(program) is None:
        skip(f"{program} is not installed")


def skip(reason):
    print(f"SKIPPED, NOTHING WAS TESTED: {reason} (see tests/needs.sh)")
    sys.exit(SKIPPED)


def run(*command):
    """The output of a program that must succeed within a minute."""
    done = subprocess.run(command, capture_output=True, timeout=60)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(command)}: exit {done.returncode}\n"
                             + done.stderr.decode(errors="replace"))
    return done.stdout


def convert(source, target, *options):
    run(PROGRAM, "convert", "--quiet", "--force", *options, source, target)
    return target


class Raster:
    """Ink by rows: one byte a pixel, 1 is ink."""

    def __init__(self, width, height, rows):
        self.width, self.height, self.rows = width, height, rows

    def edge_distances(self):
        """A function of a pixel: the distance of its centre from the nearest
        edge between ink and paper, 5 if it is above 4."""
        reach = 4
        offsets = sorted(((i, j) for i in range(-reach, reach + 1)
                          for j in range(-reach, reach + 1)),
                         key=lambda o: o[0] * o[0] + o[1] * o[1])

        def ink(x, y):
            inside = 0 <= x < self.width and 0 <= y < self.height
            return self.rows[y][x] if inside else 0

        def distance(x, y):
            own = ink(x, y)
            best = reach + 1.0
            for i, j in offsets:
                if math.hypot(max(abs(i) - 0.5, 0),
                              max(abs(j) - 0.5, 0)) >= best:
                    continue
                if ink(x + i, y + j) != own:
                    best = min(best, math.hypot(max(abs(i) - 0.5, 0),
                                                max(abs(j) - 0.5, 0)))
            return best

        return distance

    def count_different(self, other):
        """Pixels that differ; `other` may be a pixel larger by rounding."""
        assert 0 <= other.width - self.width <= 1, (self.width, other.width)
        assert 0 <= other.height - self.height <= 1
        return sum(a != b for row, seen in zip(self.rows, other.rows)
                   for a, b in zip(row, seen))


def read_pbm(data):
    """P4."""
    fields, at = [], 0
    while len(fields) < 3:
        end = at
        while data[end:end + 1] not in (b" ", b"\n", b"\t", b""):
            end += 1
        if data[at:at + 1] == b"#":
            end = data.index(b"\n", at)
        elif end > at:
            fields.append(data[at:end])
        at = end + 1
    assert fields[0] == b"P4", fields
    width, height = int(fields[1]), int(fields[2])
    stride = (width + 7) // 8
    bits = [bytes(b >> (7 - i) & 1 for i in range(8)) for b in range(256)]
    rows = [b"".join(bits[b] for b in data[at + y * stride:
                                           at + (y + 1) * stride])[:width]
            for y in range(height)]
    return Raster(width, height, rows)


def unfilter(kind, row, before, step):
    """A row of PNG samples (PNG specification, section 9)."""
    if kind == 2:
        for i, up in enumerate(before):
            row[i] = row[i] + up & 255
        return
    for i in range(len(row)):
        left = row[i - step] if i >= step else 0
        up = before[i]
        if kind == 1:
            guess = left
        elif kind == 3:
            guess = (left + up) // 2
        else:
            corner = before[i - step] if i >= step else 0
            base = left + up - corner
            guess = min((abs(base - left), 0, left), (abs(base - up), 1, up),
                        (abs(base - corner), 2, corner))[2]
        row[i] = row[i] + guess & 255


def read_png(data):
    """8-bit grey, RGB or RGBA over white; dark is ink."""
    at, packed, header = 8, b"", None
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
        at += size + 12
    width, height, depth, colour = header[:4]
    assert depth == 8 and colour in (0, 2, 6), header
    step = {0: 1, 2: 3, 6: 4}[colour]
    raw = zlib.decompress(packed)
    rows, before = [], bytearray(width * step)
    for y in range(height):
        begin = y * (width * step + 1)
        row = bytearray(raw[begin + 1:begin + 1 + width * step])
        if raw[begin]:
            unfilter(raw[begin], row, before, step)
        before = row
        light = row[::step]
        if colour == 6:
            light = bytes(255 - alpha + value * alpha // 255
                          for value, alpha in zip(light, row[3::step]))
        rows.append(bytes(value < 128 for value in light))
    return Raster(width, height, rows)


class Shapes:
    """A ring, a stadium, three quarters and one quarter of a disc: circles,
    arcs of both directions, larger and smaller than half."""

    WIDTH, HEIGHT = 200, 160

    def __init__(self, scale=1, axis="down", paint="fill"):
        self.scale, self.axis, self.paint = scale, axis, paint

    PATHS = [
        ((110, 60), [(0, 0, -50, 0, "cw")]),
        ((90, 60), [(0, 0, -30, 0, "ccw")]),
        ((130, 30), [(40, 0), (0, 30, 0, 15, "ccw"), (-40, 0),
                     (0, -30, 0, -15, "ccw")]),
        ((175, 110), [(-25, -25, -25, 0, "ccw"), (0, 25), (25, 0)]),
        ((55, 140), [(-15, -15, -15, 0, "cw"), (0, 15), (15, 0)]),
    ]

    def json(self):
        def scaled(element):
            return [v if isinstance(v, str) else v * self.scale
                    for v in element]
        shapes = [{"closed": True, "at": scaled(at),
                   "path": [scaled(element) for element in path]}
                  for at, path in self.PATHS]
        page = {"canvas": [self.WIDTH, self.HEIGHT], "y": self.axis,
                "scale": self.scale, "paint": self.paint, "shapes": shapes,
                "resolution": {"x": [127, 1], "y": [127, 1], "unit": "inch"}}
        return json.dumps({"unstep": 1, "pages": [page]})

    def signed_distances(self, x, y):
        """To each shape: below 0 inside, its size the distance to the edge or
        less."""
        ring = math.hypot(x - 60, y - 60)
        yield max(ring - 50, 30 - ring)
        yield math.hypot(x - min(max(x, 130), 170), y - 45) - 15
        disc = math.hypot(x - 150, y - 110) - 25
        yield max(disc, min(x - 150, 110 - y))
        disc = math.hypot(x - 40, y - 140) - 15
        yield max(disc, 40 - x, y - 140)

    def check(self, raster, margin):
        """All pixels whose centres are farther than `margin` from an edge are
        as they should be."""
        assert abs(raster.width - self.WIDTH) <= 1, raster.width
        assert abs(raster.height - self.HEIGHT) <= 1, raster.height
        checked = 0
        for row in range(self.HEIGHT):
            for column in range(self.WIDTH):
                x, y = column + 0.5, row + 0.5
                if self.axis == "up":
                    y = self.HEIGHT - y
                distance = min(self.signed_distances(x, y))
                if abs(distance) <= margin:
                    continue
                checked += 1
                assert raster.rows[row][column] == (distance < 0), (
                    f"pixel {column},{row}, {distance} from the edge")
        assert checked > self.WIDTH * self.HEIGHT * 0.9, checked


class Workplace:
    """A folder that goes away."""

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory()
        return self

    def __exit__(self, *unused):
        self.folder.cleanup()

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()


def sample(name):
    return os.path.join(SAMPLES, name)
