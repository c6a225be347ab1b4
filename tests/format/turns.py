"""Sections "State", "Surroundings", "Turn" and "Fast turns" of
docs/format.md."""
from curve import Curve
from entropy import (K, M64, STRETCH, Mixer, Refiner, clamp, move, squash, top,
                     update)
from segment import Match, Segment

DX, DY = (1, 0, -1, 0), (0, 1, 0, -1)


def mix(a, b):
    return (a * K ^ (b * 0xC2B2AE3D27D4EB4F + 0x165667B19E3779F9)
            ^ a >> 29) & M64


class Walker:
    """The patch around the point of a walk."""

    NEAR = 0xFF6039CA

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

    @staticmethod
    def ahead(patch):
        return (patch >> 7 & 1) + 2 * (patch >> 25 & 1) + 4 * (patch >> 26 & 1)


class TurnModel(Walker):
    """Sections "Turn" and, with `light`, "Light turns"."""

    FEWER = (1, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 1, 2, 0, 0)
    ALL, FEW = range(15), (2, 4, 6, 7, 9, 10)

    def __init__(self, cracks, table_bits, table, light=False):
        self.cracks, self.light = cracks, light
        self.views = self.FEW if light else self.ALL
        self.bits = [table_bits - self.FEWER[i] for i in self.views]
        self.slots = [{} for _ in self.bits]
        for slots, b, i in zip(self.slots, self.bits, self.views):
            for index, check, p, n in table.groups[i]:
                slots[(index << 12 | check) >> (28 - b)] = [
                    check + 1, [p[0], n[0]], [p[1], n[1]]]
        self.gates = {}
        weights = [[w[i] for i in self.views] + [w[15]]
                   + [w[16 + i] for i in self.views] + [w[31]]
                   for w in table.turn]
        self.mixer = Mixer((64, 1024, 1024) + (() if light else (1024,)),
                           weights, 1000)
        if not light:
            self.start_vectors(table)
        self.refiners = (Refiner(),) if light else (Refiner(), Refiner())
        self.match = Match()

    def start_vectors(self, table):
        numbered = [vector for set_ in self.mixer.sets for vector in set_]
        for number, more in table.vectors:
            numbered[number][:] = [
                clamp(4 * (a + b), -32768, 32767)
                for a, b in zip(table.turn[number % 2], more)], 0

    def begin(self, x, y, ink):
        self.x, self.y, self.direction, self.ink = x, y, 0, ink
        self.history, self.run, self.bend = 0, [0] * 4, [0, 0]
        self.trail = [(0, 0, 0), (1, 0, 0)]
        self.segment = Segment()
        self.segment.push(0)
        self.curve = Curve()
        self.curve.step(0, 1, 0, self.gaps(x, y, 0))
        self.x += 1

    def advance(self, t):
        self.match.push(t)
        self.history = (self.history * 4 + t) & M64
        if t == 0:
            self.run[0] = min(255, self.run[0] + 1)
        else:
            self.run = [0] + self.run[:3]
            self.bend = [t, self.bend[0]]
        self.direction = (self.direction + (0, 3, 1)[t]) % 4
        self.segment.push(self.direction)
        X, Y, A = self.trail[-1]
        dx, dy = DX[self.direction], DY[self.direction]
        self.trail.append((X + dx, Y + dy, A + Y * dx - X * dy))
        self.curve.step(self.direction, X + dx, Y + dy,
                        self.gaps(self.x, self.y, self.direction))
        self.x, self.y = self.x + dx, self.y + dy

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
        f, octave = abs(area), abs(area).bit_length()
        level = octave
        if octave >= 2:
            level = min(15, 2 * octave - 2 + (f >> octave - 2 & 1))
        return level + (16 if area < 0 else 0)

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

    def gaps(self, x, y, direction):
        x, y, plane = self.cracks.leaving(x, y, direction)
        known = self.cracks.known
        return tuple(
            next((d for d in range(1, 41) if (
                (x + s * d, y, 1) if plane else (x, y + s * d, 0)) in known), 0)
            for s in (1, -1))

    def expects(self):
        X, Y, _ = self.trail[-1]
        x, y, _ = self.trail[max(0, len(self.trail) - 17)]
        axis = 0 if abs(X - x) >= abs(Y - y) else 1
        return self.curve.expects(
            axis, self.direction, X, Y,
            self.gaps(self.x, self.y, self.curve.heading(axis)))

    def contexts(self, patch):
        """The values v, the vectors and the refiners' contexts of node 0."""
        ahead = self.ahead(patch)
        d_right, R = self.sight(1)
        d_left, L = self.sight(-1)
        level, guess = self.match.level(), self.match.guess()
        verdict = self.segment.verdict(self.direction)
        history, chord, bulge = self.last, self.chord, self.bulge
        run, near = self.run, patch & self.NEAR
        curve, right, left = self.expects()

        values = [
            history(12),
            history(18),
            (run[1] << 8 | run[0]) << 4 | self.bend[1] << 2 | self.bend[0],
            near << 8 | history(4),
            (patch & ~4) << 2 | history(1),
            (L << 18 | chord(16)) << 6 | history(3),
            (R << 10 | L) << 6 | history(3),
            (level << 2 | guess) << 4 | history(2),
            sum((run[k] & 127) << 8 * k for k in range(4)),
            (chord(32) << 8 | history(4)) << 5 | bulge(32),
            (chord(64) << 18 | chord(8)) << 5 | bulge(64),
            (verdict << 4 | min(15, self.segment.previous)) << 6 | history(3),
            curve,
            right << 20 | curve >> 3,
            left << 20 | curve >> 3]
        vectors = (2 * min(7, d_right) + (16 if d_left > 0 else 0),
                   2 * history(4),
                   64 * ahead + 2 * (4 * level + guess),
                   2 * (curve >> 8))
        return ([values[i] << 4 | ahead << 1 | self.ink for i in self.views],
                vectors[:3] if self.light else vectors,
                (2 * top(11, near * K), 2 * history(6)))

    def look_up(self, values):
        """The slots, and where they go if they learn."""
        found, places = [], []
        for i, v in enumerate(values):
            hashed = v * K & M64
            index = top(self.bits[i], hashed)
            check = (hashed >> 36 & 0xFFF) + 1
            slot = self.slots[i].get(index)
            if slot is None or slot[0] != check:
                slot = [check, [32768, 0], [32768, 0]]
            found.append(slot)
            places.append((self.slots[i], index))
        self.places = places
        return found

    def decide(self, coder, slots, vectors, refined, node):
        counters = [slot[1 + node] for slot in slots]
        gate = STRETCH[self.gate[0] >> 4] if node == 0 else 0
        x = [STRETCH[p >> 4] for p, n in counters]
        lean = [(p - 32768) * 51 * min(n, 30) >> 16 for p, n in counters]
        x += [gate] + lean + [0]
        mean = self.mixer.mean(x, [v + node for v in vectors])
        p = squash(mean) + sum(refiner.refine(mean, c + node) for refiner, c
                               in zip(self.refiners, refined))
        p = max(1, p // (1 + len(self.refiners)))
        bit = coder.decode(p, ("bends", "side")[node])
        for model in (self.mixer, *self.refiners):
            model.learn(bit)
        for counter in counters:
            update(counter, bit)
        for (table, index), slot in zip(self.places, slots):
            table[index] = slot
        return bit

    def turn(self, coder, x, y, allowed):
        self.x, self.y = x, y
        patch = self.patch()
        gate = self.gate = self.gates.setdefault(
            top(16, mix(patch & self.NEAR, self.last(12)) * K), [32768, 0])
        straight = 0 in allowed
        if straight and gate[1] >= 24 and gate[0] < 512:
            bends = coder.decode(gate[0] + 4, "bends, gate")
            update(gate, bends)
            if not bends:
                return 0
            straight = False
        values, *models = self.contexts(patch)
        slots = self.look_up(values)
        if straight:
            bends = self.decide(coder, slots, *models, 0)
            update(gate, bends)
            if not bends:
                return 0
        if 1 not in allowed:
            return 2
        if 2 not in allowed:
            return 1
        return 2 if self.decide(coder, slots, *models, 1) else 1


class FastTurnModel(Walker):
    """Section "Fast turns"."""

    def __init__(self, cracks):
        self.cracks = cracks
        self.tables = [{}, {}, {}]

    def begin(self, x, y, ink):
        self.x, self.y, self.direction, self.ink = x, y, 0, ink
        self.history = self.lengths = 0

    def advance(self, t):
        self.history = (self.history * 4 + t) & M64
        if t > 0:
            self.lengths = self.lengths << 7 & 0xFFFFFFFF
        elif self.lengths & 127 < 127:
            self.lengths += 1
        self.direction = (self.direction + (0, 3, 1)[t]) % 4

    @staticmethod
    def weight(n):
        return 0 if n == 0 else 14 if n < 2 else 20 if n < 4 else (
            26 if n < 16 else 30)

    def decide(self, coder, slots, node):
        x = sum(STRETCH[slot[1 + node][0] >> 4] * self.weight(slot[1 + node][1])
                for slot in slots) >> 6
        bit = coder.decode(squash(x), ("bends", "side")[node])
        for slot in slots:
            p, n = slot[1 + node]
            slot[1 + node][:] = move(p, n, bit), min(127, n + 1)
        return bit

    def turn(self, coder, x, y, allowed):
        self.x, self.y = x, y
        patch = self.patch()
        base = self.ahead(patch) << 1 | self.ink
        h = self.history
        slots = []
        for table, value in zip(self.tables, (
                (h & 0xFFFFFF) << 4 | base,
                (patch & self.NEAR) << 11 | (h & 0x3FF) << 1 | self.ink,
                self.lengths << 6 | (h & 3) << 4 | base)):
            hashed = value * K & M64
            check = hashed >> 33 & 0xFFFF
            slot = table.get(top(15, hashed))
            if slot is None or slot[0] != check:
                slot = [check, [32768, 0], [32768, 0]]
                table[top(15, hashed)] = slot
            slots.append(slot)
        if 0 in allowed and not self.decide(coder, slots, 0):
            return 0
        if 1 not in allowed:
            return 2
        if 2 not in allowed:
            return 1
        return 2 if self.decide(coder, slots, 1) else 1
