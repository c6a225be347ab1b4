"""Section "Curve" of docs/format.md."""
from entropy import clamp

LENGTHS = (4, 6, 9, 14, 21, 32)


def weights(k, parabola):
    """F_1 .. F_(k-1)."""
    whole, total, found = 2 * k * (k - 1) * (k - 2), 0, []
    for j in range(k - 1, 0, -1):
        total += 4 * (k - 2) * (2 * k - 3 * j - 2)
        if parabola:
            total += 5 * (3 * (2 * j - k + 1) ** 2 - k * k + 1)
        found.insert(0, (2 * 4096 * -total + whole) // (2 * whole))
    return found


LINE = [weights(k, False) for k in LENGTHS]
PARABOLA = [weights(k, True) for k in LENGTHS]


class Series:
    def __init__(self):
        self.count, self.last, self.d = 0, 0, []

    def push(self, value, jump):
        d, self.last = value - self.last, value
        if self.count == 0 or abs(d) > jump:
            self.count = 1
        else:
            self.d = [d] + self.d[:30]
            self.count = min(32, self.count + 1)

    def fit(self):
        return sum(self.count >= k for k in LENGTHS) - 1

    def line(self, f):
        return sum(F * d for F, d in zip(LINE[f], self.d)) >> 6

    def parabola(self, f):
        return sum(F * d for F, d in zip(PARABOLA[f], self.d)) >> 6


class Axis:
    def __init__(self):
        self.sign, self.error = 0, 0
        self.places, self.gaps = Series(), (Series(), Series())


class Curve:
    def __init__(self):
        self.axes = (Axis(), Axis())

    def step(self, direction, x, y, gaps):
        axis, sign = self.axes[direction % 2], 1 if direction < 2 else -1
        if sign != axis.sign:
            axis.sign, axis.error = sign, 64
            for series in (axis.places, *axis.gaps):
                series.count = 0
        place = x if direction % 2 else y
        f = min(axis.places.fit(), 3)
        if f >= 0:
            m = 64 * clamp(place - axis.places.last, -25, 25)
            more = 4 * min(255, abs(m - axis.places.line(f))) - axis.error
            axis.error += more // 8 if more >= 0 else -(-more // 8)
        axis.places.push(place, 24)
        for series, gap in zip(axis.gaps, gaps):
            if gap == 0:
                series.count = 0
            else:
                series.push(gap, 3)

    def heading(self, number):
        return number + 2 if self.axes[number].sign < 0 else number

    def expects(self, number, direction, X, Y, gaps):
        """curve, right, left."""
        axis = self.axes[number]
        along = int(direction % 2 == number)
        s = 1 if direction < 2 else -1
        if along:
            s = axis.sign if number == 0 else -axis.sign
        crosses = self.heading(number) == (direction + 1) % 4
        frame = along + 2 * (not along and crosses)

        def level(v):
            d = 128 + clamp(s * v + 32, -127, 191)
            return 8 + frame + 4 * (d // 8)

        f, c = axis.places.fit(), along
        if f >= 0:
            e = clamp((X if number else Y) - axis.places.last, -24, 24)
            c = level(axis.places.parabola(f) - 64 * e)
        trust = (f + 2) // 2
        quality = sum(axis.error >= e for e in (40, 70, 120))
        sides = []
        for series, gap, sign in zip(axis.gaps, gaps, (1, -1)):
            side = 2 * along + (gap != 0)
            if gap != 0 and series.count != 0:
                f = min(series.fit(), 3)
                v = 64 * (gap - series.last) - (series.line(f) if f >= 0
                                                else 0)
                if abs(v) < 200:
                    side = 256 * level(sign * v) + 16 * (f + 1)
            sides.append(side)
        if (number == 0) != (axis.sign > 0):
            sides.reverse()
        return 256 * c + 4 * trust + quality, *sides
