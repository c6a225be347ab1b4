"""Section "Edges of polygons" of docs/format.md."""
from entropy import clamp

LONGEST = 48


def line_weight(length):
    return 40000 // length


def long_weight(dy):
    return 87000 if dy <= LONGEST else 87000 * 48 // dy


def lengths(a, b):
    return sum(map(line_weight, range(a, b + 1)))


LENGTHS = {(a, b): lengths(a, b) for a in range(1, LONGEST + 1)
           for b in range(a, LONGEST + 1)}


def fixed(n, of):
    whole = abs(n) * 65536 // of
    return clamp(whole if n >= 0 else -whole, -65536, 65536)


def share(part, rest):
    part, rest = part >> 14, rest >> 14
    return clamp(part * 65536 // (part + rest + 1), 60, 65476)


class Slopes:
    def __init__(self, low=(-1000, 1), high=(1000, 1)):
        self.low, self.high = low, high

    def from_(self, dx, dy):
        n, of = self.low
        low = (2 * dx - 1, 2 * dy)
        return Slopes(low if low[0] * of > n * low[1] else self.low, self.high)

    def up_to(self, dx, dy):
        n, of = self.high
        high = (2 * dx + 1, 2 * dy)
        return Slopes(self.low,
                      high if high[0] * of < n * high[1] else self.high)

    def holds(self, dx, dy):
        return (self.low[0] * dy <= dx * self.low[1]
                and self.high[0] * dy >= dx * self.high[1])

    def weight(self, dy):
        low, low_of = self.low
        high, high_of = self.high
        if low * high_of > high * low_of:
            return 0
        total = long_weight(dy) * (fixed(*self.high) - fixed(*self.low)) >> 16
        for y in range(dy, LONGEST + 1):
            a = max(-(-low * y // low_of), -LONGEST)
            b = min(high * y // high_of, LONGEST)
            if a > b:
                continue
            steep = min(b, y) - max(a, -y) + 1
            if steep > 0:
                total += steep * line_weight(y)
            if b > y:
                total += LENGTHS[max(a, y + 1), b]
            if a < -y:
                total += LENGTHS[max(-b, y + 1), -a]
        return total


ANY = Slopes().weight(1)


class Edges:
    def begin(self, ink):
        self.ink, self.way, self.down = ink, 0, 0
        self.column, self.moved = 1, 1
        self.begin_edge()

    def begin_edge(self):
        self.anchors = []  # x, row, chance, slopes, weight
        self.row, self.chance = 0, 1 << 30

    def pixel(self, way):
        return self.column - (self.ink == (way == 1))

    def step(self, way):
        self.way = way
        if way in (0, 2):
            self.column += 1 - way
            self.moved += 1
            return
        self.moved = 0
        if way == self.down:
            self.reach_row()
        else:
            self.down = way
            self.x = self.pixel(way)
            self.begin_edge()

    def reach_row(self):
        self.anchors.append((self.x, self.row, self.chance, Slopes(), 0))
        self.row += 1
        self.x = self.pixel(self.down)
        kept, vertex = [], 0
        for x, row, chance, slopes, _ in self.anchors:
            dy, dx = self.row - row, clamp(self.x - x, -4000, 4000)
            slopes = slopes.from_(dx, dy).up_to(dx, dy)
            weight = chance * slopes.weight(dy) if dy <= 200 else 0
            if weight == 0:
                continue
            kept.append((x, row, chance, slopes, weight))
            if slopes.holds(dx, dy):
                length = max(dy, abs(dx))
                vertex += chance * (
                    line_weight(length) if length <= LONGEST
                    else long_weight(dy) // (50 * length))
        every = sum(a[4] for a in kept)
        if len(kept) > 8:
            kept.remove(min(kept, key=lambda a: a[4]))
        self.chance = (vertex >> 24) + (every >> 34) + 1
        self.anchors = kept
        if every == 0:
            self.chance = 1 << 30
            return
        up = 0
        while every << up < 1 << 50:
            up += 2
        while up <= 0 and every >> -up > 1 << 54:
            up -= 2

        def scaled(v):
            return v << up if up >= 0 else v >> -up
        self.chance = scaled(self.chance)
        self.anchors = [(x, row, scaled(chance), slopes, scaled(weight))
                        for x, row, chance, slopes, weight in kept]

    def look(self):
        self.bends = self.right = 32768
        self.age = self.vertex = self.place = 0
        if self.down == 0:
            return
        at = self.pixel(self.down)
        here = east = west = 0
        for x, row, chance, slopes, _ in self.anchors + [
                (self.x, self.row, self.chance, Slopes(), 0)]:
            dy, dx = self.row + 1 - row, clamp(at - x, -4000, 4000)
            here += chance * slopes.from_(dx, dy).up_to(dx, dy).weight(dy)
            if self.moved == 0 or self.way == 0:
                east += chance * slopes.from_(dx + 1, dy).weight(dy)
            if self.moved == 0 or self.way == 2:
                west += chance * slopes.up_to(dx - 1, dy).weight(dy)
        every = sum(a[4] for a in self.anchors)
        back = self.chance * (ANY // 2)
        self.vertex = (back >> 8) * 255 // ((back + every >> 8) + 1)
        if self.moved == 0:
            self.bends = share(east + west + back, here)
            east, west = east + back // 2, west + back // 2
            self.right = (share(east, west) if self.down == 3
                          else share(west, east))
        else:
            on = east if self.way == 0 else west
            self.bends = share(here + back // 8, on + back // 2)
            self.right = (share(here, back // 8)
                          if (self.way == 0) == (self.down == 1)
                          else share(back // 8, here))
        moved = 0
        if self.anchors:
            x, row, *_ = max(self.anchors, key=lambda a: a[4])
            self.age = self.row - row
            moved = clamp(self.x - x, -127, 127)
        self.place = (min(self.age, 63) << 14 | (moved & 255) << 6
                      | min(self.moved, 15) << 2
                      | (0 if self.moved == 0 else 1 if self.way == 0 else 2))
