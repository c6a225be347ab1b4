"""Bits, numbers, models of decisions and table 1 of "Coder 24: paths" of
docs/format.md."""
import pathlib
import re

from decisions import RAW, Vectors, mix
from entropy import K, STRETCH, Mixer, Refiner, clamp, squash, top, update

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "src/codec"
LEVELS = (-1500, -1000, -720, -510, -350, -220, -120, -36, 36, 120, 220, 350,
          510, 720, 1000, 1500)
AGES = 3, 7, 14, 28


def texts_of(name):
    """The texts of a table, each as a list of numbers of six bits."""
    source = (FOLDER / name).read_text("ascii").split("Table kTable")[1]
    texts = re.findall(r'(?:"[^"]*"\s*)+', source)
    return [[number_of(c) for c in "".join(re.findall(r'"([^"]*)"', text))]
            for text in texts]


def number_of(character):
    return 44 if character == "p" else ord(character) - 48


def bit(coder, counter):
    found = coder.decode(clamp(counter[0], 16, 65520), "")
    update(counter, found)
    return found


class Set:
    """A set of numbers of coders 16 and 24."""

    def __init__(self):
        self.L, self.M, self.sign = {}, {}, [RAW, 0]

    def number(self, coder):
        w = 1
        while w <= 49 and bit(coder, self.L.setdefault(w, [RAW, 0])):
            w += 1
        u = 1
        for i in range(w - 1):
            counter = self.M.setdefault((w, u), [RAW, 0])
            u = 2 * u + (bit(coder, counter) if i < 3
                         else coder.decode(RAW, ""))
        return u - 1

    def signed(self, coder):
        v = self.number(coder)
        return -v if v and bit(coder, self.sign) else v


class Model:
    """Models of decisions: refined, with 18 contexts and 3 sets."""

    def __init__(self):
        self.tables = [{} for _ in range(18)]
        self.mixer = Mixer((1, 1, 1), [[0] * 40])
        first = [4 * (5734 // 18)] * 36 + [0] * 4
        self.mixer.sets = [Vectors(list(first)) for _ in range(3)]
        self.refiners = Refiner(), Refiner()

    def decode(self, coder, values, node, selectors):
        counters, x = [], []
        for i, (table, value) in enumerate(zip(self.tables, values)):
            name = top(16, mix(value + i, node) * K)
            counter = table.setdefault(name, [RAW, 0])
            counters.append(counter)
            p, n = counter
            x += STRETCH[p >> 4], (p - 32768) * 51 * min(n, 30) >> 16
        selectors = [s % 1024 for s in selectors]
        mean = self.mixer.mean(x + [77, 0, 0, 0], selectors)
        p = 2 * squash(mean) + sum(r.refine(mean, s) for r, s in
                                   zip(self.refiners, selectors))
        found = coder.decode(clamp(p // 4, 8, 65528), "")
        for refiner in self.refiners:
            refiner.learn(found)
        self.mixer.learn(found)
        for counter in counters:
            update(counter, found)
        return found


def table_1(models):
    """Table 1 of coder 24."""
    counters, weights = texts_of("path_warm_start_table.cpp")
    numbers = iter(counters)
    for model in models:
        for table in model.tables:
            index = 0
            while (passed := next(numbers)) != 63 or (passed := 64 * next(
                    numbers)):
                index += passed
                if passed < 62:
                    v = next(numbers)
                    table[index] = [squash(LEVELS[v // 4]), AGES[v % 4]]
                    index += 1
    for at in range(0, len(weights), 78):
        record = weights[at:at + 78]
        part, set_ = record[0], record[1]
        numbers = [a << 6 | b for a, b in zip(record[2::2], record[3::2])]
        vector = [(v - 2048) * 16 for v in numbers[1:]] + [0] * 3
        mixer = models[part].mixer
        if numbers[0] == 4095:
            mixer.sets = [Vectors(list(vector)) for _ in range(3)]
        else:
            mixer.sets[set_][numbers[0]] = [vector, 768]
