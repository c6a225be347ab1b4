"""Section "Pixels of shapes" of docs/format.md."""
from entropy import K, M64, STRETCH, Mixer, Refiner, clamp, move, squash, top, update
from shape_weights import begin


class SlotMixer:
    """Eight contexts of 2^b slots in pairs that are checked, mixed and
    refined."""

    def __init__(self, b, vectors, name):
        self.b, self.slots = b, [{} for _ in range(8)]
        self.mixer = Mixer(vectors, ([0] * 16,))
        begin(self.mixer, name)
        self.refiner = Refiner()

    def decode(self, coder, values, t, vectors):
        counters, places = [], []
        for table, v in zip(self.slots, values):
            hashed = v * K & M64
            check = hashed >> 40 & 255
            place = 2 * top(self.b - 1, hashed) + t
            old, p, n = table.get(place, (0, 32768, 0))
            counters.append((p, n) if old == check else (32768, 0))
            places.append((table, place, check))
        x = [STRETCH[p >> 4] for p, n in counters]
        x += [(p - 32768) * 51 * min(n, 30) >> 16 for p, n in counters]
        mean = self.mixer.mean(x, vectors)
        p = (squash(mean) + self.refiner.refine(mean, vectors[0])) // 2
        bit = coder.decode(clamp(p, 24, 65512), "pixel")
        self.refiner.learn(bit)
        self.mixer.learn(bit)
        for (p, n), (table, place, check) in zip(counters, places):
            table[place] = check, move(p, n, bit), min(255, n + 1)
        return bit


