"""Sections "Deep turns" and "Deep far starts" of docs/format.md."""
from deep import Deep
from edges import Edges
from entropy import K, M64, STRETCH, clamp, top, update
from segment import Match
from starts import StartModel
from turns import DX, DY, TurnModel, mix


def level_of(probability):
    return STRETCH[probability >> 4] + 2048 >> 6


def level(match):
    return 4 * match.level() + match.guess()


class DeepTurnModel(TurnModel):
    SIZES = 64, 1024, 1024, 1024, 2048, 2048, 1024, 512, 128, 1024

    def __init__(self, cracks, table_bits, table, own=None):
        super().__init__(cracks, table_bits, table)
        self.longer = Match(32)
        if own:
            self.begin_with(own, table_bits)
            return
        vectors = []
        for w in table.turn:
            def part(first, other):
                return [int(w[first + i] * 4 / 5) if i < 15 else other
                        for i in range(30)]
            vectors.append(part(0, 173) + part(16, 66) + [50] * 30
                           + [w[15], 300, 0, 0])
        self.deep = Deep(30, 3, table_bits, 5, vectors)
        for i in range(15):
            for index, check, p, n in table.groups[i]:
                for node in (0, 1):
                    self.deep.know(i, index << 12 | check, node, p[node],
                                   n[node])

    def begin_with(self, own, table_bits):
        """Revision 1: own records for all contexts, own vectors."""
        self.deep = Deep(30, 3, table_bits, 5,
                         [w[:93] + w[95:] for w in own.first])
        for i, group in enumerate(own.groups):
            for index, check, p, n in group:
                for node in (0, 1):
                    self.deep.know(i, index << 12 | check, node, p[node],
                                   n[node])
        for number, more in own.vectors:
            c, s = number, 0
            while c >= self.SIZES[s]:
                c, s = c - self.SIZES[s], s + 1
            self.deep.network.begin(
                (s, c), [a + b for a, b in zip(own.first[number % 2], more)])

    def begin(self, x, y, ink):
        super().begin(x, y, ink)
        self.runs, self.bends = [0] * 8, 0
        self.edges = Edges()
        self.edges.begin(bool(ink))

    def advance(self, t):
        self.longer.push(t)
        if t == 0:
            self.runs[0] = min(255, self.runs[0] + 1)
        else:
            self.runs = [0] + self.runs[:7]
            self.bends = (self.bends * 4 + t) & 0xFFFFFFFF
        super().advance(t)
        self.edges.step(self.direction)

    def beyond(self, turns):
        d = (self.direction + turns) % 4
        x, y = self.x, self.y
        self.x, self.y = x + 2 * DX[d], y + 2 * DY[d]
        patch = self.patch()
        self.x, self.y = x, y
        return patch

    def look(self, patch):
        values, vectors, refined = self.contexts(patch)
        base = self.ahead(patch) << 1 | self.ink
        d_right, R = self.sight(1)
        d_left, L = self.sight(-1)
        curve, right, left = self.expects()
        h, chord, bulge, runs = self.last, self.chord, self.bulge, self.runs
        all_, near = patch & ~4, patch & self.NEAR
        last_two = (runs[1] << 8 | runs[0]) << 4 | self.bends & 15
        six = sum(runs[k] << 8 * k for k in range(6))
        verdict = self.segment.verdict(self.direction)
        ahead = self.beyond(0)
        more = [(all_, ahead),
                (mix(all_, ahead), mix(self.beyond(1), self.beyond(3))),
                (curve, d_right << 4 | d_left), (right, left),
                (R, last_two), (L, last_two), (six, self.bends & 0xFFF),
                (chord(24) << 5 | bulge(24), runs[0]),
                (chord(48) << 5 | bulge(48), chord(4)),
                (chord(40) << 18 | chord(12), h(2)), (level(self.longer), 0)]
        edges = self.edges
        edges.look()
        bends, right_turn = level_of(edges.bends), level_of(edges.right)
        more += [(bends, right_turn >> 2),
                 (bends >> 2 << 8 | right_turn >> 3, mix(near, h(4))),
                 (edges.age << 4 | edges.vertex >> 4, runs[0] << 4 | h(2)),
                 (edges.place, mix(bends >> 1, d_right << 4 | d_left))]
        self.deep.ask([v * K & M64 for v in values] + [
            mix(mix(mix(a, b), base), 15 + i) * K & M64
            for i, (a, b) in enumerate(more)])
        nearest, followed = top(11, near * K), 2 * level(self.match)
        steps = len(self.trail) - 1
        self.chosen = [*vectors, 2 * verdict, nearest & ~1,
                       64 * min(runs[0], 15) + 4 * min(runs[1], 15)
                       + 2 * (self.bends & 1),
                       16 * level(self.longer)
                       + 2 * min(steps.bit_length(), 7), 0,
                       min(edges.age, 31) * 32 + (edges.vertex >> 4) * 2]
        self.refined = [*refined, 2 * verdict, followed, 0]
        self.followed = followed

    def decide_deep(self, coder, gate, node):
        p = (self.edges.bends, self.edges.right)[node]
        self.chosen[8] = self.refined[4] = 2 * level_of(p)
        return self.deep.decode(
            coder, [gate, STRETCH[p >> 4], int((p - 32768) / 32)],
            [v + node for v in self.chosen],
            [r + node for r in self.refined], self.followed + node, node,
            ("bends", "side")[node])

    def turn(self, coder, x, y, allowed):
        self.x, self.y = x, y
        patch = self.patch()
        gate = self.gates.setdefault(
            top(16, mix(patch & self.NEAR, self.last(12)) * K), [32768, 0])
        straight = 0 in allowed
        if straight and gate[1] >= 24 and gate[0] < 512:
            bends = coder.decode(gate[0] + 4, "bends, gate")
            update(gate, bends)
            if not bends:
                return 0
            straight = False
        self.look(patch)
        if straight:
            bends = self.decide_deep(coder, STRETCH[gate[0] >> 4], 0)
            update(gate, bends)
            if not bends:
                return 0
        if 1 not in allowed:
            return 2
        if 2 not in allowed:
            return 1
        return 2 if self.decide_deep(coder, 0, 1) else 1


