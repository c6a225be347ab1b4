"""Sections "State" and "Predictions" of "Coder 28: programs"."""

import math
import re

from decisions import digits, mix
from entropy import K, M64

AXES, I, J, KAY, R, F, S = range(10), 10, 11, 12, 13, 14, 15
X, Y, Z, E = 0, 1, 2, 9
MOST = 2 * 10 ** 15
REACH = 1 << 40
REMEMBERED = 1 << 16


def kept(value):
    return max(-MOST, min(MOST, value))


def near(a, b):
    whole = (2 * abs(a) + abs(b)) // (2 * abs(b))
    return kept(-whole if (a < 0) != (b < 0) else whole)


def half(value, divisor):
    """Rounded to 0."""
    whole = abs(value) // divisor
    return -whole if value < 0 else whole


def large(*values):
    return any(abs(v) >= REACH for v in values)


def top16(value):
    return (value * K & M64) >> 48


class Motion:
    def __init__(self, mode=1, place=None):
        self.mode, self.words = mode, 0
        self.numbers = [0] * 16
        self.source = list(place or [0] * 10)
        self.to = list(self.source)

    def has(self, word):
        return self.words >> word & 1

    def delta(self, axis):
        return self.to[axis] - self.source[axis]

    def plane(self):
        return self.delta(X), self.delta(Y)

    def leads_nowhere(self):
        return self.to == self.source

    def is_arc(self):
        return self.mode in (2, 3)


NONE = Motion()


class Match:
    """Of vectors or of places."""

    def __init__(self, same, head):
        self.same, self.head = same, head
        self.heads, self.pointer, self.length = {}, 0, 0

    def add(self, motions, before, motion):
        count = len(motions)
        if self.length:
            self.length = (min(self.length + 1, 1000)
                           if self.same(motions[self.pointer], motion) else 0)
            self.pointer += 1
            if self.pointer >= count or count - self.pointer >= REMEMBERED:
                self.length = 0
        index = self.head(before, motion)
        head = self.heads.get(index, 0)
        if not self.length and 0 < head < count and count - head < REMEMBERED:
            self.pointer, self.length = head, 1
        self.heads[index] = count

    def guess(self, motions):
        return motions[self.pointer] if self.length else None


def head_of_vectors(before, motion):
    value = mix(before.words, motion.words)
    for axis in (X, Y, Z):
        value = mix(mix(value, before.delta(axis)), motion.delta(axis))
    return top16(value)


def place(at):
    return mix(at[X], at[Y])


def head_of_places(_, motion):
    return top16(mix(place(motion.source), place(motion.to)))


