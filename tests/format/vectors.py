"""Elements of "Coder 24: paths" of docs/format.md."""
from arcs import Arcs
from decisions import RAW, mix
from entropy import Damaged
from vector_classes import (J, NONE, W, Match, ZERO, Vertices, angle, back, c,
                            direction, length_class, less, short, size)
from vector_models import Model, bit, table_1


class Elements:
    """Elements."""

    def __init__(self):
        self.models = [Model() for _ in range(3)]
        table_1(self.models)
        self.match, self.vertices = Match(), Vertices()
        self.arcs, self.kinds = 0, {}
        self.recent = 0
        self.circles = Arcs()

    def arcs_frame(self, coder):
        self.arcs = coder.decode(RAW, "")

    def frame(self, coder):
        self.arcs_frame(coder)
        for p in (1024, 4096, 49152, 16384, RAW, RAW):
            coder.decode(p, "")

    # One path.

    def begin(self, origin, closed, count):
        self.closed, self.count, self.index = closed, count, 0
        self.v, self.t = [ZERO] * 3, [14] * 3
        self.tangent = self.last = ZERO
        self.match.M, self.match.u = 0, None
        self.first = self.here = self.vertices.add(origin, None)
        self.bent = ZERO

    def home(self):
        at = self.vertices.at
        return less(at[self.first], at[self.here])

    def go(self, move):
        x, y = self.vertices.at[self.here]
        self.index += 1
        if self.closed and self.index == self.count:
            if self.here != self.first:
                self.vertices.close(self.here, self.first)
        else:
            self.here = self.vertices.add((x + move[0], y + move[1]),
                                          self.here)

    def element(self, coder):
        """(end, centre or None, clockwise)."""
        arc = 0
        if self.arcs:
            arc = bit(coder, self.kinds.setdefault(self.recent, [RAW, 0]))
            self.recent = (2 * self.recent + arc) % 16
        left = self.count - self.index if self.closed else None
        end = self.home() if left == 1 else self.vector(coder, arc, left)
        centre, clockwise = None, 0
        if arc:
            clockwise, centre = self.circles.decode(coder, end, self.tangent)
            r = less(end, centre)
            self.tangent = (-r[1], r[0]) if clockwise else (r[1], -r[0])
            self.bent = self.tangent
        else:
            self.tangent, self.bent = end, ZERO
        self.go(end)
        return end, centre, clockwise

    def vector(self, coder, arc, left):
        self.coder, self.node = coder, 65536 * arc
        self.look(left)
        if self.decide(0, self.turn_contexts(), 40, 40, 40):
            return ZERO
        base = 0 if self.v[0] == ZERO else direction(self.v[0])
        turn = self.turn()
        self.D = (base + turn) % 28
        self.find_side()
        s = self.length(turn)
        minor = self.minor(turn, s)
        v = (s, minor) if self.D % 7 <= 3 else (minor, s)
        v = back(v, (4 - self.D // 7) % 4)
        self.match.push(v)
        self.t = [14 if self.v[0] == ZERO else turn] + self.t[:2]
        self.v = [v] + self.v[:2]
        return v

    def decide(self, part, contexts, node, *selectors):
        return self.models[part].decode(self.coder, contexts,
                                        node + self.node,
                                        (*selectors, self.stage))

    def look(self, left):
        self.stage = 8 * min(7, left or 0) + min(7, self.index)
        self.rest = 6 if left is None else min(5, left)
        self.place, self.H = min(3, self.index), self.home()
        v1, v2, _ = self.v
        self.bend = ZERO
        if self.bent != ZERO:
            self.bend = short(self.bent, 24)
        elif v1 != ZERO and v2 != ZERO:
            u, v = short(v2, 15), short(v1, 15)
            s = v[0] * v[0] - v[1] * v[1], 2 * v[0] * v[1]
            self.bend = short((s[0] * u[0] + s[1] * u[1],
                               s[1] * u[0] - s[0] * u[1]), 24)
        self.find_near()
        M = self.match.M
        self.guess, self.M = self.match.guess(), M
        self.level = 1 + min(M, 3) if M else 0
        self.l1, self.l2 = (length_class(size(v)) for v in (v1, v2))

    def find_near(self):
        P, here = self.vertices, self.here
        best, N = 401, None
        for i in P.near(P.at[here]):
            d = less(P.at[i], P.at[here])
            far = d[0] * d[0] + d[1] * d[1]
            if i not in (here, P.before[here]) and far < best:
                best, N = far, i
        self.offset = self.behind = self.forth = ZERO
        self.near = 0
        if N is None:
            return
        self.offset = less(P.at[N], P.at[here])
        self.near = 1 + min(5, size(self.offset) // 3)
        if P.before[N] is not None:
            self.behind = less(P.at[P.before[N]], P.at[N])
        if P.after[N] not in (None, here):
            self.forth = less(P.at[P.after[N]], P.at[N])

    def rel(self, v):
        if v == ZERO:
            return NONE
        base = 0 if self.v[0] == ZERO else direction(self.v[0])
        return (direction(v) - base) % 28

    def fine(self, v):
        if v == ZERO:
            return 99
        D1 = 0 if self.v[0] == ZERO else direction(self.v[0])
        base = 48 * (D1 // 7) + (8 * (D1 % 7 - 1) if D1 % 7 else 0)
        a = (angle(v) - base) % 192
        return c(a - 192 if a >= 100 else a, 40)

    def turn_contexts(self):
        v1, v2, _ = self.v
        t1, t2, t3 = self.t
        D = direction(v1)
        slope = 7 if D == NONE else D % 7
        l1, l2, rel, L = self.l1, self.l2, self.rel, length_class
        df = 99
        if v1 != ZERO and v2 != ZERO:
            df = (angle(v1) - angle(v2) + 96) % 192 - 96
        inside = 48 if v1 == ZERO else angle(v1) % 48
        behind, H = rel(self.behind), rel(self.H)
        return (0, J(1, slope, t1), J(2, l1, t1), J(3, l1, l2, slope),
                J(4, t1, t2, l1 // 2), J(5, D, l1 // 2),
                J(6, behind, self.near),
                J(7, behind, rel(self.forth), L(size(self.behind)), l1),
                J(8, rel(self.guess), self.level, slope),
                J(9, self.rest, self.place, H),
                J(10, H, self.rest, L(size(self.H)), l1),
                mix(W(v1), 11), mix(W(v1), W(v2)), J(13, t1, t2, t3, slope),
                J(14, self.fine(self.bend), l1 // 2),
                J(15, self.fine(self.behind), self.fine(self.bend) >> 2),
                J(16, inside, c(df, 24)),
                J(17, direction(self.offset), D, self.near))

    def turn(self):
        contexts = self.turn_contexts()
        second = 64 + self.rel(self.behind) + 32 * self.level

        def decide(node):
            return self.decide(0, contexts, node, node,
                               second + 256 * (node > 2))

        if not decide(0):
            return 0
        right = decide(1)
        k = 1
        while k < (13 if right else 14) and decide(k + (20 if right else 1)):
            k += 1
        return 28 - k if right else k

    def find_side(self):
        P, here = self.vertices, self.here
        best, self.side, self.kind = 1601, ZERO, 0
        for i in P.near(P.at[here]):
            if i == here:
                continue
            for kind, other in ((1, P.before[i]), (2, P.after[i])):
                if (other is None or other == here and
                        (kind == 1 or i == P.before[here])):
                    continue
                move = less(P.at[other], P.at[i])
                if move == ZERO:
                    continue
                apart = (direction(move) - self.D) % 28
                if apart not in (0, 1, 27):
                    continue
                d = less(P.at[i], P.at[here])
                cost = (2 * (d[0] * d[0] + d[1] * d[1]) + 60 * (apart != 0)
                        + 10 * (kind == 2))
                if cost < best:
                    best, self.side, self.kind = cost, move, kind

    def length(self, turn):
        v1, v2, _ = self.v
        t1, L, k = self.t[0], length_class, self.kind
        s1, s2, l1, l2 = size(v1), size(v2), self.l1, self.l2
        hh = (self.rel(self.H) - turn) % 28
        behind, side, slope = self.rel(self.behind), size(self.side), self.D % 7
        contexts = (
            0, J(1, turn, l1), J(2, turn, l1, l2), J(3, turn, slope, l1),
            J(4, t1, turn, l1, l2), J(5, self.D, l1 // 2), J(6, L(side), k),
            J(7, L(side), l1, turn, k),
            mix(256 * size(self.guess) | self.level,
                8 if turn == self.rel(self.guess) else 9),
            J(9, self.rest, L(size(self.H)), min(hh, 2)),
            J(10, self.rest, self.place, l1), mix(W(v1), J(11, turn)),
            mix(s1, 256 * s2 | turn), mix(s2, J(13, l1)),
            mix(side, J(14, k, slope)),
            mix(size(self.behind), J(15, self.near, int(turn == behind))),
            mix(size(self.H), J(16, self.rest, hh)),
            J(17, turn, behind, L(size(self.behind))))
        E = side if k else size(self.guess) if self.M else s1

        def decide(node, w, a, b):
            far = min(7, 4 * abs(E - a) // b)
            far = 7 - far if E < a else 8 + far
            return self.decide(1, contexts, node, 64 + w,
                               512 + far + 16 * min(w, 10) + 256 * (k != 0))

        w = 1
        while w < 32 and decide(w, w, 1 << w, 1 << w):
            w += 1
        u = 1
        for d in range(w - 1):
            power = 1 << (w - 2 - d)
            if d < 6:
                node = 4 * (64 + 64 * w + (u if d < 5 else 63)) + 1
                u = 2 * u + decide(node, w, (2 * u + 1) * power, power)
            else:
                u = 2 * u + self.coder.decode(RAW, "")
        return u

    def minor(self, turn, s):
        slope = self.D % 7
        if slope == 0:
            return 0
        third = slope if slope <= 3 else 7 - slope
        low = s * (third - 1) // 3 + 1
        high = s if third == 3 else s * third // 3
        high -= slope == 4
        if low > high:
            raise Damaged("no such vector")
        prefix, depth = 1, 0
        while low < high:
            middle = low + (high - low) // 2
            ww = min((high - low + 1).bit_length(), 7)
            b = 8 * ww + min(depth, 3)
            contexts, side = self.minor_contexts(turn, s, middle, ww, prefix)
            upper = self.decide(
                2, contexts, 700 + b, 320 + b + 64 * (self.kind != 0),
                768 + side + 32 * min(self.M, 4))
            prefix = min(2 * prefix + upper, 255)
            depth += 1
            low, high = (middle + 1, high) if upper else (low, middle)
        return low

    def minor_contexts(self, turn, s, middle, ww, prefix):
        slope = self.D % 7

        def x(v):
            if v == ZERO:
                return 31
            a, b = back(short(v, 24), self.D // 7)
            a, b = max(a, 0), max(b, 0)
            if slope > 3:
                a, b = b, a
            if a == 0 or b > 2 * a:
                return 31
            f = 8 * s * b // a - (8 * middle + 4)
            n = sum(abs(f) >= k for k in (2, 4, 8, 12, 20, 32, 64, 128))
            return n + 16 * (f >= 0)

        v1, v2, _ = self.v
        X1, X2, XB = x(v1), x(v2), x(self.bend)
        XS, XH, XN = x(self.side), x(self.H), x(self.behind)
        few, M = min(s, 31), min(self.M, 4)
        return (0, J(1, few, slope), J(2, few, min(prefix, 63), turn),
                J(3, X1, XB), J(4, X1, turn, ww), J(5, XB, self.l1, ww),
                J(6, XS, self.kind, ww), J(7, XS, XN, ww),
                J(8, x(self.guess), M), J(9, XH, self.rest), J(10, XS, XB, X1),
                mix(W(v1), J(11, turn, few)), mix(s, J(12, prefix, slope)),
                J(13, X2, X1, ww), J(14, XS, XH, M, self.rest),
                J(15, X2, self.l2), J(16, self.t[0], turn, few),
                J(17, XN, self.near)), XS