class Pixels:
    RARE = 6000

    def __init__(self, coder, size):
        self.coder = coder
        self.runs, self.gates = {}, {}
        self.mixer = SlotMixer(14 if size < 1000000 else 17, (1024, 256),
                               "kPixels")

    def shape(self, w, h, R, dx, dy):
        """Rows of pixels; R is the shape that it refers to, or None."""
        self.w, self.h, self.R, self.e = w, h, R, 0
        self.e_before = 0
        if R:
            more = len(R[0]) - w, len(R) - h
            self.ox, self.oy = (d + (m // 2 if m >= 0 else -(-m // 2))
                                for m, d in zip(more, (dx, dy)))
        self.known = [[0] * w for _ in range(h)]
        for self.y in range(h):
            self.row()
        return self.known

    @staticmethod
    def at(bitmap, x, y):
        inside = 0 <= y < len(bitmap) and 0 <= x < len(bitmap[0])
        return bitmap[y][x] if inside else 0

    def digits(self, bitmap, first, last, x, y):
        value = 0
        for i in range(first, last + 1):
            value = value << 1 | self.at(bitmap, x + i, y)
        return value

    def P(self, first, last, j):
        return self.digits(self.known, first, last, self.x, self.y + j)

    def Q(self, first, last, j):
        return self.digits(self.R, first, last, self.x + self.ox,
                           self.y + j + self.oy)

    def colour(self, x):
        """Of the surroundings, None if they have two."""
        self.x = x
        if self.R:
            seen = self.P(-1, 1, -1), *(self.Q(-1, 1, j) for j in (-1, 0, 1))
            full = (7,) * 4
        else:
            seen = self.P(-3, 3, -1), self.P(-2, 2, -2)
            full = 127, 31
        return 0 if not any(seen) else 1 if seen == full else None

    def row(self):
        quiet = [self.colour(x) for x in range(self.w)]
        x = 0
        while x < self.w:
            self.x, c = x, quiet[x]
            before = 2 if self.R else 4
            if c is not None and self.P(-before, -1, 0) == c * (
                    (1 << before) - 1):
                end = next((i for i in range(x, self.w) if quiet[i] is None),
                           self.w)
                x = self.run(x, end, c)
            else:
                self.known[self.y][x] = self.pixel()
                x += 1

    def run(self, x, end, c):
        length, row = end - x, self.known[self.y]
        counter = self.runs.setdefault(
            length.bit_length() + 16 * c + 32 * bool(self.R)
            + 64 * (end == self.w), [32768, 0])
        changes = self.coder.decode(clamp(counter[0], 2, 65534), "run")
        update(counter, changes)
        if not changes:
            row[x:end] = [c] * length
            return end
        low, high = 0, length
        while high - low > 1:
            middle = low + (high - low) // 2
            if self.coder.decode(32768, "change"):
                low = middle
            else:
                high = middle
        row[x:x + low + 1] = [c] * low + [1 - c]
        return x + low + 1

    def pixel(self):
        P, Q = self.P, self.Q
        corner = P(-2, -1, 0) | P(-1, 1, -1) << 2
        near = P(-4, -1, 0) | P(-3, 3, -1) << 4 | P(-2, 2, -2) << 11
        block = self.R and (Q(-1, 1, 0) | Q(-1, 1, -1) << 3
                            | Q(-1, 1, 1) << 6)
        gate = self.gates.setdefault(
            65536 + block + (corner << 9) if self.R else near, [32768, 0])
        likely = int(gate[0] >= 32768)
        rare = 65535 - gate[0] if likely else gate[0]
        self.gate = gate
        if gate[1] >= 24 and rare < self.RARE:
            bit = likely ^ self.coder.decode(rare + 4, "gate")
            update(gate, bit)
            if bit == likely:
                return bit
        else:
            bit = self.models(corner, near, block)
            update(gate, bit)
        if self.R:
            self.e_before = self.e
            self.e += -(self.e // 16) + (4096 if bit != Q(0, 0, 0) else 0)
        return bit

    @staticmethod
    def quality(e):
        return sum(e >= limit for limit in (1024, 4096, 10240))

    def models(self, corner, near, block):
        P, t = self.P, self.P(-1, -1, 0)
        if self.R:
            vectors = 512 + block, 128 + (corner | self.quality(self.e) << 5)
        else:
            vectors = (P(-3, -1, 0) | P(-2, 3, -1) << 3,
                       corner | P(-1, 0, -2) << 5)
        if t:
            self.known[self.y][self.x - 1] = 0
        values = self.contexts(corner & ~1, near & ~1, block)
        if t:
            self.known[self.y][self.x - 1] = 1
        return self.mixer.decode(self.coder, values, t, vectors)

    def contexts(self, corner, near, block):
        P, Q, x, y = self.P, self.Q, self.x, self.y
        place = (min(y, 31) | min(self.h - 1 - y, 31) << 5 | min(x, 31) << 10
                 | min(self.w - x, 31) << 15)
        values = [
            P(-6, -1, 0) | P(-4, 4, -1) << 6 | P(-3, 3, -2) << 15
            | P(-2, 2, -3) << 22,
            P(-8, -1, 0) | P(-6, 6, -1) << 8 | P(-5, 5, -2) << 21
            | P(-4, 4, -3) << 32 | P(-2, 2, -4) << 41,
            P(-3, -1, 0) | P(-2, 6, -1) << 3 | P(-2, 6, -2) << 12
            | P(-2, 5, -3) << 21,
            P(-1, -1, 0) | P(-1, 3, -1) << 1 | P(-1, 1, -2) << 6
            | P(-1, 1, -3) << 9 | P(-1, 1, -4) << 12 | P(-1, 1, -5) << 15
            | P(-1, 1, -6) << 18]
        if self.R:
            kind = (1 << 60) + (self.quality(self.e_before) << 56)
            return values + [
                kind | block | corner << 9,
                kind | Q(-1, 1, -2) | Q(-2, 2, -1) << 3 | Q(-2, 2, 0) << 8
                | Q(-2, 2, 1) << 13 | Q(-1, 1, 2) << 18 | P(0, 0, -1) << 25,
                kind | block | near << 9,
                kind | block | place << 9]
        return values + [
            P(-7, -1, 0) | P(-5, 1, -1) << 7,
            P(-1, 1, -1) | P(-1, 1, -2) << 3 | P(-1, 1, -3) << 6 | place << 9,
            corner | place << 5,
            near]
