"""Section "Table 1" of docs/format.md."""
import pathlib
import re
import zlib

from entropy import Damaged, squash

SOURCE = (pathlib.Path(__file__).resolve().parents[2]
          / "src/codec/warm_start_table.cpp")
CRC = 0x28CD8FB2


class Table:
    AGES = (0, 1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 18, 22, 26, 30, 40)

    def __init__(self):
        text = SOURCE.read_text("ascii")

        def numbers(name):
            body = re.search(name + r" = \{\{(.*?)\}\};", text, re.S)[1]
            return [int(v) for v in re.findall(r"-?\d+", body)]

        body = re.search(r"kRecords =(.*?)\";\n", text, re.S)[1] + '"'
        records = "".join(re.findall(r'"([^"]*)"', body))
        if zlib.crc32(records.encode()) != CRC:
            raise Damaged(f"{SOURCE} is not table 1")
        self.groups, at = [], 0
        for count in numbers("kCounts"):
            self.groups.append([self.record(records[i:i + 8]) for i in
                                range(at, at + 8 * count, 8)])
            at += 8 * count
        turn = numbers("kTurnWeights")
        self.turn, self.start = (turn[:32], turn[32:]), (
            numbers("kStartWeights"),)
        flat = numbers("kFlagStart")
        self.flags = [list(pair) for pair in zip(flat[::2], flat[1::2])]

    def record(self, characters):
        bits = 0
        for c in characters:
            bits = bits << 6 | (44 if c == "p" else ord(c) - 48)
        p = [squash(72 * ((bits >> shift & 63) - 32)) for shift in (14, 8)]
        n = [self.AGES[bits >> shift & 15] for shift in (4, 0)]
        return bits >> 32, bits >> 20 & 0xFFF, p, n
