"""Order of pixels (what is known) and Starts of "Coder 3: centrelines" of
docs/format.md."""
from decisions import RAW, Decisions, Vectors, mix
from entropy import K, M64, STRETCH, Refiner, clamp, move, squash, top

NEAR = sum(1 << 5 * (v + 2) + u + 2 for u in (-1, 0, 1) for v in (-1, 0, 1)
           if u or v)


def bits(value):
    return value.bit_length()


class Pixels:
    """What is known: (x, y) -> 1 for ink, 0 for paper."""

    def __init__(self, width, rows):
        self.width, self.rows = width, rows
        self.told, self.passed = {}, set()

    def get(self, x, y):
        if 0 <= x < self.width and 0 <= y < self.rows:
            return self.told.get((x, y))
        return 0

    def patch(self, x, y, quarters):
        """all, near, outer."""
        known = ink = 0
        for v in range(-2, 3):
            for u in range(-2, 3):
                i, j = u, v
                for _ in range(quarters):
                    i, j = j, -i
                colour = self.get(x + i, y + j)
                bit = 1 << 5 * (v + 2) + u + 2
                known |= bit * (colour is not None)
                ink |= bit * (colour == 1)
        outer = ink & ~NEAR & ~(1 << 12)
        return known << 25 | ink, (known & NEAR) << 25 | ink & NEAR, outer


class Ruler:
    def __init__(self):
        self.n, self.s = {}, 1

    def add(self, i):
        self.n[i] = min(65535, self.n.get(i, 0) + 1)
        self.s += 1

    def level(self, i, size):
        a = self.n.get(i, 0)
        b = max(self.n.get(i - 1, 0), self.n.get(i + 1, 0))
        r = 16 * a // (16 * self.s // size + 1)
        return 9 * min(bits(r), 5) + 3 * (2 * (a > b) + (a == b)) + min(a, 2)


class Refined(Decisions):
    """A model of starts."""

    def __init__(self, weights):
        super().__init__(5, 14)
        first = [clamp(4 * w, -32768, 32767) for w in weights]
        self.mixer.sets = [Vectors(first) for _ in range(3)]
        self.refiners = Refiner(), Refiner()

    def decode(self, coder, values, node, selectors):
        counters, inputs = [], []
        for i, (table, value) in enumerate(zip(self.tables, values)):
            slot = (mix(value + i, node) * K & M64) >> self.shift
            counter = table.setdefault(slot, [RAW, 0])
            counters.append(counter)
            p, n = counter
            inputs += STRETCH[p >> 4], (p - 32768) * 51 * min(n, 30) >> 16
        x = self.mixer.mean(inputs + [77] + self.empty, selectors)
        p = 2 * squash(x) + sum(r.refine(x, s) for r, s in
                                zip(self.refiners, selectors))
        bit = coder.decode(clamp(p // 4, 8, 65528), "")
        for refiner in self.refiners:
            refiner.learn(bit)
        self.mixer.learn(bit)
        for counter in counters:
            counter[:] = move(*counter, bit), min(255, counter[1] + 1)
        return bit


class Starts:
    def __init__(self, pixels, columns, rows, weights):
        self.pixels, self.columns, self.rows = pixels, columns, rows
        self.ruler, self.gates = Ruler(), {}
        self.words = [[0, 0, -1000, 0]
                      for _ in range((pixels.width + 63) // 64 + 2)]
        self.last, self.last_in_span = {}, {}
        self.any, self.span, self.one = map(Refined, weights)
        self.y = self.n = 0

    def begin_row(self, y):
        self.y, self.n, self.before = y, 0, -1000
        if y % 4 == 0:
            for word in self.words:
                word[0] -= word[0] // 8
                word[1] -= word[1] // 64

    def near_ink(self, x):
        return any(self.pixels.get(x + i, self.y + j)
                   for j in range(3) for i in range(-2, 3))

    def decode_any(self, coder, unknown, word):
        left, here, right = self.words[word:word + 3]
        Q, S = bits(here[0] // 64), bits(here[1] // 64)
        B = bits((left[0] + right[0]) // 64)
        W = bits((left[1] + here[1] + right[1]) // 2 // 64)
        z = bits(len(unknown))
        self.near = set(filter(self.near_ink, unknown))
        c = bits(len(self.near))
        Z, f = 8 * z + c, min(self.n, 3)
        R = self.rows.level(self.y, self.y + 1)

        def A(w, most):
            return min(self.y - w[2], most)

        gate = self.gates.setdefault(
            top(12, mix(mix(Q, B), mix(S, mix(f, Z))) * K), [RAW, 0])
        if gate[1] >= 24 and gate[0] < 512:
            found = coder.decode(gate[0] + 4, "")
        else:
            found = self.any.decode(coder, [
                mix(16 * B + Q, Z), mix(16 * S + W, c),
                mix(A(here, 80), 8 * S + c),
                mix(mix(A(left, 50), A(right, 50)), A(here, 50)),
                mix(R, mix(min(self.n, 7), S))], 0, (Z, 16 * Q + S, W))
        gate[:] = move(*gate, found), min(255, gate[1] + 1)
        return found

    def age(self, last, i, most):
        return min(self.y - last.get(i, -1000), most)

    def decode_span(self, coder, i, inside, after):
        """Whether the first start is one of those `inside` span i."""
        word, last = self.words[i // 8 + 1], self.last_in_span
        s, k = len(inside), len(after)
        v, r = (len(self.near.intersection(x)) for x in (inside, after))
        b = sum(128 >> x % 8 for x in inside if x in self.near)
        t, e = self.age(last, i, 60), clamp(8 * i - self.before, 0, 300)
        return self.span.decode(coder, [
            mix(b, mix(k, min(t, 20))), mix(e, 5),
            mix(64 * s + k, 64 * v + r),
            mix(8 + clamp(i - word[3] // 8, -8, 8),
                mix(k, min(self.y - word[2], 3))),
            mix(mix(self.age(last, i - 1, 30), self.age(last, i + 1, 30)),
                t)], 0, (k, min(e, 100), 9 * s + v))

    def decode_one(self, coder, x, k):
        word, last = self.words[x // 64 + 1], self.last
        _, near, _ = self.pixels.patch(x, self.y, 0)
        t, e = self.age(last, x, 60), min(x - self.before, 300)
        column = self.columns.level(x, self.pixels.width)
        starts = self.ruler.level(x, self.pixels.width)
        return self.one.decode(coder, [
            mix(near, k), mix(e, 5), mix(column, mix(starts, int(e < 20))),
            mix(64 + clamp(x - word[3], -64, 64), min(self.y - word[2], 3)),
            mix(mix(self.age(last, x - 1, 30), self.age(last, x + 1, 30)),
                t)], 0, (k, min(e, 100), column))

    def decode(self, coder, unknown, word):
        if not self.decode_any(coder, unknown, word):
            return None
        while True:
            i = unknown[0] // 8
            inside = [x for x in unknown if x // 8 == i]
            unknown = unknown[len(inside):]
            if not unknown or self.decode_span(coder, i, inside, unknown):
                break
        for i, x in enumerate(inside, 1):
            if i == len(inside) or self.decode_one(coder, x, len(inside) - i):
                break
        self.n += 1
        self.before = x
        self.last[x] = self.last_in_span[x // 8] = self.y
        self.ruler.add(x)
        w = self.words[word + 1]
        w[:] = w[0] + 4096, w[1] + 4096, self.y, x
        return x
