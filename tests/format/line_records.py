"""Section "Table 1 of coder 3" of docs/format.md."""
import pathlib
import re
import zlib

from entropy import Damaged, squash
from table import six_bits

SOURCE = (pathlib.Path(__file__).resolve().parents[2]
          / "src/codec/centreline_warm_start_table.cpp")
CRC = 0x239C2189
AGES = 1, 2, 4, 7, 11, 16, 22, 30


def line_records():
    """(context, index, check, [(node, p, n), ..]) of all records."""
    text = SOURCE.read_text("ascii").split("const Table ")[1]
    counts, records = re.search(r"{{(.*?)}}(.*)", text, re.S).groups()
    records = "".join(re.findall(r'"([^"]*)"', records))
    if zlib.crc32(records.encode()) != CRC:
        raise Damaged(f"{SOURCE} is not table 1")
    bits = six_bits(records)
    at = 0

    def take(characters):
        nonlocal at
        value = 0
        for _ in range(characters):
            value, at = value << 6 | bits[at], at + 1
        return value

    for context, count in enumerate(re.findall(r"\d+", counts)):
        index = 0
        for _ in range(int(count)):
            passed = take(1)
            index += take(3) if passed == 63 else passed
            told = take(3)
            counters = []
            for _ in range((told & 3) + 1):
                which, level = take(1), take(1)
                counters.append((which >> 3, squash(72 * (level - 32)),
                                 AGES[which & 7]))
            yield context, index, told >> 2, counters
            index += 1
