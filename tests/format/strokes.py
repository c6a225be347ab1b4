"""Section "Coder 25: strokes" of docs/format.md."""
import re
from collections import namedtuple

from entropy import K, STRETCH, Damaged, Interval, Mixer, clamp, top, update
from shape_numbers import GAP, RISE, Numbers
from shapes import NONE, Known, clip, join
from turns import mix
from vector_classes import direction, less, size
from vector_models import FOLDER, number_of
from vectors import Elements

LIMIT = 2**30 - 1
LESSONS = "stroke_warm_start_table.cpp"
Path = namedtuple("Path", "origin closed pen elements")
Word = namedtuple("Word", "first count box")


class Counted(Numbers):
    """Six contexts of 2^16 counters."""

    def __init__(self):
        self.coder = None
        self.counters = [{} for _ in range(6)]
        self.mixer = Mixer((1024, 1024, 1024), ([1024] * 12 + [0] * 4,))

    def decide(self, field, values, node):
        name = (field << 27) + node
        counters = [table.setdefault(top(16, mix(v + i, name) * K),
                                     [32768, 0])
                    for i, (table, v) in enumerate(zip(self.counters, values))]
        x = []
        for p, n in counters:
            x += [STRETCH[p >> 4], (p - 32768) * 51 * min(n, 30) >> 16]
        known = sum(n > 0 for _, n in counters)
        well = sum(n > 6 for _, n in counters)
        p = self.mixer.predict(x + [77, 0, 0, 0],
                               (72 * field + min(node, 71), field,
                                7 * known + well))
        bit = self.coder.decode(clamp(p, 8, 65528), "")
        self.mixer.learn(bit)
        for counter in counters:
            update(counter, bit)
        return bit


class Models:
    def __init__(self):
        self.items, self.starts, self.layout, self.anchors, self.heads = (
            Counted() for _ in range(5))
        self.vectors = Elements()

    def read_with(self, coder):
        for numbers in (self.items, self.starts, self.layout, self.anchors,
                        self.heads):
            numbers.coder = coder


def ends_of(path):
    x, y = path.origin
    yield x, y
    for (dx, dy), _, _ in path.elements:
        x, y = x + dx, y + dy
        yield x, y


def box_of(paths):
    points = [p for path in paths for p in ends_of(path)]
    xs, ys = zip(*points)
    return min(xs), min(ys), max(xs), max(ys)


class Layout:
    """Step 8 of Shapes, of a band of 2^30 - 1 units."""

    def __init__(self):
        self.X = self.base = self.line_X = self.line_base = 0
        self.drops = []

    def corner(self, f, C, gap, rise):
        """The left side and the row below the last one."""
        return (gap + (self.line_X if f else self.X),
                rise + (self.line_base if f else self.base) + self.drops[C])

    def advance(self, f, C, x, bottom, width):
        if f:
            self.line_X = x
        if C is None:
            if f:
                self.base = bottom
            self.drops.append(bottom - self.base)
        else:
            self.base = clamp(bottom - self.drops[C], 0, LIMIT)
        if f:
            self.line_base = self.base
        self.X = x + width


