"""Section "Shapes" of docs/format.md."""
from collections import namedtuple

from entropy import Damaged, clamp
from pixels import Pixels
from shape_numbers import (CLASS, DX, DY, GAP, MORE, MORE_HEIGHT, MORE_WIDTH,
                           NEW_LINE, RANK, REFERS, RISE, SAME, SIDE,
                           MixedNumbers)
from turns import mix

Known = namedtuple("Known", "klass id gap rise w h refers same")
NONE = Known(0, 0, 0, 0, 0, 0, 0, 0)


def join(t, a, b=0, c=0):
    for number in (a, b, c):
        t = mix(t, number)
    return t


def clip(v, k):
    return clamp(v, -k, k) + k


class Shapes:
    def __init__(self, coder, width, rows):
        self.width, self.rows = width, rows
        self.numbers = MixedNumbers(coder, width * rows)
        self.pixels = Pixels(coder, width * rows)
        self.room = 4 * width * rows + 65536
        self.shapes = []   # by number: rows of pixels
        self.classes = []  # lists of numbers
        self.drops = []
        self.last = [NONE] * 3
        self.X = self.base = self.line_X = self.line_base = self.in_line = 0

    def run(self, image):
        while self.numbers.flag(MORE, [0] * 6):
            self.one(image)

    def one(self, image):
        numbers, (a, b, c) = self.numbers, self.last
        numbers.begin((self.X, self.base, self.line_X, self.line_base,
                       self.in_line))
        f = numbers.flag(NEW_LINE, (
            0, join(1, a.klass), join(2, a.klass, b.klass),
            join(3, self.in_line), join(4, clip(a.gap, 20), a.refers),
            join(5, 16 * self.X // self.width)))
        refers = numbers.flag(REFERS, (
            f, join(1, a.klass, b.klass), join(2, a.klass),
            join(3, a.refers, b.refers, c.refers),
            join(4, clip(a.gap, 20), a.refers), join(5, a.w, a.h)))
        same, C, R, dx, dy = 0, None, None, 0, 0
        if refers:
            C, R, same = self.reference(f)
            w, h = len(self.shapes[R][0]), len(self.shapes[R])
            if not same:
                w, h, dx, dy = self.sides_like(C, R, w, h)
        else:
            w = self.side(1000)
            h = self.side(w)
        self.room -= 64 + w * h
        if self.room < 0:
            raise Damaged("no room for a shape")
        klass, number = (C + 1, R + 1) if refers else (0, 0)
        gap, rise = self.place(f, refers, klass, number)
        x = gap + (self.line_X if f else self.X)
        bottom = rise + (self.line_base if f else self.base) + (
            self.drops[C] if refers else 0)
        if x < 0 or bottom - h < 0 or x + w > self.width or bottom > self.rows:
            raise Damaged("a shape outside")
        shape = self.shapes[R] if same else self.draw(w, h, C, R, dx, dy)
        for j, row in enumerate(shape):
            for i, pixel in enumerate(row):
                image[bottom - h + j][x + i] |= pixel
        self.remember(f, refers, same, C, shape, x, bottom)
        klass = (C if refers else len(self.classes) - 1) + 1
        numbers.remember(klass, gap, rise, x, bottom, w, h, f)
        number = R + 1 if same else len(self.shapes)
        self.last = [Known(klass, number, gap, rise, w, h, refers, same), a, b]

    def draw(self, w, h, C, R, dx, dy):
        return self.pixels.shape(w, h, None if R is None else self.shapes[R],
                                 dx, dy)

    def reference(self, f):
        numbers, (a, b, c) = self.numbers, self.last
        C = numbers.number(CLASS, (
            f, join(1, a.klass, f), join(2, a.klass, b.klass),
            join(3, a.klass, b.klass, c.klass), join(4, a.id, a.gap),
            join(5, a.w, a.h, f)))
        if C >= len(self.classes):
            raise Damaged("no such class")
        ids = self.classes[C]
        rank = numbers.number(RANK, (
            0, join(1, C), join(2, len(ids)), join(3, C, a.id),
            join(4, a.same), join(5, C, a.klass)))
        if rank >= len(ids):
            raise Damaged("no such shape")
        R = ids[rank]
        same = numbers.flag(SAME, (
            join(0, a.same, b.same, c.same), join(1, C), join(2, R),
            join(3, a.same), join(4, len(self.shapes[R])), join(5, rank)))
        ids.insert(0, ids.pop(rank))
        numbers.id = R + 1
        return C, R, same

    def sides_like(self, C, R, w, h):
        values = (0, join(1, C), join(2, self.last[0].klass), join(3, h),
                  join(4, w), join(5, R))
        more = [self.numbers.signed(field, values)
                for field in (MORE_WIDTH, MORE_HEIGHT, DX, DY)]
        w, h = w + more[0], h + more[1]
        if (max(map(abs, more)) > 4 or not 1 <= w <= 255
                or not 1 <= h <= 255):
            raise Damaged("sides of a shape")
        return w, h, *more[2:]

    def side(self, other):
        a = self.last[0]
        return min(255, 1 + self.numbers.small(SIDE, 8, (
            0, join(1, other), join(2, a.w), join(3, a.h), join(4, a.klass),
            join(5, a.refers))))

    def place(self, f, refers, klass, number):
        a, b, _ = self.last
        gap = self.numbers.signed(GAP, (
            f, join(1, klass, f), join(2, klass, a.klass, f),
            join(3, number, a.id, f), join(4, clip(a.gap, 40), f),
            join(5, klass, a.klass, b.klass)))
        rise = self.numbers.signed(RISE, (
            f, join(1, klass, f), join(2, klass, a.klass, f),
            join(3, clip(gap, 64), f, refers),
            join(4, clip(a.rise, 20), f, clip(b.rise, 4)),
            join(5, number, a.id)))
        return gap, rise

    def remember(self, f, refers, same, C, shape, x, bottom):
        if f:
            self.line_X = x
        if not refers:
            if f:
                self.base = bottom
            self.classes.append([])
            self.drops.append(bottom - self.base)
            C = len(self.classes) - 1
        else:
            self.base = clamp(bottom - self.drops[C], 0, self.rows)
        if not same:
            self.classes[C] = [len(self.shapes)] + self.classes[C][:63]
            self.shapes.append(shape)
        if f:
            self.line_base = self.base
        self.X = x + len(shape[0])
        self.in_line = 0 if f else min(15, self.in_line + 1)
