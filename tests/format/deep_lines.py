"""Section "Deep centrelines" of docs/format.md."""
from centreline_starts import Starts, bits
from centrelines import Centrelines, Lines, first_weights
from deep import Deep
from entropy import K, M64
from line_records import line_records
from turns import mix


class DeepLines(Lines):
    def __init__(self, pixels, columns, rows, weights):
        super().__init__(pixels, columns, rows, weights)
        vectors = []
        for w in weights[:8]:
            def part(first, other):
                return [int(w[first + i] * 4 / 5) if i < 8 else other
                        for i in range(23)]
            vectors.append(part(0, 226) + part(8, 86) + [65] * 23 + [0])
        self.deep = Deep(23, 0, self.T + 1, 3, vectors)
        for i, index, check, counters in line_records():
            for counter in counters:
                self.deep.know(i, index << 12 | check >> 4, *counter)

    def look(self, start):
        super().look(start)
        x, y = self.head()
        h, run = self.last, [min(r, 255) for r in self.run]
        base = self.d % 2 + 2 * min(len(self.trail) - 1, 3)
        all_, near, _ = self.pixels.patch(x, y, self.d // 2)
        grid = (64 * self.columns.level(x, self.pixels.width)
                + self.rows.level(y, y + 1))
        verdict = self.segment.verdict(self.d)
        level, guess = self.match.level(), self.match.guess()
        bends = sum(b << 3 * i for i, b in enumerate(self.bend))
        runs = [min(r, 127) for r in self.run]
        self.values += [
            mix(run[0] << 8 | run[1], mix(bends & 63, base)),
            mix(self.chord(32), mix(self.bulge(32) << 9 | h(3), base)),
            mix(h(12), base),
            mix(runs[0] << 21 | runs[1] << 14 | runs[2] << 7 | runs[3],
                mix(bends, base)),
            mix(verdict << 8 | min(self.segment.previous, 255),
                mix(h(2), base)),
            mix(self.chord(16), mix(self.bulge(16) << 9 | h(3), base)),
            mix(verdict, mix(grid, base)),
            mix(all_, mix(h(4), base)), mix(h(20), base),
            mix(verdict, mix(run[0] << 8 | run[1], bends << 3 | base)),
            mix(self.chord(8), mix(self.chord(60), base)),
            mix(self.chord(24), mix(self.bulge(24) << 8 | run[0], base)),
            mix(verdict, mix(h(8), base)),
            mix(grid, mix(run[0] << 3 | h(1), base)),
            mix(near, mix(8 * level + guess, base))]
        self.near = 8 * ((near * K & M64) >> 54)
        self.chosen += [8 * min(bits(run[0]), 7), self.near, 8 * verdict]
        self.level = level

    def ask(self, first):
        self.ask_for([mix(v, first) if first else v for v in self.values])
        self.more = first != 0

    def ask_for(self, values):
        self.deep.ask([(v + i if i < 8 else mix(v, i)) * K & M64
                       for i, v in enumerate(values)])

    def decide(self, coder, node):
        if node == 7:
            self.ask_for([mix(v, 256 + self.before) for v in self.values])
        self.before = node
        chosen = [c + node + s * self.more for c, s in
                  zip(self.chosen, self.SIZES + (64, 0, 0))]
        return self.deep.decode(coder, [], chosen,
                                [chosen[4], chosen[0], self.near + node],
                                8 * self.level + node, node)


class DeepDecisions:
    def __init__(self, weights):
        self.deep = Deep(5, 0, 14, 2, [
            weights[0:10:2] + weights[1:10:2] + [0] * 5 + [weights[10]]])

    def decode(self, coder, values, node, selectors):
        self.deep.ask_mixed([mix(v, node) for v in values])
        return self.deep.decode(coder, [], selectors, selectors[:2], 0)


class DeepCentrelines(Centrelines):
    def make_models(self, *known):
        weights, of_starts = first_weights()
        self.lines = DeepLines(*known, weights)
        self.starts = Starts(*known, of_starts)
        self.starts.any, self.starts.span, self.starts.one = map(
            DeepDecisions, of_starts)
