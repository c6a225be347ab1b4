"""Section "Models of decisions" of docs/format.md, and what coders 24 and 28
take from "Coder 16: chains"."""

from entropy import K, M64, STRETCH, Mixer, clamp, update

RAW = 32768


def mix(a, b):
    a, b = a & M64, b & M64
    return ((a * K & M64) ^ (b * 0xC2B2AE3D27D4EB4F + 0x165667B19E3779F9 & M64)
            ^ a >> 29)


def digits(value):
    """w(v)."""
    return value.bit_length()


class Decisions:
    """A model with N contexts."""

    def __init__(self, contexts, table_bits):
        self.shift = 64 - table_bits
        self.tables = [{} for _ in range(contexts)]
        self.inputs = -(-(2 * contexts + 1) // 8) * 8
        self.empty = [0] * (self.inputs - 2 * contexts - 1)
        first = [5734 // contexts] * (2 * contexts)
        first += [0] * (self.inputs - 2 * contexts)
        self.mixer = Mixer((1024, 1024), [first])
        # A vector that was never chosen is the first one: made when it is.
        self.mixer.sets = [Vectors(self.mixer.sets[0][0][0])
                           for _ in range(2)]

    def decode(self, coder, values, node, selectors):
        counters, inputs = [], []
        for i, (table, value) in enumerate(zip(self.tables, values)):
            slot = (mix(value + i, node) * K & M64) >> self.shift
            counter = table.setdefault(slot, [RAW, 0])
            counters.append(counter)
            p, n = counter
            inputs += STRETCH[p >> 4], (p - 32768) * 51 * min(n, 30) >> 16
        inputs += [77] + self.empty
        p = self.mixer.predict(inputs, [s % 1024 for s in selectors])
        bit = coder.decode(clamp(p, 8, 65528), "")
        self.mixer.learn(bit)
        for counter in counters:
            update(counter, bit)
        return bit


class Vectors(dict):
    def __init__(self, first):
        super().__init__()
        self.first = first

    def __missing__(self, key):
        self[key] = [list(self.first), 0]
        return self[key]