def octave(d):
    return min(11, (d >> 4).bit_length())


def fine(d):
    d >>= 3
    n = d.bit_length()
    return n if n < 2 else min(20, 2 * n - 2 + (d >> n - 2 & 1))


class Past:
    """What is known of the starts of one colour."""

    def __init__(self, words):
        self.words = [[0] * (words + 2) for _ in range(3)]
        self.bytes = [0] * 8 * (words + 2)
        self.last = {}
        self.row, self.rows, self.x = 0, 0, -128


class DeepStartModel(StartModel):
    def __init__(self, cracks, table, words):
        super().__init__(cracks, table, words)
        self.pasts = Past(words), Past(words)
        self.any, self.half = Deep(13, 1, 16, 2), Deep(8, 2, 16, 1)

    def begin_row(self, y):
        super().begin_row(y)
        for past in self.pasts:
            past.rows = (past.rows << 8 | min(past.row, 255)) & M64
            past.row, past.x = 0, -128
            for densities, every in ((past.words[0], 1), (past.words[1], 8),
                                     (past.bytes, 16), (past.words[2], 64)):
                if y % every == 0:
                    densities[:] = [d - (d >> 3) for d in densities]

    def within(self, word):
        """The points of a word near known cracks, by the distance."""
        def known(x, y):
            return (x, y, 0) in self.cracks.known or (
                x, y, 1) in self.cracks.known
        first = 64 * word
        places = [(x, y) for y in range(self.y - 15, self.y + 16)
                  for x in range(first - 15, first + 79) if known(x, y)]
        return [{x for x in range(first, first + 64)
                 if any(abs(x - i) + abs(self.y - j) <= reach
                        for i, j in places)}
                for reach in (4, 8, 15)]

    def deep_age(self, c, word):
        row = self.pasts[c].last.get(word, (-(1 << 20), None))[0]
        return min(7, ((self.y - row) // 2).bit_length())

    def far_start(self, coder, mask, c):
        past, word = self.pasts[c], mask[0] // 64
        self.near = self.within(word)
        self.gap = 64 * word - past.x
        self.kind = 2 if self.gap >= 128 else 1 if self.gap < 64 else 0
        column = past.last.get(word, (0, 64 * word))[1]
        self.anchor = (column if self.kind == 2 else past.x) % 64

        size = sum(len(mask) > s for s in (4, 8, 16, 24, 40, 56))
        row = min(past.row, 3)
        ages = [self.deep_age(c, word + i) for i in (-1, 0, 1)]
        young = min(ages)
        all_ages = 64 * ages[0] + 8 * ages[1] + ages[2]
        counts = [len(near.intersection(mask)).bit_length()
                  for near in self.near]
        coast = counts[0] + 8 * counts[1] + 64 * counts[2]
        rough = min(counts[1], 3) + 4 * (counts[2] > 0)
        quick, slow, slowest = ([d[word + i] for i in range(3)]
                                for d in past.words)
        wide = [d[1] + (d[0] + d[2]) // 2 for d in (quick, slow, slowest)]
        since = min(7, (max(self.gap, 0) // 32).bit_length())
        pairs = [(size | row << 3 | young << 5, 0), (all_ages, size),
                 (fine(wide[0]), fine(wide[1])),
                 (fine(slow[1]), fine(slowest[1]) | size << 5),
                 (coast, octave(wide[1])), (coast, size | row << 3),
                 (rough | fine(wide[1]) << 3, octave(wide[2])),
                 (rough | fine(wide[2]) << 3, octave(wide[0])),
                 (past.rows & 0xFFFF, row),
                 (since | young << 3, octave(wide[1])), (word + 1, 0),
                 (coast, all_ages),
                 (fine(quick[1]), fine(quick[0]) << 8 | fine(quick[2]))]
        self.any.ask_mixed([mix(2 * a + c, b) for a, b in pairs])
        first = (8 * c + size) * 32 + 8 * row + young
        second = 16 * octave(wide[1]) + octave(wide[2])
        found = self.any.decode(
            coder, [8 * len(mask) - 256],
            [first, second, coast, (12 * c + octave(wide[0])) * 8 + rough],
            [first, second], c, 0, "far start")
        return found

    def far_index(self, coder, mask, c):
        word = mask[0] // 64
        distances = {(x - self.anchor) % 64: x for x in mask}
        node, low = 1, 0
        for half in (32, 16, 8, 4, 2, 1):
            before = [x for v, x in distances.items() if low <= v < low + half]
            after = [x for v, x in distances.items()
                     if low + half <= v < low + 2 * half]
            second = not before
            if before and after:
                second = self.decide_half(coder, c, word, before, after, half,
                                          node)
            low += half if second else 0
            node = 2 * node + second
        x = distances[low]
        past = self.pasts[c]
        past.row += 1
        past.x, past.last[word] = x, (self.y, x)
        for densities in past.words:
            densities[word + 1] += 256
        past.bytes[8 + x // 8] += 256
        return x

    def decide_half(self, coder, c, word, before, after, half, node):
        past = self.pasts[c]

        def density(points):
            return sum(past.bytes[8 + b] * sum(x // 8 == b for x in points)
                       // 8 for b in range(8 * word, 8 * word + 8))

        def nearness(points):
            value = 0
            for near in self.near:
                count = sum(x in near for x in points)
                value = 3 * value + (0 if count == 0 else
                                     1 if 2 * count <= len(points) else 2)
            return value

        def share(part, whole):
            return STRETCH[clamp(65536 * part // whole, 100, 65400) >> 4]

        few, later = len(before), len(after)
        ratio = 16 * later // (few + later)
        near = 27 * nearness(before) + nearness(after)
        d, e = density(before), density(after)
        dense = 11 * min(10, (d >> 3).bit_length()) + min(
            10, (e >> 3).bit_length())
        place = past.last.get(word, (0, None))[1]
        where = 1 if place in before else 2 if place in after else 0
        age = self.deep_age(c, word)
        size, at = 2 * half + c, 2 * node + c
        pairs = [(at, self.kind), (size, near << 5 | ratio), (half, near),
                 (size, dense << 5 | ratio),
                 (size, (where << 3 | age) << 2 | self.kind),
                 (at, where << 3 | age), (at, self.anchor << 2 | self.kind),
                 (half, ratio << 2 | self.kind)]
        self.half.ask_mixed([mix(a, b) for a, b in pairs])
        return self.half.decode(
            coder, [share(later, few + later),
                    share(e + 8 * later, d + e + 8 * (few + later))],
            [half + 64 * c, near, 8 * dense + half.bit_length() - 1],
            [half + 64 * c], c, 0, "far index")
