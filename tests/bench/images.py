"""Bilevel images for the benchmarks: files to PBM pages, PBM compared.

Needs netpbm. Only two-valued images are accepted: the figures are lossless.
"""

import os
import subprocess

KINDS = {".tif": "tifftopnm", ".tiff": "tifftopnm", ".png": "pngtopnm",
         ".pbm": "cat"}


class Pbm:
    """A raw PBM (P4): width, height and packed rows, 1 is ink."""

    def __init__(self, width, height, rows):
        self.width = width
        self.height = height
        self.rows = rows

    @property
    def pixels(self):
        return self.width * self.height

    def file(self):
        return b"P4\n%d %d\n" % (self.width, self.height) + self.rows

    def grey_file(self):
        """The same as PGM, ink black."""
        stride = (self.width + 7) // 8
        grey = bytearray(b"P5\n%d %d\n255\n" % (self.width, self.height))
        for y in range(self.height):
            row = int.from_bytes(self.rows[y * stride:(y + 1) * stride], "big")
            bits = bin(row | 1 << stride * 8)[3:3 + self.width]
            grey += bits.encode().translate(
                bytes([0]) * 48 + b"\xff\0" + bytes([0]) * 206)
        return bytes(grey)

    def same_ink(self, other):
        """Equal size and pixels; the padding of each row does not count."""
        if (self.width, self.height) != (other.width, other.height):
            return False
        if self.rows == other.rows:
            return True
        if self.width % 8 == 0:
            return False
        stride = (self.width + 7) // 8
        mask = 0xFF << (8 - self.width % 8) & 0xFF

        def last_masked(rows):
            out = bytearray(rows)
            for i in range(stride - 1, len(out), stride):
                out[i] &= mask
            return out

        return last_masked(self.rows) == last_masked(other.rows)


def parse_pnm(data):
    """The images of a concatenated stream of P4, and of P5 and P6 that are
    black and white, as Pbm."""
    pages = []
    at = 0
    while at < len(data):
        magic, at = _token(data, at)
        width, at = _token(data, at)
        height, at = _token(data, at)
        width, height = int(width), int(height)
        if magic == b"P4":
            size = (width + 7) // 8 * height
            pages.append(Pbm(width, height, data[at + 1:at + 1 + size]))
            at += 1 + size
        elif magic in (b"P5", b"P6"):
            maxval, at = _token(data, at)
            samples = 3 if magic == b"P6" else 1
            size = width * height * samples
            values = data[at + 1:at + 1 + size]
            grey = values[::samples]
            if any(values[k::samples] != grey for k in range(1, samples)):
                raise ValueError("colour")
            if int(maxval) > 255 or set(grey) - {0, int(maxval)}:
                raise ValueError("more than two values")
            pages.append(_pack(width, height, grey))
            at += 1 + size
        else:
            raise ValueError("unknown kind of image")
    return pages


def _token(data, at):
    while True:
        while data[at:at + 1].isspace():
            at += 1
        if data[at:at + 1] != b"#":
            break
        at = data.index(b"\n", at)
    end = at
    while end < len(data) and not data[end:end + 1].isspace():
        end += 1
    if end == at:
        raise ValueError("truncated image")
    return data[at:end], end


def _pack(width, height, grey):
    stride = (width + 7) // 8
    ink = grey.translate(bytes([49]) + bytes([48]) * 255)  # 0 -> "1"
    rows = bytearray()
    for y in range(height):
        bits = ink[y * width:(y + 1) * width].ljust(stride * 8, b"0")
        rows += int(bits, 2).to_bytes(stride, "big")
    return Pbm(width, height, bytes(rows))


def read_pages(path):
    """The pages of an image file. ValueError if one is not two-valued."""
    command = KINDS[os.path.splitext(path)[1].lower()]
    done = subprocess.run([command, path], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, check=False)
    if done.returncode != 0:
        raise ValueError(done.stderr.decode(errors="replace").strip())
    return parse_pnm(done.stdout)


def find_sets(folders):
    """{set name: [files]} of folders: every folder that holds images."""
    sets = {}
    for top in folders:
        for folder, below, files in sorted(os.walk(top)):
            below.sort()
            images = sorted(f for f in files
                            if os.path.splitext(f)[1].lower() in KINDS)
            if images:
                name = os.path.basename(os.path.abspath(folder))
                sets.setdefault(name, []).extend(
                    os.path.join(folder, f) for f in images)
    return sets
