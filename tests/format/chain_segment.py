"""Straight segment (of 8 letters) and Match of "Coder 16: chains" of
docs/format.md."""
from entropy import K, top


class Segment8:
    """Straight segment, over 8 letters."""

    def __init__(self):
        self.s0 = self.s1 = None
        self.length = self.previous = 0

    def start(self, t):
        self.previous, self.s0, self.s1 = self.length, t, None
        self.x, self.y, self.length = 1, 0, 1

    def push(self, t):
        if self.s0 is None or self.length == 1 << 30:
            return self.start(t)
        if self.s1 is None:
            if t == self.s0:
                self.x += 1
            elif (t - self.s0) % 8 not in (1, 7):
                return self.start(t)
            else:
                self.s1, self.a, self.b, self.r, self.y = t, 1, self.x, 0, 1
                self.w = self.b + 1
                self.U, self.L = (0, 0), (self.x, 0)
                self.U2, self.L2 = (self.x, 1), (self.x, 0)
            self.length += 1
            return None
        r = {self.s0: self.r + self.a, self.s1: self.r - self.b}.get(t)
        if r is None or r < -1 or r > self.w:
            return self.start(t)
        self.x += t == self.s0
        self.y += t == self.s1
        self.length += 1
        P = self.x, self.y
        if r == -1:
            self.b, self.a = P[0] - self.U[0], P[1] - self.U[1]
            self.w, self.r = self.a + self.b, 0
            self.U2, self.L = P, self.L2
        elif r == self.w:
            self.b, self.a = P[0] - self.L[0], P[1] - self.L[1]
            self.w = self.a + self.b
            self.r = self.w - 1
            self.L2, self.U = P, self.U2
        else:
            self.r = r
            if r == 0:
                self.U2 = P
            if r == self.w - 1:
                self.L2 = P
        return None

    def verdict(self, d):
        if self.s0 is None:
            return 0
        if self.s1 is None:
            return 1 + min(self.length, 24)
        r, a, b, w = self.r, self.a, self.b, self.w
        return (32 + (r + a <= w) + 2 * (r - b >= -1) + 4 * (r + a <= w - 1)
                + 8 * (r - b >= 0) + 16 * (d == self.s1)
                + 32 * ((self.s1 - self.s0) % 8 == 1)
                + 64 * min(7, self.length.bit_length() - 1))


class Match8:
    """Match of Coder 16."""

    def __init__(self):
        self.T, self.recent, self.heads, self.n, self.at = [], 0, {}, 0, 0

    def push(self, t):
        T = self.T
        if self.n:
            self.n = min(65535, self.n + 1) if T[self.at] == t else 0
            self.at += 1
        T.append(t)
        self.recent = (self.recent * 8 + t) % (1 << 36)
        key = top(16, self.recent * K)
        head, end = self.heads.get(key, 0), len(T)
        if not self.n and head and end - head < (1 << 18) - 64:
            same = 0
            while same < min(32, head) and T[head - 1 - same] == T[
                    end - 1 - same]:
                same += 1
            if same >= 12:
                self.n, self.at = same, head
        self.heads[key] = end

    def level(self):
        return (self.n > 0) + sum(self.n > s for s in
                                  (15, 20, 28, 40, 80, 200))

    def guess(self):
        return self.T[self.at] if self.n else 0
