"""Sections "Deep numbers of shapes" and "Deep pixels of shapes" of
docs/format.md."""
from deep import Deep
from entropy import K, M64, STRETCH, clamp
from pixels import Pixels
from shape_numbers import (CLASS, GAP, KEPT, NEW_LINE, REFERS, RISE, SIDE,
                           History, u)
from shapes import Shapes
from turns import mix


class Repeat:
    """What followed the last place with the same classes in a row."""

    def __init__(self, minimum):
        self.minimum, self.heads, self.at, self.n = minimum, {}, 0, 0

    def push(self, facts):
        def look(number):
            return 2 * facts[number].klass + facts[number].fresh

        last = len(facts) - 1
        if self.n > 0:
            self.n = self.n + 1 if look(self.at) == look(last) else 0
            self.at += 1
        if last < self.minimum:
            return
        h = 0
        for k in range(self.minimum):
            h = mix(h, look(last - k))
        key = (h * K & M64) >> 50
        head, self.heads[key] = self.heads.get(key, 0), last + 1
        if self.n == 0 and head > 0 and last - head < KEPT // 2:
            same = 0
            while same < 32 and same + 1 < head and (
                    look(head - 1 - same) == look(last - same)):
                same += 1
            self.at, self.n = head, same if same >= self.minimum else 0


class DeepNumbers(History):
    def __init__(self, coder):
        super().__init__(coder)
        self.deep = Deep(18, 0, 18, 2)
        self.repeats = Repeat(2), Repeat(5)

    def remember(self, *values):
        super().remember(*values)
        for repeat in self.repeats:
            repeat.push(self.facts)

    def foretold(self, field, repeat):
        if repeat.n == 0:
            return 0
        after = self.facts[repeat.at]
        same = int(after.klass == self.klass)
        value = {CLASS: after.klass, GAP: mix(u(after.gap), same),
                 RISE: mix(u(after.rise), same), NEW_LINE: after.fresh,
                 REFERS: after.klass}.get(field, after.w)
        return mix(value, min(repeat.n, 15))

    def more(self, field):
        a, b, c, d = (self.last(k) for k in range(4))
        over, klass, line = self.facts[self.above[0]], self.klass, self.pen[4]
        step = self.step
        if field == GAP:
            return [self.start, step[0], mix(step[0], step[1]),
                    mix(mix(klass, step[0]), over.klass),
                    mix(klass, mix(a.klass, u(a.gap))),
                    mix(u(a.gap), mix(u(b.gap), u(c.gap))),
                    mix(klass, mix(u(a.rise), a.h)), mix(klass, self.word),
                    mix(line, a.w), mix(u(a.gap), a.w)]
        if field == RISE:
            down = u(over.bottom - self.base if self.above[0] else -999)
            return [self.pen[1], mix(self.pen[3], u(self.gap)),
                    mix(klass, u(self.gap)), mix(self.id, u(a.rise)),
                    mix(u(a.rise), mix(u(b.rise), u(c.rise))),
                    mix(klass, mix(a.klass, u(a.rise))),
                    mix(klass, mix(u(a.rise), u(b.rise))),
                    mix(down, u(over.rise)), mix(line, u(a.rise)),
                    mix(klass, self.word)]
        klass = 0 if field in (CLASS, SIDE) else klass
        return [mix(v, klass) for v in (
            mix(a.klass, mix(b.klass, c.klass)),
            mix(mix(a.klass, b.klass), mix(c.klass, d.klass)), self.word,
            mix(self.word, self.last_word), mix(step[0], over.klass),
            mix(over.klass, a.klass), mix(b.klass, c.klass),
            mix(line, self.line_class), mix(u(a.gap), a.klass), a.h)]

    def look(self, field, values):
        kind = 2 * self.kind + self.refers
        all_ = list(values)
        all_ += [mix(self.foretold(field, r), kind) for r in self.repeats]
        all_ += [mix(v, kind) for v in self.more(field)]
        self.values = [mix(v, 64 * field + i) for i, v in enumerate(all_)]

    def decide(self, field, values, node):
        name = (field << 27) + node
        self.deep.ask([mix(v, name) * K & M64 for v in self.values])
        first = 72 * field + min(node, 71)
        lengths = [16 * field + min(r.n, 15) for r in self.repeats]
        return self.deep.decode(
            self.coder, [],
            [first, *lengths, (16 * field + self.pen[4]) * 4 + self.kind,
             (3 * field + self.kind) * 24 + (min(node, 23) if node < 64
                                             else 20),
             2 * field + (node > 64)], [first, lengths[0]], field, 0, "shape")


