"""Section "Table 1" of docs/format.md."""
import pathlib
import re
import zlib

from entropy import Damaged, squash

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "src/codec"
CRCS = {"small": (0xBAA9D351, 0x0CFBE4FA),
        "large": (0x50A01F69, 0x5C3E581E),
        "clean": (0x32A83E3D, 0x3CBE4561),
        "deep": (0x498C47E7, 0x408EE2AF)}



def read(source, name):
    """The text between the quotes and the numbers of each array."""
    text = source.read_text("ascii").split(f" {name} = ")[1]
    records = "".join(re.findall(r'"([^"]*)"', text))
    parts = [
        [int(v) for v in re.findall(r"-?\d+", body)] for body in
        re.findall(r"{{(.*?)}}", re.sub(r'"[^"]*"', "", text), re.S)]
    numbers = "".join(f"{v} " for values in parts for v in values)
    return records, parts, (zlib.crc32(records.encode()),
                            zlib.crc32(numbers.encode()))


def six_bits(characters):
    return [44 if c == "p" else ord(c) - 48 for c in characters]


def number_of(characters):
    number = 0
    for six in six_bits(characters):
        number = number << 6 | six
    return number


def steps_of(characters):
    return [32 * (step - 32) for step in six_bits(characters)]


class Table:
    AGES = (0, 1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 18, 22, 26, 30, 40)

    def __init__(self, part):
        source = FOLDER / f"warm_start_{part}.cpp"
        records, parts, crcs = read(source, f"k{part.capitalize()}")
        if crcs != CRCS[part]:
            raise Damaged(f"{source} is not table 1")
        counts, turn, start, flags = parts
        self.groups, at = self.grouped(records, counts)
        self.vectors = [self.vector(records[i:i + 34]) for i in
                        range(at, len(records), 34)]
        self.turn, self.start = (turn[:32], turn[32:]), (start,)
        self.flags = [list(pair) for pair in zip(flags[::2], flags[1::2])]

    @staticmethod
    def vector(characters):
        return number_of(characters[:2]), steps_of(characters[2:])

    def grouped(self, records, counts):
        """The records of each context, and where they end."""
        groups, at = [], 0
        for count in counts:
            groups.append([self.record(records[i:i + 8]) for i in
                           range(at, at + 8 * count, 8)])
            at += 8 * count
        return groups, at

    def record(self, characters):
        bits = number_of(characters)
        p = [squash(72 * ((bits >> shift & 63) - 32)) for shift in (14, 8)]
        n = [self.AGES[bits >> shift & 15] for shift in (4, 0)]
        return bits >> 32, bits >> 20 & 0xFFF, p, n


class DeepTable(Table):
    """What the deep turns of revision 1 begin with."""

    def __init__(self):  # pylint: disable=super-init-not-called
        source = FOLDER / "deep_warm_start.cpp"
        records, parts, crcs = read(source, "kDeepTurns")
        if crcs != CRCS["deep"]:
            raise Damaged(f"{source} is not table 1")
        counts, weights = parts
        self.groups, at = self.grouped(records, counts)
        self.first = weights[:96], weights[96:]
        self.vectors = [(number_of(records[i:i + 3]),
                         steps_of(records[i + 3:i + 99]))
                        for i in range(at, len(records), 99)]
