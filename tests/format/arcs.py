"""Arcs of "Coder 24: paths" of docs/format.md."""
from math import isqrt

from decisions import RAW
from entropy import Damaged
from vector_classes import ZERO, nearest, short, size
from vector_models import Set, bit


class Arcs:
    def __init__(self):
        self.sense, self.choices = {}, {}
        self.sense_before, self.choice_before = 1, 0
        self.circle, self.circles = ZERO, (Set(), Set())
        self.of_choice, self.second = [Set() for _ in range(5)], Set()
        self.radii = [0, 0]

    def decode(self, coder, end, tangent):
        p, e = short(tangent, 30), short(end, 30)
        z = p[0] * e[1] - p[1] * e[0]
        side = (0 if tangent == ZERO else 1 if z == 0
                else 2 if z > 0 else 3)
        clockwise = bit(coder, self.sense.setdefault(
            2 * side + self.sense_before, [RAW, 0]))
        if end == ZERO:
            centre = tuple(old + numbers.signed(coder) for old, numbers in
                           zip(self.circle, self.circles))
            self.circle = centre
        else:
            centre = self.centre(coder, end, clockwise, tangent)
        self.sense_before = clockwise
        if size(centre) < 1 << 30:
            square = centre[0] * centre[0] + centre[1] * centre[1]
            if square != self.radii[0]:
                self.radii = [square, self.radii[0]]
        if centre == ZERO:
            raise Damaged("an arc without radius")
        return clockwise, centre

    def centre(self, coder, end, clockwise, tangent):
        y_first = abs(end[0]) >= abs(end[1])
        guesses = self.guesses(end, clockwise, y_first, tangent)
        k = 0
        while k < 4 and bit(coder, self.choices.setdefault(
                (self.choice_before, k), [RAW, 0])):
            k += 1
        self.choice_before = k
        first = guesses[k] + self.of_choice[k].signed(coder)
        expected = 0
        if size(end) < 1 << 20:
            e1, e2 = end[::-1] if y_first else end
            q = e1 * e1 + e2 * e2
            expected = nearest(q - 2 * first * e1, 2 * e2)
        second = expected + self.second.signed(coder)
        return (second, first) if y_first else (first, second)

    def guesses(self, end, clockwise, y_first, tangent):
        if size(end) >= 1 << 20:
            return [0] * 5
        e1 = end[1] if y_first else end[0]
        q = end[0] * end[0] + end[1] * end[1]
        g0 = e1 // 2 if e1 >= 0 else -(-e1 // 2)
        guesses = [g0] * 5
        p = short(tangent, 19)
        z = 2 * (p[0] * end[1] - p[1] * end[0])
        if z:
            guesses[1] = (nearest(q * p[0], z) if y_first
                          else nearest(-q * p[1], z))
        u = end[0] if y_first else -end[1]
        for i, R in enumerate(self.radii):
            if 4 * R - q >= 0:
                o = nearest(isqrt((4 * R - q) // 4) * u, isqrt(q))
                o = o if clockwise else -o
                guesses[2 + i] = g0 + o
                if i == 0:
                    guesses[4] = g0 - o
        return guesses
