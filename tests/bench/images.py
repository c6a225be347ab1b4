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
    """The images of a concatenated P4 / two-valued P5 stream, as Pbm."""
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
        elif magic == b"P5":
            maxval, at = _token(data, at)
            size = width * height
            grey = data[at + 1:at + 1 + size]
            if int(maxval) > 255 or set(grey) - {0, int(maxval)}:
                raise ValueError("more than two values")
            pages.append(_pack(width, height, grey))
            at += 1 + size
        else:
            raise ValueError("colour or unknown kind of image")
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