def middle(d):
    return d // 2 if d >= 0 else -(-d // 2)


def edge(row, most):
    """The length of the first run and its colour."""
    ink = row[0]
    return next((i for i, p in enumerate(row) if p != ink), most) | ink << 5


class DeepPixels(Pixels):
    RARE = 100

    def __init__(self, coder, size):
        super().__init__(coder, size)
        bits = 16 if size < 1000000 else 18
        self.free = Deep(16, 1, bits, 2)
        self.told = Deep(20, 1, bits, 2)

    def edge(self, j):
        return edge([self.P(i, i, j) for i in range(-8, 11)], 19)

    def run_before(self):
        return edge([self.P(i, i, 0) for i in range(-1, -32, -1)], 31)

    def models(self, corner, near, block):
        P, Q, x, y = self.P, self.Q, self.x, self.y
        place = (min(y, 31) | min(self.h - 1 - y, 31) << 5 | min(x, 31) << 10
                 | min(self.w - x, 31) << 15)
        sides = place & 31 | (place >> 10 & 31) << 5
        close = (P(-6, -1, 0) | P(-4, 4, -1) << 6 | P(-3, 3, -2) << 15
                 | P(-2, 2, -3) << 22)
        wide = (P(-8, -1, 0) | P(-6, 6, -1) << 8 | P(-5, 5, -2) << 21
                | P(-4, 4, -3) << 32 | P(-2, 2, -4) << 41)
        ahead = (P(-3, -1, 0) | P(-2, 6, -1) << 3 | P(-2, 6, -2) << 12
                 | P(-2, 5, -3) << 21)
        gate = STRETCH[self.gate[0] >> 4]
        if self.R:
            return self.of_reference(corner, near, block, place, sides, close,
                                     wide, ahead, gate)
        three = P(-1, 1, -1) | P(-1, 1, -2) << 3 | P(-1, 1, -3) << 6
        e, run = [self.edge(-k) for k in range(7)], self.run_before()
        edges = e[1] | e[2] << 6
        more = edges | e[3] << 12 | e[4] << 18 | run << 24
        self.free.ask_mixed([
            close, wide,
            mix(P(-9, -1, 0) | P(-7, 7, -1) << 9 | P(-6, 6, -2) << 24
                | P(-5, 5, -3) << 37,
                P(-4, 4, -4) | P(-3, 3, -5) << 9 | P(-2, 2, -6) << 16),
            P(-16, -1, 0) | P(-8, 11, -1) << 16,
            P(-7, -1, 0) | P(-5, 1, -1) << 7,
            P(-2, -1, 0) | P(-1, 8, -1) << 2 | P(0, 8, -2) << 12
            | P(0, 7, -3) << 21,
            P(-8, -1, 0) | P(-8, 1, -1) << 8 | P(-7, 0, -2) << 18
            | P(-7, 0, -3) << 26,
            P(-5, -1, 0) | P(-3, 3, -1) << 5 | P(-3, 3, -2) << 12
            | P(-1, 1, -3) << 19,
            sum(P(-3, 3, -k) << 7 * (k - 1) for k in range(1, 7)),
            three | P(-1, 1, -4) << 9 | P(-1, 1, -5) << 12
            | P(-1, 1, -6) << 15 | (corner & 3) << 18,
            mix(close, place & 1023), corner | place << 5, near,
            edges | run << 12, more, more | e[5] << 30 | e[6] << 36])
        shape = P(-3, -1, 0) | P(-2, 3, -1) << 3
        column = three | (corner & 1) << 9
        return self.free.decode(
            self.coder, [gate],
            [shape, corner | P(-1, 0, -2) << 5, sides, column,
             16 * e[1] + (run & 15)], [shape, column], corner, 0, "pixel")

    def of_reference(self, corner, near, block, place, sides, close, wide,
                     ahead, gate):
        P, Q, x, y = self.P, self.Q, self.x, self.y

        def other(k, first, last, j):
            shape, ox, oy = self.others[k]
            return self.digits(shape, first, last, x + ox, y + j + oy)

        here = Q(0, 0, 0)
        seven = mix(sum(Q(-3, 3, j) << 7 * (j + 2) for j in range(-2, 3)),
                    Q(-2, 2, -3) | Q(-2, 2, 3) << 5)

        def d(first, last, j):
            return P(first, last, j) ^ Q(first, last, j)

        differed = (d(-3, -1, 0) | d(-1, 1, -1) << 3 | d(-1, 1, -2) << 6
                    | here << 9)
        at = mix(self.klass, u(x + self.fx) << 32 & M64 ^ u(y + self.fy))
        others = [other(k, -1, 1, 0) | other(k, -1, 1, -1) << 3
                  | other(k, -1, 1, 1) << 6 | 512
                  if k < len(self.others) else 0 for k in range(2)]
        cross = [o & 7 | (o >> 4 & 1) << 3 | (o >> 7 & 1) << 4 | o >> 9 << 5
                 for o in others]
        both = cross[0] | cross[1] << 6
        self.told.ask_mixed([
            block | place << 9, close, wide, ahead,
            P(-1, -1, 0) | P(-1, 3, -1) << 1
            | sum(P(-1, 1, -k) << 3 * k for k in range(2, 7)),
            seven, mix(block, close), mix(seven, near),
            mix(block, d(-6, -1, 0) | d(-4, 4, -1) << 6 | d(-3, 3, -2) << 15
                | d(-2, 2, -3) << 22),
            mix(block, d(-3, -1, 0) | d(-2, 2, -1) << 3 | d(-1, 1, -2) << 8),
            at, mix(at, block), mix(at, here | (corner & 3) << 1),
            mix(at, block | corner << 9), mix(block, both),
            mix(block | corner << 9, others[0]),
            mix(Q(-1, 1, 0) | Q(0, 0, -1) << 3 | Q(0, 0, 1) << 4
                | corner << 5, both),
            mix(others[0], others[1]),
            mix(Q(-4, 6, 0) | Q(-4, 6, 1) << 11 | Q(-3, 5, 2) << 22, corner),
            mix(Q(0, 5, 0) | Q(-2, 4, 1) << 6 | Q(-2, 2, 2) << 13
                | Q(-1, 1, 3) << 18, near)])
        q = sum(self.e >= limit for limit in (1024, 4096, 10240))
        return self.told.decode(
            self.coder, [gate],
            [block, corner | q << 5, differed, sides,
             (mix(both, here) * K & M64) >> 54], [block, differed], corner, 0,
            "pixel")


class DeepShapes(Shapes):
    def __init__(self, coder, width, rows):
        super().__init__(coder, width, rows)
        self.numbers = DeepNumbers(coder)
        self.pixels = DeepPixels(coder, width * rows)
        self.frames = []  # of each shape: its corner in its class

    def draw(self, w, h, C, R, dx, dy):
        if R is not None:
            pixels = self.pixels
            model = self.shapes[R]
            pixels.klass = C + 1
            pixels.fx, pixels.fy = (
                clamp(place + middle(a - b) + d, -1 << 20, 1 << 20)
                for place, a, b, d in zip(
                    self.frames[R], (len(model[0]), len(model)), (w, h),
                    (dx, dy)))
            pixels.others = []
            for i in self.classes[C]:
                ox, oy = (p - q for p, q in zip((pixels.fx, pixels.fy),
                                                self.frames[i]))
                if i != R and abs(ox) <= 30 and abs(oy) <= 30:
                    pixels.others.append((self.shapes[i], ox, oy))
            self.frames.append((pixels.fx, pixels.fy))
        else:
            self.frames.append((0, 0))
        return super().draw(w, h, C, R, dx, dy)
