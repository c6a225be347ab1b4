"""Section "Coder 4: pixels" of docs/format.md."""

from entropy import (K, Mixer, Refiner, STRETCH, clamp, move, squash,
                     top)

BLEND = [420 * n // (2 * n + 3) for n in range(256)]
TRUST = [51 * min(n, 30) for n in range(256)]


class Table:
    """Slots of a context: [check, p, n]."""

    def __init__(self, bits):
        self.bits, self.slots = bits, {}

    def find(self, context, start=32768, pair=None):
        """`start`: the probability of a new slot. `pair`: which of the two
        slots that lie side by side."""
        value = top(64, context * K)
        place, check = value >> 64 - self.bits, value >> 40 & 255
        if pair is not None:
            place = 2 * (place >> 1) + pair
        slot = self.slots.setdefault(place, [0, 32768, 0])
        if slot[0] != check:
            slot = self.slots[place] = [check, start, 0]
        return slot


def learn(slot, bit):
    slot[1:] = move(slot[1], slot[2], bit), min(255, slot[2] + 1)


def octave(value):
    return min(value.bit_length(), 15)


def slope(columns):
    return clamp(columns, -4, 3) + 4


class Rows:
    """Order of pixels in rows, runs and gates."""

    def __init__(self, coder, width, rows, revision):
        self.coder, self.width, self.rows = coder, width, rows
        self.code = (self.blend, self.mix, self.mix_more)[revision]
        self.rare = (3000, 1000, 3600)[revision]
        bits, count = ((16, 2), (16, 4), (17, 8))[revision]
        self.tables = [Table(bits) for _ in range(count)]
        self.mixer = (Mixer([512, 128], [[768] * 16]) if revision == 2
                      else Mixer([512], [[1536] * 8]))
        self.refiner = Refiner()
        self.gates, self.runs = {}, {}

    def run(self, image):
        self.image = image
        for y in range(self.rows):
            self.empty = not any(map(any, image[max(0, y - 2):y]))
            x, self.last = 0, -512
            while x < self.width:
                if self.quiet(x, y):
                    x = self.code_run(x, y)
                else:
                    image[y][x] = self.pixel(x, y)
                    x += 1

    def at(self, x, y):
        return self.image[y][x] if y >= 0 and 0 <= x < self.width else 0

    def cut(self, x, y, k, left, right):
        value = 0
        for i in range(x - left, x + right + 1):
            value = 2 * value + self.at(i, y - k)
        return value

    def before(self, x, y, count):
        return self.cut(x, y, 0, count, -1)

    def plain(self, x, y):
        return self.empty or (self.cut(x, y, 1, 3, 3) in (0, 127)
                              and self.cut(x, y, 2, 2, 2) in (0, 31))

    def quiet(self, x, y):
        return (self.plain(x, y)
                and self.before(x, y, 4) == 15 * self.at(x, y - 1))

    def code_run(self, x, y):
        end = x + 1
        while end < self.width and self.plain(end, y):
            end += 1
        ink = self.at(x, y - 1)
        length = octave(end - x)
        since = clamp(octave(x - self.last) - 3, 0, 7)
        left = slope(self.alike(x - 1, y, -1) - self.alike(x - 1, y - 1, -1))
        right = slope(self.alike(end, y - 2, 1) - self.alike(end, y - 1, 1))
        kind = (self.at(x, y - 2), ink, length)
        low, high = end, end
        changes = self.decide("run", ("run since", since, kind),
                              ("run edges", left, right, kind))
        if changes:
            low, high = x, x + 1
            while high < end and self.decide(
                    "near", ("near since", since, kind, octave(high - x)),
                    ("near left", left, length, octave(high - x))):
                low, high = high, 2 * high - x
            high = min(high, end)
            while high - low > 1:
                middle = (low + high) // 2
                if self.coder.decode(32768, "change"):
                    low = middle
                else:
                    high = middle
            self.last = low
        for i in range(x, low):
            self.image[y][i] = ink
        if changes:
            self.image[y][low] = 1 - ink
            return low + 1
        return end

    def alike(self, x, y, step):
        for count in range(1, 32):
            if self.at(x + count * step, y) != self.at(x, y):
                return count
        return 32

    def decide(self, name, *numbers):
        slots = [self.runs.setdefault(n, [0, 32768, 0]) for n in numbers]
        p = (slots[0][1] + slots[1][1]) // 2
        bit = self.coder.decode(clamp(p, 2, 65534), name)
        for slot in slots:
            learn(slot, bit)
        return bit

    def pixel(self, x, y):
        near = (self.before(x, y, 4) | self.cut(x, y, 1, 3, 3) << 4
                | self.cut(x, y, 2, 2, 2) << 11)
        gate = self.gates.setdefault(near, [0, 32768, 0])
        likely = int(gate[1] >= 32768)
        rare = 65535 - gate[1] if likely else gate[1]
        if rare < self.rare:
            surprise = self.coder.decode(rare + 4, "gate")
            rare += 65535 - rare >> 7 if surprise else -(rare + 127 >> 7)
            gate[1] = 65535 - rare if likely else rare
            return likely ^ surprise
        bit = self.code(x, y, near, gate[1])
        learn(gate, bit)
        return bit

    def small(self, x, y):
        return (self.before(x, y, 6) | self.cut(x, y, 1, 4, 4) << 6
                | self.cut(x, y, 2, 3, 3) << 15
                | self.cut(x, y, 3, 2, 2) << 22)

    def blend(self, x, y, _near, p):
        large = (self.before(x, y, 9) | self.cut(x, y, 1, 7, 7) << 9
                 | self.cut(x, y, 2, 6, 6) << 24
                 | self.cut(x, y, 3, 5, 5) << 37
                 | self.cut(x, y, 4, 4, 4) << 48)
        slots = []
        for table, context in zip(self.tables, (self.small(x, y), large)):
            slots.append(table.find(context, p))
            p += (slots[-1][1] - p) * BLEND[slots[-1][2]] >> 8
        bit = self.coder.decode(clamp(p, 24, 65512), "pixel")
        for slot in slots:
            learn(slot, bit)
        return bit

    def middle(self, x, y):
        return (self.before(x, y, 8) | self.cut(x, y, 1, 6, 6) << 8
                | self.cut(x, y, 2, 5, 5) << 21
                | self.cut(x, y, 3, 4, 4) << 32
                | self.cut(x, y, 4, 2, 2) << 41)

    def wide(self, x, y):
        return (self.before(x, y, 12) | self.cut(x, y, 1, 10, 9) << 12
                | self.cut(x, y, 2, 8, 8) << 32
                | self.cut(x, y, 3, 7, 7) * 0x3A8F05C5 << 28)

    def look_up(self, contexts, pair=None):
        slots = [table.find(context, pair=pair)
                 for table, context in zip(self.tables, contexts)]
        inputs = [STRETCH[p >> 4] for _, p, _ in slots]
        inputs += [(p - 32768) * TRUST[n] >> 16 for _, p, n in slots]
        return slots, inputs

    def mix(self, x, y, near, _p):
        slots, inputs = self.look_up(
            (near, self.small(x, y), self.middle(x, y), self.wide(x, y)))
        chosen = self.before(x, y, 3) | self.cut(x, y, 1, 2, 3) << 3
        p = clamp(self.mixer.predict(inputs, [chosen]), 24, 65512)
        bit = self.coder.decode(p, "pixel")
        self.mixer.learn(bit)
        for slot in slots:
            learn(slot, bit)
        return bit

    def mix_more(self, x, y, near, _p):
        B, R = self.before, self.cut
        chosen = (B(x, y, 3) | R(x, y, 1, 2, 3) << 3,
                  B(x, y, 2) | R(x, y, 1, 1, 1) << 2 | R(x, y, 2, 0, 1) << 5)
        t = B(x, y, 1)
        if t:
            self.image[y][x - 1] = 0
        contexts = (
            near & ~1, self.small(x, y), self.middle(x, y), self.wide(x, y),
            B(x, y, 3) | R(x, y, 1, 2, 6) << 3 | R(x, y, 2, 2, 6) << 12
            | R(x, y, 3, 2, 5) << 21,
            B(x, y, 1) | R(x, y, 1, 1, 3) << 1 | R(x, y, 2, 1, 1) << 6
            | R(x, y, 3, 1, 1) << 9 | R(x, y, 4, 1, 1) << 12,
            B(x, y, 7) | R(x, y, 1, 5, 1) << 7 | R(x, y, 2, 4, 0) << 14,
            B(x, y, 16) | R(x, y, 1, 8, 11) << 16)
        if t:
            self.image[y][x - 1] = 1
        slots, inputs = self.look_up(contexts, t)
        mean = self.mixer.mean(inputs, chosen)
        p = (squash(mean) + self.refiner.refine(mean, chosen[0])) // 2
        bit = self.coder.decode(clamp(p, 24, 65512), "pixel")
        self.refiner.learn(bit)
        self.mixer.learn(bit)
        for slot in slots:
            learn(slot, bit)
        return bit
