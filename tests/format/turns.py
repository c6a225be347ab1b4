"""Sections "State", "Surroundings" and "Turn" of docs/format.md."""
from entropy import K, M64, STRETCH, Mixer, clamp, top, update
from segment import Match, Segment

DX, DY = (1, 0, -1, 0), (0, 1, 0, -1)


def mix(a, b):
    return (a * K ^ (b * 0xC2B2AE3D27D4EB4F + 0x165667B19E3779F9)
            ^ a >> 29) & M64


class TurnModel:
    FEWER = (3, 1, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 2, 1)
    NEAR = 0xFF6039CA

    def __init__(self, cracks, table_bits, table):
        self.cracks = cracks
        self.bits = [table_bits - fewer for fewer in self.FEWER]
        self.slots = [{} for _ in self.bits]
        for slots, b, records in zip(self.slots, self.bits, table.groups):
            for index, check, p, n in records:
                slots[index >> (16 - b)] = [check, [p[0], n[0]], [p[1], n[1]]]
        self.gates = {}
        self.mixer = Mixer((64, 1024, 1024), table.turn)
        self.match = Match()

    def begin(self, x, y, ink):
        self.x, self.y, self.direction, self.ink = x, y, 0, ink
        self.history, self.run, self.bend = 0, [0] * 4, [0, 0]
        self.trail = [(0, 0, 0), (1, 0, 0)]
        self.segment = Segment()
        self.segment.push(0)

    def advance(self, t):
        self.match.push(t)
        self.history = (self.history * 4 + t) & M64
        if t == 0:
            self.run[0] += 1
        else:
            self.run = [0] + self.run[:3]
            self.bend = [t, self.bend[0]]
        self.direction = (self.direction + (0, 3, 1)[t]) % 4
        self.segment.push(self.direction)
        X, Y, A = self.trail[-1]
        dx, dy = DX[self.direction], DY[self.direction]
        self.trail.append((X + dx, Y + dy, A + Y * dx - X * dy))

    def last(self, turns):
        return self.history & ((1 << 2 * turns) - 1)

    def moved_since(self, n):
        (X, Y, A), (x, y, a) = self.trail[-1], self.trail[-1 - n]
        dx, dy = X - x, Y - y
        return dx, dy, A - a - (y * dx - x * dy)

    def chord(self, n):
        if len(self.trail) - 1 < n:
            return 0
        dx, dy, _ = self.moved_since(n)
        for _ in range(self.direction):
            dx, dy = dy, -dx
        return (dx + 128) * 512 + dy + 128

    def bulge(self, n):
        if len(self.trail) - 1 < n:
            return 0
        area = self.moved_since(n)[2]
        f = abs(area)
        level = min(3, f) + sum(f >= s for s in (4, 6, 9, 14, 20, 30, 45, 70))
        return 12 + level if area < 0 else level

    def place(self, f, r):
        d, right = self.direction, (self.direction + 1) % 4
        return (self.x + f * DX[d] + r * DX[right],
                self.y + f * DY[d] + r * DY[right])

    def patch(self):
        test, d, right = self.cracks.test, self.direction, (
            self.direction + 1) % 4
        patch = 0
        for f in range(-1, 3):
            for r in range(-2, 3):
                patch |= test(*self.place(f, r), d) << 5 * (f + 1) + r + 2
        for f in range(-1, 4):
            for r in range(-2, 2):
                patch |= (test(*self.place(f, r), right)
                          << 20 + 4 * (f + 1) + r + 2)
        return patch

    def sight(self, side):
        test, d = self.cracks.test, self.direction
        for distance in range(1, 13):
            if test(*self.place(-1, side * distance), d):
                six = 0
                for f in (0, 1):
                    at = self.place(f, side * distance)
                    for way in (d, d + 1, d + 3):
                        six = six << 1 | test(*at, way % 4)
                return distance, 64 * distance + six
        return 0, 0

    def contexts(self, patch):
        """The 15 values v and the vectors of node 0."""
        ahead = (patch >> 7 & 1) + 2 * (patch >> 26 & 1) + 4 * (patch >> 25 & 1)
        base = 2 * ahead + self.ink
        d_right, R = self.sight(1)
        d_left, L = self.sight(-1)
        level, guess = self.match.level(), self.match.guess()
        verdict = self.segment.verdict(self.direction)
        history, chord, bulge = self.last, self.chord, self.bulge

        def run(k, limit):
            return min(self.run[k], limit)

        values = (
            mix(history(6), base),
            mix(history(12), base),
            mix(history(18), base),
            mix(256 * run(0, 255) + run(1, 255),
                mix(self.bend[0] + 4 * self.bend[1], base)),
            mix(patch & self.NEAR, mix(history(4), base)),
            mix(patch & ~4, mix(history(1), base)),
            mix(R, mix(history(4), base)),
            mix(L, mix(64 * chord(16) + history(3), base)),
            mix(R, mix(L, mix(history(3), base))),
            mix(4 * level + guess, mix(history(2), base)),
            mix((run(0, 127) << 14) + (run(1, 127) << 7) + run(2, 127),
                mix(run(3, 127), base)),
            mix(chord(32), mix(32 * history(4) + bulge(32), base)),
            mix(4096 * chord(64) + chord(8), mix(bulge(64), base)),
            mix(verdict, mix(history(4), base)),
            mix(256 * verdict + min(255, self.segment.previous),
                mix(history(2), base)))
        vectors = (2 * min(7, d_right) + (16 if d_left > 0 else 0),
                   2 * history(4),
                   64 * ahead + 2 * (4 * level + guess))
        return values, vectors

    def look_up(self, values):
        found = []
        for i, v in enumerate(values):
            hashed = (v + i) * K & M64
            index, check = top(self.bits[i], hashed), hashed >> 8 & 0xFFF
            slot = self.slots[i].get(index)
            if slot is None or slot[0] != check:
                slot = [check, [32768, 0], [32768, 0]]
                self.slots[i][index] = slot
            found.append(slot)
        return found

    def decide(self, coder, slots, vectors, node):
        counters = [slot[1 + node] for slot in slots]
        x = [STRETCH[p >> 4] for p, n in counters] + [77]
        x += [(p - 32768) * 51 * min(n, 30) >> 16 for p, n in counters] + [0]
        p = clamp(self.mixer.predict(x, [v + node for v in vectors]), 1, 65535)
        bit = coder.decode(p, ("bends", "side")[node])
        self.mixer.learn(bit)
        for counter in counters:
            update(counter, bit)
        return bit

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
        values, vectors = self.contexts(patch)
        slots = self.look_up(values)
        if straight:
            bends = self.decide(coder, slots, vectors, 0)
            update(gate, bends)
            if not bends:
                return 0
        if 1 not in allowed:
            return 2
        if 2 not in allowed:
            return 1
        return 2 if self.decide(coder, slots, vectors, 1) else 1