class Strokes:
    def __init__(self, coder, models, count, elements):
        self.coder, self.m = coder, models
        models.read_with(coder)
        models.vectors.vertices = type(models.vectors.vertices)()
        self.count, self.left = count, elements
        self.paths, self.words, self.layout = [], [], Layout()
        self.last = [NONE] * 3
        self.was = self.refs = self.on = 0
        self.rest = self.start = self.move = 0, 0
        self.seen = self.D = self.along = 0
        self.pens, self.before = [], [Path(0, 0, 0, ())] * 2

    def run(self):
        if self.count:
            self.bits = self.m.items.small(5, 2, range(6))
            self.unit = 1 << self.bits
            self.m.vectors.arcs_frame(self.coder)
        while len(self.paths) < self.count:
            self.item()
        if self.left:
            raise Damaged("elements are left")
        return self.paths

    # Items.

    def item(self):
        a, b, _ = self.last
        items, was, refs, on = self.m.items, self.was, self.refs, self.on
        if self.words:
            refers = items.flag(0, (
                join(0, was), join(1, a.klass, was),
                join(2, a.klass, b.klass), join(3, on, was),
                join(4, refs % 8), join(5, refs)))
            self.refs = (2 * refs + refers) % 256
            if refers:
                return self.again()
        refs = self.refs
        if not items.flag(1, (
                join(0, was), join(1, refs % 8), join(2, on),
                join(3, a.klass), join(4, len(self.words) // 8),
                join(5, was, refs % 4))):
            self.was = 0
            return self.path(0)
        return self.word()

    def new_line(self):
        a, b, _ = self.last
        return self.m.items.flag(2, (
            join(0, self.was), join(1, a.klass), join(2, a.klass, b.klass),
            join(3, self.on), join(4, clip(a.gap, 20)),
            join(5, self.refs % 32)))

    def word(self):
        f, first, n = self.new_line(), len(self.paths), 0
        while True:
            n += 1
            self.path(n)
            e, few = len(self.paths[-1].elements), min(n, 8)
            if len(self.paths) == self.count or not self.m.items.flag(4, (
                    few, join(1, e), join(2, self.on), join(3, e, few),
                    join(4, *self.rest), 5)):
                break
        paths = self.paths[first:]
        x, y = paths[0].origin
        left, high, right, low = box_of(paths)
        self.words.append(Word(first, n, (left - x, high - y, right - x,
                                          low - y)))
        C = len(self.words) - 1
        self.stand(f, None, C, (x // self.unit, y // self.unit),
                   (x % self.unit, y % self.unit), 0, 0, 1)
        self.last[0] = self.last[0]._replace(klass=C + 1, id=C + 1)

    def place(self, C, rest):
        """The box in units about the origin: left, top, w, h."""
        left, high, right, low = self.words[C].box
        x, y = rest
        left, right = ((x + v) // self.unit for v in (left, right))
        high, low = ((y + v) // self.unit for v in (high, low))
        return left, high, right - left, low - high

    def stand(self, f, C, box_of_word, at, rest, gap, rise, was):
        left, high, w, h = self.place(box_of_word, rest)
        x, y = at[0] + left, at[1] + high
        if x < 0 or y < 0 or x + w > LIMIT or y + h > LIMIT:
            raise Damaged("a word outside")
        self.layout.advance(f, C, x, y + h, w)
        refers = int(C is not None)
        klass = C + 1 if refers else 0
        self.last = [Known(klass, klass, gap, rise, w, h, refers, refers),
                     *self.last[:2]]
        self.was = was

    def again(self):
        f, (a, b, c) = self.new_line(), self.last
        C = self.m.items.number(3, (
            f, join(1, a.klass, f), join(2, a.klass, b.klass, f),
            join(3, a.klass, b.klass, c.klass), join(4, a.gap),
            join(5, a.w, a.h)))
        if C >= len(self.words):
            raise Damaged("no such word")
        word = self.words[C]
        kind = join(100, C)
        rest = self.read_rest(kind)
        gap = rise = 0
        if self.anchored(kind, 2):
            at = self.anchor(kind)
        else:
            klass = C + 1
            gap = self.m.layout.signed(GAP, (
                f, join(1, klass, f), join(2, klass, a.klass, f),
                join(3, klass, a.id, f), join(4, clip(a.gap, 40), f),
                join(5, klass, a.klass, b.klass)))
            rise = self.m.layout.signed(RISE, (
                f, join(1, klass, f), join(2, klass, a.klass, f),
                join(3, clip(gap, 64), f, 1),
                join(4, clip(a.rise, 20), f, clip(b.rise, 4)),
                join(5, klass, a.id)))
            x, bottom = self.layout.corner(f, C, gap, rise)
            left, high, _, h = self.place(C, rest)
            at = x - left, bottom - h - high
        self.stand(f, C, C, at, rest, gap, rise, 2)
        origin = tuple(v * self.unit + r for v, r in zip(at, rest))
        dx, dy = less(origin, self.paths[word.first].origin)
        for i in range(word.first, word.first + word.count):
            old = self.paths[i]
            path = old._replace(origin=(old.origin[0] + dx,
                                        old.origin[1] + dy))
            self.follow(path)
            self.take(path)

    def take(self, path):
        self.left -= len(path.elements)
        if self.left < 0 or len(self.paths) == self.count:
            raise Damaged("too many elements")
        self.paths.append(path)

    def follow(self, path):
        vectors = self.m.vectors
        vectors.begin(tuple(v // self.unit for v in path.origin), path.closed,
                      len(path.elements))
        for (dx, dy), _, _ in path.elements:
            vectors.go((dx // self.unit, dy // self.unit))
        self.use(path.pen)

    # Origins.

    def read_rest(self, R):
        if self.unit == 1:
            return 0, 0
        rx, ry = self.rest
        x = self.m.starts.small(3, self.bits, (R, join(1, rx, ry), 2, 3, 4, 5))
        y = self.m.starts.small(4, self.bits, (
            join(R, x), join(1, rx, ry, x), join(2, x), 3, 4, 5))
        return x, y

    def anchored(self, k, role):
        if not self.m.vectors.vertices.at:
            return 0
        on, klass = self.on, self.last[0].klass
        found = self.m.starts.flag(2, (
            join(0, role), join(1, k), join(2, on % 2, role),
            join(3, on, role), join(4, k, on % 2), join(5, klass, role)))
        self.on = (2 * on + found) % 16
        return found

    def anchor(self, k):
        P, flag = self.m.vectors.vertices, self.m.anchors.flag
        asked = []
        for i in range(len(P.at) - 1, -1, -1):
            if len(asked) == 64:
                break
            at, before = P.at[i], P.before[i]
            known = at in asked
            if known and before is None:
                continue
            d = len(asked)
            asked.append(at)
            e = int(P.after[i] is None) + 2 * (before is None)
            line = (0, 0) if before is None else less(P.at[before], at)
            way = 28 if before is None else direction(line)
            s = size(line).bit_length()
            if not known and flag(0, (
                    e, join(1, d), join(2, e, self.D - d), join(3, e, way, s),
                    join(4, k, e), join(5, k, d))):
                self.D = d
                return at
            if 2 <= s <= 20 and flag(1, (
                    s, join(1, d), join(2, self.D - d, s), join(3, way, s),
                    join(4, k, s), join(5, k))):
                self.D = d
                return self.on_line(P.at[before], less(at, P.at[before]), k,
                                    d, way, s)
        raise Damaged("no vertex")

    def on_line(self, origin, line, k, d, way, s):
        n = size(line)
        g = self.m.anchors.flag(2, (0, join(1, way), join(2, s), join(3, k),
                                    join(4, n), join(5, d)))
        v = self.m.anchors.number(3, (
            s, join(1, n), join(2, self.along, g), join(3, k, s),
            join(4, way, s), join(5, s, g)))
        if v >= n - 1:
            raise Damaged("beyond the line")
        self.along = v
        steps = n - 1 - v if g else v + 1

        def part(c):
            twice = 2 * c * steps
            return ((twice + n) // (2 * n) if twice >= 0
                    else -((-twice + n) // (2 * n)))

        return origin[0] + part(line[0]), origin[1] + part(line[1])

    def free(self, k):
        at = self.m.vectors.vertices.at
        new, self.seen = at[self.seen:], len(at)
        x, y = ((max(p[0] for p in new), min(p[1] for p in new)) if new
                else (0, 0))
        on, (mx, my) = self.on % 8, self.move
        down = self.m.starts.signed(0, (0, join(1, k), join(2, on),
                                        join(3, my), join(4, mx),
                                        join(5, k, on)))
        q = abs(down).bit_length() + 64 * (down < 0)
        right = self.m.starts.signed(1, (
            q, join(1, k, q), join(2, on, q), join(3, mx, q), join(4, down),
            join(5, k, on)))
        return x + right, y + down

    # Heads and elements.

    def use(self, pen):
        self.pens = [pen] + [p for p in self.pens if p != pen][:15]

    def path(self, in_word):
        k, heads, (a, b) = min(in_word, 4), self.m.heads, self.before
        p, o = (self.pens + [0, 0])[:2]
        pens = len(self.pens)
        i = heads.number(1, (
            join(0, pens), join(1, k), join(2, p, o), join(3, p, k),
            join(4, len(a.elements), pens),
            join(5, int(a.pen == b.pen), k)))
        if i > pens:
            raise Damaged("no such pen")
        pen = self.pens[i] if i < pens else p + heads.signed(2, (
            0, join(1, p), join(2, pens), join(3, k), 4, 5))
        self.use(pen)
        ea, eb = len(a.elements), len(b.elements)
        closed = heads.flag(0, (
            k, join(1, pen), join(2, a.closed, b.closed),
            join(3, int(a.pen == pen), a.closed, ea),
            join(4, ea.bit_length(), eb.bit_length()), 5))
        count = heads.number(3, (
            join(0, k), join(1, pen), join(2, ea.bit_length(), k),
            join(3, ea.bit_length(), eb.bit_length()), join(4, ea), 5)
        ) if closed else 0
        about = join(k, closed)
        rest = self.read_rest(join(200, pen, 8 * self.rest[0] + self.rest[1]))
        at = (self.anchor(about) if self.anchored(about, int(k > 0))
              else self.free(about))
        self.move = tuple(clamp(v, -30, 30) for v in less(at, self.start))
        self.start, self.rest = at, rest
        elements = self.elements(at, closed, count, k, pen)
        origin = tuple(v * self.unit + r for v, r in zip(at, rest))
        path = Path(origin, closed, pen, elements)
        self.before = [path, a]
        self.take(path)

    def elements(self, at, closed, count, k, pen):
        vectors, (a, _) = self.m.vectors, self.before
        vectors.begin(at, closed, count)
        found, last = [], (0, 0)
        while True:
            j, s = min(len(found), 12), size(last)
            L = s.bit_length()
            if L > 1:
                L = 2 * L - 2 + (s >> (L - 2) & 1)
            if closed:
                if len(found) == count:
                    break
            elif not self.m.heads.flag(4, (
                    join(0, j), join(1, j, k), join(2, j, L), join(3, j, pen),
                    join(4, j, len(a.elements), a.closed),
                    join(5, min(j, 2), L, direction(last)))):
                break
            if len(found) == self.left:
                raise Damaged("too many elements")
            last, centre, clockwise = vectors.element(self.coder)
            found.append((tuple(v * self.unit for v in last), centre and tuple(
                v * self.unit for v in centre), clockwise))
        return tuple(found)


def trained():
    """Models that have learned table 1."""
    models = Models()
    source = (FOLDER / LESSONS).read_text("ascii").split("kLessons[]")[1]
    for paths, elements, text in re.findall(
            r'\{(\d+), (\d+),\s*((?:"[^"]*"\s*)+)', source):
        text = "".join(re.findall(r'"([^"]*)"', text))
        bits = 0
        for c in text:
            bits = bits << 6 | number_of(c)
        count = 6 * len(text)
        coder = Interval((bits >> count % 8).to_bytes(count // 8, "big"),
                         False)
        Strokes(coder, models, int(paths), int(elements)).run()
        coder.check_end()
    return models
