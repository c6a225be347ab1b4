"""Section "Table 1" of docs/format.md."""
import pathlib
import re
import zlib

from entropy import Damaged, squash

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "src/codec"
CRC = {"small": 0x619FB32C, "large": 0xD3B15ED2}


class Table:
    AGES = (0, 1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 18, 22, 26, 30, 40)

    def __init__(self, part):
        source = FOLDER / f"warm_start_{part}.cpp"
        text = source.read_text("ascii").split("const Table ")[1]
        records = "".join(re.findall(r'"([^"]*)"', text))
        if zlib.crc32(records.encode()) != CRC[part]:
            raise Damaged(f"{source} is not table 1")
        counts, turn, start, flags = (
            [int(v) for v in re.findall(r"-?\d+", body)] for body in
            re.findall(r"{{(.*?)}}", re.sub(r'"[^"]*"', "", text), re.S))
        self.groups, at = [], 0
        for count in counts:
            self.groups.append([self.record(records[i:i + 8]) for i in
                                range(at, at + 8 * count, 8)])
            at += 8 * count
        self.turn, self.start = (turn[:32], turn[32:]), (start,)
        self.flags = [list(pair) for pair in zip(flags[::2], flags[1::2])]

    def record(self, characters):
        bits = 0
        for c in characters:
            bits = bits << 6 | (44 if c == "p" else ord(c) - 48)
        p = [squash(72 * ((bits >> shift & 63) - 32)) for shift in (14, 8)]
        n = [self.AGES[bits >> shift & 15] for shift in (4, 0)]
        return bits >> 32, bits >> 20 & 0xFFF, p, n
