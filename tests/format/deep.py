"""Section "Deep models" of docs/format.md."""
from entropy import (K, M64, STRETCH, Refiner, clamp, signed32, squash, top,
                     update)
from turns import mix

AGES = 8, 14, 24, 48, 100, 200, 500
START = 1 << 21, 0, 1  # probability of 2^22, age, outcomes


class Network:
    """Network."""

    def __init__(self, first_vectors):
        self.first = [[w << 8 for w in v] for v in first_vectors]
        self.vectors, self.lasts = {}, {}

    def begin(self, key, vector):
        """A vector that the table has, as if it had seen 2000 bits."""
        self.vectors[key] = [[w << 8 for w in vector], 2000]

    def predict(self, x, chosen, last):
        self.x = x
        self.used = [self.vectors.setdefault(
            (s, c), [self.first[c % len(self.first)], 0])
            for s, c in enumerate(chosen)]
        self.last = self.lasts.setdefault(
            last, [(1 << 20) // len(chosen)] * len(chosen))
        self.said = []
        for w, _ in self.used:
            total = sum(a * clamp(b >> 6, -32768, 32767)
                        for a, b in zip(x, w) if a)
            self.said.append(clamp(signed32(total) >> 14, -3071, 3071))
        total = sum(o * w for o, w in zip(self.said, self.last))
        self.out = clamp(total >> 20, -3071, 3071)
        return self.out

    def learn(self, bit):
        for vector, o in zip(self.used, self.said):
            error = 65536 * bit - squash(o)
            if abs(error) < 200:
                continue
            w, age = vector
            step = error * (130 + 570 * 16 // (16 + age // 64)) >> 12
            vector[:] = ([b + (a * step + 128 >> 8) if a else b
                          for a, b in zip(self.x, w)], min(60000, age + 1))
        error = 65536 * bit - squash(self.out)
        self.last[:] = [clamp(w + (o * error * 60 >> 20), -1 << 23, 1 << 23)
                        for w, o in zip(self.last, self.said)]


class Deep:
    """A model of `contexts` contexts with `extras` inputs of its own."""

    def __init__(self, contexts, extras, table_bits, refiners, vectors=None):
        self.contexts, self.bits = contexts, table_bits
        size = (3 * contexts + extras + 1 + 7) // 8 * 8
        self.room = [0] * (size - 3 * contexts - extras - 1)
        if vectors is None:
            vectors = [[5200 // contexts] * contexts
                       + [2000 // contexts] * contexts
                       + [1500 // contexts] * contexts + [0] * (extras + 1)]
        self.network = Network([v[:-1] + self.room + v[-1:] for v in vectors])
        self.slots, self.pasts = {}, {}
        self.refiners = [Refiner() for _ in range(refiners)]

    def slot(self, i, upper):
        """By the upper 28 bits of a hash: a fresh one if another is there."""
        at, check = (i, upper >> 28 - self.bits), (upper & 0xFFF) + 1
        if self.slots.get(at, (0,))[0] != check:
            self.slots[at] = check, {}
        return self.slots[at][1]

    def ask(self, hashes):
        self.active = [self.slot(i, h >> 36) for i, h in enumerate(hashes)]

    def ask_mixed(self, values):
        self.ask([mix(v, i) * K & M64 for i, v in enumerate(values)])

    def know(self, i, upper, node, p, n):
        outcomes = min(n, 7)
        ones = p * outcomes + 32768 >> 16
        self.slot(i, upper)[node] = p << 6, n, 1 << outcomes | (1 << ones) - 1

    def past(self, i, node, n, outcomes):
        key = i, node, sum(n >= a for a in AGES), outcomes
        if key not in self.pasts:
            k = outcomes.bit_length() - 1
            ones = bin(outcomes).count("1") - 1
            self.pasts[key] = [(2 * ones + 1) * 65535 // (2 * k + 2), 6]
        return self.pasts[key]

    def decode(self, coder, extras, chosen, refined, last, node=0, what=""):
        states = [slot.get(node, START) for slot in self.active]
        pasts = [self.past(i, node, n, h)
                 for i, (_, n, h) in enumerate(states)]
        x = [STRETCH[p >> 10] for p, _, _ in states]
        x += [((p >> 6) - 32768) * 51 * min(n, 30) >> 16 for p, n, _ in states]
        x += [STRETCH[q[0] >> 4] if n else 0
              for q, (_, n, _) in zip(pasts, states)]
        x += list(extras) + self.room + [77]
        out = self.network.predict(x, chosen, last)
        p = squash(out) + sum(r.refine(out, c) for r, c in
                              zip(self.refiners, refined))
        p = clamp(p // (1 + len(self.refiners)), 8, 65528)
        bit = coder.decode(p, what)
        for refiner in self.refiners:
            refiner.learn(bit)
        self.network.learn(bit)
        for slot, past, (p, n, h) in zip(self.active, pasts, states):
            update(past, bit)
            p += ((bit << 22) - bit - p) * (655360 // (10 * n + 13)) >> 16
            h = h << 1 | bit
            slot[node] = (clamp(p, 32, (1 << 22) - 32), min(1023, n + 1),
                          h if h < 256 else h & 127 | 128)
        return bit