class State:
    def __init__(self, words):
        self.words = words  # those that occur
        self.mode, self.incremental, self.incremental_e = 1, 0, 0
        self.motions = []
        self.trails = [[0] * 8 for _ in range(16)]
        self.vectors = Match(
            lambda a, b: all(a.delta(k) == b.delta(k) for k in (X, Y, Z)),
            head_of_vectors)
        self.places = Match(lambda a, b: a.to[:2] == b.to[:2], head_of_places)
        self.visits, self.visit = {}, 0
        self.home = [0] * 10
        self.kinds, self.text = 1, 0
        self.motion = NONE  # the one that is decoded, or was last

    def back(self, n):
        return self.motions[-n] if n <= len(self.motions) else NONE

    @property
    def guess(self):
        return self.vectors.guess(self.motions)

    @property
    def guess_of_place(self):
        return self.places.guess(self.motions)

    @property
    def left(self):
        count = len(self.motions)
        return self.motions[self.visit] if 0 < self.visit < count else None

    @property
    def led(self):
        return self.motions[self.visit - 1] if self.visit else None

    def begin_motion(self):
        self.motion = Motion(self.mode, self.back(1).to)

    def end_motion(self):
        motion, before = self.motion, self.back(1)
        self.mode = motion.mode
        self.motions.append(motion)
        for word in range(16):
            if word in AXES and self.words >> word & 1:
                self.trails[word] = [motion.delta(word)] + self.trails[word][:7]
            elif word not in AXES and motion.has(word):
                self.trails[word] = ([motion.numbers[word]]
                                     + self.trails[word][:7])
        self.vectors.add(self.motions, before, motion)
        self.places.add(self.motions, before, motion)
        index, count = top16(place(motion.to)), len(self.motions)
        self.visit = self.visits.get(index, 0)
        if self.visit and (count - (self.visit - 1) >= REMEMBERED or
                           self.motions[self.visit - 1].to[:2]
                           != motion.to[:2]):
            self.visit = 0
        self.visits[index] = count
        if motion.mode == 0:
            self.home = list(motion.to)

    def end_text(self, line):
        self.text = 1
        for byte in line:
            self.text = mix(self.text, byte)
        for word, one, both in (("G91", 1, True), ("G90", 0, True),
                                ("M83", 1, False), ("M82", 0, False)):
            if re.search(word.encode() + rb"(?![0-9.])", line):
                self.incremental_e = one
                if both:
                    self.incremental = one

    def counted_from(self, word):
        """What the number of an axis word is more than its way."""
        incremental = self.incremental_e if word == E else self.incremental
        return 0 if incremental else self.motion.source[word]

    def predictions(self, word):
        if word in AXES:
            return self.axis_predictions(word)
        if word in (I, J):
            return self.centre_predictions(word)
        return self.other_predictions(word)

    def trail(self, word):
        t = self.trails[word]
        line = near(14 * t[0] + 11 * t[1] + 8 * t[2] + 5 * t[3] + 2 * t[4]
                    - t[5] - 4 * t[6] - 7 * t[7], 28)
        parabola = near(63 * t[0] + 27 * t[1] + t[2] - 15 * t[3] - 21 * t[4]
                        - 17 * t[5] - 3 * t[6] + 21 * t[7], 56)
        return (t, line, parabola, kept(2 * t[0] - t[1]),
                kept(3 * t[0] - 3 * t[1] + t[2]))

    def turned(self):
        d1, d2 = self.back(1).plane(), self.back(2).plane()
        if d2 == (0, 0) or large(*d1, *d2):
            return d1
        s, u = d1[0] ** 2 - d1[1] ** 2, 2 * d1[0] * d1[1]
        size = d2[0] ** 2 + d2[1] ** 2
        return (near(s * d2[0] + u * d2[1], size),
                near(u * d2[0] - s * d2[1], size))

    @staticmethod
    def along(v, x, other):
        if v[0] == 0 or large(x, *v):
            return other
        return near(x * v[1], v[0])

    @staticmethod
    def length(motion):
        ways = [motion.delta(k) for k in (X, Y, Z)]
        return 0 if large(*ways) else math.isqrt(sum(w * w for w in ways))

    def axis_predictions(self, axis):
        t, line, parabola, c2, c3 = self.trail(axis)
        at, now, turned = self.motion.source[axis], self.motion, self.turned()
        before, d1 = self.back(1), self.back(1).plane()
        p6 = kept(4 * t[0] - 6 * t[1] + 4 * t[2] - t[3])
        p7, p13 = -t[0], kept(-t[0] - t[1])
        if axis == X:
            p6 = turned[0]
        elif axis == Y:
            p6 = self.along(turned, now.delta(X), turned[1])
            p7, p13 = self.along(d1, now.delta(X), d1[1]), turned[1]
        elif axis == E:
            last = self.length(before)
            p6 = (0 if last == 0 or large(before.delta(E)) else
                  near(self.length(now) * before.delta(E), last))
        guess, there = self.guess, self.guess_of_place
        left, led = self.left, self.led
        return [0, t[0], c2, c3, line, parabola, p6, p7,
                guess.delta(axis) if guess else t[0],
                there.to[axis] - at if there else c2,
                left.to[axis] - at if left else line,
                led.source[axis] - at if led else c3,
                self.home[axis] - at, p13]

    def tangent(self):
        before, e = self.back(1), self.motion.plane()
        v = before.plane()
        if before.is_arc():
            r = v[0] - before.numbers[I], v[1] - before.numbers[J]
            v = (r[1], -r[0]) if before.mode == 2 else (-r[1], r[0])
        if large(*v, *e):
            return 0, 0
        n = -v[1], v[0]
        z = 2 * (n[0] * e[0] + n[1] * e[1])
        if z == 0:
            return 0, 0
        size = e[0] ** 2 + e[1] ** 2
        return near(size * n[0], z), near(size * n[1], z)

    def centre_predictions(self, word):
        t = self.trails[word]
        axis, other = word - I, J + I - word
        e = self.motion.plane()
        p2 = p3 = self.tangent()[axis]
        if self.motion.has(other):
            o = self.motion.numbers[other]
            size = e[0] ** 2 + e[1] ** 2
            p3 = (0 if e[axis] == 0 or large(o, *e) else
                  near(size - 2 * o * e[1 - axis], 2 * e[axis]))

        def centre(motion, without):
            if not motion or not motion.is_arc():
                return without
            return kept(motion.source[axis] + motion.numbers[word]
                        - self.motion.source[axis])

        arcs = [self.back(n) for n in range(1, 9)]
        arcs = [centre(m, 0) for m in arcs if m.is_arc()][:4]
        guess = self.guess
        return [t[0], half(e[axis], 2), p2, p3,
                *arcs, *[p2] * (4 - len(arcs)),
                guess.numbers[word] if guess and guess.is_arc() else p3,
                centre(self.guess_of_place, p3), centre(self.left, p2),
                centre(self.led, p2), t[1], -t[0]]

    def other_predictions(self, word):
        t, line, _, _, c3 = self.trail(word)
        p1 = kept(2 * t[0] - t[1])

        def number(motion, without):
            return (motion.numbers[word] if motion and motion.has(word)
                    else without)

        return [t[0], p1, t[1], t[2], t[3], 0, line,
                kept(t[0] + half(t[0] - t[4], 4)),
                number(self.guess, t[0]), number(self.guess_of_place, p1),
                number(self.left, t[0]), number(self.led, t[1]), t[4], c3]


def level(d):
    """q(d)."""
    size = abs(d)
    value = size if size < 2 else (2 * digits(size) - 2
                                   + (size >> digits(size) - 2 & 1))
    return min(63, value) + (64 if d < 0 else 0)
