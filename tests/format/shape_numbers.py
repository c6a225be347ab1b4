"""Sections "What is known of shapes" and "Numbers of shapes" of
docs/format.md."""
from collections import namedtuple

from entropy import K, M64
from pixels import SlotMixer
from turns import mix

(MORE, NEW_LINE, REFERS, CLASS, RANK, SAME, MORE_WIDTH, MORE_HEIGHT, SIDE, DX,
 DY, GAP, RISE) = range(13)
Fact = namedtuple("Fact", "klass gap rise x bottom w h fresh")
NOTHING = Fact(0, 0, 0, 0, 0, 0, 0, 0)
KEPT = 1 << 14


def u(number):
    return number & M64


class Numbers:
    """How they become decisions; look() and decide() are the model's."""

    def look(self, field, values):
        pass

    def note(self, field, value):
        pass

    def flag(self, field, values):
        self.look(field, values)
        bit = self.decide(field, values, 0)
        self.note(field, bit)
        return bit

    def small(self, field, digits, values):
        self.look(field, values)
        node = 1
        for _ in range(digits):
            node = 2 * node + self.decide(field, values, node)
        return node - (1 << digits)

    def number(self, field, values):
        self.look(field, values)
        value = self.digits(field, values, 0)
        self.note(field, value)
        return value

    def digits(self, field, values, sizes):
        w = 0
        while w < 31 and self.decide(field, values, sizes + w):
            w += 1
        if w == 0:
            return 0
        n = 1
        for i in range(w - 2, -1, -1):
            node = 256 + (sizes << 18) + (w << 12) + min(n, 1023 + i)
            n = 2 * n + self.decide(field, values, node)
        return n

    def signed(self, field, values):
        self.look(field, values)
        if self.decide(field, values, 64):
            value = 0
        elif self.decide(field, values, 65):
            value = -1 - self.digits(field, values, 32)
        else:
            value = 1 + self.digits(field, values, 0)
        self.note(field, value)
        return value


class History(Numbers):
    """What is known of shapes."""

    def __init__(self, coder):
        self.coder = coder
        self.facts = [NOTHING]
        self.columns = {}
        self.word = self.last_word = self.line_class = 0
        self.begin((0, 0, 0, 0, 0))
        self.kind = 0

    def begin(self, pen):
        """pen: X, base, line X, line base, in line."""
        self.pen, self.kind = pen, 2
        self.refers = self.klass = self.id = self.gap = 0
        self.find_above()

    def last(self, k):
        return self.facts[-1 - k] if k < len(self.facts) - 1 else NOTHING

    def find_above(self):
        fresh = self.kind == 1
        self.start, self.base = self.pen[2:4] if fresh else self.pen[:2]
        above = []
        for x in range(max(0, self.start - (40 if fresh else 3)),
                       self.start + 120):
            other = self.columns.get(x, 0)
            if other == 0 or len(self.facts) - 1 - other >= KEPT:
                continue
            rise = self.base - self.facts[other].bottom
            if (-200 if fresh else 4) <= rise <= 400:
                above.append(other)
        self.above = (above + [0, 0])[:2]

        self.step = [u(self.facts[i].x - self.start if i else -999)
                     for i in self.above]

    def note(self, field, value):
        if field == NEW_LINE:
            self.kind = value
            self.find_above()
        elif field == REFERS:
            self.refers = value
        elif field == CLASS:
            self.klass = value + 1
        elif field == GAP:
            self.gap = value

    def remember(self, *values):
        fact = Fact(*values)
        self.facts.append(fact)
        if fact.fresh:
            self.word, self.line_class = 0, fact.klass
        elif fact.gap > 12:
            self.last_word, self.word = self.word, 0
        self.word = mix(self.word, fact.klass)
        self.columns[fact.x] = len(self.facts) - 1


class MixedNumbers(History):
    def __init__(self, coder, size):
        super().__init__(coder)
        self.mixer = SlotMixer(14 if size < 1000000 else 16, (936, 39),
                               "kNumbers")

    def look(self, field, v):
        (a, b, c), klass = (self.last(k) for k in range(3)), self.klass
        over = mix(self.step[0], self.facts[self.above[0]].klass)
        if field == GAP:
            all_ = [v[1], v[2], v[4], self.start,
                    mix(self.step[0], self.step[1]),
                    mix(klass, mix(a.klass, u(a.gap))),
                    mix(self.pen[4], a.w), mix(u(a.gap), a.w)]
        elif field == RISE:
            all_ = [*v, self.pen[1], mix(klass, u(self.gap))]
        elif field == CLASS:
            all_ = [*v[:3], *v[4:], self.word, over, a.h]
        else:
            all_ = [*v[:3], *v[4:],
                    mix(mix(klass, a.klass), mix(b.klass, c.klass)),
                    mix(klass, self.word), mix(klass, over)]
        told = 2 * self.kind + self.refers
        self.values = [mix(u(v), (8 * field + i) * 8 + told)
                       for i, v in enumerate(all_)]

    def decide(self, field, values, node):
        name = (node // 2 + 1) * K & M64
        return self.mixer.decode(
            self.coder, [v ^ name for v in self.values], node % 2,
            (72 * field + min(node, 71), 3 * field + self.kind))
