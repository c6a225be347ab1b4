"""Section "Table 1 of coder 2" of docs/format.md."""
import pathlib
import re
import zlib

from entropy import Damaged
from table import six_bits

SOURCE = (pathlib.Path(__file__).resolve().parents[2]
          / "src/codec/shape_warm_start_table.cpp")
CRC = 0x129CE069


def begin(mixer, name):
    """The vectors of a mixer as those of `name` begin."""
    text = SOURCE.read_text("ascii").split("shape_warm {")[1]
    if zlib.crc32("".join(re.findall(r'"([^"]*)"', text)).encode()) != CRC:
        raise Damaged(f"{SOURCE} is not table 1")
    part = text.split(f"Start {name} =")[1].split("};")[0]
    shared = [int(n) for n in re.findall(r"-?\d+", part.split('"')[0])]
    vectors = "".join(re.findall(r'"([^"]*)"', part))
    numbered = [vector for set_ in mixer.sets for vector in set_]
    for vector in numbered:
        vector[0] = [4 * w for w in shared]
    for at in range(0, len(vectors), 18):
        high, low, *steps = six_bits(vectors[at:at + 18])
        numbered[high << 6 | low][0] = [
            4 * (w + 32 * (step - 32)) for w, step in zip(shared, steps)]
