"""Section "Classes of vectors" of docs/format.md, and how "Coder 24: paths"
joins numbers."""
from decisions import mix
from entropy import K, M64, clamp, top

NONE = 28
ZERO = 0, 0


def J(a, *more):
    for b in more:
        a = (a * 256 + b % 256) & M64
    return a


def W(v):
    return (v[0] << 32 & M64) ^ (v[1] & M64)


def halved(v):
    return tuple(c // 2 if c >= 0 else -(-c // 2) for c in v)


def size(v):
    return max(abs(v[0]), abs(v[1]))


def short(v, k):
    while size(v) >= 1 << k:
        v = halved(v)
    return v


def back(v, quarters):
    x, y = v
    for _ in range(quarters):
        x, y = y, -x
    return x, y


def quarter(v):
    x, y = v
    if x > 0 and y >= 0:
        return 0
    return 1 if y > 0 else 2 if x < 0 else 3


def direction(v):
    if v == ZERO:
        return NONE
    q = quarter(v)
    x, y = back(v, q)
    if y == 0:
        slope = 0
    elif y <= x:
        slope = 1 if 3 * y <= x else 2 if 3 * y <= 2 * x else 3
    else:
        slope = 4 if 3 * x > 2 * y else 5 if 3 * x > y else 6
    return 7 * q + slope


def angle(v):
    q = quarter(v)
    x, y = back(v, q)
    return 48 * q + (24 * y // x if y <= x else 48 - 24 * x // y)


def length_class(s):
    w = s.bit_length()
    return w if w < 2 else 2 * w - 2 + (s >> (w - 2) & 1)


def c(v, k):
    return clamp(v, -k, k)


def less(a, b):
    return a[0] - b[0], a[1] - b[1]


def nearest(a, b):
    """a / b to the nearest, halves away from 0."""
    if b < 0:
        a, b = -a, -b
    return (2 * a + b) // (2 * b) if a >= 0 else -((-2 * a + b) // (2 * b))


class Vertices:
    """Vertices are remembered in order."""

    def __init__(self):
        self.at, self.before, self.after = [], [], []
        self.places = {}

    @staticmethod
    def place(x, y):
        return top(14, mix(x % 2**32, y % 2**32) * K)

    def add(self, at, before):
        i = len(self.at)
        self.at.append(at)
        self.before.append(before)
        self.after.append(None)
        self.places.setdefault(self.place(at[0] >> 4, at[1] >> 4),
                               []).insert(0, i)
        if before is not None:
            self.after[before] = i
        return i

    def close(self, last, first):
        self.after[last], self.before[first] = first, last

    def near(self, at):
        for y in (-1, 0, 1):
            for x in (-1, 0, 1):
                tile = (at[0] >> 4) + x, (at[1] >> 4) + y
                for i in self.places.get(self.place(*tile), [])[:32]:
                    if (self.at[i][0] >> 4, self.at[i][1] >> 4) == tile:
                        yield i


class Match:
    def __init__(self):
        self.all, self.heads, self.M, self.at = [], {}, 0, 0
        self.u = None

    def guess(self):
        return self.all[self.at] if self.M else ZERO

    def push(self, v):
        if self.M:
            self.M = min(self.M + 1, 1000) if self.guess() == v else 0
            self.at += 1
        self.all.append(v)
        if self.u is not None:
            place = top(14, mix(mix(W(v), W(self.u)), 0) * K)
            head, end = self.heads.get(place, 0), len(self.all)
            if (not self.M and head >= 2 and end - head < 2**16 - 2
                    and self.all[head - 2:head] == [self.u, v]):
                self.M, self.at = 1, head
            self.heads[place] = end
        self.u = v
