"""Sections "Far starts" and "Near starts" of docs/format.md."""
from entropy import K, STRETCH, Mixer, clamp, top, update


class StartModel:
    def __init__(self, cracks, table):
        self.cracks, self.far = cracks, table.far
        self.recent, self.count = [0, 0], [0, 0]
        self.groups = [{}, {}, {}]
        for group, b, records in zip(self.groups, (16, 14, 14),
                                     table.groups[15:]):
            for index, _, p, n in records:
                group[index >> (16 - b)] = [p[0], n[0]]
        self.mixer = Mixer((64,), table.start)

    def begin_row(self):
        for c in (0, 1):
            self.recent[c] += (16 * min(64, self.count[c])
                               - self.recent[c] // 4)
            self.count[c] = 0

    def far_start(self, coder, mask, c):
        size = sum(len(mask) > s for s in (5, 16, 40))
        r = sum(self.recent[c] > s for s in (3, 16, 64))
        counter = self.far[((4 * c + size) * 4 + min(3, self.count[c])) * 4 + r]
        bit = coder.decode(clamp(counter[0], 2, 65534), "far start")
        update(counter, bit)
        self.count[c] += bit
        return bit

    @staticmethod
    def far_index(coder, mask):
        while len(mask) > 1:
            n = len(mask)
            first = coder.decode(65536 * (n // 2) // n, "far index")
            mask = mask[:n // 2] if first else mask[n // 2:]
        return mask[0]

    def near_start(self, coder, x, y, a):
        def digits(plane, y2, k, m):
            value = 0
            for i in range(x - k, x - k + m):
                value = value << 1 | plane(i, y2)
            return value

        def row(y2, k, m):
            return digits(self.cracks.H, y2, k, m)

        def col(y2, k, m):
            return digits(self.cracks.V, y2, k, m)

        index = (row(y, 0, 3) | col(y - 1, 0, 3) << 3 | col(y, 0, 3) << 6
                 | row(y - 1, 1, 3) << 9 | row(y + 1, 1, 3) << 12 | a << 15)
        first = self.groups[0].setdefault(index, [2000, 0])
        if first[0] < 100 and first[1] >= 16:
            bit = coder.decode(first[0] + 2, "near, tight")
            update(first, bit)
            return bit
        mid = (row(y, 1, 5) | col(y - 1, 1, 5) << 5 | col(y, 1, 5) << 10
               | row(y - 1, 1, 4) << 15 | row(y + 1, 1, 4) << 19
               | row(y - 2, 1, 4) << 23 | a << 27)
        full = (row(y, 3, 8) | col(y - 1, 3, 8) << 8 | col(y, 3, 8) << 16
                | row(y - 1, 3, 8) << 24 | row(y + 1, 3, 8) << 32
                | row(y - 2, 3, 8) << 40 | a << 48)
        counters = [first] + [
            self.groups[g].setdefault(top(14, (v + 1) * K), [2000, 0])
            for g, v in ((1, mid), (2, full))]
        vector = (8 * min(7, counters[1][1].bit_length())
                  + min(7, counters[2][1].bit_length()))
        x = [STRETCH[p >> 4] for p, n in counters] + [0] * 5
        p = clamp(self.mixer.predict(x, [vector]), 4, 65532)
        bit = coder.decode(p, "near start")
        self.mixer.learn(bit)
        for counter in counters:
            update(counter, bit)
        return bit
