"""Section "Coder 3: centrelines" of docs/format.md, and what it takes from
"Coder 16: chains"."""
import pathlib
import re

from centreline_starts import Pixels, Ruler, Starts, bits
from chain_segment import Match8, Segment8
from decisions import RAW, mix
from entropy import (K, M64, STRETCH, Damaged, Mixer, Refiner, clamp, move,
                     squash)
from line_records import line_records

DX, DY = (1, 1, 0, -1, -1, -1, 0, 1), (0, -1, -1, -1, 0, 1, 1, 1)
ORDER = 0, 1, 7, 2, 6, 3, 5, 4
NODE = {0: 0, 1: 1, 7: 2, 2: 3, 6: 4, 5: 5}
SOURCE = (pathlib.Path(__file__).resolve().parents[2]
          / "src/codec/centreline_weights.cpp")


def first_weights():
    text = SOURCE.read_text("utf-8").split("clang-format")[1]
    vectors = [[int(n) for n in re.findall(r"-?\d+", row)]
               for row in re.findall(r"\{([-\d,\s]+)\}", text)]
    return vectors[:16], vectors[16:]


def turned(x, y, quarters):
    for _ in range(quarters):
        x, y = -y, x
    return x, y


class Lines:
    """Pixels around."""

    SIZES = 512, 1024, 256, 256

    def __init__(self, pixels, columns, rows, weights):
        self.pixels, self.columns, self.rows = pixels, columns, rows
        size = pixels.width * pixels.rows
        self.T = 11 if size < 40000 else 13 if size < 2000000 else 15
        self.slots = [{} for _ in range(8)]
        for i, index, check, counters in line_records():
            for counter in counters:
                self.know(i, index, check, *counter)
        self.mixer = Mixer([2 * s for s in self.SIZES], weights[:8])
        later = [[clamp(4 * w, -32768, 32767) for w in v]
                 for v in weights[8:]]
        for vectors, s in zip(self.mixer.sets, self.SIZES):
            vectors[s:] = [[later[k % 8], 0] for k in range(s, 2 * s)]
        self.refiners = Refiner(), Refiner()
        self.match = Match8()

    def slot(self, i, at, check):
        slot = self.slots[i].setdefault(at, [0, [[RAW, 0] for _ in range(8)]])
        if slot[0] != check:
            slot[:] = check, [[RAW, 0] for _ in range(8)]
        return slot[1]

    def know(self, i, index, check, node, p, n):
        self.slot(i, index >> 16 - self.T, check)[node][:] = p, n

    def begin(self, x, y, d):
        self.trail, self.d = [(x, y, 0)], d
        self.h, self.run, self.bend = 0x4924924924924924, [0] * 4, [0] * 3
        self.segment = Segment8()

    def advance(self, t):
        self.match.push(t)
        self.h = (self.h * 8 + t) & M64
        if t == 0:
            self.run[0] += 1
        else:
            self.run = [0] + self.run[:3]
            self.bend = [t] + self.bend[:2]
        self.d = (self.d + t) % 8
        self.segment.push(self.d)
        (x0, y0, _), (x, y, area) = self.trail[0], self.trail[-1]
        u, v = DX[self.d], DY[self.d]
        self.trail.append((x + u, y + v,
                           area + (y - y0) * u - (x - x0) * v))

    def head(self):
        return self.trail[-1][:2]

    def last(self, k):
        return self.h & (1 << 3 * k) - 1

    def chord(self, k):
        if len(self.trail) <= k:
            return 0
        (x, y, _), (i, j, _) = self.trail[-1], self.trail[-1 - k]
        x, y = turned(x - i, y - j, self.d // 2)
        return 512 * (x + 128) + (2 * (y + 128) | self.d % 2)

    def bulge(self, k):
        if len(self.trail) <= k:
            return 0
        (x, y, area), (i, j, before) = self.trail[-1], self.trail[-1 - k]
        x0, y0, _ = self.trail[0]
        b = area - before - ((j - y0) * (x - i) - (i - x0) * (y - j))
        n = bits(abs(b))
        level = n if n < 2 else 2 * n - 2 + (abs(b) >> (n - 2) & 1)
        return min(level, 15) + 16 * (b < 0)

    def look(self, start):
        x, y = self.head()
        d, h = self.d, self.last
        steps = len(self.trail) - 1
        base = d % 2 + 2 * min(steps, 3)
        all_, near, outer = self.pixels.patch(x, y, d // 2)
        grid = (64 * self.columns.level(x, self.pixels.width)
                + self.rows.level(y, y + 1))
        verdict = self.segment.verdict(d)
        level, guess = self.match.level(), self.match.guess()
        i, j = start[0] - x, start[1] - y
        home = (0 if abs(i) > 20 or abs(j) > 20
                else 128 * (i + 32) + j + 32)
        self.values = [
            mix(near, mix(h(2), base)), mix(near, mix(h(6), base)),
            mix(all_, mix(h(1), base)), mix(verdict, mix(h(4), base)),
            mix(home, mix(h(1), d)) if home else mix(8 * h(3) + d, 99),
            mix(grid, mix(near, d)), mix(grid, mix(h(2), base)),
            mix(8 * level + guess, base)]
        self.chosen = [8 * h(2), 64 * level + 8 * guess + 512 * (outer != 0),
                       8 * (verdict >> 5 & 31),
                       16 * min(steps, 15) + 8 * (home != 0)]

    def ask(self, first):
        """The slots of all contexts; `first`: 0, or 2^t of the first pixel."""
        self.found = []
        for i, value in enumerate(self.values):
            hashed = (mix(value, first) if first else value) + i
            hashed = hashed * K & M64
            self.found.append(self.slot(i, hashed >> (64 - self.T),
                                        hashed >> 32 & 65535))
        self.more = first != 0

    def decide(self, coder, node):
        counters = [slot[node] for slot in self.found]
        inputs = ([STRETCH[p >> 4] for p, _ in counters]
                  + [(p - 32768) * 51 * min(n, 30) >> 16
                     for p, n in counters])
        chosen = [c + node + s * self.more
                  for c, s in zip(self.chosen, self.SIZES)]
        x = self.mixer.mean(inputs, chosen)
        p = 2 * squash(x) + sum(r.refine(x, c) for r, c in
                                zip(self.refiners, chosen[::3]))
        bit = coder.decode(clamp(p // 4, 4, 65532), "")
        for refiner in self.refiners:
            refiner.learn(bit)
        self.mixer.learn(bit)
        for counter in counters:
            counter[:] = move(*counter, bit), min(255, counter[1] + 1)
        return bit

    def decode(self, coder, unknown, start):
        """The turns of the unknown pixels that are ink."""
        self.look(start)
        self.ask(0)
        rest = [t for t in ORDER if t in unknown]
        while rest:
            turn = rest.pop(0)
            if self.decide(coder, NODE[turn]):
                break
        else:
            return []
        if not rest or not self.decide(coder, 6 if turn == 0 else 7):
            return [turn]
        self.ask(1 << turn)
        found = []
        for t in rest:
            last = t == rest[-1] and not found
            if last or self.decide(coder, NODE[t]):
                found.append(t)
        return [turn] + found


class Centrelines:
    """Order of pixels."""

    def __init__(self, coder, width, rows):
        self.coder, self.pixels = coder, Pixels(width, rows)
        self.columns, self.rows = Ruler(), Ruler()
        self.make_models(self.pixels, self.columns, self.rows)

    def make_models(self, *known):
        weights, of_starts = first_weights()
        self.lines = Lines(*known, weights)
        self.starts = Starts(*known, of_starts)

    def run(self, image):
        told, width = self.pixels.told, self.pixels.width
        for y in range(self.pixels.rows):
            self.starts.begin_row(y)
            for word in range((width + 63) // 64):
                while unknown := [x for x in
                                  range(64 * word, min(64 * word + 64, width))
                                  if (x, y) not in told]:
                    x = self.starts.decode(self.coder, unknown, word)
                    told.update(((i, y), 0) for i in unknown
                                if x is None or i < x)
                    if x is not None:
                        self.follow(x, y)
            image[y] = [told[x, y] for x in range(width)]

    def vertex(self, x, y):
        self.columns.add(x)
        self.rows.add(y)

    def follow(self, x, y):
        start, stack = (x, y), []
        self.pixels.told[start] = 1
        self.vertex(x, y)
        self.lines.begin(x, y, 0)
        while True:
            self.line(start, stack)
            while stack and stack[-1][:2] in self.pixels.passed:
                stack.pop()
            if not stack:
                return
            x, y, direction, turn = stack.pop()
            self.lines.begin(x - DX[direction], y - DY[direction],
                             (direction - turn) % 8)
            self.lines.advance(turn)

    def line(self, start, stack):
        pixels, lines = self.pixels, self.lines
        while True:
            x, y = lines.head()

            def at(turn, x=x, y=y, d=lines.d):
                direction = (d + turn) % 8
                return x + DX[direction], y + DY[direction]

            unknown = [t for t in range(8) if pixels.get(*at(t)) is None]
            found = []
            if unknown:
                found = lines.decode(self.coder, unknown, start)
                pixels.told.update((at(t), int(t in found)) for t in unknown)
            pixels.passed.add((x, y))
            ways = found or [t for t in ORDER if pixels.get(*at(t))
                             and at(t) not in pixels.passed]
            if not ways:
                return
            for turn in reversed(found[1:]):
                if len(stack) == 1 << 14:
                    raise Damaged("too many branches")
                stack.append((*at(turn), (lines.d + turn) % 8, turn))
            if len(lines.trail) > 1 and (not found or 2 <= ways[0] <= 6):
                self.vertex(x, y)
            lines.advance(ways[0])
