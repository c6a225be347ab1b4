#!/usr/bin/env python3
"""A second decoder of coder 28, written from docs/format.md alone.

    decode_program.py IN.ustp OUT.ngc

Reads short forms of one program. Plain and slow. The docstrings name the page's
sections.
"""
import pathlib
import sys
import zlib

from decisions import RAW, Decisions, digits, mix
from decode_ink import skip_details, varint
from entropy import Damaged, Interval
from program_state import AXES, F, I, J, KAY, R, S, X, Y, State, half, level

LETTERS = "XYZABCUVWEIJKRFS"
# The group of decimals of each word: lengths, angles, E, F, S.
GROUP = [0, 0, 0, 1, 1, 1, 0, 0, 0, 2, 0, 0, 0, 0, 3, 4]
CLASS = [0, 0, 1, 2, 2, 2, 3, 3, 3, 4, 5, 5, 6, 6, 7, 7]


def short(length):
    """L(x)."""
    return min(7, digits(length))


class Numbers:
    """Numbers."""

    def __init__(self, coder, state, table_bits):
        self.coder, self.state = coder, state
        self.model = Decisions(19, table_bits)
        self.errors = [[256] * 14 for _ in range(16)]
        self.residuals = [[0, 0] for _ in range(16)]
        self.before = 0  # the residual of the number before on this line

    def best(self, word):
        errors = self.errors[word]
        return errors.index(min(errors))

    def outlook(self, word, p):
        b = self.best(word)
        return 64 * level(p[b]) + min(self.errors[word][b] // 8, 63)

    def decide(self, word, p, node, border, prefix, selector):
        e, b, k, state = self.errors[word], self.best(word), CLASS[word], \
            self.state
        r0, r1 = self.residuals[word]
        t = state.trails[word]
        places = state.places.length
        values = [mix(k << 8 | e[i] // 16, level(p[i] - p[b] - border))
                  for i in range(14)]
        values += [
            mix(k << 8 | b << 16 | e[b] // 8, min(prefix, 64)),
            mix(mix(word, level(r0)), mix(level(r1), min(prefix, 16))),
            mix(mix(p[9] - p[b], min(places, 15)), mix(prefix, word)),
            mix(mix(t[0], t[1]), mix(prefix, word)),
            mix(mix(level(self.before), k << 8 | e[b] // 8), min(prefix, 16))]
        second = (64 * min(e[b] // 16, 15) + 8 * short(state.vectors.length)
                  + short(places))
        return self.model.decode(self.coder, values, node,
                                 (128 * k + selector, second))

    def residual(self, word, p):
        if not self.decide(word, p, 0, 0, 0, 0):
            return 0
        negative = self.decide(word, p, 1, 0, 0, 1)
        sign, prefix = (-1, 2) if negative else (1, 1)
        width = 1
        while width <= 53 and self.decide(word, p, 2 + width,
                                          sign << width if sign > 0
                                          else -(1 << width), prefix,
                                          2 + min(width, 30)):
            width += 1
        u = 1
        for depth in range(width - 1):
            i = width - 2 - depth
            selector = 34 + 4 * min(width, 20) + min(depth, 3)
            u = 2 * u + self.decide(word, p, 64 + 64 * width + min(depth, 63),
                                    sign * ((2 * u + 1) << i),
                                    4 * u + prefix, selector)
        return sign * u

    def decode(self, word, p):
        r = self.residual(word, p)
        number = p[self.best(word)] + r
        errors = self.errors[word]
        for i in range(14):
            errors[i] += half(16 * digits(abs(number - p[i])) - errors[i], 4)
        self.residuals[word] = [r, self.residuals[word][0]]
        self.before = r
        return number


class Lines:
    """Lines."""

    def __init__(self, coder, count):
        bits = 14 if count < 1000 else 16 if count < 10000 else 18
        self.coder = coder
        self.frame()
        self.state = State(self.words)
        self.word_model = Decisions(9, bits - 2)
        self.text_model = Decisions(6, bits - 2)
        self.numbers = Numbers(coder, self.state, bits)

    def frame(self):
        raw = [self.coder.decode(RAW, "") for _ in range(16)]
        self.words = sum(bit << i for i, bit in enumerate(raw))
        self.decimals = [0] * 5
        for group in range(5):
            if any(raw[w] and GROUP[w] == group for w in range(16)):
                for _ in range(3):
                    self.decimals[group] = (2 * self.decimals[group]
                                            + self.coder.decode(RAW, ""))

    def contexts(self, what, outlook=0, rests=0, z=0):
        state = self.state
        w = [0] + [state.back(n).words for n in (1, 2, 3)]
        last = state.back(1)
        now = mix(what | state.motion.mode << 8 | state.kinds % 4 << 12,
                  state.motion.words)

        def look(motion):
            if not motion:
                return 9
            return motion.mode if what < 2 else motion.words

        self.values = [
            now, mix(now, mix(w[1], last.mode)),
            mix(now, mix(mix(w[1], w[2]), mix(w[3], state.kinds))),
            mix(now, mix(look(state.guess), short(state.vectors.length))),
            mix(now, mix(look(state.guess_of_place),
                         short(state.places.length))),
            mix(what, mix(outlook, rests)), mix(now, mix(outlook >> 6, w[1])),
            mix(now, mix(1 if last.leads_nowhere() else 2, mix(w[1], w[2]))),
            mix(mix(what, state.text), mix(state.kinds % 16, z))]
        self.selector = (64 + what * 32 + 16 * last.leads_nowhere()
                         + 8 * (w[1] >> what + 1 & 1)
                         + short(state.places.length))

    def decide(self, node):
        return self.word_model.decode(self.coder, self.values, node,
                                      (node, self.selector))

    def line(self):
        state = self.state
        self.contexts(0)
        motion = self.decide(0)
        line = self.motion() if motion else self.text()
        state.kinds = (2 * state.kinds + motion) % 256
        return line

    def motion(self):
        state, words = self.state, []
        state.begin_motion()
        self.numbers.before = 0
        self.contexts(1)
        g = self.decide(1)
        if g:
            above = self.decide(2)
            state.motion.mode = 2 * above + self.decide(3 + above)
        for word in AXES:
            self.word(word)
        dx, dy = state.motion.plane()
        self.word(R)
        for word in ((I, J) if abs(dy) >= abs(dx) else (J, I)):
            self.word(word)
        for word in (KAY, F, S):
            self.word(word)
        motion = state.motion
        state.end_motion()
        if g:
            words.append(f"G{motion.mode}")
        for word, letter in enumerate(LETTERS):
            if motion.has(word):
                number = self.shown[word]
                words.append(letter + self.written(number, word))
        return " ".join(words).encode()

    def written(self, number, word):
        decimals = self.decimals[GROUP[word]]
        text = str(abs(number)).rjust(decimals + 1, "0")
        if decimals:
            text = text[:-decimals] + "." + text[-decimals:]
            text = text.rstrip("0").rstrip(".")
        return ("-" if number < 0 else "") + text

    def word(self, word):
        state = self.state
        if word == X:
            self.shown = [0] * 16
        if not self.words >> word & 1:
            return
        p = state.predictions(word)
        self.contexts(2 + word, self.numbers.outlook(word, p), int(p[9] == 0),
                      (p[8] == 0) + 2 * (p[10] == 0))
        if not self.decide(8 + word):
            return
        state.motion.words |= 1 << word
        number = self.numbers.decode(word, p)
        self.shown[word] = number
        if word in AXES:
            state.motion.to[word] = state.motion.source[word] + number
            self.shown[word] += state.counted_from(word)
        state.motion.numbers[word] = self.shown[word]

    def text(self):
        line, word = b"", 0
        while True:
            b = [0] * 5
            for i in range(1, 5):
                b[i] = line[-i] if i <= len(line) else 0
            b12 = b[1] | b[2] << 8
            b123 = b12 | b[3] << 16
            values = [b[1], b12 | 1 << 30, b123 | 1 << 31,
                      mix(b123 | b[4] << 24, 5),
                      mix(mix(self.state.text, min(len(line), 255)), b[1]),
                      mix(word, b[1])]
            node = 1
            for _ in range(8):
                node = 2 * node + self.text_model.decode(
                    self.coder, values, node, (node, 256 + b[1]))
            byte = node & 255
            if byte == 10:
                self.state.end_text(line)
                return line
            line += bytes([byte])
            word = mix(word + 1, byte) if bytes([byte]).isalpha() else 0


def decode(data):
    """Start of every file, Short form. Returns the program's text."""
    flags = data[4]
    if data[:4] != b"\xf5\x55\x0d\x0a" or flags & 0xD3 != 0x80:
        raise Damaged("not a short form with paths")
    width, at = varint(data, 5)
    if width or not flags & 4:
        raise Damaged("no program")
    if flags & 32:
        at = skip_details(data, at)
    fidelity, at = data[at], at + 1
    if flags & 8 or fidelity & 0x5C != 0x40:
        raise Damaged("no program")
    for _ in range((fidelity & 3 == 1) + (fidelity >> 5 & 1)):
        _, at = varint(data, at)
    if not fidelity & 0x80:
        raise Damaged("another coder than 28")
    count, at = varint(data, at)
    size, at = varint(data, at)
    head, stored, payload = data[4:at], data[at:at + 4], data[at + 4:]
    text = b""
    if count:
        coder = Interval(payload, False)
        lines = Lines(coder, count)
        text = b"".join(lines.line() + b"\n" for _ in range(count))
        coder.check_end()
    if len(text) != size:
        raise Damaged("another size")
    if zlib.crc32(head + text) != int.from_bytes(stored, "little"):
        raise Damaged("checksum")
    return text


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: decode_program.py IN.ustp OUT.ngc")
    try:
        text = decode(pathlib.Path(sys.argv[1]).read_bytes())
    except (Damaged, IndexError) as error:
        sys.exit(f"{sys.argv[1]}: {error}")
    pathlib.Path(sys.argv[2]).write_bytes(text)


if __name__ == "__main__":
    main()
