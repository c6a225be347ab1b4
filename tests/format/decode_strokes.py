#!/usr/bin/env python3
"""A second decoder of coder 25, written from docs/format.md alone.

    decode_strokes.py IN.ustp...

Reads short forms of one page of strokes each and compares the CRC of its
canonical bytes. Plain and slow. The docstrings name the page's sections.
"""
import copy
import pathlib
import sys
import zlib

from decode_ink import skip_details, varint
from entropy import Damaged, Interval
from strokes import Models, Strokes, trained


def canonical(paths):
    """Checksums."""
    def numbers(*values):
        return b"".join((v & 0xFFFFFFFF).to_bytes(4, "little") for v in values)

    data = b""
    for path in paths:
        data += numbers(*path.origin) + bytes([path.closed])
        data += numbers(path.pen) + len(path.elements).to_bytes(8, "little")
        for end, centre, clockwise in path.elements:
            data += bytes([1 + clockwise if centre else 0]) + numbers(*end)
            data += numbers(*(centre or (0, 0)))
    return data


def stated_table(data, at, head):
    """The rest of Path head, Coder name."""
    if head & 3 == 1:
        _, at = varint(data, at)
    for bit in (32, 16):
        if head & bit:
            _, at = varint(data, at)
    if data[at] not in (25, 25 | 128):
        raise Damaged("another coder than 25")
    return data[at] >> 7, at + 1


def decode(data, start):
    """Start of every file, Short form. Returns the paths."""
    flags = data[4]
    if data[:4] != b"\xf5\x55\x0d\x0a" or flags & 0xD3 != 0x80:
        raise Damaged("not a short form with paths")
    _, at = varint(data, 5)
    if not flags & 4:
        _, at = varint(data, at)
    if flags & 0x20:
        at = skip_details(data, at)
    head, at = data[at], at + 1
    if flags & 8 or head & 128:
        raise Damaged("another coder than 25")
    table = 1
    if head != 3:
        table, at = stated_table(data, at, head)
    count, at = varint(data, at)
    elements, at = varint(data, at)
    stored, payload = data[at:at + 4], data[at + 4:]
    coder = Interval(payload, False)
    models = copy.deepcopy(start) if table else Models()
    paths = Strokes(coder, models, count, elements).run()
    coder.check_end()
    if zlib.crc32(data[4:at] + canonical(paths)) != int.from_bytes(
            stored, "little"):
        raise Damaged("checksum")
    return paths


def main():
    start = trained()
    for name in sys.argv[1:]:
        try:
            paths = decode(pathlib.Path(name).read_bytes(), start)
        except (Damaged, IndexError) as error:
            sys.exit(f"{name}: {error}")
        print(f"{name}: {len(paths)} paths")


if __name__ == "__main__":
    main()
