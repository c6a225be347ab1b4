"""Sections "Straight segment" and "Match" of docs/format.md."""
from entropy import K, top


class Segment:
    def __init__(self):
        self.s0 = self.s1 = None
        self.length = self.previous = 0

    def restart(self, s):
        self.previous = self.length
        self.s0, self.s1 = s, None
        self.X, self.Y, self.length = 1, 0, 1

    def push(self, s):
        if self.s0 is None or self.length >= 1 << 30:
            return self.restart(s)
        if self.s1 is None:
            if s == self.s0:
                self.X += 1
            elif (s - self.s0) % 2 == 0:
                return self.restart(s)
            else:
                self.s1 = s
                self.A, self.B, self.W, self.r = 1, self.X, self.X + 1, 0
                self.U, self.L = (0, 0), (self.X, 0)
                self.l, self.u, self.Y = self.L, (self.X, 1), 1
            self.length += 1
            return None
        if s not in (self.s0, self.s1):
            return self.restart(s)
        e = self.r + self.A if s == self.s0 else self.r - self.B
        if e < -1 or e > self.W:
            return self.restart(s)
        if s == self.s0:
            self.X += 1
        else:
            self.Y += 1
        self.length += 1
        here = (self.X, self.Y)
        if e == -1:
            self.B, self.A = here[0] - self.U[0], here[1] - self.U[1]
            self.W, self.r = self.A + self.B, 0
            self.u, self.L = here, self.l
        elif e == self.W:
            self.B, self.A = here[0] - self.L[0], here[1] - self.L[1]
            self.W = self.A + self.B
            self.r = self.W - 1
            self.l, self.U = here, self.u
        else:
            self.r = e
            if e == 0:
                self.u = here
            if e == self.W - 1:
                self.l = here
        return None

    def verdict(self, direction):
        if self.s1 is None:
            return 1 + min(24, self.length)
        r, A, B, W = self.r, self.A, self.B, self.W
        return (32 + (r + A <= W) + 2 * (r - B >= -1) + 4 * (r + A <= W - 1)
                + 8 * (r - B >= 0) + 16 * (direction == self.s1)
                + 32 * ((self.s1 - self.s0) % 4 == 1)
                + 64 * min(7, self.length.bit_length() - 1))


class Match:
    def __init__(self, minimum=16):
        self.minimum = minimum
        self.T, self.h, self.heads, self.m, self.n = [3], 0, {}, 0, 0

    def push(self, t):
        if self.n > 0:
            self.n = self.n + 1 if self.T[self.m] == t else 0
            self.m += 1
        T = self.T
        T.append(t)
        E = len(T)
        self.h = (self.h * 4 + t) & (1 << 2 * self.minimum) - 1
        k = top(16, self.h * K)
        c = self.heads.get(k, 0)
        self.heads[k] = E
        if self.n == 0 and c > 0 and E - c < (1 << 18) - 64:
            same = 0
            while same < min(32, c) and T[c - 1 - same] == T[E - 1 - same]:
                same += 1
            if same >= self.minimum:
                self.n, self.m = same, c

    def level(self):
        return (self.n > 0) + sum(self.n > s for s in
                                  (16, 20, 28, 40, 80, 200))

    def guess(self):
        return self.T[self.m] if self.n > 0 else 3
