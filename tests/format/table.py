"""Section "Table 1" of docs/format.md."""
import pathlib
import re
import zlib

from entropy import Damaged, squash

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "src/codec"
CRCS = {"small": (0xBAA9D351, 0x0CFBE4FA),
        "large": (0x50A01F69, 0x5C3E581E),
        "clean": (0x32A83E3D, 0x3CBE4561)}


class Table:
    AGES = (0, 1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 18, 22, 26, 30, 40)

    def __init__(self, part):
        source = FOLDER / f"warm_start_{part}.cpp"
        text = source.read_text("ascii").split("const Table ")[1]
        records = "".join(re.findall(r'"([^"]*)"', text))
        parts = [
            [int(v) for v in re.findall(r"-?\d+", body)] for body in
            re.findall(r"{{(.*?)}}", re.sub(r'"[^"]*"', "", text), re.S)]
        numbers = "".join(f"{v} " for values in parts for v in values)
        if tuple(zlib.crc32(t.encode()) for t in (
                records, numbers)) != CRCS[part]:
            raise Damaged(f"{source} is not table 1")
        counts, turn, start, flags = parts
        self.groups, at = [], 0
        for count in counts:
            self.groups.append([self.record(records[i:i + 8]) for i in
                                range(at, at + 8 * count, 8)])
            at += 8 * count
        self.vectors = [self.vector(records[i:i + 34]) for i in
                        range(at, len(records), 34)]
        self.turn, self.start = (turn[:32], turn[32:]), (start,)
        self.flags = [list(pair) for pair in zip(flags[::2], flags[1::2])]

    @staticmethod
    def six_bits(characters):
        return [44 if c == "p" else ord(c) - 48 for c in characters]

    def vector(self, characters):
        high, low, *steps = self.six_bits(characters)
        return high << 6 | low, [32 * (step - 32) for step in steps]

    def record(self, characters):
        bits = 0
        for six in self.six_bits(characters):
            bits = bits << 6 | six
        p = [squash(72 * ((bits >> shift & 63) - 32)) for shift in (14, 8)]
        n = [self.AGES[bits >> shift & 15] for shift in (4, 0)]
        return bits >> 32, bits >> 20 & 0xFFF, p, n
