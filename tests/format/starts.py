"""Sections "Far starts" and "Near starts" of docs/format.md."""
from entropy import K, STRETCH, Mixer, clamp, top, update


def age(rows):
    return min(7, (rows // 2).bit_length())


class FarFlag:
    """Far starts by words, quiet spans by spans."""

    def __init__(self, count):
        self.count = count
        # Quick and slow density of a colour's words, one more on either side.
        self.density = [[[0] * (count + 2) for _ in "qs"] for _ in "01"]
        self.levels = [[(0, 0, 0)] * count for _ in "01"]
        self.groups = [{}, {}, {}]
        self.mixer = Mixer((64,), [[3100, 332, 332, 332] + [0] * 4])
        for vector in self.mixer.sets[0]:
            vector[1] = 60000

    def begin_row(self, y):
        if y % 4 == 0:
            for c in (0, 1):
                self.look(c)

    def look(self, c):
        quick, slow = self.density[c]
        quick[:] = [d - (d + 3) // 4 for d in quick]
        slow[:] = [d - (d + 31) // 32 for d in slow]

        def level(d):
            return min(7, (d >> 6).bit_length())

        for w in range(1, self.count + 1):
            near = [d[w - 1] + 2 * d[w] + d[w + 1] for d in (quick, slow)]
            wide = sum(slow[max(0, w - 5):w + 6])
            self.levels[c][w - 1] = (level(near[0]), level(near[1] // 2),
                                     level(wide // 4))

    def add(self, c, word):
        for d in self.density[c]:
            d[word + 1] += 4096

    def decode(self, coder, c, word, known, ages, size, row):
        quick, slow, wide = self.levels[c][word]
        s = 2 * size + c
        counters = [known] + [
            far.setdefault(i * 8 + s, [known[0], 45])
            for far, i in zip(self.groups, (
                (8 * ages[0] + ages[1]) * 8 + ages[2],
                (8 * quick + slow) * 4 + row, (8 * wide + slow) * 8 + ages[1]))]
        vector = (8 * min(7, counters[1][1].bit_length())
                  + min(7, counters[2][1].bit_length()))
        x = [STRETCH[p >> 4] for p, n in counters] + [0] * 4
        p = clamp(self.mixer.predict(x, [vector]), 2, 65534)
        bit = coder.decode(p, "far start")
        self.mixer.learn(bit)
        for counter in counters:
            update(counter, bit)
        if bit:
            self.add(c, word)
        return bit


class StartModel:
    FAR, GROUP, SAME, PLACE = 0, 1024, 1264, 1280

    def __init__(self, cracks, table, words):
        self.cracks, self.flags = cracks, table.flags
        self.recent, self.count = [0, 0], [0, 0]
        self.columns = {}  # (colour, word): (row, point) of the last far start
        self.groups = [{}, {}, {}]
        for group, b, records in zip(self.groups, (16, 14, 14),
                                     table.groups[15:]):
            for index, _, p, n in records:
                group[index >> (16 - b)] = [p[0], n[0]]
        self.mixer = Mixer((64,), table.start)
        self.far = FarFlag(words)
        self.spans = FarFlag(words // 4)
        self.span_rows = {}  # (colour, span): row of the last far start
        self.span_flags = [[3000, 8] for _ in range(64)]
        self.span_words = [[32768, 0] for _ in range(64)]

    def begin_row(self, y):
        self.y, self.last, self.near_count = y, [-128, -128], 0
        for c in (0, 1):
            self.recent[c] += (16 * min(64, self.count[c])
                               - self.recent[c] // 4)
            self.count[c] = 0
        self.far.begin_row(y)
        self.spans.begin_row(y)
        self.span, self.span_found = None, 0

    def age(self, c, word):
        if (c, word) not in self.columns:
            return 7
        return age(self.y - self.columns[c, word][0])

    def quiet_start(self, coder, word, c):
        span = word // 4
        ages = [age(self.y - self.span_rows.get((c, span + i), -10000))
                for i in (-1, 0, 1)]
        row = min(3, self.count[c])
        known = self.span_flags[(8 * row + ages[1]) * 2 + c]
        bit = self.spans.decode(coder, c, span, known, ages, 3, row)
        if bit:
            self.span, self.span_found = span, 0
        return bit

    def far_start(self, coder, mask, c):
        word = mask[0] // 64
        if self.span == word // 4:
            flag = self.span_words[
                (word % 4 * 8 + self.age(c, word)) * 2 + self.span_found]
            bit = coder.decode(clamp(flag[0], 2, 65534), "far start in span")
            update(flag, bit)
            if bit:
                self.far.add(c, word)
                self.span_found = 1
        else:
            bit = self.word_start(coder, mask, c, word)
        self.count[c] += bit
        if bit and word // 4 < self.spans.count:
            self.span_rows[c, word // 4] = self.y
        return bit

    def word_start(self, coder, mask, c, word):
        size = sum(len(mask) > s for s in (5, 16, 40))
        r = sum(self.recent[c] > s for s in (3, 16, 64))
        ages = [self.age(c, word + i) for i in (-1, 0, 1)]
        row = min(3, self.count[c])
        known = self.flags[self.FAR + min(ages) + 8 * (
            ((4 * c + size) * 4 + row) * 4 + r)]
        return self.far.decode(coder, c, word, known, ages, size, row)

    def far_index(self, coder, mask, c):
        word = mask[0] // 64
        x = self.place(coder, mask, c, word)
        self.last[c], self.columns[c, word] = x, (self.y, x)
        return x

    def place(self, coder, mask, c, word):
        column = self.columns.get((c, word), (0, 64 * word))[1]
        if (c, word) in self.columns and column in mask and len(mask) > 1:
            counter = self.flags[self.SAME + 8 * c + self.age(c, word)]
            same = coder.decode(clamp(counter[0], 16, 65520), "far, same")
            update(counter, same)
            if same:
                return column
            mask = [x for x in mask if x != column]
        gap = 64 * word - self.last[c]
        anchor = self.last[c] if gap < 128 else column
        kind = 2 if gap >= 128 else 1 if gap < 64 else 0
        node, low = 1, 0
        distances = {(x - anchor) % 64: x for x in mask}
        for half in (32, 16, 8, 4, 2, 1):
            there = [v for v in distances if low <= v < low + 2 * half]
            later = [v for v in there if v >= low + half]
            second = len(later) == len(there)
            if later and not second:
                counter = self.flags[self.PLACE + (3 * c + kind) * 64 + node]
                if counter[1] == 0:
                    counter[:] = 65536 * len(later) // len(there), 12
                second = coder.decode(clamp(counter[0], 16, 65520),
                                      "far index")
                update(counter, second)
            low += half if second else 0
            node = 2 * node + second
        return distances[low]

    def near_first(self, coder, mask, y, above):
        """The first start of mask, or None."""
        paper = sum(not above[x] for x in mask)
        ink = len(mask) - paper
        roof = any(self.cracks.H(x, y - 1) for x in mask)
        counter = self.flags[self.GROUP + ((
            min(7, paper.bit_length()) * 5 + min(4, ink.bit_length())) * 3
            + min(2, self.near_count)) * 2 + roof]
        bit = coder.decode(clamp(counter[0], 2, 65534), "near group")
        update(counter, bit)
        if not bit:
            return None
        self.near_count += 1
        for x in mask[:-1]:
            if self.near_start(coder, x, y, above[x]):
                return x
        return mask[-1]

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
